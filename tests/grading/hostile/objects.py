"""Submissions whose answers are objects with deceptive methods."""

from hostile.attack import Attack, gained, marked, stopped_the_run

OBJECTS = [
    Attack(
        "equals everything",
        "answers with an object equal to whatever it is compared with",
        "the answer is compared with a key by ==",
        "an object of a foreign type is no answer",
        gained,
        (
            """
               class Equal:
                   def __eq__(self, other): return True
                   __hash__ = None
               a_region = Equal()
               """,
        ),
        marks="key",
    ),
    Attack(
        "lies about its class",
        "answers with an object that says it is an And",
        "isinstance believes `__class__`",
        "types are compared by identity",
        gained,
        (
            """
               class Liar:
                   __class__ = property(lambda self: sp.And)
                   def __eq__(self, other): return True
                   def __getattr__(self, name): return self
                   def __call__(self, *given, **more): return self
                   def __iter__(self): return iter(())
               a_region = Liar()
               """,
        ),
        marks="typed key",
    ),
    Attack(
        "is a subclass",
        "answers with an And of its own making, equal to everything",
        "isinstance accepts subclasses",
        "types are compared by identity",
        gained,
        (
            """
               class Mine(sp.And):
                   def __eq__(self, other): return True
                   __hash__ = sp.And.__hash__
               a_region = Mine(k1 > 5, k2 > 5)
               """,
        ),
        marks="typed key",
    ),
    Attack(
        "is always true",
        "answers with a comparison that is always true",
        "`if answer == key` asks for its truth",
        "an object of a foreign type is no answer",
        gained,
        (
            """
               class Answer:
                   def __eq__(self, other): return self
                   def __bool__(self): return True
                   __len__ = __int__ = __index__ = lambda self: 1
               a_region = Answer()
               """,
        ),
        marks="key",
    ),
    Attack(
        "is a number near everything",
        "answers with a float at distance zero from all numbers",
        "a subclass of float is a float",
        "types are compared by identity",
        gained,
        (
            """
               class Near(float):
                   def __sub__(self, other): return 0.0
                   __rsub__ = __sub__
               a_region = Near(0)
               """,
        ),
        marks="number",
    ),
    Attack(
        "is an array near everything",
        "answers with an array that takes part in its own comparison",
        "NumPy asks the array how to compare",
        "types are compared by identity",
        gained,
        (
            """
               import numpy
               class Near(numpy.ndarray):
                   def __array_function__(self, function, types, given, named): return True
               a_region = numpy.zeros(2).view(Near)
               """,
        ),
        marks="closeness",
    ),
    Attack(
        "prints as code",
        "answers with an object whose repr writes a file",
        "the answer is printed in the feedback",
        "nothing foreign is asked to print itself",
        marked,
        (
            """
               class Prints:
                   def __repr__(self):
                       open(HERE + '/marks/' + NAME, 'w').write('ran')
                       return "1"
               a_region = Prints()
               """,
        ),
    ),
    Attack(
        "never ends to print",
        "answers with an object whose repr never ends",
        "the answer is printed in the feedback",
        "nothing foreign is asked to print itself",
        stopped_the_run,
        (
            """
               class Prints:
                   def __repr__(self):
                       while True: pass
               a_region = Prints()
               """,
        ),
        patience=2,
    ),
    Attack(
        "is hostile in every way",
        "answers with an object of which every operation exits",
        "one of them is used",
        "none of them is used",
        stopped_the_run,
        (
            """
               import os
               def bang(*given, **more): os._exit(1)
               class Meta(type):
                   __instancecheck__ = __subclasscheck__ = __eq__ = __hash__ = __getattr__ = __repr__ = bang
                   __name__ = __module__ = property(bang)
               Bomb = type.__new__(Meta, "Bomb", (), {name: bang for name in (
                   "__eq__", "__hash__", "__repr__", "__str__", "__bool__", "__len__", "__iter__", "__getattr__",
                   "__float__", "__int__", "__index__", "__array__", "__getitem__", "__call__", "__reduce__",
                   "__reduce_ex__", "__format__", "__contains__", "_sympy_", "_repr_html_")})
               a_region = Bomb()
               """,
        ),
    ),
    Attack(
        "contains itself",
        "answers with a list that contains itself",
        "walking through it never ends",
        "depth is bounded",
        stopped_the_run,
        (
            """
        class Endless(list):
            def __repr__(self): return repr(self)
        a_region = [1]
        a_region.append(a_region)
        b_region = {}
        b_region["k"] = b_region
        """,
            """
        a_region = [a_region, Endless()]
        """,
        ),
        patience=3,
    ),
]

"""Notes which functions of some packages a computation calls, at the cost of these calls alone.

A profiler sees every call, also the millions within SymPy, and with one a verdict takes half as long again. Here each
function that matters has other code meanwhile, which notes the call and then does what the function does: so it is also
seen by whoever has imported the function before.

Not seen are functions made inside others, methods that use `super()`, and what is imported only meanwhile.
"""

import functools
import sys
from contextlib import contextmanager
from types import FunctionType


@contextmanager
def calls_noted(packages, heed):
    """Within it, the set of (module, name) grows by each function called for which `heed(its module, the frame of its
    caller)` is true; functions are those of modules whose names begin with one of `packages`."""
    called, codes = set(), {}
    for name, module in sys.modules.copy().items():
        if name.startswith(packages):
            codes |= {function: function.__code__ for function in _functions(vars(module), name, set())}
    for function in codes:
        _exchange(function, called, heed)
    try:
        yield called
    finally:
        for function, code in codes.items():
            function.__code__ = code


def _functions(names, module, seen):
    """The functions of a module or a class of it whose code can be exchanged, each once."""
    for value in names.copy().values():
        if isinstance(value, property):
            value = value.fget
        elif isinstance(value, functools.cached_property):
            value = value.func
        while isinstance(value, (staticmethod, classmethod, functools._lru_cache_wrapper)):
            value = value.__wrapped__
        if not isinstance(value, (FunctionType, type)) or value.__module__ != module or id(value) in seen:
            continue
        seen.add(id(value))
        if isinstance(value, type):
            yield from _functions(vars(value), module, seen)
            continue
        wrapped = getattr(value, "__wrapped__", None)
        if wrapped is not None:
            yield from _functions({"": wrapped}, module, seen)
        if not value.__closure__ and not value.__name__.startswith("<"):
            yield value


def _exchange(function, called, heed):
    module, name = function.__module__, function.__qualname__

    def note():
        if (module, name) not in called and heed(module, sys._getframe(2)):
            called.add((module, name))

    original = FunctionType(function.__code__, function.__globals__, function.__name__, function.__defaults__)
    original.__kwdefaults__ = function.__kwdefaults__
    put = {"NOTE": note, "FUNCTION": original}
    function.__code__ = _noted.__code__.replace(co_consts=tuple(put.get(constant, constant)
                                                                for constant in _noted.__code__.co_consts))


def _noted(*args, **kwargs):
    note = "NOTE"  # the texts stand for what is put in their places
    note()
    function = "FUNCTION"
    return function(*args, **kwargs)

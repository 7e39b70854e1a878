"""Notes which functions of some packages a computation calls, at the cost of these calls alone.

A profiler sees every call, also the millions within SymPy, and with one a verdict takes half as
long again. Here each function that matters has other code until it is noted, which does so and then
what the function does: so it is also seen by whoever has imported the function before.

Not seen are functions made inside others, methods that use `super()`, and what is imported only
meanwhile.
"""

import functools
import sys
from contextlib import contextmanager
from types import FunctionType

#: Where calls are noted now: the set, and what is heeded.
_NOW = [set(), None]


@contextmanager
def recorded_calls(packages, is_relevant):
    """Within it, the set of (module, name) grows by each function called for which `is_relevant(its
    module, the frame of its caller)` is true; functions are those of modules whose names begin with
    one of `packages`."""
    codes = recording_codes(packages)
    _NOW[:] = called, is_relevant = set(), is_relevant
    for function, _, noting in codes:
        function.__code__ = noting
    try:
        yield called
    finally:
        for function, own, _ in codes:
            function.__code__ = own


def recording_codes(packages):
    """(function, its code, one that notes the call first) for each function; a process that is
    forked from one that has asked for them finds them ready."""
    return [
        found
        for name in list(sys.modules)
        if name.startswith(packages)
        for found in _codes_in(name)
    ]


@functools.cache
def _codes_in(module):
    return [
        (function, function.__code__, _that_notes(function))
        for function in _functions(vars(sys.modules[module]), module, set())
    ]


def _functions(names, module, seen):
    """The functions of a module or a class of it whose code can be exchanged, each once."""
    for value in names.copy().values():
        if isinstance(value, property):
            value = value.fget
        elif isinstance(value, functools.cached_property):
            value = value.func
        while isinstance(value, (staticmethod, classmethod, functools._lru_cache_wrapper)):
            value = value.__wrapped__
        if (
            not isinstance(value, (FunctionType, type))
            or value.__module__ != module
            or id(value) in seen
        ):
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


def _that_notes(function):
    module, name, own = function.__module__, function.__qualname__, function.__code__

    def note():
        called, is_relevant = _NOW
        if is_relevant(module, sys._getframe(2)):
            called.add((module, name))
            function.__code__ = own

    original = FunctionType(
        function.__code__, function.__globals__, function.__name__, function.__defaults__
    )
    original.__kwdefaults__ = function.__kwdefaults__
    put = {"NOTE": note, "FUNCTION": original}
    return _noted.__code__.replace(
        co_consts=tuple(put.get(constant, constant) for constant in _noted.__code__.co_consts)
    )


def _noted(*args, **kwargs):
    note = "NOTE"  # the texts stand for what is put in their places
    note()
    function = "FUNCTION"
    return function(*args, **kwargs)

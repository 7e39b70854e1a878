"""Records which functions of some packages a computation calls, at the cost of these calls alone.

A profiler sees every call, also the millions within SymPy, and with one a verdict takes half as
long again. Here each function that matters has other code until it is recorded, which records it
and then does what the function does: so a function imported before is seen, too.

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
    """Collect (module, name) of each relevant function that is called in this context.

    `is_relevant(its module, the frame of its caller)` selects the calls; functions are those of modules
    whose names begin with one of `packages`.
    """
    codes = recording_codes(packages)
    _NOW[:] = called, is_relevant = set(), is_relevant
    for function, _, recording in codes:
        function.__code__ = recording
    try:
        yield called
    finally:
        for function, own, _ in codes:
            function.__code__ = own


def recording_codes(packages):
    """Return (function, its code, code that records the call first) for each function.

    A process forked from one that has called this finds them ready.
    """
    return [
        codes
        for name in list(sys.modules)
        if name.startswith(packages)
        for codes in _codes_in(name)
    ]


@functools.cache
def _codes_in(module):
    return [
        (function, function.__code__, _recording(function))
        for function in _functions(vars(sys.modules[module]), module, set())
    ]


def _functions(names, module, seen):
    """Yield the functions of a module or a class of it whose code can be exchanged, each once."""
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


def _recording(function):
    module, name, own = function.__module__, function.__qualname__, function.__code__

    def record():
        called, is_relevant = _NOW
        if is_relevant(module, sys._getframe(2)):
            called.add((module, name))
            function.__code__ = own

    original = FunctionType(
        function.__code__, function.__globals__, function.__name__, function.__defaults__
    )
    original.__kwdefaults__ = function.__kwdefaults__
    put = {"RECORD": record, "FUNCTION": original}
    return _recorded.__code__.replace(
        co_consts=tuple(put.get(constant, constant) for constant in _recorded.__code__.co_consts)
    )


def _recorded(*args, **kwargs):
    record = "RECORD"  # the texts stand for what is put in their places
    record()
    function = "FUNCTION"
    return function(*args, **kwargs)

"""Reading of python-control's StateSpace in place of matrices, and of python-control's keywords."""

import functools
import inspect
from collections.abc import Callable
from typing import TypeVar

from trajlib._arguments.matrices import is_state_space

#: The matrix of a StateSpace that an argument stands for.
_OF_SYSTEM = {"A": "A", "Phi": "A", "B": "B", "b": "B", "H": "C", "h": "C"}
Function = TypeVar("Function", bound=Callable)


def is_discrete(system):
    """Whether this is a StateSpace in discrete time: its `dt` is True or a step, not 0 or None."""
    return is_state_space(system) and bool(system.dt)


def _require_time(system, time, function, instead):
    """Raise ValueError for a StateSpace, the first argument of a function, in the other time."""
    if is_discrete(system) != (time == "discrete"):
        name = next(iter(inspect.signature(function).parameters))
        other = "continuous" if time == "discrete" else "discrete"
        raise ValueError(
            f"{name}: expected a system in {time} time, got one in {other} time (dt = {system.dt}); "
            f"{instead}"
        )


def accepts_state_space(
    *names: str, time: str | None = None, instead: str = "", **keywords: str
) -> Callable[[Function], Function]:
    """Let a StateSpace stand for the first arguments of a function or a class, called `names`.

    `time` is "continuous" or "discrete" where the function is for one of them only, `instead` the
    advice for a system in the other. `keywords` maps python-control's names of arguments to those here.
    A matrix that is given beside the system as a keyword takes the place of the system's own.
    """

    def translated(function, args, named):
        """Return the arguments with our names, and with the matrices of the system in its place."""
        for theirs, ours in keywords.items():
            if theirs in named:
                if ours in named:
                    raise TypeError(f"{function.__name__}: {theirs} and {ours} are one argument")
                named[ours] = named.pop(theirs)
        system = args[0] if args else named.get(names[0]) if names else None
        if not names or not is_state_space(system):
            return args, named
        if time is not None:
            _require_time(system, time, function, instead)
        named.pop(names[0], None)
        others = list(args[1:])
        matrices = [system.A]
        for name in names[1:]:
            if others and others[0] is None:
                del others[0]
            own = named.pop(name, None)
            matrices.append(getattr(system, _OF_SYSTEM[name]) if own is None else own)
        return [*matrices, *others], named

    def decorate(function):
        if isinstance(function, type):
            initialise = function.__init__

            @functools.wraps(initialise)
            def initialising(self, *args, **named):
                args, named = translated(function, args, named)
                initialise(self, *args, **named)

            function.__init__ = initialising
            return function

        @functools.wraps(function)
        def accepting(*args, **named):
            args, named = translated(function, args, named)
            return function(*args, **named)

        return accepting

    return decorate

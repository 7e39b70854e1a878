"""Keywords of python-control whose letters stand for something else here.

In `lqr(sys, Q=, R=, N=)` the N is the cross term, and in `lqg(sys, Q=, R=, QN=, RN=)` Q and R are
weights. A keyword that only python-control has, R or QN, shows that all of them are meant so.
"""

import functools
from collections.abc import Callable
from typing import TypeVar

Function = TypeVar("Function", bound=Callable)


def reads_keywords(*signs: str, **ours: str) -> Callable[[Function], Function]:
    """Rename all keywords in `ours` at once if one of the `signs` is among them."""

    def decorate(function):
        @functools.wraps(function)
        def renaming(*args, **named):
            if not named.keys().isdisjoint(signs):
                renamed = {}
                for name, value in named.items():
                    own = ours.get(name, name)
                    if own in renamed:
                        raise TypeError(f"{function.__name__}: {own} and {name} are one argument")
                    renamed[own] = value
                named = renamed
            return function(*args, **named)

        return renaming

    return decorate


#: For regulators: python-control's weights Q, R and its cross term N.
reads_weights = reads_keywords("R", Q="G", R="N", N="cross")

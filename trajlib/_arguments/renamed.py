"""Former names of keywords, refused by a sentence that names the present one."""

import functools
from collections.abc import Callable
from typing import TypeVar

Function = TypeVar("Function", bound=Callable)


def renamed(**names: str) -> Callable[[Function], Function]:
    """Let a function refuse former names of its keywords: `renamed(margin="degree")`."""

    def decorate(function):
        @functools.wraps(function)
        def refusing(*args, **named):
            for former in names.keys() & named.keys():
                raise TypeError(
                    f"{function.__name__}: {former} is called {names[former]} now "
                    f"({names[former]}={named[former]!r})"
                )
            return function(*args, **named)

        return refusing

    return decorate

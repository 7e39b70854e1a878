"""Checks of a course's own, in the file `checks.py` of its folder.

Check cells call them as they call the workbook's: `checks.reach(a_reach, lengths)`. The file is that
of the course which was entered or named (`workbook.course`), never one of a submission, and its code
is trusted as the course's cells are. It is read anew after a change.
"""

import inspect
import traceback
from functools import lru_cache
from types import ModuleType

from workbook import checks
from workbook.course import CourseError, current


def own_checks(home):
    """Return {name: check} of what a `Course` or None has in its `checks.py`, {} without that file.

    Raises
    ------
    CourseError
        If the file fails, or one of its functions is no check or has the name of a workbook's check.
    """
    path = home.checks if home else None
    return _read(path, path.stat().st_mtime_ns) if path else {}


def own_check(name):
    """Return a check of the course that is here; raise `AttributeError` if there is none."""
    own = own_checks(current())
    if name not in own:
        raise AttributeError(f"there is no check {name} here")
    return own[name]


@lru_cache(maxsize=16)
def _read(path, modified):
    module = ModuleType("course_checks")
    try:
        exec(compile(path.read_bytes(), path, "exec"), vars(module))
    except Exception as error:
        frames = traceback.extract_tb(error.__traceback__)
        lines = [frame.lineno for frame in frames if frame.filename == str(path)]
        line = lines[-1] if lines else getattr(error, "lineno", None) or 1
        message = " ".join(str(getattr(error, "msg", error)).split())
        raise CourseError(f"{path}:{line}: {type(error).__name__}: {message}") from None
    own = {
        name: value
        for name, value in vars(module).items()
        if inspect.isfunction(value)
        and value.__module__ == module.__name__
        and not name.startswith("_")
    }
    for name, check in own.items():
        where = f"{path}:{inspect.unwrap(check).__code__.co_firstlineno}"
        if checks.is_of_workbook(name):
            raise CourseError(f"{where}: the workbook has a check {name}; give yours another name")
        if not hasattr(check, "__wrapped__"):
            raise CourseError(
                f"{where}: {name} is no check: write @judged(...) above it, or begin the name of a "
                "function that is none with _"
            )
    return own

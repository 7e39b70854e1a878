"""What a check says of one answer, and how a check is written.

A check is a function `check(answer, *data)` under the decorator `judged`. It returns the sentence that says what
holds, or raises `Wrong` (a property fails) or `Invalid` (not of the type asked). Whatever else it raises is our
failure, and the verdict says so: `unchecked`, never wrong, never right.
"""

import functools
import warnings
from dataclasses import dataclass

RIGHT, WRONG, MISSING, INVALID, UNCHECKED = STATUSES = ("right", "wrong", "missing", "invalid", "unchecked")


class Wrong(Exception):
    """The answer fails a property; the message says which one, where, with numbers, and never the answer."""


class Invalid(Exception):
    """The answer is not of the type asked; the message says kindly what was expected."""


@dataclass(frozen=True)
class Verdict:
    """One answer judged: `status` is one of `STATUSES`, `message` a sentence for the student."""

    status: str
    message: str


@dataclass(frozen=True)
class Unusable:
    """Stands for an answer that could not be read as data; the reason becomes the verdict `invalid`."""

    reason: str


def judged(check):
    """Turn a check into a function that always returns a `Verdict`, whatever the answer is."""

    @functools.wraps(check)
    def judge(answer, *data, **options):
        if isinstance(answer, Unusable):
            return Verdict(INVALID, answer.reason)
        if _holds_ellipsis(answer):
            return Verdict(MISSING, "not answered yet")
        try:
            # A warning on stderr would cost the cell its points in nbgrader.
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                return Verdict(RIGHT, check(answer, *data, **options))
        except Wrong as failed:
            return Verdict(WRONG, str(failed))
        except Invalid as refused:
            return Verdict(INVALID, str(refused))
        except Exception as error:
            return Verdict(UNCHECKED, "this answer could not be judged; the fault is the check's, not yours "
                                      f"({type(error).__name__}: {str(error)[:200]})")

    return judge


def _holds_ellipsis(answer):
    """True for the untouched stub, also inside a list, tuple or dict that is filled only in part."""
    if answer is ...:
        return True
    if type(answer) in (list, tuple):
        return any(_holds_ellipsis(part) for part in answer)
    if type(answer) is dict:
        return any(_holds_ellipsis(part) for part in answer.values())
    return False

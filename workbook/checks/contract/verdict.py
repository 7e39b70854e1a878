"""What a check says of one answer, and how a check is written.

A check is a function `check(claim, *data)` under the decorator `judged(Expression("parameters"))`:
it is handed the answer as a claim of the type declared (`contract.claims`), yields comparisons
(`tools.comparisons`), and returns the sentence that says what holds. Under `judged` alone it reads
the answer itself. It may raise `Wrong` (a property fails) or `Invalid` (not of the type asked).
Whatever else it raises is our failure, and the verdict says so: `unchecked`, never wrong, never
right.

A check judges what a grader would receive: the answer encoded as data and decoded again, in a
notebook too. What cannot be written as data is `invalid` in both, with the same message; the data
are used as they are.
"""

import functools
import inspect
import warnings
from contextvars import ContextVar
from dataclasses import dataclass, field

from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import encode
from workbook.checks.contract.shapes import with_shapes
from workbook.checks.contract.traversal import EncodingError

RIGHT, WRONG, MISSING, INVALID, UNCHECKED = STATUSES = (
    "right",
    "wrong",
    "missing",
    "invalid",
    "unchecked",
)


#: What was noticed while an answer was read, said only if it turns out wrong.
_remarks = ContextVar("remarks", default=())


def remark(sentence):
    """Say this too, should the answer that is being judged be wrong."""
    _remarks.set((*_remarks.get(), sentence))


class Wrong(Exception):
    """The answer fails a property; the message says which one, where, with numbers, and never the
    answer."""


class Invalid(Exception):
    """The answer is not of the type asked; the message says kindly what was expected."""


@dataclass(frozen=True)
class Verdict:
    """One answer judged: `status` is one of `STATUSES`, `message` a sentence for the student.

    `mistake` asks what may have gone wrong, if `answer`, one that is wrong, is known for it
    (`workbook.mistakes`).
    """

    status: str
    message: str
    mistake: str = ""
    answer: object = field(default=None, compare=False, repr=False)


@dataclass(frozen=True)
class Unusable:
    """Stands for an answer that could not be read as data; the reason becomes the verdict
    `invalid`."""

    reason: str


def judged(check):
    """Turn a check into a function that always returns a `Verdict`, whatever the answer is.

    As `judged(claim)`, with the type as which the answer is read, a decorator that does.
    """
    return (
        _judged(check, None)
        if inspect.isfunction(check)
        else lambda function: _judged(function, check)
    )


def _judged(check, claim):
    names = inspect.signature(check)

    @functools.wraps(check)
    def judge(answer, *data, **options):
        if isinstance(answer, Unusable):
            return Verdict(INVALID, answer.reason)
        _remarks.set(())
        given = None
        try:
            # A warning on stderr would cost the cell its points in nbgrader.
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                given = received = decode(encode(answer))
                if _holds_ellipsis(received):
                    return Verdict(MISSING, "not answered yet")
                if claim is not None:
                    bound = names.bind(None, *data, **options)
                    bound.apply_defaults()
                    received = claim.read(received, bound.arguments)
                return Verdict(RIGHT, _sentence(check(received, *data, **options)))
        except Wrong as failed:
            return Verdict(
                WRONG, ". ".join([str(failed), *dict.fromkeys(_remarks.get())]), answer=given
            )
        except (Invalid, EncodingError) as refused:
            return Verdict(INVALID, str(refused))
        except Exception as error:
            return Verdict(
                UNCHECKED,
                "this answer could not be judged; the fault is the check's, not yours "
                f"({type(error).__name__}: {str(error)[:200]})",
            )

    judge.__doc__ = with_shapes(check.__doc__, check.__module__, names.parameters)
    return judge


def _sentence(found):
    """What a check returns, once all comparisons that it yields have been done; each gives back
    what it found."""
    if not inspect.isgenerator(found):
        return found
    seen = None
    while True:
        try:
            comparison = found.send(seen)
        except StopIteration as end:
            return end.value
        seen = comparison.judge()


def _holds_ellipsis(answer):
    """True for the untouched stub, also inside a list, tuple, set or dict that is filled only in
    part."""
    if answer is ...:
        return True
    if type(answer) in (list, tuple, set, frozenset):
        return any(_holds_ellipsis(part) for part in answer)
    if type(answer) is dict:
        return any(_holds_ellipsis(part) for part in answer.values())
    return False

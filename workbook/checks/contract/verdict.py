"""Verdicts on answers, and the decorator of all checks.

A check is a function `check(claim, *data)` under the decorator `judged(Expression("parameters"))`.
Its first argument is the answer, read as a claim of the declared type (`contract.claims`); it
yields comparisons (`tools.comparisons`) and returns the sentence that describes what holds. One that
compares with a value at samples is declared by its reference (`tools.declared`). Under
`judged` alone it reads the answer itself. It may raise `Wrong` (a property fails) or `Invalid` (not
of the type asked). Any other exception is our failure, and the verdict is then `unchecked`, never
wrong, never right.

A check judges what a grader would receive: the answer encoded as data and decoded again, in a
notebook too. What cannot be written as data is `invalid` in both, with the same message; the data
are used as they are.
"""

import functools
import inspect
import warnings
from contextvars import ContextVar
from dataclasses import dataclass, field

from workbook.checks.contract.data_kinds import unsuitable
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import encode
from workbook.checks.contract.few_numbers import with_few_numbers
from workbook.checks.contract.shapes import descriptions_of, with_shapes
from workbook.checks.contract.traversal import EncodingError

RIGHT, WRONG, MISSING, INVALID, UNCHECKED = STATUSES = (
    "right",
    "wrong",
    "missing",
    "invalid",
    "unchecked",
)


#: Remarks on the form of an answer, shown only if it is wrong.
_remarks = ContextVar("remarks", default=())


def remark(sentence):
    """Add a sentence to the message in case that the answer being judged is wrong."""
    _remarks.set((*_remarks.get(), sentence))


class Wrong(Exception):
    """Raised when an answer fails a property.

    The message names the property, where it fails, and numbers of the student's own answer: never
    the true value, and no residual that the student could not compute from the data.
    """


class Invalid(Exception):
    """Raised when an answer is not of the type asked; the message says kindly what was expected."""


class UnsuitableData(ValueError):
    """Raised when a check cannot judge its data: by the check itself, whatever the answer is.

    The message is one sentence to the author of the check cell. Of nothing else a check raises an
    exception.
    """


@dataclass(frozen=True)
class Verdict:
    """The verdict on one answer.

    Parameters
    ----------
    status : str
        One of `STATUSES`: right, wrong, missing, invalid, unchecked (our failure, never counted).
    message : str
        A sentence for the student.
    mistake : str
        What may have gone wrong, if that is known for this answer (`workbook.mistakes`).
    answer : object
        The decoded answer if it is wrong, to look the mistake up.
    """

    status: str
    message: str
    mistake: str = ""
    answer: object = field(default=None, compare=False, repr=False)


@dataclass(frozen=True)
class Unusable:
    """Replaces an answer that could not be read as data.

    Parameters
    ----------
    reason : str
        The message of the verdict `invalid`.
    """

    reason: str


def judged(check=None, **kinds):
    """Turn a check into a function that always returns a `Verdict`.

    Parameters
    ----------
    check : callable or Claim
        The check, `check(answer, *data)`; or, used as `judged(claim)`, the type as which the answer
        is read before the check is called.
    **kinds : str
        Descriptions of data by name, where the check takes fewer kinds of records than others of its
        theme (`contract.shapes`).

    Returns
    -------
    callable
        A function of the same arguments, whatever the answer is; or a decorator for such a check. It
        raises `UnsuitableData` if data are of no kind that is described.

    Notes
    -----
    The check may be a generator of comparisons (`workbook.checks.tools.comparisons`), each of which is
    judged before it goes on. It returns the message of a right answer.
    """
    return (
        _judged(check, None, {})
        if inspect.isfunction(check)
        else lambda function: _judged(function, check, kinds)
    )


def _judged(check, claim, kinds):
    names = inspect.signature(check)
    descriptions = descriptions_of(check.__module__, kinds)

    @functools.wraps(check)
    def judge(answer, *data, **options):
        if isinstance(answer, Unusable):
            return Verdict(INVALID, answer.reason)
        _remarks.set(())
        if "margin" in options and "degree" in names.parameters:
            raise TypeError(f"{check.__name__}: margin is called degree now")
        decoded, bound = None, names.bind(None, *data, **options)
        for name, datum in bound.arguments.items():
            if reason := unsuitable(datum, descriptions.get(name, "")):
                raise UnsuitableData(f"{name}: {reason}")
        try:
            # A warning on stderr would cost the cell its points in nbgrader.
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                decoded = received = decode(encode(answer))
                if _holds_ellipsis(received):
                    return Verdict(MISSING, "not answered yet")
                if claim is not None:
                    bound.apply_defaults()
                    received = claim.read(received, bound.arguments)
                message = _message(check(received, *data, **options))
                return Verdict(RIGHT, with_few_numbers(message, decoded))
        except Wrong as failed:
            message = ". ".join(
                [with_few_numbers(str(failed), decoded), *dict.fromkeys(_remarks.get())]
            )
            return Verdict(WRONG, message, answer=decoded)
        except (Invalid, EncodingError) as refused:
            return Verdict(INVALID, str(refused))
        except UnsuitableData:
            raise
        except ModuleNotFoundError as missing:  # in a page of the site
            return Verdict(
                UNCHECKED,
                f"this check runs in the notebook: it needs {missing.name}, not in a page",
            )
        except Exception as error:
            return Verdict(
                UNCHECKED,
                "this answer could not be judged; the fault is the check's, not yours "
                f"({type(error).__name__}: {str(error)[:200]})",
            )

    judge.__doc__ = with_shapes(check.__doc__, descriptions, names.parameters)
    return judge


def _message(outcome):
    """Return the message that a check returns after all comparisons that it yields are judged."""
    if not inspect.isgenerator(outcome):
        return outcome
    result = None
    while True:
        try:
            comparison = outcome.send(result)
        except StopIteration as end:
            return end.value
        result = comparison.judge()


def _holds_ellipsis(answer):
    """Return whether an answer is the untouched stub or a collection that holds it."""
    if answer is ...:
        return True
    if type(answer) in (list, tuple, set, frozenset):
        return any(_holds_ellipsis(part) for part in answer)
    if type(answer) is dict:
        return any(_holds_ellipsis(part) for part in answer.values())
    return False

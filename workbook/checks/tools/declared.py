"""Declared checks: a reference at values of the symbols and two phrases are the whole check.

    @declared(
        Matrix("parameters", shape="A"),
        right="it is the covariance of the state",
        wrong=lambda entry: f"your entry is {entry.text}{entry.where}, not the covariance",
    )
    def covariance(values, process):
        return Truth(covariance_of(process, values))

becomes a check `covariance(claim, process, parameters=(), given=True)`. The sentence `right` is the
message on a right answer. The phrase `wrong` is the property that fails: of a matrix a function of
the wrong entry, of an expression the quantity, as `SameValue` names it, of several numbers in any
order the two messages of `SameNumbers`.
"""

import functools
import inspect
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import judged
from workbook.checks.tools.comparisons import SameEntries, SameNumbers, SameValue
from workbook.checks.tools.samples import allowed_values, in_every_case
from workbook.checks.tools.wording import entry_text, where_text

#: The number of samples where a check does not choose them itself.
COUNT = 6
_KIND = inspect.Parameter.POSITIONAL_OR_KEYWORD
_CLAIM = inspect.Parameter("claim", _KIND)
_COMMON = (
    inspect.Parameter("parameters", _KIND, default=()),
    inspect.Parameter("given", _KIND, default=sp.true),
)


@dataclass(frozen=True)
class Truth:
    """What holds at one sample.

    Parameters
    ----------
    value : float or numpy.ndarray
        The true value, the true entries, or the true numbers.
    size : float or numpy.ndarray
        The size of the terms, which may cancel.
    context : object
        What else the phrase on a wrong answer depends on.
    """

    value: Any
    size: Any = 0.0
    context: Any = None


@dataclass(frozen=True)
class WrongEntry:
    """The entry of a wrong answer that its message names.

    Parameters
    ----------
    answer : sympy.Matrix
        The answer.
    claimed : numpy.ndarray
        Its numbers at the sample.
    row, column : int
        The position of the entry.
    values : dict
        The sample, {symbol: value}.
    context : object
        That of the `Truth`.
    """

    answer: sp.MatrixBase
    claimed: np.ndarray
    row: int
    column: int
    values: dict
    context: Any

    @property
    def number(self):
        """The number of the answer there."""
        return self.claimed[self.row, self.column]

    @property
    def where(self):
        """The sample for the end of a clause; empty without symbols."""
        return where_text(self.values)

    @property
    def text(self):
        """The position and the number."""
        return entry_text(self.claimed, self.row, self.column)


def at_symbols(*names, count=COUNT):
    """Return a function of the data: samples of the symbols in some data and of the parameters.

    They satisfy what is given, which is also the condition on further samples.
    """

    def samples(data):
        symbols = [*(symbol for name in names for symbol in data[name]), *data["parameters"]]
        return allowed_values(symbols, data["given"], count), data["given"]

    return samples


def declared(
    claim, right: str | Callable, wrong: str | tuple | Callable, samples=at_symbols(), **kinds
):
    """Turn `reference(values, *data) -> Truth` into a check.

    Parameters
    ----------
    claim : Claim
        The type of the answer.
    right : str or callable
        The sentence on a right answer, or a function of the data that returns it.
    wrong : str, pair of str, or callable
        The quantity, two messages, or a function of a `WrongEntry` that returns the message.
    samples : callable
        A function of the data that returns samples, {symbol: value}, and the condition that further
        samples have to satisfy.
    **kinds : str
        Descriptions of data, as for `judged`.

    Returns
    -------
    callable
        A decorator. The check has the data of the reference, and before its options `parameters` and
        `given`; the reference gets the data that it names.
    """

    def decorate(reference):
        _, *own = inspect.signature(reference).parameters.values()
        required = [datum for datum in own if datum.default is datum.empty]
        signature = inspect.Signature([_CLAIM, *required, *_COMMON, *own[len(required) :]])

        @functools.wraps(reference)
        def check(*arguments, **options):
            bound = signature.bind(*arguments, **options)
            bound.apply_defaults()
            answer, data = bound.args[0], bound.arguments
            points, domain = samples(data)
            for values in in_every_case(points, answer, domain):
                truth = reference(values, **{datum.name: data[datum.name] for datum in own})
                yield _comparison(answer, truth, wrong, values)
            return right(data) if callable(right) else right

        check.__signature__ = signature
        return judged(claim, **kinds)(check)

    return decorate


def _comparison(answer, truth, wrong, values):
    if isinstance(wrong, tuple):
        return SameNumbers(answer, truth.value, *wrong, values, truth.size)
    if not callable(wrong):
        return SameValue(answer, truth.value, wrong, values, truth.size)
    return SameEntries(
        answer,
        truth.value,
        lambda claimed, i, j: wrong(WrongEntry(answer, claimed, i, j, values, truth.context)),
        values,
        truth.size,
    )

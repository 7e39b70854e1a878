"""The steps of `solve` as records: each with its theorem, its source and its hypotheses.

A step is used where all its hypotheses hold for the statement. The lists in `indirect.steps` give
the order; `solve` follows them and `explain` prints them.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from trajlib.pontryagin.problem.errors import PontryaginError
from trajlib.pontryagin.problem.statement import Statement


@dataclass(frozen=True)
class Hypothesis:
    """A property that a statement has or has not.

    Attributes
    ----------
    text : str
        The property, as a clause.
    test : callable
        Function of a statement without parameters.
    """

    text: str
    test: Callable[[Statement], bool]

    def holds(self, problem: Statement) -> bool:
        """Check whether a statement has the property; computed once for a statement."""
        return problem.cached(f"hypothesis: {self.text}", lambda: bool(self.test(problem)))


@dataclass(frozen=True)
class Step:
    """A step of `solve`.

    Attributes
    ----------
    name : str
        What is treated.
    theorem : str
        What is done or proved, in one sentence.
    source : str
        Where it is proved: a work, or the module that has the proof.
    hypotheses : tuple of Hypothesis
        All of them must hold.
    """

    name: str
    theorem: str
    source: str
    hypotheses: tuple[Hypothesis, ...]

    def missing(self, problem: Statement) -> Hypothesis | None:
        """Return the first hypothesis that does not hold, or None."""
        return next((h for h in self.hypotheses if not h.holds(problem)), None)

    def applies(self, problem: Statement) -> bool:
        """Check whether all hypotheses hold."""
        return self.missing(problem) is None


@dataclass(frozen=True)
class Reformulation(Step):
    """A problem in another form, which is solved in place of the first.

    Attributes
    ----------
    reformulate : callable
        Function of the problem; its result has the other problem as attribute `problem`.
    structure, guess : callable
        (result, arcs or guess of the first problem) -> those of the other.
    restore : callable
        (result, extremal of the other problem) -> extremal of the first.
    controls : callable
        (result, states (n, N), controls of the other problem) -> controls of the first, (k, N).
    describe : callable
        Function of the result: what was put in place of what, in one line.
    """

    reformulate: Callable[[Statement], Any]
    structure: Callable[[Any, Any], Any]
    guess: Callable[[Any, Any], Any]
    restore: Callable[[Any, Any], Any]
    controls: Callable[[Any, Any, Any], Any]
    describe: Callable[[Any], str]


@dataclass(frozen=True)
class Refusal(Step):
    """A reason why a problem has no solution, or why none is found.

    Attributes
    ----------
    error : type
        Raised where the reason is found; its class says what is proved.
    refuse : callable
        (numeric, *found) -> None, raises `error`; the list says what `found` is.
    """

    error: type[PontryaginError]
    refuse: Callable[..., Any]

    def check(self, numeric, *found):
        """Raise `error` if the hypotheses hold and the reason is found."""
        return self.refuse(numeric, *found) if self.applies(numeric.problem) else None


@dataclass(frozen=True)
class Method(Step):
    """A way to an extremal.

    Attributes
    ----------
    solve : callable
        Function of the problem; None as result: the next method.
    describe : callable, optional
        Function of the problem: what is known before it is solved, in one line.
    """

    solve: Callable[..., Any]
    describe: Callable[[Statement], str] = lambda _problem: ""

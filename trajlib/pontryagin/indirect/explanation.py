"""Which steps `solve` takes for a problem, in which order, and why."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from textwrap import fill

from trajlib.pontryagin.indirect.steps import ORDER, RICCATI
from trajlib.pontryagin.problem.errors import PontryaginError
from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.problem.steps import Method, Reformulation, Refusal, Step
from trajlib.typesetting import typeset

WIDTH = 100


@dataclass(frozen=True)
class ExplainedStep:
    """A step of `solve` for one problem.

    Attributes
    ----------
    stage, name : str
        The list that the step belongs to, and what it treats.
    kind : str
        "reformulation", "method", or the name of the error that a refusal raises.
    applies : bool
        Whether it is taken; a refusal that applies is tried, which need not refuse the problem.
    reason : str
        The hypotheses that hold, or the first one that does not.
    theorem, source : str
        What is done or proved, and where this is proved.
    detail : str
        What follows for this problem, as the new variables of a reformulation; may be empty.
    """

    stage: str
    name: str
    kind: str
    applies: bool
    reason: str
    theorem: str
    source: str
    detail: str

    def __str__(self):
        if not self.applies:
            return f"- {self.name}: {self.reason}"
        detail = f" Here: {self.detail}." if self.detail else ""
        return f"+ {self.name} ({self.kind}): {self.reason}.{detail} {self.theorem} [{self.source}]"


@dataclass(frozen=True, eq=False)
class Explanation:
    """The steps of `solve` for a problem, in their order; shows itself as text and HTML.

    Attributes
    ----------
    problem : Problem
        The problem.
    steps : tuple of ExplainedStep
        Of each stage; those that apply and those that do not.
    """

    problem: Statement
    steps: tuple[ExplainedStep, ...]

    @property
    def applied(self) -> tuple[ExplainedStep, ...]:
        """The steps that apply."""
        return tuple(step for step in self.steps if step.applies)

    def __repr__(self):
        lines = []
        for stage, steps in self._stages():
            lines.append(stage[0].upper() + stage[1:])
            lines += [fill(f"  {step}", WIDTH, subsequent_indent="    ") for step in steps]
        return "\n".join(lines)

    def _repr_html_(self):
        parts = []
        for stage, steps in self._stages():
            items = "".join(f"<li>{typeset(str(step))}</li>" for step in steps)
            parts.append(
                f"<p><b>{stage[0].upper() + stage[1:]}</b></p>"
                f"<ul style='list-style: none'>{items}</ul>"
            )
        return "".join(parts)

    def _stages(self):
        return groupby(self.steps, key=lambda step: step.stage)


def explain(problem: Statement) -> Explanation:
    """Return the steps that `solve` takes for a problem; called as `problem.explain()`.

    Nothing is solved: a refusal that applies is tried later, a reformulation is carried out.

    Parameters
    ----------
    problem : Problem
        Without parameters.

    Returns
    -------
    Explanation
        All steps in their order, each with the hypotheses on which it depends.

    Raises
    ------
    ValueError
        If a parameter has no value.
    """
    if problem.parameters:
        names = ", ".join(map(str, problem.parameters))
        raise ValueError(f"explain: no value for {names}; give values by problem.subs({{...}})")
    return Explanation(problem, tuple(_explained(problem)))


def _explained(problem) -> Iterator[ExplainedStep]:
    for stage, steps in ORDER:
        for step in steps:
            missing, detail = step.missing(problem), ""
            if missing is None and isinstance(step, Reformulation):
                try:
                    other = step.reformulate(problem)
                except PontryaginError as error:
                    yield _record(stage, step, None, str(error).rstrip("."))
                    return
                problem, detail = other.problem, step.describe(other)
            elif missing is None and isinstance(step, Method):
                detail = step.describe(problem)
            yield _record(stage, step, missing, detail)
            if missing is None and step is RICCATI:
                return


def _record(stage, step: Step, missing, detail):
    kind = step.error.__name__ if isinstance(step, Refusal) else type(step).__name__.lower()
    reason = "; ".join(h.text for h in step.hypotheses) or "always"
    if missing is not None:
        reason = f"does not apply, since it needs that {missing.text}"
    return ExplainedStep(
        stage, step.name, kind, missing is None, reason, step.theorem, step.source, detail
    )

"""Comparison of extremals: the maximum principle is necessary, the cost decides."""

from collections.abc import Iterable
from dataclasses import dataclass

from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.indirect.solve import solve
from trajlib.pontryagin.problem.arcs import arc_latex
from trajlib.pontryagin.problem.errors import PontryaginError
from trajlib.pontryagin.problem.statement import Statement


@dataclass(frozen=True)
class Comparison:
    """Several extremals of one problem, the best first; shows itself as a table in a notebook.

    Attributes
    ----------
    extremals : tuple of Extremal
        Sorted by cost.
    refused : tuple of tuple
        (structure or guess, reason) for those that led to none.
    """

    extremals: tuple[Extremal, ...]
    refused: tuple[tuple, ...]

    @property
    def best(self) -> Extremal:
        """The extremal with the best cost."""
        return self.extremals[0]

    def _repr_markdown_(self):
        rows = "".join(
            f"| {', '.join(arc_latex(kind) for kind, _, _ in e.arcs)} | {e.cost:.9g} | "
            f"{e.duration:.9g} | {', '.join(f'{t:.6g}' for t in e.switching_times)} |\n"
            for e in self.extremals
        )
        rows += "".join(
            f"| {', '.join(map(arc_latex, structure))} | none | | {reason} |\n"
            for structure, reason in self.refused
        )
        return f"| arcs | $J$ | $t_k$ | switchings |\n|---|---|---|---|\n{rows}"


def compare(
    problem: Statement,
    structures: Iterable = (),
    guess: Extremal | dict | None = None,
    guesses: Iterable = (),
) -> Comparison:
    """Compare the extremals with given structures and those near given guesses.

    Parameters
    ----------
    problem : Problem
        Without parameters.
    structures : list of list, optional
        Lists of arcs, each solved from `guess`.
    guess : Extremal or dict, optional
        As for `Problem.solve`.
    guesses : list, optional
        Guesses from which the arcs are found.

    Returns
    -------
    Comparison
        The extremals, the best first; structures and guesses without one are listed with the
        reason.

    Raises
    ------
    ValueError
        If there is nothing to compare.
    PontryaginError
        If nothing leads to an extremal.

    Examples
    --------
    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x1, x2, u = sp.symbols("x1 x2 u")
    >>> transfer = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 1, x2: 0}, terminal=[x1, x2])
    >>> comparison = compare(transfer, [["u-", "u+"], ["u+", "u-"]])
    >>> round(comparison.best.duration, 9), len(comparison.refused)
    (2.0, 1)
    >>> len(compare(transfer, guesses=[{"duration": 2}, {"duration": 5}]).extremals)
    2
    """
    attempts = [(structure, guess) for structure in structures] + [
        (None, other_guess) for other_guess in guesses
    ]
    if not attempts:
        raise ValueError("structures, guesses: expected at least one of them")
    extremals, refused = [], []
    for structure, start in attempts:
        try:
            extremals.append(solve(problem, structure, start))
        except PontryaginError as error:
            refused.append(
                (tuple(structure) if structure is not None else (f"guess {start}",), str(error))
            )
    if not extremals:
        raise PontryaginError(
            "none of the structures and guesses to compare leads to an extremal: "
            + "; ".join(reason for _, reason in refused)
        )
    return Comparison(
        tuple(sorted(extremals, key=lambda e: -e.cost if problem.maximise else e.cost)),
        tuple(refused),
    )

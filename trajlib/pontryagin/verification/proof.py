"""Proofs in ball arithmetic: the exact extremal is enclosed, and optimal by a theorem.

The exact extremal next to a computed one is enclosed, with its maximum condition
(`enclosed_extremal`); then the theorem of `optimality` makes it optimal. H is concave in the
controls in both theorems, so that the signs of its derivatives by the single controls are enough.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.verification.ball_arithmetic import Enclosure, NotProved, Undetermined
from trajlib.pontryagin.verification.enclosed_extremal import EnclosedExtremal
from trajlib.pontryagin.verification.linear_arcs import NotLinear
from trajlib.pontryagin.verification.optimality import sufficiency_theorem
from trajlib.typesetting import typeset

# Bits of the arithmetic: more where errors grow along the arcs.
PRECISIONS = (256, 1024)


@dataclass(frozen=True)
class Proof:
    """A proof that an extremal is optimal, or the reason why there is none.

    Attributes
    ----------
    holds : bool
        Whether the extremal is proved optimal.
    reason : str
        The theorem, or where the proof fails.
    cost, duration : Enclosure or None
        J and t_k; None if nothing is proved.
    switching_times, costate : tuple of Enclosure
        The times between the arcs, and psi(0) with lambda_0 = 1; empty if nothing is proved.
    """

    holds: bool
    reason: str
    cost: Enclosure | None = None
    duration: Enclosure | None = None
    switching_times: tuple[Enclosure, ...] = ()
    costate: tuple[Enclosure, ...] = ()

    def __str__(self):
        if not self.holds:
            return f"not proved: {self.reason}"
        switchings = ", ".join(map(str, self.switching_times)) or "none"
        return f"proved optimal ({self.reason}): cost {self.cost}, duration {self.duration}, switchings {switchings}"

    def _repr_markdown_(self):
        if not self.holds:
            return f"Not proved: {self.reason}."
        rows = [("$J$", self.cost), ("$t_k$", self.duration)]
        rows += [(f"switching {i}", time) for i, time in enumerate(self.switching_times, 1)]
        rows += [(rf"$\psi_{i}(0)$", value) for i, value in enumerate(self.costate, 1)]
        table = "".join(f"| {name} | {typeset(str(value))} |\n" for name, value in rows)
        return f"Proved optimal: {self.reason}.\n\n| quantity | enclosure |\n|---|---|\n{table}"


def prove(
    problem: Statement, arcs: Sequence[tuple], state, costate, multiplier: float = 1.0
) -> Proof:
    """Prove that the exact extremal with these arcs, near these initial values, is optimal.

    Parameters
    ----------
    problem : Problem
        Without parameters; a linear plant with a cost that is at most quadratic.
    arcs : list of tuple
        (kind, begin, end) as in `Extremal.arcs`.
    state, costate : array_like, shape (n,)
        Values at t = 0.
    multiplier : float, optional
        lambda_0; only a normal extremal can be proved optimal.

    Returns
    -------
    Proof
        It encloses the exact extremal, whose distance from the given values is less than 1e-7 of
        their size, or nothing is proved.

    Raises
    ------
    ImportError
        Without python-flint.

    Examples
    --------
    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x1, x2, u = sp.symbols("x1 x2 u")
    >>> transfer = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 2, x2: 0}, [x1, x2])
    >>> arcs = [("u-", 0, 1.4142135624), ("u+", 1.4142135624, 2.8284271247)]
    >>> proof = prove(transfer, arcs, [2, 0], [-0.7071067812, -1])
    >>> proof.holds, 2*sp.sqrt(2) in proof.duration
    (True, True)
    >>> print(prove(transfer, [("u-", 0, 2.8)], [2, 0], [-0.7, -1]))
    not proved: the conditions of these arcs do not determine the costate and the switchings
    """
    try:
        from flint import ctx
    except ImportError:
        raise ImportError(
            "a proof needs ball arithmetic, which is not installed here: pip install 'trajlib[proof]'"
        ) from None

    if problem.constrained:
        return Proof(False, "inequalities along the path or at the end are not enclosed here")
    theorem, reason = sufficiency_theorem(problem), ""
    if theorem is None or problem.first_return:
        return Proof(
            False, "no theorem is known here that makes an extremal of this problem optimal"
        )
    if not multiplier > 0:
        return Proof(False, "the extremal is abnormal (lambda_0 = 0)")
    for precision in PRECISIONS:
        with ctx.workprec(precision):
            try:
                return Proof(
                    True, theorem[0], *EnclosedExtremal(problem, arcs, state, costate).values()
                )
            except Undetermined as error:
                reason = str(error)
            except (NotProved, NotLinear) as error:
                return Proof(False, str(error))
    return Proof(False, reason)

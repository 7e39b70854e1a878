"""Arcs of an extremal: the kinds of control on them, and their names.

The kinds, one for each control: "u-" and "u+" (at a bound), "interior" (dH/du = 0 between the
bounds) and "singular" (H linear in u, dH/du = 0 on the arc).
"""

from dataclasses import dataclass

import numpy as np

KINDS = ("u-", "u+", "interior", "singular")
# A control that keeps the trajectory on the boundary of a path constraint, followed by its number.
BOUNDARY = "boundary"
# Arcs of a constant angle, with the angle that is added to the common one. To the user they are
# interior.
CONSTANT_ANGLES = {"ahead": 0.0, "back": np.pi}


@dataclass(frozen=True)
class Arc:
    """An arc that is still to be refined: its kinds (one for each control), begin and end.

    `touch`: the path constraint whose boundary the trajectory touches where the arc begins, or None.
    """

    kinds: tuple[str, ...]
    begin: float
    end: float
    touch: int | None = None


def boundary_kind(constraint: int) -> str:
    """Return the kind of a control that keeps a path constraint (0, 1, ...) active."""
    return f"{BOUNDARY} {constraint + 1}"


def boundary_constraint(kinds) -> int | None:
    """Return which path constraint is active along an arc of these kinds, or None."""
    return next((int(kind.split()[1]) - 1 for kind in kinds if kind.startswith(BOUNDARY)), None)


def arc_name(kinds):
    """Return the kinds of an arc as text: the word alone for one control."""
    return kinds[0] if len(kinds) == 1 else "(" + ", ".join(kinds) + ")"


def arc_latex(kind):
    """Return the kind of an arc, or a tuple of them, in LaTeX."""
    if not isinstance(kind, str):
        return "(" + ", ".join(map(arc_latex, kind)) + ")"
    return {"u-": "$u_-$", "u+": "$u_+$", "zero": "$0$"}.get(kind, kind)

"""Arcs of an extremal: the kinds of control on them, and their names.

The kinds, one for each control: "u-" and "u+" (at a bound), "interior" (dH/du = 0 between the
bounds) and "singular" (H linear in u, dH/du = 0 on the arc).
"""

from dataclasses import dataclass

import numpy as np

KINDS = ("u-", "u+", "interior", "singular")
# Arcs of a constant angle, with the angle that is added to the common one. To the user they are
# interior.
CONSTANT_ANGLES = {"ahead": 0.0, "back": np.pi}


@dataclass(frozen=True)
class Arc:
    """An arc that is still to be refined: its kinds (one for each control), begin and end."""

    kinds: tuple[str, ...]
    begin: float
    end: float


def arc_name(kinds):
    """Return the kinds of an arc as text: the word alone for one control."""
    return kinds[0] if len(kinds) == 1 else "(" + ", ".join(kinds) + ")"


def arc_latex(kind):
    """Return the kind of an arc, or a tuple of them, in LaTeX."""
    if not isinstance(kind, str):
        return "(" + ", ".join(map(arc_latex, kind)) + ")"
    return {"u-": "$u_-$", "u+": "$u_+$", "zero": "$0$"}.get(kind, kind)

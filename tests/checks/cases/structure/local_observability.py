import sympy as sp
from case import Case

x1, x2, x3, a, v = sp.symbols("x1 x2 x3 a v", real=True)
PLANE, SPACE = [x1, x2], [x1, x2, x3]
#: Squares of the distances from (1, 0) and (-1, 0), and from a place that may lie on their line.
TWO = [(x1 - 1)**2 + x2**2, (x1 + 1)**2 + x2**2]
THREE = [*TWO, x1**2 + (x2 - a)**2]
#: The distance itself, and directions to (x1, x2) from (0, 0) and from (v, 0).
RANGES = [sp.sqrt(part) for part in TWO]
BEARINGS = [part/sp.sqrt((x1 - k)**2 + x2**2) for k in (0, v) for part in (x1 - k, x2)]
ON_LINE = {x2: 0}

CASES = [
    Case("locally_determined", sp.Ne(x2, 0), (TWO, PLANE, PLANE), "right", "off the line of the two"),
    Case("locally_determined", sp.Ne(x2, 0), (RANGES, PLANE, PLANE), "right", "roots change nothing"),
    Case("locally_determined", sp.Or(sp.Ne(x2, 0), sp.Ne(a, x2)), (THREE, PLANE, [*PLANE, a]), "right",
         "a third one helps"),
    Case("locally_determined", sp.Ne(a, 0), (THREE, PLANE, [x1, a], ON_LINE), "right", "on the line"),
    Case("locally_determined", sp.Ne(v*x2, 0), (BEARINGS, PLANE, [*PLANE, v]), "right", "a base, and off it"),
    Case("locally_determined", sp.true, (TWO, PLANE, PLANE), "wrong", "two equations for two unknowns"),
    Case("locally_determined", sp.Ne(x1, 0), (TWO, PLANE, PLANE), "wrong", "the other coordinate"),
    Case("locally_determined", sp.Ne(v, 0), (BEARINGS, PLANE, [*PLANE, v]), "wrong", "a base alone"),
    Case("locally_determined", x2, (TWO, PLANE, PLANE), "invalid", "an expression"),
    Case("unseen_changes", [[0, 3]], (TWO, PLANE, [x1], ON_LINE), "right", "across the line"),
    Case("unseen_changes", [], (TWO, PLANE, PLANE), "right", "everywhere else none"),
    Case("unseen_changes", [[-x2, x1]], (TWO[:1], PLANE, PLANE, {x1: x1 + 1}), "right", "around a single one"),
    Case("unseen_changes", [[x1, x2]], (BEARINGS[:2], PLANE, PLANE), "right", "along a single bearing"),
    Case("unseen_changes", [[1, 0]], (TWO, PLANE, [x1], ON_LINE), "wrong", "along the line"),
    Case("unseen_changes", [], (TWO, PLANE, [x1], ON_LINE), "wrong", "more is unseen"),
    Case("unseen_changes", [[0, 1], [0, 2]], (TWO, PLANE, [x1], ON_LINE), "wrong", "dependent"),
    Case("unseen_changes", [[x1, x2]], (TWO[:1], PLANE, PLANE, {x1: x1 + 1}), "wrong", "towards it"),
    Case("unseen_changes", [[1, 0, 0]], (TWO, PLANE, [x1], ON_LINE), "invalid", "too many components"),
]
LIMITS = ["To first order: where the Jacobian loses rank, terms of higher order may still tell the unknowns apart, as "
          "a range tells a place on the line of two stations from its neighbours.",
          "The entries of a row of the Jacobian may have one root in common, as those of a range or of a bearing, not "
          "several."]

import sympy as sp
from case import Case

from workbook.systems import Measurements

x1, x2, x3, a, v = sp.symbols("x1 x2 x3 a v", real=True)
PLANE, SPACE = [x1, x2], [x1, x2, x3]
#: Squares of the distances from (1, 0) and (-1, 0), and from a place that may lie on their line.
TWO = [(x1 - 1) ** 2 + x2**2, (x1 + 1) ** 2 + x2**2]
THREE = [*TWO, x1**2 + (x2 - a) ** 2]
#: The distance itself, and directions to (x1, x2) from (0, 0) and from (v, 0).
RANGES = [sp.sqrt(part) for part in TWO]
BEARINGS = [part / sp.sqrt((x1 - k) ** 2 + x2**2) for k in (0, v) for part in (x1 - k, x2)]
BY_TWO, ON_LINE = (Measurements(TWO, PLANE), PLANE), (Measurements(TWO, PLANE, {x2: 0}), [x1])
AROUND = (Measurements(TWO[:1], PLANE, {x1: x1 + 1}), PLANE)
FROM_BASE = (Measurements(BEARINGS, PLANE), [*PLANE, v])

CASES = [
    Case("observable_parameters", sp.Ne(x2, 0), BY_TWO, "right", "off the line of the two"),
    Case(
        "observable_parameters",
        sp.Ne(x2, 0),
        (Measurements(RANGES, PLANE), PLANE),
        "right",
        "roots change nothing",
    ),
    Case(
        "observable_parameters",
        sp.Or(sp.Ne(x2, 0), sp.Ne(a, x2)),
        (Measurements(THREE, PLANE), [*PLANE, a]),
        "right",
        "a third one helps",
    ),
    Case(
        "observable_parameters",
        sp.Ne(a, 0),
        (Measurements(THREE, PLANE, {x2: 0}), [x1, a]),
        "right",
        "on the line",
    ),
    Case("observable_parameters", sp.Ne(v * x2, 0), FROM_BASE, "right", "a base, and off it"),
    Case(
        "observable_parameters",
        sp.S.Reals - sp.FiniteSet(0),
        BY_TWO,
        "right",
        "a set of values of the coordinate that matters",
    ),
    Case("observable_parameters", sp.true, BY_TWO, "wrong", "two equations for two unknowns"),
    Case("observable_parameters", sp.Ne(x1, 0), BY_TWO, "wrong", "the other coordinate"),
    Case("observable_parameters", sp.Ne(v, 0), FROM_BASE, "wrong", "a base alone"),
    Case("observable_parameters", x2, BY_TWO, "invalid", "an expression"),
    Case("unobservable_states", [[0, 3]], ON_LINE, "right", "across the line"),
    Case("unobservable_states", [], BY_TWO, "right", "everywhere else none"),
    Case("unobservable_states", [[-x2, x1]], AROUND, "right", "around a single one"),
    Case(
        "unobservable_states",
        [[x1, x2]],
        (Measurements(BEARINGS[:2], PLANE), PLANE),
        "right",
        "along a single bearing",
    ),
    Case("unobservable_states", [[1, 0]], ON_LINE, "wrong", "along the line"),
    Case("unobservable_states", [], ON_LINE, "wrong", "more is unseen"),
    Case("unobservable_states", [[0, 1], [0, 2]], ON_LINE, "wrong", "dependent"),
    Case("unobservable_states", [[x1, x2]], AROUND, "wrong", "towards it"),
    Case("unobservable_states", [[1, 0, 0]], ON_LINE, "invalid", "too many components"),
]
LIMITS = [
    "To first order: where the Jacobian loses rank, terms of higher order may still tell the "
    "unknowns apart, as a range tells a place on the line of two stations from its neighbours.",
    "The entries of a row of the Jacobian may have one root in common, as those of a range or of "
    "a bearing, not several.",
]

import sympy as sp
from case import Case

w, c, a, p, s = sp.symbols("w c a p s", positive=True)
HEXAGON, OCTAGON, AXES = (
    sp.Matrix([[sp.sin(2 * sp.pi * i / m), sp.cos(2 * sp.pi * i / m)] for i in range(m)])
    for m in (6, 8, 4)
)
STRIPS = (HEXAGON, [w, w, c + w, w, w, w - c])
TIGHT = (HEXAGON, [w, w, 3 * w, w, w, -w], HEXAGON)
SQUARES = (sp.Matrix.vstack(AXES, AXES), [p, p, a, a, a + p, a + p, 0, 0], OCTAGON)
TRIANGLE = sp.Matrix([[-1, 0], [0, -1], [3, 4]])
r = sp.sqrt(2)

SQUARE = [(x, y) for x in (-p, p) for y in (-p, p)]
TWO_SQUARES = [(x + shift, y) for x, y in SQUARE for shift in (0, 2 * p)]
HULL = (TWO_SQUARES, AXES)
CUT = (TWO_SQUARES, AXES, sp.Matrix([[1, 1]]), [p])
MEETS = (SQUARE, AXES, AXES, [2 * s, s, -s, s])
T, phi = sp.symbols("T phi", positive=True)
LONG = (T, phi, [phi <= sp.pi, T >= phi])
NORTH = (T, sp.pi / 2, [T <= sp.pi], 0)
cosine = sp.cos(T / 2)

CASES = [
    Case("research.section_values", [p, 3 * p, p, p], HULL, "right", "by the farthest square"),
    Case("research.section_values", [p, 2 * p, p, p], HULL, "wrong", "the mean square"),
    Case("research.section_values", [p, 3 * p, p], HULL, "invalid", "three of four"),
    Case("research.section_values", ..., HULL, "missing", "the untouched stub"),
    Case("research.section_values", [p, 2 * p, p, p], CUT, "right", "cut by a diagonal"),
    Case("research.section_values", [p, 3 * p, p, p], CUT, "wrong", "the cut is forgotten"),
    Case("research.section_meets", s <= p, MEETS, "right", "touching counts"),
    Case("research.section_meets", s / p <= 1, MEETS, "right", "as a quotient"),
    Case("research.section_meets", s < p, MEETS, "wrong", "touching does not count"),
    Case("research.section_meets", s <= 2 * p, MEETS, "wrong", "too many"),
    Case("research.section_meets", s - p, MEETS, "invalid", "an expression"),
    Case("research.section_meets", ..., MEETS, "missing", "the untouched stub"),
    Case("research.greatest_distance", sp.sin(phi) + T - phi, LONG, "right", "turn, then straight"),
    Case(
        "research.greatest_distance", T - (phi - sp.sin(phi)), LONG, "right", "the cost of the turn"
    ),
    Case("research.greatest_distance", T, LONG, "wrong", "without a turn"),
    Case("research.greatest_distance", sp.sin(phi) + T - 1.01 * phi, LONG, "wrong", "nearly"),
    Case("research.greatest_distance", s, LONG, "invalid", "another symbol"),
    Case("research.greatest_distance", ..., LONG, "missing", "the untouched stub"),
    Case("research.greatest_distance", 2 - 2 * cosine, NORTH, "right", "a turn and back"),
    Case("research.greatest_distance", 1 - sp.cos(T), NORTH, "wrong", "without turning back"),
    Case("research.support_values", [0, w, 2 * w, w, 0, -w], TIGHT, "right", "exact"),
    Case("research.support_values", sp.Matrix([0, w, 2 * w, w, 0, -w]), TIGHT, "right", "a column"),
    Case("research.support_values", [w, w, 3 * w, w, w, -w], TIGHT, "wrong", "the given bounds"),
    Case("research.support_values", [0, w, 2 * w, w, 0, w], TIGHT, "wrong", "a sign"),
    Case("research.support_values", [0, w, 1.98 * w, w, 0, -w], TIGHT, "wrong", "one per cent off"),
    Case(
        "research.support_values", [p, r * p, p, p / r, 0, 0, 0, p / r], SQUARES, "right", "exact"
    ),
    Case(
        "research.support_values",
        [p, 1.41 * p, p, 0.707 * p, 0, 0, 0, 0.707 * p],
        SQUARES,
        "right",
        "three digits",
    ),
    Case(
        "research.support_values",
        [p, r * p, p, (a + p) / r, 0, 0, 0, (a + p) / r],
        SQUARES,
        "wrong",
        "the lesser values",
    ),
    Case(
        "research.support_values",
        [0, 0, 2 * s],
        (TRIANGLE, [0, 0, s], TRIANGLE),
        "wrong",
        "twice the last",
    ),
    Case(
        "research.support_values",
        [0, 0, s],
        (TRIANGLE, [0, 0, s], TRIANGLE),
        "right",
        "all sides touch",
    ),
    Case("research.support_values", [0, w, 2 * w], TIGHT, "invalid", "three of six"),
    Case("research.support_values", [0, c, 2 * c, c, 0, -c], TIGHT, "invalid", "another symbol"),
    Case("research.support_values", ..., TIGHT, "missing", "the untouched stub"),
    Case("research.common_point_exists", c <= 3 * w, STRIPS, "right", "a relation"),
    Case(
        "research.common_point_exists",
        sp.Abs(c - w) <= 2 * w,
        STRIPS,
        "right",
        "a distance, for positive numbers",
    ),
    Case(
        "research.common_point_exists",
        sp.Ge(sp.Min(2 * w, 3 * w - c), 0),
        STRIPS,
        "right",
        "a minimum",
    ),
    Case("research.common_point_exists", c < 3 * w, STRIPS, "wrong", "without the last point"),
    Case("research.common_point_exists", c <= 2 * w, STRIPS, "wrong", "too few"),
    Case("research.common_point_exists", True, STRIPS, "wrong", "always"),
    Case("research.common_point_exists", c <= 3.05 * w, STRIPS, "wrong", "somewhat too many"),
    Case(
        "research.common_point_exists",
        s >= 12,
        (
            TRIANGLE,
            [-2, sp.Rational(-3, 2), s],
        ),
        "right",
        "a triangle",
    ),
    Case(
        "research.common_point_exists",
        s >= 6,
        (
            TRIANGLE,
            [-2, sp.Rational(-3, 2), s],
        ),
        "wrong",
        "one side only",
    ),
    Case("research.common_point_exists", c - 3 * w, STRIPS, "invalid", "an expression"),
    Case("research.common_point_exists", ..., STRIPS, "missing", "the untouched stub"),
]
LIMITS = [
    "Support values are compared at six random places with positive values of the symbols; one "
    "that is right there and wrong for other signs would pass.",
    "A polygon without a corner, a point at infinity, has no support values and is refused.",
    "A distance is compared for eight durations and directions.",
    "Whether bounds have a common point is decided for positive values of their symbols.",
]

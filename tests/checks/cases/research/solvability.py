import sympy as sp
from case import Case

from workbook.systems import Linear

t, g, R, tau, delta, omega, T, M = sp.symbols("t g R tau delta omega T M", positive=True)
v0, phi0, eps, b = sp.symbols("v0 phi0 eps b", real=True)
x, y, z, vx, vy, vz, u, w, p, q = sp.symbols("x y z vx vy vz u w p q", real=True)
n1, n2, n3, k1, k2, k3 = sp.symbols("n1 n2 n3 k1 k2 k3", real=True)
PLATFORM = sp.Matrix([[0, -g, 0, 1], [1 / R, 0, 1, 0], [0, 0, 0, 0], [0, 0, 0, 0]])
SPEED = sp.Matrix([[1, 0, 0, 0]])
UNKNOWNS = [v0, phi0, eps, b]
ORBIT = sp.Matrix(
    [
        [0, 0, 0, 1, 0, 0],
        [0, 0, 0, 0, 1, 0],
        [0, 0, 0, 0, 0, 1],
        [3 * omega**2, 0, 0, 0, 2 * omega, 0],
        [0, 0, 0, -2 * omega, 0, 0],
        [0, 0, -(omega**2), 0, 0, 0],
    ]
)
SIGHT, SECOND = [n1, n2, n3], [k1, k2, k3]
BIAS = (Linear(PLATFORM, H=SPEED), UNKNOWNS, phi0, b)
WORST = (Linear(PLATFORM[:3, :3], H=SPEED[:, :3]), UNKNOWNS[:3], eps, tau, delta)
RELATIVE = [x + u * t, y + w * t]
BEARINGS = (RELATIVE, t)
TURN = (RELATIVE, t, T, [p, q])
ERROR = (*TURN, delta)
MODES = (ORBIT, SIGHT, [x, y, z, vx, vy, vz], omega, t)
AXES = (ORBIT, [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
STATIONS = (ORBIT, SIGHT, SECOND)
f = sp.sqrt(g / R)
k = sp.cos(f * tau)
X = 4 * x + 2 * vy / omega
cross = p * (y + w * t) - q * (x + u * t)
far = (x + u * t - p * (t - T)) ** 2 + (y + w * t - q * (t - T)) ** 2

CASES = [
    Case("research.bias_of_estimate", -b / g, BIAS, "right", "exact"),
    Case("research.bias_of_estimate", -1.0 * b / g, BIAS, "right", "a decimal factor"),
    Case("research.bias_of_estimate", b / g, BIAS, "wrong", "truth minus estimate"),
    Case("research.bias_of_estimate", 0, BIAS, "wrong", "no error"),
    Case(
        "research.bias_of_estimate",
        phi0 - b / g,
        BIAS,
        "invalid",
        "the estimate instead of its error",
    ),
    Case("research.bias_of_estimate", ..., BIAS, "missing", "the untouched stub"),
    Case(
        "research.worst_case_error",
        delta * (1 + sp.Abs(k)) / (R * (1 - k)),
        WORST,
        "right",
        "by the cosine",
    ),
    Case(
        "research.worst_case_error",
        delta * (1 + sp.sqrt(k**2)) / (2 * R * sp.sin(f * tau / 2) ** 2),
        WORST,
        "right",
        "by the half angle",
    ),
    Case("research.worst_case_error", delta / R, WORST, "wrong", "for late measurements only"),
    Case(
        "research.worst_case_error",
        4 * delta / (g * tau**2),
        WORST,
        "wrong",
        "for early measurements only",
    ),
    Case(
        "research.worst_case_error",
        delta * (1 + k) / (R * (1 - k)),
        WORST,
        "wrong",
        "without the absolute value",
    ),
    Case("research.worst_case_error", sp.Lt(delta, 1), WORST, "invalid", "a condition"),
    Case("research.worst_case_error", ..., WORST, "missing", "the untouched stub"),
    Case(
        "research.unobservable_by_bearings",
        [x, y, u, w],
        BEARINGS,
        "right",
        "along the line of sight",
    ),
    Case(
        "research.unobservable_by_bearings",
        (-2 * x, -2 * y, -2 * u, -2 * w),
        BEARINGS,
        "right",
        "a multiple",
    ),
    Case(
        "research.unobservable_by_bearings",
        [x / u, y / u, 1, w / u],
        BEARINGS,
        "wrong",
        "undefined for u = 0",
    ),
    Case(
        "research.unobservable_by_bearings",
        [x, y, 0, 0],
        BEARINGS,
        "wrong",
        "along the first line of sight",
    ),
    Case("research.unobservable_by_bearings", [-y, x, -w, u], BEARINGS, "wrong", "across"),
    Case(
        "research.unobservable_by_bearings",
        [x + u * t, y + w * t, u, w],
        BEARINGS,
        "invalid",
        "with the time",
    ),
    Case("research.unobservable_by_bearings", ..., BEARINGS, "missing", "the untouched stub"),
    Case("research.range_observable", sp.Ne(cross, 0), TURN, "right", "the cross product"),
    Case("research.range_observable", cross**2 > 0, TURN, "right", "its square"),
    Case("research.range_observable", sp.Or(sp.Ne(p, 0), sp.Ne(q, 0)), TURN, "wrong", "any turn"),
    Case(
        "research.range_observable",
        sp.And(sp.Ne(cross, 0), sp.Ne(p, 0)),
        TURN,
        "wrong",
        "a turn along y left out",
    ),
    Case(
        "research.range_observable",
        sp.Ne(p**2 * (y + w * t) ** 2, q**2 * (x + u * t) ** 2),
        TURN,
        "wrong",
        "squared",
    ),
    Case("research.range_observable", cross > 0, TURN, "wrong", "one sign only"),
    Case("research.range_observable", True, TURN, "wrong", "always"),
    Case("research.range_observable", cross, TURN, "invalid", "an expression"),
    Case("research.range_observable", ..., TURN, "missing", "the untouched stub"),
    Case(
        "research.range_error",
        delta * far / ((t - T) * sp.Abs(cross)),
        ERROR,
        "right",
        "by the way aside",
    ),
    Case(
        "research.range_error",
        sp.Abs(delta * sp.expand(far) / ((t - T) * cross)),
        ERROR,
        "right",
        "the absolute value of the whole",
    ),
    Case("research.range_error", delta * far / ((t - T) * cross), ERROR, "wrong", "with a sign"),
    Case(
        "research.range_error", delta * (t - T) * sp.Abs(cross) / far, ERROR, "wrong", "turned over"
    ),
    Case("research.range_error", "small", ERROR, "invalid", "a word"),
    Case("research.range_error", ..., ERROR, "missing", "the untouched stub"),
    Case(
        "research.range_modes",
        [
            n1 * X + n2 * (y - 2 * vx / omega),
            -3 * n2 * (vy + 2 * omega * x),
            n1 * (x - X) + 2 * n2 * vx / omega + n3 * z,
            (n1 * vx + n3 * vz) / omega - 2 * n2 * (x - X),
        ],
        MODES,
        "right",
        "by the mean height",
    ),
    Case(
        "research.range_modes",
        sp.Matrix(
            [
                4 * n1 * x + 2 * n1 * vy / omega + n2 * y - 2 * n2 * vx / omega,
                -3 * n2 * vy - 6 * n2 * omega * x,
                2 * n2 * vx / omega - 3 * n1 * x - 2 * n1 * vy / omega + n3 * z,
                n1 * vx / omega + 6 * n2 * x + 4 * n2 * vy / omega + n3 * vz / omega,
            ]
        ),
        MODES,
        "right",
        "multiplied out, a column",
    ),
    Case(
        "research.range_modes",
        [n1 * x + n2 * y + n3 * z, n1 * vx + n2 * vy + n3 * vz, 0, 0],
        MODES,
        "wrong",
        "a free motion",
    ),
    Case(
        "research.range_modes",
        [n1 * X, -3 * n2 * (vy + 2 * omega * x), n1 * (x - X), n1 * vx / omega],
        MODES,
        "wrong",
        "without the other coordinates",
    ),
    Case("research.range_modes", [x, y, z], MODES, "invalid", "three of four"),
    Case("research.range_modes", [x, ..., z, y], MODES, "missing", "filled in part"),
    Case("research.observability_ranks", [3, 4, 2], AXES, "right", "a list"),
    Case("research.observability_ranks", (3.0, 4.0, 2.0), AXES, "right", "whole floats"),
    Case("research.observability_ranks", [4, 4, 4], AXES, "wrong", "four modes"),
    Case("research.observability_ranks", [2, 2, 2], AXES, "wrong", "two a coordinate"),
    Case("research.observability_ranks", [3, 4, 2.5], AXES, "invalid", "not whole"),
    Case("research.observability_ranks", [3, 4], AXES, "invalid", "two of three"),
    Case("research.observability_ranks", ..., AXES, "missing", "the untouched stub"),
    Case(
        "research.stations_insufficient",
        sp.And(sp.Eq(n1 * k3, n3 * k1), sp.Eq(n2 * k3, n3 * k2)),
        STATIONS,
        "right",
        "parallel",
    ),
    Case(
        "research.stations_insufficient",
        sp.Eq((n1 / n3 - k1 / k3) ** 2 + 4 * (n2 / n3 - k2 / k3) ** 2, 0),
        STATIONS,
        "right",
        "the determinant",
    ),
    Case(
        "research.stations_insufficient",
        sp.Eq((n1 * k1 + n2 * k2 + n3 * k3) ** 2, 1),
        STATIONS,
        "right",
        "unit vectors at 0 or 180",
    ),
    Case(
        "research.stations_insufficient",
        sp.Eq(n1 * k1 + n2 * k2 + n3 * k3, 1),
        STATIONS,
        "wrong",
        "without opposite directions",
    ),
    Case(
        "research.stations_insufficient", sp.Eq(n1 * k3, n3 * k1), STATIONS, "wrong", "one equality"
    ),
    Case(
        "research.stations_insufficient",
        sp.And(sp.Eq(n1**2, k1**2), sp.Eq(n2**2, k2**2), sp.Eq(n3**2, k3**2)),
        STATIONS,
        "wrong",
        "mirrored directions",
    ),
    Case(
        "research.stations_insufficient",
        sp.Or(sp.Eq((n1 * k1 + n2 * k2 + n3 * k3) ** 2, 1), sp.Eq(n1 * k1 + n2 * k2 + n3 * k3, 0)),
        STATIONS,
        "wrong",
        "perpendicular directions",
    ),
    Case(
        "research.stations_insufficient",
        sp.Or(sp.Eq(n1 * k3, n3 * k1), sp.Eq(n2 * k3, n3 * k2)),
        STATIONS,
        "wrong",
        "either",
    ),
    Case("research.stations_insufficient", False, STATIONS, "wrong", "never"),
    Case("research.stations_insufficient", n1 * k3 - n3 * k1, STATIONS, "invalid", "an expression"),
    Case("research.stations_insufficient", ..., STATIONS, "missing", "the untouched stub"),
]
LIMITS = [
    "Motions are compared at six random places with positive values of all symbols; an "
    "expression that is right there and wrong for other signs would pass. Times reach a few "
    "units, so that a difference that shows much later is not seen.",
    "What bearings do not see is tried at twelve moments.",
    "The greatest error of three measurements is judged for tau between 0.4 and 2.8 divided by the "
    "fastest frequency.",
    "Conditions are tried at rational places in general position and on the surface where they "
    "change, nowhere else.",
]

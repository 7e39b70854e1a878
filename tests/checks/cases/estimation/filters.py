import sympy as sp
from case import Case

from workbook.systems import Coloured, Process

Q, R, p, m, z = sp.symbols("Q R p m z", positive=True)
a, k1, k2 = sp.symbols("a k1 k2", real=True)
p11, p12, p22 = sp.symbols("p11 p12 p22", real=True)
CONSTANT = Process(A=0, H=1, R=R, mean=m, covariance=p)
STEPS = Process(A=1, Q=Q, H=1, R=R, discrete=True)
CART = Process(A=[[0, 1], [0, 0]], Q=sp.diag(0, Q), H=[[1, 0]], R=R)
SCALAR = Process(A=a, Q=Q, H=1, R=R)
START = Process(A=[[0, 1], [0, 0]], H=[[1, 0]], R=1, mean=[0, 1], covariance=sp.eye(2))
#: A state that grows without noise, which a filter that ignores it leaves at covariance zero.
GROWING = Process(A=[[2, 0], [0, 0]], Q=sp.diag(0, 1), H=[[1, 1]], R=1, discrete=True)
DELAYS = Process(
    A=[[0, 1, 0], [0, 0, 1], [0, 0, 0]], Q=sp.diag(0, 0, 2), H=[[0, 0, 1]], R=3, discrete=True
)
SQRT = sp.sqrt(2)
OWN = sp.Matrix(
    [
        [SQRT * Q ** sp.Rational(1, 4) * R ** sp.Rational(3, 4), sp.sqrt(Q * R)],
        [sp.sqrt(Q * R), SQRT * Q ** sp.Rational(3, 4) * R ** sp.Rational(1, 4)],
    ]
)
BEFORE = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
P = sp.Matrix([[p11, p12], [p12, p22]])
n = sp.Symbol("n", integer=True, nonnegative=True)
S, t, y, y1, y2 = sp.symbols("S t y y1 y2", real=True)
h, Q0 = sp.Symbol("h", real=True), sp.Symbol("Q0", nonnegative=True)
#: n + 1 measurements of a constant, whose sum is S: the order in which they come does not matter.
RECORD = [(0, S), (sp.Range(1, n + 1), 0)]
#: The correlation exp(-|tau|), measured without an error at 1 and 2.
EXPONENTIAL = Process(A=-1, Q=2, H=1, covariance=1)
PAIR = [(1, y1), (2, y2)]
BETWEEN = (y1 * sp.sinh(2 - t) + y2 * sp.sinh(t - 1)) / sp.sinh(1)
ANY = Process(A=a, Q=Q0, H=h, R=R)
SEEN = sp.And(sp.Or(sp.Ne(h, 0), a < 0), sp.Or(sp.Ne(Q0, 0), sp.Ne(a, 0)))
# A drift whose covariance has the size 1e-9 and changes within a time of size one.
DRIFT = Process(A=-1, Q=sp.Rational(1, 10**9), H=1, R=sp.Rational(1, 10**9))
RATES = sp.Matrix(
    [[2 * p12 - p11**2 / R, p22 - p11 * p12 / R], [p22 - p11 * p12 / R, Q - p12**2 / R]]
)

T, D = sp.symbols("T D", positive=True)
tau = sp.Symbol("tau", nonnegative=True)
INTEGRAL = Coloured(8 * sp.exp(-tau), tau, A=0, B=1, H=1, R=1)
MADE = Coloured(sp.exp(-tau), tau, C=1, R=1)
NOISE = Coloured(sp.exp(-a * tau), tau, C=1, R=R)
BIASED = Coloured(D, tau, A=[[0, 1], [0, 0]], B=[0, 1], H=[[0, 1]], R=R)
WAY = sp.Matrix([T**2 / 2, T, 1])

CASES = [
    Case(
        "estimate",
        (m * R + z * p) / (p + R),
        (CONSTANT, [(0, z)], 2, [R, p, m, z]),
        "right",
        "a weighted mean",
    ),
    Case(
        "estimate",
        [sp.Rational(7, 3), sp.Rational(5, 3)],
        (START, [(1, 3)], 1),
        "right",
        "a speed that is not seen",
    ),
    Case(
        "estimate",
        sp.Matrix([[sp.Rational(7, 3), sp.Rational(5, 3)]]),
        (START, [(1, 3)], 1),
        "right",
        "a row",
    ),
    Case("estimate", [4, sp.Rational(5, 3)], (START, [(1, 3)], 2), "right", "a prediction"),
    Case(
        "estimate",
        (m * R + S * p) / (R + (n + 1) * p),
        (CONSTANT, RECORD, 0, [R, p, m, S, n]),
        "right",
        "any number",
    ),
    Case(
        "estimate",
        S / (n + 1),
        (CONSTANT, RECORD, 0, [R, p, m, S, n]),
        "wrong",
        "nothing known before",
    ),
    Case(
        "estimate",
        (m * R + S * p) / (R + n * p),
        (CONSTANT, RECORD, 0, [R, p, m, S, n]),
        "wrong",
        "one too few",
    ),
    Case(
        "estimate",
        BETWEEN,
        (EXPONENTIAL, PAIR, t, [t, y1, y2], (t > 1) & (t <= 2)),
        "right",
        "between two moments",
    ),
    Case(
        "estimate",
        y2 * sp.exp(2 - t),
        (EXPONENTIAL, PAIR, t, [t, y1, y2], t > 2),
        "right",
        "a formula in time",
    ),
    Case(
        "estimate",
        y1 * sp.exp(t - 1),
        (EXPONENTIAL, PAIR, t, [t, y1, y2], t <= 1),
        "right",
        "back in time",
    ),
    Case(
        "estimate",
        y1 * (2 - t) + y2 * (t - 1),
        (EXPONENTIAL, PAIR, t, [t, y1, y2], (t > 1) & (t <= 2)),
        "wrong",
        "on a straight line",
    ),
    Case(
        "estimate",
        y1 * sp.exp(1 - t),
        (EXPONENTIAL, PAIR, t, [t, y1, y2], t <= 1),
        "wrong",
        "growing into the past",
    ),
    Case("estimate", z, (CONSTANT, [(0, z)], 2, [R, p, m, z]), "wrong", "what was measured"),
    Case("estimate", (m + z) / 2, (CONSTANT, [(0, z)], 2, [R, p, m, z]), "wrong", "equal weights"),
    Case(
        "estimate",
        [sp.Rational(7, 3), 1],
        (START, [(1, 3)], 1),
        "wrong",
        "the correlation not used",
    ),
    Case("estimate", 3, (START, [(1, 3)], 1), "invalid", "one of two"),
    Case(
        "estimate_covariance",
        p * R / (p + R),
        (CONSTANT, [(0, z)], 2, [R, p, m, z]),
        "right",
        "parallel resistances",
    ),
    Case(
        "estimate_covariance",
        sp.Matrix([[2, 1], [1, 2]]) / 3,
        (START, [(1, 3)], 1),
        "right",
        "a matrix",
    ),
    Case(
        "estimate_covariance",
        R,
        (CONSTANT, [(0, z)], 2, [R, p, m, z]),
        "wrong",
        "the error of the measurement",
    ),
    Case(
        "estimate_covariance",
        sp.Matrix([[2, 1], [1, 1]]),
        (START, [(1, 3)], 1),
        "wrong",
        "before the measurement",
    ),
    Case("estimate_covariance", [1, 2], (START, [(1, 3)], 1), "invalid", "a list"),
    Case(
        "estimate_covariance",
        p * R / (R + (n + 1) * p),
        (CONSTANT.subs(m, 0), [(sp.Range(n + 1), 0)], 0, [R, p, n]),
        "right",
        "any number of measurements",
    ),
    Case(
        "estimate_covariance",
        1 - sp.exp(4 - 2 * t),
        (EXPONENTIAL, PAIR, t, [t, y1, y2], t > 2),
        "right",
        "exact ones",
    ),
    Case(
        "estimate_standard_deviations",
        sp.sqrt(p * R / (p + R)),
        (CONSTANT, [(0, z)], 2, [R, p, m, z]),
        "right",
        "a number",
    ),
    Case(
        "estimate_standard_deviations",
        [sp.sqrt(6) / 3] * 2,
        (START, [(1, 3)], 1),
        "right",
        "a column",
    ),
    Case(
        "estimate_standard_deviations",
        p * R / (p + R),
        (CONSTANT, [(0, z)], 2, [R, p, m, z]),
        "wrong",
        "the variance",
    ),
    Case(
        "estimate_standard_deviations",
        [sp.sqrt(2), 1],
        (START, [(1, 3)], 1),
        "wrong",
        "before the measurement",
    ),
    Case(
        "estimate_standard_deviations",
        [-sp.sqrt(6) / 3] * 2,
        (START, [(1, 3)], 1),
        "wrong",
        "negative roots",
    ),
    Case("estimate_standard_deviations", 1, (START, [(1, 3)], 1), "invalid", "one of two"),
    Case(
        "estimate_covariance",
        D * R / (R + D * T**2) * WAY * WAY.T,
        (BIASED, [(T, 0)], T, [T, D, R]),
        "right",
        "a noise that is constant",
    ),
    Case(
        "estimate_standard_deviations",
        sp.sqrt(D) * WAY,
        (BIASED, [], T, [T, D, R]),
        "right",
        "nothing was measured",
    ),
    Case(
        "steady_covariance",
        sp.Matrix([[2, 2], [2, 6]]),
        (INTEGRAL,),
        "right",
        "a noise with a correlation",
    ),
    Case(
        "steady_covariance",
        R * (sp.sqrt(a**2 + 2 * a / R) - a),
        (NOISE, [a, R], a > 0),
        "right",
        "the noise itself",
    ),
    Case("steady_covariance", OWN, (CART, [Q, R]), "right", "a cart"),
    Case(
        "steady_covariance",
        R * (a + sp.sqrt(a**2 + Q / R)),
        (SCALAR, [a, Q, R]),
        "right",
        "for a of both signs",
    ),
    Case("steady_covariance", BEFORE, (STEPS, [Q, R]), "right", "before a measurement"),
    Case("steady_covariance", BEFORE - Q, (STEPS, [Q, R], sp.true, "after"), "right", "after it"),
    Case(
        "steady_covariance",
        R * (a - sp.sqrt(a**2 + Q / R)),
        (SCALAR, [a, Q, R]),
        "wrong",
        "the other root",
    ),
    Case("steady_covariance", BEFORE - Q, (STEPS, [Q, R]), "wrong", "the other moment"),
    Case("steady_covariance", sp.diag(0, 1), (GROWING,), "wrong", "growth ignored, before"),
    Case(
        "steady_covariance",
        sp.diag(0, sp.Rational(1, 2)),
        (GROWING, [], sp.true, "after"),
        "wrong",
        "growth ignored, after",
    ),
    Case(
        "steady_covariance",
        sp.diag(*OWN.diagonal()),
        (CART, [Q, R]),
        "wrong",
        "the variances alone",
    ),
    Case(
        "steady_covariance",
        0,
        (Process(A=1, Q=0, H=1, R=R), [R]),
        "wrong",
        "a root with which the errors grow",
    ),
    Case("steady_covariance", [[1, 2], [3, 4]], (CART, [Q, R]), "wrong", "a matrix not symmetric"),
    Case(
        "steady_covariance",
        0,
        (Process(A=2, Q=Q, H=1, R=0, discrete=True), [Q]),
        "wrong",
        "no gain, for exact measurements",
    ),
    Case("steady_covariance", sp.true, (CART, [Q, R]), "invalid", "a truth value"),
    Case(
        "steady_gain",
        [SQRT * (Q / R) ** sp.Rational(1, 4), sp.sqrt(Q / R)],
        (CART, [Q, R]),
        "right",
        "a cart",
    ),
    Case(
        "steady_gain",
        a + sp.sqrt(a**2 + Q / R),
        (SCALAR, [a, Q, R]),
        "right",
        "a single coordinate",
    ),
    Case("steady_gain", BEFORE / (BEFORE + R), (STEPS, [Q, R]), "right", "discrete time"),
    Case("steady_gain", OWN[:, 0], (CART, [Q, R]), "wrong", "not divided by R"),
    Case(
        "steady_gain",
        [sp.sqrt(Q / R), SQRT * (Q / R) ** sp.Rational(1, 4)],
        (CART, [Q, R]),
        "wrong",
        "interchanged",
    ),
    Case("steady_gain", 2, (CART, [Q, R]), "invalid", "one of two"),
    Case("steady_gain", [2, 2], (INTEGRAL,), "right", "a noise with a correlation"),
    Case(
        "steady_filter_exists",
        SEEN,
        (ANY, [a, h, Q0]),
        "right",
        "nothing hidden, nothing forgotten",
    ),
    Case(
        "steady_filter_exists",
        sp.Ne(a, 0),
        (Process(A=[[0, 1], [-a, -1]], Q=sp.diag(0, 1), H=[[0, 1]], R=1), [a]),
        "right",
        "an integrator that is not seen",
    ),
    Case(
        "steady_filter_exists",
        abs(a) < 1,
        (Process(A=a, Q=1, H=0 * sp.eye(1), R=1, discrete=True), [a]),
        "right",
        "a sequence that is not seen",
    ),
    Case(
        "steady_filter_exists",
        sp.Ne(abs(a), 1),
        (Process(A=a, H=1, R=1, discrete=True), [a]),
        "right",
        "a sequence without noise",
    ),
    Case(
        "steady_filter_exists",
        sp.Ne(h, 0),
        (ANY, [a, h, Q0]),
        "wrong",
        "observability is more than is needed",
    ),
    Case(
        "steady_filter_exists",
        sp.Or(sp.Ne(h, 0), a < 0),
        (ANY, [a, h, Q0]),
        "wrong",
        "a constant without noise",
    ),
    Case(
        "steady_filter_exists",
        SEEN & sp.Ne(a, sp.sqrt(2)),
        (ANY, [a, h, Q0]),
        "wrong",
        "one irrational value left out",
    ),
    Case("steady_filter_exists", 3, (ANY, [a, h, Q0]), "invalid", "a number"),
    Case(
        "filter_equation",
        a * y + p * (z - y) / R,
        (SCALAR, [y], [z], sp.Matrix([[p]]), [a, Q, R]),
        "right",
        "one",
    ),
    Case(
        "filter_equation",
        [y2 + p11 * (z - y1) / R, p12 * (z - y1) / R],
        (CART, [y1, y2], [z], P, [Q, R]),
        "right",
        "two",
    ),
    Case(
        "filter_equation",
        a * y + p * (y - z) / R,
        (SCALAR, [y], [z], sp.Matrix([[p]]), [a, Q, R]),
        "wrong",
        "a sign",
    ),
    Case(
        "filter_equation",
        [y2 + p11 * (z - y1) / R, p22 * (z - y1) / R],
        (CART, [y1, y2], [z], P, [Q, R]),
        "wrong",
        "the wrong column",
    ),
    Case("filter_equation", [y2, 0], (CART, [y1, y2], [z], P, [Q, R]), "wrong", "nothing measured"),
    Case("filter_equation", a * y, (CART, [y1, y2], [z], P, [Q, R]), "invalid", "one of two"),
    Case("riccati_equation", RATES, (CART, P, [Q, R]), "right", "a cart"),
    Case("riccati_equation", RATES.tolist(), (CART, P, [Q, R]), "right", "lists"),
    Case(
        "riccati_equation",
        RATES - 2 * sp.diag(0, Q),
        (CART, P, [Q, R]),
        "wrong",
        "the sign of the noise",
    ),
    Case(
        "riccati_equation",
        RATES.subs(R, -R),
        (CART, P, [Q, R]),
        "wrong",
        "the sign of the measurement",
    ),
    Case("riccati_equation", RATES + P, (CART, P, [Q, R]), "wrong", "one more linear term"),
    *(
        Case("riccati_equation", rate, (DRIFT, sp.Matrix([[p11]])), verdict, f"small units, {term}")
        for rate, verdict, term in [
            (-2 * p11 + DRIFT.Q[0] - p11**2 / DRIFT.R[0], "right", "all terms"),
            (-2 * p11 - p11**2 / DRIFT.R[0], "wrong", "the noise forgotten"),
            (-p11 + DRIFT.Q[0] - p11**2 / DRIFT.R[0], "wrong", "half of a linear term"),
        ]
    ),
    Case("riccati_equation", [1, 2, 3], (CART, P, [Q, R]), "invalid", "three entries"),
    Case(
        "riccati_equation",
        (p11 * R / (p11 + R)) + Q,
        (STEPS, sp.Matrix([[p11]]), [Q, R]),
        "right",
        "discrete time",
    ),
    Case(
        "riccati_equation",
        p11 * R / (p11 + R),
        (STEPS, sp.Matrix([[p11]]), [Q, R]),
        "wrong",
        "the noise forgotten",
    ),
    Case(
        "riccati_equation",
        2 * p11 + Q - p11**2 / R,
        (STEPS, sp.Matrix([[p11]]), [Q, R]),
        "wrong",
        "the equation of continuous time",
    ),
    Case("error_eigenvalues", [-sp.sqrt(a**2 + Q / R)], (SCALAR, [a, Q, R]), "right", "a rate"),
    Case("error_eigenvalues", [R / (BEFORE + R)], (STEPS, [Q, R]), "right", "a factor"),
    Case(
        "error_eigenvalues",
        {
            (Q / R) ** sp.Rational(1, 4) * (-1 + sp.I) / SQRT,
            (Q / R) ** sp.Rational(1, 4) * (-1 - sp.I) / SQRT,
        },
        (CART, [Q, R]),
        "right",
        "a pair",
    ),
    Case("error_eigenvalues", [0], (DELAYS,), "right", "the same one three times"),
    Case("error_eigenvalues", [0, 0], (DELAYS,), "right", "told as often as one likes"),
    Case("error_eigenvalues", [a], (SCALAR, [a, Q, R]), "wrong", "that of the process itself"),
    Case(
        "error_eigenvalues",
        [(Q / R) ** sp.Rational(1, 4) * (-1 + sp.I) / SQRT],
        (CART, [Q, R]),
        "wrong",
        "one of a pair",
    ),
    Case("error_eigenvalues", [], (DELAYS,), "wrong", "none"),
    Case("error_eigenvalues", 3, (DELAYS, [Q, R]), "wrong", "a number"),
    Case("error_eigenvalues", sp.true, (DELAYS, [Q, R]), "invalid", "a truth value"),
]
LIMITS = [
    "The errors of measurements and the noise are independent of each other; for the filters R is "
    "not singular."
]

import sympy as sp
from case import Case

from workbook.systems import Coloured, FilterErrors, Process

t = sp.Symbol("t", nonnegative=True)
k = sp.Symbol("k", integer=True, nonnegative=True)
a, q, m, P, r, s = sp.symbols("a q m P r s", positive=True)
DECAY = Process(A=-a, Q=q, mean=m, covariance=P)
WIENER = Process(A=0, Q=q, mean=m, covariance=P)
STEPS = Process(A=a, Q=q, mean=m, covariance=P, discrete=True)
CARTS = Process(A=[[0, 1], [0, 0]], Q=sp.diag(0, q), mean=[m, 1])
STIFF = Process(A=[[0, 1], [-6, -5]], Q=sp.diag(0, 1))
FALL = (STIFF.A * t).exp()
LINE = q * sp.Matrix([[t**3 / 3, t**2 / 2], [t**2 / 2, t]])
u, v = sp.symbols("u v", real=True)
SWING = Process(A=[[0, 1], [-v, -u]], Q=sp.diag(0, q))
ECHO = Process(A=[[0, 1], [-v, u]], Q=sp.diag(0, q), discrete=True)
DELAY = Process(A=[[0, u], [0, 0]], Q=sp.diag(0, q), discrete=True)
HALF = sp.Rational(1, 2)

tau = sp.Symbol("tau", nonnegative=True)
D, R = sp.symbols("D R", positive=True)
BIASED = Coloured(D, tau, A=[[0, 1], [0, 0]], B=[0, 1], H=[[0, 1]], R=R)
WAY = sp.Matrix([t**2 / 2, t, 1])
LAGGED = Coloured(D * sp.exp(-tau), tau, A=-1, B=1, H=1, R=1)
BOTH = sp.Matrix([[1, 0, 0], [0, 1, 0]])
# Measured, with the errors of filters that have the gain v, or u and v.
MADE = Coloured(sp.exp(-tau), tau, C=1, R=1)
CART = Process(A=[[0, 1], [0, 0]], Q=sp.diag(0, q), H=[[1, 0]], R=1)
MEASURED = Process(A=u, Q=q, H=1, R=1)
WALK = Process(A=1, Q=1, H=1, R=1, discrete=True)

CASES = [
    Case("mean_at_time", m * sp.exp(-a * t), (DECAY, t, [a, q, m, P]), "right", "decay"),
    Case("mean_at_time", [m + t, 1], (CARTS, t, [q, m]), "right", "a column"),
    Case("mean_at_time", m * a**k, (STEPS, k, [a, q, m, P]), "right", "powers"),
    Case("mean_at_time", m * sp.exp(a * t), (DECAY, t, [a, q, m, P]), "wrong", "growth"),
    Case("mean_at_time", [m, 1], (CARTS, t, [q, m]), "wrong", "the motion forgotten"),
    Case("mean_at_time", m, (CARTS, t, [q, m]), "invalid", "one of two"),
    Case(
        "covariance_at_time",
        P * sp.exp(-2 * a * t) + q * (1 - sp.exp(-2 * a * t)) / (2 * a),
        (DECAY, t, [a, q, m, P]),
        "right",
        "towards a limit",
    ),
    Case("covariance_at_time", P + q * t, (WIENER, t, [q, m, P]), "right", "in proportion to time"),
    Case("covariance_at_time", LINE, (CARTS, t, [q, m]), "right", "a matrix"),
    Case(
        "covariance_at_time",
        P * a ** (2 * k) + q * (1 - a ** (2 * k)) / (1 - a**2),
        (STEPS, k, [a, q, m, P]),
        "right",
        "a sum of powers",
    ),
    Case(
        "covariance_at_time",
        sp.diag(1, 6) / 60 - FALL * sp.diag(1, 6) / 60 * FALL.T,
        (STIFF, t),
        "right",
        "what decays fast is not lost in rounding",
    ),
    Case(
        "covariance_at_time",
        0.2 - 0.2 * sp.exp(-2.5 * t),
        (Process(A=-sp.Rational(5, 4), Q=HALF), t),
        "right",
        "decimals that cancel at the start",
    ),
    Case("covariance_at_time", D * WAY * WAY.T, (BIASED, t, [D, R]), "right", "a constant noise"),
    Case(
        "covariance_at_time",
        P + 2 * q,
        (WIENER, t, [q, m, P]),
        "right",
        "at one time",
        (("times", [2]),),
    ),
    Case(
        "covariance_at_time",
        P + q * sp.Piecewise((2, q > 1), (3, True)),
        (WIENER, t, [q, m, P]),
        "wrong",
        "at one time, for some parameters alone",
        (("times", [2]),),
    ),
    Case("covariance_at_time", q * t, (WIENER, t, [q, m, P]), "wrong", "the start forgotten"),
    Case(
        "covariance_at_time",
        P * sp.exp(-a * t) + q * (1 - sp.exp(-a * t)) / a,
        (DECAY, t, [a, q, m, P]),
        "wrong",
        "at the rate of the mean",
    ),
    Case(
        "covariance_at_time",
        LINE.subs(q, q**2),
        (CARTS, t, [q, m]),
        "wrong",
        "the intensity squared",
    ),
    Case(
        "covariance_at_time",
        sp.diag(*LINE.diagonal()),
        (CARTS, t, [q, m]),
        "wrong",
        "the variances alone",
    ),
    Case("covariance_at_time", [1, 2, 3], (CARTS, t, [q, m]), "invalid", "a list"),
    Case(
        "correlation_at_time",
        sp.sqrt(3) / 2,
        (CARTS, t, sp.eye(2), [q, m]),
        "right",
        "of place and speed",
    ),
    Case("correlation_at_time", 1, (BIASED, t, BOTH, [D, R]), "right", "complete"),
    Case(
        "correlation_at_time",
        sp.Rational(3, 4),
        (CARTS, t, sp.eye(2), [q, m]),
        "wrong",
        "its square",
    ),
    Case(
        "correlation_at_time",
        q * t**2 / 2,
        (CARTS, t, sp.eye(2), [q, m]),
        "wrong",
        "the covariance",
    ),
    Case("correlation_at_time", [1, 2], (CARTS, t, sp.eye(2), [q, m]), "invalid", "a list"),
    Case(
        "shaping_filter", [-1, 16, 8], (Coloured(8 * sp.exp(-tau), tau, C=1),), "right", "numbers"
    ),
    Case("shaping_filter", [0, 0, D], (BIASED, [D]), "right", "a constant"),
    Case(
        "shaping_filter",
        [-a, 2 * a * q, q],
        (Coloured(q * sp.exp(-a * tau), tau, C=1), [a, q]),
        "right",
        "symbols",
    ),
    Case("shaping_filter", [1, 16, 8], (Coloured(8 * sp.exp(-tau), tau, C=1),), "wrong", "growth"),
    Case(
        "shaping_filter",
        [-1, 8, 8],
        (Coloured(8 * sp.exp(-tau), tau, C=1),),
        "wrong",
        "the variance as intensity",
    ),
    Case("shaping_filter", [0, D, D], (BIASED, [D]), "wrong", "a constant that is driven"),
    Case("shaping_filter", [1, 2], (BIASED, [D]), "invalid", "two of three"),
    Case(
        "stationary_covariance",
        sp.Matrix([[D / 2, D / 2], [D / 2, D]]),
        (LAGGED, [D]),
        "right",
        "a noise with a correlation",
    ),
    Case(
        "stationary_covariance_exists",
        u < 0,
        (Coloured(sp.exp(-tau), tau, A=u, B=1, H=1, R=1), [u]),
        "right",
        "a noise with a correlation",
    ),
    Case("stationary_covariance", q / (2 * a), (DECAY, [a, q]), "right", "a number"),
    Case("stationary_covariance", q / (1 - a**2), (STEPS, [a, q]), "right", "where it exists"),
    Case(
        "stationary_covariance",
        q / (1 - a**2),
        (STEPS, [a, q], a < 1),
        "right",
        "with a condition that says where",
    ),
    Case(
        "stationary_covariance",
        sp.Matrix([[HALF, 0], [0, HALF]]),
        (Process(A=[[0, 1], [-1, -1]], Q=sp.diag(0, 1)),),
        "right",
        "a damped oscillator",
    ),
    Case("stationary_covariance", q / a, (DECAY, [a, q]), "wrong", "a factor of two"),
    Case(
        "stationary_covariance",
        q / (1 - a),
        (STEPS, [a, q], a < 1),
        "wrong",
        "the rate of the mean",
    ),
    Case("covariance_exponents", [-2 * a], (DECAY, [a, q]), "right", "twice the rate of the mean"),
    Case(
        "covariance_exponents",
        {-u, -u + sp.sqrt(u**2 - 4 * v), -u - sp.sqrt(u**2 - 4 * v)},
        (SWING, [u, v, q]),
        "right",
        "sums, also complex ones",
    ),
    Case("covariance_exponents", [a**2], (STEPS, [a]), "right", "in discrete time a factor"),
    Case("covariance_exponents", [0], (DELAY, [u]), "right", "the same one three times"),
    Case("covariance_exponents", [-a], (DECAY, [a, q]), "wrong", "that of the mean"),
    Case(
        "covariance_exponents",
        [-u + sp.sqrt(u**2 - 4 * v), -u - sp.sqrt(u**2 - 4 * v)],
        (SWING, [u, v, q]),
        "wrong",
        "one left out",
    ),
    Case(
        "covariance_exponents",
        [-2 * a, 0],
        (DECAY, [a, q]),
        "wrong",
        "what the noise makes it keep",
    ),
    Case("covariance_exponents", True, (DECAY, [a, q]), "invalid", "a truth value"),
    Case(
        "state_after_steps", a**2 * m + a * u + v, (STEPS, [m], [u, v], [a]), "right", "two steps"
    ),
    Case(
        "state_after_steps",
        [u**2 * m, v],
        (DELAY, [q, P], [(0, m), (0, v)], [u]),
        "wrong",
        "the delay forgotten",
    ),
    Case(
        "state_after_steps", [u * m, v], (DELAY, [q, P], [(0, m), (0, v)], [u]), "right", "a column"
    ),
    Case(
        "state_after_steps",
        a**2 * m + a * v + u,
        (STEPS, [m], [u, v], [a]),
        "wrong",
        "the noises interchanged",
    ),
    Case("state_after_steps", u + v, (STEPS, [m], [u, v], [a]), "wrong", "without the factors"),
    Case("state_after_steps", [u, v], (STEPS, [m], [u, v], [a]), "invalid", "two components"),
    Case(
        "stationary_covariance_exists",
        u > 0,
        (Process(A=-u, Q=1), [u]),
        "right",
        "a rate that decays",
    ),
    Case(
        "stationary_covariance_exists",
        sp.And(u > 0, v > 0),
        (SWING, [u, v]),
        "right",
        "two parameters",
    ),
    Case(
        "stationary_covariance_exists",
        abs(u) < 1,
        (Process(A=u, Q=1, discrete=True), [u]),
        "right",
        "a factor",
    ),
    Case(
        "stationary_covariance_exists",
        sp.And(v < 1, u < 1 + v, -u < 1 + v),
        (ECHO, [u, v]),
        "right",
        "a triangle",
    ),
    Case("stationary_covariance_exists", True, (DELAY, [u]), "right", "always"),
    Case(
        "stationary_covariance_exists",
        False,
        (Process(A=[[u, 0], [0, -1]], discrete=True), [u]),
        "right",
        "never",
    ),
    Case(
        "stationary_covariance_exists",
        u < 1,
        (Process(A=u, Q=1, discrete=True), [u], u > 0),
        "right",
        "what is given",
    ),
    Case("stationary_covariance_exists", u >= 0, (Process(A=-u, Q=1), [u]), "wrong", "the border"),
    Case(
        "stationary_covariance_exists",
        sp.And(u > 0, v >= 0),
        (SWING, [u, v]),
        "wrong",
        "one side of the border",
    ),
    Case(
        "stationary_covariance_exists",
        u < 1,
        (Process(A=u, Q=1, discrete=True), [u]),
        "wrong",
        "one sign",
    ),
    Case(
        "stationary_covariance_exists",
        sp.And(u >= -1, u < 1),
        (Process(A=u, Q=1, discrete=True), [u]),
        "wrong",
        "where the order drops",
    ),
    Case("stationary_covariance_exists", abs(u) < 1, (DELAY, [u]), "wrong", "as if it came back"),
    Case(
        "stationary_covariance_exists",
        q,
        (Process(A=u, Q=1, discrete=True), [u]),
        "invalid",
        "an expression",
    ),
    Case(
        "stationary_covariance_exists",
        v > -1,
        (FilterErrors(MADE, [[v]]), [v]),
        "right",
        "a single gain",
    ),
    Case(
        "stationary_covariance_exists",
        sp.And(u > 0, v > 0),
        (FilterErrors(CART, [u, v]), [u, v]),
        "right",
        "two gains",
    ),
    Case(
        "stationary_covariance_exists",
        v > 0,
        (FilterErrors(MADE, [[v]]), [v]),
        "wrong",
        "the decay of the process forgotten",
    ),
    Case(
        "stationary_covariance_exists",
        sp.And(u > 0, v > 0, u > v),
        (FilterErrors(CART, [u, v]), [u, v]),
        "wrong",
        "too narrow",
    ),
    Case(
        "stationary_covariance_exists",
        abs(v - 1) < 1,
        (FilterErrors(WALK, [[v]]), [v]),
        "right",
        "the gain of predictions",
    ),
    Case(
        "stationary_covariance",
        (q + v**2) / (2 * (v - u)),
        (FilterErrors(MEASURED, [[v]]), [u, v, q]),
        "right",
        "where the errors decay",
    ),
    Case(
        "stationary_covariance",
        (v**2 + 2) / (2 * (v + 1)),
        (FilterErrors(MADE, [[v]]), [v]),
        "right",
        "a noise with a correlation, measured",
    ),
    Case(
        "stationary_covariance",
        (q + v**2) / v / 2,
        (FilterErrors(MEASURED.subs(u, 0), [[v]]), [v, q]),
        "right",
        "an integrator",
    ),
    Case(
        "stationary_covariance",
        (1 + v**2) / (v * (2 - v)),
        (FilterErrors(WALK, [[v]]), [v]),
        "right",
        "of predictions",
    ),
    Case(
        "stationary_covariance",
        q / (2 * (v - u)),
        (FilterErrors(MEASURED, [[v]]), [u, v, q]),
        "wrong",
        "the noise of the measurement forgotten",
    ),
    Case(
        "stationary_covariance",
        (q + v) / (2 * (v - u)),
        (FilterErrors(MEASURED, [[v]]), [u, v, q]),
        "wrong",
        "the gain not squared",
    ),
    Case(
        "stationary_covariance",
        [1, 2],
        (FilterErrors(MEASURED, [[v]]), [u, v, q]),
        "invalid",
        "a list",
    ),
    Case("stationary_covariance", "q/2", (DECAY, [a, q]), "invalid", "a word"),
    Case("covariance_increases", P < q / (2 * a), (DECAY, [a, q, P]), "right", "below the limit"),
    Case(
        "covariance_increases",
        sp.Or(a >= 1, P * (1 - a**2) < q),
        (STEPS, [a, q, P]),
        "right",
        "in steps",
    ),
    Case(
        "covariance_increases",
        (1 - r) ** 2 < q * s,
        (Process([[0, 1], [-1, 0]], sp.diag(s, q), covariance=sp.diag(1, r)), [q, r, s]),
        "right",
        "every combination of two",
    ),
    Case(
        "covariance_increases",
        sp.true,
        (DECAY, [a, q, P]),
        "wrong",
        "noise is added, but something decays too",
    ),
    Case(
        "covariance_increases",
        P <= q / (2 * a),
        (DECAY, [a, q, P]),
        "wrong",
        "at the limit it rests",
    ),
    Case(
        "covariance_increases",
        sp.true,
        (Process([[0, 1], [-1, 0]], sp.diag(s, q), covariance=sp.diag(1, r)), [q, r, s]),
        "wrong",
        "both variances, but not those between",
    ),
    Case("covariance_increases", q - a, (DECAY, [a, q, P]), "invalid", "an expression"),
]
LIMITS = [
    "A process that does not settle has no `stationary_covariance`; whether it does is asked by "
    "`stationary_covariance_exists`."
]

import sympy as sp
from case import Case

x1, x2, x, a, p = sp.symbols("x1 x2 x a p", real=True)
K = sp.Matrix([[2, 1], [1, 5]])
PAIR = ([x1, x2], K)
COIN = ([x], {0: sp.Rational(1, 2), 2: sp.Rational(1, 2)})
TURN = (
    x1 * sp.cos(a) + x2 * sp.sin(a),
    -x1 * sp.sin(a) + x2 * sp.cos(a),
    [x1, x2],
    sp.diag(1, 3),
    a,
)
FORMS = [x1 + x2, x1 - x2]
OF_A = (x1 + a * x2, x1 - x2, [x1, x2], K, [a])

CASES = [
    Case("expectations", [1, 2], ([x, x**2], *COIN), "right", "a mean and that of the square"),
    Case("expectations", (p, 2 * p), ([p * x, p * x**2], *COIN, [p]), "right", "with a parameter"),
    Case("expectations", [1, 1], ([x, x**2], *COIN), "wrong", "the square of the mean"),
    Case("expectations", [2, 4], ([x, x**2], *COIN), "wrong", "without the probability"),
    Case("expectations", 2, ([x, x**2], *COIN), "invalid", "one of two"),
    Case(
        "covariance", 7, (x1 + x2, 2 * x1 + 0 * x2 + x2 / 5, *PAIR), "wrong", "the variances alone"
    ),
    Case("covariance", sp.Rational(36, 5), (x1 + x2, 2 * x1 + x2 / 5, *PAIR), "right", "two forms"),
    Case("covariance", 7.2, (x1 + x2, 2 * x1 + x2 / 5, *PAIR), "right", "decimals"),
    Case("covariance", 2, (x, x**2, *COIN), "right", "a quantity and its square"),
    Case("covariance", 4, (x, x**2, *COIN), "wrong", "the mean of the product"),
    Case("covariance", 1 - 4 * a, OF_A, "right", "with a parameter"),
    Case("covariance", 2, (x1, x2, *PAIR), "wrong", "a variance"),
    Case("covariance", sp.Matrix([[1, 2], [3, 4]]), (x1, x2, *PAIR), "invalid", "a matrix"),
    Case("correlation", 1 / sp.sqrt(10), (x1, x2, *PAIR), "right", "two coordinates"),
    Case("correlation", 0.316, (x1, x2, *PAIR), "right", "decimals"),
    Case("correlation", 1, (x, 3 * x, *COIN), "right", "in proportion"),
    Case("correlation", sp.Rational(1, 10), (x1, x2, *PAIR), "wrong", "without the root"),
    Case("correlation", -1 / sp.sqrt(10), (x1, x2, *PAIR), "wrong", "the sign"),
    Case("correlation", sp.true, (x1, x2, *PAIR), "invalid", "a truth value"),
    Case("covariance", sp.Matrix([[9, -3], [-3, 5]]), (FORMS, FORMS, *PAIR), "right", "two forms"),
    Case("covariance", [[9, -3], [-3, 5]], (FORMS, FORMS, *PAIR), "right", "lists"),
    Case(
        "covariance", sp.Matrix([[9, -3], [3, 5]]), (FORMS, FORMS, *PAIR), "wrong", "not symmetric"
    ),
    Case(
        "covariance",
        sp.Matrix([[7, -3], [-3, 7]]),
        (FORMS, FORMS, *PAIR),
        "wrong",
        "the covariances left out",
    ),
    Case("covariance", [9, -3], ([x1 + x2], FORMS, *PAIR), "invalid", "a column"),
    Case("covariance", [[9, -3]], ([x1 + x2], FORMS, *PAIR), "right", "of one with two"),
    Case("covariance", [9, -3], (FORMS, FORMS, *PAIR), "invalid", "a row"),
    Case("uncorrelated", [0, sp.pi / 2], TURN, "right", "along the axes"),
    Case("uncorrelated", {1.57, 0}, TURN, "right", "a set, decimals"),
    Case("uncorrelated", [0], TURN, "wrong", "one of two"),
    Case("uncorrelated", [0, sp.pi / 2, sp.pi], TURN, "wrong", "half a turn as well"),
    Case("uncorrelated", [sp.pi / 4, 3 * sp.pi / 4], TURN, "wrong", "between the axes"),
    Case("uncorrelated", "never", TURN, "invalid", "a word"),
]
LIMITS = [
    "A covariance matrix determines linear quantities only; for others the law gives all values."
]

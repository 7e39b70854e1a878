import sympy as sp
from case import Case

a, b, q = sp.symbols("a b q", real=True)
LINE = ([(a, 1), (a + b, 2), (a + 2 * b, 6)], [a, b])
WEIGHED = ([(a, 1), (a, 4)], [a], [1, 2])
OF_Q = ([(a, 1), (a, q)], [a], None, [q])
n, r = sp.symbols("n r", positive=True)
MANY = ([(a, q), (a, 0, n)], [a], [r, r], [q, n, r])

CASES = [
    Case(
        "least_squares",
        [sp.Rational(1, 2), sp.Rational(5, 2)],
        LINE,
        "right",
        "a line through three points",
    ),
    Case("least_squares", [0.5, 2.5], LINE, "right", "decimals"),
    Case("least_squares", [(1 + q) / 2], OF_Q, "right", "the mean"),
    Case(
        "least_squares",
        [0.333 * q - 0.667],
        ([(a, 2 - q), (a, q), (a, q - 4)], [a], None, [q]),
        "right",
        "decimals with a parameter, which may cancel",
    ),
    Case("least_squares", [sp.Rational(8, 5)], WEIGHED, "right", "weights"),
    Case("least_squares", [q / (n + 1)], MANY, "right", "any number of measurements"),
    Case("least_squares", q / (n + 1), MANY, "right", "a single unknown without brackets"),
    Case("least_squares", [q / n], MANY, "wrong", "one not counted"),
    Case("least_squares", [sp.Rational(5, 2)], WEIGHED, "wrong", "the weights forgotten"),
    Case(
        "least_squares", [2], WEIGHED, "wrong", "weights by the deviations instead of their squares"
    ),
    Case("least_squares", [1, 1], LINE, "wrong", "through the first two points"),
    Case("least_squares", [sp.Rational(5, 2), sp.Rational(1, 2)], LINE, "wrong", "interchanged"),
    Case("least_squares", [3], LINE, "invalid", "one of two"),
    Case("least_sum_of_squares", sp.Rational(3, 2), LINE, "right", "what is left"),
    Case("least_sum_of_squares", sp.Rational(9, 5), WEIGHED, "right", "with weights"),
    Case("least_sum_of_squares", 0, LINE, "wrong", "nothing"),
    Case("least_sum_of_squares", sp.sqrt(sp.Rational(3, 2)), LINE, "wrong", "the root of the sum"),
    Case("least_sum_of_squares", [[1, 2], [3, 4]], LINE, "invalid", "a matrix"),
    Case("error_covariance", sp.Matrix([[5, -3], [-3, 3]]) / 6, LINE, "right", "a line"),
    Case("error_covariance", [[sp.Rational(4, 5)]], WEIGHED, "right", "weights"),
    Case(
        "error_covariance", sp.Rational(4, 5), WEIGHED, "right", "a single unknown without brackets"
    ),
    Case("error_covariance", r**2 / (n + 1), MANY, "right", "any number of measurements"),
    Case("error_covariance", sp.Matrix([[3, 3], [3, 5]]), LINE, "wrong", "its inverse"),
    Case("error_covariance", sp.Matrix([[5, 0], [0, 3]]) / 6, LINE, "wrong", "the variances alone"),
    Case("error_covariance", [1, 2], LINE, "invalid", "a list"),
]
LIMITS = ["The quantities are linear in the unknowns, and the measurements determine these."]

import sympy as sp
from case import Case

t, g, R, tau, delta, omega, T, M = sp.symbols("t g R tau delta omega T M", positive=True)
BOUND = (sp.Matrix([[1, 0], [0, sp.Rational(1, 100)], [0, 0]]), [1, 0], 5)
ROWS = (6, 10**9, sp.Rational(22, 10**17))

CASES = [
    Case("research.bound_violating_error", [0, 5, 0], BOUND, "right", "just enough"),
    Case("research.bound_violating_error", [1, -200, 3], BOUND, "right", "much more"),
    Case("research.bound_violating_error", [0, 4, 0], BOUND, "wrong", "four times only"),
    Case("research.bound_violating_error", [0, 0, 9], BOUND, "wrong", "not seen by the estimate"),
    Case("research.bound_violating_error", [0, 0, 0], BOUND, "wrong", "no error"),
    Case("research.bound_violating_error", [0, 5], BOUND, "invalid", "two of three"),
    Case("research.bound_violating_error", ..., BOUND, "missing", "the untouched stub"),
    Case("research.greatest_row_count", 51539, ROWS, "right", "an int"),
    Case("research.greatest_row_count", 51539.0, ROWS, "right", "a whole float"),
    Case("research.greatest_row_count", 51540, ROWS, "wrong", "rounded up"),
    Case("research.greatest_row_count", 51538, ROWS, "wrong", "one less"),
    Case("research.greatest_row_count", 3, ROWS, "wrong", "fewer than the unknowns"),
    Case("research.greatest_row_count", 51539.2, ROWS, "invalid", "not whole"),
    Case("research.greatest_row_count", ..., ROWS, "missing", "the untouched stub"),
    Case(
        "research.nearly_dependent_condition_number",
        (1 + sp.sqrt(1 + delta**2)) / delta,
        (delta,),
        "right",
        "a root",
    ),
    Case(
        "research.nearly_dependent_condition_number",
        sp.cot(sp.atan(delta) / 2),
        (delta,),
        "right",
        "by the angle",
    ),
    Case(
        "research.nearly_dependent_condition_number", 2 / delta, (delta,), "wrong", "leading term"
    ),
    Case(
        "research.nearly_dependent_condition_number",
        (1 + sp.sqrt(1 + delta**2)) ** 2 / delta**2,
        (delta,),
        "wrong",
        "squared",
    ),
    Case("research.nearly_dependent_condition_number", M, (delta,), "invalid", "another symbol"),
    Case(
        "research.nearly_dependent_condition_number", ..., (delta,), "missing", "the untouched stub"
    ),
    Case("research.dependence_hiding_error", 2 * M / (M**2 - 1), (M,), "right", "a fraction"),
    Case(
        "research.dependence_hiding_error",
        1 / (M - 1) + 1 / (M + 1),
        (M,),
        "right",
        "partial fractions",
    ),
    Case("research.dependence_hiding_error", 2 / M, (M,), "wrong", "leading term"),
    Case("research.dependence_hiding_error", -2 * M / (M**2 - 1), (M,), "wrong", "negative"),
    Case("research.dependence_hiding_error", [M], (M,), "invalid", "a list"),
    Case("research.dependence_hiding_error", ..., (M,), "missing", "the untouched stub"),
]
LIMITS = [
    "An error that breaks the printed bound may be any that does so; it is measured by least "
    "squares."
]

import sympy as sp
from case import Case

from workbook.systems import Linear

t, a = sp.symbols("t", real=True), sp.symbols("alpha", real=True)
y, u = sp.Function("y")(t), sp.Function("u")(t)
M = sp.Matrix
# Delta = lambda^2 - a lambda + 2, xi1 = x1/3; for y = x1 + x2 the right-hand side is 3u' + 3u.
PLANT = (M([[0, 1], [-2, a]]), M([0, 3]))
DRIVEN = Linear(*PLANT)
FORM = (DRIVEN, y, u, [a])
SUM = (Linear(*PLANT, M([[1, 1]])), y, u, [a])
# Delta = lambda^3 - 2 lambda - 2, in the form (2.4) already.
CHAIN = (Linear(M([[0, 1, 0], [0, 0, 1], [2, 2, 0]]), M([0, 0, 1])),)
LEFT = y.diff(t, 2) - a * y.diff(t) + 2 * y
Y, U, s, b = (
    sp.Function("y")(sp.Symbol("t")),
    sp.Function("u")(sp.Symbol("t")),
    sp.Symbol("t"),
    sp.Symbol("alpha"),
)

CASES = [
    Case("scalar_equation", sp.Eq(LEFT, u), FORM, "right", "all of y on the left"),
    Case(
        "scalar_equation",
        sp.Eq(y.diff(t, 2), a * y.diff(t) - 2 * y + u),
        FORM,
        "right",
        "solved for y''",
    ),
    Case(
        "scalar_equation",
        sp.Eq(0, (a**2 + 1) * (u - LEFT) / 7),
        FORM,
        "right",
        "a factor with the parameter that vanishes nowhere",
    ),
    Case(
        "scalar_equation",
        sp.Eq(0, (a + 1) * (u - LEFT)),
        FORM,
        "wrong",
        "a factor that vanishes at alpha = -1",
    ),
    Case(
        "scalar_equation",
        sp.Eq(LEFT / (a**2 - 2), u / (a**2 - 2)),
        FORM,
        "wrong",
        "divided by what vanishes at irrational values",
    ),
    Case("scalar_equation", LEFT - u, FORM, "right", "an expression that is to be zero"),
    Case(
        "scalar_equation",
        sp.Eq(Y.diff(s, 2) + 2 * Y, b * Y.diff(s) + U),
        FORM,
        "right",
        "plain symbols",
    ),
    Case(
        "scalar_equation",
        sp.Eq(sp.Derivative(y.diff(t) - a * y, t), u - 2 * y),
        FORM,
        "right",
        "a derivative not carried out",
    ),
    Case(
        "scalar_equation",
        sp.Eq(sp.Derivative(y, t, t) - 1.0 * a * y.diff(t) + 2.001 * y, u),
        FORM,
        "right",
        "decimals",
    ),
    Case(
        "scalar_equation",
        sp.Eq(y.diff(t, 3), 2 * y.diff(t) + 2 * y + u),
        (*CHAIN, y, u),
        "right",
        "of third order",
    ),
    Case("scalar_equation", sp.Eq(LEFT, 3 * u), FORM, "wrong", "the equation of 3 y"),
    Case(
        "scalar_equation", sp.Eq(LEFT, u.diff(t) + u), FORM, "wrong", "that of another combination"
    ),
    Case("scalar_equation", sp.Eq(LEFT, 0), FORM, "wrong", "without control"),
    Case("scalar_equation", sp.Eq(LEFT, -u), FORM, "wrong", "a sign of the control"),
    Case(
        "scalar_equation", sp.Eq(y.diff(t, 2) + a * y.diff(t) + 2 * y, u), FORM, "wrong", "a sign"
    ),
    Case(
        "scalar_equation",
        sp.Eq(y.diff(t, 2) - 2 * a * y.diff(t) + y, u),
        FORM,
        "wrong",
        "the coefficients",
    ),
    Case(
        "scalar_equation",
        sp.Eq(y.diff(t, 2) - 1.02 * a * y.diff(t) + 2 * y, u),
        FORM,
        "wrong",
        "two decimals of a coefficient",
    ),
    Case(
        "scalar_equation",
        sp.Eq(LEFT.diff(t), u.diff(t)),
        FORM,
        "wrong",
        "differentiated: of third order",
    ),
    Case("scalar_equation", sp.Eq(y.diff(t), u), FORM, "wrong", "of first order"),
    Case(
        "scalar_equation",
        sp.Eq(y.diff(t, 2) - a * y.diff(t) + 2.02 * y, u),
        FORM,
        "wrong",
        "one per cent off",
    ),
    Case(
        "scalar_equation",
        sp.Eq(0.333 * y.diff(t, 2) - 0.333 * a * y.diff(t) + 0.667 * y, 0.333 * u),
        FORM,
        "right",
        "a third of it, to three digits",
    ),
    Case("scalar_equation", sp.Eq(LEFT, u + 1), FORM, "wrong", "a constant too many"),
    Case("scalar_equation", sp.Eq(y * LEFT, y * u), FORM, "wrong", "not linear"),
    Case("scalar_equation", sp.Eq(t * LEFT, t * u), FORM, "wrong", "a factor that depends on time"),
    Case(
        "scalar_equation",
        sp.Eq(sp.Derivative(y**50, (t, 12), evaluate=False), u),
        FORM,
        "wrong",
        "the derivative of a power",
    ),
    Case(
        "scalar_equation",
        sp.Eq(sp.Derivative(t * y, (t, 2), evaluate=False), u),
        FORM,
        "wrong",
        "the derivative of t y",
    ),
    Case("scalar_equation", sp.Eq(u, u.diff(t)), FORM, "wrong", "no y"),
    Case("scalar_equation", sp.Eq(LEFT, LEFT, evaluate=False), FORM, "wrong", "an identity"),
    Case("scalar_equation", ..., FORM, "missing", "the untouched stub"),
    Case("scalar_equation", LEFT == u, FORM, "invalid", "compared by Python"),
    Case("scalar_equation", sp.Ne(LEFT, u), FORM, "invalid", "an inequality"),
    Case(
        "scalar_equation", sp.Eq(LEFT, sp.Symbol("u")), FORM, "invalid", "the control as a symbol"
    ),
    Case("scalar_equation", sp.Eq(LEFT, sp.Function("w")(t)), FORM, "invalid", "another function"),
    Case("scalar_equation", sp.Eq(LEFT, u.subs(t, t + 1)), FORM, "invalid", "another time"),
    Case("scalar_equation", sp.Eq(y.diff(t, 2), sp.oo), FORM, "invalid", "infinity"),
    Case("scalar_equation", sp.Eq(y.diff(t, 50), u), FORM, "invalid", "of order 50"),
    Case("scalar_equation", sp.Eq(M([y]), M([u])), FORM, "invalid", "matrices"),
    Case("scalar_equation", [1, -a, 2], FORM, "invalid", "the coefficients alone"),
    Case("scalar_equation", "y'' + 2y = u", FORM, "invalid", "text"),
    Case(
        "scalar_equation",
        sp.Eq(LEFT, 3 * u.diff(t) + 3 * u),
        SUM,
        "right",
        "with a derivative of the control",
    ),
    Case("scalar_equation", sp.Eq(LEFT / 3 - u, u.diff(t)), SUM, "right", "another arrangement"),
    Case(
        "scalar_equation",
        sp.Eq(LEFT, 3 * u),
        (Linear(*PLANT, M([[1, 0]])), y, u, [a]),
        "right",
        "free of derivatives",
    ),
    Case(
        "scalar_equation", sp.Eq(LEFT, u), SUM, "wrong", "the equation of the canonical coordinate"
    ),
    Case("scalar_equation", sp.Eq(LEFT, 3 * u.diff(t)), SUM, "wrong", "a term forgotten"),
    Case(
        "scalar_equation",
        sp.Eq(LEFT, 3 * u.diff(t) + 3 * u + u.diff(t, 2)),
        SUM,
        "wrong",
        "a derivative too many",
    ),
    Case(
        "scalar_equation",
        sp.Eq(LEFT + y, 3 * u.diff(t) + 3 * u),
        SUM,
        "wrong",
        "a wrong polynomial",
    ),
    Case("scalar_equation", sp.Eq(1, 2), SUM, "invalid", "false as it stands"),
    Case("canonical_coordinate", [sp.Rational(1, 3), 0], (DRIVEN, [a]), "right", "a list"),
    Case("canonical_coordinate", M([[1, 0]]) / 3, (DRIVEN, [a]), "right", "a row"),
    Case("canonical_coordinate", M([0.333, 0]), (DRIVEN, [a]), "right", "a column of decimals"),
    Case("canonical_coordinate", [1, 0, 0], CHAIN, "right", "the form itself"),
    Case("canonical_coordinate", [1, 0], (DRIVEN, [a]), "wrong", "three times as large"),
    Case(
        "canonical_coordinate",
        [0, sp.Rational(1, 3)],
        (DRIVEN, [a]),
        "wrong",
        "the last coordinate",
    ),
    Case(
        "canonical_coordinate",
        [0.35, 0.0],
        (DRIVEN, [a]),
        "wrong",
        "decimals that are not near enough",
    ),
    Case("canonical_coordinate", [0, 0], (DRIVEN, [a]), "wrong", "zero"),
    Case("canonical_coordinate", [0, 1, 0], CHAIN, "wrong", "the second coordinate"),
    Case("canonical_coordinate", [1], CHAIN, "invalid", "too short"),
    Case("canonical_coordinate", ..., CHAIN, "missing", "the untouched stub"),
]
LIMITS = [
    "A factor of the equation has to be constant in time; with parameters it is judged at six "
    "rational values in general position.",
    "The control is a function of time; a plain symbol u is refused, since its derivative would be "
    "zero.",
]

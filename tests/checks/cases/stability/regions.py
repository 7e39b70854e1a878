import sympy as sp
from case import REFUSED, Case

k1, k2, s = sp.symbols("k1 k2 s", real=True)
p, q = sp.symbols("k1 k2")
CUBIC = (s**3 + k1 * s**2 + k2 * s + 1, [k1, k2])
FALLING = (k1 * s**2 + s + 1, [k1])
MATRIX = (sp.Matrix([[k1, 1], [k2, 1]]), [k1, k2])
NEVER = (sp.Matrix([[1, k1], [k2, 1]]), [k1, k2])
t, z = sp.symbols("t", real=True), sp.Function("z")(sp.Symbol("t", real=True))
SECOND = (z.diff(t, 2) + z.diff(t) + z + k1 * z.diff(t, 2), [k1])

TRUE = sp.And(k1 > 0, k1 * k2 > 1)
ROOTS = (s**2 + s + 2 - k1**2, [k1])

CASES = [
    Case("stability_region", sp.And(k1 > 0, k1 * k2 > 1), CUBIC, "right", "the minors"),
    Case(
        "stability_region",
        [p > 0, q > 1 / p],
        CUBIC,
        "right",
        "a list, plain symbols, solved for k2",
    ),
    Case("stability_region", sp.Not(sp.Or(k1 <= 0, k1 * k2 <= 1)), CUBIC, "right", "a negation"),
    Case(
        "stability_region",
        sp.And(k1 > 0, sp.sqrt(k1) * sp.sqrt(k2) > 1),
        CUBIC,
        "right",
        "roots of parameters",
    ),
    Case(
        "stability_region",
        sp.And(k1 > 0, sp.log(k1 * k2) > 0),
        CUBIC,
        "right",
        "a logarithm in the place of a product",
    ),
    Case(
        "stability_region",
        sp.ConditionSet((p, q), sp.And(p > 0, p * q > 1), sp.S.Reals**2),
        CUBIC,
        "right",
        "a set of points",
    ),
    Case(
        "stability_region",
        sp.And(k1 > 0, k1 * k2 > 1, sp.Gt(sp.Float("1e-400"), 0, evaluate=False)),
        CUBIC,
        "right",
        "with a decimal below all floats",
    ),
    Case(
        "stability_region",
        sp.And(k1 > 0, k1 * k2 > 1, sp.Float("1e400") * k1 > 0),
        CUBIC,
        "right",
        "with a decimal above all floats",
    ),
    Case(
        "stability_region",
        sp.And(k1 > sp.Rational(1, 10**400), k1 * k2 > 1),
        CUBIC,
        "wrong",
        "a strip less, thinner than all floats",
    ),
    Case("stability_region", sp.And(k1 > 0, k2 > 0), CUBIC, "wrong", "necessary only"),
    Case(
        "stability_region",
        k1 * k2 > 1,
        CUBIC,
        "wrong",
        "the second branch of the hyperbola taken along",
    ),
    Case(
        "stability_region", sp.And(k1 > 0, k1 * k2 >= 1), CUBIC, "wrong", "the boundary counted in"
    ),
    Case(
        "stability_region",
        sp.And(k1 > 0, k1 * k2 > sp.Rational(1001, 1000)),
        CUBIC,
        "wrong",
        "off by a thousandth",
    ),
    Case(
        "stability_region",
        sp.And(k1 > 0, k1 * k2 > 1, sp.Ne(k1, 2)),
        CUBIC,
        "wrong",
        "one line left out",
    ),
    Case("stability_region", True, CUBIC, "wrong", "everywhere"),
    Case("stability_region", False, CUBIC, "wrong", "nowhere"),
    Case("stability_region", k1 > 0, FALLING, "right", "the order drops at 0: left out"),
    Case("stability_region", k1 >= 0, FALLING, "right", "the order drops at 0: counted in"),
    Case(
        "stability_region",
        sp.Interval.open(0, sp.oo),
        FALLING,
        "right",
        "an interval of the only parameter",
    ),
    Case(
        "stability_region",
        sp.And(k1 < -3, k2 < 2 * k1 + 2),
        MATRIX,
        "right",
        "margin 1, open region",
        (("degree", 1),),
    ),
    Case(
        "stability_region",
        sp.And(k1 < -3, k2 < 2 * k1 + 2),
        MATRIX,
        REFUSED,
        "the former name of the degree",
        (("margin", 1),),
    ),
    Case(
        "stability_region",
        sp.And(k1 <= -3, k2 <= 2 * k1 + 2),
        MATRIX,
        "right",
        "margin 1, closed region",
        (("degree", 1),),
    ),
    Case(
        "stability_region",
        sp.And(k1 < -1, k2 < k1),
        MATRIX,
        "wrong",
        "the margin forgotten",
        (("degree", 1),),
    ),
    Case("stability_region", False, NEVER, "right", "the empty set: the trace is fixed"),
    Case("stability_region", sp.S.EmptySet, NEVER, "right", "the empty set as a set"),
    Case("stability_region", ..., CUBIC, "missing", "the untouched stub"),
    Case("stability_region", [k1 > 0, ...], CUBIC, "missing", "half of it"),
    Case("stability_region", k1, CUBIC, "invalid", "an expression"),
    Case("stability_region", "k1 > 0", CUBIC, "invalid", "text"),
    Case(
        "stability_region",
        sp.Symbol("q") > 0,
        CUBIC,
        "invalid",
        "a symbol that the problem does not have",
    ),
    Case(
        "stability_region",
        sp.And(k1 > 0, k1 * k2 > 1, k1**3 + k2**3 < 10**12),
        CUBIC,
        "wrong",
        "cut off far out",
    ),
    Case(
        "stability_region",
        sp.Or(TRUE, (k1 + 3) ** 2 + (k2 + 3) ** 2 < sp.Rational(1, 10**6)),
        CUBIC,
        "wrong",
        "a small disc more",
    ),
    Case(
        "stability_region",
        sp.Or(
            TRUE, sp.And(k1 > -1000 - sp.Rational(1, 1000), k1 < -1000, k2 > 5, 1000 * k2 < 5001)
        ),
        CUBIC,
        "wrong",
        "a sliver more, far out",
    ),
    Case(
        "stability_region",
        sp.And(TRUE, sp.Ne(k1**2 + k2**2, 5)),
        CUBIC,
        "wrong",
        "one circle left out",
    ),
    Case(
        "stability_region",
        sp.And(TRUE, sp.Ne(k1, sp.sqrt(2))),
        CUBIC,
        "wrong",
        "an irrational line left out",
    ),
    Case(
        "stability_region",
        sp.And(TRUE, sp.Or(sp.Ne(k1, 2), sp.Ne(k2, 2))),
        CUBIC,
        "wrong",
        "one point left out",
    ),
    Case(
        "stability_region",
        sp.Or(TRUE, sp.And(sp.Eq(k1, -sp.sqrt(2)), sp.Eq(k2, -sp.sqrt(3)))),
        CUBIC,
        "wrong",
        "one irrational point more",
    ),
    Case(
        "stability_region",
        sp.And(k1 > 0, k1 * k2 > 1.004),
        CUBIC,
        "right",
        "a border in decimals, three digits",
    ),
    Case(
        "stability_region",
        sp.And(k1 > 0, k1 * k2 > 1.009),
        CUBIC,
        "wrong",
        "a border in decimals, off by 0.9 %",
    ),
    Case(
        "stability_region",
        sp.And(k1 > 0, k1 * k2 >= 1.0),
        CUBIC,
        "wrong",
        "the boundary counted in, as a decimal",
    ),
    Case(
        "stability_region",
        sp.And(k1**2 < 2.0, k1 > -1.41),
        ROOTS,
        "right",
        "an irrational border in decimals",
    ),
    Case(
        "stability_region",
        sp.And(k1**2 < 2.0, k1 > -1.43),
        ROOTS,
        "right",
        "what is cut off besides is empty",
    ),
    Case(
        "stability_region", sp.Interval.open(-1.42, 1.42), ROOTS, "wrong", "three digits are asked"
    ),
    Case(
        "stability_region",
        sp.Or(sp.And(k1 < -3, k2 < 2 * k1 + 2), sp.Eq(k1, k2)),
        MATRIX,
        "wrong",
        "margin 1, a line more",
        (("degree", 1),),
    ),
    Case(
        "stability_region",
        sp.And(k1 < -3, k2 < 2 * k1 + 2, sp.Ne(k2, 3 * k1)),
        MATRIX,
        "wrong",
        "margin 1, a line less",
        (("degree", 1),),
    ),
    Case(
        "stability_region",
        sp.And(k1 <= -3, k2 < 2 * k1 + 2),
        MATRIX,
        "right",
        "margin 1, half of the border",
        (("degree", 1),),
    ),
    Case(
        "stability_region",
        sp.Eq(k1, k2),
        NEVER,
        "wrong",
        "margin 1, an equation instead of the empty set",
        (("degree", 1),),
    ),
    Case("stability_region", k1 > -1, SECOND, "right", "the order drops at -1: left out"),
    Case(
        "stability_region",
        sp.Interval(-1, sp.oo),
        SECOND,
        "right",
        "the order drops at -1: counted in",
    ),
    Case("stability_region", k1 > 0, SECOND, "wrong", "the own coefficient forgotten"),
    Case("stability_region", sp.Ne(k1, -1), SECOND, "wrong", "only the order looked at"),
    Case("stability_region", -1, SECOND, "invalid", "the border alone"),
]
LIMITS = [
    "What is not polynomial (a logarithm), or too large to be decided, is compared at points; the "
    "verdict says so.",
]

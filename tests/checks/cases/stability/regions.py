import sympy as sp
from case import Case

k1, k2, s = sp.symbols("k1 k2 s", real=True)
p, q = sp.symbols("k1 k2")
CUBIC = (s**3 + k1 * s**2 + k2 * s + 1, [k1, k2])
FALLING = (k1 * s**2 + s + 1, [k1])
MATRIX = (sp.Matrix([[k1, 1], [k2, 1]]), [k1, k2])
NEVER = (sp.Matrix([[1, k1], [k2, 1]]), [k1, k2])
LINE = (s**2 - k1 * s + 1, [k1])
t, z = sp.symbols("t", real=True), sp.Function("z")(sp.Symbol("t", real=True))
SECOND = (z.diff(t, 2) + z.diff(t) + z + k1 * z.diff(t, 2), z, [k1])

CASES = [
    Case("stability_region", sp.And(k1 > 0, k1 * k2 > 1), CUBIC, "right", "the minors"),
    Case("stability_region", [p > 0, q > 1 / p], CUBIC, "right", "a list, plain symbols, solved for k2"),
    Case("stability_region", sp.Not(sp.Or(k1 <= 0, k1 * k2 <= 1)), CUBIC, "right", "a negation"),
    Case("stability_region", sp.And(k1 > 0, sp.sqrt(k1) * sp.sqrt(k2) > 1), CUBIC, "right", "roots of parameters"),
    Case("stability_region", sp.And(k1 > 0, sp.log(k1 * k2) > 0), CUBIC, "right",
         "a logarithm in the place of a product"),
    Case("stability_region", sp.ConditionSet((p, q), sp.And(p > 0, p * q > 1), sp.S.Reals**2), CUBIC, "right",
         "a set of points"),
    Case("stability_region", sp.And(k1 > 0, k2 > 0), CUBIC, "wrong", "necessary only"),
    Case("stability_region", k1 * k2 > 1, CUBIC, "wrong", "the second branch of the hyperbola taken along"),
    Case("stability_region", sp.And(k1 > 0, k1 * k2 >= 1), CUBIC, "wrong", "the boundary counted in"),
    Case("stability_region", sp.And(k1 > 0, k1 * k2 > sp.Rational(1001, 1000)), CUBIC, "wrong", "off by a thousandth"),
    Case("stability_region", sp.And(k1 > 0, k1 * k2 > 1, sp.Ne(k1, 2)), CUBIC, "wrong", "one line left out"),
    Case("stability_region", True, CUBIC, "wrong", "everywhere"),
    Case("stability_region", False, CUBIC, "wrong", "nowhere"),
    Case("stability_region", k1 > 0, FALLING, "right", "the order drops at 0: left out"),
    Case("stability_region", k1 >= 0, FALLING, "right", "the order drops at 0: counted in"),
    Case("stability_region", sp.Interval.open(0, sp.oo), FALLING, "right", "an interval of the only parameter"),
    Case("stability_region", sp.And(k1 < -3, k2 < 2 * k1 + 2), MATRIX, "right", "margin 1, open region",
         (("margin", 1),)),
    Case("stability_region", sp.And(k1 <= -3, k2 <= 2 * k1 + 2), MATRIX, "right", "margin 1, closed region",
         (("margin", 1),)),
    Case("stability_region", sp.And(k1 < -1, k2 < k1), MATRIX, "wrong", "the margin forgotten", (("margin", 1),)),
    Case("stability_region", False, NEVER, "right", "the empty set: the trace is fixed"),
    Case("stability_region", sp.S.EmptySet, NEVER, "right", "the empty set as a set"),
    Case("stability_region", ..., CUBIC, "missing", "the untouched stub"),
    Case("stability_region", [k1 > 0, ...], CUBIC, "missing", "half of it"),
    Case("stability_region", k1, CUBIC, "invalid", "an expression"),
    Case("stability_region", "k1 > 0", CUBIC, "invalid", "text"),
    Case("stability_region", sp.Symbol("q") > 0, CUBIC, "invalid", "a symbol that the problem does not have"),
    Case("stable_equation", k1 > -1, SECOND, "right", "the order drops at -1: left out"),
    Case("stable_equation", sp.Interval(-1, sp.oo), SECOND, "right", "the order drops at -1: counted in"),
    Case("stable_equation", k1 > 0, SECOND, "wrong", "the own coefficient forgotten"),
    Case("stable_equation", sp.Ne(k1, -1), SECOND, "wrong", "only the order looked at"),
    Case("stable_equation", -1, SECOND, "invalid", "the border alone"),
    Case("instability_region", k1 > 0, LINE, "right", "the sum of the roots is positive"),
    Case("instability_region", sp.Interval.open(0, sp.oo), LINE, "right", "as a set"),
    Case("instability_region", k1 >= 0, LINE, "wrong", "imaginary roots are not in the right half-plane"),
    Case("instability_region", k1 < 0, LINE, "wrong", "the stable ones"),
    Case("instability_region", 3, LINE, "invalid", "a number"),
]
LIMITS = [
    "Regions are compared on 40 lines through the plane of parameters (exactly on each line): a difference that none "
    "of "
    "these lines meets, such as a single point, passes.",
    "Where a condition is not a rational function of the parameters, 60 more points a line take the place of exact "
    "cells.",
]

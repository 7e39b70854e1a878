"""Twenty rows for students, on systems of no problem: what counts as right (book/guides/checks.md)."""

import sympy as sp
from case import Case

from workbook.systems import Linear

p, q, s, x, y = sp.symbols("p q s x y", real=True)
POINTS = (sp.Matrix([y, (6 * x - 43) * (x + 1)]), [x, y])
REGION = (s**2 + (p - 2) * s + q, [p, q])
INTEGRAL = ([y, -4 * x], [x, y], [])
BASIS = (Linear(A=sp.zeros(2, 2), H=sp.Matrix([[2, 1]])),)


def _rows(check, data, *rows):
    return [Case(check, answer, data, verdict, note) for answer, verdict, note in rows]


#: What is asked -> answers to it.
QUESTIONS = {
    "All equilibria of x' = y, y' = (6*x - 43)*(x + 1)": _rows(
        "equilibria",
        POINTS,
        ([[-1, 0], [sp.Rational(43, 6), 0]], "right", "exact, in any order"),
        ([[-1, 0], [7.17, 0]], "right", "three digits of 43/6 = 7.1666..."),
        ([[-1, 0], [7.167, 0]], "right", "more digits"),
        ([[-1, 0], [7.2, 0]], "wrong", "two digits"),
        ([{x: -1, y: 0}, {x: 7.17, y: 0}], "right", "dicts, as solve gives them"),
        ([[7.17, 0]], "wrong", "one of two"),
    ),
    "For which p, q is x'' + (p - 2)*x' + q*x = 0 asymptotically stable?": _rows(
        "stability_region",
        REGION,
        (sp.And(p > 2, q > 0), "right", "a condition"),
        ([q > 0, p - 2 > 0], "right", "a list of conditions, all of which hold"),
        (sp.Not(sp.Or(p <= 2, q <= 0)), "right", "a negation"),
        (sp.And(p > 2, p * q > 0), "right", "another condition for the same set"),
        (sp.And(p >= 2, q > 0), "wrong", "a boundary that does not belong to the set"),
        (p > 2, "wrong", "a necessary condition alone"),
        (p - 2, "invalid", "an expression instead of a condition"),
    ),
    "A first integral of x' = y, y' = -4*x": _rows(
        "first_integral",
        INTEGRAL,
        (2 * x**2 + y**2 / 2, "right", "the energy"),
        (4 * x**2 + y**2 + 7, "right", "any function of it"),
        (x**2 + y**2, "wrong", "not constant along the motions"),
        (..., "missing", "the stub as it was"),
    ),
    "Basis of the unobservable states for x' = 0, z = 2*x1 + x2": _rows(
        "unobservable_states",
        BASIS,
        ([[1, -2]], "right", "a list of one vector"),
        ([[-3, 6]], "right", "any multiple"),
        ([[2, 1]], "wrong", "an observable state"),
    ),
}
CASES = [case for cases in QUESTIONS.values() for case in cases]
LIMITS = ()

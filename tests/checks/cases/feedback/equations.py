import sympy as sp
from case import Case

from workbook.systems import Scalar

mu, k1 = sp.symbols("mu", positive=True), sp.Symbol("k1", real=True)
s, M = sp.Symbol("s", real=True), sp.Matrix
# (s + 2) is uncontrollable; (s + 3) is hidden; nothing is lost; (s - 1) is uncontrollable
UNDRIVEN, UNSHOWN = (
    Scalar((s + 2) * (s - 1) * s, s + 2, s + 3, s),
    Scalar((s + 3) * (s - 1) * s, 1, s + 3, s),
)
FREE, LOST = Scalar(s**2 + s - 2, s + 1, 5, s), Scalar(s**2 + s - 2, s - 1, 5, s)
# (s - 2)(s + 1) x = (s + 1) u, z = x; and (s - 1)(s + 3) x = (2 s + 1) u, z = 4 x; and x'' = u, z =
# x' - x
COMMON, SEVERAL = Scalar(s**2 - s - 2, s + 1, 1, s), Scalar(s**2 + 2 * s - 3, 2 * s + 1, 4, s)
RATE, TOP, LOW = Scalar(s**2, 1, s - 1, s), M([[1, 0]]), M([[0, 1]])
# x'' - x = u' + u, z = x: the root -1 is uncontrollable; x'' - x = u: every margin
CANCELS, WHOLE = Scalar(s**2 - 1, s + 1, 1, s), Scalar(s**2 - 1, 1, 1, s)
FORM = [M([[0, 1], [1, 0]]), M([1, 1]), M([[1, 0]]), M([[1, 0]])]
PLAIN = [M([[0, 1], [1, 0]]), M([0, 1]), M([[1, 0]]), M([[1, 0]])]
# x'' = u' - u, z = x: both roots can be moved
BLOCK = Scalar(s**2, s - 1, 1, s)

CASES = [
    Case(
        "state_space_form",
        [M([[0, 1], [2, 1]]), M([1, 2]), TOP, TOP],
        (COMMON,),
        "right",
        "x' - u as a variable",
    ),
    Case(
        "state_space_form",
        [M([[1, 1], [2, 0]]), [1, 1], [1, 0], [1, 0]],
        (COMMON,),
        "right",
        "canonical by observation",
    ),
    Case(
        "state_space_form",
        [M([[0, 1], [3, -2]]), M([2, -3]), TOP, 4 * TOP],
        (SEVERAL,),
        "right",
        "the other equation",
    ),
    Case(
        "state_space_form",
        [M([[0, 1], [3, -2]]), [0, 1], [[1, 2]], [[4, 8]]],
        (SEVERAL,),
        "right",
        "canonical by control: here both sides have no common root",
    ),
    Case(
        "state_space_form",
        [M([[0, 0], [1, 0]]), [0.5, 0], [0, 2.0], [2.0, -2.0]],
        (RATE,),
        "right",
        "decimals, exchanged",
    ),
    Case(
        "state_space_form",
        [M([[0, 1], [2, 1]]), M([0, 1]), M([[1, 1]]), M([[1, 1]])],
        (COMMON,),
        "wrong",
        "the right transfer function, but x does not tell the state",
    ),
    Case(
        "state_space_form",
        [M([[2]]), [1], [1], [1]],
        (COMMON,),
        "wrong",
        "the common factor cancelled",
    ),
    Case(
        "state_space_form",
        [M([[0, 1], [2, 1]]), M([0, 1]), TOP, TOP],
        (COMMON,),
        "wrong",
        "without the derivative",
    ),
    Case(
        "state_space_form",
        [M([[0, 1], [-2, -1]]), M([1, 2]), TOP, TOP],
        (COMMON,),
        "wrong",
        "signs",
    ),
    Case(
        "state_space_form",
        [M([[0, 1], [2, 1]]), M([1, 2.02]), TOP, TOP],
        (COMMON,),
        "wrong",
        "one per cent off, in decimals",
    ),
    Case(
        "state_space_form",
        [M([[0, 1], [0, 0]]), [0, 1], TOP, M([[1, -1]])],
        (RATE,),
        "wrong",
        "another output",
    ),
    Case(
        "state_space_form",
        [M([[0, 1], [0, 0]]), [0, sp.I], M([[-sp.I, 0]]), M([[sp.I, -sp.I]])],
        (RATE,),
        "wrong",
        "not real",
    ),
    Case(
        "state_space_form",
        [M([[0, 1], [0, 0]]), [0, sp.oo], TOP, M([[-1, 1]])],
        (RATE,),
        "wrong",
        "infinite",
    ),
    Case(
        "state_space_form", [M([[0, 1], [0, 0]]), [0, 1], TOP], (RATE,), "invalid", "three matrices"
    ),
    Case(
        "state_space_form",
        [M([[0, 1, 0], [0, 0, 1]]), [0, 1], TOP, LOW],
        (RATE,),
        "invalid",
        "not square",
    ),
    Case(
        "state_space_form",
        [M([[0, 1], [0, 0]]), [0, 1, 0], TOP, LOW],
        (RATE,),
        "invalid",
        "a column of three",
    ),
    Case(
        "equation_gains",
        [*FORM, [-2, 0], [2, 2]],
        (CANCELS,),
        "right",
        "the root that stays, and another there",
    ),
    Case(
        "equation_gains", [*FORM, M([[-3, -3]]), M([5, 7])], (CANCELS,), "right", "faster beside it"
    ),
    Case(
        "equation_gains",
        [M([[0, 1], [1, 0]]), [1, 1], [1, 0], [1, 0], [0, -2.0], [2.0, 2.0]],
        (CANCELS,),
        "right",
        "decimals",
    ),
    Case(
        "equation_gains",
        [*PLAIN, [-2, -1], [1, 2]],
        (WHOLE,),
        "right",
        "every margin: what stabilises will do",
    ),
    Case(
        "equation_gains",
        [M([[0, 1], [0, 0]]), [1, -1], [1, 0], [1, 0], [1, 2], [1, 1]],
        (BLOCK,),
        "right",
        "two roots at zero",
    ),
    Case(
        "equation_gains", [*FORM, [-1, 0], [2, 2]], (CANCELS,), "wrong", "the loop not stabilised"
    ),
    Case(
        "equation_gains",
        [*FORM, [-2, 0], [1, 2]],
        (CANCELS,),
        "wrong",
        "errors too slow for the greatest margin",
    ),
    Case("equation_gains", [*FORM, [2, 0], [-2, -2]], (CANCELS,), "wrong", "signs"),
    Case(
        "equation_gains", [*PLAIN, [-2, 0], [2, 2]], (CANCELS,), "wrong", "no form of the equation"
    ),
    Case("equation_gains", [*PLAIN, [-2, 0], [1, 2]], (WHOLE,), "wrong", "an oscillation"),
    Case("equation_gains", [*FORM], (CANCELS,), "invalid", "no gains"),
    Case("equation_gains", [*FORM, [-2, 0, 1], [2, 2]], (CANCELS,), "invalid", "three numbers"),
    Case("possible_degrees", mu <= 2, (UNDRIVEN, mu), "right", "uncontrollable"),
    Case("possible_degrees", mu - 3 <= 0, (UNSHOWN, mu), "right", "hidden"),
    Case("possible_degrees", sp.true, (FREE, mu), "right", "nothing is lost"),
    Case("possible_degrees", sp.false, (LOST, mu), "right", "a growing mode is lost"),
    Case("possible_degrees", sp.true, (UNDRIVEN, mu), "wrong", "cancelled"),
    Case("possible_degrees", mu < 2, (UNDRIVEN, mu), "wrong", "the greatest left out"),
    Case("possible_degrees", mu <= 1, (LOST, mu), "wrong", "the other sign"),
    Case("possible_degrees", 2, (UNDRIVEN, mu), "invalid", "a number"),
    Case(
        "gain_region",
        (k1 < sp.Rational(2, 5)) & (k1 < 0),
        (Scalar(s**2, s + 1, 1, s), k1, [k1]),
        "right",
        "a double integrator with a zero",
    ),
    Case(
        "gain_region",
        k1 < sp.Rational(1, 5),
        (FREE, k1, [k1]),
        "wrong",
        "the sum of the roots alone",
    ),
    Case("gain_region", k1 < -sp.Rational(2, 5), (FREE, k1, [k1]), "right", "both coefficients"),
    Case("gain_region", k1 > sp.Rational(2, 5), (FREE, k1, [k1]), "wrong", "u = -kz"),
    Case("gain_region", "all", (FREE, k1, [k1]), "invalid", "a word"),
]

LIMITS = [
    "Entries of state forms and gains are numbers: those with parameters are refused.",
    "A form of a higher order with the motions of the equation, and others that x does not show, "
    "is refused.",
]

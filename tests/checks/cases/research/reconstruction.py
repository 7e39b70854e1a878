import math

import sympy as sp
from case import Case

lam, w, phi, kappa = sp.symbols("lam w phi kappa", real=True)
h0, h1, h2 = sp.symbols("h0 h1 h2", real=True)
tau, rho, M, Delta, D, omega, a = sp.symbols("tau rho M Delta D omega a", positive=True)
A = sp.Matrix(
    [
        [1 - kappa / 6, 1, sp.Rational(1, 2), -sp.Rational(1, 6)],
        [-kappa / 2, 1, 1, -sp.Rational(1, 2)],
        [-kappa, 0, 1, -1],
        [kappa, 0, 0, 1],
    ]
)
P = (lam - 1) ** 4 + kappa / 6 * lam * (lam**2 + 4 * lam + 1)
POLYNOMIAL = (A, lam, kappa)
REDUCED = (A, w / 2 + sp.sqrt(w**2 / 4 - 1), kappa)
CIRCLE = (A, sp.exp(sp.I * phi), kappa)
MULTIPLE = (A, kappa)
DIGITS = (A, kappa, sp.Rational(1, 4))
TIMES, SAMPLES, DIP = [0, tau, 2 * tau], [h0, h1, h2], [0, -Delta / 2, 0]
UNEVEN = [0, tau, 3 * tau]  # intervals tau and 2 tau
THREE = (TIMES, SAMPLES, rho, M)
THROUGH = (TIMES, DIP)
BOUNDED = (TIMES, DIP, rho, D)
second = h0 - 2 * h1 + h2
s = -3 * M * second / (2 * (rho * tau**3 + 9 * M))
FILTER = (omega, rho, M)
HARMONIC = (a, omega, rho, D)
WEIGHTS = (rho, M)
plain = sp.Symbol

CASES = [
    Case(
        "research.transition_polynomial",
        sp.PurePoly(P, lam),
        POLYNOMIAL,
        "right",
        "as `charpoly` returns it",
    ),
    Case(
        "research.transition_polynomial",
        sp.Poly(2 * P, lam),
        POLYNOMIAL,
        "wrong",
        "a polynomial object with a factor",
    ),
    Case("research.transition_polynomial", P, POLYNOMIAL, "right", "by powers of lambda - 1"),
    Case("research.transition_polynomial", sp.expand(P), POLYNOMIAL, "right", "multiplied out"),
    Case(
        "research.transition_polynomial",
        P.subs({lam: plain("lam"), kappa: plain("kappa")}),
        POLYNOMIAL,
        "right",
        "plain symbols",
    ),
    Case("research.transition_polynomial", 2 * P, POLYNOMIAL, "wrong", "a factor"),
    Case(
        "research.transition_polynomial",
        (lam - 1) ** 4,
        POLYNOMIAL,
        "wrong",
        "without measurements",
    ),
    Case(
        "research.transition_polynomial",
        P.subs(kappa, 1),
        POLYNOMIAL,
        "wrong",
        "for one kappa only",
    ),
    Case("research.transition_polynomial", P / (lam - lam), POLYNOMIAL, "invalid", "undefined"),
    Case("research.transition_polynomial", "P", POLYNOMIAL, "invalid", "a word"),
    Case("research.transition_polynomial", ..., POLYNOMIAL, "missing", "the untouched stub"),
    Case(
        "research.transition_polynomial",
        (w - 2) ** 2 + kappa / 6 * (w + 4),
        REDUCED,
        "right",
        "a square and a rest",
    ),
    Case(
        "research.transition_polynomial",
        w**2 + (kappa / 6 - 4) * w + 2 * kappa / 3 + 4,
        REDUCED,
        "right",
        "by powers",
    ),
    Case(
        "research.transition_polynomial",
        w**2 + (kappa / 6 - 4) * w + 2 * kappa / 3 + 6,
        REDUCED,
        "wrong",
        "lambda^2 + 1/lambda^2 taken for w^2",
    ),
    Case(
        "research.transition_polynomial",
        6 * (w - 2) ** 2 + kappa * (w + 4),
        REDUCED,
        "wrong",
        "multiplied by 6",
    ),
    Case("research.transition_polynomial", P, REDUCED, "invalid", "in lambda"),
    Case("research.transition_polynomial", ..., REDUCED, "missing", "the untouched stub"),
    Case(
        "research.transition_polynomial",
        4 * (1 - sp.cos(phi)) ** 2 + kappa / 3 * (2 + sp.cos(phi)),
        CIRCLE,
        "right",
        "two terms that are not negative",
    ),
    Case(
        "research.transition_polynomial",
        16 * sp.sin(phi / 2) ** 4 + kappa * (2 + sp.cos(phi)) / 3,
        CIRCLE,
        "right",
        "by the half angle",
    ),
    Case(
        "research.transition_polynomial",
        (sp.cos(phi) - 2) ** 2 + kappa / 6 * (sp.cos(phi) + 4),
        CIRCLE,
        "wrong",
        "w = cos phi",
    ),
    Case(
        "research.transition_polynomial",
        (P / lam**2).subs(lam, sp.exp(sp.I * phi)),
        CIRCLE,
        "wrong",
        "the right value, still with the imaginary unit",
    ),
    Case(
        "research.transition_polynomial",
        4 * (1 - sp.cos(phi)) ** 2,
        CIRCLE,
        "wrong",
        "the first term only",
    ),
    Case("research.transition_polynomial", sp.Gt(kappa, 0), CIRCLE, "invalid", "a condition"),
    Case("research.transition_polynomial", ..., CIRCLE, "missing", "the untouched stub"),
    Case("research.multiple_eigenvalues", 144, MULTIPLE, "right", "exact"),
    Case("research.multiple_eigenvalues", 144.4, MULTIPLE, "right", "a decimal that rounds to it"),
    Case("research.multiple_eigenvalues", 145, MULTIPLE, "wrong", "the next whole number"),
    Case("research.multiple_eigenvalues", 0, MULTIPLE, "wrong", "the trivial zero"),
    Case("research.multiple_eigenvalues", 24, MULTIPLE, "wrong", "another coefficient"),
    Case("research.multiple_eigenvalues", kappa, MULTIPLE, "invalid", "a symbol"),
    Case("research.multiple_eigenvalues", ..., MULTIPLE, "missing", "the untouched stub"),
    Case("research.digits_lost", 0.217, DIGITS, "right", "three digits"),
    Case("research.digits_lost", math.log10(1.648641), DIGITS, "right", "a float"),
    Case(
        "research.digits_lost",
        sp.Rational(217, 1000),
        DIGITS,
        "wrong",
        "a fraction says that it is exact",
    ),
    Case("research.digits_lost", 0.5, DIGITS, "wrong", "the natural logarithm"),
    Case("research.digits_lost", 1.649, DIGITS, "wrong", "the eigenvalue"),
    Case("research.digits_lost", 1e9, DIGITS, "wrong", "absurdly large"),
    Case("research.digits_lost", "0.2", DIGITS, "invalid", "a word"),
    Case("research.digits_lost", ..., DIGITS, "missing", "the untouched stub"),
    Case(
        "research.spline_acceleration",
        3 * rho * tau * second / (2 * (rho * tau**3 + 9 * M)),
        THREE,
        "right",
        "a fraction",
    ),
    Case(
        "research.spline_acceleration",
        (second / tau) / (2 * tau / 3 + 6 * M / (rho * tau**2)),
        THREE,
        "right",
        "from the banded equation",
    ),
    Case(
        "research.spline_acceleration",
        ((h2 - h1) / (2 * tau) - (h1 - h0) / tau)
        / (tau + M * (1 + sp.Rational(9, 4) + sp.Rational(1, 4)) / (rho * tau**2)),
        (UNEVEN, SAMPLES, rho, M),
        "right",
        "unequal intervals",
    ),
    Case(
        "research.spline_acceleration",
        3 * second / (2 * tau**2),
        THREE,
        "wrong",
        "the spline through the samples",
    ),
    Case(
        "research.spline_acceleration",
        3 * rho * tau * second / (2 * (rho * tau**3 + 6 * M)),
        THREE,
        "wrong",
        "only the middle sample gives way",
    ),
    Case("research.spline_acceleration", D, THREE, "invalid", "a symbol of another item"),
    Case("research.spline_acceleration", ..., THREE, "missing", "the untouched stub"),
    Case(
        "research.spline_positions",
        [h0 + s, h1 - 2 * s, h2 + s],
        THREE,
        "right",
        "samples and misses",
    ),
    Case(
        "research.spline_positions",
        sp.Matrix([h0 + s, h1 - 2 * s, h2 + s]).applyfunc(sp.together),
        THREE,
        "right",
        "a column",
    ),
    Case(
        "research.spline_positions",
        [h0 - s, h1 + 2 * s, h2 - s],
        THREE,
        "wrong",
        "the misses turned round",
    ),
    Case("research.spline_positions", SAMPLES, THREE, "wrong", "the samples"),
    Case("research.spline_positions", [h0 + s, h1 - 2 * s], THREE, "invalid", "two of three"),
    Case("research.spline_positions", [h0 + s, ..., h2 + s], THREE, "missing", "filled in part"),
    Case("research.spline_acceleration", 3 * Delta / (2 * tau**2), THROUGH, "right", "exact"),
    Case("research.spline_acceleration", 1.5 * Delta / tau**2, THROUGH, "right", "decimals"),
    Case(
        "research.spline_acceleration",
        Delta / tau**2,
        THROUGH,
        "wrong",
        "the second difference quotient",
    ),
    Case("research.spline_acceleration", sp.oo, THROUGH, "wrong", "infinite, as the paper says"),
    Case(
        "research.spline_acceleration", 3 * Delta / (2 * M), THROUGH, "invalid", "with the weight"
    ),
    Case("research.spline_acceleration", ..., THROUGH, "missing", "the untouched stub"),
    Case(
        "research.weight_for_bound",
        rho * tau * (3 * Delta - 2 * D * tau**2) / (18 * D),
        BOUNDED,
        "right",
        "a fraction",
    ),
    Case(
        "research.weight_for_bound",
        rho * tau * Delta / (6 * D) - rho * tau**3 / 9,
        BOUNDED,
        "right",
        "multiplied out",
    ),
    Case(
        "research.weight_for_bound",
        0.167 * rho * tau * Delta / D - 0.111 * rho * tau**3,
        BOUNDED,
        "right",
        "three digits",
    ),
    Case(
        "research.weight_for_bound",
        0.1684 * rho * tau * Delta / D - rho * tau**3 / 9,
        BOUNDED,
        "wrong",
        "one per cent off",
    ),
    Case("research.weight_for_bound", sp.exp(40 * rho), BOUNDED, "wrong", "very large"),
    Case("research.weight_for_bound", sp.exp(-400 * rho), BOUNDED, "wrong", "very small"),
    Case(
        "research.weight_for_bound",
        rho * tau * (2 * D * tau**2 - 3 * Delta) / (18 * D),
        BOUNDED,
        "wrong",
        "negative",
    ),
    Case(
        "research.weight_for_bound",
        rho * tau * (3 * Delta - 2 * D * tau**2) / 18,
        BOUNDED,
        "wrong",
        "not divided by D",
    ),
    Case("research.weight_for_bound", M, BOUNDED, "invalid", "M itself"),
    Case("research.weight_for_bound", ..., BOUNDED, "missing", "the untouched stub"),
    Case(
        "research.spline_misfit",
        rho * (Delta - 2 * D * tau**2 / 3) ** 2 / 6,
        BOUNDED,
        "right",
        "a square",
    ),
    Case(
        "research.spline_misfit",
        rho * (3 * Delta - 2 * D * tau**2) ** 2 / 54,
        BOUNDED,
        "right",
        "over 54",
    ),
    Case(
        "research.spline_misfit",
        rho * (Delta - D * tau**2) ** 2 / 6,
        BOUNDED,
        "wrong",
        "that of the direct method",
    ),
    Case(
        "research.spline_misfit",
        rho * (Delta - 2 * D * tau**2 / 3) ** 2 / 12,
        BOUNDED,
        "wrong",
        "half of it, as it stands in the cost",
    ),
    Case("research.spline_misfit", [rho], BOUNDED, "invalid", "a list"),
    Case("research.spline_misfit", ..., BOUNDED, "missing", "the untouched stub"),
    Case(
        "research.bounded_misfit", rho * (Delta - D * tau**2) ** 2 / 6, BOUNDED, "right", "a square"
    ),
    Case(
        "research.bounded_misfit",
        rho * tau**4 * (Delta / tau**2 - D) ** 2 / 6,
        BOUNDED,
        "right",
        "by the second difference quotient",
    ),
    Case(
        "research.bounded_misfit",
        rho * (Delta - 2 * D * tau**2 / 3) ** 2 / 6,
        BOUNDED,
        "wrong",
        "that of the sweep",
    ),
    Case("research.bounded_misfit", 0, BOUNDED, "wrong", "no miss"),
    Case("research.bounded_misfit", sp.Eq(D, 0), BOUNDED, "invalid", "an equation"),
    Case("research.bounded_misfit", ..., BOUNDED, "missing", "the untouched stub"),
    Case("research.filter_gain", rho / (rho + M * omega**4), FILTER, "right", "a fraction"),
    Case("research.filter_gain", 1 / (1 + M * omega**4 / rho), FILTER, "right", "of first kind"),
    Case("research.filter_gain", rho / (rho - M * omega**2), FILTER, "wrong", "second derivative"),
    Case(
        "research.filter_gain", M * omega**4 / (rho + M * omega**4), FILTER, "wrong", "what is lost"
    ),
    Case("research.filter_gain", sp.sqrt(-rho), FILTER, "wrong", "not real"),
    Case(
        "research.filter_gain",
        sp.cos(omega * sp.Symbol("t")),
        FILTER,
        "invalid",
        "a function of time",
    ),
    Case("research.filter_gain", ..., FILTER, "missing", "the untouched stub"),
    Case(
        "research.boundary_decay",
        (rho / (4 * M)) ** sp.Rational(1, 4),
        WEIGHTS,
        "right",
        "a fourth root",
    ),
    Case(
        "research.boundary_decay",
        sp.sqrt(sp.sqrt(rho / M) / 2),
        WEIGHTS,
        "right",
        "two square roots",
    ),
    Case(
        "research.boundary_decay", (rho / M) ** sp.Rational(1, 4), WEIGHTS, "wrong", "the modulus"
    ),
    Case(
        "research.boundary_decay",
        -((rho / (4 * M)) ** sp.Rational(1, 4)),
        WEIGHTS,
        "wrong",
        "the exponent",
    ),
    Case("research.boundary_decay", None, WEIGHTS, "invalid", "nothing"),
    Case("research.boundary_decay", ..., WEIGHTS, "missing", "the untouched stub"),
    Case(
        "research.weight_of_harmonic",
        rho / omega**4 * (a * omega**2 / D - 1),
        HARMONIC,
        "right",
        "a product",
    ),
    Case(
        "research.weight_of_harmonic",
        rho * a / (D * omega**2) - rho / omega**4,
        HARMONIC,
        "right",
        "multiplied out",
    ),
    Case(
        "research.weight_of_harmonic", rho * a / (D * omega**2), HARMONIC, "wrong", "without the 1"
    ),
    Case(
        "research.weight_of_harmonic",
        rho / omega**4 * (1 - a * omega**2 / D),
        HARMONIC,
        "wrong",
        "negative",
    ),
    Case("research.weight_of_harmonic", M, HARMONIC, "invalid", "M itself"),
    Case("research.weight_of_harmonic", ..., HARMONIC, "missing", "the untouched stub"),
]
LIMITS = [
    "Expressions are compared at six random places with positive values of all symbols except "
    "lambda and w; one that is right there and wrong for other signs would pass.",
    "The middle sample of three is taken for the place of the greatest acceleration; longer "
    "records are not judged.",
    "The least misfit under a bound is found with accelerations that are constant on sixteen "
    "pieces of each interval. For three samples the best acceleration is constant, so that "
    "nothing is lost.",
    "The answer on the unit circle may not contain the imaginary unit; that its sign can really "
    "be read off is not tested.",
]

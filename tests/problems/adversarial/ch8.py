"""Chapter 8: reference integral curves and invariant-unbiased estimates."""

from adversarial import right, wrong

ROWS = [
    wrong("8.1", "a_middle", "4.04*t*(1 - t)", "one per cent off"),
    wrong("8.1", "a_middle", "sp.sin(sp.pi*t)", "1 and 0 at the moments, but no polynomial"),
    wrong("8.1", "a_middle", "16*t**2*(1 - t)**2", "of too high a degree"),
    right("8.1", "a_middle", "1 - 4*(t - half)**2", "by its vertex"),
    right("8.1", "a_middle", "-4*t**2 + 4*t", "by powers"),
    wrong(
        "8.1",
        "b_formula",
        "x0 + (1 - 1.85*x0)*t + (x0 - 0.667)*t**2",
        "one per cent off in one coefficient",
    ),
    wrong(
        "8.1",
        "b_formula",
        "x0 + (1 - 11*x0/6)*t + (x0 - sp.Rational(2, 3))*t**2 + t*(t - 1)*(2*t - 1)*(x0 - 1)",
        "agrees with the table, of too high a degree in t",
    ),
    wrong(
        "8.1",
        "b_formula",
        "x0 + (1 - 11*x0/6)*t + (x0 - sp.Rational(2, 3))*t**2 + (x0 - 1)*(x0 - 2)*t",
        "agrees with the table, of too high a degree in the start",
    ),
    right("8.1", "b_formula", "x0*(1 - 11*t/6 + t**2) + t*(1 - 2*t/3)", "ordered by the start"),
    right("8.1", "b_formula", "x0 + (1 - 1.83*x0)*t + (x0 - 0.667)*t**2", "three digits"),
    wrong("8.1", "c_curve", "(x0 - 1)*t*(2*t - 1)*(t - 1)/(6*(1 + t))", "zero for the start 1"),
    right(
        "8.1",
        "c_curve",
        "x0*t*(2*t - 1)*(t - 1)/(6*(1 + x0*t))",
        "with the start, which is 1 there, left in it",
    ),
    wrong("8.1", "d_moment", "sp.Abs((x0 - 1)*(x0 - 2))/(6*(1 + x0))", "its size"),
    right(
        "8.1",
        "d_moment",
        "-sp.Abs((x0 - 1)*(x0 - 2))/(6*(1 + x0))",
        "less its size, between the starts",
    ),
    wrong("8.1", "e_defect", "(x0 - 1)**2", "almost the same polynomial"),
    right("8.1", "e_defect", "x0*(x0 - 1.83) + 1", "three digits"),
    wrong(
        "8.2", "a_weights", "[q/(q - 1)/2, 0.505, 1/(1 - q)/2]", "one per cent off in one weight"
    ),
    wrong(
        "8.2",
        "a_weights",
        "[0, q/(q - 1), 1/(1 - q)]",
        "unbiased and invariant by the last two samples alone",
    ),
    wrong("8.2", "a_weights", "[-sp.Rational(1, 2), sp.Rational(1, 2), 1]", "for q = 1/2 alone"),
    right("8.2", "a_weights", "[0.5*q/(q - 1), 0.5, 0.5/(1 - q)]", "halves in decimals"),
    wrong("8.2", "b_condition", "sp.Ne(q, 1) & (q < 2)", "without the drifts that grow fast"),
    right("8.2", "b_condition", "sp.Ne(q**2, 1)", "the other root is no drift"),
    right("8.2", "b_condition", "sp.Abs(q - 1) > 0", "by the distance"),
    wrong(
        "8.2",
        "c_estimates",
        "[(h0 + h1 + h2)/3, (h0 - h2)/(1 - q**2)]",
        "a mean, and a drift by two samples",
    ),
    right(
        "8.2",
        "c_estimates",
        "[h1/2 + (q*h0 - h2)/(2*(q - 1)), (h0 + h1 + h2)/(-2*(1 - q)**2)"
        " + 3*(h0 + q*h1 + q**2*h2)/(2*(1 - q)**2*(1 + q + q**2))]",
        "not put over one denominator",
    ),
    wrong(
        "8.2",
        "c_covariance",
        "sigma**2/(2*(1 - q)**2)*sp.Matrix([[1 - q + q**2, 1], [1, 3/(1 + q + q**2)]])",
        "the sign of the correlation",
    ),
    wrong(
        "8.2",
        "c_covariance",
        "sigma**2/(2*(1 - q)**2)*sp.Matrix([[1 - q + q**2, -1], [-1, 1/(1 + q + q**2)]])",
        "a factor of three in one entry",
    ),
    right(
        "8.2",
        "c_covariance",
        "sigma**2/(2*(1 - q)**2)*sp.Matrix([[(1 + q**3)/(1 + q), -1], [-1, 3*(1 - q)/(1 - q**3)]])",
        "by sums of powers",
    ),
    wrong("8.2", "d_weights", "[(q - 1)/2/(1 - q), 0, sp.Rational(1, 2)]", "those without a drift"),
    right("8.2", "d_weights", "sp.Matrix([q, -1 - q, 1])/(1 - q)", "a column times a factor"),
    wrong("8.3", "a_product", "0.38*h**3", "one per cent too small"),
    right("8.3", "a_product", "0.3849*h**3", "four digits"),
    wrong("8.3", "b_bound", "2*h**3/(9*sp.sqrt(3))*(1 + h/100)", "slightly more for long steps"),
    right("8.3", "b_bound", "sp.Max(h**3, 2*h**3)/(9*sp.sqrt(3))", "the greater curve"),
    wrong("8.3", "c_chebyshev", "h**3/12 + h**4/1000", "another power added"),
    wrong("8.3", "d_quotient", "1 + 2*h + 2*h**2", "three terms of the series"),
    right("8.3", "d_quotient", "1/sp.exp(-2*h)", "an inverse"),
    wrong("8.3", "e_rate", "2*h**2/3*sp.exp(-2*h)", "the least third derivative"),
]

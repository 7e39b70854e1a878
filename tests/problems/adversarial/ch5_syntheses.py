"""Chapter 5, problems 5.1 to 5.10: transfers in least time, laws and the curves on which they
change."""

from adversarial import right, wrong

A_CURVE = "sp.sqrt(1 - (sp.Abs(x1) - 2*sp.floor(sp.Abs(x1)/2) - 1)**2)"
ELLIPSE = (
    "sp.sqrt(1 - R**2/(sp.sqrt(R**2 + 2*sp.Abs(x1) + 1) - 1)**2)*sp.sqrt(R**2 + 2*sp.Abs(x1) + 1)"
)
OUTSIDE = "sp.sqrt(1 - (-R + sp.Abs(x1) - 2*sp.floor(-R/2 + sp.Abs(x1)/2) - 1)**2)"
INSIDE = "x2 - x1*sp.sqrt((R**2 - x1**2 - x2**2)/(4 - R**2 + x1**2 + x2**2))"
FALLING = "x1 - x2 - sp.log(1 - sp.Abs(x2))*sp.sign(x2)"
TURNED = "sp.sqrt((sp.cos(alpha) - sp.sin(alpha))/(sp.cos(alpha) + sp.sin(alpha)))"
LEFT_OR_Z = "sp.Piecewise((sp.sqrt(x1**2 - R**4/x1**2), R <= -x1), (0, R > x1), (z, True))"
BELOW = "sp.Piecewise((1, sp.Or(sp.And(x2 <= 0, x1 < 0.5), sp.And(x2 > 0, x2 < 1, x1 < x2**2/2 + {0}))), (-1, True))"
ABOVE = (
    "-sp.Piecewise((1, sp.Or(sp.And(x2 >= 0, x1 > -0.5), sp.And(x2 < 0, x2 > -1, x1 > -x2**2/2 - "
    "{0}))), (-1, True))"
)
TO_LINE = f"sp.Piecewise(({BELOW}, x1 > x2), ({ABOVE}, True))"

ROWS = [
    wrong("5.1", "time", "(b - a)*sp.tanh(1000*(b - a))/A", "a smooth imitation of the modulus"),
    wrong("5.1", "time", "sp.Abs(b)/A", "counted from zero"),
    right("5.1", "time", "sp.sqrt(a**2 - 2*a*b + b**2)/A", "a root for the modulus"),
    wrong("5.1", "control", "A*sp.tanh(1000*(b - a))", "a smooth imitation of the sign"),
    wrong(
        "5.1",
        "control",
        "A*(b - a)/(sp.Abs(b - a) + sp.Rational(1, 1000))",
        "it never comes up to the bound",
    ),
    wrong("5.1", "control", "A*sp.erf(1000*(b - a))", "another smooth imitation"),
    right("5.1", "control", "A*(b - a)/sp.Abs(b - a)", "a quotient for the sign"),
    right(
        "5.1",
        "control",
        "[[A*sp.sign(b - a), 2*sp.Abs(b - a)/A]]",
        "an arc that goes on behind the end",
    ),
    right(
        "5.1",
        "control",
        "A*sp.Piecewise((1, b - a > 0), (-1, b - a < 0))",
        "cases without a last one",
    ),
    wrong("5.1", "trajectory", "a + A*t*sp.tanh(1000*(b - a))", "a smooth imitation of the sign"),
    right(
        "5.1",
        "trajectory",
        "a + sp.sign(b - a)*sp.Min(A*t, sp.Abs(b - a))",
        "it stays there afterwards",
    ),
    wrong("5.1", "costate", "sp.tanh(1000*(b - a))/A", "a smooth imitation of the sign"),
    wrong("5.1", "costate", "-sp.sign(b - a)/A", "the costate of H = -psi u - 1"),
    wrong("5.1", "costate", "sp.sign(b - a)", "H is A - 1, not zero"),
    right("5.1", "costate", "1/(A*sp.sign(b - a))", "the sign below"),
    wrong("5.1", "reached", "sp.Abs(b - a) < A*T", "just in time is in time"),
    wrong(
        "5.1",
        "reached",
        "sp.Or(sp.Abs(b - a) < A*T, sp.Eq(b - a, A*T))",
        "the border to one side alone",
    ),
    right(
        "5.1",
        "reached",
        "sp.Contains(b, sp.Interval(a - A*T, a + A*T))",
        "membership of an interval",
    ),
    right("5.1", "reached", "sp.sign(sp.Abs(b - a) - A*T) <= 0", "by a sign"),
    wrong("5.2", "least_rate", "x*sp.tanh(1000*x) - 1", "a smooth imitation of the modulus"),
    wrong("5.2", "solvable", "sp.Abs(x0) <= 1", "at one the state cannot be moved towards zero"),
    right(
        "5.2", "solvable", "sp.And(x0 > -1, x0 < 1, sp.Ne(x0, 0))", "zero may be counted either way"
    ),
    wrong("5.2", "time", "-sp.log(1 - x0*sp.tanh(1000*x0))", "a smooth imitation of the modulus"),
    right("5.2", "time", "2*sp.atanh(sp.Abs(x0)/(2 - sp.Abs(x0)))", "an area function"),
    wrong("5.2", "control", "-sp.tanh(10000*x0)", "a steep smooth imitation"),
    wrong(
        "5.2",
        "control",
        "-x0/sp.sqrt(x0**2 + sp.Rational(1, 10**8))",
        "a smooth imitation with a root",
    ),
    right("5.2", "control", "1 - 2*sp.Heaviside(x0)", "a step"),
    wrong(
        "5.2",
        "trajectory",
        "sp.tanh(1000*x0) + (x0 - sp.tanh(1000*x0))*sp.exp(t)",
        "a smooth imitation",
    ),
    right(
        "5.2",
        "trajectory",
        "sp.sign(x0)*(1 - sp.exp(t + sp.log(1 - sp.Abs(x0))))",
        "the time left in the exponent",
    ),
    wrong("5.2", "costate", "-sp.exp(-t)*sp.tanh(1000*x0)/(1 - sp.Abs(x0))", "a smooth imitation"),
    right("5.2", "costate", "sp.exp(-t)/(x0 - sp.sign(x0))", "the sign below"),
    wrong("5.3", "a_switching", "-x2**2*sp.tanh(1000*x2)/2", "a smooth imitation of the sign"),
    wrong("5.3", "a_switching", "-x2**2*sp.tanh(10**5*x2)/2", "a steep smooth imitation"),
    wrong(
        "5.3",
        "a_switching",
        "-x2**2*x2/sp.sqrt(x2**2 + sp.Rational(1, 10**6))/2",
        "a smooth imitation with a root",
    ),
    wrong(
        "5.3", "a_law", "-sp.sign(x1 + x2**2*sp.tanh(1000*x2)/2)", "a smooth imitation of the curve"
    ),
    right("5.3", "a_switching", "-x2*sp.sqrt(x2**2)/2", "a root for the modulus"),
    wrong(
        "5.3",
        "a_switching",
        "-x2*sp.sqrt(x2**2 + sp.Rational(1, 100))/2",
        "a smooth imitation of the modulus",
    ),
    right("5.3", "a_switching", "-x2**3/(2*sp.Abs(x2))", "a quotient, undefined at zero alone"),
    wrong(
        "5.3",
        "a_law",
        "-sp.sign(x1 + x2*sp.Abs(x2)/2 + sp.Rational(1, 1000))",
        "a thousandth beside the curve",
    ),
    right(
        "5.3",
        "a_law",
        "-sp.sign(x2 + sp.sign(x1)*sp.sqrt(2*sp.Abs(x1)))",
        "the curve solved for the velocity",
    ),
    wrong("5.3", "a_control", "sp.tanh(1000*(t - 1))", "it goes over by and by"),
    wrong("5.3", "a_control", "2*sp.atan(1000*(t - 1))/sp.pi", "it never comes up to the bounds"),
    wrong("5.3", "a_control", "sp.tanh(10**6*(t - 1))", "it goes over by and by, however quickly"),
    right("5.3", "a_control", "-(-1)**sp.floor(t)", "a power of minus one"),
    right("5.3", "a_control", "-sp.sign(sp.cos(sp.pi*t/2))", "the sign of a cosine"),
    wrong("5.3", "a_costate", "[-2, 2*t - 2]", "H is one, not zero"),
    wrong("5.3", "a_costate", "[-1, t - 1.01]", "its zero is one per cent late"),
    wrong("5.3", "b_solvable", "sp.And(x2 < 0, x1 > x2**2/2)", "who brakes at once arrives too"),
    wrong("5.3", "b_control", "(1 + sp.tanh(1000*(t - 0.5)))/2", "it goes over by and by"),
    right(
        "5.3",
        "b_control",
        "sp.floor(t + sp.Rational(1, 2))",
        "a floor for the step, as far as the time goes",
    ),
    right(
        "5.3",
        "b_law",
        "sp.Piecewise((0, x2 > -sp.sqrt(2*x1)), (1, True))",
        "the curve solved for the velocity",
    ),
    wrong("5.4", "a_law", "-sp.sign(x1 + x2/100)", "close to the line it drives away from it"),
    wrong("5.4", "a_law", "-sp.sign(x1 - sp.Rational(1, 1000))", "a thousandth beside the line"),
    wrong("5.4", "b_law", "-sp.sign(x2 + x1/1000)", "the line is turned a little"),
    wrong("5.4", "b_law", "-sp.sign(x2 - sp.Rational(1, 1000))", "a thousandth beside the line"),
    wrong(
        "5.4",
        "a_time",
        "sp.Abs(x2) + sp.sqrt(x2**2 + 2*sp.Abs(x1))",
        "right only for motions away from the line",
    ),
    right(
        "5.4",
        "a_time",
        "2*sp.Abs(x1)/(sp.sqrt(x2**2 + 2*sp.Abs(x1)) - x2*sp.sign(x1))",
        "the root below",
    ),
    wrong("5.4", "a_others", "sp.And(x1 > 0, x2 < 0, x2**2 >= 2*x1)", "one side alone"),
    right("5.4", "a_others", "sp.And(sp.sign(x1)*x2 < 0, x2**2/2 > sp.Abs(x1))", "by the sign"),
    wrong(
        "5.4",
        "a_other_time",
        "sp.Abs(x2) - sp.sqrt(x2**2 - 2*sp.Abs(x1))",
        "the same motion, met earlier",
    ),
    wrong("5.4", "b_others", "sp.And(sp.Eq(x1, 3), sp.Eq(x2, 1))", "a single start"),
    wrong(
        "5.5",
        "crossing",
        "[(R*sp.sin(alpha) - sp.tan(alpha))*(-R*sp.cos(alpha) + 2.02/sp.cos(alpha)**2), "
        "-R*(R*sp.sin(alpha) - sp.tan(alpha))*sp.cos(alpha)]",
        "one per cent off in one term",
    ),
    wrong("5.5", "barrier", "R**2/2 - x2**2/2 + sp.Rational(501, 1000)", "a thousandth beside it"),
    right(
        "5.5",
        "curve",
        "[R*sp.sec(alpha) - (sp.sec(alpha)**2 - 1)/2, (R*sp.cos(alpha) - 1)*sp.tan(alpha)]",
        "by the secant",
    ),
    right(
        "5.5",
        "reached",
        "R*sp.cos(alpha)*sp.sign(sp.sin(alpha)) < sp.Abs(sp.sign(sp.sin(alpha)))",
        "by signs",
    ),
    wrong("5.6", "continuous", "R >= sp.Rational(101, 100)", "one per cent off"),
    wrong("5.6", "continuous", "R >= sp.Rational(999, 1000)", "a thousandth off"),
    wrong("5.6", "continuous", "sp.And(R >= 1, R <= 100)", "bounded for no reason"),
    wrong("5.6", "continuous", "sp.And(R >= 1, sp.Ne(R, 2))", "a value is left out"),
    wrong(
        "5.6", "continuous", "sp.Or(R >= 1, R < sp.Rational(1, 1000))", "thin ellipses are added"
    ),
    right("5.6", "continuous", "R**2 > 1", "the border may be left out"),
    right("5.6", "continuous", "sp.log(R) >= 0", "by a logarithm"),
    wrong(
        "5.6",
        "law",
        f"sp.Piecewise((-sp.sign(x2 + {ELLIPSE}*sp.sign(x1)), 1 < sp.Abs(x1)), (-sp.sign(x2), "
        "True))",
        "the curve begins at R, not at one",
    ),
    right(
        "5.6",
        "law",
        f"-sp.sign(x2 + sp.sign(x1)*sp.re({ELLIPSE})*sp.Heaviside(sp.Abs(x1) - R))",
        "a step",
    ),
    right(
        "5.6",
        "law_wide",
        "sp.Piecewise((-1, x2 > 1), (1, x2 < -1), (0, True))",
        "in the strip nothing is asked",
    ),
    wrong("5.7", "a_switching", f"-sp.tanh(1000*x1)*{A_CURVE}", "a smooth imitation of the sign"),
    wrong(
        "5.7",
        "a_switching",
        f"sp.Piecewise((-sp.sign(x1)*{A_CURVE}, sp.Abs(x1) < 20), (0, True))",
        "ten semicircles on a side, not all",
    ),
    wrong(
        "5.7",
        "a_law",
        f"sp.Piecewise((-sp.sign(x2 + sp.sign(x1)*{A_CURVE}), sp.Abs(x1) < 20), (-sp.sign(x2), "
        "True))",
        "ten semicircles on a side, not all",
    ),
    right(
        "5.7",
        "a_switching",
        "-sp.sign(x1)*sp.sin(sp.acos(1 - sp.Mod(sp.Abs(x1), 2)))",
        "by an arc cosine",
    ),
    right(
        "5.7",
        "a_law",
        "-sp.sign(x2 + sp.sign(x1)*sp.sin(sp.acos(1 - sp.Mod(sp.Abs(x1), 2))))",
        "by an arc cosine",
    ),
    wrong(
        "5.7",
        "c_switching",
        "-x2 + sp.log(sp.Abs(x2) + 1)*sp.tanh(1000*x2)",
        "a smooth imitation of the sign",
    ),
    wrong(
        "5.7",
        "c_law",
        "-sp.sign(x1 + x2 - 0.98*sp.log(sp.Abs(x2) + 1)*sp.sign(x2))",
        "two per cent: it chatters",
    ),
    right(
        "5.7",
        "c_law",
        "-sp.sign(x2)*sp.sign(sp.exp(sp.sign(x2)*(x1 + x2)) - 1 - sp.Abs(x2))",
        "by an exponential, zero on the axis alone",
    ),
    wrong("5.7", "a_interval", "sp.Rational(22, 7)", "exact, and not pi"),
    wrong("5.7", "a_switching", "-sp.Abs(sp.sin(sp.pi*x1/2))*sp.sign(x1)", "arches of a sine"),
    wrong(
        "5.7",
        "a_law",
        f"-sp.sign(x2 + {A_CURVE}*sp.tanh(1000*x1))",
        "a smooth imitation of the inner sign",
    ),
    wrong(
        "5.7",
        "a_law",
        "-sp.sign(x2 + sp.sign(x1)*(1 - sp.Abs(sp.Abs(x1) - 2*sp.floor(sp.Abs(x1)/2) - 1)))",
        "a polygon for the semicircles",
    ),
    right(
        "5.7",
        "a_law",
        "-sp.sign(x2 + sp.sign(x1)*sp.sqrt(1 - (sp.Mod(sp.Abs(x1), 2) - 1)**2))",
        "by a remainder",
    ),
    right("5.7", "a_count", "sp.ceiling(R/2)", "even numbers are not asked"),
    wrong("5.7", "a_time", "sp.pi*R/2", "a mean over the turns"),
    wrong(
        "5.7",
        "b_law",
        "-sp.sign(x2 + sp.sign(x1)*sp.sqrt(2*sp.Abs(x1)))",
        "the curve of the double integrator",
    ),
    right(
        "5.7",
        "b_law",
        "-sp.sign(x1 + sp.sign(x2)*(sp.sqrt(1 + x2**2) - 1))",
        "the curve solved for the place",
    ),
    wrong("5.7", "c_switching", "-x2*sp.Abs(x2)/2", "without friction"),
    wrong(
        "5.7",
        "d_law",
        "-sp.sign(x1 - x2 - 1.05*sp.log(1 - sp.Abs(x2))*sp.sign(x2))",
        "five per cent off",
    ),
    right(
        "5.7",
        "d_law",
        f"1 - 2*sp.Heaviside({FALLING})",
        "a step; a number beyond the border of the starts too",
    ),
    right(
        "5.7",
        "d_law",
        "sp.Piecewise((-1, x1 > sp.sign(x2)*(sp.Abs(x2) + sp.log(1 - sp.Abs(x2)))), (1, True))",
        "cases; a number beyond the border of the starts too",
    ),
    right(
        "5.7",
        "d_law",
        "sp.Piecewise((1, x1 < sp.sign(x2)*(sp.Abs(x2) + sp.log(1 - sp.Abs(x2)))), (-1, True))",
        "the other number beyond the border",
    ),
    right(
        "5.7",
        "d_law",
        "-sp.sign(x1 - x2 - sp.log(sp.Abs(1 - sp.Abs(x2)))*sp.sign(x2))",
        "the curve beyond too",
    ),
    wrong(
        "5.7",
        "d_law",
        "sp.Piecewise((-1, x1 > sp.sign(x2)*(sp.Abs(x2) + 1.03*sp.log(1 - sp.Abs(x2)))), (1, "
        "True))",
        "three per cent off, a number beyond the border",
    ),
    wrong(
        "5.8",
        "reached",
        "sp.And(sp.Ne(sp.sin(alpha), 0), R*sp.cos(alpha) < 1)",
        "that of the double integrator",
    ),
    right("5.8", "reached", "sp.true", "two points are ends of arcs"),
    wrong(
        "5.8",
        "law",
        f"sp.Piecewise((-sp.sign(x2 + {OUTSIDE}*sp.sign(x1)), 1 < sp.Abs(x1)), (-sp.sign(x2), "
        "True))",
        "the curve begins at R, not at one",
    ),
    right(
        "5.8",
        "law",
        "sp.Piecewise((-sp.sign(x2 + sp.sqrt(1 - (sp.Mod(sp.Abs(x1) - R, 2) - 1)**2)*sp.sign(x1)), "
        "R < sp.Abs(x1)), (-sp.sign(x2), True))",
        "by a remainder",
    ),
    wrong(
        "5.8",
        "crossing",
        "[R*sp.sin(alpha), (R + 2)*sp.sin(alpha)]",
        "before and after changed places",
    ),
    wrong("5.8", "in_dispersal", "0*x1", "by symmetry alone"),
    wrong(
        "5.8",
        "in_dispersal",
        "sp.sqrt(R**2/2 - x1**2 + sp.sqrt(15.7*x1**2 + (4 - R**2)**2)/2 - 2)",
        "two per cent",
    ),
    wrong("5.8", "in_law", f"sp.tanh(1000*({INSIDE}))", "a smooth imitation"),
    right("5.8", "in_law", f"2*sp.Heaviside({INSIDE}) - 1", "a step"),
    wrong("5.9", "a_law", "-sp.sign(x2 + z*sp.sign(x1))", "no number where z has no value"),
    right(
        "5.9",
        "a_law",
        "sp.Piecewise((-sp.sign(x2), R > sp.Abs(x1)), (-1, x2 > -z*sp.sign(x1)), (1, True))",
        "three cases",
    ),
    wrong("5.9", "a_barrier", "1 - x1", "the border of what is in reach"),
    wrong(
        "5.9",
        "a_switching",
        f"[{TURNED}*(R*(sp.cos(alpha) - sp.sin(alpha)) - 1)/2 + 1.03 + (R*(sp.sin(alpha) + "
        f"sp.cos(alpha)) - 1)/(2*{TURNED}), -{TURNED}*(R*(sp.cos(alpha) - sp.sin(alpha)) - 1)/2 + "
        f"(R*(sp.sin(alpha) + sp.cos(alpha)) - 1)/(2*{TURNED})]",
        "the saddle is three per cent off",
    ),
    wrong("5.9", "b_law", f"-sp.sign(x2 - {LEFT_OR_Z})", "the bounds of item a"),
    right("5.9", "b_law", f"sp.Heaviside({LEFT_OR_Z} - x2)", "a step"),
    right(
        "5.9",
        "b_time",
        "sp.log((R**2 - sp.sqrt(R**4 - (x1**2 - x2**2)**2))/(x1 + x2)**2)/2",
        "the conjugate root",
    ),
    wrong("5.10", "a_reached", "v < sp.Rational(999, 1000)", "a thousandth off"),
    right("5.10", "a_reached", "sp.exp(v) < sp.E", "by an exponential"),
    wrong("5.10", "a_curve", "sp.Rational(1, 2) + x2/1000", "it is turned a little"),
    wrong("5.10", "a_barrier", "sp.Rational(501, 1000) + x2**2/2", "a thousandth beside it"),
    wrong(
        "5.10",
        "a_law",
        TO_LINE.format("0.52"),
        "the barrier is four per cent off: the line is missed",
    ),
    right("5.10", "a_law", TO_LINE.format("0.5"), "a case for each side"),
    wrong("5.10", "b_reached", "sp.And(sp.Ne(v, 0), sp.Ne(v, 7))", "a point is left out"),
    wrong("5.10", "b_dispersal", "13*x2**2 + sp.Rational(1, 10)", "it begins beside the parabola"),
    wrong("5.10", "b_dispersal", "2*x2**2", "the root of the quadratic that is none of the times"),
]

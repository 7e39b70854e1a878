"""Chapter 5: slips of students, admissible processes that are not optimal, and borders a little
beside."""

from adversarial import right, wrong

BRAKE_LATE = "[[-1, sp.sqrt({0})], [0, {1}*sp.sqrt({0})], [1, {2}*sp.sqrt({0})]]"
BEFORE_35, BEYOND_35 = (
    "(w + sp.sqrt(2*w**2 + 4*a*rho))/a",
    "(-w + sp.sqrt(sp.Abs(2*w**2 - 4*a*rho)))/a",
)
BORDER_35 = f"sp.Piecewise(({BEFORE_35}, rho + w*sp.Abs(w)/(2*a) >= {{0}}), ({BEYOND_35}, True))"
SIDE_35 = "sp.tanh({0}*(1 + w*sp.Abs(w)/(2*a*rho)))"
SMOOTH_35 = f"({SIDE_35}*w + sp.sqrt(2)*sp.sqrt(w**2 + 2*a*rho*{SIDE_35}))/a"
SHORT_17 = "sp.Piecewise((sp.Abs(x0)**3/6, T > {0}*sp.Abs(x0)), ((sp.Abs(x0)**3 - (sp.Abs(x0) - T)**3)/6, True))"
D_57, R_57 = "sp.sqrt(a**2 + b**2)", "(vbar/omegabar)"
TURN_57 = (
    f"(sp.atan2(sp.Abs(b), a) - sp.asin(sp.Min({D_57}/(2*{R_57}), 1/sp.sqrt(2))) - "
    f"sp.acos(sp.Min({R_57}/{D_57}, 1/sp.sqrt(2))) + sp.pi/4)"
)
A_58, D_58 = "(r*sp.cos(phi) + k0)", "sp.sqrt((r*sp.cos(phi) + k0)**2 + (r*sp.sin(phi))**2)"
S_58 = "sp.Abs(r*sp.sin(phi))"
TURN_58 = f"(sp.atan2({S_58}, {A_58}) - sp.acos({R_57}/{D_58}))"
TIME_58 = (
    f"sp.Piecewise((({TURN_58} + sp.pi/2)/omegabar + (sp.sqrt({D_58}**2 - {R_57}**2) - "
    f"{R_57})/vbar, {TURN_58} > {{0}}), ((sp.atan2({S_58} - {R_57}, {A_58}) + sp.atan2({R_57}, "
    f"sp.sqrt({D_58}**2 - 2*{R_57}*{S_58})))/omegabar + sp.sqrt({D_58}**2 - 2*{R_57}*{S_58})/vbar, "
    "True)) - k0/vbar"
)
D_64 = "(1 + (1-t) + (1-t)**3/3 + (1-t)**4/12)"

ROWS = [
    wrong("5.1", "control", "[[A*sp.sign(b - a), sp.Abs(b - a)/(2*A)]]", "half the time"),
    wrong(
        "5.1",
        "control",
        "[[A*sp.sign(b - a)/2, 2*sp.Abs(b - a)/A]]",
        "at half the speed it arrives, and later",
    ),
    right(
        "5.1", "reached", "sp.ITE(b > a, b - a <= A*T, a - b <= A*T)", "one condition for each side"
    ),
    wrong("5.1", "reached", "(b - a)**2 <= A**2*T", "the time is not squared"),
    right(
        "5.1",
        "trajectory",
        "sp.Piecewise((sp.Min(a + A*t, b), b > a), (sp.Max(a - A*t, b), True))",
        "it stays there",
    ),
    wrong(
        "5.2",
        "costate",
        "-sp.sign(x0)*sp.exp(t)*(1 - sp.Abs(x0))",
        "the adjoint equation with the wrong sign",
    ),
    wrong("5.2", "costate", "-sp.sign(x0)*sp.exp(-t)", "H is not zero"),
    right("5.2", "solvable", "sp.ITE(x0 > 0, x0 < 1, x0 > -1)", "one condition for each side"),
    right("5.2", "control", "-sp.cos(sp.pi*sp.Heaviside(-x0))", "a cosine of a step"),
    wrong(
        "5.3",
        "a_time",
        "sp.Piecewise((x2 + 2*sp.sqrt(x1 + x2**2/2), x1 > 0), (2*sp.sqrt(x2**2/2 - x1) - x2, "
        "True))",
        "the axis for the switching curve",
    ),
    right(
        "5.3",
        "a_time",
        "sp.Max(x2 + 2*sp.sqrt(sp.Max(0, x1 + x2**2/2)), -x2 + 2*sp.sqrt(sp.Max(0, x2**2/2 - x1)))",
        "the greater one of both formulas",
    ),
    wrong("5.3", "a_control", "sp.Max(-1, sp.Min(1, 10**6*(t - 1)))", "a steep ramp"),
    wrong(
        "5.3",
        "a_control",
        "[[-sp.Rational(1, 2), sp.sqrt(2)], [sp.Rational(1, 2), 2*sp.sqrt(2)]]",
        "it arrives at half the force, and later",
    ),
    wrong(
        "5.3", "b_control", "[[sp.Rational(1, 2), 2]]", "it arrives at half the force, and later"
    ),
    wrong(
        "5.3",
        "a_law",
        "sp.Piecewise((-1, x1 > -x2**2/2), (1, True))",
        "right in the upper half-plane alone",
    ),
    right(
        "5.3",
        "b_law",
        "sp.Lambda((x1, x2), sp.Piecewise((0, 2*x1 > x2**2), (1, True)))",
        "a function of both",
    ),
    right("5.4", "a_reached", "sp.Max(v, -1) < 0", "the larger one of two"),
    wrong("5.4", "a_other_time", "-x2 + sp.sqrt(x2**2 - 2*x1)", "right on the right alone"),
    right(
        "5.5",
        "reached",
        "sp.ITE(sp.sin(alpha) > 0, R*sp.cos(alpha) < 1, sp.And(sp.sin(alpha) < 0, "
        "R*sp.cos(alpha) > -1))",
        "one condition for each half-plane",
    ),
    wrong(
        "5.5",
        "curve",
        "[R/sp.cos(alpha) + sp.tan(alpha)**2/2, R*sp.sin(alpha) - sp.tan(alpha)]",
        "a sign",
    ),
    right("5.7", "a_count", "sp.floor(R/2) + 1", "even numbers are not asked"),
    wrong("5.7", "b_solvable", "sp.Abs(x1 + x2) <= 1", "from the border nothing leads away"),
    right("5.10", "a_reached", "v <= 1", "the last one is touched by the motion along the barrier"),
    wrong("5.11", "control", "[[1, sp.pi/4], [4, sp.pi/2]]", "soft at first"),
    right("5.11", "angular_rate", "-(u + 1)/2 - (u - 1)*sp.cos(2*theta)/2", "by the double angle"),
    wrong("5.13", "control", "[[4, sp.pi/2]]", "the soonest return instead of the latest"),
    wrong("5.13", "control", "[[1, sp.pi/2], [4, 3*sp.pi/4]]", "stiff on the way back"),
    wrong(
        "5.14",
        "control",
        "[[u_min, sp.pi/(2*sp.sqrt(u_min))], [u_max, sp.pi/(2*sp.sqrt(u_min)) + "
        "sp.pi/(2*sp.sqrt(u_max))]]",
        "the least way instead of the greatest",
    ),
    wrong(
        "5.14",
        "control",
        "sp.Piecewise((u_max, sp.cos(sp.sqrt(u_max)*t) > 0), (u_min, True))",
        "stiff again before the end, where the bounds are more than four times apart",
    ),
    right(
        "5.15",
        "control",
        "sp.Piecewise((u_min, sp.cos(sp.sqrt(u_min)*t) > 0), (u_max, True))",
        "the cosine is not positive again before the end",
    ),
    wrong(
        "5.16",
        "b_control",
        "[[-1, sp.Rational(313, 100)], [1, sp.pi]]",
        "it changes a hundredth before the end",
    ),
    right("5.16", "b_control", "np.array([[-1, 3.1416]])", "arcs as an array"),
    wrong(
        "5.17",
        "a_control",
        "sp.Piecewise((-sp.sign(x0), t < 999*sp.Abs(x0)/1000), (0, True))",
        "it stops a thousandth before zero",
    ),
    right(
        "5.17",
        "a_cost",
        "(sp.Abs(x0)**3 - sp.Max(sp.Abs(x0) - T, 0)**3)/6",
        "the greater one of two",
    ),
    right("5.17", "a_cost", SHORT_17.format("1"), "two cases"),
    wrong(
        "5.17", "a_cost", SHORT_17.format("sp.Rational(4, 5)"), "the border of the cases is beside"
    ),
    wrong("5.17", "a_cost", SHORT_17.format("sp.Rational(6, 5)"), "and to the other side"),
    wrong(
        "5.17",
        "a_cost",
        SHORT_17.format("sp.Rational(19, 20)"),
        "hardly beside: there the cost would jump",
    ),
    wrong("5.17", "a_cost", SHORT_17.format("sp.Rational(31, 30)"), "and to the other side"),
    wrong("5.17", "b_law", "-sp.Max(-1, sp.Min(1, x))", "that of an infinite time"),
    wrong(
        "5.17",
        "b_law",
        "-sp.Max(-1, sp.Min(1, x*sp.tanh(T)))",
        "the time that has passed does not matter",
    ),
    wrong("5.18", "cost", "-sp.Rational(5, 8)", "an extremal, and the worst process"),
    wrong(
        "5.18",
        "costate",
        "[-sp.Rational(3, 2), 3*(t - 1)/2]",
        "zero at the end instead of the beginning",
    ),
    wrong(
        "5.19",
        "control",
        "[[-1, sp.Rational(49, 100)], [0, sp.Rational(51, 100)], [1, 1]]",
        "a short pause",
    ),
    wrong(
        "5.20",
        "control",
        "4*a*sp.cos(t)/sp.pi + a*(sp.sin(2*t) - 8*sp.cos(t)/(3*sp.pi))/10",
        "the same end at a greater cost",
    ),
    right("5.20", "fixed_cost", "a**2*(2/(sp.pi - 2) + 2/(sp.pi + 2))", "partial fractions"),
    wrong(
        "5.21",
        "a_control",
        "(6 - 2*T)/T**2 + (6*T - 12)*t/T**3 + (6*t**2/T**2 - 6*t/T + 1)/100",
        "the same end at a slightly greater cost",
    ),
    wrong("5.21", "a_still", "2.99", "one less in the third digit, at an inflection"),
    wrong("5.21", "c_still", "5.98", "two less in the third digit, at an inflection"),
    right(
        "5.22",
        "b_control",
        "sp.re((xi2 + sp.I*xi1)*sp.exp(sp.I*t))/sp.pi",
        "the real part of a complex number",
    ),
    wrong(
        "5.23",
        "costate",
        "[t - 2, sp.Rational(1, 2) - (t - 3)**2/2]",
        "zero at an end that is given",
    ),
    wrong(
        "5.23",
        "control",
        "[[-1, sp.Rational(99, 100)], [0, sp.Rational(101, 100)], [1, 2]]",
        "a short pause",
    ),
    wrong(
        "5.25",
        "control",
        "[[-1, sp.sqrt(d)], [1, 2*sp.sqrt(d)]]",
        "the fastest way, without drifting",
    ),
    wrong(
        "5.25",
        "control",
        BRAKE_LATE.format("5*d/12", "12*sp.Rational(1, 5)", "17*sp.Rational(1, 5)"),
        "a drift that is a little short",
    ),
    wrong("5.25", "control", BRAKE_LATE.format("d/3", "3", "4"), "a drift that is too long"),
    right(
        "5.25",
        "control",
        "sp.Matrix([[-1, sp.sqrt(10*d)/5], [0, sp.sqrt(10*d)/2], [1, 7*sp.sqrt(10*d)/10]])",
        "arcs as the rows of a matrix",
    ),
    wrong(
        "5.26",
        "cost",
        "sp.Rational(4, 3)*18**sp.Rational(1, 4)*sp.sqrt(d)",
        "as if there were no bounds",
    ),
    wrong("5.27", "b_motion", "sp.sqrt(1 - 2*t)", "an extremal that ends half-way"),
    wrong(
        "5.29",
        "switching",
        "(psi_v/m - psi_m/c)*(m - sp.Rational(1, 1000))",
        "a factor that changes its sign",
    ),
    wrong(
        "5.29", "switching", "(psi_v/m - psi_m/c)*(psi_v - 1)**2", "a factor with a zero of its own"
    ),
    right("5.29", "switching", "(psi_v/m - psi_m/c)*(1 + psi_v**2)", "a factor that is positive"),
    right("5.29", "transversality", "[(psi_h - 1)**2]", "a square"),
    right("5.31", "time_transversality", "[psi3**2 + psi4**2]", "a sum of squares"),
    right(
        "5.31",
        "transversality",
        "[(psi1 - k1)**2 + (psi2 - k2)**2, sp.Eq((psi3 - k3)**2 + 2*(psi4 - k4)**2, 0)]",
        "sums of squares",
    ),
    wrong(
        "5.31",
        "transversality",
        "[(psi1 - k1)**2 + (psi2 - k2)**2 + (psi3 + k3)**2 + (psi4 - k4)**2]",
        "a sign in a sum of squares",
    ),
    wrong("5.31", "time_transversality", "[(psi3 + psi4)**2]", "the square of a sum"),
    right(
        "5.29",
        "height",
        "(v0 + c*sp.log(m0/m_T))**2/(2*g) + c**2/P_max*(m0 - m_T - m0*sp.log(m0/m_T))",
        "the loss while it burns as a term of its own",
    ),
    wrong(
        "5.29",
        "height",
        "(v0 + c*sp.log(m0/m_T))**2/(2*g) + c**2/P_max*(m0 - m_T - m_T*sp.log(m0/m_T))",
        "the mass at the end for that at the beginning",
    ),
    wrong(
        "5.31",
        "angle",
        "sp.atan2(k4 + k2*(T - t), k3 + k1*(T - t)) + sp.Rational(1, 100)",
        "half a degree beside",
    ),
    wrong(
        "5.35",
        "line_time",
        BORDER_35.format("rho/1000"),
        "the border of the cases is a thousandth beside",
    ),
    wrong("5.35", "line_time", BORDER_35.format("-rho/1000"), "and to the other side"),
    wrong(
        "5.35",
        "line_time",
        SMOOTH_35.format("1000"),
        "a smooth imitation of the side of the border",
    ),
    wrong("5.35", "line_time", SMOOTH_35.format("10**6"), "a steep one"),
    right(
        "5.35",
        "rest_control",
        "sp.Piecewise((sp.atan2(-y0, -x0), t < sp.sqrt(sp.sqrt(x0**2 + y0**2)/a)), "
        "(sp.atan2(y0, x0), True))",
        "the opposite direction in itself",
    ),
    wrong(
        "5.37", "b_angle", "-sp.Rational(105, 100) + g*t/(2*v0)", "exact, and not the third of pi"
    ),
    right("5.37", "b_angle", "-1.047 + 0.5*g*t/v0", "in decimals"),
    right(
        "5.39",
        "b_heading",
        "sp.atan2(Y, X) + sp.asin(w*Y/(v*sp.sqrt(X**2 + Y**2)))",
        "by the sine rule",
    ),
    wrong(
        "5.39",
        "b_heading",
        "sp.atan(Y/X) + sp.asin(w*Y/(v*sp.sqrt(X**2 + Y**2)))",
        "right for X > 0 alone",
    ),
    wrong(
        "5.39",
        "c_heading",
        "sp.atan(101*(T/2 - t)/100)",
        "one per cent: it comes back to the bank, and less far",
    ),
    wrong("5.39", "c_distance", "2*sp.asinh(T/2)", "without what the current adds"),
    right("5.43", "b_apart_type", "'saddle'", "both signs of the determinant's terms are negative"),
    wrong(
        "5.44",
        "a_rate",
        "2*omega**3 - 2*k**2*omega + 4*k*u",
        "the growth of the distance counted once more",
    ),
    wrong("5.46", "least", "sp.Abs(a)**3/6", "a half too much"),
    wrong(
        "5.47",
        "best",
        "sp.Piecewise((-1, t < sp.Rational(1, 1000)), (1, True))",
        "it turns round at first",
    ),
    right(
        "5.48",
        "family",
        "c*(1 - 4*t + 3*t**2)",
        "its integral is zero, and it stays within the bounds",
    ),
    right("5.48", "family", "[[c, sp.Rational(1, 2)], [-c, 1]]", "two arcs"),
    wrong("5.48", "family", "[[c, sp.Rational(1, 2)]]", "only the first half"),
    wrong("5.48", "family", "sp.sign(c)*(1 - 2*t)", "it begins on a bound"),
    right(
        "5.49",
        "law",
        "sp.Piecewise((1, y + s <= 1), (1, y < 0), (-1, y > 0), (0, True))",
        "four cases",
    ),
    wrong(
        "5.49",
        "law",
        "sp.Piecewise((1, s <= 1 - y), (1, y < 0), (0, True))",
        "beyond the middle it stays there",
    ),
    wrong(
        "5.49",
        "law",
        "sp.Piecewise((1, y + s <= 1), (-sp.tanh(1000*y), True))",
        "a smooth imitation",
    ),
    right("5.50", "b_control", "v*sp.cos(sp.pi*t/2)", "its integral is zero"),
    wrong("5.50", "b_control", "v*sp.cos(t)", "it does not come back"),
    right("5.54", "a_law", "-ubar*sp.sign(sp.sin(beta))", "the sine has the sign of the angle"),
    right("5.54", "b_law", "-ubar*sp.sign(sp.tan(beta/2))", "so has the tangent of the half"),
    right("5.54", "a_surface", "sp.Eq(sp.tan(beta), 0)", "zero together with the sine"),
    right("5.52", "edge", "sp.Eq(v, c)", "what is left of the drag's worth and of H = 0"),
    wrong("5.53", "glide", "m*(v1 - v2)/(a + b)", "at the drag of the speed one"),
    wrong("5.54", "a_law", "-ubar*sp.tanh(1000*beta)", "a smooth imitation"),
    right("5.55", "kelley", "-1/(b/sp.cos(alpha) - 1)", "a double fraction"),
    wrong("5.55", "law", "-ubar*sp.Max(-1, sp.Min(1, 1000*alpha))", "a steep ramp"),
    wrong(
        "5.56",
        "law",
        "-ubar*sp.sign(alpha)*sp.Heaviside(sp.Abs(alpha) - sp.Rational(1, 100))",
        "it stops turning before the line of sight",
    ),
    wrong(
        "5.57",
        "a_control",
        "[vbar*sp.sign(psi1*sp.cos(alpha) + psi2*sp.sin(alpha)), omegabar*sp.sign(psi3)]",
        "it drives backwards",
    ),
    right(
        "5.57",
        "a_greatest",
        "sp.Max(vbar*(psi1*sp.cos(alpha) + psi2*sp.sin(alpha)), 0) + omegabar*sp.sqrt(psi3**2) - 1",
        "a root for the modulus",
    ),
    wrong(
        "5.57",
        "c_spot",
        f"({TURN_57} + sp.sqrt({TURN_57}**2 + sp.Rational(1, 10**8)))/2/omegabar",
        "a smooth corner",
    ),
    wrong(
        "5.57",
        "c_spot",
        f"({TURN_57} + {TURN_57}*sp.tanh(10**4*{TURN_57}))/2/omegabar",
        "another smooth corner",
    ),
    wrong(
        "5.57",
        "c_spot",
        f"(sp.Max({TURN_57}, 0) + sp.Rational(1, 10**4))/omegabar",
        "hardly longer, everywhere",
    ),
    wrong(
        "5.57",
        "c_spot",
        f"sp.Max({TURN_57}, 0)/omegabar*(1 + sp.Rational(1, 10**4))",
        "a share longer",
    ),
    right("5.57", "c_spot", f"({TURN_57} + sp.Abs({TURN_57}))/(2*omegabar)", "by a modulus"),
    wrong(
        "5.58",
        "c_spot",
        f"sp.Max({TURN_58}, 0)/omegabar*(1 + sp.Rational(1, 10**4))",
        "a share longer",
    ),
    wrong(
        "5.58",
        "c_spot",
        f"({TURN_58} + sp.sqrt({TURN_58}**2 + sp.Rational(1, 10**8)))/2/omegabar",
        "a smooth corner",
    ),
    right("5.58", "c_duration", TIME_58.format("0"), "the cases by the angle left to turn"),
    wrong(
        "5.58",
        "c_duration",
        TIME_58.format("sp.Rational(1, 20)"),
        "it drives off while there is an angle left",
    ),
    wrong("5.59", "b_control", "-x2/sp.sqrt(2)", "right on one of the two lines alone"),
    wrong("5.59", "d_starts", "sp.Abs(b + c) <= 1", "from the border nothing leads away"),
    right(
        "5.60",
        "d_surface",
        "sp.Eq(2*k*(x*alpha - v*omega + v**2), 1 + k*x**2)",
        "H = 0 with the costates put in",
    ),
    wrong(
        "5.60",
        "d_surface",
        "sp.Eq(2*k*(x*alpha - v*omega + v**2), k*x**2)",
        "the time is not paid for",
    ),
    wrong("5.61", "d_curve", "0.45*x2**2", "one per cent off"),
    wrong("5.62", "d_leaving", "-0.4446*x2**2", "the wrong branch"),
    right(
        "5.64",
        "gain",
        f"[-((1-t) + (1-t)**2/2)/{D_64}, -(1 + (1-t)**2 + (1-t)**3/3)/{D_64}]",
        "from the time left by the Gramian",
    ),
    wrong("5.64", "cost", "(12*x10**2 + 14*x20**2)/29", "the mixed term is lost"),
    right(
        "5.66",
        "a_eigenvalues",
        "np.roots([1, 2.414213562373095, 1.414213562373095])",
        "as NumPy gives them",
    ),
    right("5.67", "b_repaired", "[-epsilon, -1 - sp.sqrt(2)*sp.sqrt(1 + epsilon)]", "two roots"),
    wrong(
        "5.67", "b_repaired", "[-epsilon, -1 - sp.sqrt(2) - epsilon/sp.sqrt(2)]", "to first order"
    ),
    wrong("5.66", "b_cost", "[[sp.sqrt(5), 2], [2, -sp.sqrt(5)]]", "the other root in one entry"),
    right("5.68", "a_cost", "[[2.83, 1], [1, 1.41]]", "three digits"),
    wrong("5.70", "controller", "[e2, -e1 - 3*e2 - 2*z]", "the measurement with the wrong sign"),
    *(
        wrong(problem, name, control, "too large for floats")
        for problem, name, large in (
            ("5.20", "control", "a*sp.exp(400*t)"),
            ("5.20", "fixed_control", "a*sp.exp(400*t)"),
            ("5.21", "a_control", "sp.exp(400*t)"),
            ("5.22", "a_control", "xi1*sp.exp(400*t)"),
            ("5.65", "control", "sp.exp(400*t)"),
        )
        for control in ("1e160", large)
    ),
    wrong("5.20", "trajectory", "[1e160*t, 1e160]", "too large for squares"),
    wrong("5.21", "a_motion", "[1e160*t**2, 2e160*t]", "too large for squares"),
    wrong("5.65", "motion", "1e160*t", "too large for squares"),
    wrong("5.65", "costate", "1e160", "too large for squares"),
]

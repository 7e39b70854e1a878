"""Chapter 5, problems 5.11 to 5.28: optimal processes with their costates, costs and laws; best
motions."""

from adversarial import right, wrong

ARCS = "sp.Piecewise((-1, t < {0}*sp.sqrt(d)), ({1}, t < {2}*sp.sqrt(d)), (1, True))"
RAMP = "-sp.Rational(3, 2) + sp.sqrt(69/d)*t/6"
THREE = (
    "sp.Piecewise((-1, sp.And(x1 > -{0}*x2*sp.Abs(x2), x1 > -{1}*x2*sp.Abs(x2))), "
    "(1, sp.And(x1 < -{0}*x2*sp.Abs(x2), x1 < -{1}*x2*sp.Abs(x2))), ({2}, True))"
)
COST = (
    "sp.Piecewise((7*b/4 + sp.sqrt(10*a + 5*b**2), sp.And(a > -2*b*sp.Abs(b), a > "
    "-b*sp.Abs(b)/2)), (-7*b/4 + sp.sqrt(-10*a + 5*b**2), sp.And(a < -2*b*sp.Abs(b), a < "
    "-b*sp.Abs(b)/2)), (sp.Abs(a/b) + {0}*sp.Abs(b), True))"
)
WITH_ENERGY = (
    "sp.Eq(sp.Piecewise((u + 1, sp.And(x1 > -{0}*x2*sp.Abs(x2), x1 > -x2*sp.Abs(x2)/2)), "
    "(u - 1, sp.And(x1 < -{0}*x2*sp.Abs(x2), x1 < -x2*sp.Abs(x2)/2)), "
    "(x1*(2 - u**2)**2 + x2**2*(4*u - 2*u**3/3) + {1}*x2*sp.Abs(x2), True)), 0)"
)

ROWS = [
    wrong(
        "5.11",
        "angular_rate",
        "-u*sp.cos(theta)**2 + sp.sin(theta)**2",
        "a sign: it would stand still somewhere",
    ),
    right("5.11", "angular_rate", "-(1 + u)/2 - (u - 1)*sp.cos(2*theta)/2", "by the double angle"),
    right("5.11", "control", "[[4, 0.5], [4, sp.pi/2]]", "one arc in two parts"),
    wrong("5.11", "trajectory", "1 - 2*t**2", "the beginning of the series"),
    right("5.11", "trajectory", "[sp.cos(2*t), -2*sp.sin(2*t)]", "both states"),
    wrong("5.11", "costate", "[sp.sin(2*t)/2, sp.cos(2*t)/4]", "the costates of -H"),
    wrong(
        "5.11",
        "costate",
        "[-1.01*sp.sin(2*t)/2, -1.01*sp.cos(2*t)/4]",
        "one per cent off: H is not zero",
    ),
    right("5.11", "switching", "(1 + sp.cos(4*t))/8", "by the double angle"),
    wrong("5.11", "meeting", "(n + 1)*sp.pi/2", "the start is number 0"),
    wrong("5.12", "time", "sp.Rational(11, 14)", "exact, and not pi/4"),
    right("5.12", "latest", "2*sp.atan(1)", "by an arc tangent"),
    wrong("5.13", "costate", "[-sp.sin(t), -sp.cos(t)]", "those for the cost t_k"),
    wrong("5.13", "switching", "sp.cos(t)**2", "that for the cost t_k"),
    right("5.13", "switching", "sp.sin(t)**2 - 1", "by the sine"),
    wrong(
        "5.14",
        "control",
        "u_max + (u_min - u_max)*(1 + sp.tanh(1000*(t - sp.pi/(2*sp.sqrt(u_max)))))/2",
        "it goes over by and by",
    ),
    right(
        "5.14",
        "control",
        "(u_max + u_min)/2 + (u_max - u_min)/2*sp.sign(sp.pi/2 - t*sp.sqrt(u_max))",
        "a sign",
    ),
    right(
        "5.14",
        "control",
        "sp.Piecewise((u_max, 4*u_max*t**2 < sp.pi**2), (u_min, True))",
        "squared",
    ),
    wrong(
        "5.14",
        "trajectory",
        "sp.Piecewise((sp.cos(t*sp.sqrt(u_max)), t < sp.pi/(2*sp.sqrt(u_max))), "
        "(-sp.sin(sp.sqrt(u_min)*(t - sp.pi/(2*sp.sqrt(u_max)))), True))",
        "the velocity jumps",
    ),
    wrong(
        "5.14", "duration", "sp.pi/(sp.sqrt(u_min) + sp.sqrt(u_max))", "a mean of the frequencies"
    ),
    right("5.14", "cost", "-sp.exp((sp.log(u_max) - sp.log(u_min))/2)", "by logarithms"),
    wrong(
        "5.15",
        "control",
        "sp.Piecewise((u_max, t < sp.pi/(2*sp.sqrt(u_max))), (u_min, True))",
        "that of the farthest swing",
    ),
    wrong(
        "5.15",
        "trajectory",
        "sp.Piecewise((sp.sin(t*sp.sqrt(u_min)), t < sp.pi/(2*sp.sqrt(u_min))), "
        "(sp.cos(sp.sqrt(u_max)*(t - sp.pi/(2*sp.sqrt(u_min)))), True))",
        "an amplitude of one",
    ),
    wrong("5.16", "a_costate", "[5.05*sp.cos(t), -5.05*sp.sin(t)]", "one per cent off at the end"),
    wrong(
        "5.16",
        "a_costate",
        "[4*sp.cos(t), -4*sp.sin(t)]",
        "the amplitude is not the place at the end",
    ),
    right("5.16", "a_costate", "[-5*sp.cos(t + sp.pi), 5*sp.sin(t + sp.pi)]", "by a shifted angle"),
    right(
        "5.16",
        "b_control",
        "-sp.sign(sp.sin(t))",
        "the sign of a sine, constant as far as the time goes",
    ),
    wrong("5.16", "b_costate", "[-5*sp.cos(t), 5*sp.sin(t)]", "the costates of -H"),
    wrong(
        "5.17",
        "a_control",
        "-sp.sign(x0)*(1 + sp.tanh(1000*(sp.Abs(x0) - t)))/2",
        "it goes over by and by",
    ),
    right("5.17", "a_control", "-(sp.sign(x0 - t) + sp.sign(x0 + t))/2", "by two signs"),
    wrong("5.17", "a_trajectory", "sp.sign(x0)*(sp.Abs(x0) - t)", "through zero and on"),
    right(
        "5.17",
        "a_trajectory",
        "(x0 + sp.sign(x0)*sp.Abs(sp.Abs(x0) - t) - sp.sign(x0)*t)/2",
        "by a modulus",
    ),
    wrong("5.17", "a_cost", "sp.Abs(x0)**3/6", "the time may not suffice"),
    right(
        "5.17",
        "a_cost",
        "sp.Abs(x0)**3/6 - sp.Max(0, sp.Abs(x0) - T)**3/6",
        "by the part that is left",
    ),
    wrong(
        "5.17",
        "a_costate",
        "sp.Piecewise((-(sp.Abs(x0) - t)**2*sp.sign(x0)/2, t < sp.Abs(x0)), (0, True))",
        "not zero at the end where the time does not suffice",
    ),
    wrong(
        "5.17",
        "b_law",
        "sp.Piecewise((-1.01*x*sp.tanh(T - t), 1.01*sp.Abs(x)*sp.tanh(T - t) <= 1), "
        "(-sp.sign(x), True))",
        "one per cent too strong",
    ),
    wrong(
        "5.17",
        "b_law",
        "sp.Piecewise((-x*sp.tanh(T - t), sp.Abs(x) <= 1), (-sp.sign(x), True))",
        "the bound is reached at another place",
    ),
    right(
        "5.17",
        "b_law",
        "-sp.sign(x)*sp.Min(1, sp.Abs(x)*sp.tanh(T - t))",
        "by the sign and the smaller one",
    ),
    right(
        "5.17",
        "b_law",
        "sp.Piecewise((-1.0*x*sp.tanh(T - t), sp.Abs(x)*sp.tanh(T - t) <= 1), (-sp.sign(x), True))",
        "in decimals",
    ),
    wrong("5.17", "b_control", "-x0*sp.sinh(T - t)/sp.sinh(T)", "the motion would end at zero"),
    right(
        "5.17", "b_trajectory", "x0*(sp.cosh(t) - sp.tanh(T)*sp.sinh(t))", "by the sum of arguments"
    ),
    wrong("5.18", "trajectory", "0.51*t**2 + 0.49*t", "more than the force allows"),
    wrong("5.18", "cost", "-1.61", "one per cent off"),
    wrong("5.18", "costate", "[-1.52, 1.52*t]", "one per cent off at the end"),
    right("5.18", "costate", "sp.Matrix([-3, 3*t])/2", "a column"),
    wrong("5.19", "control", "sp.tanh(1000*(t - sp.Rational(1, 2)))", "it goes over by and by"),
    wrong("5.19", "costate", "[-1, t - 0.505]", "its zero is one per cent late"),
    wrong("5.19", "costate", "[-1.01, 1.01*t - 0.505]", "one per cent too large"),
    right("5.19", "costate", "[-1, t - 0.5]", "in decimals"),
    right(
        "5.19",
        "trajectory",
        "-t**2/2 + sp.Max(0, t - sp.Rational(1, 2))**2",
        "the larger one of two",
    ),
    right(
        "5.19",
        "trajectory",
        "-t**2/2 + (t - sp.Rational(1, 2))**2*sp.Heaviside(t - sp.Rational(1, 2))",
        "a step",
    ),
    right(
        "5.19",
        "trajectory",
        "t**2/2*sp.sign(2*t - 1) - (t - sp.Rational(1, 4))*(1 + sp.sign(2*t - 1))/2",
        "a sign",
    ),
    wrong(
        "5.19",
        "trajectory",
        "-t**2/2 + sp.Heaviside(t - sp.Rational(1, 2))*(t - sp.Rational(1, 2))",
        "the velocity jumps",
    ),
    wrong(
        "5.19",
        "trajectory",
        "-t**2/2 + (t - sp.Rational(1, 2))**2*sp.Heaviside(t - sp.Rational(1, 2)) + "
        "sp.Heaviside(t - sp.Rational(1, 2))/10",
        "the place jumps",
    ),
    wrong("5.20", "control", "4*sp.Abs(a)*sp.cos(t)/sp.pi", "wrong for places on the other side"),
    wrong(
        "5.20", "costate", "[4*a*sp.sin(t)/sp.pi, 4*a*sp.cos(t)/sp.pi]", "those of half the cost"
    ),
    wrong("5.20", "costate", "[2.58*a*sp.sin(t), 2.58*a*sp.cos(t)]", "one per cent off"),
    right("5.20", "costate", "[2.55*a*sp.sin(t), 2.55*a*sp.cos(t)]", "8/pi to three digits"),
    wrong(
        "5.20",
        "fixed_control",
        "4*a*(sp.pi*sp.cos(t) - 2.04*sp.sin(t))/(sp.pi**2 - 4)",
        "two per cent in one term",
    ),
    right(
        "5.20",
        "fixed_control",
        "4*a*sp.sqrt(sp.pi**2 + 4)*sp.cos(t + sp.atan(2/sp.pi))/(sp.pi**2 - 4)",
        "one cosine",
    ),
    wrong("5.21", "a_motion", "3*t**2/T**2 - 2*t**3/T**3", "at rest at the end"),
    wrong("5.21", "b_still", "1.515", "one per cent off"),
    wrong(
        "5.21",
        "d_effort",
        "2*(V**2*T**2 - 3*sp.Abs(V*X)*T + 3*X**2)/T**3",
        "ends to one side alone",
    ),
    right("5.21", "d_effort", "6*(X - V*T/2)**2/T**3 + V**2/(2*T)", "a sum of squares"),
    wrong("5.22", "general_control", "xi/(beta*T)", "that of alpha = 0"),
    right(
        "5.22",
        "general_control",
        "2*alpha*xi*sp.exp(-alpha*(t + T))/(beta*(1 - sp.exp(-2*alpha*T)))",
        "multiplied by the exponential",
    ),
    wrong("5.22", "general_exists", "sp.Ne(k**2, 1)", "k = -1 is controllable"),
    right("5.22", "general_exists", "sp.Ne(k**3, 1)", "one real root"),
    wrong("5.22", "a_energy", "6*xi1**2 - 6*xi1*xi2 + 2*xi2**2", "the half of it"),
    right("5.22", "a_energy", "3*(2*xi1 - xi2)**2 + xi2**2", "a sum of squares"),
    wrong("5.22", "b_gramian", "[[sp.pi, 0.05], [0.05, sp.pi]]", "not diagonal"),
    right("5.22", "b_control", "0.3183*(xi2*sp.cos(t) - xi1*sp.sin(t))", "1/pi to four digits"),
    wrong("5.22", "c_energy", "xi**2/(1 - sp.exp(-2))", "one tank's share"),
    right("5.22", "c_energy", "xi**2*(1 + sp.coth(1))", "by a hyperbolic cotangent"),
    wrong("5.23", "costate", "[t - 2.02, -t**2/2 + 3*t - 2.5]", "not zero at the end"),
    wrong(
        "5.23",
        "costate",
        "[t - 2, -t**2/2 + 3*t - 2]",
        "its zero is not where the control switches",
    ),
    right("5.23", "costate", "[t - 2, 2 - (t - 3)**2/2]", "a completed square"),
    wrong("5.23", "control", "sp.tanh(1000*(t - 1))", "it goes over by and by"),
    right("5.23", "trajectory", "-t**2/2 + sp.Max(0, t - 1)**2", "the larger one of two"),
    wrong("5.24", "a_motion", "1.01 - 3*sp.cos(t)", "it starts beside -2"),
    right(
        "5.24",
        "a_control",
        "sp.sign(sp.sin(t))",
        "the sign of a sine, constant as far as the time goes",
    ),
    wrong("5.24", "c_costate", "[sp.cos(t), -sp.sin(t)]", "those for x(t_k) to be small"),
    right(
        "5.24", "c_costate", "[sp.cos(sp.pi - t), sp.sin(sp.pi - t)]", "counted back from the end"
    ),
    wrong("5.25", "law", THREE.format("2", "0.51", "0"), "two per cent off: it brakes too early"),
    wrong("5.25", "law", THREE.format("2", "0.5", "0.01"), "a little force while it drifts"),
    right(
        "5.25",
        "law",
        "1 - sp.Heaviside(x1 + 2*x2*sp.Abs(x2)) - sp.Heaviside(x1 + x2*sp.Abs(x2)/2)",
        "two steps",
    ),
    wrong(
        "5.25",
        "control",
        "(sp.tanh(1000*(t - sp.sqrt(10*d)/5)) + sp.tanh(1000*(t - sp.sqrt(10*d)/2)))/2",
        "it goes over by and by",
    ),
    right(
        "5.25",
        "control",
        "[[-1, 0.632*sp.sqrt(d)], [0, 1.58*sp.sqrt(d)], [1, 2.21*sp.sqrt(d)]]",
        "three digits",
    ),
    wrong("5.25", "cost", COST.format("sp.Rational(7, 4)"), "the drifting is paid as the drive is"),
    right("5.25", "cost", COST.format("1.25"), "a decimal"),
    wrong(
        "5.25",
        "costate",
        "[-sp.sqrt(10/d)/2, sp.sqrt(10/d)*t/2 - 1.78]",
        "two per cent off in one term",
    ),
    wrong(
        "5.26",
        "control",
        ARCS.format("0.365", RAMP, "5*sp.sqrt(69)/23"),
        "it leaves the bound one per cent late",
    ),
    wrong(
        "5.26",
        "control",
        ARCS.format("0.357", RAMP, "1.806"),
        "it leaves the bound one per cent early",
    ),
    wrong(
        "5.26",
        "control",
        ARCS.format("0.361", "-1.5 + 1.40*t/sp.sqrt(d)", "1.806"),
        "one per cent too steep",
    ),
    right(
        "5.26",
        "control",
        ARCS.format("0.361", "-1.5 + 1.38*t/sp.sqrt(d)", "1.81"),
        "three digits everywhere",
    ),
    right("5.26", "control", f"sp.Max(-1, sp.Min(1, {RAMP}))", "between the bounds by Max and Min"),
    wrong(
        "5.26",
        "law",
        WITH_ENERGY.format("sp.Rational(43, 6)", "3.87"),
        "one per cent off in one term",
    ),
    right("5.26", "law", WITH_ENERGY.format("7.17", "3.83"), "three digits"),
    wrong("5.26", "costate", "[-1.4/sp.sqrt(d), 1.4*t/sp.sqrt(d) - 1.5]", "one per cent off"),
    right("5.26", "costate", "[-1.38/sp.sqrt(d), 1.38*t/sp.sqrt(d) - 1.5]", "three digits"),
    wrong("5.27", "a_motion", "2.745**t", "one per cent off"),
    wrong("5.27", "a_motion", "2.69**t", "one per cent off"),
    wrong("5.27", "a_motion", "1 + t + t**2/2 + t**3/6 + t**4/24", "the beginning of the series"),
    wrong("5.27", "a_motion", "sp.cosh(t) + 1.01*sp.sinh(t)", "one per cent off"),
    right("5.27", "a_motion", "sp.cosh(t) + sp.sinh(t)", "hyperbolic functions"),
    wrong("5.27", "b_motion", "sp.sqrt(1 - 0.99*t)", "one per cent off: it ends beside zero"),
    right("5.27", "b_motion", "sp.exp(sp.log(1 - t)/2)", "by a logarithm"),
    wrong("5.27", "b_other_motion", "sp.sqrt(1 + 2.02*t)", "one per cent off"),
    wrong(
        "5.27", "c_motion", "-0.255*t**2 + t*(1.02*T**2 + 8)/(4*T)", "two per cent off in one term"
    ),
    right("5.27", "c_motion", "-0.25*t**2 + 0.25*T*t + 2.0*t/T", "in decimals"),
    right("5.27", "c_value", "4/T - T - 0.0208*T**3", "1/48 to three digits"),
    wrong("5.27", "d_motion", "0.0421*(t - t**4)", "one per cent off"),
    right("5.27", "d_motion", "0.0417*(t - t**4)", "1/24 to three digits"),
    wrong("5.28", "a_costate", "[48 - 48*t, -24*(1 - t)**2]", "a sign"),
    right("5.28", "a_motion", "(t - 1)**4 + 4*t - 1", "about the end"),
    wrong(
        "5.28",
        "b_motion",
        "1.27*sp.sin(t) - 0.5*sp.cos(t) - 0.27*sp.sinh(t) + 0.5*sp.cosh(t)",
        "one per cent off",
    ),
    right(
        "5.28",
        "b_motion",
        "1.26*sp.sin(t) - 0.5*sp.cos(t) - 0.259*sp.sinh(t) + 0.5*sp.cosh(t)",
        "three digits",
    ),
    right("5.28", "b_value", "sp.sech(sp.pi/2) - 2", "a hyperbolic secant"),
    wrong(
        "5.28",
        "c_motion",
        "2*(3*t**2/T**2 - 2*t**3/T**3)",
        "the motion of the effort alone, at rest at the end",
    ),
    # The value of the first or last arc is taken at once.
    wrong("5.12", "control", "4*sp.tanh(1000*t)", "it comes to the bound by and by"),
    wrong(
        "5.12",
        "control",
        "1 + 3*sp.tanh(1000*t)",
        "it comes to the bound by and by, within the bounds",
    ),
    right("5.12", "control", "4*sp.Heaviside(t)", "a step at the start"),
    wrong("5.16", "b_control", "-sp.tanh(1000*t)", "it comes to the bound by and by"),
    wrong("5.16", "b_control", "-1 + sp.exp(-1000*t)", "it comes to the bound by and by"),
    wrong("5.16", "b_control", "-sp.tanh(1000*(sp.pi - t))", "it leaves the bound before the end"),
    right(
        "5.11",
        "control",
        "[[4, 1.6]]",
        "an arc that goes on behind the end, as the constant 4 does",
    ),
    wrong("5.11", "control", "[[4, 1.55]]", "one per cent short: the spring is not back yet"),
    right("5.24", "b_control", "sp.sign(sp.sin(t))", "it changes at the end itself"),
    right(
        "5.24", "a_control", "sp.Piecewise((1, t < 4), (sp.nan, True))", "not defined after the end"
    ),
    right(
        "5.24",
        "a_motion",
        "sp.Piecewise((1 - 3*sp.cos(t), t < 4), (sp.nan, True))",
        "not defined after the end",
    ),
    wrong(
        "5.24",
        "a_motion",
        "sp.Piecewise((1 - 3*sp.cos(t), t < 2), (sp.nan, True))",
        "not defined on the way",
    ),
    wrong(
        "5.26",
        "law",
        WITH_ENERGY.format("7.0", "sp.Rational(23, 6)"),
        "two per cent off, at a mere bend",
    ),
    right("5.26", "law", WITH_ENERGY.format("7.17", "sp.Rational(23, 6)"), "43/6 to three digits"),
    right(
        "5.17",
        "a_control",
        "[[-sp.sign(x0), sp.Abs(x0)], [0, T]]",
        "the first arc ends after T from far away: what comes after the end does not count",
    ),
    right(
        "5.17",
        "a_control",
        "[[-sp.sign(x0), sp.Min(sp.Abs(x0), T)], [0, T]]",
        "the second arc has no length from far away",
    ),
    wrong("5.17", "a_control", "[[-sp.sign(x0), sp.Abs(x0)], [0, T/2]]", "it ends too early"),
    wrong("5.17", "a_control", "[[-sp.sign(x0), 2*sp.Abs(x0)], [0, T]]", "it goes too far"),
]

"""Chapter 4: estimation."""

from adversarial import right, wrong

ROWS = [
    wrong("4.1", "b_determined", "sp.Ne(h**2, k**2)", "h = -k is determined"),
    wrong(
        "4.1",
        "c_determined",
        "sp.Ne(x[0]/a + x[1]/b + x[2]/c, 0)",
        "this plane goes through the centre",
    ),
    wrong(
        "4.1",
        "d_unseen",
        "[[b*x[2]**2, a*x[2]**2, x[2]*(a*b - a*x[1] - b*x[0])]]",
        "zero for x3 = 0",
    ),
    wrong("4.1", "e_determined", "sp.Ne(p*(3*p - 1), 0)", "the origin helps too"),
    right("4.1", "b_determined", "sp.Abs(h - k) > 0", "a difference of heights"),
    right("4.1", "c_determined", "(x[0]/a + x[1]/b + x[2]/c - 1)**2 > 0", "beside the plane"),
    right("4.1", "a_unseen", "[[0, 0, -2]]", "the opposite one"),
    right("4.1", "a_unseen", "np.array([[0, 0, 1.]])", "an array"),
    wrong("4.1", "a_unseen", "[[0, 0, 1], [1, 0, 0]]", "the second is seen"),
    wrong("4.1", "a_unseen", "[[0, 0.01, 1]]", "seen, if a little"),
    wrong("4.1", "a_unseen", "[]", "a vertical one is not seen"),
    wrong("4.1", "b_determined", "sp.Or(sp.Ne(h, 0), sp.Ne(k, 0))", "the claim of the book"),
    wrong("4.1", "b_determined", "h > k", "from above too"),
    wrong(
        "4.1",
        "c_determined",
        "sp.And(sp.Ne(x[0]/a + x[1]/b + x[2]/c, 1), sp.Ne(x[0], 0))",
        "x1 = 0 is no obstacle",
    ),
    wrong("4.1", "c_determined", "x[0]/a + x[1]/b + x[2]/c > 1", "below the plane too"),
    wrong(
        "4.1",
        "c_determined",
        "sp.Ne(x[0] + x[1] + x[2], 1)",
        "the satellites are not at the distance 1",
    ),
    right("4.1", "d_unseen", "[[x[2]/a, x[2]/b, 1 - x[0]/a - x[1]/b]]", "divided by a*b"),
    wrong(
        "4.1", "d_unseen", "[[b*x[2], a*x[2], a*b - a*x[0] - b*x[1]]]", "two coordinates exchanged"
    ),
    right("4.1", "e_determined", "sp.Abs(3*p - 1) > 0", "a modulus"),
    right("4.1", "e_determined", "sp.Ne(p, 0.333)", "three digits"),
    wrong("4.1", "e_determined", "sp.Ne(p, 0.34)", "another number"),
    wrong("4.1", "e_determined", "sp.And(sp.Ne(3*p, 1), sp.Ne(p, 1))", "p = 1 helps"),
    wrong("4.1", "a_unseen", "[[0, 0.004, 1]]", "seen, if a little"),
    wrong("4.1", "d_unseen", "[[1.01*b*x[2], a*x[2], a*b - a*x[1] - b*x[0]]]", "one per cent"),
    wrong("4.2", "b_real", "q >= 2.64", "the border is 8/3"),
    right("4.2", "b_real", "q >= 2.67", "8/3 to three digits"),
    right("4.2", "a_zero", "h**2 > 0", "a square"),
    right(
        "4.2",
        "b_fixes",
        "[(2 + sp.sqrt(3*q - 8))/3, (2 - sp.sqrt(3*q - 8))/3]",
        "over one denominator",
    ),
    right(
        "4.2",
        "b_fixes",
        "[0.667 + 0.333*sp.sqrt(3*q - 8), 0.667 - 0.333*sp.sqrt(3*q - 8)]",
        "three digits",
    ),
    wrong("4.2", "b_fixes", "[(2 + sp.sqrt(3*q - 8))/3]", "one of two"),
    wrong("4.2", "b_fixes", "[(2 + sp.sqrt(3*q - 9))/3, (2 - sp.sqrt(3*q - 9))/3]", "9 for 8"),
    wrong("4.2", "b_real", "q > sp.Rational(8, 3)", "a double root is real"),
    right("4.2", "b_real", "sp.Interval(sp.Rational(8, 3), sp.oo)", "as a set"),
    right("4.2", "c_other", "256*(a - sp.Rational(4, 3))**2", "a square"),
    right("4.2", "c_other", "28.4*(3*a - 4)**2", "three digits"),
    wrong("4.2", "c_other", "28.9*(3*a - 4)**2", "28.9 for 28.4"),
    wrong("4.2", "c_other", "256*(3*a - 4)/9", "the square is lost"),
    right("4.2", "d_slope", "4*e4*(3*p - 1)*(x[0]**2 + x[1]**2 + x[2]**2)", "factored"),
    wrong("4.2", "d_slope", "4*e4*(1 - 3*p)*(x[0]**2 + x[1]**2 + x[2]**2)", "a sign"),
    wrong(
        "4.2",
        "d_slope",
        "4*e4*(3*p - 1)*sp.sqrt(x[0]**2 + x[1]**2 + x[2]**2)",
        "the square is lost",
    ),
    right("4.2", "e_sum", "0.694", "three digits"),
    wrong("4.2", "e_sum", "0.69", "two digits"),
    wrong("4.2", "e_least", "0.0735", "a digit"),
    right("4.2", "e_least", "0.074", "0.0740 to three digits"),
    wrong("4.2", "d_slope", "4.04*e4*(3*p - 1)*(x[0]**2 + x[1]**2 + x[2]**2)", "one per cent"),
    wrong(
        "4.2", "b_fixes", "[(2 + sp.sqrt(3*q - 8))/3, (2.02 - sp.sqrt(3*q - 8))/3]", "one per cent"
    ),
    wrong("4.3", "determined", "sp.Ne(v*x[1]*x[2], 0)", "one of the two is enough"),
    right("4.3", "determined", "v**2*(x[1]**2 + x[2]**2) > 0", "a sum of squares"),
    wrong("4.3", "determined", "sp.And(v > 0, x[1]**2 + x[2]**2 > 0)", "backwards too"),
    wrong("4.3", "unseen", "[[1, 0.01, 0]]", "seen, if a little"),
    wrong("4.3", "unseen", "[[x[0], 0, 0], [v, 0, 0]]", "twice the same"),
    right("4.3", "moving", "[[-x[0], -x[1], 0, v, 0, 0]]", "the opposite"),
    wrong("4.3", "moving", "[[x[0], x[1], 0, v, 0, 0]]", "a sign"),
    wrong("4.3", "moving", "[[x[0], x[1], 0, -v, 0, 0], [0, 0, 1, 0, 0, 0]]", "height is seen"),
    wrong("4.3", "moving", "[[x[0], 1.01*x[1], 0, -v, 0, 0]]", "one per cent"),
    wrong("4.3", "unseen", "[[1.0, 0.004, 0]]", "seen a little"),
    right("4.4", "before_deviations", "[18.3, 0.0316]", "three digits"),
    right(
        "4.4", "before_deviations", "[sp.sqrt(sp.Rational(1000, 3)), 1/sp.sqrt(1000)]", "as roots"
    ),
    wrong("4.4", "before_deviations", "[18.2, 0.0316]", "a digit"),
    wrong("4.4", "before_deviations", "[333.3, 0.001]", "the variances"),
    wrong("4.4", "correction", "[T*z/2, z]", "a perfect measurement"),
    right("4.4", "correction", "[T*z/(2*(1 + R/(Q*T))), z/(1 + R/(Q*T))]", "divided"),
    wrong("4.4", "correction", "[-Q*T**2*z/(2*(Q*T + R)), -Q*T*z/(Q*T + R)]", "a sign"),
    wrong(
        "4.4",
        "after",
        "[[Q*T**3*(Q*T + 4*R)/(12*(Q*T + R)), Q*R*T**2/(2*(Q*T + R))], [Q*R*T**2/(Q*T + R), "
        "Q*R*T/(Q*T + R)]]",
        "not symmetric",
    ),
    wrong(
        "4.4",
        "after",
        "[[Q*T**3/3, Q*R*T**2/(2*(Q*T + R))], [Q*R*T**2/(2*(Q*T + R)), Q*R*T/(Q*T + R)]]",
        "the place is not corrected",
    ),
    right(
        "4.4",
        "after",
        "(lambda P: P - P[:, 1]*P[1, :]/(P[1, 1] + R))(sp.Matrix([[Q*T**3/3, Q*T**2/2], [Q*T**2/2, "
        "Q*T]]))",
        "not simplified",
    ),
    right("4.4", "after_deviations", "[9.14, 0.001]", "three digits"),
    wrong("4.4", "after_deviations", "[9.13, 0.001]", "a digit"),
    wrong("4.4", "before", "[[Q*T**3/3, Q*T**2/2], [Q*T**2/3, Q*T]]", "not symmetric"),
    right(
        "4.4",
        "before",
        "[[Q*sp.Integral(sp.Symbol('s')**2, (sp.Symbol('s'), 0, T)), Q*T**2/2], [Q*T**2/2, Q*T]]",
        "an integral",
    ),
    wrong("4.4", "correction", "[sp.Rational(3, 2)*z/T, z]", "the other way"),
    wrong("4.4", "after_deviations", "[9.14, 0.00101]", "one per cent"),
    right("4.5", "covariance", "sp.cos(2*alpha) - sp.sin(2*alpha)", "a difference"),
    right("4.5", "covariance", "1.41*sp.cos(2*alpha + 0.785)", "three digits"),
    wrong("4.5", "covariance", "1.4*sp.cos(2*alpha + 0.785)", "two digits"),
    wrong("4.5", "covariance", "sp.cos(2*alpha) + sp.sin(2*alpha)", "a sign"),
    wrong("4.5", "variance", "4 + sp.cos(2*alpha) - sp.sin(2*alpha)", "that of the other one"),
    right("4.5", "variance", "3 + 2*sp.cos(alpha)**2 + sp.sin(2*alpha)", "half the angle"),
    right("4.5", "angles", "[0.393, 1.96]", "three digits"),
    right(
        "4.5",
        "angles",
        "sp.FiniteSet(sp.atan(sp.sqrt(2) - 1), sp.pi/2 + sp.atan(sp.sqrt(2) - 1))",
        "by the tangent",
    ),
    wrong("4.5", "angles", "[0.39, 1.96]", "two digits"),
    wrong("4.5", "angles", "[sp.pi/8, 5*sp.pi/8, 9*sp.pi/8]", "beyond pi"),
    wrong("4.5", "angles", "[sp.pi/8, 3*sp.pi/8]", "the second is another"),
    wrong("4.5", "variance", "4.04 + sp.cos(2*alpha) + sp.sin(2*alpha)", "one per cent"),
    wrong("4.6", "covariance", "-6.55", "a digit"),
    wrong("4.6", "covariance", "sp.Rational(13, 2)", "a sign"),
    right("4.6", "covariance", "np.float64(-6.5)", "a NumPy number"),
    wrong("4.7", "covariance", "1", "a sign"),
    right("4.7", "correlation", "-0.0604", "three digits"),
    wrong("4.7", "correlation", "-0.06", "two digits"),
    wrong("4.7", "correlation", "-1/sp.sqrt(137)", "one deviation is lost"),
    right("4.7", "correlation", "-1/sp.sqrt(sp.Integer(274))", "a root"),
    wrong("4.8", "correlation", "0.32", "two digits"),
    right("4.8", "correlation", "0.316", "three digits"),
    wrong("4.8", "covariance", "sp.Rational(1, 3)", "the means are not taken off"),
    right("4.8", "means", "np.array([1/3, 2/3, 1/3, 2/3])", "an array"),
    wrong(
        "4.8",
        "means",
        "[sp.Rational(1, 3), sp.Rational(2, 3), sp.Rational(1, 3), sp.Rational(1, 3)]",
        "the last",
    ),
    right(
        "4.8",
        "means",
        "(sp.Rational(1, 3), sp.Rational(2, 3), sp.Rational(1, 3), sp.Rational(2, 3))",
        "a tuple",
    ),
    wrong("4.8", "means", "[0.333, 0.667, 0.333, 0.674]", "one per cent"),
    wrong("4.9", "matrix", "[[7, -8.5], [8.5, 16]]", "not symmetric"),
    right("4.9", "matrix", "np.array([[7, -8.5], [-8.5, 16]])", "an array"),
    wrong("4.9", "matrix", "[[6, -8.5], [-8.5, 18]]", "the covariances of x are left out"),
    wrong("4.9", "covariance", "-8", "half is lost"),
    right("4.10", "estimate", "[1.14, 1.29]", "three digits"),
    wrong("4.10", "estimate", "[1.14, 1.28]", "a digit"),
    wrong("4.10", "estimate", "[1.1, 1.3]", "two digits"),
    wrong("4.10", "least", "0.29", "two digits"),
    right("4.10", "least", "0.286", "three digits"),
    wrong("4.10", "least", "sp.sqrt(sp.Rational(2, 7))", "the root of it"),
    right("4.10", "estimate", "{x1: sp.Rational(8, 7), x2: sp.Rational(9, 7)}", "by name"),
    wrong("4.11", "estimate", "[1, sp.Rational(4, 3)]", "exchanged"),
    right("4.11", "estimate", "{a: 4/3, b: 1}", "by name"),
    wrong("4.11", "first_two", "[2, 1]", "a sign"),
    right("4.12", "estimate", "np.array([[0.962], [0.615]])", "a column"),
    wrong("4.12", "estimate", "[0.96, 0.615]", "two digits"),
    wrong("4.12", "least", "0.077", "two digits"),
    right("4.12", "least", "0.0769", "three digits"),
    wrong("4.13", "covariance", "[[1.15, -0.3], [0.3, 0.1]]", "not symmetric"),
    wrong(
        "4.13",
        "covariance",
        "[[sp.Rational(1, 4), 0], [0, sp.Rational(1, 10)]]",
        "about the middle",
    ),
    right("4.13", "covariance", "[[1.15, -0.3], [-0.3, 0.1]]", "decimals"),
    wrong("4.13", "estimate", "[-0.95, 0.89]", "a digit"),
    wrong("4.13", "estimate", "[-0.96, 0.9]", "one per cent"),
    right("4.14", "covariance", "[[2.17, -1], [-1, 0.5]]", "three digits"),
    wrong("4.14", "covariance", "[[2.2, -1], [-1, 0.5]]", "two digits"),
    wrong(
        "4.14",
        "covariance",
        "[[sp.Rational(7, 3), -1], [-1, sp.Rational(1, 2)]]",
        "without weights",
    ),
    right("4.14", "weighted", "[0.667*c - 1.33, 1]", "three digits"),
    wrong("4.14", "weighted", "[(c - 2)/2, 1]", "the weight 2 for 4"),
    wrong("4.14", "plain", "[(c - 2)/3, 1 + (c - 2)/10**4]", "the slope does not know c"),
    wrong("4.15", "settles", "sp.And(a < 0, sp.Ne(a, -1))", "a = -1 settles"),
    wrong("4.15", "rises", "P0 < -Q/(2*a)", "for a > 0 it rises from every start"),
    right("4.15", "settles", "sp.exp(a) < 1", "the exponential is monotonic"),
    right(
        "4.15", "rises", "sp.Or(P0 < Q/(2*sp.Abs(a)), a >= 0)", "below the limit, or without one"
    ),
    right("4.15", "limit", "sp.sqrt(Q**2/(4*a**2))", "the root of the square"),
    right("4.15", "mean", "mu0*(sp.cosh(a*t) + sp.sinh(a*t))", "hyperbolic"),
    right("4.15", "variance", "P0*sp.exp(2*a*t) + Q*sp.exp(a*t)*sp.sinh(a*t)/a", "hyperbolic"),
    right(
        "4.15",
        "variance",
        "P0*sp.exp(2*a*t) + sp.Integral(Q*sp.exp(2*a*sp.Symbol('s')), (sp.Symbol('s'), 0, t))",
        "an integral",
    ),
    right(
        "4.15",
        "variance",
        "sp.Piecewise((P0 + Q*t, sp.Eq(a, 0)), (P0*sp.exp(2*a*t) + Q*(sp.exp(2*a*t) - 1)/(2*a), "
        "True))",
        "by cases",
    ),
    wrong("4.15", "variance", "P0*sp.exp(2*a*t) + Q*(sp.exp(2*a*t) - 1)/a", "the half is lost"),
    wrong(
        "4.15",
        "variance",
        "P0*sp.exp(a*t) + Q*(sp.exp(2*a*t) - 1)/(2*a)",
        "the start decays like the mean",
    ),
    wrong(
        "4.15",
        "variance",
        "P0*sp.exp(2*a*t) + Q*(sp.exp(2*a*t) - 1)/(2*sp.Abs(a))",
        "a may be negative",
    ),
    wrong("4.15", "wiener", "P0 + Q*t**2", "like a constant error"),
    right("4.15", "wiener", "P0 + sp.Integral(Q, (sp.Symbol('s'), 0, t))", "an integral"),
    wrong("4.15", "settles", "sp.And(a < 0, a > -1000)", "faster ones too"),
    wrong("4.15", "settles", "a <= 0", "a Wiener process does not settle"),
    right("4.15", "settles", "sp.Interval.open(-sp.oo, 0)", "as a set"),
    wrong("4.15", "limit", "Q/(2*a)", "negative"),
    wrong("4.15", "limit", "-Q/a", "the half is lost"),
    right("4.15", "rises", "sp.Or(a >= 0, P0 < -Q/(2*a))", "by cases"),
    wrong("4.15", "rises", "2*a*P0 + Q >= 0", "at the limit it stays"),
    wrong("4.15", "rises", "sp.Or(a > 0, P0 < -Q/(2*a))", "a = 0 rises too"),
    wrong(
        "4.15",
        "rises",
        "sp.Or(sp.And(2*a*P0 + Q > 0, P0 > 0), sp.And(a > 0, sp.Eq(P0, 0)))",
        "from zero it rises always",
    ),
    wrong("4.15", "settles", "sp.And(a < 0, sp.Ne(a, -sp.sqrt(2)))", "an irrational point"),
    right(
        "4.15",
        "variance",
        "sp.Lambda(t, P0*sp.exp(2*a*t) + Q*(sp.exp(2*a*t) - 1)/(2*a))",
        "a Lambda",
    ),
    right(
        "4.15", "variance", "P0*sp.exp(2*a*t) + Q*sp.tanh(a*t)/(a*(1 - sp.tanh(a*t)))", "by tanh"
    ),
    wrong("4.15", "variance", "P0*sp.exp(2*a*t) + Q*(sp.exp(2.02*a*t) - 1)/(2*a)", "one per cent"),
    right(
        "4.16",
        "mean",
        "sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]])*sp.Matrix([mu1, mu2])",
        "a rotation",
    ),
    wrong(
        "4.16", "mean", "[mu1*sp.cos(t) + mu2*sp.sin(t), mu1*sp.sin(t) + mu2*sp.cos(t)]", "a sign"
    ),
    right(
        "4.16",
        "covariance",
        "(lambda F: F*P0*F.T + Q*sp.Matrix([[t/2 - sp.sin(2*t)/4, sp.sin(t)**2/2], "
        "[sp.sin(t)**2/2, t/2 +"
        " sp.sin(2*t)/4]]))(sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]]))",
        "a product",
    ),
    wrong(
        "4.16",
        "covariance",
        "(lambda F: F*P0*F.T + Q*sp.Matrix([[t/2 + sp.sin(2*t)/4, sp.sin(t)**2/2], "
        "[sp.sin(t)**2/2, t/2 -"
        " sp.sin(2*t)/4]]))(sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]]))",
        "place and speed exchanged",
    ),
    wrong(
        "4.16",
        "covariance",
        "(lambda F: F.T*P0*F + Q*sp.Matrix([[t/2 - sp.sin(2*t)/4, sp.sin(t)**2/2], "
        "[sp.sin(t)**2/2, t/2 +"
        " sp.sin(2*t)/4]]))(sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]]))",
        "the transposed on the wrong side",
    ),
    wrong(
        "4.16",
        "covariance",
        "(lambda F: F*P0*F.T + Q*sp.Matrix([[t/2 - sp.sin(2*t)/4, sp.sin(t)**2/2], [0, t/2 +"
        " sp.sin(2*t)/4]]))(sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]]))",
        "not symmetric",
    ),
    wrong(
        "4.16",
        "covariance",
        "(lambda F: F*P0*F.T + Q*t/2*sp.eye(2))(sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), "
        "sp.cos(t)]]))",
        "the average over a turn",
    ),
    wrong(
        "4.16",
        "mean",
        "[mu1*sp.cos(1.01*t) + mu2*sp.sin(t), -mu1*sp.sin(t) + mu2*sp.cos(t)]",
        "the frequency one per cent off",
    ),
    wrong("4.17", "settles", "sp.And(a > 0, b > 0, sp.Ne(a**2, 4*b))", "a double root settles too"),
    right("4.17", "settles", "sp.Min(a, b) > 0", "the smaller one is positive"),
    right(
        "4.17",
        "exponents",
        "[-a + sp.I*sp.sqrt(4*b - a**2), -a - sp.I*sp.sqrt(4*b - a**2), -a]",
        "complex",
    ),
    wrong(
        "4.17",
        "exponents",
        "[-a/2 + sp.sqrt(a**2 - 4*b)/2, -a/2 - sp.sqrt(a**2 - 4*b)/2]",
        "those of the mean",
    ),
    wrong(
        "4.17", "exponents", "[-a + sp.sqrt(a**2 - 4*b), -a - sp.sqrt(a**2 - 4*b)]", "-a is missing"
    ),
    wrong("4.17", "settles", "sp.And(a > 0, b >= 0)", "without a spring the place runs away"),
    wrong("4.17", "limit", "[[Q/(2*a*b), 0], [0, Q/(2*b)]]", "the damping limits the speed"),
    wrong("4.17", "limit", "[[Q/(2*a*b), Q/(2*a)], [0, Q/(2*a)]]", "not symmetric"),
    right(
        "4.17",
        "motion",
        "(lambda c, L: (lambda F: L + F*(sp.Matrix([[p11, p12], [p12, p22]]) -"
        " L)*F.T)(sp.exp(-a*t/2)*sp.Matrix([[sp.cosh(c*t) + a*sp.sinh(c*t)/(2*c), sp.sinh(c*t)/c],"
        " [-b*sp.sinh(c*t)/c, sp.cosh(c*t) - a*sp.sinh(c*t)/(2*c)]])))(sp.sqrt(a**2/4 - b), "
        "sp.diag(Q/(2*a*b),"
        " Q/(2*a)))",
        "hyperbolic functions",
    ),
    wrong(
        "4.17",
        "motion",
        "(lambda c, L: (lambda F: L + F*(sp.Matrix([[p11, p12], [p12, p22]]) -"
        " L)*F.T)(sp.exp(-a*t/2)*sp.Matrix([[sp.cosh(c*t) - a*sp.sinh(c*t)/(2*c), sp.sinh(c*t)/c],"
        " [-b*sp.sinh(c*t)/c, sp.cosh(c*t) + a*sp.sinh(c*t)/(2*c)]])))(sp.sqrt(a**2/4 - b), "
        "sp.diag(Q/(2*a*b),"
        " Q/(2*a)))",
        "two signs",
    ),
    right(
        "4.17",
        "critical",
        "(lambda s: [[Q*sp.Integral(s**2*sp.exp(-a*s), (s, 0, t)), Q*t**2*sp.exp(-a*t)/2],"
        " [Q*t**2*sp.exp(-a*t)/2, Q*sp.Integral((1 - a*s/2)**2*sp.exp(-a*s), (s, 0, "
        "t))]])(sp.Symbol('s',"
        " real=True))",
        "integrals",
    ),
    wrong(
        "4.17",
        "critical",
        "[[2*Q/a**3*(1 - sp.exp(-a*t)), Q*t**2*sp.exp(-a*t)/2], [Q*t**2*sp.exp(-a*t)/2, Q/(2*a)*(1 "
        "-"
        " sp.exp(-a*t))]]",
        "the powers of t are lost",
    ),
    wrong("4.17", "undamped", "[[Q*t/(2*omega**2), 0], [0, Q*t/2]]", "the average over a turn"),
    right(
        "4.17",
        "undamped",
        "(lambda s: [[Q*sp.Integral(sp.sin(omega*s)**2, (s, 0, t))/omega**2, "
        "Q*sp.sin(omega*t)**2/(2*omega**2)],"
        " [Q*sp.sin(omega*t)**2/(2*omega**2), Q*sp.Integral(sp.cos(omega*s)**2, (s, 0, "
        "t))]])(sp.Symbol('s'))",
        "integrals",
    ),
    wrong(
        "4.17",
        "springless",
        "[[Q*t/a**2, Q/(2*a**2)*(1 - sp.exp(-a*t))**2], [Q/(2*a**2)*(1 - sp.exp(-a*t))**2, "
        "Q/(2*a)*(1 -"
        " sp.exp(-2*a*t))]]",
        "what grows in the end alone",
    ),
    wrong("4.17", "settles", "sp.And(a > 0, b > 0, sp.Ne(b, a))", "a line"),
    wrong("4.18", "limit", "[[0.017, 0], [0, 0.1]]", "two digits of 1/60"),
    right("4.18", "limit", "[[0.0167, 0], [0, 0.1]]", "three digits of 1/60"),
    wrong(
        "4.18", "limit", "[[0.0167, 0.01], [0.01, 0.1]]", "the place and the speed do not correlate"
    ),
    right(
        "4.18",
        "motion",
        "(lambda s, h: [[sp.Integral(h(s)**2, (s, 0, t)), h(t)**2/2], [h(t)**2/2, "
        "sp.Integral(sp.diff(h(s),"
        " s)**2, (s, 0, t))]])(sp.Symbol('s'), lambda s: sp.exp(-2*s) - sp.exp(-3*s))",
        "integrals",
    ),
    right(
        "4.18",
        "motion",
        "(lambda x: [[sp.Rational(1, 60) - x**4/4 + 2*x**5/5 - x**6/6, (x**2 - x**3)**2/2], [(x**2 "
        "- x**3)**2/2,"
        " 0.1 - x**4 + 2.4*x**5 - 1.5*x**6]])(sp.exp(-t))",
        "decimals",
    ),
    wrong(
        "4.18",
        "motion",
        "(lambda x: [[sp.Rational(1, 60) - x**4/4 + 2*x**5/5 - x**6/6, (x**2 - x**3)**2/2], [(x**2 "
        "- x**3)**2/2,"
        " sp.Rational(1, 10) - x**4 + 12*x**5/5 - 7*x**6/5]])(sp.exp(-t))",
        "7/5 for 3/2",
    ),
    wrong(
        "4.18",
        "motion",
        "(lambda x: [[sp.Rational(1, 60) - x**4/4 + 2*x**5/5 - x**6/6, (x**2 - x**3)**2], [(x**2 - "
        "x**3)**2,"
        " sp.Rational(1, 10) - x**4 + 12*x**5/5 - 3*x**6/2]])(sp.exp(-t))",
        "a half is lost",
    ),
    wrong("4.18", "limit", "[[0.0168, 0], [0, 0.1]]", "a digit"),
    wrong("4.18", "limit", "[[0.0167, 0.0001], [0.0001, 0.1]]", "a small covariance"),
    wrong(
        "4.18",
        "motion",
        "(lambda x: [[sp.Rational(1, 60) - x**4/4 + 0.404*x**5 - x**6/6, (x**2 - x**3)**2/2], "
        "[(x**2 -"
        " x**3)**2/2, 0.1 - x**4 + 2.4*x**5 - 1.5*x**6]])(sp.exp(-t))",
        "one per cent",
    ),
    wrong(
        "4.19",
        "settles",
        "sp.And(alpha > -1, alpha < 1, sp.Ne(alpha, 0))",
        "for alpha = 0 it settles at once",
    ),
    right("4.19", "settles", "sp.Abs(alpha**3) < 1", "the cube of the modulus"),
    right(
        "4.19",
        "variance",
        "alpha**(2*k)*P0 + Q*sp.Sum(alpha**(2*sp.Symbol('j')), (sp.Symbol('j'), 0, k - 1))",
        "as a sum",
    ),
    right(
        "4.19",
        "variance",
        "alpha**(2*k)*P0 + sp.Sum(Q*alpha**(2*(k - sp.Symbol('j'))), (sp.Symbol('j'), 1, k))",
        "a sum from the end",
    ),
    right(
        "4.19",
        "variance",
        "Q/(1 - alpha**2) + alpha**(2*k)*(P0 - Q/(1 - alpha**2))",
        "the limit and what is left",
    ),
    wrong(
        "4.19",
        "variance",
        "alpha**(2*k)*P0 + sp.Sum(Q*alpha**(2*sp.Symbol('j')), (sp.Symbol('j'), 0, k))",
        "one noise too many",
    ),
    wrong(
        "4.19",
        "variance",
        "alpha**k*P0 + Q*(1 - alpha**(2*k))/(1 - alpha**2)",
        "the start decays like the mean",
    ),
    wrong(
        "4.19",
        "variance",
        "sp.Abs(alpha)**k*P0 + Q*(1 - alpha**(2*k))/(1 - alpha**2)",
        "the start decays like the mean",
    ),
    wrong("4.19", "mean", "sp.Abs(alpha)**k*mu", "the signs alternate"),
    wrong("4.19", "border", "P0 + Q*(k + 1)", "a noise too many"),
    right("4.19", "border", "P0 + sp.Sum(Q, (sp.Symbol('j'), 1, k))", "as a sum"),
    wrong("4.19", "state", "alpha**3*x0 + q0 + alpha*q1 + alpha**2*q2", "the order of the noises"),
    right("4.19", "state", "alpha*(alpha*(alpha*x0 + q0) + q1) + q2", "nested"),
    wrong("4.19", "share", "Q*alpha**(2*n + 2)", "counted from the step before"),
    right("4.19", "share", "Q*(alpha**n)**2", "a square"),
    wrong("4.19", "limit", "Q/(1 - alpha)", "the square is lost"),
    wrong("4.19", "settles", "sp.And(alpha >= -1, alpha < 1)", "at -1 it grows"),
    wrong("4.19", "settles", "sp.Abs(alpha) < 0.99", "the border is 1"),
    right(
        "4.19",
        "mean",
        "mu*sp.Piecewise((sp.Abs(alpha)**k, alpha >= 0), ((-1)**k*sp.Abs(alpha)**k, True))",
        "by cases",
    ),
    wrong(
        "4.19",
        "variance",
        "alpha**(2*k)*P0 + 1.01*Q*(1 - alpha**(2*k))/(1 - alpha**2)",
        "one per cent",
    ),
    wrong("4.20", "settles", "sp.Ne(alpha, 0)", "for alpha = 0 it settles too"),
    right("4.20", "settles", "alpha**2 > -1", "it holds everywhere"),
    wrong(
        "4.20",
        "first",
        "[[alpha**2*p22, alpha*p12], [alpha*p12, Q]]",
        "the new noise knows nothing",
    ),
    wrong("4.20", "first", "[[alpha*p22, 0], [0, Q]]", "the square is lost"),
    wrong("4.20", "later", "[[Q*alpha**2, 0], [0, 1.01*Q]]", "one per cent"),
    wrong("4.20", "state", "[alpha*q2, q1]", "exchanged"),
    right("4.20", "settles", "sp.Or(alpha >= 0, alpha < 0)", "every one"),
    wrong("4.20", "settles", "sp.Abs(alpha) < 1", "alpha is no eigenvalue"),
    right("4.20", "settles", "sp.Ne(alpha, alpha + 1)", "always"),
    right("4.21", "limit", "[[0.741, -0.296], [-0.296, 1.19]]", "three digits"),
    wrong("4.21", "limit", "[[0.74, -0.296], [-0.296, 1.19]]", "two digits"),
    wrong("4.21", "limit", "[[0.741, 0.296], [0.296, 1.19]]", "a sign"),
    wrong(
        "4.21",
        "limit",
        "[[sp.Rational(20, 27), -sp.Rational(8, 27)], [sp.Rational(8, 27), sp.Rational(32, 27)]]",
        "not symmetric",
    ),
    right("4.21", "exponents", "{0.25}", "as a set"),
    wrong("4.21", "exponents", "[sp.Rational(1, 2)]", "that of the mean"),
    wrong("4.21", "exponents", "[sp.Rational(1, 4), sp.Rational(1, 2)]", "one too many"),
    right(
        "4.21",
        "motion",
        "(lambda F, L: L + F*(start - L)*F.T)(sp.Matrix([[1 + k, k], [-k, 1 - k]])/2**k, "
        "sp.Matrix([[20, -8],"
        " [-8, 32]])/27)",
        "a product",
    ),
    wrong(
        "4.21",
        "motion",
        "(lambda F, L: L + F*(start - L)*F.T)(sp.Matrix([[1 + k, k], [-k, 1 - k]])/4**k, "
        "sp.Matrix([[20, -8],"
        " [-8, 32]])/27)",
        "the power is squared twice",
    ),
    wrong(
        "4.21",
        "motion",
        "(lambda F, L: L + F*(start - L)*F.T)(sp.eye(2)/2**k, sp.Matrix([[20, -8], [-8, 32]])/27)",
        "without k",
    ),
    wrong("4.21", "limit", "[[0.741, -0.296], [-0.299, 1.19]]", "not symmetric, a digit"),
    right(
        "4.22",
        "prior",
        "(lambda m: [[m, m], [m, m + Q]])(2*Q*R/(Q + sp.sqrt(Q**2 + 4*Q*R)))",
        "the conjugate form",
    ),
    right(
        "4.22",
        "prior",
        "(lambda m: [[m, m], [m, m + Q]])(Q*(sp.sqrt(1 + 4*R/Q) - 1)/2)",
        "by the ratio",
    ),
    wrong(
        "4.22",
        "prior",
        "(lambda m: [[m, m], [m, m]])((sp.sqrt(Q**2 + 4*Q*R) - Q)/2)",
        "after the measurement",
    ),
    wrong(
        "4.22",
        "prior",
        "(lambda m: [[m, m], [m, m + Q]])((-sp.sqrt(Q**2 + 4*Q*R) - Q)/2)",
        "the other root",
    ),
    wrong(
        "4.22",
        "gain",
        "(lambda p: [p/(p + R), p/(p + R)])((sp.sqrt(Q**2 + 4*Q*R) + Q)/2)",
        "that of the prediction",
    ),
    right(
        "4.22",
        "gain",
        "(lambda m: [m**2/(R*(m + Q)), m/R])((sp.sqrt(Q**2 + 4*Q*R) - Q)/2)",
        "by the variance after",
    ),
    wrong(
        "4.22",
        "posterior",
        "(lambda m: [[m, m], [m, m + Q]])((sp.sqrt(Q**2 + 4*Q*R) - Q)/2)",
        "before the measurement",
    ),
    right(
        "4.22",
        "posterior",
        "(lambda m: (lambda p: [[m - m**2/(p + R), m*R/(p + R)], [m*R/(p + R), p*R/(p + R)]])(m +"
        " Q))((sp.sqrt(Q**2 + 4*Q*R) - Q)/2)",
        "not simplified",
    ),
    right(
        "4.22",
        "decay",
        "[0, (lambda p: R/(p + R))((sp.sqrt(Q**2 + 4*Q*R) + Q)/2)]",
        "by the variance before",
    ),
    wrong(
        "4.22", "decay", "[(lambda p: R/(p + R))((sp.sqrt(Q**2 + 4*Q*R) + Q)/2)]", "zero is missing"
    ),
    wrong(
        "4.22",
        "recursion",
        "[[R*p22/(R + p22), R*p22/(R + p22)], [R*p22/(R + p22), R*p22/(R + p22)]]",
        "the noise is lost",
    ),
    wrong(
        "4.22",
        "recursion",
        "[[R*p22/(R + p22), R*p12/(R + p22)], [R*p12/(R + p22), Q + R*p22/(R + p22)]]",
        "p12 for p22",
    ),
    right(
        "4.22",
        "prior",
        "(lambda q: R*sp.Matrix([[q/2*(sp.sqrt(1 + 4/q) - 1), q/2*(sp.sqrt(1 + 4/q) - 1)], "
        "[q/2*(sp.sqrt(1 +"
        " 4/q) - 1), q/2*(sp.sqrt(1 + 4/q) + 1)]]))(Q/R)",
        "by the ratio",
    ),
    wrong(
        "4.22", "decay", "[0.001, (lambda p: R/(p + R))((sp.sqrt(Q**2 + 4*Q*R) + Q)/2)]", "not zero"
    ),
    right(
        "4.23",
        "gain",
        "[(sp.sqrt(Q**2 + 4*Q*R) - Q)/(2*R)]*2",
        "the root of the quadratic for the gain",
    ),
    wrong("4.23", "gain", "[0, (sp.sqrt(Q**2 + 4*Q*R) - Q)/(2*R)]", "that of 4.22"),
    wrong(
        "4.23",
        "prior",
        "(lambda p: [[p, p], [p, p]])((sp.sqrt(Q**2 + 4*Q*R) + Q)/2)",
        "the noise of the last step is lost",
    ),
    wrong(
        "4.23",
        "posterior",
        "(lambda p: [[p, p], [p, p + Q]])((sp.sqrt(Q**2 + 4*Q*R) + Q)/2)",
        "before the measurement",
    ),
    right(
        "4.23",
        "posterior",
        "(lambda m: [[m, m], [m, m + Q]])(2*R*Q/(Q + sp.sqrt(Q)*sp.sqrt(Q + 4*R)))",
        "conjugate",
    ),
    wrong(
        "4.23",
        "recursion",
        "[[p22 - p12**2/(R + p22), p22 - p12**2/(R + p22)], [p22 - p12**2/(R + p22), Q + p22 - "
        "p12**2/(R + p22)]]",
        "another coordinate is measured",
    ),
    wrong("4.23", "decay", "[0, (sp.sqrt(Q**2 + 4*Q*R) - Q)/(2*R)]", "the gain"),
    right("4.24", "recursion", "a**2*p + Q - a**2*p**2*h**2/(h**2*p + R)", "a difference"),
    right("4.24", "recursion", "a**2/(1/p + h**2/R) + Q", "by the inverses"),
    wrong("4.24", "recursion", "R*p/(R + h**2*p)*a + Q", "the square is lost"),
    wrong(
        "4.24",
        "recursion",
        "(lambda m: R*m/(R + h**2*m))(a**2*p + Q)",
        "first predicted, then measured",
    ),
    wrong(
        "4.24",
        "prior",
        "(Q*h**2 + R*(a**2 - 1) - sp.sqrt(4*Q*R*h**2 + (Q*h**2 + R*(a**2 - 1))**2))/(2*h**2)",
        "the other root",
    ),
    wrong(
        "4.24",
        "posterior",
        "(Q*h**2 + R*(a**2 - 1) + sp.sqrt(4*Q*R*h**2 + (Q*h**2 + R*(a**2 - 1))**2))/(2*h**2)",
        "before the measurement",
    ),
    right(
        "4.24",
        "prior",
        "(lambda d: 2*Q*R/(sp.sqrt(d**2 + 4*Q*R*h**2) - d))(Q*h**2 + R*(a**2 - 1))",
        "conjugate",
    ),
    wrong(
        "4.24",
        "gain",
        "(lambda p: a*h*p/(h**2*p + R))((Q*h**2 + R*(a**2 - 1) + sp.sqrt(4*Q*R*h**2 + (Q*h**2 + "
        "R*(a**2 -"
        " 1))**2))/(2*h**2))",
        "that of the prediction",
    ),
    right(
        "4.24",
        "gain",
        "(lambda p: h*p/(h**2*p + R))((Q*h**2 + R*(a**2 - 1) + sp.sqrt(4*Q*R*h**2 + (Q*h**2 + "
        "R*(a**2 -"
        " 1))**2))/(2*h**2))",
        "by the variance before",
    ),
    wrong(
        "4.24",
        "decay",
        "[(lambda p: R*sp.Abs(a)/(h**2*p + R))((Q*h**2 + R*(a**2 - 1) + sp.sqrt(4*Q*R*h**2 + "
        "(Q*h**2 + R*(a**2 -"
        " 1))**2))/(2*h**2))]",
        "a may be negative",
    ),
    wrong("4.24", "quiet", "R*(a**2 - 1)/h**2", "before the measurement"),
    right("4.24", "quiet", "R/h**2 - R/(a*h)**2", "a difference"),
    right("4.24", "recursion", "sp.Matrix([[a**2*p*R/(h**2*p + R) + Q]])", "a matrix"),
    right(
        "4.24",
        "decay",
        "a*R/(R + h**2*(Q*h**2 + R*(a**2 - 1) + sp.sqrt(4*Q*R*h**2 + (Q*h**2 + R*(a**2 - "
        "1))**2))/(2*h**2))",
        "an expression",
    ),
    wrong("4.24", "recursion", "a**2*p*R/(h**2*p + R) + 1.01*Q", "one per cent"),
    wrong("4.25", "prior", "[[Q*R/(Q + R), 0], [0, Q*R/(Q + R)]]", "after the measurement"),
    wrong("4.25", "gain", "[Q/(Q + R), 0]", "that of the prediction"),
    wrong("4.25", "decay", "[0, R/(Q + R)]", "a process without memory forgets"),
    right("4.25", "decay", "[0, 0]", "with its multiplicity"),
    wrong("4.25", "estimate", "[Q*z1/(Q + R) + m1/10**5, Q*z2/(Q + R)]", "the start is forgotten"),
    wrong("4.25", "estimate", "[Q*z2/(Q + R), Q*z1/(Q + R)]", "exchanged"),
    right("4.25", "estimate", "[z1/(1 + R/Q), z2/(1 + R/Q)]", "divided"),
    right("4.26", "covariance", "[[0.95, 0.375], [0.375, 1.19]]", "three digits"),
    wrong("4.26", "covariance", "[[0.95, 0.375], [0.375, 1.18]]", "a digit"),
    wrong("4.26", "covariance", "[[0.95, 0.375], [0.375, 4]]", "the speed is not corrected"),
    wrong("4.26", "estimate", "[3.05, 1.375]", "a sign"),
    wrong("4.26", "estimate", "[3.05, 0.63]", "two digits"),
    right("4.26", "estimate", "sp.Matrix([3.05, 0.625])", "a column"),
    wrong("4.26", "covariance", "[[0.95, 0.375], [0.37, 1.19]]", "not symmetric, a digit"),
    right("4.27", "filtered", "(mu/P + S/R)/(1/P + (n + 1)/R)", "weights"),
    right("4.27", "filtered", "mu + P*(S - (n + 1)*mu)/(R + (n + 1)*P)", "a correction"),
    wrong("4.27", "filtered", "(mu/P + S/R)/(1/P + n/R)", "n + 1 measurements"),
    wrong("4.27", "plain", "S/n", "n + 1 measurements"),
    wrong("4.27", "plain_variance", "R/(n + 1)**2", "a square too many"),
    wrong("4.27", "filtered_variance", "P*R/(P*n + R)", "n + 1 measurements"),
    right("4.27", "filtered_variance", "1/(1/P + sp.Sum(1/R, (sp.Symbol('j'), 0, n)))", "as a sum"),
    wrong("4.27", "narrow", "0", "the mean is known"),
    wrong("4.27", "filtered", "(mu/P + S/R)/(1/P + (n + 1.01)/R)", "one per cent"),
    right("4.28", "estimate", "0.92", "0.920 to three digits"),
    right("4.28", "deviation", "sp.sqrt((1 + sp.exp(-2)/2)/2)", "one root"),
    right("4.28", "deviation", "0.731", "three digits"),
    wrong("4.28", "deviation", "0.73", "two digits"),
    wrong(
        "4.28",
        "deviation",
        "sp.sqrt(sp.Rational(3, 4)*sp.exp(-2) + (1 - sp.exp(-2)))",
        "the half is lost",
    ),
    wrong("4.28", "estimate", "3*sp.exp(-1)", "the reading is believed"),
    right("4.28", "deviation", "[0.731]", "in a list"),
    wrong("4.29", "before", "sp.Rational(3, 4)", "after the measurement"),
    right(
        "4.29",
        "before",
        "3*sp.exp(-2) + 6*sp.Integral(sp.exp(-2*sp.Symbol('s')), (sp.Symbol('s'), 0, 1))",
        "an integral",
    ),
    wrong("4.29", "estimate", "2.5", "the mean at the start"),
    right("4.29", "estimate", "2.34", "three digits"),
    wrong("4.29", "deviation", "0.75", "the variance"),
    right("4.29", "estimate", "np.exp(-1)/4 + 9/4", "from NumPy"),
    wrong("4.30", "start_estimate", "1.75", "that of the end"),
    wrong("4.30", "start_deviation", "1", "nothing is learned"),
    right("4.30", "deviation", "0.866", "three digits"),
    right("4.31", "first", "(z1*sp.sinh(2 - t) + z2*sp.sinh(t - 1))/sp.sinh(1)", "the sign inside"),
    right(
        "4.31",
        "first",
        "(z1*(sp.exp(2 - t) - sp.exp(t - 2)) + z2*(sp.exp(t - 1) - sp.exp(1 - t)))/(sp.E - 1/sp.E)",
        "exponentials",
    ),
    right("4.31", "first", "0.851*(z1*sp.sinh(2 - t) + z2*sp.sinh(t - 1))", "three digits"),
    wrong("4.31", "first", "z1*(2 - t) + z2*(t - 1)", "a straight line"),
    wrong("4.31", "first", "0.88*(z1*sp.sinh(2 - t) + z2*sp.sinh(t - 1))", "0.88 for 0.85"),
    wrong("4.31", "first", "z1*sp.exp(1 - t) + z2*sp.exp(t - 2)", "each of them alone"),
    wrong(
        "4.31",
        "first",
        "(z1*sp.sinh(2 - t) + z2*sp.sinh(t - 1) + z3*sp.sinh(t - 1)*sp.sinh(2 - t)/100)/sp.sinh(1)",
        "z3 does not count",
    ),
    wrong("4.31", "before", "z1*sp.exp(1 - t)", "a sign"),
    right("4.31", "before", "z1/sp.exp(sp.Abs(t - 1))", "a modulus"),
    right(
        "4.31",
        "first_variance",
        "1 - (sp.sinh(2 - t)*sp.exp(1 - t) + sp.sinh(t - 1)*sp.exp(t - 2))/sp.sinh(1)",
        "not simplified",
    ),
    wrong("4.31", "first_variance", "1 - sp.exp(2 - 2*t)", "the second value is forgotten"),
    wrong("4.31", "first_variance", "1.9*sp.sinh(t - 1)*sp.sinh(2 - t)/sp.sinh(1)", "1.9 for 2"),
    wrong("4.31", "after_variance", "1 - sp.exp(3 - t)", "the square is lost"),
    right("4.31", "after_variance", "2*sp.sinh(t - 3)*sp.exp(3 - t)", "hyperbolic"),
    right("4.31", "before", "sp.Lambda(t, z1*sp.exp(t - 1))", "a Lambda"),
    right(
        "4.31",
        "first",
        "z1*(sp.cosh(t - 1) - sp.coth(1)*sp.sinh(t - 1)) + z2*sp.sinh(t - 1)/sp.sinh(1)",
        "by coth",
    ),
    wrong(
        "4.31", "first", "(z1*sp.sinh(2 - t) + 1.01*z2*sp.sinh(t - 1))/sp.sinh(1)", "one per cent"
    ),
    wrong(
        "4.31", "first_variance", "2.02*sp.sinh(t - 1)*sp.sinh(2 - t)/sp.sinh(1)", "one per cent"
    ),
    right("4.32", "estimate", "4.08", "three digits"),
    wrong("4.32", "estimate", "4.07", "a digit"),
    right("4.32", "deviation", "sp.sqrt(sp.exp(2)/2 + sp.exp(1)*sp.sinh(1))", "hyperbolic"),
    wrong("4.32", "deviation", "sp.exp(2) - sp.Rational(1, 2)", "the variance"),
    wrong("4.32", "blind", "sp.sqrt(sp.exp(2) - sp.Rational(1, 2))", "with the measurement"),
    right(
        "4.32",
        "deviation",
        "sp.sqrt(sp.exp(2)/2 + sp.Integral(sp.exp(2*sp.Symbol('s')), (sp.Symbol('s'), 0, 1)))",
        "an integral",
    ),
    wrong("4.33", "exists", "sp.Ne(b*(a**2 - 4*b), 0)", "a double root is no obstacle"),
    right("4.33", "exists", "b**2 > 0", "a square"),
    right(
        "4.33",
        "positive",
        "(lambda g: [[g/b, 0], [0, g]])(sp.sqrt(R*(Q + a**2*R)) - a*R)",
        "one root",
    ),
    right(
        "4.33",
        "positive",
        "(lambda g: [[g/b, 0], [0, g]])(Q*R/(sp.sqrt(R*(Q + a**2*R)) + a*R))",
        "conjugate",
    ),
    wrong(
        "4.33",
        "positive",
        "(lambda g: [[g/b, 0], [0, g]])(sp.sqrt(R*(Q + a**2*R)) + a*R)",
        "a sign",
    ),
    wrong(
        "4.33",
        "positive",
        "(lambda g: [[g*b, 0], [0, g]])(sp.sqrt(R*(Q + a**2*R)) - a*R)",
        "multiplied for divided",
    ),
    wrong("4.33", "positive_gain", "[0, sp.sqrt(a**2*R**2 + Q*R) - a*R]", "not divided by R"),
    wrong("4.33", "negative_gain", "[0, -a + sp.sqrt(Q/R + a**2)]", "as for a positive b"),
    wrong("4.33", "negative_gain", "[2, -a + sp.sqrt(Q/R + a**2 + 4*b)]", "a sign"),
    wrong(
        "4.33",
        "negative",
        "[[R*(a + sp.sqrt(Q/R + a**2 - 4*b))/b, 2*R], [2*R, R*(-a + sp.sqrt(Q/R + a**2 - 4*b))]]",
        "a negative variance",
    ),
    wrong(
        "4.33",
        "negative",
        "[[-R*(a + sp.sqrt(Q/R + a**2 - 4*b))/b, 0], [2*R, R*(-a + sp.sqrt(Q/R + a**2 - 4*b))]]",
        "not symmetric",
    ),
    right(
        "4.33",
        "negative",
        "[[(a*R + sp.sqrt(R*Q + R**2*(a**2 - 4*b)))/sp.Abs(b), 2*R], [2*R, -a*R + sp.sqrt(R*Q + "
        "R**2*(a**2 -"
        " 4*b))]]",
        "a modulus",
    ),
    wrong("4.33", "exists", "b > 0", "a repelled one is seen too"),
    wrong("4.33", "exists", "sp.Or(b > 0, sp.And(b < 0, a > 0))", "whatever the friction"),
    wrong(
        "4.33",
        "riccati",
        "[[2*p12 - p12**2/R, p22 - a*p12 - b*p11 - p12*p22/R], [p22 - a*p12 - b*p11 - p12*p22/R, Q "
        "- 2*a*p22 -"
        " 2*b*p12 - p22**2*R]]",
        "multiplied for divided",
    ),
    wrong(
        "4.33",
        "estimates",
        "[y2 + p11*(z - y2)/R, -b*y1 - a*y2 + p12*(z - y2)/R]",
        "the place is measured",
    ),
    wrong(
        "4.33", "exists", "sp.And(sp.Ne(b, 0), sp.Ne(a**2, 4*b))", "double roots are no obstacle"
    ),
    wrong("4.33", "positive_gain", "[0.01, -a + sp.sqrt(Q/R + a**2)]", "not zero"),
    wrong("4.34", "exists", "sp.Ne(h, 0)", "a < 0 needs no measurement"),
    wrong("4.34", "exists", "sp.Or(a < 0, sp.Ne(h, 0))", "a = 0 without noise"),
    right("4.34", "exists", "sp.Or(a < 0, sp.And(sp.Ne(h, 0), sp.Or(a > 0, Q > 0)))", "by cases"),
    wrong(
        "4.34",
        "steady",
        "sp.Piecewise((R*(a + sp.sqrt(a**2 + Q*h**2/R))/h**2, a <= 20), (Q, True))",
        "another one for a = 21",
    ),
    wrong(
        "4.34",
        "steady",
        "sp.Piecewise((R*(a + sp.sqrt(a**2 + Q*h**2/R))/h**2, sp.Or(a <= 20, Q < 20)), (Q, True))",
        "another one where both are large",
    ),
    wrong(
        "4.34",
        "gain",
        "sp.Piecewise((h*Q/R/(sp.sqrt(a**2 + Q*h**2/R) - a), h*a < 30), (Q, True))",
        "another one where the product is large",
    ),
    wrong(
        "4.34",
        "riccati",
        "sp.Piecewise((2*a*P + Q - h**2*P**2/R, a < 20), (Q, True))",
        "another one for a = 21",
    ),
    right(
        "4.34",
        "steady",
        "sp.Piecewise((R*(a + sp.sqrt(a**2 + Q*h**2/R))/h**2, a <= 20), "
        "(Q/(sp.sqrt(a**2 + Q*h**2/R) - a), True))",
        "two forms of the root",
    ),
    right(
        "4.34",
        "quiet",
        "sp.Piecewise((2*a*R/h**2, sp.And(a > 0, sp.Ne(h, 0))), (sp.nan, True))",
        "no value where none is asked",
    ),
    right(
        "4.34",
        "unseen",
        "sp.Piecewise((-Q/(2*a), a < 0), (sp.nan, True))",
        "no value where none is asked",
    ),
    right(
        "4.34",
        "steady",
        "R*(a + sp.sqrt(a**2 + Q*h**2/R))/h**2*sp.Sum(sp.Symbol('n')**-2, "
        "(sp.Symbol('n'), 1, sp.oo))*6/sp.pi**2",
        "with a series",
    ),
    wrong(
        "4.34",
        "steady",
        "R*(a + sp.sqrt(a**2 + Q*h**2/R))/h**2*sp.Sum(sp.Symbol('n')**-2, "
        "(sp.Symbol('n'), 2, sp.oo))*6/sp.pi**2",
        "the first term is left out",
    ),
    right("4.34", "steady", "Q/(sp.sqrt(a**2 + Q*h**2/R) - a)", "conjugate"),
    wrong("4.34", "steady", "Q/(sp.sqrt(a**2 + Q*h**2/R) + a)", "a sign"),
    wrong(
        "4.34",
        "steady",
        "R*(a + sp.Abs(a)*sp.sqrt(1 + Q*h**2/(R*a**2)))/h**2 + Q/10**4",
        "a little off",
    ),
    wrong("4.34", "gain", "(a + sp.sqrt(Q*h**2/R + a**2))/sp.Abs(h)", "h may be negative"),
    wrong("4.34", "decay", "sp.sqrt(Q*h**2/R + a**2)", "it grows"),
    wrong("4.34", "quiet", "0", "it is not stable without a gain"),
    wrong("4.34", "quiet", "2*a*R", "h is lost"),
    wrong("4.34", "estimate", "a*y + P*h*(z - y)/R", "h in the innovation"),
    right("4.34", "estimate", "(a - P*h**2/R)*y + P*h*z/R", "collected"),
    wrong("4.34", "riccati", "2*a*P + Q - P**2*h/R", "the square of h"),
    wrong(
        "4.34",
        "exists",
        "sp.Or(sp.And(a < 0, Q > 0), sp.And(sp.Ne(h, 0), sp.Or(sp.Ne(a, 0), Q > 0)))",
        "a < 0, h = 0, Q = 0 decays",
    ),
    right("4.34", "exists", "sp.And(sp.Or(a < 0, h**2 > 0), a**2 + Q > 0)", "as a sum"),
    right("4.34", "decay", "[-sp.sqrt(a**2 + Q*h**2/R)]", "in a list"),
    wrong("4.34", "riccati", "2.02*a*P + Q - P**2*h**2/R", "one per cent"),
    right(
        "4.35",
        "covariance",
        "(lambda p: [[sp.sqrt(2*R*p), p], [p, sp.sqrt(2*R*p)*p/R]])(sp.sqrt(Q*R))",
        "nested roots",
    ),
    wrong(
        "4.35",
        "covariance",
        "(lambda p: [[sp.sqrt(2*R*p), p], [p, sp.sqrt(2*Q*p)*p/R]])(sp.sqrt(Q*R))",
        "Q for R",
    ),
    wrong(
        "4.35",
        "covariance",
        "(lambda p: [[sp.sqrt(2*R*p), -p], [-p, sp.sqrt(2*R*p)*p/R]])(sp.sqrt(Q*R))",
        "a sign",
    ),
    right(
        "4.35",
        "gain",
        "(lambda w: [sp.sqrt(2)*w, w**2])((Q/R)**sp.Rational(1, 4))",
        "by the frequency",
    ),
    right("4.35", "gain", "[1.41*(Q/R)**0.25, (Q/R)**0.5]", "three digits"),
    wrong("4.35", "gain", "[1.4*(Q/R)**0.25, (Q/R)**0.5]", "two digits"),
    wrong(
        "4.35", "gain", "(lambda w: [w**2, sp.sqrt(2)*w])((Q/R)**sp.Rational(1, 4))", "exchanged"
    ),
    right(
        "4.35",
        "eigenvalues",
        "[(Q/R)**sp.Rational(1, 4)*sp.exp(3*sp.pi*sp.I/4), (Q/R)**sp.Rational(1, "
        "4)*sp.exp(-3*sp.pi*sp.I/4)]",
        "polar form",
    ),
    wrong(
        "4.35",
        "eigenvalues",
        "[(Q/R)**sp.Rational(1, 4)*sp.exp(sp.pi*sp.I/4), (Q/R)**sp.Rational(1, "
        "4)*sp.exp(-sp.pi*sp.I/4)]",
        "they grow",
    ),
    wrong("4.35", "eigenvalues", "[(Q/R)**sp.Rational(1, 4)*sp.exp(3*sp.pi*sp.I/4)]", "one of two"),
    wrong(
        "4.35",
        "rate",
        "[[2*p12 - p11**2/R, p22 - p11*p12/R], [p22 - p11*p12/R, Q + p12**2/R]]",
        "a sign",
    ),
    right("4.35", "rate", "(lambda P: A*P + P*A.T + noise - P*H.T*H*P/R)(P)", "the product"),
    wrong(
        "4.35", "rate", "(lambda P: A*P + P*A.T + noise - P*H.T*H*P*R)(P)", "multiplied for divided"
    ),
    right(
        "4.35",
        "eigenvalues",
        "sp.roots(sp.Symbol('x')**2 + sp.sqrt(2)*(Q/R)**sp.Rational(1, 4)*sp.Symbol('x') + "
        "sp.sqrt(Q/R),"
        " sp.Symbol('x'))",
        "from roots",
    ),
    wrong(
        "4.35",
        "eigenvalues",
        "[1.01*(Q/R)**sp.Rational(1, 4)*sp.exp(3*sp.pi*sp.I/4), (Q/R)**sp.Rational(1, "
        "4)*sp.exp(-3*sp.pi*sp.I/4)]",
        "one per cent",
    ),
    wrong("4.36", "covariance", "[[-3, 1.5], [1.5, -3]]", "the other solution"),
    right("4.36", "eigenvalues", "np.array([-1 + 0.707j, -1 - 0.707j])", "an array"),
    wrong("4.36", "eigenvalues", "[-1 + 0.7*sp.I, -1 - 0.7*sp.I]", "two digits"),
    wrong("4.36", "eigenvalues", "[-1 + sp.sqrt(2)/2, -1 - sp.sqrt(2)/2]", "they are complex"),
    wrong("4.36", "gain", "[1.5, 1]", "exchanged"),
    right("4.36", "gain", "np.array([[1.0], [1.5]])", "a column"),
    right("4.36", "gain", "sp.Matrix([[1, sp.Rational(3, 2)]])", "lying down"),
    wrong("4.37", "covariance", "[[2, 1], [1, 2]]", "a sign"),
    wrong("4.37", "covariance", "[[2, -1], [-1, 2.02]]", "one per cent"),
    right("4.37", "eigenvalues", "[-2.62, -0.382]", "three digits"),
    wrong("4.37", "eigenvalues", "[-2.62, -0.38]", "two digits"),
    wrong("4.37", "eigenvalues", "[2.62, 0.382]", "a sign"),
    wrong("4.37", "gain", "[2, -1]", "a column of the covariance"),
    right("4.37", "eigenvalues", "sp.Matrix([[-2, -1], [-1, -1]]).eigenvals()", "from eigenvals"),
    right(
        "4.37", "eigenvalues", "np.linalg.eigvals(np.array([[-2., -1.], [-1., -1.]]))", "from NumPy"
    ),
    wrong("4.37", "eigenvalues", "[-2.618]", "one of two"),
    wrong("4.38", "limit_exists", "sp.And(a > 0, b > 0, a**2 > 4*b)", "oscillations settle too"),
    right("4.38", "limit_exists", "sp.Min(a, b) > 0", "the smaller one is positive"),
    wrong("4.38", "limit_exists", "sp.And(a > 0, sp.Ne(b, 0))", "a repelled one has no limit"),
    wrong("4.38", "gain", "[0, a + sp.sqrt(a**2 + Q/R)]", "a sign"),
    right("4.38", "gain", "[0, (Q/R)/(a + sp.sqrt(a**2 + Q/R))]", "conjugate"),
    wrong("4.38", "limit", "[[Q/(2*a*b), 0], [0, Q/(4*a)]]", "half of it"),
    wrong("4.39", "exists", "a < 0", "a falling one is seen too"),
    wrong("4.39", "covariance_positive", "[[sp.sqrt(Q)/a, 0], [0, sp.sqrt(Q)]]", "as for a < 0"),
    wrong("4.39", "gain_positive", "[0, sp.sqrt(Q + 4*a)]", "the place has to be corrected"),
    wrong("4.39", "gain_negative", "[0, Q]", "the root is lost"),
    right(
        "4.39", "covariance_negative", "[[sp.sqrt(Q)/sp.Abs(a), 0], [0, sp.sqrt(Q)]]", "a modulus"
    ),
    right(
        "4.39",
        "eigenvalues",
        "(lambda s: [(-s + sp.sqrt(s**2 - 4*a))/2, (-s - sp.sqrt(s**2 - 4*a))/2])(sp.sqrt(Q + "
        "4*a))",
        "the formula",
    ),
    wrong(
        "4.39",
        "eigenvalues",
        "(lambda s: [(-s + sp.sqrt(s**2 + 4*a))/2, (-s - sp.sqrt(s**2 + 4*a))/2])(sp.sqrt(Q + "
        "4*a))",
        "a sign",
    ),
    wrong("4.39", "exists", "sp.And(sp.Ne(a, 0), sp.Ne(Q + 4*a, 0))", "a < 0 has no such border"),
    wrong("4.40", "covariance", "[[-sp.sqrt(6), 3], [3, -2*sp.sqrt(6)]]", "the other solution"),
    right("4.40", "covariance", "[[2.45, 3], [3, 4.9]]", "three digits: 4.90"),
    wrong("4.40", "covariance", "[[2.45, 3], [3, 4.8]]", "a digit"),
    wrong("4.40", "gain", "[2.4, 3]", "two digits"),
    right(
        "4.40",
        "eigenvalues",
        "sp.FiniteSet(-sp.sqrt(6)/2 + sp.I/sp.sqrt(2), -sp.sqrt(6)/2 - sp.I/sp.sqrt(2))",
        "as a set",
    ),
    wrong("4.40", "covariance", "[[2.45, 3], [3.01, 4.9]]", "not symmetric, one digit"),
    right("4.41", "eigenvalues", "[-1.5 + 1.32j, -1.5 - 1.32j]", "three digits"),
    wrong("4.41", "shaping", "[-1, 8, 8]", "twice the variance"),
    wrong("4.41", "shaping", "[1, 16, 8]", "a sign"),
    wrong("4.41", "covariance", "[[2, 2], [2, 8]]", "the variance before"),
    right(
        "4.41", "eigenvalues", "np.linalg.eigvals(np.array([[-2., 1.], [-2., -1.]]))", "from NumPy"
    ),
    wrong("4.41", "eigenvalues", "[-1.5 + 1.3j, -1.5 - 1.3j]", "two digits"),
    wrong("4.41", "covariance", "[[2, 2], [2, 6.06]]", "one per cent"),
    wrong("4.42", "admissible", "K > 0", "up to -1"),
    wrong("4.42", "admissible", "sp.And(K > -1, K < 100)", "large ones too"),
    right("4.42", "admissible", "sp.Interval.open(-1, sp.oo)", "as a set"),
    right("4.42", "variance", "(K - 1)/2 + 3/(2*(K + 1))", "divided"),
    wrong("4.42", "variance", "(K**2 + 1)/(2*(K + 1))", "half the noise"),
    wrong("4.42", "gain", "0.73", "two digits"),
    right("4.42", "gain", "2/(1 + sp.sqrt(3))", "conjugate"),
    right("4.42", "least", "0.732", "three digits"),
    wrong("4.42", "least", "-1 - sp.sqrt(3)", "the other root"),
    wrong("4.42", "shaping", "[-1, 1, 1]", "twice the variance"),
    wrong("4.42", "admissible", "sp.And(K > -1, sp.Ne(K, 0))", "without a measurement too"),
    right("4.42", "variance", "sp.Lambda(K, (K**2 + 2)/(2*K + 2))", "a Lambda"),
    wrong("4.42", "variance", "(K**2 + 2.02)/(2*(K + 1))", "one per cent"),
    wrong("4.43", "shaping", "[0, D, 0]", "a Wiener process"),
    wrong(
        "4.43",
        "before",
        "[[D*T**4/4, D*T**3/2, D*T**2/2], [D*T**3/2, D*T**2, D*T], [D*T**2/2, 0, D]]",
        "not symmetric",
    ),
    right("4.43", "before", "(lambda c: D*c*c.T)(sp.Matrix([T**2/2, T, 1]))", "a product"),
    wrong("4.43", "correlation", "0.866", "that of the white noise"),
    right("4.43", "correlation_noise", "0.866", "three digits"),
    wrong("4.43", "correlation_noise", "0.87", "two digits"),
    right(
        "4.43",
        "after",
        "(lambda c: D*R*c*c.T/(D*T**2 + R))(sp.Matrix([T**2/2, T, 1]))",
        "a product",
    ),
    wrong(
        "4.43",
        "after",
        "(lambda c: D*R*c*c.T/(D*T + R))(sp.Matrix([T**2/2, T, 1]))",
        "a power of T",
    ),
    wrong("4.43", "deviations_after", "[0.5, 0.001, 0.001]", "the bias is learned"),
    right("4.43", "deviations_after", "[0.5, 0.001, 1e-6]", "three digits"),
    wrong("4.43", "deviations_before", "[0.5, 1, 0.001]", "kilometres"),
    right(
        "4.43", "deviations_after", "np.array([0.49999975, 0.0009999995, 9.999995e-07])", "an array"
    ),
    right(
        "4.43",
        "after",
        "(lambda P: P - P[:, 1]*P[1, :]/(P[1, 1] + R))(D*sp.Matrix([T**2/2, T, "
        "1])*sp.Matrix([[T**2/2, T, 1]]))",
        "as it is computed",
    ),
    wrong("4.43", "deviations_after", "[0.5, 0.001, 1.01e-6]", "one per cent"),
    wrong("4.43", "deviations_before", "[500, 1, 0.00101]", "one per cent"),
    wrong("4.43", "before", "(lambda c: D*c*c.T)(sp.Matrix([0.505*T**2, T, 1]))", "one per cent"),
    wrong(
        "4.4",
        "before",
        "sp.Matrix([[Q*T**3/3, Q*T**2/2], [Q*T**2/2, sp.Piecewise((Q*T, T < 50), (Q, True))]])",
        "wrong after a long time",
    ),
    wrong(
        "4.15",
        "mean",
        "sp.Piecewise((mu0*sp.exp(a*t), t < 50), (0, True))",
        "wrong after a long time",
    ),
    wrong(
        "4.15",
        "mean",
        "sp.Piecewise((mu0*sp.exp(a*t), sp.Ne(t, 1)), (5, True))",
        "wrong at one moment",
    ),
    wrong(
        "4.15",
        "variance",
        "(P0 + Q/(2*a))*sp.exp(2*a*t) - Q/(2*a) + sp.Max(t - 40, 0)",
        "wrong after a long time",
    ),
    right(
        "4.15",
        "mean",
        "sp.Piecewise((mu0*sp.exp(a*t), t >= 0), (0, True))",
        "nothing is asked before the start",
    ),
    right(
        "4.15",
        "mean",
        "sp.Piecewise((mu0*sp.exp(a*t), sp.Ne(a, 0)), (mu0, True))",
        "a constant for a = 0",
    ),
    wrong(
        "4.16",
        "mean",
        "[mu1*sp.cos(t) + mu2*sp.sin(t), sp.Piecewise((mu2*sp.cos(t) - mu1*sp.sin(t), t < 50), "
        "(mu2, True))]",
        "wrong after a long time",
    ),
    wrong(
        "4.16",
        "mean",
        "[mu1*sp.cos(t) + mu2*sp.sin(t), mu2*sp.cos(t) - mu1*sp.sin(t) + sp.Abs(t - 60) + t - 60]",
        "wrong after a long time",
    ),
    right(
        "4.2",
        "e_least",
        "(3*(-1 + 4*x[0] - 3*x[0]**2)**2 + (12*x[0] - 3*x[0]**2 - sp.Rational(19, 2))**2).subs("
        "x[0], sp.real_roots(24*x[0]**3 - 72*x[0]**2 + 89*x[0] - 42)[0])",
        "at a root that SymPy only counts",
    ),
    wrong(
        "4.2",
        "e_least",
        "(3*(-1 + 4*x[0] - 3*x[0]**2)**2 + (12*x[0] - 3*x[0]**2 - sp.Rational(19, 2))**2).subs("
        "x[0], sp.real_roots(24*x[0]**3 - 72*x[0]**2 + 89*x[0] - 43)[0])",
        "at the root of another cubic",
    ),
    wrong(
        "4.4",
        "correction",
        "[sp.Piecewise((Q*T**2*z/(2*(Q*T + R)), sp.Abs(z) < 1000), (0, True)), Q*T*z/(Q*T + R)]",
        "large readings are thrown away",
    ),
    wrong(
        "4.4",
        "correction",
        "[sp.Piecewise((Q*T**2*z/(2*(Q*T + R)), sp.exp(z) < 10**9), (0, True)), Q*T*z/(Q*T + R)]",
        "large readings are thrown away",
    ),
    wrong(
        "4.5",
        "covariance",
        "sp.Piecewise((sp.cos(2*alpha) - sp.sin(2*alpha), sp.Abs(alpha) < 50), (0, True))",
        "nothing after many turns",
    ),
    right("4.5", "covariance", "sp.re((1 + sp.I)*sp.exp(2*sp.I*alpha))", "a complex exponential"),
    wrong(
        "4.15",
        "mean",
        "sp.Piecewise((mu0*sp.exp(a*t), sp.Abs(mu0) < 1000), (0, True))",
        "nothing for large means",
    ),
    right(
        "4.15",
        "mean",
        "sp.Piecewise((mu0*sp.exp(a*t), sp.Abs(mu0) < 1000), (mu0*(sp.cosh(a*t) + sp.sinh(a*t)), "
        "True))",
        "the same in both cases",
    ),
    right(
        "4.16",
        "mean",
        "[sp.re((mu1 - sp.I*mu2)*sp.exp(sp.I*t)), sp.im((-mu1 + sp.I*mu2)*sp.exp(sp.I*t))]",
        "a complex exponential",
    ),
    right(
        "4.34", "gain", "sp.sign(h)*(a + sp.sqrt(a**2 + Q*h**2/R))/sp.Abs(h)", "sign and modulus"
    ),
    right(
        "4.35",
        "eigenvalues",
        "[sp.root(Q/R, 4)*sp.exp(3*s*sp.I*sp.pi/4) for s in (1, -1)]",
        "by modulus and angle",
    ),
    right("4.42", "gain", "2*sp.sqrt(2)*sp.sin(sp.pi/12)", "a sine"),
]

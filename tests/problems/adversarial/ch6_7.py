"""Chapters 6 and 7: reconstruction and solvability."""

from adversarial import right, wrong

ROWS = [
    wrong("6.1", "c_kappa", "145.4", "one per cent off"),
    wrong("6.1", "d_digits", "0.2195", "one per cent off"),
    wrong(
        "6.1",
        "a_polynomial",
        "lam**4 + lam**3*(0.168*kappa - 4) + lam**2*(6 + 2*kappa/3) + lam*(kappa/6 - 4) + 1",
        "a sixth is 0.167",
    ),
    wrong("6.1", "b_reduced", "(w - 2)**2 + 0.16*kappa*(w + 4)", "two digits of a sixth"),
    wrong(
        "6.1",
        "b_reduced",
        "(w - 2)**2 + kappa*w/6 + 2*kappa/3 + 2",
        "the square of w holds 2 as well",
    ),
    right("6.1", "d_digits", "0.217", "three digits"),
    right(
        "6.1",
        "b_circle",
        "4*(1 - sp.cos(phi))**2 + kappa*(2 + sp.cos(phi))/3",
        "a square and a positive term",
    ),
    right(
        "6.1", "b_circle", "16*sp.sin(phi/2)**4 + kappa*(2 + sp.cos(phi))/3", "by half the angle"
    ),
    wrong("6.2", "b_limit", "1.515*Delta/tau**2", "one per cent off"),
    wrong("6.2", "a_acceleration", "3*(h0 - 2*h1 + h2)/(2*tau**2)", "that of the interpolation"),
    wrong("6.2", "b_limit", "Delta/tau**2", "a constant acceleration is not the least cost"),
    wrong("6.2", "c_sweep", "rho*(Delta - D*tau**2)**2/6", "the least misfit of all"),
    right(
        "6.2", "c_direct", "rho*sp.Max(Delta - D*tau**2, 0)**2/6", "the same where D tau**2 < Delta"
    ),
    right("6.2", "c_sweep", "rho*(Delta - 2*D*tau**2/3)**2/6", "a third taken out of the square"),
    wrong("6.3", "a_decay", "0.714*(rho/M)**0.25", "one per cent off"),
    wrong("6.3", "a_gain", "1 - M*omega**4/rho", "a truncated series"),
    wrong("6.3", "b_weight", "rho*(a*omega**2/D - 1)/omega**4*1.01", "one per cent off"),
    wrong(
        "6.3",
        "c_riccati",
        "[[1.41*rho**0.75*M**0.25, (rho*M)**0.5], [(rho*M)**0.5, 1.4*rho**0.25*M**0.75]]",
        "two digits of the root of 2",
    ),
    right("6.3", "a_decay", "0.707*(rho/M)**0.25", "three digits of 1/sqrt(2)"),
    right("6.3", "a_decay", "sp.re((-rho/M)**sp.Rational(1, 4))", "the real part of a fourth root"),
    right(
        "6.3",
        "c_riccati",
        "[[1.41*rho**0.75*M**0.25, (rho*M)**0.5], [(rho*M)**0.5, 1.41*rho**0.25*M**0.75]]",
        "three digits of the root of 2",
    ),
    wrong(
        "7.1",
        "d_worst",
        "delta*(1 + sp.cos(sp.sqrt(g/R)*tau))/(R*(1 - sp.cos(sp.sqrt(g/R)*tau)))",
        "after a quarter of a period the cosine is negative",
    ),
    wrong("7.1", "a_speed", "v0 + (b - g*phi0)*t - g*eps*t**2/2", "a truncated series"),
    wrong("7.1", "b_unobservable_change", "[0, g - R, 0, g*(g - R)]", "zero for g = R"),
    wrong("7.1", "c_error", "-1.01*b/g", "one per cent off"),
    right(
        "7.1",
        "b_unobservable_change",
        "{'v0': 0, 'phi0': 1, 'eps': 0, 'b': g}",
        "a dict by the names",
    ),
    wrong(
        "7.1",
        "b_unobservable_change",
        "{'v0': 0, 'phi0': -1, 'eps': 0, 'b': g}",
        "a dict, with a wrong sign",
    ),
    right(
        "7.1",
        "d_worst",
        "sp.Max(1/(1 - sp.cos(sp.sqrt(g/R)*tau)) - sp.Rational(1, 2), sp.Rational(1, 2))*2*delta/R",
        "by cases of the cosine",
    ),
    right(
        "7.1",
        "a_speed",
        "v0 - 2*(v0 + R*eps)*sp.sin(sp.sqrt(g/R)*t/2)**2 + (b - g*phi0)*sp.sqrt(R/g)"
        "*sp.sin(sp.sqrt(g/R)*t)",
        "by half the angle",
    ),
    wrong(
        "7.2",
        "b_condition",
        "sp.Ne(p**2*(y + w*t)**2, q**2*(x + u*t)**2)",
        "squaring adds a direction",
    ),
    wrong("7.2", "a_unobservable_change", "[u*x, u*y, u**2, u*w]", "zero for u = 0"),
    wrong("7.2", "a_unobservable_change", "[x/u, y/u, 1, w/u]", "undefined for u = 0"),
    wrong(
        "7.2",
        "b_condition",
        "sp.Ne(q/p, (y + w*t)/(x + u*t))",
        "undefined for p = 0, where it may tell the range",
    ),
    wrong(
        "7.2",
        "c_error",
        "delta*((x + u*t)**2 + (y + w*t)**2)/((t - T)*sp.Abs((x + u*t)*q - (y + w*t)*p))",
        "the distance before the turn",
    ),
    right("7.2", "b_condition", "sp.Ne((x + u*t)*q, (y + w*t)*p)", "the two products"),
    right(
        "7.2",
        "a_unobservable_change",
        "sp.Matrix([x, y, u, w])/sp.sqrt(x**2 + y**2 + u**2 + w**2)",
        "scaled to length 1",
    ),
    wrong(
        "7.3",
        "b_unobservable_states",
        "[[n1, 0, -n1**2/n3, 0, -2*omega*n1, 2*n1*n2*omega/n3], [0, 2, -2*n2/n3, omega, 0, "
        "-n1*omega/n3]]",
        "the first one vanishes for n1 = 0",
    ),
    wrong(
        "7.3",
        "d_insufficient",
        "sp.Eq(n1*k1 + n2*k2 + n3*k3, 1)",
        "opposite directions see the same",
    ),
    wrong(
        "7.3",
        "a_modes",
        "[n1*(4*x + 2*v_y/omega) + n2*(y - 2*v_x/omega), -n2*(6*omega*x + 3*v_y), -n1*(3*x + "
        "2*v_y/omega) + 2*n2*v_x/omega + n3*z, n1*v_x/omega + n2*(6*x + 4.04*v_y/omega) + "
        "n3*v_z/omega]",
        "one per cent off",
    ),
    wrong(
        "7.3",
        "d_insufficient",
        "sp.And(sp.Eq(n1**2, k1**2), sp.Eq(n2**2, k2**2), sp.Eq(n3**2, k3**2))",
        "mirrored directions see everything",
    ),
    wrong(
        "7.3",
        "d_insufficient",
        "sp.Eq((n1*k1 + n2*k2 + n3*k3)**3, n1*k1 + n2*k2 + n3*k3)",
        "perpendicular directions see everything",
    ),
    wrong(
        "7.3",
        "d_insufficient",
        "sp.Abs(n1*k1 + n2*k2 + n3*k3) > 0.999",
        "close directions see everything",
    ),
    right(
        "7.3", "d_insufficient", "sp.Eq(sp.Abs(n1*k1 + n2*k2 + n3*k3), 1)", "the angle is 0 or pi"
    ),
    right("7.3", "d_insufficient", "sp.And(sp.Eq(n1/k1, n2/k2), sp.Eq(n2/k2, n3/k3))", "quotients"),
    right("7.3", "d_insufficient", "(n1*k1 + n2*k2 + n3*k3)**2 >= 1", "the cosine of unit vectors"),
    wrong("7.4", "a_error", "[0, 4.8, 0]", "exceeded 4.9 times"),
    wrong("7.4", "b_rows", "51540", "one row too many"),
    wrong("7.4", "c_condition", "2/delta + delta/2", "a truncated series"),
    wrong("7.4", "d_fooling", "2*M/(M**2 + 1)", "the sine of the angle, not its tangent"),
    right("7.4", "c_condition", "sp.exp(sp.asinh(1/delta))", "an inverse hyperbolic function"),
    right("7.4", "d_fooling", "1/sp.sinh(sp.log(M))", "a hyperbolic function"),
    right("7.4", "a_error", "[0, sp.sqrt(24), 0]", "five times exactly"),
    right("7.4", "c_condition", "1/sp.tan(sp.atan(delta)/2)", "by half the angle"),
    right(
        "6.1",
        "d_digits",
        "-sp.log(sp.Min(*[sp.Abs(r) for r in sp.Poly((lam - 1)**4 + d_kappa/6*lam*(lam**2 + "
        "4*lam + 1), lam).all_roots()]), 10)",
        "by roots that SymPy only counts",
    ),
    right(
        "7.2",
        "c_error",
        "delta*((x + u*t - p*(t - T))**2 + (y + w*t - q*(t - T))**2)"
        "/sp.sqrt((t - T)**2*(p*(y + w*t) - q*(x + u*t))**2)",
        "the root of a square",
    ),
    right("7.4", "d_fooling", "sp.tan(2*sp.atan(1/M))", "the double angle"),
    right(
        "7.1",
        "a_speed",
        "sp.re((v0 + R*eps - sp.I*(b - g*phi0)*sp.sqrt(R/g))*sp.exp(sp.I*sp.sqrt(g/R)*t)) - R*eps",
        "a complex exponential",
    ),
    wrong(
        "7.1",
        "a_speed",
        "sp.Piecewise((-R*eps + (v0 + R*eps)*sp.cos(sp.sqrt(g/R)*t) + (b - g*phi0)*sp.sqrt(R/g)*"
        "sp.sin(sp.sqrt(g/R)*t), sp.sqrt(g/R)*t < 50), (0, True))",
        "nothing after many periods",
    ),
    right("6.1", "a_polynomial", "transition.charpoly(lam)", "as SymPy returns it"),
]

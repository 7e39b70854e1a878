"""Chapters 6 and 7: reconstruction and solvability."""

from adversarial import right, wrong

ROWS = [
    wrong("6.1", "c_kappa", "145.4", "one per cent off"),
    wrong("6.1", "d_digits", "0.2195", "one per cent off"),
    right("6.1", "d_digits", "0.217", "three digits"),
    right("6.1", "b_circle", "4*(1 - sp.cos(phi))**2 + kappa*(2 + sp.cos(phi))/3", "a square and a positive term"),
    wrong("6.2", "b_limit", "1.515*Delta/tau**2", "one per cent off"),
    right("6.2", "c_direct", "rho*sp.Max(Delta - D*tau**2, 0)**2/6", "the same where D tau**2 < Delta"),
    right("6.2", "c_sweep", "rho*(Delta - 2*D*tau**2/3)**2/6", "a third taken out of the square"),
    wrong("6.3", "a_decay", "0.714*(rho/M)**0.25", "one per cent off"),
    right("6.3", "a_decay", "0.707*(rho/M)**0.25", "three digits of 1/sqrt(2)"),
    wrong("7.1", "d_worst", "delta*(1 + sp.cos(sp.sqrt(g/R)*tau))/(R*(1 - sp.cos(sp.sqrt(g/R)*tau)))",
          "after a quarter of a period the cosine is negative"),
    right("7.1", "d_worst", "sp.Max(1/(1 - sp.cos(sp.sqrt(g/R)*tau)) - sp.Rational(1, 2), sp.Rational(1, 2))*2*delta/R",
          "by cases of the cosine"),
    wrong("7.2", "b_condition", "sp.Ne(p**2*(y + w*t)**2, q**2*(x + u*t)**2)", "squaring adds a direction"),
    right("7.2", "b_condition", "sp.Ne((x + u*t)*q, (y + w*t)*p)", "the two products"),
    wrong("7.3", "b_unseen", "[[n1, 0, -n1**2/n3, 0, -2*omega*n1, 2*n1*n2*omega/n3], [0, 2, -2*n2/n3, omega, 0, "
          "-n1*omega/n3]]", "the first one vanishes for n1 = 0"),
    wrong("7.3", "d_insufficient", "sp.Eq(n1*k1 + n2*k2 + n3*k3, 1)", "opposite directions see the same"),
    right("7.3", "d_insufficient", "sp.Eq(sp.Abs(n1*k1 + n2*k2 + n3*k3), 1)", "the angle is 0 or pi"),
    right("7.4", "c_condition", "sp.exp(sp.asinh(1/delta))", "an inverse hyperbolic function"),
    right("7.4", "d_fooling", "1/sp.sinh(sp.log(M))", "a hyperbolic function"),
]

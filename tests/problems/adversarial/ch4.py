"""Chapter 4: estimation."""

from adversarial import right, wrong

ROWS = [
    wrong("4.1", "b_determined", "sp.Ne(h**2, k**2)", "h = -k is determined"),
    wrong("4.1", "c_determined", "sp.Ne(x[0]/a + x[1]/b + x[2]/c, 0)", "this plane goes through the centre"),
    wrong("4.1", "d_unseen", "[[b*x[2]**2, a*x[2]**2, x[2]*(a*b - a*x[1] - b*x[0])]]", "zero for x3 = 0"),
    wrong("4.1", "e_determined", "sp.Ne(p*(3*p - 1), 0)", "the origin helps too"),
    right("4.1", "b_determined", "sp.Abs(h - k) > 0", "a difference of heights"),
    right("4.1", "c_determined", "(x[0]/a + x[1]/b + x[2]/c - 1)**2 > 0", "beside the plane"),
    wrong("4.2", "b_real", "q >= 2.64", "the border is 8/3"),
    right("4.2", "b_real", "q >= 2.67", "8/3 to three digits"),
    right("4.2", "a_zero", "h**2 > 0", "a square"),
    wrong("4.15", "settles", "sp.And(a < 0, sp.Ne(a, -1))", "a = -1 settles"),
    wrong("4.15", "rises", "P0 < -Q/(2*a)", "for a > 0 it rises from every start"),
    right("4.15", "settles", "sp.exp(a) < 1", "the exponential is monotonic"),
    right("4.15", "rises", "sp.Or(P0 < Q/(2*sp.Abs(a)), a >= 0)", "below the limit, or without one"),
    right("4.15", "limit", "sp.sqrt(Q**2/(4*a**2))", "the root of the square"),
    wrong("4.17", "settles", "sp.And(a > 0, b > 0, sp.Ne(a**2, 4*b))", "a double root settles too"),
    right("4.17", "settles", "sp.Min(a, b) > 0", "the smaller one is positive"),
    wrong("4.18", "limit", "[[0.017, 0], [0, 0.1]]", "two digits of 1/60"),
    right("4.18", "limit", "[[0.0167, 0], [0, 0.1]]", "three digits of 1/60"),
    wrong("4.19", "settles", "sp.And(alpha > -1, alpha < 1, sp.Ne(alpha, 0))", "for alpha = 0 it settles at once"),
    right("4.19", "settles", "sp.Abs(alpha**3) < 1", "the cube of the modulus"),
    wrong("4.20", "settles", "sp.Ne(alpha, 0)", "for alpha = 0 it settles too"),
    right("4.20", "settles", "alpha**2 > -1", "it holds everywhere"),
    right("4.23", "gain", "[(sp.sqrt(Q**2 + 4*Q*R) - Q)/(2*R)]*2", "the root of the quadratic for the gain"),
    wrong("4.33", "exists", "sp.Ne(b*(a**2 - 4*b), 0)", "a double root is no obstacle"),
    right("4.33", "exists", "b**2 > 0", "a square"),
    wrong("4.38", "limit_exists", "sp.And(a > 0, b > 0, a**2 > 4*b)", "oscillations settle too"),
    right("4.38", "limit_exists", "sp.Min(a, b) > 0", "the smaller one is positive"),
]

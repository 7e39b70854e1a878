# %% wrong
# Are these the coefficients of the polynomial instead of the gain? (hint 2)
family = sp.Matrix([beta1, beta2, beta3])
# Was the change of coordinates to the canonical form left out? (hint 1)
family = sp.Matrix([b - c for b, c in zip(betas, coefficients[::-1])])
# Is this the sign of a feedback $u = Kx$? The correction enters the errors with a minus. (hint 2)
family = -family
# Are positive coefficients enough for a cubic? (hint 2)
polynomial = (A - two_corrections * H).charpoly(lam)
region = sp.And(*(c > 0 for c in polynomial.all_coeffs()[1:]))
region = sp.And(l2 > 0, l3 > 0)  # Is it enough that the gains are positive? (hint 1)
# Is the last minor enough by itself? (hint 2)
a1, a2, a3 = (A - two_corrections * H).charpoly(lam).all_coeffs()[1:]
region = sp.expand(a1 * a2 - a3) > 0
# Is it enough to correct the last line alone? (hint 1)
e = sp.Matrix(estimates)
equations = list(A * e + 5 * sp.Matrix([0, 0, 1]) * (z - (H * e)[0]))
# Do errors decay with a gain on the border? (hint 1)
e, border = sp.Matrix(estimates), family.subs({beta1: 1, beta2: 2, beta3: 2})
equations = list(A * e + border * (z - (H * e)[0]))
# Is the measurement fed in, or its difference from what is expected? (hint 1)
e, gain = sp.Matrix(estimates), family.subs({beta1: 3, beta2: 3, beta3: 1})
equations = list(A * e + gain * z)
# What should z be compared with? It is not x itself. (hint 1)
e, gain = sp.Matrix(estimates), family.subs({beta1: 3, beta2: 3, beta3: 1})
equations = list(A * e + gain * (z - e1))

# %% right
family = family.applyfunc(sp.together).T  # over one denominator, as a row
# the product not expanded
a1, a2, a3 = (A - two_corrections * H).charpoly(lam).all_coeffs()[1:]
region = sp.And(a1 > 0, a3 > 0, a1 * a2 > a3)
# all roots at -1
e, gain = sp.Matrix(estimates), family.subs({beta1: 3, beta2: 3, beta3: 1})
equations = list(A * e + gain * (z - (H * e)[0]))
# other gains, with decimals
e, gain = sp.Matrix(estimates), family.subs({beta1: 6, beta2: 11.5, beta3: 6.5})
equations = list(A * e + gain * (z - (H * e)[0]))

# %% numbers
coefficients, weights = [
    ([2, -1, -1], [3, 2]),
    ([3, -2, -1], [2, 1]),
    ([-2, -1, -2], [1, 1]),
    ([-3, 1, -1], [1, 2]),
    ([2, -3, -2], [3, 1]),
    ([-1, -2, -1], [2, 1]),
    ([4, -1, -1], [1, 1]),
    ([1, -3, -1], [2, 1]),
    ([-2, 2, -1], [3, 1]),
    ([3, -1, -2], [3, 2]),
    ([-1, -1, -2], [1, 2]),
    ([1, -2, -3], [3, 2]),
    ([-3, -2, -1], [3, 1]),
]
shown = [
    r"\dddot x «+coefficients[2]*»\ddot x «+coefficients[1]*»\dot x «+coefficients[0]*»x = 0, "
    r"\qquad z = «weights[1]*»\dot x «+weights[0]*»x .",
]
unknown = sp.symbols("l1:4", real=True)
of_errors = (A - sp.Matrix(unknown) * H).charpoly(lam).as_expr(lam)
comparison = sp.Poly(of_errors - any_polynomial, lam).coeffs()
family = sp.Matrix(unknown).subs(sp.solve(comparison, unknown))
a1, a2, a3 = (A - two_corrections * H).charpoly(lam).all_coeffs()[1:]
region = sp.And(a1 > 0, a3 > 0, sp.expand(a1 * a2 - a3) > 0)
e, gain = sp.Matrix(estimates), family.subs({beta1: 3, beta2: 3, beta3: 1})
equations = list(A * e + gain * (z - (H * e)[0]))

# %% wrong
# Is this plain asymptotic stability, with the degree of stability forgotten? (hint 1)
a_region = sp.And(k1 < -diagonal, k2 < diagonal * k1)
# Were the roots shifted to the wrong side? (hint 1)
m, d = margin, diagonal
a_region = sp.And(k1 <= 2 * m - d, k2 <= (k1 - m) * (d - m))
# By how much does the trace of a matrix of order two change with the shift? (hint 1)
m, d = margin, diagonal
a_region = sp.And(k1 <= -d - m, k2 <= (d + m) * (k1 + m))
# Was the sign of the determinant reversed? (hint 1)
m = margin
b_region = sp.And(k1 <= -2 * m, k2 >= m * (k1 + m) / factor)
# Was the matrix itself compared with the degree of stability, instead of the shifted one? (hint 1)
b_region = sp.And(k1 <= -margin, k2 <= -margin)
# Which of the two branches of the hyperbola agrees with the trace? (hint 2)
c_region = (k1 - margin) * (k2 - margin) >= coupling
# Is it enough to look at the diagonal? (hint 1)
c_region = sp.And(k1 >= margin, k2 >= margin)
# Is this the region of item b without the exchange of the parameters? (hint 1)
m = margin
d_region = sp.And(k1 <= -2 * m, k2 <= m * (k1 + m))
# Is this plain asymptotic stability, with the degree of stability forgotten? (hint 1)
d_region = sp.And(k2 < 0, k1 < 0)
# Is this plain asymptotic stability, with the degree of stability forgotten? (hint 1)
e_region = sp.And(k1 > -1, k1 + k2 > 0)
# Is this the determinant before the shift? (hint 1)
e_region = sp.And(k1 >= 2 * margin - 1, k1 + k2 >= 0)
# Is this plain asymptotic stability? The degree of stability requires more. (hint 1)
f_region = 2 * k1 - 3 * k2 + k1 * k2 - 4 < 0
# Was only the determinant considered, without the trace? (hint 1)
f_region = (1 + margin) * (margin - 2) - (2 + k2) * (k1 - 3) >= 0
# Was the product of the coupling terms left out of the determinant? (hint 1)
m = margin
f_repaired_region = sp.And(k1 + k2 <= 1 - 2 * m, (k1 + 1 + m) * (k2 - 2 + m) >= 0)
# Was the inequality divided by a factor without regard to its sign? (hint 2)
m = margin
f_repaired_region = sp.And(k1 + k2 <= 1 - 2 * m, k2 - 2 + m >= -6 / (k1 + 1 + m))

# %% right
# strict, solved for k1
m, d = margin, diagonal
a_region = sp.And(k1 < -d - 2 * m, k1 > k2 / (d + m) - m)
# a list of the two conditions on the shifted matrix, with plain symbols
p, q, m, d = *sp.symbols("k1 k2"), margin, diagonal
a_region = [p + d + 2 * m <= 0, (d + m) * (p + m) - q >= 0]
# the coefficients of the shifted polynomial
b_region = [-(k1 + 2 * margin) > 0, margin * (k1 + margin) - factor * k2 > 0]
# as a set of points
m = margin
b_region = sp.ConditionSet((k1, k2), (k1 <= -2 * m) & (factor * k2 <= m * (k1 + m)), sp.S.Reals**2)
# trace and determinant as they come
determinant = sp.expand((k1 - margin) * (k2 - margin)) - coupling
c_region = sp.And(k1 + k2 >= 2 * margin, determinant >= 0)
# solved for k2
c_region = sp.And(k1 > margin, k2 >= margin + coupling / (k1 - margin))
# a negation
d_region = sp.Not(sp.Or(k2 > -2 * margin, k1 > margin * (k2 + margin)))
# with decimals, solved for k2
d_region = sp.And(k2 <= -2.0 * margin, k2 >= k1 / margin - float(margin))
# as a product of half-lines, or as a set of points where the border is oblique
m = margin
e_region = (
    sp.ProductSet(sp.Interval(1, sp.oo), sp.Interval(0, sp.oo))
    if m == 1
    else sp.ConditionSet((k1, k2), (k1 >= 2 * m - 1) & (k2 >= (m - 1) * (k1 - m)), sp.S.Reals**2)
)
e_region = [k1 > 2 * margin - 1, k2 > (margin - 1) * (k1 - margin)]  # strict
f_region = sp.S.EmptySet  # the empty set
# a contradiction between parameters, as an elimination may leave it
f_region = sp.And(k1 > 3, k1 < 3)
# multiplied out
m = margin
f_repaired_region = sp.And(
    k1 + k2 + 2 * m - 1 <= 0, sp.expand((k1 + 1 + m) * (k2 - 2 + m)) + 6 >= 0
)
# strict, with the case distinction of a division by the first factor
p, q = k1 + 1 + margin, k2 - 2 + margin
f_repaired_region = sp.And(
    p + q < 0,
    sp.Or(sp.And(p > 0, q > -6 / p), sp.Eq(p, 0), sp.And(p < 0, q < -6 / p)),
)

# %% numbers
margin, diagonal, factor, coupling = [
    (1, 1, 1, 1),
    (2, 3, 2, 4),
    (3, 2, 3, 2),
    (sp.Rational(3, 2), 2, 2, 3),
    (4, 1, 2, 2),
    (sp.Rational(5, 2), 1, 3, 4),
    (sp.Rational(7, 2), 1, 1, 1),
    (sp.Rational(9, 2), 2, 1, 2),
    (6, 1, 1, 2),
    (sp.Rational(11, 2), 2, 1, 2),
    (5, 2, 2, 3),
    (7, 2, 2, 1),
    (8, 1, 3, 2),
]
shown = [
    "degree of stability «str(margin)»",
    r"\operatorname{Re}\lambda \leq -«margin»$",
    r"x = \exp(-«margin*»t) y",
    r"A + «margin*»I",
    r"\dot x_2 = k_2x_1 + «diagonal*»x_2,$",
    r"\dot x_1 = k_1x_1 + k_2x_2,$ $\quad \dot x_2 = «factor*»x_1",
    r"\dot x_1 = -k_1x_1 + «coupling*»x_2",
    "«'each of them depends on one parameter only' if margin == 1 else "
    "'the trace depends on one parameter only'»",
]
m = margin
a_region = sp.And(k1 <= -diagonal - 2 * m, k2 <= (diagonal + m) * (k1 + m))
b_region = sp.And(k1 <= -2 * m, factor * k2 <= m * (k1 + m))
c_region = sp.And(k1 > m, (k1 - m) * (k2 - m) >= coupling)
d_region = sp.And(k2 <= -2 * m, k1 <= m * (k2 + m))
e_region = sp.And(k1 >= 2 * m - 1, k2 >= (m - 1) * (k1 - m))
f_region = sp.false
f_repaired_region = sp.And(k1 + k2 <= 1 - 2 * m, (k1 + 1 + m) * (k2 - 2 + m) + 6 >= 0)

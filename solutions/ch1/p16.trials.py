# %% wrong
# Is this plain asymptotic stability, with the margin forgotten? (hint 1)
a_region = sp.And(k1 < -1, k2 < k1)
a_region = sp.And(k1 <= 1, k2 <= 0)  # Were the roots moved to the wrong side? (hint 1)
# By how much does the trace of a matrix of order two change with the shift? (hint 1)
a_region = sp.And(k1 <= -2, k2 <= 2 * k1 + 2)
b_region = sp.And(k1 <= -2, k2 >= k1 + 1)  # Did the determinant get its sign turned? (hint 1)
# Was the matrix itself compared with the margin, instead of the shifted one? (hint 1)
b_region = sp.And(k1 <= -1, k2 <= -1)
# Which of the two branches of the hyperbola agrees with the trace? (hint 2)
c_region = (k1 - 1) * (k2 - 1) >= 1
c_region = sp.And(k1 >= 1, k2 >= 1)  # Is it enough to look at the diagonal? (hint 1)
# Is this the region of item b without the exchange of the parameters? (hint 1)
d_region = sp.And(k1 <= -2, k2 <= k1 + 1)
# Is this plain asymptotic stability, with the margin forgotten? (hint 1)
d_region = sp.And(k2 < 0, k1 < 0)
# Is this plain asymptotic stability, with the margin forgotten? (hint 1)
e_region = sp.And(k1 > -1, k1 + k2 > 0)
e_region = sp.And(k1 >= 1, k1 + k2 >= 0)  # Is this the determinant before the shift? (hint 1)
# Is this plain asymptotic stability? The margin asks for more. (hint 1)
f_region = 2 * k1 - 3 * k2 + k1 * k2 - 4 < 0
# Was the determinant looked at alone, without the trace? (hint 1)
f_region = -2 - (2 + k2) * (k1 - 3) >= 0
# Was the product of the coupling terms left out of the determinant? (hint 1)
f_repaired_region = sp.And(k1 + k2 <= -1, (k1 + 2) * (k2 - 1) >= 0)
# Was the inequality divided by a factor without asking for its sign? (hint 2)
f_repaired_region = sp.And(k1 + k2 <= -1, k2 - 1 >= -6 / (k1 + 2))

# %% right
a_region = sp.And(k1 < -3, k1 > k2 / 2 - 1)  # strict, solved for k1
# a list of the two conditions on A + E, with plain symbols
p, q = sp.symbols("k1 k2")
a_region = [p + 3 <= 0, 2 * (p + 1) - q >= 0]
b_region = [-(k1 + 2) > 0, k1 + 1 - k2 > 0]  # the coefficients of the shifted polynomial
# as a set of points
b_region = sp.ConditionSet((k1, k2), (k1 <= -2) & (k2 <= k1 + 1), sp.S.Reals**2)
c_region = sp.And(k1 + k2 >= 2, k1 * k2 - k1 - k2 >= 0)  # trace and determinant as they come
c_region = sp.And(k1 > 1, k2 >= 1 + 1 / (k1 - 1))  # solved for k2
d_region = sp.Not(sp.Or(k2 > -2, k1 > k2 + 1))  # a negation
d_region = sp.And(k2 <= -2.0, k2 >= k1 - 1.0)  # with decimals, solved for k2
# as a product of half-lines
e_region = sp.ProductSet(sp.Interval(1, sp.oo), sp.Interval(0, sp.oo))
e_region = [k1 > 1, k2 > 0]  # strict
f_region = sp.S.EmptySet  # the empty set
# a contradiction between parameters, as an elimination may leave it
f_region = sp.And(k1 > 3, k1 < 3)
f_repaired_region = sp.And(k1 + k2 + 1 <= 0, k1 * k2 - k1 + 2 * k2 + 4 >= 0)  # multiplied out
# strict, with the case distinction of a division by k1 + 2
f_repaired_region = sp.And(
    k1 + k2 < -1,
    sp.Or(
        sp.And(k1 > -2, k2 - 1 > -6 / (k1 + 2)),
        sp.Eq(k1, -2),
        sp.And(k1 < -2, k2 - 1 < -6 / (k1 + 2)),
    ),
)

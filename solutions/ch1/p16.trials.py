# %% wrong
a_region = sp.And(k1 < -1, k2 < k1)  # plain asymptotic stability, the margin forgotten
a_region = sp.And(k1 <= 1, k2 <= 0)  # the roots moved to the wrong side: A - E in the place of A + E
a_region = sp.And(k1 <= -2, k2 <= 2*k1 + 2)  # the trace of A + E taken as trace A + 1
b_region = sp.And(k1 <= -2, k2 >= k1 + 1)  # the sign of the determinant turned
b_region = sp.And(k1 <= -1, k2 <= -1)  # the trace and the determinant of A itself compared with the margin
c_region = (k1 - 1)*(k2 - 1) >= 1  # the second branch of the hyperbola taken along
c_region = sp.And(k1 >= 1, k2 >= 1)  # the diagonal alone looked at
d_region = sp.And(k1 <= -2, k2 <= k1 + 1)  # the answer of item b copied without exchanging the parameters
d_region = sp.And(k2 < 0, k1 < 0)  # plain asymptotic stability, the margin forgotten
e_region = sp.And(k1 > -1, k1 + k2 > 0)  # plain asymptotic stability, the margin forgotten
e_region = sp.And(k1 >= 1, k1 + k2 >= 0)  # the determinant of A, not of A + E
f_region = 2*k1 - 3*k2 + k1*k2 - 4 < 0  # asymptotic stability, which the printed system can have, taken for the margin
f_region = -2 - (2 + k2)*(k1 - 3) >= 0  # the determinant of A + E alone
f_repaired_region = sp.And(k1 + k2 <= -1, (k1 + 2)*(k2 - 1) >= 0)  # the coupling 2*(-3) left out of the determinant
f_repaired_region = sp.And(k1 + k2 <= -1, k2 - 1 >= -6/(k1 + 2))  # divided by k1 + 2 without asking for its sign

# %% right
a_region = sp.And(k1 < -3, k1 > k2/2 - 1)  # strict, solved for k1
# a list of the two conditions on A + E, with plain symbols
p, q = sp.symbols("k1 k2")
a_region = [p + 3 <= 0, 2*(p + 1) - q >= 0]
b_region = [-(k1 + 2) > 0, k1 + 1 - k2 > 0]  # the coefficients of the shifted polynomial
b_region = sp.ConditionSet((k1, k2), (k1 <= -2) & (k2 <= k1 + 1), sp.S.Reals**2)  # as a set of points
c_region = sp.And(k1 + k2 >= 2, k1*k2 - k1 - k2 >= 0)  # trace and determinant as they come
c_region = sp.And(k1 > 1, k2 >= 1 + 1/(k1 - 1))  # solved for k2
d_region = sp.Not(sp.Or(k2 > -2, k1 > k2 + 1))  # a negation
d_region = sp.And(k2 <= -2.0, k2 >= k1 - 1.0)  # with decimals, solved for k2
e_region = sp.ProductSet(sp.Interval(1, sp.oo), sp.Interval(0, sp.oo))  # as a product of half-lines
e_region = [k1 > 1, k2 > 0]  # strict
f_region = sp.S.EmptySet  # the empty set
f_region = sp.And(k1 > 3, k1 < 3)  # a contradiction between parameters, as an elimination may leave it
f_repaired_region = sp.And(k1 + k2 + 1 <= 0, k1*k2 - k1 + 2*k2 + 4 >= 0)  # multiplied out
# strict, with the case distinction of a division by k1 + 2
f_repaired_region = sp.And(k1 + k2 < -1,
                           sp.Or(sp.And(k1 > -2, k2 - 1 > -6/(k1 + 2)), sp.Eq(k1, -2),
                                 sp.And(k1 < -2, k2 - 1 < -6/(k1 + 2))))

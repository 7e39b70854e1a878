# %% wrong
a_region = sp.And(k1 > 0, k2 > 0)  # positive coefficients taken for sufficient
a_region = k1*k2 > 1  # the sign of k1 forgotten: the left-hand branch of the hyperbola taken along
a_region = sp.And(k1 > 0, k1*k2 >= 1)  # the boundary counted in, where a pair of roots is imaginary
b_region = sp.And(k2 > 0, k1 < k2)  # the second minor with its sign turned
c_region = sp.And(k2 > 0, k1*k2 < 1)  # multiplied by k1 without asking for its sign
d_region = sp.And(k1 > 0, k2 > 1)  # the criterion for leading coefficient 1 used without dividing: 1*k2 > 1
e_region = sp.And(k1 > 0, k2 > 0)  # only the signs of the coefficients

# %% right
a_region = sp.And(k1 > 0, k2 > 1/k1)  # solved for k2
# all three minors left as they come, with plain symbols
p, q = sp.symbols("k1 k2")
a_region = [p > 0, p*q - 1 > 0, 1*(p*q - 1) > 0]
b_region = sp.Not(sp.Or(k1 <= 0, k2 <= 0, k1 <= k2))  # with the implied condition kept, as a negation
b_region = sp.ConditionSet((k1, k2), (0 < k2) & (k2 < k1), sp.S.Reals**2)  # as a set of points
c_region = sp.And(k1 > 0, 0 < k2, k2 < 1/k1)  # solved for k2
c_region = [1/k1 > 0, k2/k1 > 0, 1/k1**2 > k2/k1]  # the divided coefficients as they come
d_region = sp.And(k1 > 0, k2 > 0, k2/k1 > 1)  # a quotient
d_region = sp.And(k1 >= 0, k1 < k2)  # chained, with the line of lower order counted in
e_region = sp.And(k2 - k1 > 0, k1 > 0, k2 > 0)  # the same wedge with the redundant sign kept

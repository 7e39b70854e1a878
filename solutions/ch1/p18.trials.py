# %% wrong
a_region = sp.And(k1 > 0, k2 > 0)  # positive coefficients taken for sufficient
a_region = k1 > 0  # the trace alone: -k1 negative
a_region = k1*k2 > 1  # the sign of k1 forgotten: the left-hand branch of the hyperbola taken along
a_region = sp.And(k1 > 0, k1*k2 >= 1)  # the boundary counted in, where a pair of roots is imaginary
b_region = sp.And(k1 > 0, k2 > k1)  # k1 and k2 exchanged when the coefficients were read off
b_region = sp.And(k2 >= 0, k1 >= k2)  # the sides counted in, where roots lie on the imaginary axis
b_region = sp.And(k1 > 0, k2 > 0)  # positive coefficients taken for sufficient

# %% right
a_region = sp.And(k1 > 0, k2 > 1/k1)  # solved for k2
# all three minors as they come, with plain symbols
p, q = sp.symbols("k1 k2")
a_region = [p > 0, p*q - 1 > 0, p*q - 1 > 0]
a_region = sp.Not(sp.Or(k2 <= 0, k1 <= 1/k2))  # by the other variable, as a negation
b_region = [k1 > 0, k2 > 0, k1 - k2 > 0]  # with the implied condition kept
b_region = sp.ConditionSet((k1, k2), (0 < k2) & (k2 < k1), sp.S.Reals**2)  # as a set of points

# %% wrong
a_region = sp.And(k1 > 0, k2 > 0)  # Are positive coefficients enough for a cubic? (hint 2)
a_region = k1 > 0  # Is it enough to look at the sum of the roots? (hint 2)
a_region = k1 * k2 > 1  # Can this product be large with both factors negative? (hint 2)
# Does a pair of imaginary roots on the border leave the zero solution asymptotically stable? (hint
# 2)
a_region = sp.And(k1 > 0, k1 * k2 >= 1)
# Were two coefficients swapped when they were read off? (hint 1)
b_region = sp.And(k1 > 0, k2 > k1)
# Do roots on the imaginary axis leave the zero solution asymptotically stable? (hint 2)
b_region = sp.And(k2 >= 0, k1 >= k2)
b_region = sp.And(k1 > 0, k2 > 0)  # Are positive coefficients enough for a cubic? (hint 2)

# %% right
a_region = sp.And(k1 > 0, k2 > 1 / k1)  # solved for k2
# all three minors as they come, with plain symbols
p, q = sp.symbols("k1 k2")
a_region = [p > 0, p * q - 1 > 0, p * q - 1 > 0]
a_region = sp.Not(sp.Or(k2 <= 0, k1 <= 1 / k2))  # by the other variable, as a negation
b_region = [k1 > 0, k2 > 0, k1 - k2 > 0]  # with the implied condition kept
b_region = sp.ConditionSet((k1, k2), (0 < k2) & (k2 < k1), sp.S.Reals**2)  # as a set of points

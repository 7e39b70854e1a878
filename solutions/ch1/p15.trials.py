# %% wrong
# Are positive coefficients enough for a cubic? Which minor was not looked at? (hint 1)
a_region = sp.And(k1 > 0, k2 > 0)
# Is this the sign of one minor alone? Try a point where both parameters are negative. (hint 2)
a_region = k1 * k2 > p_a
# Does a pair of imaginary roots on the border still make the zero solution asymptotically stable?
# (hint 2)
a_region = sp.And(k1 > 0, k1 * k2 >= p_a)
# Does the second minor have the wrong sign? Compute the roots at one point of your region. (hint 1)
b_region = sp.And(k2 > 0, p_b * k1 < k2)
# Was the inequality multiplied by a parameter without regard to its sign? (hint 1)
c_region = sp.And(k2 > 0, k1 * k2 < p_c)
# Was the criterion for the leading coefficient 1 used without dividing the equation first? (hint 1)
d_region = sp.And(k1 > 0, k2 > p_d)
# Are these the signs of the coefficients alone? Which minor can still fail? (hint 2)
e_region = sp.And(k1 > 0, k2 > 0)

# %% right
a_region = sp.And(k1 > 0, k2 > p_a / k1)  # solved for k2
# all three minors left as they come, with plain symbols
p, q = sp.symbols("k1 k2")
a_region = [p > 0, p * q - p_a > 0, p_a * (p * q - p_a) > 0]
# with the implied condition kept, as a negation
b_region = sp.Not(sp.Or(k1 <= 0, k2 <= 0, p_b * k1 <= k2))
b_region = sp.ConditionSet(
    (k1, k2), (0 < k2) & (k2 < p_b * k1), sp.S.Reals**2
)  # as a set of points
c_region = sp.And(k1 > 0, 0 < k2, k2 < p_c / k1)  # solved for k2
c_region = [1 / k1 > 0, k2 / k1 > 0, p_c / k1**2 > k2 / k1]  # the divided coefficients as they come
d_region = sp.And(k1 > 0, k2 > 0, k2 / k1 > p_d)  # a quotient
d_region = sp.And(k1 >= 0, p_d * k1 < k2)  # chained, with the line of lower order counted in
e_region = sp.And(p_e * k2 - k1 > 0, k1 > 0, k2 > 0)  # the same wedge with the redundant sign kept

# %% numbers
p_a, p_b, p_c, p_d, p_e = [(1, 1, 1, 1, 1)] + [
    tuple((start + step * k) % 5 + 2 for k in range(5))
    for start in range(4)
    for step in (1, 2, 3, 4)
]
shown = [
    r"\dddot x + k_1 \ddot x + k_2\dot x + «p_a*»x = 0",
    r"\dddot x + «p_b*»\ddot x + k_1\dot x + k_2 x = 0",
    r"k_1\dddot x + «p_c*»\ddot x + \dot x + k_2 x = 0",
    r"k_1\dddot x + \ddot x + k_2\dot x + «p_d*»x = 0",
    r"k_1\dddot x + k_2\ddot x + «p_e*»\dot x + x = 0",
]
a_region = sp.And(k1 > 0, k1 * k2 > p_a)
b_region = sp.And(k2 > 0, p_b * k1 > k2)
c_region = sp.And(k1 > 0, k2 > 0, k1 * k2 < p_c)
d_region = sp.And(k1 > 0, k2 > p_d * k1)
e_region = sp.And(k1 > 0, p_e * k2 > k1)

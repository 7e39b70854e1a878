# %% wrong
a_middle = t * (1 - t)  # What is it at the middle time itself? (hint 2)
a_middle = 1 - 2 * sp.Abs(t - half)  # Is a hat made of straight lines a polynomial? (hint 1)
# This is the motion. What can be known of it from only six values? (hint 1)
b_formula = x0 / (1 + x0 * t)
# Does each curve have its own initial value? (hint 2)
b_formula = (x0 - 1) * (1 - 5 * t / 6 + t**2 / 3) + (2 - x0) * (2 - 8 * t / 3 + 4 * t**2 / 3)
# Does a series about $t = 0$ use the values at the later times? (hint 1)
b_formula = x0 - x0**2 * t + x0**3 * t**2
b_formula = 1 - 5 * t / 6 + t**2 / 3  # Where is the initial value? (hint 2)
c_curve = -t * (2 * t - 1) * (t - 1) / (6 * (1 + t))  # Is it the formula minus the motion? (hint 2)
c_curve = t * (2 * t - 1) * (t - 1) / 6  # Was the denominator of the motion lost? (hint 2)
c_curve = 0  # Is a reference curve known between the times of the table, too? (hint 1)
# On which side of the curve does its chord lie? (hint 2)
d_moment = (x0 - 1) * (2 - x0) / (6 * (1 + x0))
d_moment = (x0 - 1) * (x0 - 2) / 6  # Was the denominator of the motion lost? (hint 1)
# This is the rate of the formula. Which rate does the equation give? (hint 2)
e_defect = 1 - 11 * x0 / 6
e_defect = 0  # Does the formula satisfy the equation because its value is right? (hint 1)
# What is the sign of the right-hand side of the equation? (hint 2)
e_defect = 1 - 11 * x0 / 6 - x0**2

# %% right
a_middle = 1 - (2 * t - 1) ** 2  # by its vertex
# the double sum of the statement
L1, L2, L3 = (2 * t - 1) * (t - 1), 4 * t * (1 - t), t * (2 * t - 1)
b_formula = (L1 + 2 * L2 / 3 + L3 / 2) * (2 - x0) + (2 * L1 + L2 + 2 * L3 / 3) * (x0 - 1)
c_curve = 1 - 5 * t / 6 + t**2 / 3 - 1 / (1 + t)  # not put over one denominator
d_moment = sp.Rational(1, 6) * x0 - sp.Rational(2, 3) + 1 / (1 + x0)  # in partial fractions
# a square and a rest: it vanishes for no start
e_defect = (x0 - sp.Rational(11, 12)) ** 2 + sp.Rational(23, 144)

# %% wrong
a_region = epsilon > 0  # Is friction alone enough? What does the spring have to do? (hint 1)
# Can this product be positive with both factors negative? (hint 1)
a_region = epsilon * omega2 > 0
# Do motions without friction tend to zero? (hint 1)
a_region = sp.And(epsilon >= 0, omega2 > 0)
# Must the pendulum swing in order to be stable? (hint 1)
a_region = sp.And(epsilon > 0, epsilon**2 < 4 * omega2)
# Is it enough to look at the sum of the roots? One of them may be slow. (hint 1)
b_region = sp.And(epsilon >= 2, omega2 > 0)
# Was the line shifted to the wrong side? (hint 1)
b_region = sp.And(epsilon >= -2, omega2 >= -epsilon - 1)
# Was the last coefficient shifted in full? (hint 1)
b_region = sp.And(epsilon >= 2, omega2 >= epsilon)
b_region = sp.And(epsilon > 0, omega2 > 0)  # Was the margin forgotten? (hint 1)

# %% right
a_region = [epsilon > 0, epsilon * omega2 > 0]  # both minors as they come
# a set, with plain symbols
p, q = sp.symbols("omega2 epsilon")
a_region = sp.ConditionSet((p, q), sp.And(p > 0, q > 0), sp.S.Reals**2)
a_region = sp.Interval.open(0, sp.oo) * sp.Interval.open(0, sp.oo)  # a product of intervals
# the interior, both minors after the shift
b_region = [epsilon - 2 > 0, (epsilon - 2) * (omega2 - epsilon + 1) > 0]
b_region = sp.And(2 <= epsilon, epsilon <= 1 + omega2)  # solved for epsilon
# plain symbols, one side closed and one open
p, q = sp.symbols("omega2 epsilon")
b_region = sp.And(q >= 2, p - q > -1)

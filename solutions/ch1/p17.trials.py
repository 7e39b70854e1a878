# %% wrong
a_region = epsilon > 0  # friction alone taken for enough
a_region = epsilon*omega2 > 0  # only the second minor, which is positive in the third quadrant too
a_region = sp.And(epsilon >= 0, omega2 > 0)  # the side without friction counted in
a_region = sp.And(epsilon > 0, epsilon**2 < 4*omega2)  # complex roots demanded: a swinging pendulum
b_region = sp.And(epsilon >= 2, omega2 > 0)  # only the sum of the roots looked at: the overdamped pendulum forgotten
b_region = sp.And(epsilon >= -2, omega2 >= -epsilon - 1)  # shifted to the wrong side: lambda = mu + 1
b_region = sp.And(epsilon >= 2, omega2 >= epsilon)  # the last coefficient not shifted in full
b_region = sp.And(epsilon > 0, omega2 > 0)  # the margin forgotten

# %% right
a_region = [epsilon > 0, epsilon*omega2 > 0]  # both minors as they come
# a set, with plain symbols
p, q = sp.symbols("omega2 epsilon")
a_region = sp.ConditionSet((p, q), sp.And(p > 0, q > 0), sp.S.Reals**2)
a_region = sp.Interval.open(0, sp.oo)*sp.Interval.open(0, sp.oo)  # a product of intervals
b_region = [epsilon - 2 > 0, (epsilon - 2)*(omega2 - epsilon + 1) > 0]  # the interior, both minors after the shift
b_region = sp.And(2 <= epsilon, epsilon <= 1 + omega2)  # solved for epsilon
# plain symbols, one side closed and one open
p, q = sp.symbols("omega2 epsilon")
b_region = sp.And(q >= 2, p - q > -1)

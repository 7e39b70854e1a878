# %% wrong
a_region = epsilon > 0  # Is friction alone enough? What does the spring have to do? (hint 1)
# Can this product be positive with both factors negative? (hint 1)
a_region = epsilon * omega2 > 0
# Do motions without friction tend to zero? (hint 1)
a_region = sp.And(epsilon >= 0, omega2 > 0)
# Must the pendulum oscillate in order to be stable? (hint 1)
a_region = sp.And(epsilon > 0, epsilon**2 < 4 * omega2)
# Is it enough to look at the sum of the roots? One of them may be slow. (hint 1)
b_region = sp.And(epsilon >= 2 * margin, omega2 > 0)
# Was the line shifted to the wrong side? (hint 1)
m = margin
b_region = sp.And(epsilon >= -2 * m, omega2 >= -m * epsilon - m**2)
# Was the last coefficient shifted in full? (hint 1)
b_region = sp.And(epsilon >= 2 * margin, omega2 >= margin * epsilon)
b_region = sp.And(epsilon > 0, omega2 > 0)  # Was the degree of stability forgotten? (hint 1)

# %% right
a_region = [epsilon > 0, epsilon * omega2 > 0]  # both minors as they come
# a set, with plain symbols
p, q = sp.symbols("omega2 epsilon")
a_region = sp.ConditionSet((p, q), sp.And(p > 0, q > 0), sp.S.Reals**2)
a_region = sp.Interval.open(0, sp.oo) * sp.Interval.open(0, sp.oo)  # a product of intervals
# the interior, both minors after the shift
p, q = epsilon - 2 * margin, omega2 - margin * epsilon + margin**2
b_region = [p > 0, p * q > 0]
b_region = sp.And(2 * margin <= epsilon, epsilon <= margin + omega2 / margin)  # solved for epsilon
# plain symbols, one side closed and one open
p, q = sp.symbols("omega2 epsilon")
b_region = sp.And(q >= 2 * margin, p - margin * q > -(margin**2))

# %% numbers
margin = [1, 2, 3, 4, 5, 6] + [
    sp.Rational(p, q) for p, q in [(1, 2), (3, 2), (5, 2), (7, 2), (1, 3), (2, 3), (4, 3), (5, 3)]
]
shown = [
    "degree of stability «str(margin)»",
    r"\operatorname{Re} \lambda \leq -«margin»$",
    r"\operatorname{Re}\lambda \leq -«margin»$",
    r"\operatorname{Re} \lambda = -«margin»$",
]
b_region = sp.And(epsilon >= 2 * margin, omega2 - margin * epsilon + margin**2 >= 0)
site_share = sp.Rational(1, 2)  # item a has no number

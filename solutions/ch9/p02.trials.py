# %% wrong
a_greatest = D / T + a * T  # Is the mean speed the initial speed? (hint 1)
a_greatest = D / T  # Must the speed be constant because no change was measured? (hint 2)
# Which power of time does the weighted integral give? (hint 1)
a_greatest = D / T + a * T / 3
a_least = D / T - a * T / 2  # How fast can the vehicle brake? (hint 1)
a_least = D / T - b * T  # Is the mean speed the initial speed? (hint 1)
b_first = D / T + a * T / 2  # Did the vehicle become faster or slower after the time 0? (hint 2)
b_first = D / T + b * T  # Is the mean speed the final speed? (hint 1)

# %% right
a_greatest = (2 * D + a * T**2) / (2 * T)  # one fraction
a_greatest = sp.Rational(1, 2) * (sp.sqrt((D / T) ** 2) * 2 + T * a)  # a root of a square
a_least = -(b * T**2 / 2 - D) / T  # with the sign in front
b_first = (D - b * T**2 / 2) / T + b * T  # the speed at the end and what was lost on the way

# %% wrong
plain = S / n  # How many measurements are there, if they are counted from zero? (hint 2)
plain = S  # Is this the sum? (hint 2)
plain_variance = R / n  # How many measurements are there, if they are counted from zero?
plain_variance = R  # Is this the variance of a single measurement? (hint 1)
# How many variances are added up before the sum is divided? (hint 1)
plain_variance = R / (n + 1) ** 2
filtered = (R * mu + P * S) / (R + n * P)  # How often is it corrected? (hint 1)
filtered = S / (n + 1)  # Is the prior knowledge used? (hint 2)
# Does the prior knowledge have the weight of one measurement? (hint 2)
filtered = (mu + S) / (n + 2)
# Which has the larger weight if the variance of the measurements is large?
filtered = (P * mu + R * S) / (P + (n + 1) * R)
filtered_variance = P * R / (R + n * P)  # How often is it corrected? (hint 1)
filtered_variance = P * R / (R + P)  # How often is it corrected? (hint 1)
filtered_variance = 1 / P + (n + 1) / R  # Is this the variance, or its inverse?
wide = mu  # Which has the full weight here, the expectation or the measurements? (hint 1)
wide = S / n  # How many measurements are there, if they are counted from zero?
# Which has the full weight here, the expectation or the measurements? (hint 1)
narrow = S / (n + 1)
narrow = 0 * mu  # Is $x$ known to be zero here? (hint 1)

# %% right
filtered = mu + (n + 1) * P / (R + (n + 1) * P) * (S / (n + 1) - mu)  # a correction by the mean
filtered_variance = 1 / (1 / P + (n + 1) / R)  # inverse variances add up

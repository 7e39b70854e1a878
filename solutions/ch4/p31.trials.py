# %% wrong
before = z1  # Is the value at the time 1 valid at all times before? (hint 2)
before = z1 * sp.exp(1 - t)  # What becomes of this long before the first value?
before = (z1 + z2 + z3) / 3  # Are near and far values equally correlated with x(t)? (hint 1)
# Does a straight line satisfy the equations for the weights? (hint 2)
first = z1 * (2 - t) + z2 * (t - 1)
# Are the two values correlated with each other too? (hint 2)
first = z1 * sp.exp(1 - t) + z2 * sp.exp(t - 2)
first = z1 * sp.exp(1 - t)  # Is the later of the two values used?
first = (z1 * sp.sinh(t - 1) + z2 * sp.sinh(2 - t)) / sp.sinh(1)  # What does this give at $t = 1$?
# What does this give at $t = 2$? (hint 1)
second = (z2 * sp.sinh(2 - t) + z3 * sp.sinh(t - 1)) / sp.sinh(1)
second = z2 * (3 - t) + z3 * (t - 2)  # Does a straight line satisfy the equations for the weights?
after = z3  # What is the mean of the process long after the last value?
after = z3 * sp.exp(t - 3)  # What becomes of this long after the last value?
# Is $z_2$ more strongly correlated with $x(t)$ than $z_3$? (hint 1)
after = z1 * sp.exp(1 - t) + z2 * sp.exp(2 - t) + z3 * sp.exp(3 - t)
first_variance = 1 - sp.exp(2 - 2 * t)  # Is the later of the two values used? (hint 2)
# Is this the standard deviation?
first_variance = sp.sqrt(2 * sp.sinh(t - 1) * sp.sinh(2 - t) / sp.sinh(1))
# What does this give at $t = 1$? (hint 2)
first_variance = 1 - sp.exp(2 - 2 * t) - sp.exp(2 * t - 4)
after_variance = 1 - sp.exp(3 - t)  # By what is the variance of $z_3$ multiplied? (hint 1)
after_variance = sp.exp(6 - 2 * t)  # What must this be at $t = 3$? (hint 1)

# %% right
# the other form of the weights
first = ((sp.exp(1 - t) - sp.exp(t - 3)) * z1 + (sp.exp(t - 2) - sp.exp(-t)) * z2) / (
    1 - sp.exp(-2)
)
# what is left between two ends
first_variance = (1 - sp.exp(2 - 2 * t)) * (1 - sp.exp(2 * t - 4)) / (1 - sp.exp(-2))
after_variance = 2 * sp.exp(3 - t) * sp.sinh(t - 3)  # a product

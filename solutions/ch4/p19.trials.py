# %% wrong
mean = mu  # Does the mean remain constant in each step? (hint 1)
mean = alpha ** (2 * k) * mu  # Is this how a variance is multiplied? (hint 1)
# How does a factor enter a variance? (hint 1)
variance = alpha**k * P0 + Q * (1 - alpha**k) / (1 - alpha)
# How many noise terms have entered after one step? (hint 2)
variance = alpha ** (2 * k) * P0 + Q * (1 - alpha ** (2 * k + 2)) / (1 - alpha**2)
variance = Q * (1 - alpha ** (2 * k)) / (1 - alpha**2)  # Is the initial state known exactly?
border = P0 + Q  # What happens in the second step? (hint 1)
border = P0 + k**2 * Q  # Is the same noise added in each step? (hint 1)
state = alpha**3 * x0 + q0 + q1 + q2  # What do later steps do to the noise terms? (hint 1)
# Which of the noise terms entered first? (hint 2)
state = alpha**3 * x0 + q0 + alpha * q1 + alpha**2 * q2
share = alpha**n * Q  # Is this the factor of the noise, or of its variance? (hint 1)
share = Q  # Is the contribution the same in later steps? (hint 1)
settles = alpha < 1  # Try $\alpha = -2$. (hint 1)
# What becomes of the variance at $\alpha = -1$? (hint 1)
settles = sp.And(alpha >= -1, alpha < 1)
limit = Q / (1 - alpha)  # How does a factor enter a variance? (hint 1)
limit = 0  # The mean decays. Does the noise? (hint 1)

# %% right
variance = Q / (1 - alpha**2) + (P0 - Q / (1 - alpha**2)) * alpha ** (2 * k)  # limit and difference
settles = abs(alpha) < 1  # by the modulus
limit = Q / ((1 - alpha) * (1 + alpha))  # in factors
state = alpha * (alpha * (alpha * x0 + q0) + q1) + q2  # one step into the other

# %% wrong
covariance = -sp.sin(2 * alpha)  # Are $x_1$ and $x_2$ themselves correlated? (hint 1)
# What is the sign of the sine in the second component? (hint 2)
covariance = sp.cos(2 * alpha) + sp.sin(2 * alpha)
# The variance of a sum has one more term. Which? (hint 1)
variance = 5 * sp.cos(alpha) ** 2 + 3 * sp.sin(alpha) ** 2
variance = 5 * sp.cos(alpha) + 3 * sp.sin(alpha)  # How do factors enter a variance? (hint 1)
angles = {sp.pi / 8}  # Is this the only one? (hint 2)
angles = {3 * sp.pi / 8, 7 * sp.pi / 8}  # Was the angle measured in the other direction? (hint 1)
# Are these the directions of $x_1$ and $x_2$, which are correlated? (hint 1)
angles = {0, sp.pi / 2}
angles = {sp.pi / 4}  # Was the angle halved at the end? (hint 1)

# %% right
covariance = sp.sqrt(2) * sp.cos(2 * alpha + sp.pi / 4)  # one cosine
variance = 4 + sp.sqrt(2) * sp.cos(2 * alpha - sp.pi / 4)  # the same
angles = {sp.atan(1) / 2, sp.atan(1) / 2 + sp.pi / 2}  # by the inverse tangent

# %% wrong
# Try $a = 3$, $b = 2$: does the initial state keep its influence? (hint 1)
settles = sp.And(a > 0, 4 * b > a**2)
# What dissipates the energy supplied by the noise, if $a = 0$? (hint 1)
settles = sp.And(a >= 0, b > 0)
# Are these the exponents of the mean? (hint 1)
exponents = [(-a + sp.sqrt(a**2 - 4 * b)) / 2, (-a - sp.sqrt(a**2 - 4 * b)) / 2]
# Are there squares only? (hint 2)
exponents = [-a + sp.sqrt(a**2 - 4 * b), -a - sp.sqrt(a**2 - 4 * b)]
limit = sp.diag(Q / (a * b), Q / a)  # How often does $a$ appear in the rate of $p_{22}$? (hint 1)
# Which of the two variances is determined by the friction alone? (hint 1)
limit = sp.diag(Q / (2 * a), Q / (2 * a * b))
# Is the covariance multiplied on one side only? (hint 2)
root = sp.sqrt(b - a**2 / 4)
g = sp.exp(-a * t / 2) * sp.sin(root * t) / root
E = sp.Matrix([[g.diff(t) + a * g, g], [-b * g, g.diff(t)]])
rest = sp.diag(Q / (2 * a * b), Q / (2 * a))
motion = rest + E * (process.covariance - rest)
# Does the formula give the initial covariance at $t = 0$? (hint 1)
root = sp.sqrt(b - a**2 / 4)
g = sp.exp(-a * t / 2) * sp.sin(root * t) / root
E = sp.Matrix([[g.diff(t) + a * g, g], [-b * g, g.diff(t)]])
motion = sp.diag(Q / (2 * a * b), Q / (2 * a)) + E * process.covariance * E.T
# Is it one exponential, without powers of the time? (hint 1)
critical = sp.diag(2 * Q / a**3, Q / (2 * a)) * (1 - sp.exp(-a * t))
# Does nothing remain in the end? (hint 1)
critical = Q * sp.Matrix([[t**3 / 3, t**2 / 2], [t**2 / 2, t]]) * sp.exp(-a * t)
# This is right on average. Which terms oscillate with the motion? (hint 2)
undamped = sp.diag(Q * t / (2 * omega**2), Q * t / 2)
# Is the frequency of a square that of the motion? (hint 2)
undamped = Q * sp.Matrix(
    [
        [(t - sp.sin(omega * t) / omega) / (2 * omega**2), sp.sin(omega * t) ** 2 / (2 * omega**2)],
        [sp.sin(omega * t) ** 2 / (2 * omega**2), (t + sp.sin(omega * t) / omega) / 2],
    ]
)
# Do position and speed remain uncorrelated? (hint 1)
springless = sp.diag(Q * t / a**2, Q * (1 - sp.exp(-2 * a * t)) / (2 * a))
springless = Q * sp.Matrix([[t**3 / 3, t**2 / 2], [t**2 / 2, t]])  # Where is the friction? (hint 1)

# %% right
settles = sp.And(a + b > 0, a * b > 0)  # by sum and product
limit = sp.diag(1 / b, 1) * Q / (2 * a)  # a factor in front
# by the roots of the characteristic equation
first, second = -a / 2 + sp.sqrt(a**2 / 4 - b), -a / 2 - sp.sqrt(a**2 / 4 - b)
g = (sp.exp(first * t) - sp.exp(second * t)) / (first - second)
E = sp.Matrix([[g.diff(t) + a * g, g], [-b * g, g.diff(t)]])
rest = sp.diag(Q / (2 * a * b), Q / (2 * a))
motion = rest + E * (process.covariance - rest) * E.T
# by the law of the matrix exponential
E = sp.exp(-a * t / 2) * sp.Matrix([[1 + a * t / 2, t], [-(a**2) * t / 4, 1 - a * t / 2]])
rest = sp.diag(2 * Q / a**3, Q / (2 * a))
critical = rest - E * rest * E.T

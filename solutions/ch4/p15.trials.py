# %% wrong
mean = mu0 * sp.exp(2 * a * t)  # Is this the rate of a square? (hint 1)
mean = mu0 + Q * t  # Does white noise push to one side on the average? (hint 1)
# Does the square of a deviation change at this rate? (hint 1)
variance = P0 * sp.exp(a * t) + Q * (sp.exp(a * t) - 1) / a
# Does noise from early on stay as large as it was? (hint 1)
variance = P0 * sp.exp(2 * a * t) + Q * t
# Which sign has the equilibrium? (hint 2)
variance = (P0 - Q / (2 * a)) * sp.exp(2 * a * t) + Q / (2 * a)
# Did the process start from a known point? (hint 2)
variance = Q * (sp.exp(2 * a * t) - 1) / (2 * a)
# Is the intensity already a square?
variance = P0 * sp.exp(2 * a * t) + Q**2 * (sp.exp(2 * a * t) - 1) / (2 * a)
# Do uncorrelated steps add up, or their squares? (hint 1)
wiener = P0 + Q * t**2
wiener = Q * t  # What was there at the start? (hint 1)
wiener = P0  # Does the noise stop when the motion does? (hint 1)
settles = a <= 0  # Try the border itself. (hint 1)
settles = a > 0  # Which deviations fade? (hint 1)
limit = -Q / a  # Is this the rate of the deviation or of its square? (hint 1)
limit = Q / (2 * a)  # Can a variance have this sign where there is a limit? (hint 1)
rises = a > 0  # Is there a start from which the variance rises though deviations fade? (hint 1)
# Is there a start from which the variance rises though deviations fade? (hint 1)
rises = a >= 0
rises = 2 * a * P0 + Q >= 0  # What does a stationary process do?
rises = 2 * a * P0 - Q > 0  # Which sign has the noise in the rate of change? (hint 1)
rises = a * P0 + Q > 0  # Is the rate that of a deviation or of its square? (hint 1)

# %% right
# with a hyperbolic function
variance = P0 * sp.exp(2 * a * t) + Q * sp.exp(a * t) * sp.sinh(a * t) / a
# both cases at once
variance = sp.Piecewise(
    (P0 + Q * t, sp.Eq(a, 0)), ((P0 + Q / (2 * a)) * sp.exp(2 * a * t) - Q / (2 * a), True)
)
settles = sp.Interval.open(-sp.oo, 0)  # as a set
limit = Q / (2 * sp.Abs(a))  # with the modulus
rises = sp.Or(a >= 0, P0 < -Q / (2 * a))  # below the limit, or no limit

# %% wrong
recursion = a**2 * p + Q  # Was the measurement used? (hint 1)
# Is this after the measurement, and not yet before the next one? (hint 1)
recursion = p * R / (h**2 * p + R)
recursion = a**2 * p * R / (h * p + R) + Q  # How does the factor h enter a variance?
# Is this root a variance? (hint 2)
root = sp.sqrt((h**2 * Q + (a**2 - 1) * R) ** 2 + 4 * h**2 * Q * R)
prior = (h**2 * Q + (a**2 - 1) * R - root) / (2 * h**2)
# Is this the variance of the process itself, without a measurement? (hint 1)
prior = Q / (1 - a**2)
# Is this the formula of continuous time? (hint 1)
prior = (a * R + sp.sqrt(a**2 * R**2 + h**2 * Q * R)) / h**2
# Is it the variance before the measurement? (hint 1)
root = sp.sqrt((h**2 * Q + (a**2 - 1) * R) ** 2 + 4 * h**2 * Q * R)
posterior = (h**2 * Q + (a**2 - 1) * R + root) / (2 * h**2)
posterior = R / h**2  # Is this what a single measurement alone would leave? (hint 1)
# Was the factor of the measurement forgotten?
root = sp.sqrt((h**2 * Q + (1 - a**2) * R) ** 2 + 4 * a**2 * h**2 * Q * R)
gain = 2 * Q / (h**2 * Q + (1 - a**2) * R + root)
# Is this the gain of the predictor, $aK$?
root = sp.sqrt((h**2 * Q + (1 - a**2) * R) ** 2 + 4 * a**2 * h**2 * Q * R)
gain = 2 * a * h * Q / (h**2 * Q + (1 - a**2) * R + root)
# How does the prediction change an error? (hint 1)
root = sp.sqrt((h**2 * Q + (1 - a**2) * R) ** 2 + 4 * a**2 * h**2 * Q * R)
decay = [1 - 2 * h**2 * Q / (h**2 * Q + (1 - a**2) * R + root)]
decay = [a]  # Is this what happens without a measurement? (hint 1)
quiet = 0  # Do errors decay if the gain is zero? (hint 2)
quiet = (a**2 - 1) * R / h**2  # Is it the variance before the measurement?
unmeasured = Q / (1 - a)  # By which factor does a step multiply a variance? (hint 2)
unmeasured = Q  # Does the noise of earlier steps contribute nothing? (hint 2)
unmeasured = Q * R / (Q + R)  # Is there a measurement to correct with? (hint 1)

# %% right
# by the prediction, backwards
root = sp.sqrt((h**2 * Q + (a**2 - 1) * R) ** 2 + 4 * h**2 * Q * R)
posterior = ((h**2 * Q + (a**2 - 1) * R + root) / (2 * h**2) - Q) / a**2
# with the root below
root = sp.sqrt((h**2 * Q + (a**2 - 1) * R) ** 2 + 4 * h**2 * Q * R)
prior = 2 * Q * R / (root - h**2 * Q - (a**2 - 1) * R)
recursion = a**2 / (1 / p + h**2 / R) + Q  # informations add up
unmeasured = Q / 2 * (1 / (1 - a) + 1 / (1 + a))  # partial fractions

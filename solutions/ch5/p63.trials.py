# %% wrong
# Which sign does a stabilising feedback $u = Kx$ have? (hint 1)
gain = -gain
# Which root of the Riccati equation was taken, and where does the motion go with it? (hint 2)
root = sp.sqrt(rate**2 + sp.Rational(weight, price))
gain = root - rate
gain = price * gain  # Was the weight of the control in the square forgotten? (hint 1)
# Is the weight of the control 1 here? (hint 1)
gain = -(rate + sp.sqrt(rate**2 + weight))
# This mirrors the eigenvalue of the free motion. Does the deviation cost nothing here?
gain = -2 * rate
# Does the factor in front of the integral belong to both terms? (hint 1)
gain = -rate - sp.sqrt(rate**2 + sp.Rational(weight, 2 * price))
# Is this the value of the integral alone? (hint 2)
root = sp.sqrt(rate**2 + sp.Rational(weight, price))
cost = price * (rate + root) * x0**2
# Can an integral of squares be negative?
root = sp.sqrt(rate**2 + sp.Rational(weight, price))
cost = price * (rate - root) / 2 * x0**2
# How does the cost change if the initial state is doubled? (hint 1)
root = sp.sqrt(rate**2 + sp.Rational(weight, price))
cost = price * (rate + root) / 2 * x0
# Was a half counted twice? (hint 2)
root = sp.sqrt(rate**2 + sp.Rational(weight, price))
cost = price * (rate + root) / 4 * x0**2
# Does this motion decay? (hint 1)
eigenvalues = [-eigenvalues[0]]
eigenvalues = [rate]  # Is this the motion without control? (hint 1)
eigenvalues = [gain]  # Is this the gain alone, without the free motion? (hint 1)

# %% right
# the conjugate
root = sp.sqrt(rate**2 + sp.Rational(weight, price))
gain = sp.Rational(weight, price) / (rate - root)
gain = round(float(gain), 2)  # three digits
# a matrix of one entry
gain = sp.Matrix([[-rate - sp.sqrt(rate**2 + sp.Rational(weight, price))]])
# under one root
cost = x0**2 * (rate + sp.sqrt(rate**2 + sp.Rational(weight, price))) * price / 2
# the conjugate
root = sp.sqrt(rate**2 + sp.Rational(weight, price))
cost = weight * x0**2 / (2 * (root - rate))
# under one root
eigenvalues = [-sp.sqrt(rate**2 + sp.Rational(weight, price))]
eigenvalues = [round(float(eigenvalues[0]), 2)]  # three digits

# %% numbers
rate, weight, price = [
    (1, 1, 2),
    (2, 1, 3),
    (1, 3, 2),
    (2, 1, 2),
    (1, 2, 3),
    (2, 2, 3),
    (3, 1, 2),
    (1, 5, 3),
    (2, 3, 2),
    (1, 3, 4),
    (2, 5, 2),
    (1, 1, 4),
    (1, 1, 3),
    (1, 5, 2),
    (3, 2, 3),
    (1, 4, 3),
]
shown = [
    r"\dot x - «rate*»x = u",
    r"\big(«weight*»x^2 + «price*»u^2\big)",
]
root = sp.sqrt(rate**2 + sp.Rational(weight, price))
gain = -rate - root
cost = price * (rate + root) / 2 * x0**2
eigenvalues = [-root]

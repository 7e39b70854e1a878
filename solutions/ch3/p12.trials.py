# %% wrong
free_region = sp.false  # Does the second coordinate not act back on the first one? (hint 1)
free_region = epsilon > 0  # How strong has the coupling to be against the growth? (hint 1)
free_region = epsilon >= 1  # Where is the second root on the border? (hint 1)
# What if the part left to itself drives the other one further away? (hint 1)
gain = sp.Matrix([[-2, 0]])
# What is this gain where the coupling vanishes? (hint 1)
gain = sp.Matrix([[-2, 2 - 1 / epsilon]])
# With which sign does the parameter enter the polynomial? (hint 1)
gain = sp.Matrix([[-2, 2 + epsilon]])
gain = []  # Does the uncontrollable part not decay by itself?
# Which sign has the feedback in the statement? (hint 1)
prescribed = sp.Matrix([[gamma1 - 1, -2 + (4 + gamma2 - 2 * gamma1) / epsilon]])
# Does one of the gains stand in both coefficients? (hint 1)
prescribed = sp.Matrix([[1 - gamma1, 2 - (4 + gamma2) / epsilon]])
# Is this the gain of a chain of integrators? (hint 1)
prescribed = sp.Matrix([[-gamma1, -gamma2]])
region = (k1 < 1) & (k2 < 2 - 2 * (1 + k1) / epsilon)  # Which sign may the divisor have? (hint 2)
# Are there no other gains for a single value of the parameter? (hint 1)
region = (k1 < -1) & sp.Eq(k2, 2)
region = k1 < 1  # Can one root be positive while the sum is negative? (hint 1)
# Must each term be positive, or only their sum? (hint 1)
region = (k1 < -1) & (epsilon * (2 - k2) > 0)
# It is controllable in general. What happens at the exceptional value? (hint 1)
margins = sp.true
margins = sp.Ne(epsilon, 0)  # How fast does the fixed mode decay? (hint 1)
margins = mu <= 2  # Does the limit of one value of the parameter hold for the others? (hint 2)
# Does the definition of a margin exclude equality? (hint 2)
margins = sp.Ne(epsilon, 0) | (mu < 2)

# %% right
free_region = epsilon - 1 > 0  # the last coefficient
gain = sp.Matrix([[-5, 2]])  # further along the half-line
gain = sp.Matrix([[-2, 2 - epsilon]])  # a gain that follows epsilon
gain = [-2 - epsilon**2, 2]  # the first entry varies
# over one denominator
prescribed = sp.Matrix([[1 - gamma1, (2 * epsilon + 2 * gamma1 - gamma2 - 4) / epsilon]])
# Ackermann's formula
W = B.row_join(A * B)
psi = A**2 + gamma1 * A + gamma2 * sp.eye(2)
prescribed = (-sp.Matrix([[0, 1]]) * W.inv() * psi).applyfunc(sp.cancel)
# the coefficients as they come
region = (1 - k1 > 0) & (2 * epsilon - 2 - 2 * k1 - epsilon * k2 > 0)
# cases of epsilon
region = (k1 < 1) & sp.Or(
    (epsilon > 0) & (k2 < 2 - 2 * (1 + k1) / epsilon),
    (epsilon < 0) & (k2 > 2 - 2 * (1 + k1) / epsilon),
    sp.Eq(epsilon, 0) & (k1 < -1),
)
margins = sp.Or(epsilon > 0, epsilon < 0, sp.Eq(epsilon, 0) & (mu <= 2))  # by cases

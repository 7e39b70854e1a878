# %% wrong
free_region = sp.false  # Does the second coordinate not act back on the first one? (hint 1)
free_region = epsilon > 0  # How strong must the coupling be to stop the growth? (hint 1)
# What is the second root on the border? (hint 1)
free_region = coupling * epsilon >= growth * decay
# What if the coupling through $x_2$ drives $x_1$ further away? (hint 1)
gain = sp.Matrix([[-growth - 1, 0]])
# What is this gain where the coupling vanishes? (hint 1)
gain = sp.Matrix([[-growth - 1, coupling - 1 / epsilon]])
# With which sign does the parameter enter the polynomial? (hint 1)
gain = sp.Matrix([[-growth - 1, coupling + epsilon]])
gain = []  # Does the uncontrollable part not decay by itself?
# What is the sign of the feedback in the statement? (hint 1)
prescribed = -prescribed
# Does one of the gains appear in both coefficients? (hint 1)
prescribed = sp.Matrix([[prescribed[0], coupling - (growth * decay + decay + gamma2) / epsilon]])
# Is this the gain of a chain of integrators? (hint 1)
prescribed = sp.Matrix([[-gamma1, -gamma2]])
# What signs may the divisor have? (hint 2)
region = (k1 < decay - growth) & (k2 < coupling - decay * (growth + k1) / epsilon)
# Are there no other gains for a single value of the parameter? (hint 1)
region = (k1 < -growth) & sp.Eq(k2, coupling)
region = k1 < decay - growth  # Can one root be positive while the sum is negative? (hint 1)
# Must each term be positive, or only their sum? (hint 1)
region = (k1 < -growth) & (epsilon * (coupling - k2) > 0)
# It is controllable in general. What happens at the exceptional value? (hint 1)
margins = sp.true
margins = sp.Ne(epsilon, 0)  # How fast does the fixed mode decay? (hint 1)
# Does the limit of one value of the parameter hold for the others? (hint 2)
margins = mu <= decay
# Does the definition of a degree of stability exclude equality? (hint 2)
margins = sp.Ne(epsilon, 0) | (mu < decay)

# %% right
free_region = coupling * epsilon - growth * decay > 0  # the last coefficient
gain = sp.Matrix([[-growth - 4, coupling]])  # further along the half-line
gain = sp.Matrix([[-growth - 1, coupling - epsilon]])  # a gain that follows epsilon
gain = [-growth - 1 - epsilon**2, coupling]  # the first entry varies
prescribed = prescribed.applyfunc(sp.together)  # over one denominator
# Ackermann's formula
W = B.row_join(A * B)
psi = A**2 + gamma1 * A + gamma2 * sp.eye(2)
prescribed = (-sp.Matrix([[0, 1]]) * W.inv() * psi).applyfunc(sp.cancel)
# the coefficients as they come
last = coupling * epsilon - growth * decay - decay * k1 - epsilon * k2
region = (decay - growth - k1 > 0) & (last > 0)
# cases of epsilon
region = (k1 < decay - growth) & sp.Or(
    (epsilon > 0) & (k2 < coupling - decay * (growth + k1) / epsilon),
    (epsilon < 0) & (k2 > coupling - decay * (growth + k1) / epsilon),
    sp.Eq(epsilon, 0) & (k1 < -growth),
)
margins = sp.Or(epsilon > 0, epsilon < 0, sp.Eq(epsilon, 0) & (mu <= decay))  # by cases

# %% numbers
growth, coupling, decay = [
    *[(1, 2, 2), (1, 3, 3), (2, 1, 3), (1, 4, 3), (2, 3, 4), (3, 1, 4), (1, 3, 5)],
    *[(2, 5, 3), (3, 2, 5), (1, 5, 4), (2, 1, 5), (4, 3, 5), (3, 4, 6), (1, 1, 3)],
]
shown = [
    r"\dot x_1 = «growth*»x_1 - «coupling*»x_2 + u, "
    r"\qquad \dot x_2 = \varepsilon x_1 - «decay*»x_2"
]
free_region = epsilon > sp.Rational(growth * decay, coupling)
gain = sp.Matrix([[-growth - 1, coupling]])
prescribed = sp.Matrix(
    [[decay - growth - gamma1, coupling + (decay * gamma1 - decay**2 - gamma2) / epsilon]]
)
region = sp.And(k1 < decay - growth, epsilon * (coupling - k2) > decay * (growth + k1))
margins = sp.Or(sp.Ne(epsilon, 0), mu <= decay)

# %% wrong
# Must an eigenvalue zero be excluded? (hint 1)
a_region = sp.And(sp.Ne(lam1, lam2), sp.Ne(lam1 * lam2, 0))
a_region = True  # Is the whole system observable whenever each part is? (hint 1)
# Must the oscillators be equal for a motion to be unobservable, or is one common root enough? (hint
# 2)
b_region = sp.Or(sp.Ne(p, 3), sp.Ne(k, 2))
b_region = sp.Ne(k, p - 1)  # What is the other eigenvalue of the first block? (hint 1)
# Were the eigenvalues of the first oscillator taken with the wrong sign? (hint 1)
b_region = sp.And(sp.Ne(k, -p - 1), sp.Ne(k, -2 * p - 4))
b_region = k > p**2 / 4  # Must the roots be complex? (hint 1)
# What is the output of each of the two eigenvectors? Combine them so that the outputs cancel. (hint
# 2)
c_unobservable_states = [[1, 0, -1, -q]]
c_unobservable_states = [[2, 0, -q, -(q**2)]]  # Were the two coefficients swapped? (hint 2)
c_unobservable_states = [
    [q, 0, 2, 2 * q]
]  # Do the outputs add up here instead of cancelling? (hint 2)
# Is the theorem about two outputs that are measured separately? (hint 1)
d_observable = False

# %% right
# the difference squared, with plain symbols
u, w = sp.symbols("lam1 lam2")
a_region = (u - w) ** 2 > 0
a_region = sp.Or(lam1 > lam2, lam1 < lam2)  # two open half-planes
# the resultant of the two polynomials
x = sp.Symbol("x")
b_region = sp.Ne(sp.resultant(x**2 + 3 * x + 2, x**2 + p * x + k, x), 0)
b_region = [sp.Ne(p, k + 1), sp.Ne(p, k / 2 + 2)]  # a list of conditions, solved for p
b_region = sp.Not(sp.Or(sp.Eq(1 - p + k, 0), sp.Eq(4 - 2 * p + k, 0)))  # a negation
c_unobservable_states = [[1, 0, -2 / q, -2]]  # divided by q, which is positive
# the other sign and length, plain symbols
Q, S = sp.symbols("q s")
c_unobservable_states = [[-Q * (Q + S), 0, 2 * (Q + S), 2 * Q * (Q + S)]]

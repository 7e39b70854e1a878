# %% wrong
a_region = sp.And(sp.Ne(lam1, lam2), sp.Ne(lam1*lam2, 0))  # an eigenvalue zero excluded needlessly
a_region = True  # each part is observable, so the whole is thought to be
b_region = sp.Or(sp.Ne(p, 3), sp.Ne(k, 2))  # only equal oscillators excluded: one common root forgotten to be enough
b_region = sp.Ne(k, p - 1)  # only the eigenvalue -1 thought of
b_region = sp.And(sp.Ne(k, -p - 1), sp.Ne(k, -2*p - 4))  # the signs of the eigenvalues of the first oscillator turned
b_region = k > p**2/4  # complex roots taken for necessary
c_unseen = [[1, 0, -1, -q]]  # the two eigenvectors subtracted without regard to what the outputs show of them
c_unseen = [[2, 0, -q, -q**2]]  # the amounts exchanged
c_unseen = [[q, 0, 2, 2*q]]  # the sign: the outputs add up
d_observable = False  # the theorem used for two outputs

# %% right
# the difference squared, with plain symbols
u, w = sp.symbols("lam1 lam2")
a_region = (u - w)**2 > 0
a_region = sp.Or(lam1 > lam2, lam1 < lam2)  # two open half-planes
# the resultant of the two polynomials
x = sp.Symbol("x")
b_region = sp.Ne(sp.resultant(x**2 + 3*x + 2, x**2 + p*x + k, x), 0)
b_region = [sp.Ne(p, k + 1), sp.Ne(p, k/2 + 2)]  # a list of conditions, solved for p
b_region = sp.Not(sp.Or(sp.Eq(1 - p + k, 0), sp.Eq(4 - 2*p + k, 0)))  # a negation
c_unseen = [[1, 0, -2/q, -2]]  # divided by q, which is positive
# the other sign and length, plain symbols
Q, S = sp.symbols("q s")
c_unseen = [[-Q*(Q + S), 0, 2*(Q + S), 2*Q*(Q + S)]]

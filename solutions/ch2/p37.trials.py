# %% wrong
a_controllable = True  # Is it enough that one of the equations contains the control? (hint 1)
a_uncontrollable_eigenvalues = [
    sp.I * Omega,
    -sp.I * Omega,
]  # Is the oscillation uncontrollable, or a constant? (hint 1)
a_uncontrollable_eigenvalues = []  # Is there no first integral? Look for an equation to integrate. (hint 1)
a_uncontrollable_eigenvalues = [
    0,
    sp.I * Omega,
    -sp.I * Omega,
]  # Are all roots uncontrollable? (hint 1)
# Is this rate constant by itself? Its equation contains another one. (hint 1)
a_uncontrolled = [[0, 0, 1, 0]]
a_uncontrolled = [[0, -2 * Omega / r0, 1, 0]]  # Was a sign lost in the integration? (hint 1)
# Are an angle and a height added here without a factor of length? (hint 1)
a_uncontrolled = [[0, 2 * Omega, 1, 0]]
# Is the angle itself uncontrollable as well? (hint 1)
a_uncontrolled = [[1, 0, 0, 0], [0, 2 * Omega / r0, 1, 0]]
b_controllable = False  # Is the height uncontrollable by a thrust along the orbit? (hint 1)
b_uncontrollable_eigenvalues = [0]  # Is this the uncontrollable root of the other case? (hint 1)
# Are these numbers roots of the determinant? (hint 1)
b_uncontrollable_eigenvalues = [sp.sqrt(3) * Omega, -sp.sqrt(3) * Omega]
c_region = sp.Or(sp.Ne(b1, 0), sp.Ne(b2, 0))  # Is any thrust at all enough? (hint 1)
c_region = sp.And(sp.Ne(b1, 0), sp.Ne(b2, 0))  # Must both components be present? (hint 1)
c_region = sp.Ne(b2, 0)  # Were the two cases swapped? (hint 1)

# %% right
a_uncontrollable_eigenvalues = [Omega - Omega]  # a zero that is computed
a_uncontrolled = [[0, 2 * Omega, r0, 0]]  # multiplied by r0
a_uncontrolled = [[0, -1, -r0 / (2 * Omega), 0]]  # as a height
c_region = sp.Ne(b1**2 * (4 * b1**2 + b2**2), 0)  # the determinant
c_region = sp.Or(b1 < 0, b1 > 0)  # two half-planes

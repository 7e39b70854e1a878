# %% wrong
# Is the system in canonical form already, with nothing of its own to cancel?
control = sp.Matrix([[-b3, -b2, -b1]])
# Is the feedback taken with a minus sign, $u = -Kx$?
control = -sp.Matrix([[b1 - b2 - 2, -b1, b2 - b1 - b3]])
# Has the polynomial of the system itself been taken off?
control = sp.Matrix([[b1 - b2, -b1, b2 - b1 - b3]])
# In which order do the coefficients of the polynomial stand?
control = sp.Matrix([[b3 - b2 - 2, -b3, b2 - b1 - b3]])
correction = sp.Matrix([g1, g2, g3])  # Are these the numbers for a system in canonical form?
# Does the correction enter the equations of the errors as + LH?
correction = (
    -sp.Matrix([2 + 2 * g1 + 2 * g2 - g3, 8 + 2 * g1 + 2 * g2 + 2 * g3, -2 + 4 * g1 - 2 * g2 + g3])
    / 6
)
# Has one power of the matrix been forgotten, that of the leading term?
correction = sp.Matrix([2 * g1 + 2 * g2 - g3, 2 * g1 + 2 * g2 + 2 * g3, 4 * g1 - 2 * g2 + g3]) / 6
# Try the roots of A - LH; is there a slip in one sign?
gains = [sp.Matrix([[-2, -3, -1]]), sp.Matrix([5, 10, -1])]
# A feedback that is fast enough; how fast does the estimate become right?
gains = [sp.Matrix([[-2, -3, -1]]), sp.Matrix([247, 634, 41]) / 384]
# Friction alone: what do the other two coefficients need?
gains = [sp.Matrix([[0, -2, 0]]), sp.Matrix([5, 10, 1])]
# Is the feedback taken with a minus sign, $u = -Ke$?
gains = [sp.Matrix([[2, 3, 1]]), sp.Matrix([5, 10, 1])]
# Does the copy contain the control of the plant?
equations = [e2 + 5 * (z - e1 - e3), e1 + e2 + e3 + 10 * (z - e1 - e3), e1 - e3 + (z - e1 - e3)]
# What would the copy measure: the first coordinate alone?
equations = [e2 + 5 * (z - e1), e1 + e2 + e3 + u + 10 * (z - e1), e1 - e3 + (z - e1)]
# Is the correction of one line enough? Look at the roots of the errors.
equations = [e2, e1 + e2 + e3 + u + 10 * (z - e1 - e3), e1 - e3]

# %% right
control = sp.Matrix([b1 - b2 - 2, -b1, b2 - b1 - b3])  # upright
# a flat list
correction = [
    g1 / 3 + g2 / 3 - g3 / 6 + sp.Rational(1, 3),
    (g1 + g2 + g3 + 4) / 3,
    (4 * g1 - 2 * g2 + g3 - 2) / 6,
]
# the regulator as fast as the observer
gains = [sp.Matrix([[-8, -6, -2]]), sp.Matrix([5, 10, 1])]
gains = [[-2.0, -3.0, -1.0], [12.0, 36.0, 3.0]]  # decimals, and another observer
# a faster one
equations = [
    e2 + 12 * (z - e1 - e3),
    e1 + e2 + e3 + u + 36 * (z - e1 - e3),
    e1 - e3 + 3 * (z - e1 - e3),
]
# multiplied out
equations = [
    5 * z - 5 * e1 + e2 - 5 * e3,
    10 * z - 9 * e1 + e2 - 9 * e3 + u,
    z - 2 * e3,
]

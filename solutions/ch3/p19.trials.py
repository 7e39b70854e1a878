# %% wrong
# Is the system in canonical form already, with nothing of its own to cancel?
control = sp.Matrix([[-b3, -b2, -b1]])
control = -control  # Is the feedback taken with a minus sign, $u = -Kx$?
# Has the polynomial of the system itself been subtracted?
control = control - control.subs({b1: 0, b2: 0, b3: 0})
# What is the order of the coefficients of the polynomial?
control = control.subs({b1: b3, b3: b1}, simultaneous=True)
correction = sp.Matrix([g1, g2, g3])  # Are these the numbers for a system in canonical form?
# Does the correction enter the equations of the errors as + LH?
correction = -correction
# Has one power of the matrix been forgotten, that of the leading term?
correction = correction - correction.subs({g1: 0, g2: 0, g3: 0})
# Check the roots of A - LH; is one sign wrong?
gains = [gains[0], sp.diag(1, 1, -1) * gains[1]]
# The feedback is fast enough; how fast does the estimate converge?
slow = {g1: sp.Rational(3, 4), g2: sp.Rational(3, 16), g3: sp.Rational(1, 64)}
gains = [gains[0], correction.subs(slow)]
# This is friction alone; what do the other two coefficients need?
gains = [sp.Matrix([[0, -A[1, 1] - 1, 0]]), gains[1]]
gains = [-gains[0], gains[1]]  # Is the feedback taken with a minus sign, $u = -Ke$?
# Does the copy contain the control of the plant?
equations = [rate.subs(u, 0) for rate in equations]
# What is the output of the copy: the first coordinate alone?
equations = list(A * sp.Matrix(estimates) + B * u + gains[1] * (z - e1))
# Is the correction of one line enough? Look at the roots of the errors.
novelty = z - (H * sp.Matrix(estimates))[0]
equations = list(A * sp.Matrix(estimates) + B * u + sp.diag(0, 1, 0) * gains[1] * novelty)

# %% right
control = control.T  # upright
correction = [sp.together(gain) for gain in correction]  # a flat list
# the regulator as fast as the observer
gains = [control.subs({b1: 6, b2: 12, b3: 8}), gains[1]]
# decimals, and another observer
gains = [
    [float(gain) for gain in gains[0]],
    [float(gain) for gain in correction.subs({g1: 9, g2: 27, g3: 27})],
]
# a faster one
novelty = z - (H * sp.Matrix(estimates))[0]
faster = correction.subs({g1: 9, g2: 27, g3: 27})
equations = list(A * sp.Matrix(estimates) + B * u + faster * novelty)
equations = [sp.expand(rate) for rate in equations]  # multiplied out

# %% numbers
from workbook.authoring.numbers import linear_form

A, H = [
    (sp.Matrix([[0, 1, 0], second, third]), sp.Matrix([measured]))
    for second, third, measured in [
        ([1, 1, 1], [1, 0, -1], [1, 0, 1]),
        ([1, 1, -1], [1, 0, 1], [1, 0, 1]),
        ([2, -2, -2], [1, 0, -2], [1, 0, -2]),
        ([3, -2, 1], [1, 0, 1], [1, 0, 1]),
        ([1, -1, 1], [-1, 0, 1], [1, 0, -1]),
        ([-2, 1, -1], [-1, 0, -1], [1, 0, 2]),
        ([-1, -1, -2], [1, 0, 1], [1, 0, 1]),
        ([1, -2, 1], [1, 0, -1], [1, 0, -2]),
        ([3, -1, -1], [1, 0, -1], [1, 0, -1]),
        ([-2, 2, -1], [1, 0, -1], [1, 0, -2]),
        ([2, -1, 1], [-1, 0, -1], [1, 0, 1]),
        ([3, -2, 2], [-1, 0, -1], [1, 0, 1]),
        ([-1, 1, 2], [1, 0, -1], [1, 0, -1]),
        ([2, -2, 2], [-1, 0, -2], [1, 0, 2]),
    ]
]
states, e = ["x_1", "x_2", "x_3"], sp.Matrix(estimates)
shown = [
    r"\dot x_2 = «linear_form([*A.row(1), 1], [*states, 'u'])», "
    r"\qquad \dot x_3 = «linear_form(A.row(2), states)», \qquad z = «linear_form(H, states)»",
    "«linear_form([1, *-H], ['z', 'e_1', 'e_2', 'e_3'])»",
]
last = sp.Matrix.hstack(B, A * B, A**2 * B).inv().row(2)
control = -(last * (A**3 + b1 * A**2 + b2 * A + b3 * sp.eye(3))).expand()
first = sp.Matrix.vstack(H, H * A, H * A**2).inv().col(2)
correction = ((A**3 + g1 * A**2 + g2 * A + g3 * sp.eye(3)) * first).expand()
gains = [control.subs({b1: 3, b2: 3, b3: 1}), correction.subs({g1: 6, g2: 12, g3: 8})]
equations = list(A * e + B * u + gains[1] * (z - (H * e)[0]))

# %% wrong
# Does a force against the displacement make the oscillation die out, or only faster?
static_region = k < 0
static_region = k > -1  # The oscillator has a spring then; does it have any friction?
control_region = sp.And(k1 < 1, k2 > 0)  # Was the feedback taken with a minus sign, $u = -Kx$?
# There is friction; what becomes of the spring if the control opposes it strongly?
control_region = k2 < 0
# In which direction does $u$ push $x_1$? Follow the signs through both equations.
control_region = sp.And(k1 < 1, k2 < 0)
error_region = sp.And(l1 > 0, l2 > -1)  # Was the minus sign in the first equation lost?
# Is the free motion damped, so that a small gain of the wrong sign is harmless?
error_region = sp.And(l1 > -1, l2 < 1)
# Was the correction added with the opposite sign, L(He - z)?
error_region = sp.And(l1 < 0, l2 > 1)
# Does this control brake or drive? It enters as $u = +Ke$.
gains = [sp.Matrix([[0, 2]]), sp.Matrix([4, -3])]
# Look at the product of the roots of the errors.
gains = [sp.Matrix([[0, -2]]), sp.Matrix([4, 3])]
# Is a force that depends on the position alone friction?
gains = [sp.Matrix([[-2, 0]]), sp.Matrix([4, -3])]
# Does the correction act on the first estimate at all?
gains = [sp.Matrix([[0, -2]]), sp.Matrix([0, -3])]
# Does the copy contain the control of the plant?
equations = [-e2 + 4 * (z - e1), e1 - 3 * (z - e1)]
# Is the measurement itself the correction, or its difference from the estimate?
equations = [-e2 + 4 * z, e1 + u - 3 * z]
# Does this correction drive the estimate towards the measurement?
equations = [-e2 - 4 * (z - e1), e1 + u + 3 * (z - e1)]
equations = [-e2, e1 + u]  # A copy without correction: does its error decay by itself?

# %% right
static_region = sp.And(k > 0, k < 0)  # a contradiction
control_region = sp.And(-k2 > 0, 1 + k1 > 0)  # the coefficients of the polynomial
error_region = sp.And(l1**3 > 0, 1 - l2 > 0)  # a cube
gains = [[-0.5, -1], [2, 0]]  # other numbers, flat lists
# an irrational coefficient, a fast observer
gains = [sp.Matrix([[1, -sp.sqrt(2)]]), sp.Matrix([20, -99])]
equations = [2 * z - 2 * e1 - e2, e1 + u]  # a correction of the first estimate alone
equations = [-e2 - 4 * e1 + 4 * z, 4 * e1 - 3 * z + u]  # multiplied out

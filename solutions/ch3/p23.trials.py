# %% wrong
# Does the error of the instrument push the body?
a_augmented = [sp.Matrix([[0, 1, 0], [1, 0, 1], [0, 0, 0]]), sp.Matrix([[1, 1, 1]])]
# What is the rate of a constant?
a_augmented = [sp.Matrix([[0, 1, 0], [1, 0, 0], [0, 0, 1]]), sp.Matrix([[1, 1, 1]])]
# Where does the error enter, if the measurement does not hold it?
a_augmented = [sp.Matrix([[0, 1, 0], [1, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 1, 0]])]
# Is the third coordinate here $r$ itself, or twice as much?
a_augmented = [sp.Matrix([[0, 1, 0], [1, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 1, sp.Rational(1, 2)]])]
a_margins = sp.true  # Does the measurement show every motion of the equation?
a_margins = sp.false  # Something is hidden. Is it the offset, and does what is hidden grow?
a_margins = mu < 1  # Look at the margin 1 itself: which root could be slower?
# Try the roots of the errors: what does the sign of $l_3$ do?
a_gains = [sp.Matrix([[-2, -2]]), sp.Matrix([4, 0, 4])]
# Can an estimate that is never corrected become right?
a_gains = [sp.Matrix([[-2, -2]]), sp.Matrix([9, 0, 0])]
# Is the feedback taken with a minus sign, $u = -Ke$?
a_gains = [sp.Matrix([[2, 2]]), sp.Matrix([9, 0, -4])]
# What is left of the stiffness with this control?
a_gains = [sp.Matrix([[-1, -1]]), sp.Matrix([9, 0, -4])]
# Stable; is it fast enough?
a_gains = [sp.Matrix([[-2, -2]]), sp.Matrix([2, 0, -sp.Rational(1, 2)])]
# Does the error of the instrument push the body?
b_augmented = [sp.Matrix([[0, 1, 0], [2, 1, 1], [0, 0, 0]]), sp.Matrix([[1, 1, 1]])]
# Which coefficient is that of x?
b_augmented = [sp.Matrix([[0, 1, 0], [1, 2, 0], [0, 0, 0]]), sp.Matrix([[1, 1, 1]])]
# Which of the two roots of the equation belongs to the motion that is not shown?
b_margins = mu <= 2
b_margins = sp.false  # Is the hidden motion the growing one?
# Which sign has the product of the roots of the errors?
b_gains = [sp.Matrix([[-3, -3]]), sp.Matrix([8, 0, 2])]
# Is this the control of item a? Look at the friction here.
b_gains = [sp.Matrix([[-2, -2]]), sp.Matrix([8, 0, -2])]
# Is the feedback taken with a minus sign, $u = -Ke$?
b_gains = [sp.Matrix([[3, 3]]), sp.Matrix([8, 0, -2])]

# %% right
a_margins = sp.And(mu > 0, mu <= 1)  # with what is known of mu
a_gains = [[-5, -4], [0, 9, -4]]  # another control, and another splitting of the sum
# decimals, the sum in halves
a_gains = [sp.Matrix([[-2.0, -2.0]]), sp.Matrix([4.5, 4.5, -4.0])]
b_augmented = [[[0, 1, 0], [2, 1, 0], [0, 0, 0]], [1, 1, 1]]  # nested lists, the row flat
b_margins = mu**3 <= 1  # a cube
b_gains = [sp.Matrix([-6, -5]), sp.Matrix([[0, 8, -2]])]  # upright and lying down
b_gains = [[-3, -3], [3, sp.Rational(35, 2), sp.Rational(-25, 2)]]  # a faster observer

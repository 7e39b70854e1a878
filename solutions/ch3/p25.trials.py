# %% wrong
# Which of the two coordinates does the control drive, the first?
a_control_split = sp.Matrix([[5, 1], [3, 1]])
a_control_split = sp.eye(2)  # Do both of the old coordinates feel the control?
# Can the old coordinates be found from these two?
a_control_split = sp.Matrix([[1, 1], [1, 1]])
# Is this the matrix that leads to the new coordinates, or back?
a_observation_split = sp.Matrix([[1, 5], [1, 3]])
# Which coordinate does the measurement show, the first?
a_observation_split = sp.Matrix([[1, -1], [3, -5]])
a_observation_split = sp.eye(2)  # Does the measurement hold one of the old coordinates alone?
a_margins = sp.true  # One root stays where it is. Which one?
a_margins = sp.false  # Is it the growing motion that is left to itself?
# Is the feedback taken with a minus sign, $u = -Ke$?
a_gains = [sp.Matrix([[2, 0]]), sp.Matrix([1, 0])]
# In which direction does this correction move the error?
a_gains = [sp.Matrix([[-2, 0]]), sp.Matrix([-1, 0])]
# In which combination do the two numbers enter?
a_gains = [sp.Matrix([[-2, 2]]), sp.Matrix([1, 0])]
# Which of the two coordinates does the control drive, the first?
b_control_split = sp.Matrix([[7, 1], [4, 1]])
# Is this a row that measures, or a vector that is not shown?
b_observation_split = sp.Matrix([[7, 4], [1, 0]])
b_margins = mu <= 1  # Is the root that stays that of item a?
# In which combination do the two numbers enter?
b_gains = [sp.Matrix([[-3, 3]]), sp.Matrix([-1, -1])]
# What is the sign of HL with these numbers?
b_gains = [sp.Matrix([[-3, 0]]), sp.Matrix([1, 1])]
# With which sign does u enter the second equation?
c_control_split = sp.Matrix([[1, 1], [1, 3]])
c_observation_split = sp.Matrix([[3, 1], [1, 0]])  # Mind the sign in the measurement.
c_margins = sp.false  # The growing motion has the root 2. Is it left to itself?
# Here the root to be moved is 2. Is the correction enough?
c_gains = [sp.Matrix([[-3, 0]]), sp.Matrix([1, 1])]
# With which sign does the second number enter?
c_gains = [sp.Matrix([[0, -4]]), sp.Matrix([1, -1])]
# Which of the two coordinates does the control drive, the first?
d_control_split = sp.Matrix([[1, 1], [-4, -1]])
# Is this a row that measures, or a vector that is not shown?
d_observation_split = sp.Matrix([[1, -4], [1, 0]])
d_margins = mu < 2  # Look at the margin 2 itself: which root could be slower?
# In which combination do the two numbers enter?
d_gains = [sp.Matrix([[-3, -3]]), sp.Matrix([1, -1])]
d_gains = [sp.Matrix([[-3, 0]]), sp.Matrix([1, -4])]  # What does H make of this column?

# %% right
a_control_split = sp.Matrix([[1, 1], [1, 0]])  # b with any other column
a_observation_split = sp.Matrix([[3, -5], [0, 1]])  # H with any other row
a_margins = mu**2 <= 1  # a square
a_gains = [[-1.5, -1.5], [0.0, -1.0]]  # decimals, other numbers of the right sum
b_control_split = sp.Matrix([[2, 0], [2, 1]])  # a multiple of b
b_observation_split = sp.Matrix([[-4, 7], [1, 0]])  # H with the other sign
b_margins = sp.And(mu > 0, mu <= 2)  # with what is known of mu
# the other coordinate alone, a fraction
b_gains = [sp.Matrix([[0, -4]]), sp.Matrix([sp.Rational(3, 4), 0])]
c_control_split = sp.Matrix([[-1, 0], [1, 1]])  # b with the other sign
c_observation_split = sp.Matrix([[1, -sp.Rational(1, 3)], [0, 1]])  # a third of H
c_margins = mu - 2 <= 0  # moved to one side
c_gains = [[0, 5], [2, 0]]  # other roots
d_control_split = sp.Matrix([[1, 5], [-1, 2]])  # b with any other column
d_observation_split = sp.Matrix([[8, 2], [1, 1]])  # twice H
d_margins = sp.Not(mu > 2)  # a negation
d_gains = [sp.Matrix([[0, 3]]), sp.Matrix([0, 3])]  # the other coordinates alone

# %% wrong
a_printed_margins = mu <= 1  # Is this the system as it is printed? Compute both ranks for it.
a_printed_margins = sp.false  # Is any mode of the printed system uncontrollable or unobservable?
# Which coordinates are to come first?
a_control_split = sp.Matrix([[-7, 1, 0], [1, 0, 1], [10, -1, 0]])
# Does A leave the plane of the first two columns?
a_control_split = sp.Matrix([[1, 0, 0], [0, 0, 1], [-1, 1, 0]])
# Can the old coordinates be found from these three?
a_control_split = sp.Matrix([[1, 0, 1], [0, 1, 1], [-1, 0, -1]])
# Is this the matrix that leads to the new coordinates, or back?
a_observation_split = sp.Matrix([[1, 0, -7], [0, 1, 1], [-1, 0, 10]])
# Do the rates of the first two coordinates contain the third one?
a_observation_split = sp.Matrix([[0, 4, -sp.Rational(2, 5)], [1, 0, 0], [0, 0, 1]])
# Add the first and the last equation: can anything change the root of this combination?
a_margins = sp.true
a_margins = mu < 1  # Look at the degree of stability 1 itself: which root could be slower?
# Is the feedback taken with a minus sign, $u = -Ke$?
a_gains = [sp.Matrix([[5, 17, 0]]), sp.Matrix([5, 3, -5]) / 2]
# Which number belongs to which coordinate?
a_gains = [sp.Matrix([[-17, -5, 0]]), sp.Matrix([5, 3, -5]) / 2]
# Does this correction drive the estimate towards the measurement?
a_gains = [sp.Matrix([[-5, -17, 0]]), -sp.Matrix([5, 3, -5]) / 2]
# Which coordinates are to come first?
b_control_split = sp.Matrix([[2, 1, 0], [-3, 1, 1], [7, -1, 0]])
# Does the control act along the first column?
b_control_split = sp.Matrix([[1, 0, 2], [0, 1, -3], [1, 0, 7]])
# Is this the matrix that leads to the new coordinates, or back?
b_observation_split = sp.Matrix([[1, 0, 2], [1, 1, -3], [-1, 0, 7]])
b_margins = mu <= 1  # Is the uncontrollable combination as slow as that of item a?
b_margins = sp.false  # Does the uncontrollable mode grow?
# Are these numbers for the new coordinates, or the old?
b_gains = [sp.Matrix([[-7, -19, 0]]), sp.Matrix([0, 1, 0])]
# What are the roots of the errors with this correction?
b_gains = [sp.Matrix([[12, -19, 0]]), sp.Matrix([1, 0, 0])]

# %% right
a_printed_margins = mu > 0  # what was assumed of mu
# another basis of the plane, any third column
a_control_split = sp.Matrix([[1, 1, 0], [0, 3, 0], [-1, -1, 1]])
# other rows that vanish on the hidden vector
a_observation_split = sp.Matrix([[1, 7, 0], [0, 10, -1], [0, 0, 1]])
a_margins = mu**2 <= 1  # a square
a_gains = [[-5.0, -17.0, 0.0], [2.5, 1.5, -2.5]]  # decimals
a_gains = [sp.Matrix([[-4, -17, 1]]), sp.Matrix([-9, 5, 15]) / 2]  # parts that change no root
b_control_split = sp.Matrix([[2, 0, 1], [2, 3, 0], [-2, 0, 0]])  # multiples, any third column
# other rows that vanish on the hidden vector
b_observation_split = sp.Matrix([[3, 2, 0], [0, 7, 3], [0, 0, 1]])
b_margins = sp.And(mu > 0, mu <= 3)  # with what is known of mu
b_gains = [sp.Matrix([[13, -19, 1]]), sp.Matrix([2, -2, 7])]  # parts that change no root

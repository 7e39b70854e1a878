# %% wrong
a_observable = False  # Are two measurements too few for four variables? (hint 1)
# Is this unobservable only from $z_1$ and its first derivative? (hint 1)
a_unobservable_states_z1 = [[0, 1, 1, 0], [0, 0, 0, 1]]
a_unobservable_states_z3 = []  # Is the whole state observable from this instrument too? (hint 1)
# Does the velocity turn with a satellite that is shifted along the orbit? (hint 2)
a_unobservable_states_z3 = [[1, 0, 0, 0]]
# Are these just the measurement and its derivatives? (hint 2)
b_part = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0], [-2, 0, 0, -2], [0, -2, -4, 0]])
# Does a coefficient of the polynomial have the wrong sign? (hint 1)
b_part = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0], [-3, 0, 0, -2], [0, -1, -5, 0]])
# How many coordinates are observable from the first instrument alone? (hint 1)
b_part = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0]])
# Is this the decomposition in the other order? (hint 1)
b_reversed = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0], [-1, 0, 0, -2], [0, -3, -3, 0]])
# Does this lead from the new coordinates to the old ones, instead of the other way? (hint 1)
b_reversed = sp.Matrix([[0, 1, 0, 0], [1, 0, 0, 1], [0, 1, 1, 0], [1, 0, 0, 0]]).inv()
# Must the instruments share the coordinates equally here? (hint 1)
b_reversed = sp.Matrix([[0, 1, 0, 0], [1, 0, 0, 1], [1, 0, 0, 0], [0, -1, 1, 0]])
# Are the rows sorted by instrument? (hint 2)
c_parallel = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, -1, 1, 0], [1, 0, 0, 1]])
# Is this the sequential decomposition? (hint 1)
c_parallel = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0], [-1, 0, 0, -2], [0, -3, -3, 0]])
# Were the rates of the two measurements swapped? (hint 2)
c_parallel = sp.Matrix([[1, 0, 0, 0], [1, 0, 0, 1], [0, 1, 0, 0], [0, -1, 1, 0]])
# Does the attraction change with the height? (hint 1)
d_matrix = sp.Matrix([[0, 0, 1, 0], [0, 0, 0, 1], [0, 0, 0, -2], [0, 1, 2, 0]])
# What is the sign of the change of the attraction with height, together with that of the
# centrifugal force? (hint 1)
d_matrix = sp.Matrix([[0, 0, 1, 0], [0, 0, 0, 1], [0, 0, 0, -2], [0, -1, 2, 0]])
# Are absolute velocities the same as those relative to the turning axes? (hint 2)
d_change = sp.eye(4)
# Does this lead from the deviations to y, instead of from y to them? (hint 2)
d_change = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 1, 1, 0], [-1, 0, 0, 1]])
e_z1 = "height"  # In which direction does the first axis point? (hint 1)
e_z3 = "distance along the orbit"  # In which direction does the third axis point? (hint 1)
e_z3 = "vertical speed"  # Is this the derivative of the measured quantity? (hint 2)

# %% right
a_unobservable_states_z1 = sp.zeros(4, 0)  # a matrix without columns
a_unobservable_states_z3 = [[-2, 0, 0, 2]]  # another length
a_unobservable_states_z3 = [sp.Matrix([0.5, 0.0, 0.0, -0.5])]  # a column, with floats
# z3 and its derivatives as they come, then z1 in another unit
b_reversed = sp.Matrix([[0, 1, 0, 0], [1, 0, 0, 1], [0, 1, 2, 0], [-5, 0, 0, 0]])
# the part of z3 in the canonical form (2.5)
b_reversed = [[0, 1, 0, 0], [1, 0, 0, 1], [0, 2, 2, 0], [1, 0, 0, 0]]
# the rows h1, h1 A, h3, h3 A as they are
c_parallel = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0], [0, 1, 0, 0], [1, 0, 0, 1]])
# every coordinate with its momentum
c_parallel = sp.Matrix([[1, 0, 0, 0], [0, 0, 1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
# pi1 as the second coordinate of z1, floats
c_parallel = [[1.0, 0, 0, 0], [0, 0, 1.0, 0], [0, 2.0, 0, 0], [1.0, 0, 0, 1.0]]
d_change = [[-1, 0, 0, 0], [0, -1, 0, 0], [0, 1, -1, 0], [-1, 0, 0, -1]]  # all signs changed
# the deviations at another time, by a matrix that commutes with the system
d_change = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, -1, 1, 0], [1, 0, 0, 1]]) * (
    3 * sp.eye(4) + satellite**2
)

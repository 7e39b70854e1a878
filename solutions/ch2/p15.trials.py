# %% wrong
# Were the sum and the difference swapped? Which of the two driving variables acts on each? (hint 2)
a_change = sp.Matrix([[1, 0, -1, 0], [0, 1, 0, 0], [1, 0, 1, 0], [0, 0, 0, 1]])
# Which chain must come first? (hint 1)
a_change = sp.Matrix([[1, 0, -1, 0], [0, 0, 0, 1], [1, 0, 1, 0], [0, 1, 0, 0]])
# Does this lead from y to x, instead of from x to y?
a_change = sp.Matrix([[1, 0, 1, 0], [0, 2, 0, 0], [1, 0, -1, 0], [0, 0, 0, 2]]) * sp.Rational(1, 2)
b_observable = False  # If neither instrument is enough, can both together not be enough? (hint 2)
b_unobservable_states_z1 = [
    [1, 0, 1, 0]
]  # Is this the eigenvector that is observable from $z_1$? (hint 1)
b_unobservable_states_z1 = []  # Are both chains observable because both exponentials occur in $z_1$? (hint 1)
# Are these the states with $z_2 = 0$ at a single instant only? (hint 1)
b_unobservable_states_z2 = [[1, 0, 1, 0], [0, 0, 0, 1]]
# Does $z_2$ depend on this last coordinate alone? (hint 2)
c_sequential = sp.Matrix([[1, 0, 1, 0], [0, 1, 0, 0], [0, 0, 0, 1], [1, 0, -1, 0]])
# Must the two parts be of equal size in this order? (hint 1)
c_sequential = sp.Matrix([[1, 0, 1, 1], [1, 1, 1, 2], [1, 1, -1, 0], [2, 1, -2, 1]])
# Is this the decomposition in the other order? (hint 1)
c_reversed = sp.Matrix([[1, 0, 1, 0], [0, 1, 0, 0], [0, 0, 0, 1], [1, 1, -1, 0]])
# What must come first, and what remains for $z_1$? (hint 1)
c_reversed = sp.Matrix([[1, 0, 1, 1], [1, 0, -1, 0], [0, 0, 0, 1], [0, 1, 0, 0]])
# Are the chains the parts of the instruments? (hint 1)
d_parallel = sp.Matrix([[1, 0, 1, 0], [0, 1, 0, 0], [1, 0, -1, 0], [0, 0, 0, 1]])
# Are the rows sorted part by part? (hint 2)
d_parallel = sp.Matrix([[1, 0, 1, 1], [1, 1, -1, 0], [1, 1, 1, 2], [2, 1, -2, 1]])
# Is this the sequential decomposition? (hint 1)
d_parallel = sp.Matrix([[1, 0, 1, 1], [1, 1, 1, 2], [1, 2, 1, 4], [1, 1, -1, 0]])

# %% right
# nested lists, another freedom: a multiple of the driver added to the head
a_change = [[2, 3, 2, 0], [0, 2, 0, 0], [-1, 0, 1, 1], [0, 0, 0, -1]]
# floats
a_change = sp.Matrix([[0.5, 0, 0.5, 0], [0, 0.5, 0, 0], [0.25, 0, -0.25, 0], [0, 0, 0, 0.25]])
b_unobservable_states_z1 = [[-3, 0, 3, 0]]  # another length and sign
b_unobservable_states_z1 = [sp.Matrix([half, 0, -half, 0])]  # a column
b_unobservable_states_z2 = [[0.7, 0.0, 0.7, 0.0]]  # floats
b_unobservable_states_z2 = sp.Matrix([-1, 0, -1, 0])  # a matrix with one column
# z1 and its derivatives, then z2
c_sequential = sp.Matrix([[1, 0, 1, 1], [1, 1, 1, 2], [1, 2, 1, 4], [1, 1, -1, 0]])
# the first part mixed, the second in another unit, floats
c_sequential = [[1.0, 2, 1, 0], [0, 1.0, 0, -1], [0, 0, 0, 1.0], [-2.0, -2, 2, 0]]
# z2 and its derivatives, then z1
c_reversed = [[1, 1, -1, 0], [2, 1, -2, 1], [4, 1, -4, 4], [1, 0, 1, 1]]
# another order in the first part, halves
c_reversed = sp.Matrix([[0, 1, 0, 0], [0, 0, 0, 1], [half, 0, -half, 0], [half, 0, half, half]])
# the rows h1, h1 A, h2, h2 A as they are
d_parallel = sp.Matrix([[1, 0, 1, 1], [1, 1, 1, 2], [1, 1, -1, 0], [2, 1, -2, 1]])
# the two sums of the drivers as the second coordinates
d_parallel = [[1, 0, 1, 1], [0, 1, 0, 1], [1, 1, -1, 0], [0, -1, 0, 1]]

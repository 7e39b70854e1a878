# %% wrong
# the sum and the difference exchanged: each with the other driver
a_change = sp.Matrix([[1, 0, -1, 0], [0, 1, 0, 0], [1, 0, 1, 0], [0, 0, 0, 1]])
a_change = sp.Matrix([[1, 0, -1, 0], [0, 0, 0, 1], [1, 0, 1, 0], [0, 1, 0, 0]])  # the chain with the eigenvalue 2 first
# the inverse, x = S y
a_change = sp.Matrix([[1, 0, 1, 0], [0, 2, 0, 0], [1, 0, -1, 0], [0, 0, 0, 2]])*sp.Rational(1, 2)
b_observable = False  # neither instrument sees all, so both together are thought not to
b_unseen_z1 = [[1, 0, 1, 0]]  # the eigenvector that z1 does see
b_unseen_z1 = []  # z1 contains both exponentials, so it is thought to see both chains
b_unseen_z2 = [[1, 0, 1, 0], [0, 0, 0, 1]]  # what z2 does not see at the first moment
# the difference itself, so that z2 contains x2 of the first part
c_sequential = sp.Matrix([[1, 0, 1, 0], [0, 1, 0, 0], [0, 0, 0, 1], [1, 0, -1, 0]])
c_sequential = sp.Matrix([[1, 0, 1, 1], [1, 1, 1, 2], [1, 1, -1, 0], [2, 1, -2, 1]])  # the parts of equal size
c_reversed = sp.Matrix([[1, 0, 1, 0], [0, 1, 0, 0], [0, 0, 0, 1], [1, 1, -1, 0]])  # the order z1, z2
c_reversed = sp.Matrix([[1, 0, 1, 1], [1, 0, -1, 0], [0, 0, 0, 1], [0, 1, 0, 0]])  # what is left for z1 put first
# the chains taken for the parts of the instruments
d_parallel = sp.Matrix([[1, 0, 1, 0], [0, 1, 0, 0], [1, 0, -1, 0], [0, 0, 0, 1]])
# the rows in the order in which they are taken
d_parallel = sp.Matrix([[1, 0, 1, 1], [1, 1, -1, 0], [1, 1, 1, 2], [2, 1, -2, 1]])
d_parallel = sp.Matrix([[1, 0, 1, 1], [1, 1, 1, 2], [1, 2, 1, 4], [1, 1, -1, 0]])  # all that z1 sees, then the rest

# %% right
# nested lists, another freedom: a multiple of the driver added to the head
a_change = [[2, 3, 2, 0], [0, 2, 0, 0], [-1, 0, 1, 1], [0, 0, 0, -1]]
a_change = sp.Matrix([[0.5, 0, 0.5, 0], [0, 0.5, 0, 0], [0.25, 0, -0.25, 0], [0, 0, 0, 0.25]])  # floats
b_unseen_z1 = [[-3, 0, 3, 0]]  # another length and sign
b_unseen_z1 = [sp.Matrix([half, 0, -half, 0])]  # a column
b_unseen_z2 = [[0.7, 0.0, 0.7, 0.0]]  # floats
b_unseen_z2 = sp.Matrix([-1, 0, -1, 0])  # a matrix with one column
c_sequential = sp.Matrix([[1, 0, 1, 1], [1, 1, 1, 2], [1, 2, 1, 4], [1, 1, -1, 0]])  # z1 and its derivatives, then z2
# the first part mixed, the second in another unit, floats
c_sequential = [[1.0, 2, 1, 0], [0, 1.0, 0, -1], [0, 0, 0, 1.0], [-2.0, -2, 2, 0]]
c_reversed = [[1, 1, -1, 0], [2, 1, -2, 1], [4, 1, -4, 4], [1, 0, 1, 1]]  # z2 and its derivatives, then z1
# another order in the first part, halves
c_reversed = sp.Matrix([[0, 1, 0, 0], [0, 0, 0, 1], [half, 0, -half, 0], [half, 0, half, half]])
# the rows h1, h1 A, h2, h2 A as they are
d_parallel = sp.Matrix([[1, 0, 1, 1], [1, 1, 1, 2], [1, 1, -1, 0], [2, 1, -2, 1]])
# the two sums of the drivers as the second coordinates
d_parallel = [[1, 0, 1, 1], [0, 1, 0, 1], [1, 1, -1, 0], [0, -1, 0, 1]]

# %% wrong
a_observable = False  # two measurements thought to be too few for four variables
a_unseen_z1 = [[0, 1, 1, 0], [0, 0, 0, 1]]  # what z1 and its first derivative do not see
a_unseen_z3 = []  # z3 thought to see everything, as z1 does
a_unseen_z3 = [[1, 0, 0, 0]]  # the shift along the orbit, with a velocity that does not turn with it
b_part = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0], [-2, 0, 0, -2], [0, -2, -4, 0]])  # z1 and its derivatives as they come
# the sign of alpha 3 lost: z'' - z1 instead of z'' + z1
b_part = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0], [-3, 0, 0, -2], [0, -1, -5, 0]])
b_part = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0]])  # only two rows, since two are left for z3
b_reversed = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0], [-1, 0, 0, -2], [0, -3, -3, 0]])  # the order z1, z3
b_reversed = sp.Matrix([[0, 1, 0, 0], [1, 0, 0, 1], [0, 1, 1, 0], [1, 0, 0, 0]]).inv()  # the inverse, x = T (xi; eta)
b_reversed = sp.Matrix([[0, 1, 0, 0], [1, 0, 0, 1], [1, 0, 0, 0], [0, -1, 1, 0]])  # the parts shared equally
# the rows in the order in which they are taken, not part by part
c_parallel = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, -1, 1, 0], [1, 0, 0, 1]])
# the sequential decomposition, with z1 first
c_parallel = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0], [-1, 0, 0, -2], [0, -3, -3, 0]])
# the velocities exchanged: z1 with the rate of z3, z3 with the rate of z1
c_parallel = sp.Matrix([[1, 0, 0, 0], [1, 0, 0, 1], [0, 1, 0, 0], [0, -1, 1, 0]])
# the attraction taken for constant: its change with the height forgotten
d_matrix = sp.Matrix([[0, 0, 1, 0], [0, 0, 0, 1], [0, 0, 0, -2], [0, 1, 2, 0]])
# the attraction falls with the height, so a restoring sign is expected
d_matrix = sp.Matrix([[0, 0, 1, 0], [0, 0, 0, 1], [0, 0, 0, -2], [0, -1, 2, 0]])
d_change = sp.eye(4)  # absolute velocities taken for those relative to the turning axes
d_change = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 1, 1, 0], [-1, 0, 0, 1]])  # the inverse, x = S y
e_z1 = "height"  # the first axis thought to point outward
e_z3 = "distance along the orbit"  # the third axis thought to point along the orbit
e_z3 = "vertical speed"  # what the altimeter tells by its derivative

# %% right
a_unseen_z1 = sp.zeros(4, 0)  # a matrix without columns
a_unseen_z3 = [[-2, 0, 0, 2]]  # another length
a_unseen_z3 = [sp.Matrix([0.5, 0.0, 0.0, -0.5])]  # a column, with floats
# z3 and its derivatives as they come, then z1 in another unit
b_reversed = sp.Matrix([[0, 1, 0, 0], [1, 0, 0, 1], [0, 1, 2, 0], [-5, 0, 0, 0]])
b_reversed = [[0, 1, 0, 0], [1, 0, 0, 1], [0, 2, 2, 0], [1, 0, 0, 0]]  # the part of z3 in the canonical form (2.5)
# the rows h1, h1 A, h3, h3 A as they are
c_parallel = sp.Matrix([[1, 0, 0, 0], [0, -1, 1, 0], [0, 1, 0, 0], [1, 0, 0, 1]])
c_parallel = sp.Matrix([[1, 0, 0, 0], [0, 0, 1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])  # every coordinate with its momentum
# pi1 as the second coordinate of z1, floats
c_parallel = [[1.0, 0, 0, 0], [0, 0, 1.0, 0], [0, 2.0, 0, 0], [1.0, 0, 0, 1.0]]
d_change = [[-1, 0, 0, 0], [0, -1, 0, 0], [0, 1, -1, 0], [-1, 0, 0, -1]]  # all signs changed
# the deviations at another time, by a matrix that commutes with the system
d_change = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, -1, 1, 0], [1, 0, 0, 1]])*(3*sp.eye(4) + satellite**2)

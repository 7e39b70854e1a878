# %% wrong
a_observable = True  # the coupled motion in the plane thought to be the whole
a_unseen = [[0, 1, 0, 0, 0, 0], [0, 0, 0, 0, 1, 0]]  # only the oscillation across the plane
# a shift along the orbit whose velocity does not turn with it
a_unseen = [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 0, 0, 1, 0]]
# the motion in the plane taken for the observable part
a_split = sp.Matrix([[0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 0, 1], [1, 0, 0, 0, 0, 0], [0, 0, 0, 1, 0, 0],
                     [0, 1, 0, 0, 0, 0], [0, 0, 0, 0, 1, 0]])
# the unseen coordinates first
a_split = sp.Matrix([[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 1, 0, 0, 0],
                     [1, 0, 0, 0, 0, 1], [0, 0, 0, 1, 0, 0]])
b_observable = True  # all six variables thought to be coupled
b_unseen = []  # nothing: the four coupled variables taken for the whole state
# the shift that a measurement of the height would not see
b_unseen = [[1, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]
# the oscillator first
b_split = sp.Matrix([[0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1], [1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0],
                     [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0]])
c_hill = sp.eye(6)  # deviations of the absolute velocity taken for relative velocities
# the frame thought to turn the other way
c_hill = sp.Matrix([[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 1, 1, 0, 0],
                    [0, 0, 0, 0, 1, 0], [-1, 0, 0, 0, 0, 1]])
# the variables put in order, without turning the first axis
c_similarity = sp.Matrix([[1, 0, 0, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 0, 1],
                          [0, 1, 0, 0, 0, 0], [0, 0, 0, 0, 1, 0]])
# x = S y, the inverse of what is asked
c_similarity = sp.Matrix([[-1, 0, 0, 0, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 1, 0, 0, 0], [0, -1, 0, 0, 0, 0],
                          [0, 0, 0, 0, 0, 1], [0, 0, 0, 1, 0, 0]])
c_similarity = sp.zeros(6, 6)  # no transformation
d_first = "distance across the plane of the orbit"  # the third axis thought to be the normal of the plane
d_second = "height"  # the first variable thought to point away from the centre
e_observable = True  # one coefficient thought to make the difference
e_unseen = [[0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]  # the unseen states of the system with 2 y3
e_split = sp.eye(6)  # the variables left as they are, as in item b
e_eigenvalues = [[0, 2, 1], [sp.I, 2, 2], [-sp.I, 2, 2]]  # the eigenvalues of the satellite
# the double eigenvalue 0 taken for a Jordan block
e_eigenvalues = [[0, 2, 1], [sp.I, 1, 1], [-sp.I, 1, 1], [2*sp.I, 1, 1], [-2*sp.I, 1, 1]]

# %% right
# other combinations, as columns
a_unseen = [sp.Matrix([0, 1, 0, 0, 1, 0]), sp.Matrix([0, 1, 0, 0, -1, 0]), sp.Matrix([-2, 5, 0, 0, 0, 2])]
# a matrix with a column for each
a_unseen = sp.Matrix([[3, 0, 0], [0, 1, 0], [0, 0, 0], [0, 0, 0], [0, 0, 1], [-3, 0, 0]])
# the derivatives of z1 as they come, then v3 instead of x1
a_split = [[0, 0, 1, 0, 0, 0], [1, 0, 0, 0, 0, 1], [0, 0, 1, 2, 0, 0], [0, 0, 0, 0, 0, 1], [0, 1, 0, 0, 0, 0],
           [0, 0, 0, 0, 1, 0]]
# with the constant x3 + v1, and the oscillator mixed into the hidden shift
a_split = sp.Matrix([[0, 0, 1, 1, 0, 0], [0, 0, 1, 0, 0, 0], [1, 0, 0, 0, 0, 1], [1, 1, 0, 0, 0, 0],
                     [0, 1, 0, 0, 1, 0], [0, 2, 0, 0, -1, 0]])
b_unseen = [[0, 0, 0, 0, 1, 1], [0, 0, 0, 0, 1, -1]]  # two other combinations
b_unseen = [[0.0, 0.0, 0.0, 0.0, 0.5, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 2.0]]  # floats
# the derivatives of z2 for the observable part
b_split = sp.Matrix([[1, 0, 0, 0, 0, 0], [0, 1, 1, 0, 0, 0], [-2, 0, 0, 2, 0, 0], [0, -4, 2, 0, 0, 0],
                     [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]])
# nested lists, another order in each part
b_split = [[0, 0, 0, 1, 0, 0], [0, 0, 1, 0, 0, 0], [0, 1, 0, 0, 0, 0], [1, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 1],
           [0, 0, 0, 0, 1, 0]]
# nested lists, another unit of length
c_hill = [[2, 0, 0, 0, 0, 0], [0, 2, 0, 0, 0, 0], [0, 0, 2, 0, 0, 0], [0, 0, -2, 2, 0, 0], [0, 0, 0, 0, 2, 0],
          [2, 0, 0, 0, 0, 2]]
# the place at another time, by a matrix that commutes with the system
c_hill = sp.Matrix([[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, -1, 1, 0, 0],
                    [0, 0, 0, 0, 1, 0], [1, 0, 0, 0, 0, 1]])*(sp.eye(6) + a_system)
# all signs turned: forward, inward, the other normal
c_similarity = sp.Matrix([[1, 0, 0, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, -1, 0, 0, 0], [0, 0, 0, 0, 0, -1],
                          [0, -1, 0, 0, 0, 0], [0, 0, 0, 0, -1, 0]])
# floats, the normal turned and the oscillator in another scale
c_similarity = [[-1.0, 0, 0, 0, 0, 0], [0, 0, 0, -1.0, 0, 0], [0, 0, 1.0, 0, 0, 0], [0, 0, 0, 0, 0, 1.0],
                [0, -2.5, 0, 0, 0, 0], [0, 0, 0, 0, -2.5, 0]]
e_unseen = [[0, 0, 0, 0, 0, 1], [0, 2, -2, 0, 0, 0], [0, 0, 0, 0, 1, 0]]  # another sign and order
e_unseen = [[0, -1, 1, 0, 1, 0], [0, -1, 1, 0, -1, 0], [0, 0, 0, 0, 3, 1]]  # other combinations
# the derivatives of z2, then the constant y2 - y3
e_split = [[1, 0, 0, 0, 0, 0], [0, 1, 1, 0, 0, 0], [-2, 0, 0, 2, 0, 0], [0, 1, -1, 0, 0, 0], [0, 0, 0, 0, 1, 0],
           [0, 0, 0, 0, 0, 1]]
# y2 in the place of y3 for the hidden coordinate
e_split = sp.Matrix([[1, 0, 0, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 1, 1, 0, 0, 0], [0, 0, 0, 0, 1, 0],
                     [0, 0, 0, 0, 0, 1], [0, 1, 0, 0, 0, 0]])
e_eigenvalues = [(2*sp.I, 1, 1), (sp.I, 1, 1), (0, 2, 2), (-sp.I, 1, 1), (-2*sp.I, 1, 1)]  # another order, as tuples

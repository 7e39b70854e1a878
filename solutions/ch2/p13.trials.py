# %% wrong
a_observable = True  # Is the coupled motion in the plane the whole motion? (hint 1)
# Is there another unobservable motion besides the oscillation across the plane? (hint 2)
a_unobservable_states = [[0, 1, 0, 0, 0, 0], [0, 0, 0, 0, 1, 0]]
# Does the velocity turn with a satellite that is shifted along the orbit? (hint 1)
a_unobservable_states = [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 0, 0, 1, 0]]
# Is the motion in the plane observable as a whole? (hint 1)
a_split = sp.Matrix(
    [
        [0, 0, 1, 0, 0, 0],
        [0, 0, 0, 0, 0, 1],
        [1, 0, 0, 0, 0, 0],
        [0, 0, 0, 1, 0, 0],
        [0, 1, 0, 0, 0, 0],
        [0, 0, 0, 0, 1, 0],
    ]
)
# Which coordinates must come first? (hint 1)
a_split = sp.Matrix(
    [
        [1, 0, 0, 0, 0, 0],
        [0, 1, 0, 0, 0, 0],
        [0, 0, 0, 0, 1, 0],
        [0, 0, 1, 0, 0, 0],
        [1, 0, 0, 0, 0, 1],
        [0, 0, 0, 1, 0, 0],
    ]
)
b_observable = True  # Do all six variables act on each other? (hint 1)
b_unobservable_states = []  # Are the coupled variables the whole state? (hint 1)
# Would this shift be unobservable from the height? What does $z_2$ measure? (hint 1)
b_unobservable_states = [[1, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]
# Which coordinates must come first? (hint 1)
b_split = sp.Matrix(
    [
        [0, 0, 0, 0, 1, 0],
        [0, 0, 0, 0, 0, 1],
        [1, 0, 0, 0, 0, 0],
        [0, 1, 0, 0, 0, 0],
        [0, 0, 1, 0, 0, 0],
        [0, 0, 0, 1, 0, 0],
    ]
)
c_hill = sp.eye(6)  # Are the deviations of an absolute velocity relative velocities? (hint 1)
# Does the frame rotate in this direction? (hint 1)
c_hill = sp.Matrix(
    [
        [1, 0, 0, 0, 0, 0],
        [0, 1, 0, 0, 0, 0],
        [0, 0, 1, 0, 0, 0],
        [0, 0, 1, 1, 0, 0],
        [0, 0, 0, 0, 1, 0],
        [-1, 0, 0, 0, 0, 1],
    ]
)
# Is it enough to put the variables in order? Look at the directions of the axes. (hint 2)
c_similarity = sp.Matrix(
    [
        [1, 0, 0, 0, 0, 0],
        [0, 0, 0, 1, 0, 0],
        [0, 0, 1, 0, 0, 0],
        [0, 0, 0, 0, 0, 1],
        [0, 1, 0, 0, 0, 0],
        [0, 0, 0, 0, 1, 0],
    ]
)
# Does this lead from y to x, instead of from x to y? (hint 3)
c_similarity = sp.Matrix(
    [
        [-1, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 1, 0],
        [0, 0, 1, 0, 0, 0],
        [0, -1, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 1],
        [0, 0, 0, 1, 0, 0],
    ]
)
c_similarity = sp.zeros(6, 6)  # Can a change of coordinates map everything to zero? (hint 1)
# Which axis is the normal of the plane? (hint 1)
d_first = "distance across the plane of the orbit"
d_second = "height"  # In which direction does the first axis point? (hint 1)
e_observable = True  # Does the printed coefficient make the system observable? (hint 1)
# Are these the unobservable states of the corrected system? The printed one has others. (hint 1)
e_unobservable_states = [[0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]
e_split = sp.eye(6)  # Can the variables be left as they are, as in item b? (hint 1)
# Are these the eigenvalues of the satellite? The printed system is different. (hint 1)
e_eigenvalues = [[0, 2, 1], [sp.I, 2, 2], [-sp.I, 2, 2]]
# How many eigenvectors does the double eigenvalue have? (hint 2)
e_eigenvalues = [[0, 2, 1], [sp.I, 1, 1], [-sp.I, 1, 1], [2 * sp.I, 1, 1], [-2 * sp.I, 1, 1]]

# %% right
# other combinations, as columns
a_unobservable_states = [
    sp.Matrix([0, 1, 0, 0, 1, 0]),
    sp.Matrix([0, 1, 0, 0, -1, 0]),
    sp.Matrix([-2, 5, 0, 0, 0, 2]),
]
# a matrix with a column for each
a_unobservable_states = sp.Matrix(
    [[3, 0, 0], [0, 1, 0], [0, 0, 0], [0, 0, 0], [0, 0, 1], [-3, 0, 0]]
)
# the derivatives of z1 as they come, then v3 instead of x1
a_split = [
    [0, 0, 1, 0, 0, 0],
    [1, 0, 0, 0, 0, 1],
    [0, 0, 1, 2, 0, 0],
    [0, 0, 0, 0, 0, 1],
    [0, 1, 0, 0, 0, 0],
    [0, 0, 0, 0, 1, 0],
]
# with the constant x3 + v1, and the oscillator mixed into the hidden shift
a_split = sp.Matrix(
    [
        [0, 0, 1, 1, 0, 0],
        [0, 0, 1, 0, 0, 0],
        [1, 0, 0, 0, 0, 1],
        [1, 1, 0, 0, 0, 0],
        [0, 1, 0, 0, 1, 0],
        [0, 2, 0, 0, -1, 0],
    ]
)
b_unobservable_states = [[0, 0, 0, 0, 1, 1], [0, 0, 0, 0, 1, -1]]  # two other combinations
b_unobservable_states = [[0.0, 0.0, 0.0, 0.0, 0.5, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 2.0]]  # floats
# the derivatives of z2 for the observable part
b_split = sp.Matrix(
    [
        [1, 0, 0, 0, 0, 0],
        [0, 1, 1, 0, 0, 0],
        [-2, 0, 0, 2, 0, 0],
        [0, -4, 2, 0, 0, 0],
        [0, 0, 0, 0, 1, 0],
        [0, 0, 0, 0, 0, 1],
    ]
)
# nested lists, another order in each part
b_split = [
    [0, 0, 0, 1, 0, 0],
    [0, 0, 1, 0, 0, 0],
    [0, 1, 0, 0, 0, 0],
    [1, 0, 0, 0, 0, 0],
    [0, 0, 0, 0, 0, 1],
    [0, 0, 0, 0, 1, 0],
]
# nested lists, another unit of length
c_hill = [
    [2, 0, 0, 0, 0, 0],
    [0, 2, 0, 0, 0, 0],
    [0, 0, 2, 0, 0, 0],
    [0, 0, -2, 2, 0, 0],
    [0, 0, 0, 0, 2, 0],
    [2, 0, 0, 0, 0, 2],
]
# the place at another time, by a matrix that commutes with the system
c_hill = sp.Matrix(
    [
        [1, 0, 0, 0, 0, 0],
        [0, 1, 0, 0, 0, 0],
        [0, 0, 1, 0, 0, 0],
        [0, 0, -1, 1, 0, 0],
        [0, 0, 0, 0, 1, 0],
        [1, 0, 0, 0, 0, 1],
    ]
) * (sp.eye(6) + a_system)
# all signs turned: forward, inward, the other normal
c_similarity = sp.Matrix(
    [
        [1, 0, 0, 0, 0, 0],
        [0, 0, 0, 1, 0, 0],
        [0, 0, -1, 0, 0, 0],
        [0, 0, 0, 0, 0, -1],
        [0, -1, 0, 0, 0, 0],
        [0, 0, 0, 0, -1, 0],
    ]
)
# floats, the normal turned and the oscillator in another scale
c_similarity = [
    [-1.0, 0, 0, 0, 0, 0],
    [0, 0, 0, -1.0, 0, 0],
    [0, 0, 1.0, 0, 0, 0],
    [0, 0, 0, 0, 0, 1.0],
    [0, -2.5, 0, 0, 0, 0],
    [0, 0, 0, 0, -2.5, 0],
]
# another sign and order
e_unobservable_states = [[0, 0, 0, 0, 0, 1], [0, 2, -2, 0, 0, 0], [0, 0, 0, 0, 1, 0]]
e_unobservable_states = [
    [0, -1, 1, 0, 1, 0],
    [0, -1, 1, 0, -1, 0],
    [0, 0, 0, 0, 3, 1],
]  # other combinations
# the derivatives of z2, then the constant y2 - y3
e_split = [
    [1, 0, 0, 0, 0, 0],
    [0, 1, 1, 0, 0, 0],
    [-2, 0, 0, 2, 0, 0],
    [0, 1, -1, 0, 0, 0],
    [0, 0, 0, 0, 1, 0],
    [0, 0, 0, 0, 0, 1],
]
# y2 in the place of y3 for the hidden coordinate
e_split = sp.Matrix(
    [
        [1, 0, 0, 0, 0, 0],
        [0, 0, 0, 1, 0, 0],
        [0, 1, 1, 0, 0, 0],
        [0, 0, 0, 0, 1, 0],
        [0, 0, 0, 0, 0, 1],
        [0, 1, 0, 0, 0, 0],
    ]
)
# another order, as tuples
e_eigenvalues = [(2 * sp.I, 1, 1), (sp.I, 1, 1), (0, 2, 2), (-sp.I, 1, 1), (-2 * sp.I, 1, 1)]

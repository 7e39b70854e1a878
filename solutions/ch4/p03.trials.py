# %% wrong
# What are the bearings if the observer moves straight towards the target? (hint 1)
determined = sp.Ne(v, 0)
# Is one position of the observer enough? (hint 2)
determined = sp.Or(sp.Ne(x[1], 0), sp.Ne(x[2], 0))
# Try a target at the height of the observer. (hint 1)
determined = sp.And(sp.Ne(v, 0), sp.Ne(x[1], 0), sp.Ne(x[2], 0))
# Is the position of a target abeam undetermined?
determined = sp.And(sp.Ne(v, 0), sp.Ne(x[0], 0), sp.Or(sp.Ne(x[1], 0), sp.Ne(x[2], 0)))
unobservable_displacements = []  # How far away is a target dead ahead? (hint 1)
unobservable_displacements = [
    [1, 0, 0],
    [0, 1, 0],
]  # Does a step aside leave the bearing unchanged? (hint 1)
unobservable_displacements = [
    [0, 1, 0],
    [0, 0, 1],
]  # Are these the observable displacements? (hint 1)
third = []  # Does the third line of sight leave the course? (hint 1)
third = [[0, 1, 0], [0, 0, 1]]  # Are these the observable displacements? (hint 1)
# What is its component across the new line of sight? (hint 1)
elsewhere = [[1, 0, 0]]
# Does a displacement along the new line of sight change the first bearing, too? (hint 1)
elsewhere = [[x[0], -h, 0]]
# Are the two angles of each of three bearings independent of all the others? (hint 2)
moving = []
# Whose velocity is subtracted in the relative motion? (hint 1)
moving = [[x[0], x[1], 0, v, 0, 0]]
moving = [[x[0], x[1], 0, 0, 0, 0]]  # Is the nearer target at rest, too? (hint 2)

# %% right
determined = sp.Ne(v**2 * (x[1] ** 2 + x[2] ** 2), 0)  # by the cross product with the velocity
unobservable_displacements = [[-(x[0] ** 2) - 1, 0, 0]]  # another multiple
third = [[-3, 0, 0]]  # another multiple
moving = [[x[0] / v, x[1] / v, 0, -1, 0, 0]]  # another multiple

# %% wrong
# Was a common factor cancelled before the equation became a system? (hint 2)
controllable = True
# Is everything controllable? Look for a combination whose derivative does not contain u. (hint 1)
uncontrolled = []
uncontrolled = [[2, 1]]  # Was a sign lost? Does the control enter this combination? (hint 1)
uncontrolled = [[1, 2]]  # Is this the direction in which the control acts? (hint 1)
split = sp.Matrix([[1, 1], [2, -1]]).T  # Were the columns written as rows? (hint 1)
split = sp.Matrix([[1, 1], [-1, 2]])  # Which coordinate must come first? (hint 1)
# Was the derivative of u dropped from the equation? (hint 1)
split = sp.Matrix([[0, 1], [1, 1]])
# What is the sign of the uncontrollable root? (hint 1)
split_system = [sp.Matrix([[2, 0], [0, 1]]), sp.Matrix([1, 0])]
# Which of the two roots is uncontrollable, the one that cancels or the other? (hint 1)
split_system = [sp.Matrix([[-1, 0], [0, 2]]), sp.Matrix([1, 0])]
split_system = [A, B]  # Is this the original system? (hint 1)
region = sp.Ne(a, 1)  # Does the left-hand side have another root? (hint 2)
# Are these the roots, where their negatives are needed? (hint 2)
region = sp.And(sp.Ne(a, -1), sp.Ne(a, 2))
# Are these the exceptional values instead of all others? (hint 1)
region = sp.Or(sp.Eq(a, 1), sp.Eq(a, -2))
uncontrolled_where = {1: [[-2, 1]]}  # Was one of the values overlooked? (hint 1)
# Are these the roots, where their negatives are needed? (hint 1)
uncontrolled_where = {-1: [[-2, 1]], 2: [[1, 1]]}
uncontrolled_where = {1: [[1, 1]], -2: [[-2, 1]]}  # Were the two rows swapped? (hint 1)

# %% right
uncontrolled = [[1, -sp.Rational(1, 2)]]  # another length and sign
split = sp.Matrix([[1, 0], [2, 1]])  # another second column: eta then acts on xi
split = sp.Matrix([[3, 1], [6, -1]])  # another length of b
# with the second axis, eta acts on xi
split_system = [sp.Matrix([[2, 1], [0, -1]]), sp.Matrix([1, 0])]
split_system = [sp.Matrix([[2, 7], [0, -1]]), sp.Matrix([-2, 0])]  # other lengths
region = sp.Ne((a - 1) * (a + 2), 0)  # the determinant
region = sp.Or(a < -2, sp.And(a > -2, a < 1), a > 1)  # three intervals
uncontrolled_where = {-2: sp.Matrix([3, 3]), 1: sp.Matrix([4, -2])}  # columns of other lengths

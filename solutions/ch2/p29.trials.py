# %% wrong
controllable = True  # the factor cancelled first, and the rest, x' - 2x = u, found to be controllable
uncontrolled = []  # thought to be controllable
uncontrolled = [[2, 1]]  # a sign lost: the control enters this combination
uncontrolled = [[1, 2]]  # the direction in which the control pushes
split = sp.Matrix([[1, 1], [2, -1]]).T  # the columns written as rows
split = sp.Matrix([[1, 1], [-1, 2]])  # the uncontrollable coordinate first
split = sp.Matrix([[0, 1], [1, 1]])  # as if b were (0, 1): the derivative of u dropped from the equation
split_system = [sp.Matrix([[2, 0], [0, 1]]), sp.Matrix([1, 0])]  # a sign of the lost root
split_system = [sp.Matrix([[-1, 0], [0, 2]]), sp.Matrix([1, 0])]  # the root 2 taken for the lost one
split_system = [A, B]  # the system as it was
region = sp.Ne(a, 1)  # the other root of the left side overlooked
region = sp.And(sp.Ne(a, -1), sp.Ne(a, 2))  # the roots themselves for their negatives
region = sp.Or(sp.Eq(a, 1), sp.Eq(a, -2))  # the exceptional values given
uncontrolled_where = {1: [[-2, 1]]}  # one value overlooked
uncontrolled_where = {-1: [[-2, 1]], 2: [[1, 1]]}  # the roots for their negatives
uncontrolled_where = {1: [[1, 1]], -2: [[-2, 1]]}  # the rows interchanged

# %% right
uncontrolled = [[1, -sp.Rational(1, 2)]]  # another length and sign
split = sp.Matrix([[1, 0], [2, 1]])  # another second column: eta then acts on xi
split = sp.Matrix([[3, 1], [6, -1]])  # another length of b
split_system = [sp.Matrix([[2, 1], [0, -1]]), sp.Matrix([1, 0])]  # with the second axis, eta acts on xi
split_system = [sp.Matrix([[2, 7], [0, -1]]), sp.Matrix([-2, 0])]  # other lengths
region = sp.Ne((a - 1)*(a + 2), 0)  # the determinant
region = sp.Or(a < -2, sp.And(a > -2, a < 1), a > 1)  # three intervals
uncontrolled_where = {-2: sp.Matrix([3, 3]), 1: sp.Matrix([4, -2])}  # columns of other lengths

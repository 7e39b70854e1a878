# %% wrong
controllable = True  # each equation contains u, taken for enough
uncontrolled = []  # thought to be controllable
uncontrolled = [[1, 1]]  # the direction in which the control pushes, for the one that it leaves alone
uncontrolled = [[1, -2]]  # the eigenvector of A for that of the transposed matrix
lost = [2]  # the eigenvalue of the direction b, the one that is kept
lost = [-1, 2]  # all eigenvalues of A
lost = []  # no eigenvalue thought to be lost
split = sp.Matrix([[1, 1], [1, -2]]).inv()  # the matrix that gives (xi, eta) from x
split = sp.Matrix([[1, 1], [-2, 1]])  # the uncontrollable coordinate first
split = sp.Matrix([[1, 2], [1, 2]])  # Kalman's matrix, which has no inverse here
split = sp.eye(2)  # the coordinates as they are
split_system = [sp.Matrix([[2, 0], [0, -1]]), sp.Matrix([1, 1])]  # the control still enters the lost equation
split_system = [sp.Matrix([[2, 0], [2, -1]]), sp.Matrix([1, 0])]  # the coupling on the wrong side of the diagonal
split_system = [sp.Matrix([[-1, 0], [0, 2]]), sp.Matrix([1, 0])]  # the eigenvalues interchanged

# %% right
uncontrolled = [[5, -5]]  # another length and sign
lost = [-sp.sqrt(1)]  # the number in another form
split = sp.Matrix([[1, 1], [1, 0]])  # b and the first axis
split = sp.Matrix([[-3, 0], [-3, 7]])  # another length of b, the second axis
split_system = [sp.Matrix([[2, 2], [0, -1]]), sp.Matrix([1, 0])]  # with the first axis: eta acts on xi
split_system = [sp.Matrix([[2, -5], [0, -1]]), sp.Matrix([3, 0])]  # other lengths

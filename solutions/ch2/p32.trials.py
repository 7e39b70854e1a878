# %% wrong
# Is a variable uncontrollable because its equation does not contain u? (hint 1)
a_uncontrolled = [[0, 1, 0, 0], [0, 0, 1, 0]]
a_uncontrolled = [[0, 0, 0, 1]]  # Was an arrow read in the wrong direction? (hint 1)
a_uncontrollable_eigenvalues = [
    1,
    2,
]  # Are all eigenvalues of Jordan blocks uncontrollable? (hint 1)
a_uncontrollable_eigenvalues = []  # Can an eigenvalue be both controllable and uncontrollable? (hint 1)
a_split = sp.eye(4)  # Can the order stay as it is? (hint 1)
a_split = sp.eye(4)[:, [2, 0, 1, 3]]  # Which variables must come first? (hint 1)
# Is a variable uncontrollable because its equation does not contain u? (hint 1)
b_uncontrolled = [[1, 0, 0, 0], [0, 0, 0, 1]]
b_uncontrolled = [[0, 0, 1, 0]]  # Was an arrow read in the wrong direction? (hint 1)
b_uncontrollable_eigenvalues = [3]  # At which end does the control enter the Jordan block? (hint 1)
b_uncontrollable_eigenvalues = [2, 3]  # Are all eigenvalues uncontrollable? (hint 1)
b_split = sp.eye(4)[:, [3, 0, 1, 2]]  # Which variables must come first? (hint 1)
# Does this matrix have an inverse?
b_split = sp.Matrix.hstack(b_b, A_b * b_b, A_b**2 * b_b, A_b**3 * b_b)
c_uncontrolled = [[0, 0, 1, 0]]  # Was an arrow read in the wrong direction? (hint 1)
c_uncontrolled = []  # Is a Jordan block controllable from any of its variables? (hint 1)
c_uncontrollable_eigenvalues = [2]  # Is this the eigenvalue of the other block? (hint 1)
c_uncontrollable_eigenvalues = []  # Can an eigenvalue be both controllable and uncontrollable? (hint 1)
c_split = sp.eye(4)[:, [3, 0, 1, 2]]  # Which variables must come first? (hint 1)
c_split = sp.eye(4)[:, [0, 1, 3, 2]]  # Is this the order of item a? (hint 1)
# Is a variable uncontrollable because its equation does not contain u? (hint 1)
d_uncontrolled = [[1, 0, 0, 0], [0, 0, 0, 1]]
d_uncontrolled = [[0, 0, 1, -1]]  # Does the control enter this difference? (hint 1)
# Are these the eigenvalues of the controllable part?
d_uncontrollable_eigenvalues = [(1 + sp.sqrt(13)) / 2, (1 - sp.sqrt(13)) / 2]
d_uncontrollable_eigenvalues = []  # Can an eigenvalue be both controllable and uncontrollable? (hint 1)
d_split = sp.eye(4)[:, [3, 0, 1, 2]]  # Which variables must come first? (hint 1)
d_split = sp.eye(4)[:, [0, 1, 3, 2]]  # Is this the order of item a? (hint 1)
# The control cancels here, but does the derivative contain only such combinations? (hint 1)
e_uncontrolled = [[-1, 0, 1, 0]]
# Is every difference without u uncontrollable? Look at its derivative. (hint 1)
e_uncontrolled = [[-1, 0, 1, 0], [-1, 1, 0, 0]]
e_uncontrolled = []  # Must the matrix have zeros for something to be uncontrollable? (hint 1)
# Are these the eigenvalues of the controllable part? (hint 1)
e_uncontrollable_eigenvalues = [(1 + sp.sqrt(17)) / 2, (1 - sp.sqrt(17)) / 2]
e_uncontrollable_eigenvalues = [
    (1 + sp.sqrt(5)) / 2
]  # Are only the growing ones required? (hint 1)
# Which part must come first? (hint 1)
e_split = sp.Matrix.hstack(sp.eye(4)[:, 2:], b_e, A_e * b_e)
# Is there a slip in solving for the old coordinates? Multiply the matrices. (hint 1)
e_split = sp.Matrix([[1, 0, 0, 0], [1, 2, 0, 0], [1, 0, 1, 0], [0, 0, 0, 1]]).inv() * 2 + sp.eye(4)
e_split_system = [A_e, b_e]  # Is this the original system? (hint 1)
# Was a coupling between the two parts changed? (hint 1)
e_split_system = [
    sp.Matrix([[0, 4, 1, 2], [1, 1, 2, 1], [0, 0, 1, 1], [0, 0, 1, 1]]),
    sp.Matrix([1, 0, 0, 0]),
]
# Are these the rows of item e? One sign differs here. (hint 1)
f_uncontrolled = [[-1, 0, 1, 0], [0, 0, 0, 1]]
# Is a variable uncontrollable because its equation does not contain u? (hint 1)
f_uncontrolled = [[0, 0, 0, 1]]
# Are these the eigenvalues of item e? One sign differs here. (hint 1)
f_uncontrollable_eigenvalues = [(1 + sp.sqrt(5)) / 2, (1 - sp.sqrt(5)) / 2]
f_split = sp.Matrix.hstack(b_f, A_f * b_f, b_f, A_f * b_f)  # Is this matrix invertible? (hint 1)

# %% right
a_uncontrolled = [[0, 0, -7, 0]]  # another length and sign
# the columns of the textbook
a_split = sp.Matrix.hstack(b_a, A_a * b_a, A_a**2 * b_a, sp.eye(4)[:, 2])
b_uncontrolled = [[0, 0, 0, 2]]  # another length
# the columns of the textbook
b_split = sp.Matrix.hstack(b_b, A_b * b_b, A_b**2 * b_b, sp.eye(4)[:, 3])
# the columns of the textbook
c_split = sp.Matrix.hstack(b_c, A_c * b_c, A_c**2 * b_c, sp.ones(4, 1))
# the columns of the textbook
d_split = sp.Matrix.hstack(b_d, A_d * b_d, A_d**2 * b_d, sp.Matrix([0, 0, 1, -2]))
e_uncontrolled = [[-1, 0, 1, 1], [1, 0, -1, 1]]  # sum and difference of the two rows
e_uncontrollable_eigenvalues = [sp.S.GoldenRatio, 1 - sp.S.GoldenRatio]  # by its name
# simpler columns of the same plane
e_split = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [1, 0, 1, 0], [0, 0, 0, 1]])
# in the simpler columns: the coordinates x1, x2, x3 - x1, x4
e_split_system = [
    sp.Matrix([[-2, 2, 1, 2], [-1, 3, 5, 4], [0, 0, 1, 1], [0, 0, 1, 0]]),
    sp.Matrix([1, 1, 0, 0]),
]
# any invertible matrix: Kalman's
f_split = sp.Matrix.hstack(b_f, A_f * b_f, A_f**2 * b_f, A_f**3 * b_f)
f_split = 3 * sp.eye(4)[:, ::-1]  # the variables in another order and scale

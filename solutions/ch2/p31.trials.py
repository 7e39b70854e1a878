# %% wrong
# Must the control enter every equation? Follow what it acts on. (hint 1)
a_controllable = False
# Was the transposed matrix used? (hint 1)
a_matrix = sp.Matrix.hstack(along, A.T * along, A.T**2 * along, A.T**3 * along)
# Was a column written twice? (hint 1)
a_matrix = sp.Matrix.hstack(along, A * along, A * along, A**2 * along)
b_controllable = True  # Is the outward thrust as effective as the one along the orbit? (hint 1)
# Is $v_1$ the rate of $x_1$ in these equations? Remember the rotating frame. (hint 2)
b_uncontrolled = [[0, 2 * omega, 1, 0]]
# Is this rate constant by itself? Its equation contains other variables. (hint 1)
b_uncontrolled = [[0, 0, 1, 0]]
b_uncontrolled = []  # Is there no first integral? Look for an equation to integrate. (hint 1)
# Is the position along the orbit uncontrollable as well? (hint 1)
b_uncontrolled = [[0, omega, 1, 0], [1, 0, 0, 0]]
# Is the oscillation uncontrollable, or does the thruster act on it? (hint 1)
b_uncontrollable_eigenvalues = [sp.I * omega, -sp.I * omega]
b_uncontrollable_eigenvalues = [
    0,
    sp.I * omega,
    -sp.I * omega,
]  # Are all eigenvalues uncontrollable? (hint 1)
b_uncontrollable_eigenvalues = []  # Is every eigenvalue controllable, though a combination is constant? (hint 1)
# Does this lead from x to the new coordinates, instead of from them to x?
b_split = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [omega, 0, 0, 1], [0, omega, 1, 0]])
b_split = sp.eye(4)[:, [0, 1, 3, 2]]  # Is $v_1$ the constant? Remember the rotating frame. (hint 2)
# Does this matrix have an inverse? (hint 1)
b_split = sp.Matrix.hstack(outward, A * outward, A**2 * outward, A**3 * outward)
# Does the constant drive nothing? Think of the drift along the orbit. (hint 1)
b_split_system = [
    sp.Matrix([[0, -2 * omega, 0, 0], [0, 0, 1, 0], [0, -(omega**2), 0, 0], [0] * 4]),
    sp.Matrix([0, 0, 1, 0]),
]
# Was the effect of the motion along the orbit on the height left out? (hint 1)
b_split_system = [
    sp.Matrix([[0, 0, 0, 1], [0, 0, 1, 0], [0, 3 * omega**2, 0, 0], [0] * 4]),
    sp.Matrix([0, 0, 1, 0]),
]
b_split_system = [A, outward]  # Is this the original system? (hint 1)

# %% right
a_matrix = a_matrix.subs(omega, sp.Symbol("omega")) * 1  # with a plain symbol
b_uncontrolled = [[0, 1, 1 / omega, 0]]  # divided by omega
b_uncontrolled = [[0, -(omega**2), -omega, 0]]  # another length and sign
b_uncontrollable_eigenvalues = [omega - omega]  # a zero that is computed
# b, Ab, AAb and the axis of v1
b_split = sp.Matrix.hstack(outward, A * outward, A**2 * outward, sp.Matrix([0, 0, 1, 0]))
# other coordinates in both parts
b_split = b_split * sp.Matrix([[1, 0, 0, 5], [0, 2, 0, 0], [1, 0, 1, 0], [0, 0, 0, -1]])
# the columns b, Ab, AAb and the axis of v1
chains = sp.Matrix(
    [[0, 0, 0, 3 * omega / 2], [1, 0, -(omega**2), 0], [0, 1, 0, -1 / (2 * omega)], [0, 0, 0, 0]]
)
b_split_system = [chains, sp.Matrix([1, 0, 0, 0])]

# %% wrong
a_controllable = False  # u1 enters the equation of v1 alone, and x2 is thought to be out of its reach
a_matrix = sp.Matrix.hstack(along, A.T*along, A.T**2*along, A.T**3*along)  # with the transposed matrix
a_matrix = sp.Matrix.hstack(along, A*along, A*along, A**2*along)  # a column written twice
b_controllable = True  # the outward thrust thought to be as good as the other one
b_uncontrolled = [[0, 2*omega, 1, 0]]  # the constant x1' + 2 omega x2 with v1 in the place of x1'
b_uncontrolled = [[0, 0, 1, 0]]  # v1 alone, since u2 is not in its equation
b_uncontrolled = []  # thought to be controllable
b_uncontrolled = [[0, omega, 1, 0], [1, 0, 0, 0]]  # the position along the orbit counted as well
b_lost = [sp.I*omega, -sp.I*omega]  # the oscillation, which is the part that is kept
b_lost = [0, sp.I*omega, -sp.I*omega]  # all eigenvalues of A
b_lost = []  # thought to be controllable
b_split = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [omega, 0, 0, 1], [0, omega, 1, 0]])  # (xi, eta) from x
b_split = sp.eye(4)[:, [0, 1, 3, 2]]  # v1 taken for the constant
# Kalman's matrix itself, which has no inverse
b_split = sp.Matrix.hstack(outward, A*outward, A**2*outward, A**3*outward)
# a constant that drives nothing: the drift forgotten
b_split_system = [sp.Matrix([[0, -2*omega, 0, 0], [0, 0, 1, 0], [0, -omega**2, 0, 0], [0]*4]), sp.Matrix([0, 0, 1, 0])]
# the height without the effect of x1': 3 omega^2 left as it was
b_split_system = [sp.Matrix([[0, 0, 0, 1], [0, 0, 1, 0], [0, 3*omega**2, 0, 0], [0]*4]), sp.Matrix([0, 0, 1, 0])]
b_split_system = [A, outward]  # the system as it was

# %% right
a_matrix = a_matrix.subs(omega, sp.Symbol("omega"))*1  # with a plain symbol
b_uncontrolled = [[0, 1, 1/omega, 0]]  # divided by omega
b_uncontrolled = [[0, -omega**2, -omega, 0]]  # another length and sign
b_lost = [omega - omega]  # a zero that is computed
# b, Ab, AAb and the axis of v1
b_split = sp.Matrix.hstack(outward, A*outward, A**2*outward, sp.Matrix([0, 0, 1, 0]))
# other coordinates in both parts
b_split = b_split*sp.Matrix([[1, 0, 0, 5], [0, 2, 0, 0], [1, 0, 1, 0], [0, 0, 0, -1]])
# the columns b, Ab, AAb and the axis of v1
chains = sp.Matrix([[0, 0, 0, 3*omega/2], [1, 0, -omega**2, 0], [0, 1, 0, -1/(2*omega)], [0, 0, 0, 0]])
b_split_system = [chains, sp.Matrix([1, 0, 0, 0])]

# %% wrong
a_uncontrolled = [[0, 1, 0, 0], [0, 0, 1, 0]]  # both variables without u in their equations, though x1 acts on x2
a_uncontrolled = [[0, 0, 0, 1]]  # the arrow from x3 to x4 read the wrong way
a_lost = [1, 2]  # all eigenvalues, as both have Jordan blocks
a_lost = []  # 1 thought to be kept, since x4 has it too
a_split = sp.eye(4)  # the variables in the order as they stand
a_split = sp.eye(4)[:, [2, 0, 1, 3]]  # the uncontrollable variable first
b_uncontrolled = [[1, 0, 0, 0], [0, 0, 0, 1]]  # both variables without u in their equations, though x2 acts on x1
b_uncontrolled = [[0, 0, 1, 0]]  # the arrow from x4 to x3 read the wrong way
b_lost = [3]  # the Jordan block thought to be entered at the wrong end
b_lost = [2, 3]  # all eigenvalues
b_split = sp.eye(4)[:, [3, 0, 1, 2]]  # the uncontrollable variable first
b_split = sp.Matrix.hstack(b_b, A_b*b_b, A_b**2*b_b, A_b**3*b_b)  # Kalman's matrix, which has no inverse
c_uncontrolled = [[0, 0, 1, 0]]  # the arrow from x4 to x3 read the wrong way
c_uncontrolled = []  # each eigenvalue of a Jordan block is thought to be reached from any of its places
c_lost = [2]  # the other Jordan block
c_lost = []  # 1 thought to be kept, since x3 has it too
c_split = sp.eye(4)[:, [3, 0, 1, 2]]  # the uncontrollable variable first
c_split = sp.eye(4)[:, [0, 1, 3, 2]]  # the order of item a
d_uncontrolled = [[1, 0, 0, 0], [0, 0, 0, 1]]  # both variables without u in their equations
d_uncontrolled = [[0, 0, 1, -1]]  # a difference that the control enters
d_lost = [(1 + sp.sqrt(13))/2, (1 - sp.sqrt(13))/2]  # the eigenvalues of x1 and x2, which are kept
d_lost = []  # 1 thought to be kept, since x3 has it too
d_split = sp.eye(4)[:, [3, 0, 1, 2]]  # the uncontrollable variable first
d_split = sp.eye(4)[:, [0, 1, 3, 2]]  # the order of item a
e_uncontrolled = [[-1, 0, 1, 0]]  # the control cancels in x3 - x1, but its derivative brings in x4
e_uncontrolled = [[-1, 0, 1, 0], [-1, 1, 0, 0]]  # all differences of the equations that the control enters alike
e_uncontrolled = []  # no zeros in the matrix, thought to be controllable
e_lost = [(1 + sp.sqrt(17))/2, (1 - sp.sqrt(17))/2]  # the eigenvalues of the controllable part
e_lost = [(1 + sp.sqrt(5))/2]  # only the growing one
e_split = sp.Matrix.hstack(sp.eye(4)[:, 2:], b_e, A_e*b_e)  # the uncontrollable part first
e_split = sp.Matrix([[1, 0, 0, 0], [1, 2, 0, 0], [1, 0, 1, 0], [0, 0, 0, 1]]).inv()*2 + sp.eye(4)  # a slip in solving
e_split_system = [A_e, b_e]  # the system as it was
# the two parts as they are, with the coupling forgotten in one equation
e_split_system = [sp.Matrix([[0, 4, 1, 2], [1, 1, 2, 1], [0, 0, 1, 1], [0, 0, 1, 1]]), sp.Matrix([1, 0, 0, 0])]
f_uncontrolled = [[-1, 0, 1, 0], [0, 0, 0, 1]]  # the rows of item e
f_uncontrolled = [[0, 0, 0, 1]]  # the only variable without u in its equation
f_lost = [(1 + sp.sqrt(5))/2, (1 - sp.sqrt(5))/2]  # the eigenvalues of item e
f_split = sp.Matrix.hstack(b_f, A_f*b_f, b_f, A_f*b_f)  # two columns repeated to fill up the matrix

# %% right
a_uncontrolled = [[0, 0, -7, 0]]  # another length and sign
a_split = sp.Matrix.hstack(b_a, A_a*b_a, A_a**2*b_a, sp.eye(4)[:, 2])  # the columns of the textbook
b_uncontrolled = [[0, 0, 0, 2]]  # another length
b_split = sp.Matrix.hstack(b_b, A_b*b_b, A_b**2*b_b, sp.eye(4)[:, 3])  # the columns of the textbook
c_split = sp.Matrix.hstack(b_c, A_c*b_c, A_c**2*b_c, sp.ones(4, 1))  # the columns of the textbook
d_split = sp.Matrix.hstack(b_d, A_d*b_d, A_d**2*b_d, sp.Matrix([0, 0, 1, -2]))  # the columns of the textbook
e_uncontrolled = [[-1, 0, 1, 1], [1, 0, -1, 1]]  # sum and difference of the two rows
e_lost = [sp.S.GoldenRatio, 1 - sp.S.GoldenRatio]  # by its name
e_split = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [1, 0, 1, 0], [0, 0, 0, 1]])  # simpler columns of the same plane
# in the simpler columns: the coordinates x1, x2, x3 - x1, x4
e_split_system = [sp.Matrix([[-2, 2, 1, 2], [-1, 3, 5, 4], [0, 0, 1, 1], [0, 0, 1, 0]]), sp.Matrix([1, 1, 0, 0])]
f_split = sp.Matrix.hstack(b_f, A_f*b_f, A_f**2*b_f, A_f**3*b_f)  # any invertible matrix: Kalman's
f_split = 3*sp.eye(4)[:, ::-1]  # the variables in another order and scale

# %% wrong
a_observable = True  # Is it enough that z and its derivative contain all states? (hint 1)
# Is this a row of the observable part instead of an unobservable state? (hint 1)
a_unobservable_states = [list(a_output)]
# Are these the states with zero output at a single instant only? (hint 1)
a_unobservable_states = [list(v) for v in a_output.nullspace()]
# Does this matrix have an inverse? (hint 1)
a_split = sp.Matrix.vstack(*(a_output * a_system**k for k in range(3)))
# Which coordinates must come first? (hint 1)
a_split = sp.Matrix(a_split)[::-1, :]
b_observable = True  # Is it enough that the other states act on the measured one? (hint 1)
# Is this the measured coordinate? (hint 1)
b_unobservable_states = [list(b_output)]
# Was a sign lost? Substitute the state into z and its derivative. (hint 2)
b_unobservable_states = [list(sp.Matrix(b_unobservable_states[0]).cross(b_output.T))]
# Is one of the first coordinates outside the observable part? (hint 1)
b_split = sp.Matrix(b_split)[[0, 2, 1], :]
c_observable = True  # Does a regular matrix imply observability? (hint 1)
# Are these the states with zero output at a single instant only? (hint 1)
c_unobservable_states = [list(v) for v in c_output.nullspace()]
# Were the new coordinates written into the columns? (hint 2)
c_split = sp.Matrix(c_split).T
d_observable = True  # Can three rows be dependent although no two are? (hint 2)
# Is the system observable as soon as all states occur? Look for a combination that never does.
# (hint 1)
d_unobservable_states = []
# Do the two observable coordinates come first? (hint 1)
d_split = sp.Matrix(d_split)[[0, 2, 1], :]
# Is there a slip in the last row? Test it with an unobservable state. (hint 1)
e_observable = True
# Were the signs lost? Substitute the state into z and its derivative. (hint 1)
e_unobservable_states = [list(sp.Matrix(e_unobservable_states[0]).cross(e_output.T))]
# Do the other two coordinates complete z to a decomposition? (hint 1)
e_split = sp.Matrix.vstack(e_output, sp.Matrix([e_unobservable_states[0]]), e_output * e_system)
f_observable = True  # Is it observable if the state is found only in the limit? (hint 1)
# Can the zero vector belong to a basis? (hint 1)
f_unobservable_states = [f_unobservable_states[0], [0, 0, 0]]
# Is this what the second observable coordinate measures? (hint 1)
f_unobservable_states = [list(f_output * f_system)]
# Does this matrix have an inverse? (hint 1)
f_split = sp.Matrix.vstack(*(f_output * f_system**k for k in range(3)))
g_observable = True  # Do complex eigenvalues make everything observable? (hint 1)
# Is this the measured direction? (hint 1)
g_unobservable_states = [list(g_output)]
# Does the unobservable coordinate come last? (hint 2)
g_split = sp.Matrix(g_split)[[0, 2, 1], :]
h_observable = True  # Are different eigenvalues enough for one output? (hint 1)
# Is this the observable eigenvector? (hint 1)
h_unobservable_states = [list(sp.Matrix(h_unobservable_states[0]).cross(h_output.T))]
# Were the eigenvectors written into the rows? (hint 1)
h_split = sp.Matrix(h_split)[::-1, :]

# %% right
a_unobservable_states = [[-2 * v for v in a_unobservable_states[0]]]  # another length and sign
a_unobservable_states = [[v / 3 for v in a_unobservable_states[0]]]  # another length
# the observable coordinates mixed
a_split = sp.Matrix([[1, 1, 0], [1, -1, 0], [0, 1, 1]]) * sp.Matrix(a_split)
b_unobservable_states = sp.Matrix(b_unobservable_states[0])  # a column
b_unobservable_states = [sp.Matrix(b_unobservable_states[0]) * sp.sqrt(2)]  # a list of columns
# another third coordinate
b_split = sp.Matrix([[1, 0, 0], [0, 1, 0], [2, -1, 7]]) * sp.Matrix(b_split)
c_unobservable_states = (c_unobservable_states[0],)  # a tuple
c_unobservable_states = [[float(v) for v in c_unobservable_states[0]]]  # floats
# the observable coordinates exchanged
c_split = sp.Matrix([[0, 1, 0], [1, 0, 0], [0, 0, -1]]) * sp.Matrix(c_split)
# without coupling: a left eigenvector for the hidden coordinate
v = sp.Matrix(c_unobservable_states[0])
value = (v.T * c_system * v)[0] / (v.T * v)[0]
w = (c_system - value * sp.eye(3)).T.nullspace()[0].T
c_split = sp.Matrix.vstack(c_output, c_output * c_system, w).tolist()
d_unobservable_states = [[v / 3 for v in d_unobservable_states[0]]]  # another length
d_unobservable_states = d_unobservable_states[0]  # a single vector without the outer list
# halves
d_split = sp.Matrix([[sp.S.Half, 0, 0], [1, 1, 0], [0, 0, 1]]) * sp.Matrix(d_split)
# without coupling: a left eigenvector for the hidden coordinate
v = sp.Matrix(d_unobservable_states[0])
value = (v.T * d_system * v)[0] / (v.T * v)[0]
w = (d_system - value * sp.eye(3)).T.nullspace()[0].T
d_split = sp.Matrix.vstack(d_output, d_output * d_system, w).tolist()
e_unobservable_states = [sp.Matrix(e_unobservable_states[0]) * sp.sqrt(2)]  # a list of columns
e_unobservable_states = [[-v for v in e_unobservable_states[0]]]  # the other sign
# the observable coordinates mixed
e_split = sp.Matrix([[1, 1, 0], [1, -1, 0], [0, 1, 1]]) * sp.Matrix(e_split)
# without coupling: a left eigenvector for the hidden coordinate
v = sp.Matrix(e_unobservable_states[0])
value = (v.T * e_system * v)[0] / (v.T * v)[0]
w = (e_system - value * sp.eye(3)).T.nullspace()[0].T
e_split = sp.Matrix.vstack(e_output, e_output * e_system, w).tolist()
f_unobservable_states = [[float(v) for v in f_unobservable_states[0]]]  # floats
f_unobservable_states = [[-2 * v for v in f_unobservable_states[0]]]  # another length and sign
# another third coordinate
f_split = sp.Matrix([[1, 0, 0], [0, 1, 0], [2, -1, 7]]) * sp.Matrix(f_split)
# without coupling: a left eigenvector for the hidden coordinate
v = sp.Matrix(f_unobservable_states[0])
value = (v.T * f_system * v)[0] / (v.T * v)[0]
w = (f_system - value * sp.eye(3)).T.nullspace()[0].T
f_split = sp.Matrix.vstack(f_output, f_output * f_system, w).tolist()
g_unobservable_states = g_unobservable_states[0]  # a single vector without the outer list
g_unobservable_states = sp.Matrix(g_unobservable_states[0])  # a column
# the observable coordinates exchanged
g_split = sp.Matrix([[0, 1, 0], [1, 0, 0], [0, 0, -1]]) * sp.Matrix(g_split)
# without coupling: a left eigenvector for the hidden coordinate
v = sp.Matrix(g_unobservable_states[0])
value = (v.T * g_system * v)[0] / (v.T * v)[0]
w = (g_system - value * sp.eye(3)).T.nullspace()[0].T
g_split = sp.Matrix.vstack(g_output, g_output * g_system, w).tolist()
h_unobservable_states = [[-v for v in h_unobservable_states[0]]]  # the other sign
h_unobservable_states = (h_unobservable_states[0],)  # a tuple
# halves
h_split = sp.Matrix([[sp.S.Half, 0, 0], [1, 1, 0], [0, 0, 1]]) * sp.Matrix(h_split)
# without coupling: a left eigenvector for the hidden coordinate
v = sp.Matrix(h_unobservable_states[0])
value = (v.T * h_system * v)[0] / (v.T * v)[0]
w = (h_system - value * sp.eye(3)).T.nullspace()[0].T
h_split = sp.Matrix.vstack(h_output, h_output * h_system, w).tolist()


# %% numbers
from workbook.authoring.numbers import linear_form, signed_permutations

systems = [
    (a_system, a_output),
    (b_system, b_output),
    (c_system, c_output),
    (d_system, d_output),
    (e_system, e_output),
    (f_system, f_output),
    (g_system, g_output),
    (h_system, h_output),
]
turns = signed_permutations(3)


def turned(start, step):
    """The systems with their coordinates permuted and mirrored."""
    chosen = [turns[(start + step * k) % 48] for k in range(8)]
    pairs = [(T * A * T.T, H * T.T) for T, (A, H) in zip(chosen, systems)]
    return [A for A, _ in pairs] + [H for _, H in pairs]


(
    a_system,
    b_system,
    c_system,
    d_system,
    e_system,
    f_system,
    g_system,
    h_system,
    a_output,
    b_output,
    c_output,
    d_output,
    e_output,
    f_output,
    g_output,
    h_output,
) = [
    turned(*parts)
    for parts in [
        (0, 0),
        (1, 5),
        (8, 30),
        (10, 12),
        (25, 7),
        (16, 19),
        (32, 37),
        (13, 0),
        (21, 31),
        (23, 7),
        (3, 8),
        (26, 41),
        (35, 25),
    ]
]
x = ["x_1", "x_2", "x_3"]
shown = [
    f"{item}) $\\quad\\dot x_1 = «linear_form({item}_system.row(0), x)»,$ "
    f"$\\quad \\dot x_2 = «linear_form({item}_system.row(1), x)»,$ "
    f"$\\quad \\dot x_3 = «linear_form({item}_system.row(2), x)»,$ "
    f"$\\quad z = «linear_form({item}_output, x)»"
    for item in "abcdefgh"
]
site_share = sp.Rational(3, 8)  # 8 of 24: that no system is observable holds in all rows


def answers(A, H):
    """The unobservable state, and the coordinates z, its derivative and one more."""
    rows = sp.Matrix.vstack(H, H * A)
    v = rows.nullspace()[0]
    return [list(v)], sp.Matrix.vstack(rows, v.T)


a_unobservable_states, a_split = answers(a_system, a_output)
b_unobservable_states, b_split = answers(b_system, b_output)
c_unobservable_states, c_split = answers(c_system, c_output)
d_unobservable_states, d_split = answers(d_system, d_output)
e_unobservable_states, e_split = answers(e_system, e_output)
f_unobservable_states, f_split = answers(f_system, f_output)
g_unobservable_states, g_split = answers(g_system, g_output)
h_unobservable_states, h_split = answers(h_system, h_output)

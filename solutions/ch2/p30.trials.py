# %% wrong
# Is this the variable that the control enters? (hint 1)
a_uncontrolled = [list(b_a)]
# Does the driven variable cancel in the difference, or in the sum? (hint 1)
a_uncontrolled = [list(sp.Matrix(a_uncontrolled[0]).cross(b_a))]
# Does this lead from x to the new coordinates, instead of from them to x?
a_split = sp.Matrix(a_split).inv()
# Which coordinates must come first? (hint 1)
a_split = sp.Matrix(a_split)[:, ::-1]
# Does this matrix have an inverse? (hint 1)
a_split = sp.Matrix.hstack(b_a, A_a * b_a, A_a**2 * b_a)
# Is it enough that the driven variable acts on both others? (hint 1)
b_uncontrolled = []
# Does the control cancel in a combination of all three equations? (hint 1)
b_uncontrolled = [[p + q for p, q in zip(b_uncontrolled[0], b_b)]]
# Does this lead from x to the new coordinates, instead of from them to x?
b_split = sp.Matrix(b_split).inv()
# Which coordinates must come first? (hint 1)
b_split = sp.Matrix(b_split)[:, ::-1]
# Can the coordinates be left as they are? (hint 1)
b_split = sp.eye(3)
# What is the sign of the effect of the driven variable on the other two? (hint 1)
c_uncontrolled = [list(sp.Matrix(c_uncontrolled[0]).cross(b_c))]
# Is this an eigenvector of A instead of its transpose?
w = sp.Matrix([c_uncontrolled[0]])
value = (w * A_c * w.T)[0] / (w * w.T)[0]
c_uncontrolled = [list((A_c - value * sp.eye(3)).nullspace()[0])]
# Does this lead from x to the new coordinates, instead of from them to x?
c_split = sp.Matrix(c_split).inv()
# Which coordinates must come first? (hint 1)
c_split = sp.Matrix(c_split)[:, ::-1]
# Does this matrix have an inverse? (hint 1)
c_split = sp.Matrix.hstack(b_c, A_c * b_c, A_c**2 * b_c)
# The control cancels here, but is the derivative a multiple of the combination itself? (hint 1)
d_uncontrolled = [list(b_d.cross(sp.Matrix([1 - p**2 for p in b_d])))]
# Is this an eigenvector of A instead of its transpose? (hint 1)
w = sp.Matrix([d_uncontrolled[0]])
value = (w * A_d * w.T)[0] / (w * w.T)[0]
d_uncontrolled = [list((A_d - value * sp.eye(3)).nullspace()[0])]
# Does this lead from x to the new coordinates, instead of from them to x?
d_split = sp.Matrix(d_split).inv()
# Which coordinates must come first? (hint 1)
d_split = sp.Matrix(d_split)[:, ::-1]
# Does this matrix have an inverse? (hint 1)
d_split = sp.Matrix.hstack(b_d, A_d * b_d, A_d**2 * b_d)
# Must the control enter an equation directly? Which variables act on this one? (hint 1)
e_uncontrolled = [list(sp.Matrix(e_uncontrolled[0]).cross(b_e))]
# Are both variables without u in their equations uncontrollable? (hint 1)
e_uncontrolled = [e_uncontrolled[0], list(sp.Matrix(e_uncontrolled[0]).cross(b_e))]
# Does this lead from x to the new coordinates, instead of from them to x?
e_split = sp.Matrix(e_split).inv()
# Which coordinates must come first? (hint 1)
e_split = sp.Matrix(e_split)[:, ::-1]
# Can the coordinates be left as they are? (hint 1)
e_split = sp.eye(3)
# The control cancels here, but is the derivative a multiple of the combination itself? (hint 1)
f_uncontrolled = [list(b_f.cross(sp.Matrix([1 - p**2 for p in b_f])))]
# Is this an eigenvector of A instead of its transpose? (hint 1)
w = sp.Matrix([f_uncontrolled[0]])
value = (w * A_f * w.T)[0] / (w * w.T)[0]
f_uncontrolled = [list((A_f - value * sp.eye(3)).nullspace()[0])]
# Which coordinates must come first? (hint 1)
f_split = sp.Matrix(f_split)[:, ::-1]
# Was a sign lost? Does the driven variable act on this combination? (hint 1)
g_uncontrolled = [list(sp.Matrix(g_uncontrolled[0]).cross(b_g))]
# Are both variables without u in their equations uncontrollable? (hint 1)
g_uncontrolled = [list(sp.eye(3).row(k)) for k in range(3) if b_g[k] == 0]
# Which coordinates must come first? (hint 1)
g_split = sp.Matrix(g_split)[:, ::-1]
# Does this matrix have an inverse? (hint 1)
g_split = sp.Matrix.hstack(b_g, A_g * b_g, A_g**2 * b_g)
# Is this variable alone the uncontrollable combination? (hint 1)
h_uncontrolled = [list((2 * b_h + A_h * b_h - sp.Matrix(h_uncontrolled[0])) / 3)]
# The control cancels here, but is the derivative a multiple of the combination itself? (hint 1)
h_uncontrolled = [list(b_h.cross(sp.Matrix([1 - p**2 for p in b_h])))]
# Does this lead from x to the new coordinates, instead of from them to x?
h_split = sp.Matrix(h_split).inv()
# Which coordinates must come first? (hint 1)
h_split = sp.Matrix(h_split)[:, ::-1]
# Can the coordinates be left as they are? (hint 1)
h_split = sp.eye(3)
# Is this an eigenvector of A instead of its transpose? (hint 1)
w = sp.Matrix([i_uncontrolled[0]])
value = (w * A_i * w.T)[0] / (w * w.T)[0]
i_uncontrolled = [list((A_i - value * sp.eye(3)).nullspace()[0])]
# Does a multiple eigenvalue mean that as many combinations are uncontrollable? (hint 1)
i_uncontrolled = [i_uncontrolled[0], list((b_i - A_i * b_i - 2 * sp.Matrix(i_uncontrolled[0])) / 3)]
# Does this lead from x to the new coordinates, instead of from them to x?
i_split = sp.Matrix(i_split).inv()
# Which coordinates must come first? (hint 1)
i_split = sp.Matrix(i_split)[:, ::-1]
# Does this matrix have an inverse? (hint 1)
i_split = sp.Matrix.hstack(b_i, A_i * b_i, A_i**2 * b_i)
# Does the control cancel in the difference, or in the sum? (hint 1)
j_uncontrolled = [list(sp.Matrix(j_uncontrolled[0]).cross(b_j))]
# Does the control cancel when all three equations are combined? (hint 1)
j_uncontrolled = [[p + q for p, q in zip(j_uncontrolled[0], b_j)]]
# Which coordinates must come first? (hint 1)
j_split = sp.Matrix(j_split)[:, ::-1]
# Is this the variable that the control enters? (hint 1)
k_uncontrolled = [list(b_k)]
# Is everything controllable? Look for a combination whose derivative does not contain u. (hint 1)
k_uncontrolled = []
# Which coordinates must come first? (hint 1)
k_split = sp.Matrix(k_split)[:, ::-1]
# The control cancels here, but is the derivative a multiple of the combination itself? (hint 1)
l_uncontrolled = [list(b_l.cross(sp.Matrix([1 - p**2 for p in b_l])))]
# Is this the direction in which the control acts? (hint 1)
l_uncontrolled = [list(b_l)]
# Which coordinates must come first? (hint 1)
l_split = sp.Matrix(l_split)[:, ::-1]
# Can the coordinates be left as they are? (hint 1)
l_split = sp.eye(3)

# %% right
# another length and sign
a_uncontrolled = [[-3 * p for p in a_uncontrolled[0]]]
# another basis of the plane, another third column
a_split = sp.Matrix(a_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])
# another length and sign
b_uncontrolled = [[-3 * p for p in b_uncontrolled[0]]]
# another basis of the plane, another third column
b_split = sp.Matrix(b_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])
# another length and sign
c_uncontrolled = [[-3 * p for p in c_uncontrolled[0]]]
# another basis of the plane, another third column
c_split = sp.Matrix(c_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])
# another length and sign
d_uncontrolled = [[-3 * p for p in d_uncontrolled[0]]]
# another basis of the plane, another third column
d_split = sp.Matrix(d_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])
# another length and sign
e_uncontrolled = [[-3 * p for p in e_uncontrolled[0]]]
# another basis of the plane, another third column
e_split = sp.Matrix(e_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])
# another length and sign
f_uncontrolled = [[-3 * p for p in f_uncontrolled[0]]]
# another basis of the plane, another third column
f_split = sp.Matrix(f_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])
# another length and sign
g_uncontrolled = [[-3 * p for p in g_uncontrolled[0]]]
# another basis of the plane, another third column
g_split = sp.Matrix(g_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])
# another length and sign
h_uncontrolled = [[-3 * p for p in h_uncontrolled[0]]]
# another basis of the plane, another third column
h_split = sp.Matrix(h_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])
# another length and sign
i_uncontrolled = [[-3 * p for p in i_uncontrolled[0]]]
# another basis of the plane, another third column
i_split = sp.Matrix(i_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])
# another length and sign
j_uncontrolled = [[-3 * p for p in j_uncontrolled[0]]]
# another basis of the plane, another third column
j_split = sp.Matrix(j_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])
# another length and sign
k_uncontrolled = [[-3 * p for p in k_uncontrolled[0]]]
# another basis of the plane, another third column
k_split = sp.Matrix(k_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])
# another length and sign
l_uncontrolled = [[-3 * p for p in l_uncontrolled[0]]]
# another basis of the plane, another third column
l_split = sp.Matrix(l_split) * sp.Matrix([[1, 0, -1], [1, 2, 0], [0, 0, 1]])

# %% numbers
from workbook.authoring.numbers import signed_permutations

systems = [
    (A_a, b_a),
    (A_b, b_b),
    (A_c, b_c),
    (A_d, b_d),
    (A_e, b_e),
    (A_f, b_f),
    (A_g, b_g),
    (A_h, b_h),
    (A_i, b_i),
    (A_j, b_j),
    (A_k, b_k),
    (A_l, b_l),
]
turns = signed_permutations(3)


def turned(start, step):
    """The systems with their coordinates permuted and mirrored; j and k, d and l stay alike."""
    chosen = [turns[(start + step * k) % 48] for k in (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 3)]
    pairs = [(T * A * T.T, T * b) for T, (A, b) in zip(chosen, systems)]
    return [A for A, _ in pairs] + [b for _, b in pairs]


(
    A_a,
    A_b,
    A_c,
    A_d,
    A_e,
    A_f,
    A_g,
    A_h,
    A_i,
    A_j,
    A_k,
    A_l,
    b_a,
    b_b,
    b_c,
    b_d,
    b_e,
    b_f,
    b_g,
    b_h,
    b_i,
    b_j,
    b_k,
    b_l,
) = [
    turned(*parts)
    for parts in [
        (0, 0),
        (2, 28),
        (4, 16),
        (6, 4),
        (7, 46),
        (9, 34),
        (10, 28),
        (11, 22),
        (8, 3),
        (13, 9),
        (28, 16),
        (30, 4),
    ]
]


def answers(A, b):
    """The row without control, and two vectors of the plane of b and A*b with one outside it."""
    w = sp.Matrix.hstack(b, A * b, A**2 * b).T.nullspace()[0]
    return [list(w)], sp.Matrix.hstack(b + 2 * A * b, b + 3 * A * b, b + 5 * w)


def side(A, b, k):
    """The right-hand side of an equation, as the page writes it."""
    terms = [*zip(A.row(k), ("x_1", "x_2", "x_3")), (b[k], "u")]
    signed = [f"{'-' if n < 0 else '+'} {abs(n) if abs(n) != 1 else ''}{x}" for n, x in terms if n]
    first, *others = signed
    return " ".join([first.replace("+ ", "").replace("- ", "-"), *others])


shown = [
    f"{item})\n\n$$\n\\begin{{aligned}}\n"
    + ",\\\\\n".join(f"\\dot x_{k + 1} &= «side(A_{item}, b_{item}, {k})»" for k in range(3))
    for item in "abcdefghijkl"
]
a_uncontrolled, a_split = answers(A_a, b_a)
b_uncontrolled, b_split = answers(A_b, b_b)
c_uncontrolled, c_split = answers(A_c, b_c)
d_uncontrolled, d_split = answers(A_d, b_d)
e_uncontrolled, e_split = answers(A_e, b_e)
f_uncontrolled, f_split = answers(A_f, b_f)
g_uncontrolled, g_split = answers(A_g, b_g)
h_uncontrolled, h_split = answers(A_h, b_h)
i_uncontrolled, i_split = answers(A_i, b_i)
j_uncontrolled, j_split = answers(A_j, b_j)
k_uncontrolled, k_split = answers(A_k, b_k)
l_uncontrolled, l_split = answers(A_l, b_l)

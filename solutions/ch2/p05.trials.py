# %% wrong
# Must there be as many measurements as unknowns? What do the derivatives of the measurement show?
# (hint 1)
a_observable = False
# Are these the states with zero output at one instant? Follow them a little longer. (hint 1)
a_unobservable_states = [[0, 1, 0], [0, 0, 1]]
# Is one sign in the equations read as in example 3 of the chapter? Write the derivatives of z out
# once more. (hint 1)
b_observable = False
# Is this the unobservable state of example 3? The system here differs from it in a sign. (hint 1)
b_unobservable_states = [[1, 0, -1]]
# Is it enough that every coordinate acts on another one? Two of them may always act in the same
# way. (hint 1)
c_observable = True
# Was a sign lost when z and its derivative were set to zero? Test the vector in both equations.
# (hint 1)
c_unobservable_states = [[0, c_unobservable_states[0][1], -c_unobservable_states[0][2]]]
# Do these states stay unobservable as time goes on, or only at the initial time? (hint 2)
c_unobservable_states = [[0, 1, 0], [0, 0, 1]]
c_unobservable_states = [[0, 0, 0]]  # Can the zero vector belong to a basis? (hint 1)
# Is it enough that all three coordinates enter z or its derivative? They may enter in one
# combination only. (hint 1)
d_observable = True
# Was a sign lost? Substitute this vector into the derivative of z. (hint 1)
d_unobservable_states = [[d_unobservable_states[0][0], 0, -d_unobservable_states[0][2]]]
# Is the system observable because all eigenvalues appear in z? Count the eigenvectors too. (hint 1)
e_observable = True
# Does the motion along this eigenvector really give zero for z? (hint 2)
e_unobservable_states = [list(A_e.nullspace()[0])]
# Is one vector too many here? Compute the output of each of them and its derivative. (hint 2)
e_unobservable_states = [*e_unobservable_states, [0, 1, 0]]
# Is a coordinate observable because the others act on it? Check which ones it acts on. (hint 1)
f_observable = True
# Are these the states with zero output at the initial time only? (hint 1)
f_unobservable_states = [list(v) for v in H_f.nullspace()]
# Was one factor of the determinant overlooked? (hint 1)
g_region = sp.Ne(alpha, min(g_unobservable_states))
# Are these the values for which the system is unobservable, instead of observable? (hint 1)
g_region = sp.Or(*(sp.Eq(alpha, value) for value in g_unobservable_states))
# Does the sign of the determinant matter, or only whether it vanishes? (hint 1)
g_region = sp.And(sp.Ne(alpha, min(g_unobservable_states)), alpha < max(g_unobservable_states))
# Is one vector a whole basis at each of these values? Count the independent rows that remain. (hint
# 2)
g_unobservable_states = {value: basis[:1] for value, basis in g_unobservable_states.items()}
# Was one of the exceptional values left out? (hint 1)
g_unobservable_states = {
    min(g_unobservable_states): g_unobservable_states[min(g_unobservable_states)]
}
# Were the two values swapped? Substitute each of them into the rows again. (hint 1)
g_unobservable_states = dict(zip(g_unobservable_states, reversed(g_unobservable_states.values())))
# Was a sign lost in the factor of the determinant? (hint 2)
h_region = sp.Ne(alpha, -min(h_unobservable_states))
# Is this the eigenvector alone? How many rows are still independent there? (hint 1)
h_unobservable_states = {
    min(h_unobservable_states): [list(v) for v in (A_h + sp.eye(3)).nullspace()]
}
# Is the system unobservable at each of these values? Compute the determinant there. (hint 1)
h_unobservable_states = h_unobservable_states | {min(h_unobservable_states) + 2: [[1, 0, 0]]}
# Is this the condition of a single minor? All of them have to vanish together. (hint 1)
i_region = sp.And(
    sp.Ne(alpha, min(i_unobservable_states)), sp.Ne(alpha, min(i_unobservable_states) + 2)
)
# Is this unobservable only from the first output? Compute the second output too, and check the
# value. (hint 1)
i_unobservable_states = {value + 2: basis for value, basis in i_unobservable_states.items()}
# Are both outputs of this eigenvector really zero? (hint 1)
i_unobservable_states = {value: [[1, 1, 0]] for value in i_unobservable_states}
# Is this the condition of a single minor? The others may still be different from zero there. (hint 1)
j_region = sp.And(
    sp.Ne(alpha, min(j_unobservable_states)),
    sp.Ne(alpha, min(j_unobservable_states) + sp.Rational(1, 2)),
)
j_region = True  # Does the minor really never vanish? Factor it. (hint 1)
# Is this eigenvector unobservable only from the first output? Compute the second one at this value.
# (hint 1)
unseen_by_first = [list(v) for v in (A_j + 5 * sp.eye(3)).nullspace()]
j_unobservable_states = j_unobservable_states | {
    min(j_unobservable_states) + sp.Rational(1, 2): unseen_by_first
}

# %% right
a_unobservable_states = sp.zeros(3, 0)  # a matrix without columns
b_unobservable_states = sp.zeros(3, 0)  # a matrix without columns
c_unobservable_states = [
    tuple(2.5 * float(x) for x in c_unobservable_states[0])
]  # another length, as decimals
c_unobservable_states = -3 * sp.Matrix(c_unobservable_states[0])  # a column
d_unobservable_states = [-7 * sp.Matrix(d_unobservable_states[0])]  # a list of columns
# floats of length one
import numpy as np

vector = np.array(e_unobservable_states[0], dtype=float)
e_unobservable_states = [vector / np.linalg.norm(vector)]
e_unobservable_states = (tuple(-x for x in e_unobservable_states[0]),)  # a tuple of tuples
f_unobservable_states = -sp.Matrix(f_unobservable_states[0])  # a column
# an array
import numpy as np

f_unobservable_states = 4 * np.array(f_unobservable_states, dtype=float)
# the determinant
g_region = sp.Ne(sp.Matrix.vstack(H_g, H_g * A_g, H_g * A_g**2).det(), 0)
# a list of two conditions, a plain symbol and decimals
g_region = [sp.Ne(sp.Symbol("alpha"), float(value)) for value in g_unobservable_states]
# eigenvectors as the basis, floats as the values
growing = [(A_g - root * sp.eye(3)).nullspace()[0] for root in (1, 2)]
g_unobservable_states = {
    float(min(g_unobservable_states)): growing,
    float(max(g_unobservable_states)): (A_g + sp.eye(3)).nullspace(),
}
# matrices with the basis as columns
g_unobservable_states = {
    value: sp.Matrix(basis).T for value, basis in g_unobservable_states.items()
}
h_region = sp.Or(
    alpha < min(h_unobservable_states), alpha > min(h_unobservable_states)
)  # two intervals
# the two eigenvectors
h_unobservable_states = {
    min(h_unobservable_states): [(A_h + root * sp.eye(3)).nullspace()[0] for root in (1, -1)]
}
h_unobservable_states = {
    value: H_h.subs(alpha, value).nullspace() for value in h_unobservable_states
}  # a list of columns
# the sum of the squares of two minors
minor = alpha - min(i_unobservable_states)
i_region = sp.Ne(minor**2 + (minor * (minor - 2)) ** 2, 0)
# one of several minors does not vanish
minor = alpha - min(i_unobservable_states)
i_region = sp.Or(sp.Ne(minor, 0), sp.Ne(minor * (minor - 2), 0))
# the other sign, as a tuple
i_unobservable_states = {
    value: [tuple(-x for x in basis[0])] for value, basis in i_unobservable_states.items()
}
i_unobservable_states = {
    float(value): 5 * sp.Matrix(basis[0]) for value, basis in i_unobservable_states.items()
}  # a column
j_region = sp.Ne(
    (alpha - min(j_unobservable_states)) * (1 + alpha**2), 0
)  # a factor that never vanishes kept
# another length
j_unobservable_states = {
    value: [[2 * x for x in basis[0]]] for value, basis in j_unobservable_states.items()
}
# an array of floats
import numpy as np

j_unobservable_states = {
    value: -0.5 * np.array(basis, dtype=float) for value, basis in j_unobservable_states.items()
}

# %% numbers
from itertools import combinations

from workbook.authoring.numbers import linear_form


def sheared(A, row, column, factor):
    """The matrix after a multiple of one coordinate is added to another."""
    T = sp.eye(3)
    T[row, column] = factor
    return T * A * T.inv()


def changed(factors, order):
    """The systems of items c to j in other coordinates: alpha moves in g to j."""
    c, d, e, g, h, i, j = factors
    return (
        *(sheared(A_c, 2, 1, c), sheared(A_d, 2, 0, d), sheared(A_e, 2, 0, e)),
        *(A_f.extract(order, order), H_f.extract([0], order)),
        *(sheared(A_g, 0, 2, g), sheared(A_h, 1, 2, h)),
        *(sheared(A_i, 1, 2, i), sheared(A_j, 0, 2, j)),
    )


A_c, A_d, A_e, A_f, H_f, A_g, A_h, A_i, A_j = [
    changed(*parts)
    for parts in [
        ((0, 0, 0, 0, 0, 0, 0), [0, 1, 2]),
        ((-1, -3, 1, 1, -4, 4, -3), [0, 2, 1]),
        ((-2, -4, -3, 2, 2, 3, 2), [2, 0, 1]),
        ((-5, 1, -2, -1, 1, 5, -1), [1, 2, 0]),
        ((-4, -4, 3, -2, -1, 1, -3), [2, 1, 0]),
        ((-3, 2, -3, -3, 1, 4, -2), [2, 0, 1]),
        ((2, -2, -2, 1, -5, -1, 1), [2, 0, 1]),
        ((-1, 1, -4, -2, 2, 2, -2), [1, 2, 0]),
        ((-3, 2, 3, -5, 4, -1, -4), [0, 2, 1]),
        ((4, 1, -5, -4, 3, 3, 1), [0, 2, 1]),
    ]
]
states = ["x_1", "x_2", "x_3"]
acting = [
    "last two equations: do they need the first",
    "first and the third equation: do they need the second",
    "first two equations: do they need the third",
]
shown = [
    *(
        f"{item}) $\\quad\\dot x_1 = «linear_form(A_{item}.row(0), states)»,$ "
        f"$\\quad \\dot x_2 = «linear_form(A_{item}.row(1), states)»,$ "
        f"$\\quad \\dot x_3 = «linear_form(A_{item}.row(2), states)»"
        for item in "cdefghij"
    ),
    "z = «linear_form(H_f, states)».",
    "Look at the «acting[H_f.tolist()[0].index(0)]»",
]
site_share = 0.41  # 8 of 20: the items a and b, and the verdicts of c to f


def lost(A, H):
    """The values of alpha at which the rank falls, with the states that are unobservable there."""
    N = sp.Matrix.vstack(H, H * A, H * A**2)
    minors = [N.extract(rows, range(3)).det() for rows in combinations(range(N.rows), 3)]
    return {value: basis(N.subs(alpha, value)) for value in sp.roots(sp.gcd_list(minors), alpha)}


def basis(N):
    return [list(v) for v in N.nullspace()]


c_unobservable_states, d_unobservable_states, e_unobservable_states, f_unobservable_states = [
    basis(sp.Matrix.vstack(H, H * A, H * A**2))
    for A, H in [(A_c, H_c), (A_d, H_d), (A_e, H_e), (A_f, H_f)]
]
g_unobservable_states, h_unobservable_states, i_unobservable_states, j_unobservable_states = [
    lost(A, H) for A, H in [(A_g, H_g), (A_h, H_h), (A_i, H_i), (A_j, H_j)]
]
g_region, h_region, i_region, j_region = [
    sp.And(*(sp.Ne(alpha, value) for value in unseen))
    for unseen in [
        g_unobservable_states,
        h_unobservable_states,
        i_unobservable_states,
        j_unobservable_states,
    ]
]

# %% wrong
controllable = sp.Ne(beta, 0)  # Is it enough that the control enters both equations? (hint 2)
# Does the left eigenvector have the right signs? (hint 1)
value = next(v for v in uncontrolled if v)
controllable = sp.And(sp.Ne(beta, 0), sp.Ne(beta, -value))
# Does the output matter for controllability? (hint 1)
controllable = sp.And(*(sp.Ne(beta, v) for v in uncontrolled), sp.Ne(alpha, *unobservable_states))
# Does a constant numerator mean that the system is uncontrollable? (hint 1)
controllable = sp.And(*(sp.Ne(beta, v) for v in uncontrolled), sp.Ne(alpha * beta, -1))
# Are these columns, the controllable directions, instead of rows? (hint 1)
uncontrolled = {v: [list(B.subs(beta, v))] for v in uncontrolled}
uncontrolled = {0: [[0, 1]]}  # Was one of the two left eigenvectors overlooked? (hint 2)
# Were the two combinations swapped? (hint 1)
p, q = uncontrolled
uncontrolled = {p: uncontrolled[q], q: uncontrolled[p]}
observable = sp.Ne(alpha, 0)  # Must both coordinates appear in z? (hint 1)
# Is it enough that $x_2$ acts on $x_1$? Think of the motions for which $z$ vanishes. (hint 2)
observable = sp.true
value = next(iter(unobservable_states))
observable = sp.Ne(alpha, -value)  # Was a sign lost in the row h A? (hint 2)
# Does the control matter for observability? (hint 2)
observable = sp.And(sp.Ne(alpha, *unobservable_states), sp.Ne(beta, 0))
# Is this the row of the output instead of an unobservable state? (hint 1)
unobservable_states = {value: [[1, value]] for value in unobservable_states}
# Is this the eigenvector of the other eigenvalue? (hint 1)
unobservable_states = {value: [[1, 0]] for value in unobservable_states}
unobservable_states = {
    0: [[0, 1]]
}  # Is a coordinate unobservable whenever it is not measured? (hint 1)
# Was the derivative of the control forgotten? (hint 1)
left, right = equation.args
equation = sp.Eq(left, right.subs(u.diff(t), 0))
# What is the sign of the action of $x_2$ on $x_1$? (hint 1)
left, right = equation.args
equation = sp.Eq(left, right - 2 * A[0, 1] * beta * u)
# Does this equation hold only for one special value? It must be of second order. (hint 2)
equation = sp.Eq(z.diff(t) - A[0, 0] * z, (1 - beta) * u)
# Were the two fractions added without a common denominator? (hint 1)
equation = sp.Eq(equation.args[0], (1 + alpha * beta) * u)

# %% right
value = next(v for v in uncontrolled if v)
controllable = sp.Ne(beta**2 - value * beta, 0)  # the determinant
# three intervals, with a plain symbol
v, (p, q) = sp.Symbol("beta"), sorted(uncontrolled)
controllable = sp.Or(v < p, sp.And(v > p, v < q), v > q)
# other lengths and signs, columns for rows
uncontrolled = {v: -2 * sp.Matrix(rows[0]) for v, rows in uncontrolled.items()}
# decimals
uncontrolled = {float(v): [[float(w) / 4 for w in rows[0]]] for v, rows in uncontrolled.items()}
value = next(iter(unobservable_states))
observable = sp.Or(alpha < value, alpha > value)  # two half-planes
# the determinant, with a plain symbol
observable = sp.Ne(sp.Matrix([H, H * A]).det().subs(alpha, sp.Symbol("alpha")), 0)
unobservable_states = {
    v: [[-3 * x for x in rows[0]]] for v, rows in unobservable_states.items()
}  # another length and sign
# a decimal key and a column
unobservable_states = {float(v): sp.Matrix(rows[0]) / 2 for v, rows in unobservable_states.items()}
# solved for the second derivative, plain symbols
left, right = equation.args
second = right - left + z.diff(t, 2)
equation = sp.Eq(z.diff(t, 2), second.subs({alpha: sp.Symbol("alpha"), beta: sp.Symbol("beta")}))
# factors as operators
p, q, c = A[0, 0], A[1, 1], A[0, 1]
first = z.diff(t) - p * z
numerator = u.diff(t) - q * u + c * beta * u + alpha * beta * (u.diff(t) - p * u)
equation = sp.Eq(first.diff(t) - q * first, numerator)

# %% numbers
from workbook.authoring.numbers import linear_form

A = [
    sp.Matrix([[p, c], [0, q]])
    for p, c, q in [
        (-1, -1, -2),
        (-1, 2, -3),
        (-3, 1, -1),
        (-4, -1, -1),
        (-2, -1, -5),
        (-4, 2, -1),
        (-3, -2, -4),
        (-2, 3, -1),
        (-3, -1, -1),
        (-2, -3, -1),
        (-1, -1, -5),
        (-1, 1, -5),
        (-5, -2, -4),
        (-3, 3, -1),
    ]
]
sides = [linear_form([*A.row(k), B[k]], ["x_1", "x_2", "u"]) for k in range(2)]
shown = [r"\dot x_1 = «sides[0]»,\qquad \dot x_2 = «sides[1]»,\qquad z"]
p, c, q = A[0, 0], A[0, 1], A[1, 1]
controllable = sp.And(sp.Ne(beta, 0), sp.Ne(beta, (q - p) / c))
uncontrolled = {0: [[0, 1]], (q - p) / c: [[p - q, c]]}
observable = sp.Ne(alpha, c / (p - q))
unobservable_states = {c / (p - q): [[c, q - p]]}
equation = sp.Eq(
    z.diff(t, 2) - (p + q) * z.diff(t) + p * q * z,
    (1 + alpha * beta) * u.diff(t) + (c * beta - q - p * alpha * beta) * u,
)

# %% wrong
# What is the root of the polynomial of the output? Check its sign. (hint 2)
a_observable = sp.Ne(weight**2 + weight * alpha + beta, 0)
# Was a sign lost in the second row? (hint 1)
a_observable = sp.Ne(weight**2 - weight * alpha - beta, 0)
# Must the motions be stable in order to be observable? (hint 1)
a_observable = sp.And(sp.Ne(weight * alpha - beta, weight**2), alpha > 0, beta > 0)
# Are both motions of the double root observable? One of the two vanishes in z. (hint 2)
a_observable = sp.Or(sp.Ne(weight * alpha - beta, weight**2), sp.Eq(alpha, 2 * weight))
# Is this where the system is not observable? (hint 2)
a_observable = sp.Eq(weight * alpha - beta, weight**2)
# Are these the roots themselves? Substitute one of them into z. (hint 1)
p, q = b_unobservable_states
b_unobservable = sp.Or(sp.Eq(h, -p), sp.Eq(h, -q))
# Are these the values for which the system is observable? (hint 2)
p, q = b_unobservable_states
b_unobservable = sp.And(sp.Ne(h, p), sp.Ne(h, q))
# Is this the only motion that can vanish in z? (hint 2)
b_unobservable = sp.Eq(h, min(b_unobservable_states))
# Is a motion unobservable without the position? The equation couples position and velocity. (hint
# 1)
b_unobservable = sp.Eq(h, 0)
# Is this motion unobservable for this value, or the other one? (hint 1)
p, q = b_unobservable_states
b_unobservable_states = {p: [[1, -q]], q: [[1, -p]]}
# Are these the rows of the outputs instead of the states? (hint 1)
b_unobservable_states = {value: [[value, 1]] for value in b_unobservable_states}
# Was one of the two motions overlooked? (hint 1)
p = min(b_unobservable_states)
b_unobservable_states = {p: [[1, -p]]}

# %% right
# the determinant as it comes, with plain symbols
p, q = sp.symbols("alpha beta")
a_observable = sp.Ne(weight**2 - weight * p + q, 0)
# two half-planes
a_observable = sp.Or(weight * alpha < weight**2 + beta, weight * alpha > weight**2 + beta)
# a negation, solved for beta
a_observable = sp.Not(sp.Eq(beta, weight * (alpha - weight)))
# the determinant, factored
p, q = b_unobservable_states
b_unobservable = sp.Eq((h - p) * (h - q), 0)
# the determinant multiplied out, with a plain symbol
b_unobservable = sp.Eq(sp.Symbol("h") ** 2 + stiffness, friction * sp.Symbol("h"))
# other lengths, in the other order
p, q = b_unobservable_states
b_unobservable_states = {q: [[-3, 3 * q]], p: [[0.5, -p / 2]]}
b_unobservable_states = {p: sp.Matrix([1, -p]) for p in b_unobservable_states}  # columns

# %% numbers
weight, friction, stiffness = [
    (weight, p + q, p * q)
    for weight, p, q in [
        (1, 1, 2),
        (3, 1, 3),
        (4, 2, 3),
        (-2, 1, 4),
        (-1, 2, 5),
        (-3, 3, 4),
        (2, 1, 5),
        (5, 1, 6),
        (-4, 1, 7),
        (7, 2, 4),
        (-5, 4, 5),
        (6, 2, 6),
        (8, 1, 8),
        (10, 3, 5),
        (9, 2, 9),
        (11, 4, 6),
        (12, 3, 8),
    ]
]
shown = [
    r"z = «weight*»x + \dot x.$",
    r"give $«weight*»x + \dot x = 0$",
    r"\ddot x + «friction*»\dot x + «stiffness*»x = 0",
]
p, q = sorted(-root for root in b_matrix.eigenvals())
a_observable = sp.Ne(weight * alpha - beta, weight**2)
b_unobservable = sp.Or(sp.Eq(h, p), sp.Eq(h, q))
b_unobservable_states = {p: [[1, -p]], q: [[1, -q]]}

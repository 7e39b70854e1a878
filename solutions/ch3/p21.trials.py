# %% wrong
# Does the last equation contain a derivative of u that was dropped? (hint 1)
system = [system[0], sp.Matrix([0, 0, weight]), *system[2:]]
# Is the new state variable the second derivative plus the control, or minus the control? (hint 1)
system = [system[0], sp.Matrix([0, -1, a2 + weight]), *system[2:]]
# The second derivative has a coefficient. What becomes of the control added to it? (hint 1)
system = [system[0], sp.Matrix([0, 1, weight]), *system[2:]]
# Can all three initial values of x be chosen in this form, or only two? (hint 2)
system = [
    system[0],
    sp.Matrix([0, 0, 1]),
    sp.Matrix([[weight, 1, 0]]),
    sp.Matrix([[weight**2, 2 * weight, 1]]),
]
# Which motions of the equation were lost when the common factor was cancelled? (hint 2)
system = [
    sp.Matrix([[0, 1], [-sp.Rational(a0, weight), weight - a2]]),
    sp.Matrix([0, 1]),
    sp.Matrix([[1, 0]]),
    sp.Matrix([[weight, 1]]),
]
# Is z formed with the numbers in the order of the derivatives?
system = [*system[:3], sp.Matrix([[1, weight, 0]])]
# Were the signs on the left-hand side kept when the terms changed sides?
system = [sp.Matrix([[0, 1, 0], [0, 0, 1], coefficients]), *system[1:]]
margins = sp.true  # Was a common factor cancelled? (hint 2)
# Is this the degree of stability without any feedback?
margins = mu <= -sp.real_roots(equation.left)[2]
# Look at the end of your interval: may all roots be as slow as that one?
margins = mu < weight
margins = sp.false  # One mode is fixed. Does it grow or decay?
# Which of the three roots is the fixed one? (hint 1)
margins = mu <= -sp.real_roots(equation.left)[1]
gains = [*system, -gains[4], gains[5]]  # What is the sign of $K$ in $u = Ke$? (hint 1)
gains = [*system, gains[4], -gains[5]]  # What is the sign of L in the observer? (hint 2)
# Is the loop faster than without a control? (hint 1)
gains = [*system, sp.zeros(1, 3), gains[5]]
gains = [*gains[:5], sp.zeros(3, 1)]  # How do the errors decay without a correction? (hint 2)
# Were these computed for an equation without a derivative of u?
prescribed = [weight**3, 3 * weight**2, 3 * weight]
gains = [*system, (sp.Matrix([coefficients]) - sp.Matrix([prescribed])) / weight, gains[5]]
# Does this form contain the derivative of u?
prescribed = [weight**3, 3 * weight**2, 3 * weight]
gains = [
    system[0],
    sp.Matrix([0, 0, weight]),
    *system[2:],
    (sp.Matrix([coefficients]) - sp.Matrix([prescribed])) / weight,
    gains[5],
]
# Was the feedback taken with a minus sign? (hint 1)
static_region = k > -sp.Rational(a0, weight**2)
# Is it enough that the sum of the roots is negative? (hint 1)
static_region = k < a2 - weight
# What is the root at the end of your interval?
static_region = k <= sp.Rational(a0, weight**2)
# What was substituted for the control, x or z? (hint 1)
static_region = k < sp.Rational(a0, weight)

# %% right
# the measurement and its rate as state variables: x, z, z' - u
system = [
    sp.Matrix([[-weight, 1, 0], [0, 0, 1], [0, -sp.Rational(a0, weight), weight - a2]]),
    *([0, 1, 2 * weight - a2], [1, 0, 0], [0, 1, 0]),
]
# the observable canonical form
system = [
    sp.Matrix([[-a2, 1, 0], [-a1, 0, 1], [-a0, 0, 0]]),
    sp.Matrix([0, 1, weight]),
    sp.Matrix([[1, 0, 0]]),
    sp.Matrix([[weight - a2, 1, 0]]),
]
# other units
system = [system[0], 10.0 * system[1], system[2] / 10.0, system[3] / 10.0]
margins = sp.And(mu > 0, mu - weight <= 0)  # in another form
# faster roots beside the fixed one
first = sp.Rational(a0, weight) - (weight + 1) * (weight + 2)
second = 2 * weight + 1 - a2
gains = [
    *system,
    sp.Matrix([[first, a2 - 3 * weight - 3, 0]]),
    sp.Matrix([1, second, weight * (weight + 1) - a1 - a2 * second]),
]
# for the state x, z, z' - u: a feedback by z alone
product, total = sp.Rational(a0, weight), a2 - weight
second = 2 * weight - total
gains = [
    sp.Matrix([[-weight, 1, 0], [0, 0, 1], [0, -product, -total]]),
    *([0, 1, weight - total], [1, 0, 0], [0, 1, 0]),
    [0, -2 * weight, 0],
    [0, second, weight**2 - product - total * second],
]
static_region = weight**2 * k < a0  # a multiple

# %% numbers
coefficients, weight = [
    ([p * q * r, p * q + p * r + q * r, p + q + r], r)
    for p, q, r in [
        *[(1, 2, 3), (1, 2, 4), (1, 3, 5), (1, 3, 8), (1, 2, 10), (1, 2, 6), (1, 2, 11), (1, 2, 9)],
        *[
            (1, 2, 13),
            (1, 2, 12),
            (1, 2, 16),
            (1, 4, 15),
            (1, 3, 14),
            (1, 2, 7),
        ],
    ]
]
misprint = (
    r"(The book prints $\ddot x + 6\dot x + 11x + 6x$ "
    "but calls this a third-order equation.)"
)
shown = [
    r"\dddot x + «coefficients[2]»\ddot x + «coefficients[1]»\dot x + «coefficients[0]»x "
    r"= \dot u + «weight»u, "
    r"\qquad z = «weight»x + \dot x",
    r"$\dot u + «weight»u$",
    "Which degree of stability is possible?«'\\n\\n' + misprint if weight == 3 else ''»",
]
product, total = sp.Rational(a0, weight), a2 - weight  # of the roots that are left
system = [
    sp.Matrix([[0, 1, 0], [0, 0, 1], [-a0, -a1, -a2]]),
    sp.Matrix([0, 1, -total]),
    sp.Matrix([[1, 0, 0]]),
    sp.Matrix([[weight, 1, 0]]),
]
K = sp.Matrix([[product - weight**2, total - 2 * weight, 0]])
L = sp.Matrix([1, weight - total, weight**2 - a1 - a2 * (weight - total)])
gains = [*system, K, L]
margins = mu <= weight
static_region = k < product / weight

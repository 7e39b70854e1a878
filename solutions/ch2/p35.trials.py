# %% wrong
# Do the pendulums hang down or stand? (hint 1)
equations = [sp.diag(l1, l2), g * sp.eye(2), sp.Matrix([-1, -1])]
# In which direction does the force of inertia act? (hint 1)
equations = [sp.diag(l1, l2), -g * sp.eye(2), sp.Matrix([1, 1])]
# Is the control a force on the cart, or its acceleration? (hint 1)
equations = [sp.diag(l1, l2), -g * sp.eye(2), sp.Matrix([-m1, -m2])]
# Does the cart accelerate the two pendulums in opposite directions? (hint 1)
equations = [sp.diag(l1, l2), -g * sp.eye(2), sp.Matrix([-1, 1])]
region = sp.true  # Is the whole system controllable whenever each part is? (hint 1)
region = l1 > l2  # Does it matter which of the two is longer? (hint 1)
region = sp.Eq(l1, l2)  # Is this the exceptional case instead of all others? (hint 1)
equal_uncontrollable_eigenvalues = []  # Is it enough that each pendulum alone can be controlled? (hint 1)
equal_uncontrollable_eigenvalues = [
    sp.sqrt(g / l)
]  # Is only the growing mode uncontrollable? (hint 1)
# Do the pendulums hang down or stand? (hint 1)
equal_uncontrollable_eigenvalues = [sp.I * sp.sqrt(g / l), -sp.I * sp.sqrt(g / l)]
equal_uncontrolled = [[1, -1, 0, 0]]  # Was the rate of the difference forgotten? (hint 1)
equal_uncontrolled = [[1, 1, 0, 0], [0, 0, 1, 1]]  # Does the cart act on this sum? (hint 1)
equal_uncontrolled = []  # Is everything controllable when both pendulums are equal? (hint 1)

# %% right
# multiplied by m l, as Lagrange's equations give them
equations = [
    sp.diag(m1 * l1**2, m2 * l2**2),
    -g * sp.diag(m1 * l1, m2 * l2),
    sp.Matrix([-m1 * l1, -m2 * l2]),
]
# solved for the accelerations
equations = [sp.eye(2), -g * sp.diag(1 / l1, 1 / l2), sp.Matrix([-1 / l1, -1 / l2])]
# sum and difference
equations = [sp.Matrix([[l1, l2], [l1, -l2]]), sp.Matrix([[-g, -g], [-g, g]]), sp.Matrix([-2, 0])]
region = sp.Or(l1 < l2, l1 > l2)  # either is longer
region = sp.Ne(l1 / l2, 1)  # by the ratio
equal_uncontrollable_eigenvalues = [
    sp.sqrt(g) / sp.sqrt(l),
    -sp.sqrt(g) / sp.sqrt(l),
]  # the root taken apart
# the decaying and the growing motion of the difference
equal_uncontrolled = [[1, -1, 1, -1], [1, -1, -1, 1]]

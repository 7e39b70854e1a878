# %% wrong
equations = [sp.diag(l1, l2), g*sp.eye(2), sp.Matrix([-1, -1])]  # pendulums that hang down
equations = [sp.diag(l1, l2), -g*sp.eye(2), sp.Matrix([1, 1])]  # the force of inertia with the sign of the acceleration
equations = [sp.diag(l1, l2), -g*sp.eye(2), sp.Matrix([-m1, -m2])]  # a force on the cart for its acceleration
equations = [sp.diag(l1, l2), -g*sp.eye(2), sp.Matrix([-1, 1])]  # the second pendulum pushed the other way
region = sp.true  # two controllable parts taken for a controllable whole
region = l1 > l2  # an order of the lengths asked for
region = sp.Eq(l1, l2)  # the exceptional case given
equal_lost = []  # each alone is controllable: taken for enough
equal_lost = [sp.sqrt(g/l)]  # only the growing mode
equal_lost = [sp.I*sp.sqrt(g/l), -sp.I*sp.sqrt(g/l)]  # the frequencies of pendulums that hang down
equal_uncontrolled = [[1, -1, 0, 0]]  # the difference of the angles without its rate
equal_uncontrolled = [[1, 1, 0, 0], [0, 0, 1, 1]]  # the sum, which the cart moves
equal_uncontrolled = []  # thought to be controllable

# %% right
# multiplied by m l, as Lagrange's equations give them
equations = [sp.diag(m1*l1**2, m2*l2**2), -g*sp.diag(m1*l1, m2*l2), sp.Matrix([-m1*l1, -m2*l2])]
equations = [sp.eye(2), -g*sp.diag(1/l1, 1/l2), sp.Matrix([-1/l1, -1/l2])]  # solved for the accelerations
equations = [sp.Matrix([[l1, l2], [l1, -l2]]), sp.Matrix([[-g, -g], [-g, g]]), sp.Matrix([-2, 0])]  # sum and difference
region = sp.Or(l1 < l2, l1 > l2)  # either is longer
region = sp.Ne(l1/l2, 1)  # by the ratio
equal_lost = [sp.sqrt(g)/sp.sqrt(l), -sp.sqrt(g)/sp.sqrt(l)]  # the root taken apart
equal_uncontrolled = [[1, -1, 1, -1], [1, -1, -1, 1]]  # the decaying and the growing motion of the difference

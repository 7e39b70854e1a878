# %% wrong
# the lower link's end without the motion of the upper one: two separate pendulums
equations = [sp.diag(l1, l2), -g*sp.eye(2), sp.Matrix([-1, -1])]
# the second angle counted from the first link
relative = sp.Matrix([[(m1 + m2)*l1 + m2*l2, m2*l2], [l1 + l2, l2]])
equations = [relative, sp.diag(-(m1 + m2)*g, -g), sp.Matrix([-(m1 + m2), -1])]
# the links hanging down
equations = [sp.Matrix([[(m1 + m2)*l1, m2*l2], [l1, l2]]), sp.diag((m1 + m2)*g, g), sp.Matrix([-(m1 + m2), -1])]
# the sign of the force of inertia
equations = [sp.Matrix([[(m1 + m2)*l1, m2*l2], [l1, l2]]), sp.diag(-(m1 + m2)*g, -g), sp.Matrix([m1 + m2, 1])]
# the control left out of the second equation before it is solved
equations = [sp.Matrix([[(m1 + m2)*l1, m2*l2], [l1, l2]]), sp.diag(-(m1 + m2)*g, -g), sp.Matrix([-(m1 + m2), 0])]
roots = [sp.sqrt(g/l1), -sp.sqrt(g/l1), sp.sqrt(g/l2), -sp.sqrt(g/l2)]  # those of two separate pendulums
roots = [value**2 for value in roots]  # the squares of the roots
roots = [sp.I*value for value in roots]  # the frequencies of a double pendulum that hangs down
controllable = False  # the control does not enter the second of the solved equations: taken for the end of the matter
side_by_side = sp.true  # thought to be as good as the double pendulum
side_by_side = sp.Eq(l1, l2)  # the exceptional case given

# %% right
equations = [masses, springs, push]  # not divided by anything
# solved for the accelerations
solved = sp.Matrix([[-(m1 + m2)*g/(m1*l1), m2*g/(m1*l1)], [(m1 + m2)*g/(m1*l2), -(m1 + m2)*g/(m1*l2)]])
equations = [sp.eye(2), solved, sp.Matrix([-1/l1, 0])]
# the squares multiplied out
roots = [sign*sp.sqrt(sp.expand(value**2)) for value, sign in zip(roots, (1, -1, 1, -1))]
side_by_side = sp.Or(l1 < l2, l1 > l2)  # either is longer

# %% wrong
rest = rest[:4]  # What if the first factor of the first equation vanishes? (hint 1)
rest = [rest[0], rest[3], rest[4]]  # Must the two coordinates be equal? (hint 2)
# Does the second equation vanish as well at each of your points? (hint 1)
rest = [*rest, (sp.pi / 2, 0)]
rest = [*rest, (-sp.pi / 2, -sp.pi / 2)]  # Where is the sine 1, and where is it $-1$? (hint 2)
rest = [rest[0], rest[4]]  # How often does the sine vanish in one full turn? (hint 2)
matrices = matrices[:4]  # Does the list cover every equilibrium? (hint 3)
# Which signs may the cosines have? (hint 2)
matrices = [sp.Matrix([[0, 1], [1, 0]]), sp.zeros(2, 2)]
# What are $1 - \sin y$ and $\cos y$ where the sine is 1? (hint 1)
matrices = [*matrices[:4], sp.eye(2)]
# In which row is the derivative of the first right-hand side? (hint 1)
matrices = [sp.diag(m[0, 1], m[1, 0]) for m in matrices[:4]] + [sp.zeros(2, 2)]
# What is the sign of the last coefficient of the polynomial? (hint 1)
region = sp.And(k1 > -1, k2 < 0)
# Is the control strong enough to overcome the free motion? (hint 1)
region = sp.And(k1 < 0, k2 < 0)
region = k1 < -1  # What does the coefficient of $\lambda$ require? (hint 1)
region = sp.And(k1 > 1, k2 > 0)  # What is the sign of the feedback in the statement?
# Does the polynomial have the same signs everywhere? (hint 1)
gains = [[place, [-2, -2]] for place in rest[:4]] + [[rest[4], []]]
gains = [*gains[:4], [rest[4], [-1, -1]]]  # Is a single eigenvalue below zero enough? (hint 2)
# What becomes of a small positive deviation of $y_1$? (hint 3)
gains = [*gains[:4], [rest[4], [0, -2]]]
# Do imaginary eigenvalues resist the control? (hint 1)
gains = [*gains[:2], [rest[2], []], *gains[3:]]
gains = gains[:4]  # Does the list have an entry for each of the equilibria? (hint 2)
# Is the feedback $K(y - y^*)$, or minus that?
gains = [[place, [-k for k in K]] for place, K in gains]
gains = [[(0, 0), [-2, 0]], *gains[1:]]  # Which term takes energy out of the motion? (hint 1)

# %% right
rest = [(0, 0), (0, 3.1416), (3.1416, 0), (3.1416, 3.1416), (1.571, 1.571)]  # decimals
# through inverse functions
rest = [[sp.acos(sp.cos(a)), sp.asin(1) * 2 * b / sp.pi] for a, b in rest]
# the partial derivatives, point by point
slopes = sp.Matrix(uncontrolled).jacobian(state)
matrices = [slopes.subs(dict(zip(state, place))) for place in rest]
# under names
matrices = {
    "a": matrices[0],
    "b": -matrices[0],
    "c": matrices[1],
    "d": -matrices[1],
    "fifth": 0 * matrices[0],
}
region = sp.And(-1 - k1 > 0, -k2 > 0)  # the coefficients of the polynomial
# other roots
gains = [
    [(0, 0), [-3, -1]],
    [(0, sp.pi), [1, -1]],
    [(sp.pi, 0), [-1, -3]],
    [(sp.pi, sp.pi), sp.Matrix([[5, -1]])],
    gains[4],
]
gains = gains[::-1]  # in another order

# %% wrong
rest = rest[:4]  # What if a factor of the form $1 - \cos y_i$ vanishes? (hint 2)
rest = [rest[0], rest[3], rest[4]]  # Must the two coordinates have the same sign?
# Are these the zeros of the sine, or of the cosine? (hint 1)
rest = [(0, 0), (0, sp.pi), (sp.pi, 0), (sp.pi, sp.pi)]
rest = [*rest, (sp.pi, sp.pi)]  # Is the cosine 1 or $-1$ there? (hint 2)
# What is the direction of the shift? (hint 1)
rest = [(y + sp.pi / 2, z + sp.pi / 2) for y, z in rest]
matrices = matrices[:4]  # Does your list contain a matrix for each equilibrium? (hint 2)
matrices = [sp.Matrix([[0, -1], [-1, 0]]), sp.zeros(2, 2)]  # Which signs may the sines have?
# In which row is the derivative of the first right-hand side?
matrices = [sp.diag(m[0, 1], m[1, 0]) for m in matrices[:4]] + [sp.zeros(2, 2)]
# What is the derivative of the cosine where the cosine is 1?
matrices = [*matrices[:4], sp.eye(2)]
# Is it the sum or the difference that is constant? (hint 3)
integral = sp.cot(y1 / 2) + sp.cot(y2 / 2) + y1 + y2
# What became of the second term of the fraction? (hint 2)
integral = sp.cot(y2 / 2) - sp.cot(y1 / 2)
# Were the factors in front of the cosines kept? (hint 1)
integral = sp.sin(y1) - sp.sin(y2)
integral = sp.Integer(1)  # Does this distinguish one motion from another?
# Are the signs the same everywhere? (hint 1)
gains = [[place, [-2, -2]] for place in rest[:4]] + [[rest[4], []]]
# What becomes of a small positive deviation of $y_1$? (hint 3)
gains = [*gains[:4], [rest[4], [-1, -1]]]
# Is it enough that one coordinate comes back? (hint 2)
gains = [*gains[:4], [rest[4], [0, -2]]]
# Do imaginary eigenvalues resist the control? (hint 1)
gains = [gains[0], [rest[1], []], *gains[2:]]
gains = gains[:4]  # What can be said about the omitted point? (hint 2)
# Is the feedback $K(y - y^*)$, or minus that?
gains = [[place, [-k for k in K]] for place, K in gains]
# Is an undamped oscillation asymptotically stable?
gains = [gains[0], [rest[1], [0, 0]], *gains[2:]]

# %% right
rest = [(1.571, 1.571), (1.571, -1.571), (-1.571, 1.571), (-1.571, -1.571), (0, 0)]  # decimals
# the partial derivatives, point by point
slopes = sp.Matrix(uncontrolled).jacobian(state)
matrices = [slopes.subs(dict(zip(state, place))) for place in rest]
integral = 3 * (sp.cot(y1 / 2) + y1) - 3 * (sp.cot(y2 / 2) + y2)  # a multiple, with cotangents
# the difference of the cotangents as a quotient
integral = sp.sin((y2 - y1) / 2) / (sp.sin(y1 / 2) * sp.sin(y2 / 2)) + y1 - y2
integral = (y2 - y1 + 1 / sp.tan(y2 / 2) - 1 / sp.tan(y1 / 2)) ** 3  # a function of it
# other roots
gains = [
    [(sp.pi / 2, sp.pi / 2), [5, -1]],
    [(sp.pi / 2, -sp.pi / 2), [-1, -3]],
    [(-sp.pi / 2, sp.pi / 2), [0, -1]],
    [(-sp.pi / 2, -sp.pi / 2), sp.Matrix([[-3, -1]])],
    gains[4],
]
gains = gains[::-1]  # in another order

# %% wrong
a_rest = [0, sp.pi]  # Are these all equilibria, or only those within one turn? (hint 2)
a_rest = [2 * sp.pi * n]  # Can a pendulum be at rest in one kind of position only? (hint 2)
# Does the sine vanish at all of these values, or were zeros of the cosine included? (hint 2)
a_rest = [sp.pi * n / 2]
# Is the deviation equation the same at every equilibrium? (hint 1)
a_matrices = [sp.Matrix([[0, 1], [-(omega**2), -delta]])]
# Is there no restoring or driving force when the pendulum stands upright? Differentiate first, then
# substitute the position. (hint 1)
a_matrices = [sp.Matrix([[0, 1], [-(omega**2), -delta]]), sp.Matrix([[0, 1], [0, -delta]])]
a_stable = [sp.pi * n]  # Does friction make every equilibrium stable? (hint 2)
a_stable = [2 * sp.pi * n + sp.pi]  # Were hanging and standing swapped here? (hint 2)
a_unstable = [sp.pi]  # Are these all such positions, or only the one within a single turn?
a_growth = omega  # Is this the result without friction? (hint 1)
# Which of the two roots makes a deviation grow? (hint 1)
a_growth = (-delta - sp.sqrt(delta**2 + 4 * omega**2)) / 2
# Does friction enter the characteristic equation with this sign? (hint 1)
a_growth = (delta + sp.sqrt(delta**2 + 4 * omega**2)) / 2
# Do the terms with the product $x_1 x_2$ really remain after both rates are substituted? (hint 1)
b_rate = omega**2 * x1 * x2 - delta * x2**2
# Is the derivative of V negative definite? Find a state other than zero where it vanishes. (hint 1)
b_null = sp.And(sp.Eq(x1, 0), sp.Eq(x2, 0))
# Is this the velocity of the motion there, and not its acceleration? (hint 1)
b_leave = sp.Integer(0)
b_leave = omega**2 * x1  # In which direction does the restoring force pull? (hint 1)
b_stable = delta >= 0  # Does a constant energy prove that motions come to rest? (hint 1)
b_stable = delta < 0  # Was the minus sign of the derivative of V overlooked? (hint 1)

# %% right
a_rest = sp.pi * n  # all positions in one expression
a_rest = sp.solveset(sp.sin(x1), x1, sp.S.Reals)  # the set that solveset gives
a_rest = [(3.142 * n, 0)]  # points of the phase plane, decimals
# one matrix with the integer, nested lists
a_matrices = [
    [0, 1],
    [-((-1) ** n) * omega**2, -delta],
]
# the other order, plain symbols
w, d = sp.symbols("omega delta")
a_matrices = [sp.Matrix([[0, 1], [w**2, -d]]), sp.Matrix([[0, 1], [-(w**2), -d]])]
a_stable = 2 * n * sp.pi  # one expression without a list
a_stable = sp.ImageSet(sp.Lambda(n, 2 * n * sp.pi), sp.S.Integers)  # as a set
a_unstable = [-(2 * n + 1) * sp.pi]  # counted downwards
a_unstable = [(2 * sp.pi * n - sp.pi, 0)]  # as points
a_growth = 2 * omega**2 / (delta + sp.sqrt(delta**2 + 4 * omega**2))  # the root in the denominator
# as sp.solve writes it, with a plain symbol
d = sp.Symbol("delta")
a_growth = -d / 2 + sp.sqrt(d**2 / 4 + omega**2)
b_null = sp.Eq(x2**2, 0)  # with the square
b_leave = -delta * x2 - omega**2 * x1  # with the friction, which vanishes there
b_stable = -sp.Symbol("delta") < 0  # the sign of the derivative, with a plain symbol

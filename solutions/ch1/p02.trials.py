# %% wrong
a_rest = [0, sp.pi]  # only the positions within one turn
a_rest = [2*sp.pi*n]  # the standing pendulum overlooked
a_rest = [sp.pi*n/2]  # zeros of the cosine taken along
a_matrices = [sp.Matrix([[0, 1], [-omega**2, -delta]])]  # the equation at x* = 0 used everywhere
# sin x* differentiated as a constant: no restoring force upright
a_matrices = [sp.Matrix([[0, 1], [-omega**2, -delta]]), sp.Matrix([[0, 1], [0, -delta]])]
a_stable = [sp.pi*n]  # every position of rest counted as stable, since friction is there
a_stable = [2*sp.pi*n + sp.pi]  # hanging and standing interchanged
a_unstable = [sp.pi]  # one turn only
a_growth = omega  # friction forgotten
a_growth = (-delta - sp.sqrt(delta**2 + 4*omega**2))/2  # the negative root of the two
a_growth = (delta + sp.sqrt(delta**2 + 4*omega**2))/2  # the sign of the friction turned
b_rate = omega**2*x1*x2 - delta*x2**2  # the terms that cancel left in
b_null = sp.And(sp.Eq(x1, 0), sp.Eq(x2, 0))  # V' taken for negative definite
b_leave = sp.Integer(0)  # the velocity taken for the acceleration: as if the motion stayed
b_leave = omega**2*x1  # the sign of the restoring force turned
b_stable = delta >= 0  # constant energy taken for a proof of asymptotic stability
b_stable = delta < 0  # the derivative read without its minus

# %% right
a_rest = sp.pi*n  # all positions in one expression
a_rest = sp.solveset(sp.sin(x1), x1, sp.S.Reals)  # the set that solveset gives
a_rest = [(3.142*n, 0)]  # points of the phase plane, decimals
a_matrices = [[0, 1], [-(-1)**n*omega**2, -delta]]  # one matrix with the integer, nested lists
# the other order, plain symbols
w, d = sp.symbols("omega delta")
a_matrices = [sp.Matrix([[0, 1], [w**2, -d]]), sp.Matrix([[0, 1], [-w**2, -d]])]
a_stable = 2*n*sp.pi  # one expression without a list
a_stable = sp.ImageSet(sp.Lambda(n, 2*n*sp.pi), sp.S.Integers)  # as a set
a_unstable = [-(2*n + 1)*sp.pi]  # counted downwards
a_unstable = [(2*sp.pi*n - sp.pi, 0)]  # as points
a_growth = 2*omega**2/(delta + sp.sqrt(delta**2 + 4*omega**2))  # the root in the denominator
# as sp.solve writes it, with a plain symbol
d = sp.Symbol("delta")
a_growth = -d/2 + sp.sqrt(d**2/4 + omega**2)
b_null = sp.Eq(x2**2, 0)  # with the square
b_leave = -delta*x2 - omega**2*x1  # with the friction, which vanishes there
b_stable = -sp.Symbol("delta") < 0  # the sign of the derivative, with a plain symbol

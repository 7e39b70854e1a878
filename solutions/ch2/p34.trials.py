# %% wrong
# Are two controls always enough? Look for a combination that neither enters. (hint 1)
uncontrolled = []
uncontrolled = [[0, 1, 1, 0]]  # Do the controls enter this sum? (hint 1)
# Is a variable uncontrollable because its equation contains no control?
uncontrolled = [[0, 1, -1, 0], [1, 0, 0, 0]]
# Is this uncontrollable by both controls together? By one alone more may be uncontrollable. (hint
# 1)
missed_by_u2 = [[0, 1, -1, 0]]
# Is a variable uncontrollable although controlled variables act on it? (hint 2)
missed_by_u2 = [[0, 1, -1, 0], [1, 0, 0, 0]]
missed_by_u2 = [[0, 1, 1, -1]]  # Was the combination uncontrollable by both forgotten? (hint 2)
sequential = sp.eye(4)  # Can the coordinates be left as they are? (hint 1)
# Which columns must come first? (hint 1)
sequential = sp.Matrix.hstack(sp.Matrix([0, 1, 0, 0]), b1, A * b1, A**2 * b1)
# Was the chain continued beyond its end? (hint 1)
sequential = sp.Matrix.hstack(b1, A * b1, A**2 * b1, A**3 * b1)
# Is this the decomposition in the other order? (hint 1)
reversed_order = sp.Matrix.hstack(b1, A * b1, A**2 * b1, sp.Matrix([0, 1, 0, 0]))
# Which part must come first? (hint 1)
reversed_order = sp.Matrix.hstack(b1, b2, A * b2, sp.Matrix([0, 1, 0, 0]))
# Is this the sequential decomposition? (hint 1)
parallel = sp.Matrix.hstack(b1, A * b1, A**2 * b1, sp.Matrix([0, 1, 0, 0]))
# Are the columns sorted part by part? (hint 1)
parallel = sp.Matrix.hstack(b1, b2, A * b1, sp.Matrix([0, 1, 0, 0]))
# Was a column kept that depends on the previous ones? (hint 2)
parallel = sp.Matrix.hstack(b1, A * b1, b2, A * b2)
parallel_system = [A, u1_first]  # Are these the given equations? (hint 1)
# Was the coupling between the parts left out? (hint 1)
parallel_system = [
    sp.diag(parallel_system[0][:2, :2], parallel_system[0][2:, 2:]),
    parallel_system[1],
]
# Are these the equations of the sequential decomposition? (hint 2)
parallel_system = [sequential.inv() * A * sequential, sequential.inv() * u1_first]
# Was $P$ used in place of its inverse? (hint 1)
parallel_system = [parallel * A * parallel.inv(), parallel * u1_first]

# %% right
uncontrolled = [[0, -3, 3, 0]]  # another length and sign
missed_by_u2 = [[0, 2, 0, -1], [0, 0, 2, -1]]  # sum and difference of the two rows
# columns of the parallel one: they span the same
sequential = sp.Matrix.hstack(b1, A * b1, b2, sp.Matrix([0, 1, 0, 0]))
# x1, x2 + x3, x4 and the difference
sequential = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 1], [0, 1, 0, -1], [0, 0, 1, 0]])
# other columns of the same parts
reversed_order = sp.Matrix.hstack(A * b2 - b2, 2 * b2, b1, sp.Matrix([0, 1, -1, 0]))
# each chain up to columns with lower powers
parallel = sp.Matrix.hstack(2 * b1, A * b1 - b2, b2, sp.Matrix([1, 0, 5, 0]))
# with the difference of two axes as the last column
P = sp.Matrix.hstack(b1, A * b1, b2, sp.Matrix([0, 1, -1, 0]))
parallel_system = [P.inv() * A * P, P.inv() * u1_first]

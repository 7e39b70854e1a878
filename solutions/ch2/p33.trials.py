# %% wrong
# Is a variable uncontrollable because its equation lacks the control? (hint 1)
missed_by_u1 = [[0, 1, 0, 0], [0, 0, 1, 0]]
missed_by_u1 = [[0, 0, 0, 1]]  # Is this uncontrollable by the other control? (hint 1)
# Is a variable uncontrollable because its equation lacks the control? (hint 1)
missed_by_u2 = [[1, 0, 0, 0], [0, 0, 0, 1]]
missed_by_u2 = []  # Is the system controllable by each control because it is by both? (hint 1)
# Does the second control enter the part of the first one here? (hint 1)
sequential = sp.eye(4)[:, [0, 2, 3, 1]]
sequential = sp.Matrix.hstack(b2, b1, A * b1, A**2 * b1)  # Which part must come first? (hint 1)
# Is this the parallel decomposition? (hint 1)
sequential = sp.Matrix.hstack(b1, A * b1, b2, A * b2)
# Was the chain continued beyond its end? (hint 1)
sequential = sp.Matrix.hstack(b1, A * b1, A**2 * b1, A**3 * b1)
# Is this the decomposition in the other order? (hint 1)
reversed_order = sp.Matrix.hstack(b1, A * b1, A**2 * b1, b2)
# Which part must come first? (hint 1)
reversed_order = sp.Matrix.hstack(b1, b2, A * b2, A**2 * b2)
reversed_order = sp.eye(4)  # Does one control enter the part of the other one here? (hint 1)
# Is this the sequential decomposition? (hint 1)
parallel = sp.Matrix.hstack(b1, A * b1, A**2 * b1, b2)
parallel = sp.Matrix.hstack(b1, b2, A * b1, A * b2)  # Are the columns sorted part by part? (hint 2)
parallel = sp.Matrix.hstack(b2, A * b2, b1, A * b1)  # Which part must come first? (hint 2)
parallel_system = [A, u1_first]  # Are these the given equations? (hint 1)
# Was the coupling between the parts left out? (hint 2)
parallel_system = [
    sp.diag(parallel_system[0][:2, :2], parallel_system[0][2:, 2:]),
    parallel_system[1],
]
# Are these the equations of the sequential decomposition? (hint 2)
parallel_system = [sequential.inv() * A * sequential, sequential.inv() * u1_first]
# Was $P$ used in place of its inverse? (hint 1)
parallel_system = [parallel * A * parallel.inv(), parallel * u1_first]

# %% right
missed_by_u1 = [[0, -4, 0, 0]]  # another length and sign
missed_by_u2 = [[0, 0, 0, 9]]  # another length
sequential = sp.Matrix.hstack(b1, A * b1, A**2 * b1, b2)  # the chains of the textbook
# another basis of the part of u1
sequential = sp.Matrix.hstack(A * b1 - b1, A**2 * b1, 2 * b1, 5 * b2)
reversed_order = sp.Matrix.hstack(b2, A * b2, A**2 * b2, b1)  # the chains of the textbook
# each chain up to columns with lower powers of A
parallel = sp.Matrix.hstack(b1, A * b1 + b2, b2, A * b2 - b1)
# in coordinates of other lengths
P = parallel * sp.diag(2, 3, 5, 7)
parallel_system = [P.inv() * A * P, P.inv() * u1_first]
# each chain up to columns with lower powers of A
P = sp.Matrix.hstack(b1, A * b1 + b2, b2, A * b2 - b1)
parallel_system = [P.inv() * A * P, P.inv() * u1_first]

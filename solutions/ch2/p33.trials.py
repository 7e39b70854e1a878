# %% wrong
missed_by_u1 = [[0, 1, 0, 0], [0, 0, 1, 0]]  # both variables without u1 in their equations, though x4 acts on x3
missed_by_u1 = [[0, 0, 0, 1]]  # what the other control misses
missed_by_u2 = [[1, 0, 0, 0], [0, 0, 0, 1]]  # both variables without u2 in their equations, though x2 acts on x1
missed_by_u2 = []  # together they miss nothing: taken for each alone
sequential = sp.eye(4)[:, [0, 2, 3, 1]]  # u2 then enters the part of u1 as well
sequential = sp.Matrix.hstack(b2, b1, A*b1, A**2*b1)  # the parts in the opposite order
sequential = sp.Matrix.hstack(b1, A*b1, b2, A*b2)  # the parallel decomposition
sequential = sp.Matrix.hstack(b1, A*b1, A**2*b1, A**3*b1)  # the chain of u1 continued beyond its end: no inverse
reversed_order = sp.Matrix.hstack(b1, A*b1, A**2*b1, b2)  # the first order once more
reversed_order = sp.Matrix.hstack(b1, b2, A*b2, A**2*b2)  # the part of u1 first
reversed_order = sp.eye(4)  # u1 then enters the part of u2 as well
parallel = sp.Matrix.hstack(b1, A*b1, A**2*b1, b2)  # the sequential decomposition
parallel = sp.Matrix.hstack(b1, b2, A*b1, A*b2)  # the columns as they are taken, not part by part
parallel = sp.Matrix.hstack(b2, A*b2, b1, A*b1)  # the part of u2 first

# %% right
missed_by_u1 = [[0, -4, 0, 0]]  # another length and sign
missed_by_u2 = [[0, 0, 0, 9]]  # another length
sequential = sp.Matrix.hstack(b1, A*b1, A**2*b1, b2)  # the chains of the textbook
sequential = sp.Matrix.hstack(A*b1 - b1, A**2*b1, 2*b1, 5*b2)  # another basis of the part of u1
reversed_order = sp.Matrix.hstack(b2, A*b2, A**2*b2, b1)  # the chains of the textbook
parallel = sp.Matrix.hstack(b1, A*b1 + b2, b2, A*b2 - b1)  # each chain up to columns with lower powers of A

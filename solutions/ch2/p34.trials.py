# %% wrong
uncontrolled = []  # two controls for four coordinates, taken for enough
uncontrolled = [[0, 1, 1, 0]]  # the sum, into which the controls enter
uncontrolled = [[0, 1, -1, 0], [1, 0, 0, 0]]  # x1 counted too, since no control stands in its equation
missed_by_u2 = [[0, 1, -1, 0]]  # what both controls miss, though u2 alone misses more
missed_by_u2 = [[0, 1, -1, 0], [1, 0, 0, 0]]  # x1 counted, though x2 and x3 act on it
missed_by_u2 = [[0, 1, 1, -1]]  # what both controls miss forgotten
sequential = sp.eye(4)  # the coordinates as they are
sequential = sp.Matrix.hstack(sp.Matrix([0, 1, 0, 0]), b1, A*b1, A**2*b1)  # what is left over put first
sequential = sp.Matrix.hstack(b1, A*b1, A**2*b1, A**3*b1)  # the chain continued beyond its end: no inverse
reversed_order = sp.Matrix.hstack(b1, A*b1, A**2*b1, sp.Matrix([0, 1, 0, 0]))  # the first order once more
reversed_order = sp.Matrix.hstack(b1, b2, A*b2, sp.Matrix([0, 1, 0, 0]))  # the part of u1 first
parallel = sp.Matrix.hstack(b1, A*b1, A**2*b1, sp.Matrix([0, 1, 0, 0]))  # the sequential one
parallel = sp.Matrix.hstack(b1, b2, A*b1, sp.Matrix([0, 1, 0, 0]))  # the columns as they are taken, not part by part
parallel = sp.Matrix.hstack(b1, A*b1, b2, A*b2)  # the column A b2 not left out: no inverse

# %% right
uncontrolled = [[0, -3, 3, 0]]  # another length and sign
missed_by_u2 = [[0, 2, 0, -1], [0, 0, 2, -1]]  # sum and difference of the two rows
sequential = sp.Matrix.hstack(b1, A*b1, b2, sp.Matrix([0, 1, 0, 0]))  # columns of the parallel one: they span the same
sequential = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 1], [0, 1, 0, -1], [0, 0, 1, 0]])  # x1, x2 + x3, x4 and the difference
reversed_order = sp.Matrix.hstack(A*b2 - b2, 2*b2, b1, sp.Matrix([0, 1, -1, 0]))  # other columns of the same parts
parallel = sp.Matrix.hstack(2*b1, A*b1 - b2, b2, sp.Matrix([1, 0, 5, 0]))  # each chain up to columns with lower powers

# %% wrong
region = sp.And(sp.Ne(l1, l2), sp.Ne(l1, 0), sp.Ne(l2, 0))  # an eigenvalue zero thought to hide its mode
region = sp.And(l1 < 0, l2 < 0)  # observability confused with stability
region = sp.Ne(l1**2, l2**2)  # the squares compared
unseen = [[1, 1]]  # the direction that is seen best
unseen = [[1, 0], [0, 1]]  # both modes taken for unseen because they look alike
split = sp.Matrix([[1, -1], [1, 1]])  # the unseen coordinate first
split = sp.eye(2)  # nothing changed: x1 is not observable by itself
split = sp.Matrix([[1, 1], [2, 2]])  # the second row is twice the first: no coordinates
split_system = [sp.diag(l, l), sp.Matrix([[1, 1]])]  # the output left as it was
split_system = [sp.diag(l, 0), sp.Matrix([[1, 0]])]  # the unseen coordinate thought not to change

# %% right
# the determinant, with plain symbols
p, q = sp.symbols("l1 l2")
region = sp.Ne(q - p, 0)
region = sp.Or(l1 < l2, l1 > l2)  # two open half-planes
unseen = [(-3, 3)]  # another length and sign, a tuple
unseen = sp.Matrix([1, -1])/2  # a column
split = [[1, 1], [0, 1]]  # x2 as the second coordinate
split = sp.Matrix([[sp.Rational(1, 2), sp.Rational(1, 2)], [1, -5]])  # the half sum and a slanted second coordinate
split_system = [sp.diag(l, l), sp.Matrix([[2, 0]])]  # for the half sum as the observable coordinate

# %% wrong
a_equilibria = [[1, 1]]  # the negative root of y2**2 = 1 forgotten
a_equilibria = [[1, 1], [1, -1], [-1, 1], [-1, -1]]  # signs combined freely, though the second equation ties y1 to y2
# the logarithm taken to vanish where its argument does
a_equilibria = [[sp.sqrt(2), sp.sqrt(2)], [-sp.sqrt(2), -sp.sqrt(2)]]
# the matrix of the point (1, 1) used at both points
a_spectra = [[*point, *sp.Matrix([[0, -2], [sp.E, -sp.E]]).eigenvals()] for point in ([1, 1], [-1, -1])]
# the inner derivative -2 y2 of the logarithm forgotten
a_spectra = [[c, c, *sp.Matrix([[0, 1], [sp.exp(c), -sp.exp(c)]]).eigenvals()] for c in (1, -1)]
a_stable = [[1, 1], [-1, -1]]  # a negative trace taken for sufficient
a_stable = [[-1, -1]]  # the two points confused
b_equilibria = [[2, 3], [-1, 0]]  # the coordinates given in the order y, x
b_equilibria = [[y_root - 1, y_root] for y_root in (0, 1)]  # a sign lost in x = y + 1
# the derivative of y**2 - x by x taken with the wrong sign
b_spectra = [[3, 2, sp.sqrt(5), -sp.sqrt(5)], [0, -1, sp.I, -sp.I]]
b_spectra = [[3, 2, 1, -3], [0, -1, -1 + sp.sqrt(2), -1 - sp.sqrt(2)]]  # the imaginary unit lost under the root
b_stable = [[3, 2], [0, -1]]  # one negative eigenvalue taken for sufficient
b_stable = []  # complex eigenvalues taken for instability
c_equilibria = [[0, 0], [1, 1]]  # ln 3 overlooked: the argument set to 1
c_equilibria = [[-2, 4], [1, 1]]  # signs of the roots of the quadratic turned
c_spectra = [[2, 4, -1, -3], [-1, 1, 3, -1]]  # the logarithm differentiated without division by its argument
c_spectra = [[2, 4, -2 + sp.sqrt(3), -2 - sp.sqrt(3)]]  # the saddle left out because it is unstable anyway
c_stable = [[2, 4], [-1, 1]]  # eigenvalues of opposite signs taken for stability

# %% right
a_equilibria = [{y2: -1, y1: -1}, {y1: 1, y2: 1}]  # as dicts, the way solve gives them
# decimals to three digits, the points in the other order
a_spectra = [[-1, -1, -1.06, 0.693], [1, 1, -1.36 - 1.89j, -1.36 + 1.89j]]
# exact, by the formula for a quadratic, not simplified
a_spectra = [[c, c, *((-sp.exp(c) + sign*sp.sqrt(sp.exp(2*c) - 8*c*sp.exp(c)))/2 for sign in (1, -1))] for c in (1, -1)]
a_stable = [1.0, 1.0]  # the point alone, as decimals
b_equilibria = sp.Matrix([[3, 2], [0, -1]])  # a matrix with a row for each point
# the roots of (lambda + 1)**2 = 2 y, not simplified
b_spectra = [[p, q, -1 + sp.sqrt(2*q), -1 - sp.sqrt(2*q)] for p, q in ((0, -1), (3, 2))]
# pairs of a point and its eigenvalues, with decimals
b_spectra = [[(3, 2), (1.0, -3.0)], [(0, -1), (-1 + 1.41j, -1 - 1.41j)]]
b_stable = [{x: 0, y: -1}]  # as a dict
c_equilibria = [(2.0, 4.0), (-1.0, 1.0)]  # tuples of floats
# a matrix, with the roots written as quotients
c_spectra = sp.Matrix([[-1, 1, (2 + sp.sqrt(8))/2, (2 - sp.sqrt(8))/2],
                       [2, 4, (-4 + sp.sqrt(12))/2, (-4 - sp.sqrt(12))/2]])
c_spectra = [[2, 4, -0.268, -3.73], [-1, 1, 2.41, -0.414]]  # decimals to three digits
c_stable = [[2, 4], [2.0, 4.0]]  # twice the same point

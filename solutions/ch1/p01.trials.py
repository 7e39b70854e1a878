# %% wrong
a_equilibria = [[1, 1]]  # Has the quadratic equation for $y_2$ only one root? (hint 2)
# May the signs of the two coordinates be chosen freely, or does the second equation tie one to the
# other? (hint 1)
a_equilibria = [[1, 1], [1, -1], [-1, 1], [-1, -1]]
# Is a logarithm zero where its argument is zero? (hint 2)
a_equilibria = [[sp.sqrt(2), sp.sqrt(2)], [-sp.sqrt(2), -sp.sqrt(2)]]
# Was the matrix of one point used at the other one too? (hint 1)
a_spectra = [
    [*point, *sp.Matrix([[0, -2], [sp.E, -sp.E]]).eigenvals()] for point in ([1, 1], [-1, -1])
]
# Was the argument of the logarithm differentiated as well? (hint 1)
a_spectra = [[c, c, *sp.Matrix([[0, 1], [sp.exp(c), -sp.exp(c)]]).eigenvals()] for c in (1, -1)]
# Is a negative trace enough? What is the sign of the determinant at each point? (hint 1)
a_stable = [[1, 1], [-1, -1]]
# Have the two points changed places? Compare trace and determinant at each of them. (hint 1)
a_stable = [[-1, -1]]
b_equilibria = [[2, 3], [-1, 0]]  # In which order are the coordinates asked for? (hint 2)
# Was a sign lost when one unknown was expressed by the other? Put the points into the linear
# equation. (hint 1)
b_equilibria = [[y_root - 1, y_root] for y_root in (0, 1)]
# Which sign has the derivative of the denominator $y^2 - x$ by $x$? (hint 1)
b_spectra = [[3, 2, sp.sqrt(5), -sp.sqrt(5)], [0, -1, sp.I, -sp.I]]
# Did the imaginary unit get lost under a root? Look at the discriminant once more. (hint 1)
b_spectra = [[3, 2, 1, -3], [0, -1, -1 + sp.sqrt(2), -1 - sp.sqrt(2)]]
b_stable = [[3, 2], [0, -1]]  # Is one negative eigenvalue enough? (hint 1)
# Are complex eigenvalues a sign of instability, or does their real part decide? (hint 1)
b_stable = []
# Is the argument of the logarithm set to 1 here? The other side is not zero. (hint 2)
c_equilibria = [[0, 0], [1, 1]]
# Did the roots of the quadratic get their signs turned? Test them in the equation. (hint 1)
c_equilibria = [[-2, 4], [1, 1]]
# Was the logarithm differentiated without dividing by its argument? (hint 1)
c_spectra = [[2, 4, -1, -3], [-1, 1, 3, -1]]
# Are the eigenvalues of an unstable point asked for as well?
c_spectra = [[2, 4, -2 + sp.sqrt(3), -2 - sp.sqrt(3)]]
c_stable = [[2, 4], [-1, 1]]  # Can eigenvalues of opposite signs mean stability? (hint 1)

# %% right
a_equilibria = [{y2: -1, y1: -1}, {y1: 1, y2: 1}]  # as dicts, the way solve gives them
# decimals to three digits, the points in the other order
a_spectra = [[-1, -1, -1.06, 0.693], [1, 1, -1.36 - 1.89j, -1.36 + 1.89j]]
# exact, by the formula for a quadratic, not simplified
a_spectra = [
    [
        c,
        c,
        *((-sp.exp(c) + sign * sp.sqrt(sp.exp(2 * c) - 8 * c * sp.exp(c))) / 2 for sign in (1, -1)),
    ]
    for c in (1, -1)
]
a_stable = [1.0, 1.0]  # the point alone, as decimals
b_equilibria = sp.Matrix([[3, 2], [0, -1]])  # a matrix with a row for each point
# the roots of (lambda + 1)**2 = 2 y, not simplified
b_spectra = [[p, q, -1 + sp.sqrt(2 * q), -1 - sp.sqrt(2 * q)] for p, q in ((0, -1), (3, 2))]
# pairs of a point and its eigenvalues, with decimals
b_spectra = [[(3, 2), (1.0, -3.0)], [(0, -1), (-1 + 1.41j, -1 - 1.41j)]]
b_stable = [{x: 0, y: -1}]  # as a dict
c_equilibria = [(2.0, 4.0), (-1.0, 1.0)]  # tuples of floats
# a matrix, with the roots written as quotients
c_spectra = sp.Matrix(
    [
        [-1, 1, (2 + sp.sqrt(8)) / 2, (2 - sp.sqrt(8)) / 2],
        [2, 4, (-4 + sp.sqrt(12)) / 2, (-4 - sp.sqrt(12)) / 2],
    ]
)
c_spectra = [[2, 4, -0.268, -3.73], [-1, 1, 2.41, -0.414]]  # decimals to three digits
c_stable = [[2, 4], [2.0, 4.0]]  # twice the same point

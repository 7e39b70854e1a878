# %% wrong
# Are $x_1$ and $x_2$ uncorrelated? (hint 2)
covariance = sum(a * b * v for a, b, v in zip(first, second, variances))
# How many products of $x_1$ and $x_2$ are there, and with which signs? (hint 2)
covariance = covariance - first[1] * second[0] * joint
# What is the sign of $x_3$ in the second sum? (hint 2)
covariance = covariance - 2 * first[2] * second[2] * variances[2]
# Is the variance of a sum of $x_1$ and $x_2$ determined by their variances alone? (hint 2)
products = sp.diag(first[0] * first[1], second[0] * second[1])
matrix = matrix - 2 * joint * products
matrix = matrix - 2 * sp.Matrix(
    [[0, covariance], [covariance, 0]]
)  # Was a minus in the rows lost? (hint 1)
matrix = sp.diag(matrix[0, 0], matrix[1, 1])  # Are the two sums uncorrelated? (hint 1)

# %% right
# squares and mixed products apart
squares = sum(a * b * v for a, b, v in zip(first, second, variances))
covariance = squares + (first[0] * second[1] + first[1] * second[0]) * joint

# %% numbers
half = sp.Rational(1, 2)
variances, joint, first, second = [
    ([1, 4, 1], half, [1, 1, 1], [1, -2, -1]),
    ([2, 3, 1], half, [1, 2, 1], [2, -1, -1]),
    ([1, 2, 2], half, [2, 1, 1], [1, -4, -1]),
    ([3, 1, 1], -half, [1, 1, 2], [1, -2, -1]),
    ([1, 5, 2], 3 * half, [1, -1, 1], [1, 2, -1]),
    ([2, 2, 1], half, [1, 3, 1], [3, -1, -2]),
    ([4, 1, 1], 3 * half, [1, 1, 1], [2, -1, -3]),
    ([2, 1, 3], -half, [2, 1, 1], [1, -1, -1]),
    ([1, 3, 1], half, [1, 2, 3], [1, -1, -1]),
    ([5, 1, 2], half, [1, 1, 1], [1, -3, -2]),
    ([2, 1, 1], half, [1, 1, 1], [3, -2, -2]),
    ([1, 1, 2], -half, [3, 1, 1], [1, -2, -1]),
    ([2, 3, 2], 3 * half, [2, 1, 1], [1, -1, -3]),
    ([1, 4, 3], -half, [1, 2, 1], [2, -1, -1]),
]


def fraction(number):
    """A number in the notation of the page."""
    return f"{number.p}/{number.q}"


shown = [
    r"\begin{pmatrix} «variances[0]» & «fraction(joint)» & 0\\ "
    r"«fraction(joint)» & «variances[1]» & 0\\ 0 & 0 & «variances[2]»\end{pmatrix}",
    r"y_1 &= «first[0]*»x_1 «+first[1]*»x_2 «+first[2]*»x_3,",
    r"y_2 &= «second[0]*»x_1 «+second[1]*»x_2 «+second[2]*»x_3 .",
]
B = sp.Matrix([y1, y2]).jacobian(x)
matrix = B * K_x * B.T
covariance = matrix[0, 1]

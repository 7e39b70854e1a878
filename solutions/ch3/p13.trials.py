# %% wrong
uncontrollable_rows = {}  # The control enters both equations. What of their difference? (hint 1)
uncontrollable_rows = {1: [[1, 1]]}  # Does the control not enter the sum? (hint 1)
# Was a sign of the parameter lost? Write the derivative of the difference down once more. (hint 2)
uncontrollable_rows = {-1: [[1, -1]]}
# Does the control act on the second coordinate only through the coupling? (hint 1)
uncontrollable_rows = {0: [[0, 1]]}
# It is controllable in general. What happens at the exceptional value? (hint 1)
margins = sp.true
margins = epsilon < 1  # Is there no gain on the other side? (hint 2)
# Does the fixed mode decay? How does the difference of the coordinates behave? (hint 1)
margins = sp.Or(sp.Ne(epsilon, 1), mu <= 1)
# Does a constant gain stabilise for large values of the parameter, too? (hint 1)
gain = sp.Matrix([[-3, 2]])
# Does a constant gain stabilise for small values of the parameter, too? (hint 1)
gain = sp.Matrix([[-1, 0]])
gain = sp.Matrix([[3 - epsilon, epsilon - 2]])  # What is the sign of the feedback in the statement?
gain = []  # Is the pair not controllable elsewhere?
# What is the sign of the last coefficient with this gain? (hint 1)
gain = sp.Matrix([[-2 - epsilon, epsilon]])
# What is the sign of the feedback in the statement?
prescribed = sp.Matrix([[gamma1 + 1 + gamma2 / (1 - epsilon), -1 - gamma2 / (1 - epsilon)]])
# Which gains appear in the last coefficient? (hint 1)
prescribed = sp.Matrix([[1 - gamma1 - gamma2 / (1 - epsilon), gamma2 / (1 - epsilon)]])
# Do both gains enter the trace? (hint 1)
prescribed = sp.Matrix([[-gamma1, 1 + gamma2 / (1 - epsilon)]])
region = (k1 + k2 < 0) & (k2 > 1)  # What changes when the other factor is negative? (hint 2)
# What is on the diagonal of the closed-loop matrix? (hint 1)
region = (k1 < 0) & ((1 - epsilon) * (k2 - 1) > 0)
region = k1 + k2 < 0  # Can one root be positive while the sum is negative? (hint 1)
# Was a term of the determinant lost? Multiply it out once more. (hint 1)
region = (k1 + k2 < 0) & (epsilon * (k2 - 1) > 0)

# %% right
uncontrollable_rows = {1: [[-3, 3]]}  # another multiple
uncontrollable_rows = {1.0: sp.Matrix([1, -1])}  # decimals, a column
margins = sp.Or(epsilon < 1, epsilon > 1)  # two sides
gain = sp.Matrix([[2 * epsilon - 7, 3 - 2 * epsilon]])  # k2 - 1 twice as large
# with a pole at the exceptional value
gain = sp.Matrix([[-2 - 1 / (1 - epsilon), 1 + 1 / (1 - epsilon)]])
# cases of epsilon
gain = sp.Matrix(
    [[sp.Piecewise((-3, epsilon < 1), (-1, True)), sp.Piecewise((2, epsilon < 1), (0, True))]]
)
# over one denominator
prescribed = sp.Matrix(
    [
        [
            (epsilon * gamma1 + epsilon - gamma1 - gamma2 - 1) / (1 - epsilon),
            (1 + gamma2 - epsilon) / (1 - epsilon),
        ]
    ]
)
# Ackermann's formula
W = B.row_join(A * B)
psi = A**2 + gamma1 * A + gamma2 * sp.eye(2)
prescribed = (-sp.Matrix([[0, 1]]) * W.inv() * psi).applyfunc(sp.cancel)
region = (k1 < -k2) & sp.Or((epsilon < 1) & (k2 > 1), (epsilon > 1) & (k2 < 1))  # by cases
region = (-k1 - k2 > 0) & (epsilon + k2 - epsilon * k2 - 1 > 0)  # the coefficients expanded

# %% wrong
observable = True  # Is there a state, not zero, that gives $z = 0$ for ever? (hint 1)
unobservable_eigenvalues = [1]  # Which coordinate does the measurement show? (hint 1)
unobservable_eigenvalues = []  # Write the two rows of Kalman's matrix. (hint 1)
recursion = sp.Matrix([[p22, p22], [p22, p22 + Q]])  # Was the measurement used? (hint 1)
# Is this after the measurement, and not yet before the next one? (hint 1)
recursion = P - P * sp.Matrix([0, 1]) * sp.Matrix([[0, 1]]) * P / (p22 + R)
# Does the noise act on $x_1$, too?
recursion = sp.Matrix([[1, 1], [1, 1]]) * (p22 * R / (p22 + R) + Q)
# Which sign makes the root of the quadratic equation a variance? (hint 2)
root = (Q - sp.sqrt(Q**2 + 4 * Q * R)) / 2
prior = sp.Matrix([[root - Q, root - Q], [root - Q, root]])
# Is this the equation of continuous time? (hint 1)
prior = sp.Matrix([[1, 1], [1, 1]]) * sp.sqrt(Q * R)
# Are the errors of the two coordinates uncorrelated?
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
prior = sp.diag(root - Q, root)
# Is it the matrix before the measurement? (hint 1)
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
posterior = sp.Matrix([[root - Q, root - Q], [root - Q, root]])
# Is a measurement of $x_2$ uncorrelated with the past of $x_2$? (hint 1)
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
posterior = sp.diag(root - Q, root - Q)
# Does the innovation not correct a coordinate that is not measured? (hint 1)
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
gain = [0, root / (root + R)]
# Is this the gain of the predictor, $\Phi K$?
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
gain = [root / (root + R), root / (root + R)]
# Is this the weight of the measurement, and not the remaining part of the error?
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
decay = [0, root / (root + R)]
decay = [0, 1]  # Are these the eigenvalues without a measurement?

# %% right
prior = Q * sp.ones(2, 2) / 2 * (sp.sqrt(1 + 4 * R / Q) - 1) + sp.diag(0, Q)  # in units of Q
# by the equation of the stationary variance
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
gain = [R / (root + R) * root / (root + R), Q / root]
# the inverse of the sum of informations
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
posterior = (
    sp.Matrix([[root - Q, root - Q], [root - Q, root]]).inv("ADJ") + sp.diag(0, 1 / R)
).inv("ADJ")
# 0 twice
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
decay = [0, (root - Q) / root, 0]

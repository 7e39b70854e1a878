# %% wrong
observable = False  # Does a delay of the measurement make a state unobservable? (hint 1)
recursion = sp.Matrix([[p22, p22], [p22, p22 + Q]])  # Was the measurement used? (hint 1)
# Which coordinate is measured here?
recursion = p22 * R / (p22 + R) * sp.ones(2, 2) + sp.diag(0, Q)
# Is it the matrix after the measurement?
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
prior = sp.Matrix([[root - Q, root - Q], [root - Q, root]])
# Which sign makes the root of the quadratic equation a variance? (hint 2)
root = (Q - sp.sqrt(Q**2 + 4 * Q * R)) / 2
prior = sp.Matrix([[root, root], [root, root + Q]])
# Is it the matrix before the measurement? (hint 1)
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
posterior = sp.Matrix([[root, root], [root, root + Q]])
# Is only the measured coordinate improved?
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
posterior = sp.Matrix([[root - Q, root - Q], [root - Q, root + Q]])
# Is the measurement uncorrelated with the other coordinate? (hint 1)
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
gain = [root / (root + R), 0]
# Is it the first column of the matrix that is divided? (hint 1)
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
gain = [root / (root + R), (root + Q) / (root + R)]
# Is this the weight of the measurement, and not the remaining part of the error?
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
decay = [0, root / (root + R)]
decay = [0, 1]  # Are these the eigenvalues without a measurement?

# %% right
# by the quadratic equation
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
gain = [Q / root, Q / root]
prior = Q / 2 * (1 + sp.sqrt(1 + 4 * R / Q)) * sp.ones(2, 2) + sp.diag(0, Q)  # in units of Q
# in the other order
root = (Q + sp.sqrt(Q**2 + 4 * Q * R)) / 2
decay = [(root - Q) / root, 0]

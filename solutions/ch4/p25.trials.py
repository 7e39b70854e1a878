# %% wrong
observable = True  # Is there a state, not zero, that gives $z = 0$ for ever? (hint 1)
# Does $x_2$ keep its old value, as in 4.22? (hint 2)
recursion = p22 * R / (p22 + R) * sp.ones(2, 2) + sp.diag(0, Q)
recursion = sp.diag(p22, Q)  # Was the measurement used? (hint 1)
prior = sp.diag(Q, Q)  # Was $x_1$ never measured, not even one step before? (hint 1)
prior = Q * R / (Q + R) * sp.eye(2)  # Is it the matrix after the measurement?
posterior = sp.diag(Q * R / (Q + R), Q)  # Is it the matrix before the measurement? (hint 1)
# Was $x_1$ never measured, not even as $x_2$ one step before?
posterior = sp.diag(Q, Q * R / (Q + R))
gain = [Q / (Q + R), Q / (Q + R)]  # Is the estimate of $x_1$ improved a second time? (hint 1)
gain = [0, R / (Q + R)]  # Should an exact measurement have a smaller weight? (hint 1)
gain = [Q / (Q + R), 0]  # Is this the gain of the predictor, $\Phi K$?
decay = [0, R / (Q + R)]  # Is the second number on the diagonal of the matrix? (hint 1)
decay = [1]  # Does an initial error remain for ever? (hint 1)
estimate = [z1, z2]  # Is a measurement with errors used with full weight? (hint 1)
estimate = [Q * z2 / (Q + R), Q * z2 / (Q + R)]  # When was $x_1$ measured, if ever? (hint 1)
estimate = [m2, Q * z2 / (Q + R)]  # Does the initial mean depend on a later noise? (hint 2)

# %% right
prior = sp.diag(1 / (1 / Q + 1 / R), Q)  # informations add up
gain = [0, 1 / (1 + R / Q)]  # by the ratio
posterior = sp.eye(2) * (Q - Q**2 / (Q + R))  # what the measurement takes off
estimate = [z1 / (1 + R / Q), z2 / (1 + R / Q)]  # by the ratio
decay = [0, 0]  # listed twice

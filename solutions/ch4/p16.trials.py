# %% wrong
# In which direction does the state rotate? (hint 2)
mean = [mu1 * sp.cos(t) - mu2 * sp.sin(t), mu1 * sp.sin(t) + mu2 * sp.cos(t)]
mean = [mu1 * sp.cos(t) + mu2 * sp.sin(t), mu2]  # Does the speed remain constant? (hint 2)
mean = [mu1, mu2]  # Is the initial state an equilibrium? (hint 1)
# Does the initial covariance remain constant? (hint 1)
covariance = P0 + Q / 4 * sp.Matrix(
    [[2 * t - sp.sin(2 * t), 1 - sp.cos(2 * t)], [1 - sp.cos(2 * t), 2 * t + sp.sin(2 * t)]]
)
# Does the noise enter through x or through its rate? (hint 2)
turned = sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]])
covariance = turned * P0 * turned.T + Q / 4 * sp.Matrix(
    [[2 * t + sp.sin(2 * t), 1 - sp.cos(2 * t)], [1 - sp.cos(2 * t), 2 * t - sp.sin(2 * t)]]
)
# Are the effects of the noise rotated with the motion, too? (hint 2)
turned = sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]])
covariance = turned * P0 * turned.T + sp.diag(0, Q * t)
# Are the effects of one impulse on x and on its rate uncorrelated? (hint 2)
turned = sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]])
covariance = turned * P0 * turned.T + Q / 4 * sp.diag(2 * t - sp.sin(2 * t), 2 * t + sp.sin(2 * t))
# In which direction does the ellipse rotate? (hint 1)
turned = sp.Matrix([[sp.cos(t), -sp.sin(t)], [sp.sin(t), sp.cos(t)]])
covariance = turned * P0 * turned.T + Q / 4 * sp.Matrix(
    [[2 * t - sp.sin(2 * t), 1 - sp.cos(2 * t)], [1 - sp.cos(2 * t), 2 * t + sp.sin(2 * t)]]
)

# %% right
mean = (A * t).exp() * sp.Matrix([mu1, mu2])  # the exponential of the matrix, with complex numbers
# as an integral, not multiplied out
turned = sp.Matrix([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]])
covariance = turned * P0 * turned.T + Q / 2 * sp.Matrix(
    [[t - sp.sin(t) * sp.cos(t), sp.sin(t) ** 2], [sp.sin(t) ** 2, t + sp.sin(t) * sp.cos(t)]]
)

# %% wrong
# Is the time measured from the end? (hint 1)
general_control = 2 * alpha * xi * sp.exp(alpha * t) / (beta * (sp.exp(2 * alpha * T) - 1))
# Was the factor of the control used both times? (hint 2)
general_control = 2 * alpha * xi * sp.exp(alpha * (T - t)) / (sp.exp(2 * alpha * T) - 1)
# Is a constant push the cheapest one, if the state grows by itself? (hint 1)
general_control = alpha * xi / (beta * (sp.exp(alpha * T) - 1))
general_exists = sp.Ne(k, 0)  # Which two exponentials are compared? (hint 1)
general_exists = k > 1  # Is it needed that the second part decays faster? (hint 1)
# Is this the observability Gramian? (hint 2)
a_gramian = sp.Matrix([[1, sp.Rational(1, 2)], [sp.Rational(1, 2), sp.Rational(1, 3)]])
a_gramian = sp.eye(2)  # Was the exponential forgotten? (hint 1)
# Does this reach the velocity, too? (hint 2)
a_control = 12 * xi1 - 6 * xi2 + (6 * xi2 - 12 * xi1) * t
a_control = xi2  # Is the position reached by a constant push? (hint 1)
# Which sign does the mixed term have? (hint 1)
a_energy = 12 * xi1**2 + 12 * xi1 * xi2 + 4 * xi2**2
# Is this the form with the Gramian instead of its inverse? (hint 1)
a_energy = xi1**2 / 3 + xi1 * xi2 + xi2**2
b_gramian = 2 * sp.pi * sp.eye(2)  # What is the mean of the square of a sine? (hint 1)
b_gramian = sp.Matrix([[sp.pi, 1], [1, sp.pi]])  # Are sine and cosine orthogonal here? (hint 1)
b_control = (
    xi1 * sp.sin(t) + xi2 * sp.cos(t)
) / sp.pi  # Was the time measured from the end? (hint 1)
b_control = xi1 * sp.sin(t) + xi2 * sp.cos(t)  # Was the inverse of the Gramian forgotten? (hint 1)
# Is this the form with the Gramian instead of its inverse? (hint 1)
b_energy = sp.pi * (xi1**2 + xi2**2)
b_energy = (xi1**2 + xi2**2) / (2 * sp.pi)  # What is the mean of the square of a sine? (hint 1)
# Is the inflow of the two tanks the same one? (hint 1)
c_gramian = (1 - sp.exp(-2)) / 2 * sp.eye(2)
# Does the integral contain the square of the exponential? (hint 1)
c_gramian = (1 - sp.exp(-1)) * sp.ones(2, 2)
c_energy = xi**2  # Is this the energy without the outflow? (hint 1)
c_energy = 4 * xi**2 / (1 - sp.exp(-2))  # Is the same inflow counted twice? (hint 2)

# %% right
# with a hyperbolic sine
general_control = alpha * xi * sp.exp(-alpha * t) / (beta * sp.sinh(alpha * T))
general_exists = sp.Or(k < 1, k > 1)  # as two intervals
a_gramian = [[0.33333, 0.5], [0.5, 1]]  # decimals
a_control = (6 - 12 * t) * xi1 + (6 * t - 2) * xi2  # by the parts of the end
a_energy = 3 * (2 * xi1 - xi2) ** 2 + xi2**2  # a sum of squares
b_gramian = sp.diag(sp.pi, sp.pi)  # a diagonal matrix
b_control = (xi2 * sp.sin(t + sp.pi / 2) - xi1 * sp.sin(t)) / sp.pi  # a shifted sine
b_energy = xi1**2 / sp.pi + xi2**2 / sp.pi  # term by term
c_gramian = sp.exp(-1) * sp.sinh(1) * sp.ones(2, 2)  # a hyperbolic sine
c_energy = xi**2 * sp.E / sp.sinh(1)  # a hyperbolic sine

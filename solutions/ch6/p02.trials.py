# %% wrong
# Is this the spline through the samples, for any weight? (hint 2)
a_acceleration = 3 * (h0 - 2 * h1 + h2) / (2 * tau**2)
# Is the acceleration constant between the samples? (hint 1)
a_acceleration = rho * tau * (h0 - 2 * h1 + h2) / (rho * tau**3 + 6 * M)
# Is only the middle residual not zero? (hint 2)
a_acceleration = 3 * rho * tau * (h0 - 2 * h1 + h2) / (2 * (rho * tau**3 + 6 * M))
# Do the residuals have the wrong sign? (hint 2)
q = 3 * M * (h0 - 2 * h1 + h2) / (2 * (rho * tau**3 + 9 * M))
a_positions = [h0 + q, h1 - 2 * q, h2 + q]
a_positions = [h0, h1, h2]  # Are these the samples themselves? (hint 1)
# Is this the straight line that an infinite weight gives? (hint 1)
a_positions = [(5 * h0 + 2 * h1 - h2) / 6, (h0 + h1 + h2) / 3, (-h0 + 2 * h1 + 5 * h2) / 6]
# Is this a mean of the acceleration instead of its greatest value? (hint 1)
b_limit = Delta / tau**2
b_limit = 3 * Delta / tau**2  # Is Delta the depth of the dip or the second difference? (hint 1)
# Was only one side of the equation divided? (hint 1)
b_weight = rho * tau * (3 * Delta - 2 * D * tau**2) / 18
# Can the weight be negative for a small bound? (hint 1)
b_weight = rho * tau * (2 * D * tau**2 - 3 * Delta) / (18 * D)
c_sweep = rho / 6 * (Delta - D * tau**2) ** 2  # Is this the misfit of the direct method? (hint 1)
# Is this the residual of the middle sample alone? (hint 1)
c_sweep = rho * (Delta - 2 * D * tau**2 / 3) ** 2 / 9
# Is this the misfit of the sweep? Another motion may have a smaller one. (hint 1)
c_direct = rho / 6 * (Delta - 2 * D * tau**2 / 3) ** 2
# Is it best to let the middle sample have the whole residual? (hint 2)
c_direct = rho / 4 * (Delta - D * tau**2) ** 2
c_direct = 0  # Can the bound be satisfied with zero residuals? (hint 2)

# %% right
# from the equation (R + M G) u = d
a_acceleration = ((h0 - 2 * h1 + h2) / tau) / (2 * tau / 3 + 6 * M / (rho * tau**2))
# over a common denominator
N = 2 * (rho * tau**3 + 9 * M)
q = -3 * M * (h0 - 2 * h1 + h2)
a_positions = sp.Matrix([(h0 * N + q) / N, (h1 * N - 2 * q) / N, (h2 * N + q) / N])
# multiplied out, a tuple
q = sp.expand(-3 * M * (h0 - 2 * h1 + h2) / (2 * (rho * tau**3 + 9 * M)))
a_positions = (h0 + q, h1 - 2 * q, q + h2)

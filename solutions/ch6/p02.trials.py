# %% wrong
a_acceleration = 3*(h0 - 2*h1 + h2)/(2*tau**2)  # the spline through the samples, whatever M is
a_acceleration = rho*tau*(h0 - 2*h1 + h2)/(rho*tau**3 + 6*M)  # a constant acceleration between the samples
a_acceleration = 3*rho*tau*(h0 - 2*h1 + h2)/(2*(rho*tau**3 + 6*M))  # only the middle sample gives way
# the misses turned round
q = 3*M*(h0 - 2*h1 + h2)/(2*(rho*tau**3 + 9*M))
a_positions = [h0 + q, h1 - 2*q, h2 + q]
a_positions = [h0, h1, h2]  # the samples themselves
a_positions = [(5*h0 + 2*h1 - h2)/6, (h0 + h1 + h2)/3, (-h0 + 2*h1 + 5*h2)/6]  # the straight line of M = infinity
b_limit = Delta/tau**2  # the second difference quotient, which is a mean of u and not its maximum
b_limit = 3*Delta/tau**2  # Delta taken for the depth of the dip
b_weight = rho*tau*(3*Delta - 2*D*tau**2)/18  # divided by D on one side only
b_weight = rho*tau*(2*D*tau**2 - 3*Delta)/(18*D)  # the sign turned
c_sweep = rho/6*(Delta - D*tau**2)**2  # the direct method's misfit
c_sweep = rho*(Delta - 2*D*tau**2/3)**2/9  # the middle miss only
c_direct = rho/6*(Delta - 2*D*tau**2/3)**2  # the misfit of the sweep taken for the least one
c_direct = rho/4*(Delta - D*tau**2)**2  # the whole rest put on the middle sample
c_direct = 0  # no miss at all

# %% right
a_acceleration = ((h0 - 2*h1 + h2)/tau)/(2*tau/3 + 6*M/(rho*tau**2))  # from the equation (R + M G) u = d
# over a common denominator
N = 2*(rho*tau**3 + 9*M)
q = -3*M*(h0 - 2*h1 + h2)
a_positions = sp.Matrix([(h0*N + q)/N, (h1*N - 2*q)/N, (h2*N + q)/N])
# multiplied out, a tuple
q = sp.expand(-3*M*(h0 - 2*h1 + h2)/(2*(rho*tau**3 + 9*M)))
a_positions = (h0 + q, h1 - 2*q, q + h2)

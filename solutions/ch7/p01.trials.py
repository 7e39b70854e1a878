# %% wrong
# the drift without the speed that it brings with it at the start
a_speed = -R*eps + v0*sp.cos(sp.sqrt(g/R)*t) + (b - g*phi0)*sp.sqrt(R/g)*sp.sin(sp.sqrt(g/R)*t)
# the frequency turned over
a_speed = -R*eps + (v0 + R*eps)*sp.cos(sp.sqrt(R/g)*t) + (b - g*phi0)*sp.sqrt(g/R)*sp.sin(sp.sqrt(R/g)*t)
a_speed = v0 + (b - g*phi0)*t - g*eps*t**2/2  # without the feedback by the curvature of the Earth
b_unseen = [0, 1, 0, -g]  # the sign of the tilt
b_unseen = [-R, 0, 1, 0]  # drift against speed, as if only the constant part mattered
b_unseen = [0, 0, 0, 0]  # no change at all
c_error = b/g  # truth minus estimate
c_error = 0  # the bias is not seen, so it was thought to do no harm
# the three errors added as if independent
d_worst = delta*sp.sqrt(2 + 4*sp.cos(sp.sqrt(g/R)*tau)**2)/(2*R*(1 - sp.cos(sp.sqrt(g/R)*tau)))
d_worst = delta/R  # the errors with the signs that they have in the formula: they need not be equal
d_worst = 4*delta/(g*tau**2)  # right for short arcs only

# %% right
# plain symbols, by the half angle
T, G, L, V, P, E, B = sp.symbols('t g R v0 phi0 eps b')
a_speed = V*sp.cos(T*sp.sqrt(G/L)) - 2*L*E*sp.sin(T*sp.sqrt(G/L)/2)**2 + (B - G*P)*sp.sqrt(L/G)*sp.sin(T*sp.sqrt(G/L))
b_unseen = sp.Matrix([0, 1/g, 0, 1])  # divided by g, as a column
b_unseen = (0, -2, 0, -2*g)  # the other way round
c_error = -1.0*b/g  # a decimal factor
d_worst = delta*(1 + sp.sqrt(sp.cos(tau*sp.sqrt(g/R))**2))/(2*R*sp.sin(tau*sp.sqrt(g/R)/2)**2)  # by the half angle

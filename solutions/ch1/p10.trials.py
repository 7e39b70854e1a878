# %% wrong
# no voltage, as the book prints it: the robot would slow down
a_program = {"x": V0*t, "y": 0, "alpha": 0, "V": V0, "omega": 0, "u_S": 0, "u_D": 0}
a_program = {"x": 0, "y": 0, "alpha": 0, "V": V0, "omega": 0, "u_S": V0, "u_D": 0}  # the place on the track forgotten
# the term V*sin(alpha) lost: taken for small of second order
a_matrix = sp.Matrix([[0, 0, 0, 1, 0], [0, 0, 0, 0, k0], [0, 0, 0, 0, 1], [0, 0, 0, -1, 0],
                      [0, 0, 0, 0, -k3*(1 + k2*V0/k1)]])
# the program speed not put in: linearised about rest
a_matrix = sp.Matrix([[0, 0, 0, 1, 0], [0, 0, V0, 0, k0], [0, 0, 0, 0, 1], [0, 0, 0, -1, 0], [0, 0, 0, 0, -k3]])
# the square of omega taken along as if it were linear
a_matrix = sp.Matrix([[0, 0, 0, 1, 0], [0, 0, V0, 0, k0], [0, 0, 0, 0, 1], [0, 0, 0, -1, 2*k1*k2],
                      [0, 0, 0, 0, -k3*(1 + k2*V0/k1)]])
a_inputs = sp.Matrix([[0, 0], [0, 0], [0, 0], [0, 1], [k3/k1, 0]])  # the columns exchanged
a_inputs = sp.Matrix([[0, 0], [0, 0], [0, 0], [1, 0], [0, 1]])  # the coefficient of u_D lost
b_eigenvalues = [[-1, 2, 1]]  # the zero eigenvalue overlooked: only the speed looked at
b_eigenvalues = [[0, 1, 1], [1, 1, 1]]  # the sign of the eigenvalue turned
b_limit = sp.Matrix([0, 0])  # asymptotic stability assumed
b_limit = sp.Matrix([dx0, 0])  # the way covered while the speed recovers forgotten
b_stability = "asymptotically stable"  # the speed recovers, but not the place
b_stability = "unstable"  # a zero eigenvalue taken for instability
c_eigenvalues = [[0, 2, 2], [-k3*(1 + k2*V0/k1), 1, 1]]  # the double zero taken to have two eigenvectors
c_eigenvalues = [[0, 2, 1], [k3*(1 + k2*V0/k1), 1, 1]]  # the sign of p turned
c_growing = sp.Matrix([V0*alpha0*t**2/2, alpha0*t, alpha0])  # a turning that the equation for omega does not allow
c_growing = sp.Matrix([alpha0, 0, 0])  # a displacement, which stays as it is
c_stability = "stable"  # no eigenvalue on the right taken for stability
c_heading = sp.And(k1 > 0, k3 > 0)  # the centre of mass taken to be ahead of the wheels
c_heading = k1 + k2*V0 >= 0  # p = 0 counted in, where the two zero eigenvalues have one eigenvector
c_heading = k2 > 0  # only a centre of mass ahead of the wheels allowed

# %% right
a_program = [V0*t, 0, 0, V0, 0, V0, 0]  # a list, the state first and the controls last
# a dict from the symbols
a_program = {x: sp.Symbol("V0")*sp.Symbol("t"), y: 0, alpha: 0, V: V0, omega: 0, u_S: V0, u_D: 0.0}
b_eigenvalues = [(-1, 1, 1), (0, 1, 1)]  # another order, tuples
c_eigenvalues = [[-k3*(k1 + k2*V0)/k1, 1, 1], [0, 2, 1]]  # over a common denominator
c_eigenvalues = {0: (2, 1), -k3 - k2*k3*V0/k1: (1, 1)}  # a dict from the value to its multiplicities
c_growing = [alpha0 - V0*alpha0*t, -alpha0, 0]  # a list, to the other side and with a displacement at the start
# with a turning that dies out or grows
c_growing = [alpha0*(V0*t + (V0/(k3*(1 + k2*V0/k1)) - k0)/(k3*(1 + k2*V0/k1))*sp.exp(-k3*(1 + k2*V0/k1)*t)),
             alpha0*(1 - sp.exp(-k3*(1 + k2*V0/k1)*t)/(k3*(1 + k2*V0/k1))), alpha0*sp.exp(-k3*(1 + k2*V0/k1)*t)]
c_heading = k3*(1 + k2*V0/k1) > 0  # p > 0 as it stands
c_heading = sp.Or(k2 >= 0, sp.And(k2 < 0, V0 < -k1/k2))  # solved for the speed, by the sign of k2

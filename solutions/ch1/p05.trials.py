# %% wrong
# the Coriolis terms of the first two equations confused
a_matrix = sp.Matrix([[0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1], [0, 0, 0, 0, 2*r0*Omega, 0],
                      [0, 3*Omega**2, 0, -2*Omega/r0, 0, 0], [0, 0, -Omega**2, 0, 0, 0]])
# the state in the order (x1, v1, x2, v2, x3, v3)
a_matrix = sp.Matrix([[0, 1, 0, 0, 0, 0], [0, 0, 0, -2*Omega/r0, 0, 0], [0, 0, 0, 1, 0, 0],
                      [0, 2*r0*Omega, 3*Omega**2, 0, 0, 0], [0, 0, 0, 0, 0, 1], [0, 0, 0, 0, -Omega**2, 0]])
# a double eigenvalue taken to have two eigenvectors
a_eigenvalues = [[0, 2, 2], [sp.I*Omega, 2, 2], [-sp.I*Omega, 2, 2]]
a_eigenvalues = [[0, 2, 1], [sp.I*Omega, 2, 1], [-sp.I*Omega, 2, 1]]  # every double eigenvalue taken for a Jordan block
# the Coriolis coupling forgotten: the height alone would have real eigenvalues
a_eigenvalues = [[0, 2, 1], [sp.sqrt(3)*Omega, 1, 1], [-sp.sqrt(3)*Omega, 1, 1], [sp.I*Omega, 1, 1],
                 [-sp.I*Omega, 1, 1]]
a_growing = sp.Matrix([3*Omega*h/(2*r0)*t, h, 0, 3*Omega*h/(2*r0), 0, 0])  # a higher satellite taken to run ahead
# a motion, but a bounded one: the ellipse of the same period
a_growing = sp.Matrix([2*h/r0*sp.cos(Omega*t), h*sp.sin(Omega*t), 0, -2*Omega*h/r0*sp.sin(Omega*t),
                       Omega*h*sp.cos(Omega*t), 0])
# a drift at constant height zero, which the second equation forbids
a_growing = sp.Matrix([h/r0*Omega*t, 0, 0, h/r0*Omega, 0, 0])
a_stability = "stable"  # no root on the right taken for stability
# the coordinate x2 struck out in the place of x1
b_matrix = sp.Matrix([[0, 0, 0, 1, 0], [0, 0, 0, 0, 1], [0, 0, 0, -2*Omega/r0, 0], [0, 0, 2*r0*Omega, 0, 0],
                      [0, -Omega**2, 0, 0, 0]])
b_eigenvalues = [[0, 2, 1], [sp.I*Omega, 2, 2], [-sp.I*Omega, 2, 2]]  # the spectrum of the full system kept
b_eigenvalues = [[sp.I*Omega, 2, 2], [-sp.I*Omega, 2, 2]]  # the eigenvalue 0 taken to leave with x1
# energies only: zero along x2 : y1 = 2 r0 : -3 Omega, so not positive definite
b_integral = v2**2 + (3*Omega*x2 + 2*r0*y1)**2 + v3**2 + Omega**2*x3**2
# the energy of an oscillator about the undisturbed height
b_integral = v2**2 + Omega**2*x2**2 + r0**2*y1**2 + v3**2 + Omega**2*x3**2
# the energy in the turning frame: conserved, but indefinite
b_integral = v2**2 + r0**2*y1**2 - 3*Omega**2*x2**2 + v3**2 + Omega**2*x3**2
b_stability = "asymptotically stable"  # bounded taken for tending to zero

# %% right
a_eigenvalues = [(-sp.I*Omega, 2, 2), (sp.I*Omega, 2, 2), (0, 2, 1)]  # in another order, as tuples
a_growing = [sp.Rational(3, 2)*Omega*h*t/r0, -h, 0, 3*Omega*h/r0/2, 0, 0]  # a list, with the sign of h turned
# the drift in loops of a satellite that starts faster, with another oscillation across the plane
a_growing = [h*(4*sp.sin(Omega*t) - 3*Omega*t)/r0, 2*h*(1 - sp.cos(Omega*t)), h*sp.sin(Omega*t)/r0,
             h*Omega*(4*sp.cos(Omega*t) - 3)/r0, 2*h*Omega*sp.sin(Omega*t), h*Omega*sp.cos(Omega*t)/r0]
b_eigenvalues = [(sp.I*Omega, 2, 2), (0, 1, 1), (-sp.I*Omega, 2, 2)]  # in another order, as tuples
b_eigenvalues = {0: (1, 1), sp.I*Omega: (2, 2), -sp.I*Omega: (2, 2)}  # as a dict from the value to its multiplicities
# other weights of the conserved parts, multiplied out
b_integral = sp.expand(2*(v2**2 + (3*Omega*x2 + 2*r0*y1)**2) + 5*(2*Omega*x2 + r0*y1)**2 + 7*(v3**2 + Omega**2*x3**2))
# by the constant C and the shifted centre
C = y1 + 2*Omega/r0*x2
b_integral = (v2**2 + Omega**2*(x2 - 2*r0*C/Omega)**2)/2 + (r0*C)**2 + (v3**2 + Omega**2*x3**2)/2

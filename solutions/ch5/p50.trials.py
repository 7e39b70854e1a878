# %% wrong
# Which sign precedes the gradient if $\varphi$ is minimised? (hint 1)
a_end = [psi1 - x1, psi2, psi3 - x3, psi4]
a_end = [psi2, psi4]  # Are the displacements given at the end? (hint 1)
a_end = [psi1, psi2, psi3, psi4]  # Where is the cost? (hint 1)
a_switching = psi2  # Does the force act on one pendulum only? (hint 1)
a_switching = psi1 + psi3  # Which equations contain the control? (hint 1)
a_rate = psi1 + psi3  # What is the sign in the adjoint equation? (hint 1)
a_rate = -(psi1 + k * psi3)  # Which costate equation belongs to the velocity? (hint 1)
# Are two derivatives enough? (hint 2)
a_matrix = sp.Matrix([[0, 1, 0, 0], [1, 0, 0, 0], [0, 1, 0, 0], [1, 0, 0, 0]])
# Are the pendulums equal? (hint 1)
a_matrix = sp.Matrix([[0, 1, 0, -1], [1, 0, -1, 0], [0, 1, 0, -1], [1, 0, -1, 0]])
a_values = sp.Ne(k, 0)  # Which determinant was looked at? (hint 1)
a_values = k > 1  # Does it matter which of the pendulums is the longer one? (hint 1)
a_values = sp.And(k > 0, sp.Ne(k, 1))  # Is anything lost for a negative stiffness? (hint 1)
b_starts = sp.Eq(b, 0)  # Can the best end be reached from elsewhere? (hint 2)
b_starts = b <= T  # What about negative initial values? (hint 2)
b_end = [psi0]  # Is the costate zero at every end, or at one only? (hint 1)
b_end = [psi0 - 2 * x]  # Which sign precedes the gradient if the cost is minimised? (hint 1)
b_end = [x]  # Is the final state given? (hint 1)
b_control = v  # Where does the motion end under this control? (hint 1)
b_control = sp.Piecewise((v, t < 1), (1 - v, True))  # Is the end the best one? (hint 1)
# Does the trolley not affect the mean motion? (hint 1)
c_uncontrollable_rows = [sp.Matrix([[1, 0, 1, 0]]), sp.Matrix([[0, 1, 0, 1]])]
# Is there only one such combination? Which velocity belongs to it? (hint 1)
c_uncontrollable_rows = [sp.Matrix([[1, 0, -1, 0]])]

# %% right
# as equations, combined
a_end = [sp.Eq(psi1, -x1), sp.Eq(psi3, -x3), sp.Eq(psi2 + psi4, 0), sp.Eq(psi2, psi4)]
a_switching = 2 * (psi2 + psi4)  # a positive multiple
a_values = sp.Or(k < 1, k > 1)  # as two intervals
b_starts = b**2 <= T**2  # squared
b_end = sp.Eq(x, -psi0 / 2)  # solved for the state
b_control = sp.Piecewise((v, t < 1), (-v, True))  # there and back
c_uncontrollable_rows = [sp.Matrix([[1, 1, -1, -1]]), sp.Matrix([[1, -1, -1, 1]])]  # another basis

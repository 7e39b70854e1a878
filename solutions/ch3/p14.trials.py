# %% wrong
a_gain = sp.Matrix([[-27, -8, -8]])  # Is $k_2$ the difference or the sum?
a_gain = sp.Matrix([[0, -3, -3]])  # Does the first coordinate not grow, too?
a_gain = []  # How many chains has each eigenvalue?
a_gain = sp.Matrix([[27, 0, 8]])  # What is the sign of the feedback in the statement?
a_prescribed = sp.Matrix([[-gamma3, -gamma2, -gamma1]])  # Is the system a chain of integrators?
# What is the sign of the feedback in the statement?
psi1, psi2 = 1 + gamma1 + gamma2 + gamma3, 8 + 4 * gamma1 + 2 * gamma2 + gamma3
a_prescribed = sp.Matrix([[psi2, 12 + 4 * gamma1 + gamma2 - psi2, psi1]])
b_gain = sp.Matrix([[-27, -8, -20]])  # What does $\psi(1)$ have to be?
b_gain = sp.Matrix([[-3, -3, -3]])  # Do three modes not share one control?
b_gain = []  # How many chains has each eigenvalue?
b_prescribed = sp.Matrix([[-gamma3, -gamma2, -gamma1]])  # Is the system a chain of integrators?
# Which coordinate is the single one here?
psi1, psi2 = 1 + gamma1 + gamma2 + gamma3, 8 + 4 * gamma1 + 2 * gamma2 + gamma3
b_prescribed = sp.Matrix([[-psi2, psi2 - 12 - 4 * gamma1 - gamma2, -psi1]])
c_gain = sp.Matrix([[-2, 0]])  # Which of the two coordinates grows?
c_gain = []  # Does the uncontrollable coordinate not decay?
c_region = (k1 < 1) & (k2 < -1)  # Does the first gain appear in the characteristic polynomial?
c_region = k2 < 0  # How fast does $x_2$ grow by itself?
c_region = k2 < -2  # Is the question about the greatest degree of stability?
c_margins = sp.true  # And the other root: does the gain move it, too?
c_margins = mu < 1  # Does the definition of a degree of stability exclude equality?
c_margins = sp.false  # Which equation does the control enter?
c_uncontrollable_rows = []  # What is the rank of W?
c_uncontrollable_rows = [[0, 1]]  # Which coordinate does the control leave alone?
c_uncontrollable_rows = [[2, -1]]  # Is this a row with $wb = 0$, or an eigenvector of the matrix?

# %% right
a_gain = [-64, 16, -27]  # three roots -2
a_gain = sp.Matrix([-27.0, 0.0, -8.0])  # decimals, upright
# Ackermann's formula
W = B_a.row_join(A_a * B_a).row_join(A_a**2 * B_a)
psi = A_a**3 + gamma1 * A_a**2 + gamma2 * A_a + gamma3 * sp.eye(3)
a_prescribed = (-sp.Matrix([[0, 0, 1]]) * W.inv() * psi).applyfunc(sp.cancel)
b_gain = [-64, 27, 54]  # three roots -2
# Ackermann's formula
W = B_b.row_join(A_b * B_b).row_join(A_b**2 * B_b)
psi = A_b**3 + gamma1 * A_b**2 + gamma2 * A_b + gamma3 * sp.eye(3)
b_prescribed = (-sp.Matrix([[0, 0, 1]]) * W.inv() * psi).applyfunc(sp.cancel)
c_gain = [7, -1.5]  # any gain of x1
c_region = (k2 + 1 < 0) & (k1**2 >= 0)  # with a condition that always holds
c_margins = (mu > 0) & (mu <= 1)  # an interval
c_uncontrollable_rows = [[-3, 0]]  # another multiple

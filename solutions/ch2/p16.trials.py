# %% wrong
# the error thought to push the motion
a_augmented = [sp.Matrix([[-1, 0, 1], [1, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 0, 1]])]
# the error left out of the output
a_augmented = [sp.Matrix([[-1, 0, 0], [1, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 0, 0]])]
# a constant taken to have the rate 1
a_augmented = [sp.Matrix([[-1, 0, 0], [1, 0, 0], [0, 0, 1]]), sp.Matrix([[1, 0, 1]])]
a_observable = True  # C and x1 are found, so all is thought to be found
a_unseen = [[0, 1, -1]]  # two unknown constants thought to be confused with each other
a_unseen = [[0, 1, 0], [0, 0, 1]]  # a hidden error added to the hidden coordinate
a_amplitude = z  # the last value of z, which is C only in the end
a_amplitude = z - z1  # the sign of the rate of decay
b_augmented = [sp.Matrix([[0, 1, 0], [-1, 0, 0], [0, 0, 0]]), sp.Matrix([[0, 1, 1]])]  # the error taken for a constant
b_observable = False  # the growing error thought to cover everything
b_amplitude = (z + z2)*sp.exp(-t)  # the derivatives of the error forgotten
b_amplitude = (z + z2)/2  # the growth of the error forgotten
c_augmented = [sp.diag(A_c, 0), sp.Matrix([[1, 0, sp.exp(alpha)]])]  # the coefficient itself where the rate belongs
# the error in the place of x2
c_augmented = [sp.Matrix([[-3, -2, 0], [1, 0, 0], [0, 0, alpha]]), sp.Matrix([[1, 1, 0]])]
c_region = alpha < 0  # the error thought to be harmless only if it decays
c_region = sp.Ne(alpha, -1)  # one of the two modes overlooked
c_region = sp.And(sp.Ne(alpha, 1), sp.Ne(alpha, 2))  # the sign of the eigenvalues
c_unseen = {-1: [[-1, 1, 1]], -2: [[-2, 1, 1]]}  # the eigenvectors, with C = 1 in both cases
c_unseen = {-1: [[-1, 1, -1]], -2: [[-2, 1, -2]]}  # the eigenvectors, with C of the wrong sign
c_unseen = {-1: [[0, 0, 1]], -2: [[0, 0, 1]]}  # the error alone thought to be lost
d_augmented = [sp.diag(A_d, omega), sp.Matrix([[1, 0, 1]])]  # one coordinate for the sine
# a sign that makes exponentials of the sine
d_augmented = [sp.diag(A_d, sp.Matrix([[0, omega], [omega, 0]])), sp.Matrix([[1, 0, 1, 0]])]
d_region = sp.Ne(omega, 1)  # the exceptional value of the text-book example alone
d_region = sp.Ne(omega**2, 1)  # the error that is not there overlooked
d_region = sp.Ne(omega, 0)  # zero frequency thought to be the only danger
d_state = sp.And(sp.Ne(omega, 0), sp.Ne(omega**2, 1))  # what holds for the state and the error together
d_state = sp.true  # the known phase thought to save the state at resonance, too
d_amplitude = sp.And(sp.Ne(omega, 1), sp.Ne(omega, -1))  # the error that is not there overlooked
d_unseen = {0: [[0, 0, 1]], 1: [[0, 1, -1]], -1: [[0, 1, -1]]}  # one sign for both resonances
# as if the phase of the error were unknown
d_unseen = {0: [[0, 0, 1]], 1: [[0, 1, -1], [1, 0, 0]], -1: [[0, 1, 1], [1, 0, 0]]}
d_unseen = {1: [[0, 1, -1]], -1: [[0, 1, 1]]}  # the value zero forgotten

# %% right
# twice C for the coordinate
a_augmented = [sp.Matrix([[-1, 0, 0], [1, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 0, sp.Rational(1, 2)]])]
a_augmented = [[[-1, 0, 0], [1, 0, 0], [0, 0, 0]], [1, 0, 1]]  # nested lists, the row flat
a_unseen = [sp.Matrix([0, -3, 0])]  # another multiple, as a column
a_unseen = [0.0, 1.0, 0.0]  # floats, without the outer list
# the error with the opposite sign
b_augmented = [sp.Matrix([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]), sp.Matrix([[0, 1, -1]])]
b_amplitude = (sp.cosh(t) - sp.sinh(t))*(z + z2)/2  # written with hyperbolic functions
c_augmented = [sp.diag(A_c, alpha), sp.Matrix([[1, 0, 2]])]  # half the error
c_region = sp.Ne(alpha**2 + 3*alpha + 2, 0)  # the polynomial
c_region = sp.Or(alpha < -2, sp.And(alpha > -2, alpha < -1), alpha > -1)  # intervals
c_unseen = {-2: [[2, -1, -2]], -1: [[3, -3, -3]]}  # other multiples and order
c_unseen = {-1.0: [sp.Matrix([1, -1, -1])], -2.0: [(-1.0, 0.5, 1.0)]}  # floats and columns
d_augmented = [sp.diag(A_d, sp.Matrix([[0, 1], [-omega**2, 0]])), sp.Matrix([[1, 0, 1, 0]])]  # the error and its rate
# cosine and sine interchanged, nested lists
d_augmented = [[[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, -omega], [0, 0, omega, 0]], [1, 0, 0, 1]]
d_region = sp.Ne(omega*(omega**2 - 1)**2, 0)  # the determinant of Kalman's matrix
d_state = sp.Ne(omega**2, 1)  # the square
d_state = sp.Or(sp.Abs(omega) < 1, sp.Abs(omega) > 1)  # the modulus
d_amplitude = sp.Ne(omega**3 - omega, 0)  # a product
d_amplitude = sp.Complement(sp.S.Reals, sp.FiniteSet(0, 1, -1)).as_relational(omega)  # the complement of a set
d_unseen = {-1: [[0, -2, -2]], 1: [[0, -1, 1]], 0: [[0, 0, 7]]}  # other multiples and order
d_unseen = {0.0: [0, 0, 1.0], 1.0: [0, 0.5, -0.5], -1.0: [0, 0.5, 0.5]}  # floats, without the outer lists

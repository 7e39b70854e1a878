# %% wrong
# Is the energy minimised or maximised? With which sign does it enter $H$? (hint 1)
a_pontryagin = (
    psi1 * k * rho + psi2 * (-2 * k * omega + u) + rho**2 * (u**2 + (k**2 - omega**2) ** 2)
)
# Was the factor $\rho$ of both accelerations forgotten? (hint 1)
a_pontryagin = psi1 * k * rho + psi2 * (-2 * k * omega + u) - u**2 - (k**2 - omega**2) ** 2
# Which sign precedes the derivative of $H$? (hint 1)
a_adjoint = [
    k * psi1 - 2 * rho * (u**2 + (k**2 - omega**2) ** 2),
    -2 * k * psi2 + 4 * rho**2 * omega * (k**2 - omega**2),
]
# Does the energy depend on the states? (hint 1)
a_adjoint = [-k * psi1, 2 * k * psi2]
a_transversality = [psi1, psi2]  # Is the distance free at the end? (hint 1)
# Which state has a given value at the end, and which has not? (hint 1)
a_transversality = [psi1]
# Was the distance in the coefficient of the square of the control forgotten? (hint 1)
a_control = psi2 / 2
# Does $H$ have its maximum there? Which sign does the linear term have? (hint 1)
a_control = -psi2 / (2 * rho**2)
# Is the distance in the control constant while the costate changes? (hint 1)
a_rate = 2 * omega * (omega**2 - k**2) + 2 * k * u
# Which sign does the derivative of the square of a difference have? (hint 2)
a_rate = 2 * omega * (k**2 - omega**2)
a_rate = omega * (omega**2 - k**2)  # Is a factor from the inner derivative missing? (hint 1)
# Are these the terms on the other side of the equation? (hint 1)
b_duffing = 2 * k**2 * omega + 2 * k * v - 2 * omega**3
# Does the result of the differentiation still contain the control? (hint 2)
b_duffing = -2 * k * v + 2 * omega**3 - 2 * k**2 * omega - 2 * k * omega
b_duffing = -2 * k**2 * omega - 2 * k * v - 2 * omega**3  # Which sign does the cube have? (hint 1)
b_rest = [(0, 0)]  # When does the other factor vanish? (hint 1)
b_rest = [(0, 0), (k, 0), (-k, 0)]  # Is $\omega$ constant there as well? (hint 2)
# Which sign does the control that keeps $\omega$ constant have? (hint 2)
b_rest = [(0, 0), (k, -2 * k**2), (-k, 2 * k**2)]
# Is there no other matrix among the stationary solutions? (hint 2)
b_matrices = [sp.Matrix([[-2 * k, 1], [-2 * k**2, 0]])]
# What is the order of the variables? (hint 1)
b_matrices = [sp.Matrix([[0, -2 * k**2], [1, -2 * k]]), sp.Matrix([[0, 4 * k**2], [1, -2 * k]])]
# Was the cube differentiated in full? (hint 1)
b_matrices = [sp.Matrix([[-2 * k, 1], [-2 * k**2, 0]]), sp.Matrix([[-2 * k, 1], [0, 0]])]
# Is the friction positive for an approach?
b_kinds = {0: "stable focus", 1: "saddle", -1: "saddle"}
# Is there no term with the first derivative?
b_kinds = {0: "centre", 1: "saddle", -1: "saddle"}
# Is the portrait not symmetric? (hint 1)
b_kinds = {0: "unstable focus", 1: "saddle"}
# Which of them belongs to the positive root? (hint 1)
b_slopes = [-sp.sqrt(5) - 1, sp.sqrt(5) - 1]
# Are these the eigenvalues themselves? A slope in these variables differs from them. (hint 1)
b_slopes = [1 + sp.sqrt(5), 1 - sp.sqrt(5)]
b_straight = (1 - sp.exp(-T)) / 2  # How does the square of the distance fall? (hint 1)
b_straight = T  # Does the distance stay the same? (hint 1)
b_straight = sp.Integer(0)  # Is there nothing to brake? (hint 1)
# Is this the straight approach? Does Jacobi's condition hold for so long a time? (hint 1)
b_long = sp.Rational(490842, 10**6)
b_long = sp.Rational(1, 2)  # Does the approach last for ever? (hint 1)

# %% right
a_transversality = sp.Eq(psi2, 0)  # a single equation
a_rate = 2 * (omega - k) * omega * (omega + k)  # in factors
b_rest = sp.Matrix([[0, 0], [-k, -2 * k**2], [k, 2 * k**2]])  # as the rows of a matrix
b_kinds = {-1: "saddle", 0: "unstable focus", 1: "saddle"}  # from left to right
b_straight = sp.exp(-T) * sp.sinh(T)  # by the hyperbolic sine
b_long = sp.Float("0.4618")  # four digits

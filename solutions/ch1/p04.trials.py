# %% wrong
a_matrix = sp.Matrix([[0, 1], [-1, -epsilon]])  # the sign of epsilon lost when the bracket is multiplied out
a_stable = epsilon > 0  # the equation taken for a damped oscillator
a_stable = epsilon <= 0  # imaginary roots counted as asymptotically stable
a_unstable = epsilon >= 0  # everything that is not asymptotically stable called unstable
a_critical = "asymptotically stable"  # stability taken for asymptotic stability: the circles do not shrink
b_rate = -epsilon*(x1**2 - 1)*x2  # one factor x2 lost
b_rate = epsilon*(x1**2 - 1)*x2**2  # the sign of the resistor's term turned
b_null = sp.Eq(x2, 0)  # the lines x1 = +-1 overlooked
b_stable = epsilon <= 0  # V' identically zero taken for a proof
b_basin = sp.Abs(x1) < 1  # the strip where V' <= 0 taken for the estimate
b_basin = x1**2 + x2**2 < 2  # the level V = 1 instead of the circle of radius 1

# %% right
a_stable = -epsilon > 0  # the damping coefficient
b_null = sp.Eq((x1**2 - 1)*x2**2, 0)  # one equation
b_null = sp.Or(sp.Eq(x2, 0), sp.Eq(sp.Abs(x1), 1))  # with the modulus
b_basin = V < sp.Rational(1, 2)  # by the level of V
b_basin = sp.sqrt(x1**2 + x2**2) < 1.0  # by the radius, with decimals

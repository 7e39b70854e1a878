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
a_matrix = [[0, 1], [-1, sp.Symbol("epsilon")]]  # nested lists and a plain symbol
a_matrix = field.jacobian(state).subs(x1, 0).subs(x2, 0)  # left as the partial derivatives give it
a_stable = sp.Interval.open(-sp.oo, 0)  # as an interval
a_stable = -epsilon > 0  # the damping coefficient
a_unstable = 0 < epsilon  # turned round
a_unstable = sp.Interval.open(0, sp.oo)  # as a set
b_rate = epsilon*x2**2 - epsilon*x1**2*x2**2  # multiplied out
b_rate = x1*x2 + x2*(-epsilon*(x1**2 - 1)*x2 - x1)  # not simplified
b_null = sp.Eq((x1**2 - 1)*x2**2, 0)  # one equation
b_null = sp.Or(sp.Eq(x2, 0), sp.Eq(sp.Abs(x1), 1))  # with the modulus
b_stable = 0 > epsilon  # turned round
b_stable = sp.Interval.open(-sp.oo, 0)  # as an interval
b_basin = V < sp.Rational(1, 2)  # by the level of V
b_basin = sp.sqrt(x1**2 + x2**2) < 1.0  # by the radius, with decimals

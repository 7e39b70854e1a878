# %% wrong
a_gain = rho/(rho - M*omega**2)  # the second derivative instead of the fourth
a_gain = 1/(1 + (M*omega**4/rho)**2)  # the square of the right ratio
a_gain = M*omega**4/(rho + M*omega**4)  # what is lost instead of what is left
a_decay = (rho/M)**sp.Rational(1, 4)  # the modulus of the exponents instead of their real part
a_decay = -(rho/(4*M))**sp.Rational(1, 4)  # with the sign of the exponent
b_weight = rho/omega**4*(1/D - 1)  # the gain set equal to D
b_weight = rho/omega**4*(a/D - 1)  # the amplitude bounded instead of the acceleration
b_weight = rho*a/(D*omega**2)  # the excess without the 1 that stands for h itself
# the negative root of p22
c_riccati = sp.Matrix([[-sp.sqrt(2)*rho**sp.Rational(3, 4)*M**sp.Rational(1, 4), sp.sqrt(rho*M)],
                       [sp.sqrt(rho*M), -sp.sqrt(2)*rho**sp.Rational(1, 4)*M**sp.Rational(3, 4)]])
# rho and M interchanged
c_riccati = sp.Matrix([[sp.sqrt(2)*rho**sp.Rational(1, 4)*M**sp.Rational(3, 4), sp.sqrt(rho*M)],
                       [sp.sqrt(rho*M), sp.sqrt(2)*rho**sp.Rational(3, 4)*M**sp.Rational(1, 4)]])
# the signs of the paper's Q, which is minus the matrix with its rows exchanged
c_riccati = -sp.Matrix([[sp.sqrt(rho*M), sp.sqrt(2)*rho**sp.Rational(1, 4)*M**sp.Rational(3, 4)],
                        [sp.sqrt(2)*rho**sp.Rational(3, 4)*M**sp.Rational(1, 4), sp.sqrt(rho*M)]])

# %% right
# by the cut-off frequency
cut = (rho/M)**sp.Rational(1, 4)
a_gain = 1/(1 + (omega/cut)**4)
a_gain = 1 - M*omega**4/(rho + M*omega**4)  # one minus what is lost

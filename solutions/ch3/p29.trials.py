# %% wrong
a_factors = [sp.Rational(1, 2), sp.oo]  # Is the loop unstable for a small factor? (hint 1)
a_factors = [0, 2]  # Do both coefficients stay positive for large factors? (hint 1)
a_factors = [1, sp.oo]  # Look at a weaker motor. (hint 1)
a_phase = sp.atan(2 / sp.sqrt((1 + sp.sqrt(17)) / 2))  # To which axis is this the angle? (hint 2)
a_phase = 38.7  # In radians, please. (hint 2)
a_phase = sp.pi / 3  # Does the guarantee of an optimal regulator hold for every law? (hint 1)
a_phase = sp.atan(sp.sqrt(2) / 2)  # At this frequency, is the modulus of $L$ equal to 1? (hint 1)
a_delay = sp.atan(sp.sqrt((1 + sp.sqrt(17)) / 2) / 2)  # This is an angle. (hint 1)
# Divide the angle by the frequency. (hint 1)
a_delay = sp.atan(sp.sqrt((1 + sp.sqrt(17)) / 2) / 2) * sp.sqrt((1 + sp.sqrt(17)) / 2)
a_delay = sp.oo  # Does a long delay do no harm? (hint 1)
b_lags = sp.true  # All coefficients are positive. Is this sufficient for degree three? (hint 2)
b_lags = (
    tau < 1
)  # Compare the product of the inner coefficients with that of the outer ones. (hint 2)
b_lags = tau < 2  # Which two coefficients are the inner ones? (hint 2)
b_lags = tau <= sp.Rational(1, 2)  # Do the motions decay at the end of the interval?
c_disk = 1  # Is this the guarantee of an optimal regulator? (hint 1)
c_disk = sp.Rational(7, 16)  # Is this the square of the distance?
c_disk = sp.sqrt(2) / 2  # Is the modulus smallest at the frequency 2? (hint 2)

# %% right
a_factors = (0, sp.oo)  # a tuple
# by the sine
crossing = sp.sqrt((friction**2 + sp.sqrt(friction**4 + 4 * stiffness**2)) / 2)
a_phase = sp.asin(friction / crossing)
# by the cosine
square = (friction**2 + sp.sqrt(friction**4 + 4 * stiffness**2)) / 2
a_delay = sp.acos(stiffness / square) / sp.sqrt(square)
b_lags = stiffness * tau < friction  # the Hurwitz criterion
b_lags = sp.And(tau > 0, tau < sp.Rational(friction, stiffness))  # both ends
# by the minimum of the square
c_disk = friction * sp.sqrt(4 * stiffness - friction**2) / (2 * sp.Integer(stiffness))

# %% numbers
stiffness, friction = [
    *[(2, 1), (3, 1), (5, 2), (4, 1), (3, 2), (5, 3), (6, 1)],
    *[(7, 2), (7, 3), (9, 2), (8, 3), (5, 1), (7, 1), (8, 1)],
]
shown = [r"u = -«stiffness»x - «friction*»\dot x ."]
crossing = sp.sqrt((friction**2 + sp.sqrt(friction**4 + 4 * stiffness**2)) / 2)
a_factors = [0, sp.oo]
a_phase = sp.atan(friction * crossing / stiffness)
a_delay = a_phase / crossing
b_lags = tau < sp.Rational(friction, stiffness)
c_disk = sp.sqrt(1 - sp.Rational(2 * stiffness - friction**2, 2 * stiffness) ** 2)

# %% wrong
pontryagin = psi_h * v + psi_v * (P / m - g) - psi_m * P / c  # Was the drag forgotten? (hint 1)
# Does the mass grow while the engine runs? (hint 1)
pontryagin = psi_h * v + psi_v * ((P - k * v**2) / m - g) + psi_m * P / c
# Where did the mass go? (hint 1)
pontryagin = psi_h * v + psi_v * (P - k * v**2 - g) - psi_m * P / c
adjoint = [0, -psi_h, psi_v * P / m**2]  # Are these the equations without drag? (hint 1)
# Which forces are divided by the mass? (hint 1)
adjoint = [0, -psi_h + 2 * k * v * psi_v / m, psi_v * P / m**2]
# Which sign precedes the derivative of $H$? (hint 1)
adjoint = [0, psi_h - 2 * k * v * psi_v / m, psi_v * (k * v**2 - P) / m**2]
transversality = [psi_h + 1]  # Is the height minimised or maximised? (hint 2)
transversality = [psi_h - 1, psi_v]  # Is the velocity free at the end? (hint 1)
transversality = [psi_h - 1, psi_m]  # Is the mass free at the end? (hint 1)
switching = psi_v  # Does a burn change the speed alone? (hint 1)
# Does full thrust maximise or minimise $H$ where this is positive? (hint 1)
switching = psi_m / c - psi_v / m
rate = -psi_h / m  # Is this the derivative without drag? (hint 2)
# Does the drag occur in two of the adjoint equations? (hint 1)
rate = -psi_h / m + 2 * k * v * psi_v / m**2
# Does the drag occur in two of the adjoint equations? (hint 1)
rate = -psi_h / m + k * v**2 * psi_v / (c * m**2)
# Where does this come from: is the exhaust speed taken as infinite? (hint 1)
surface = sp.Eq(k * v**2, m * g)
surface = sp.Eq(k * v**2 * (2 + v / c), m * g)  # Is $H$ zero on this surface, too? (hint 1)
# Does the drag act against the velocity, or along it? (hint 1)
surface = sp.Eq(k * v**2 * (1 - v / c), m * g)
control = k * v**2 + m * g  # Is the speed constant on the surface? (hint 1)
control = k * v**2  # Does the rocket stay on the surface under this thrust? (hint 1)
control = m * g  # Does the rocket stay on the surface under this thrust? (hint 1)
order = 2  # Is this the number of the derivative itself? (hint 1)
# Which power of $-1$ belongs to this order? (hint 1)
kelley = (v**2 + 4 * c * v + 2 * c**2) / (c * m**2 * v * (v + 2 * c))
kelley = -1 / (c * m**2)  # Does $P$ occur in the rates of $v$ and of $m$ alike? (hint 1)
holds = "no"  # Which of the factors could be negative? (hint 1)
law = sp.Piecewise((0, w <= v), (P_max, True))  # Is this the law without drag? (hint 1)
# Where does the speed settle under this law? (hint 1)
law = sp.Piecewise((0, w <= v), (P_max, k * v**2 < mass * g), (0, True))
# Are the two sides of the surface interchanged? (hint 1)
law = sp.Piecewise((0, w <= v), (0, k * v**2 * (1 + v / c) < mass * g), (P_max, True))
height = 0.519305  # Is this full thrust until the fuel is spent? (hint 1)
height = sp.Rational(1, 2)  # Is this the sequence of arcs that the synthesis gives? (hint 1)

# %% right
transversality = sp.Eq(psi_h, 1)  # a single equation
switching = c * psi_v - m * psi_m  # multiplied by $m c$
rate = (k * v * (v + 2 * c) * psi_v - c * m * psi_h) / (c * m**2)  # over one denominator
surface = k * v**3 + c * k * v**2 - c * g * m  # a polynomial
# with both variables
control = k * v * (3 * v + 2 * c) * (k * v**2 + m * g) / (k * v * (3 * v + 2 * c) + m * g)
# with the costate of the arc from $H = 0$
psi = m * v / (k * v**2 + m * g)
kelley = -1 / (c * m**2) - psi / m**3 * 2 * k * (1 + v / c)
# with the other form of the singular thrust
gap = k * v**3 + c * k * v**2 - c * g * mass
middle = k * v * (3 * v + 2 * c) * (k * v**2 + mass * g) / (k * v * (3 * v + 2 * c) + mass * g)
law = sp.Piecewise((0, w <= v), (P_max, gap < 0), (0, gap > 0), (middle, True))

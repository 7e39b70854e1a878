# %% wrong
# In which direction does the drag act in a fall? (hint 2)
pontryagin = psi_h * v + psi_v * (g - (P - k * v**2) / m) - psi_m * P / c
# Does the mass grow while the engine runs? (hint 1)
pontryagin = psi_h * v + psi_v * (g - (P + k * v**2) / m) + psi_m * P / c
pontryagin = psi_h * v + psi_v * (g - P / m) - psi_m * P / c  # Was the drag forgotten? (hint 2)
adjoint = [0, -psi_h, -psi_v * P / m**2]  # Are these the equations without drag? (hint 1)
# Which forces are divided by the mass? (hint 1)
adjoint = [0, -psi_h + 2 * k * v * psi_v / m, -psi_v * P / m**2]
# Which sign precedes the derivative of $H$? (hint 1)
adjoint = [0, psi_h - 2 * k * v * psi_v / m, psi_v * (P + k * v**2) / m**2]
transversality = [psi_h - 1]  # Is the height free at the end, or the mass? (hint 1)
transversality = [psi_m + 1]  # Is the final mass minimised or maximised? (hint 2)
transversality = [psi_m - 1, psi_v]  # Is the velocity free at the end? (hint 1)
switching = psi_v / m - psi_m / c  # In which direction does the thrust push here? (hint 1)
# Does full thrust maximise or minimise $H$ where this is positive? (hint 1)
switching = psi_v / m + psi_m / c
rate = psi_h / m  # Is this the derivative without drag? (hint 2)
# Do the two terms with the drag have the same sign? (hint 1)
rate = psi_h / m + k * v * (v + 2 * c) * psi_v / (c * m**2)
# Does the drag occur in two of the adjoint equations? (hint 1)
rate = psi_h / m - 2 * k * v * psi_v / m**2
surface = sp.Eq(k * v**2 * (1 + v / c), m * g)  # Is this the surface of the ascent? (hint 2)
surface = sp.Eq(k * v**2, m * g)  # Is this a steady fall, or a singular arc? (hint 1)
surface = sp.Eq(v, 2 * c)  # Is $H$ zero on this surface, too? (hint 1)
# Is this the thrust of the ascent? (hint 1)
control = k * v**2 * (v + 2 * c) * (3 * v + 2 * c) / (v**2 + 4 * c * v + 2 * c**2)
control = m * g - k * v**2  # Is the speed constant on the surface? (hint 1)
control = sp.Integer(0)  # Does a falling vehicle stay on the surface? (hint 1)
edge = sp.Eq(v, 2 * c)  # Where does the weight vanish, and where the thrust? (hint 1)
edge = sp.Eq(v, c * (2 + sp.sqrt(2)))  # Which function has its zero here? (hint 1)
thrust = sp.Piecewise((0, t < 1.536853), (2, True))  # Was the drag forgotten? (hint 2)
# What is the order of the two arcs? (hint 1)
thrust = sp.Piecewise((2, t < 0.709125), (0, True))
thrust = [[1, 2.698810]]  # Does the vehicle descend with this thrust? (hint 1)
left = 0.541462  # Was the drag forgotten? (hint 1)
left = 0.354563  # Is this the fuel that is burnt, or the mass that is left? (hint 1)
left = 0.509296  # Does the fuel depend on the time alone? (hint 1)
vacuum = 0.645437  # Is this the mass with air? (hint 1)
vacuum = sp.exp(-sp.Rational(1, 2))  # Is this a burn in an instant, at the ground? (hint 1)

# %% right
transversality = sp.Eq(psi_m, 1)  # a single equation
switching = -c * psi_v - m * psi_m  # multiplied by $m c$
rate = (c * m * psi_h + k * v * (v - 2 * c) * psi_v) / (c * m**2)  # over one denominator
surface = k * v**3 - c * k * v**2 - c * g * m  # a polynomial
# with both variables
control = k * v * (3 * v - 2 * c) * (m * g - k * v**2) / (k * v * (3 * v - 2 * c) - m * g)
thrust = [[0, 1.98968458], [2, 2.69880996]]  # a list of arcs

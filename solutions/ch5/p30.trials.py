# %% wrong
# In which direction does the axis point here? (hint 1)
pontryagin = psi_h * v + psi_v * (P / m - g) - psi_m * P / c
# Does the mass grow while the engine runs? (hint 1)
pontryagin = psi_h * v + psi_v * (g - P / m) + psi_m * P / c
# Is the mass an integral here? (hint 1)
pontryagin = psi_h * v + psi_v * (g - P / m) - psi_m * P / c + m
adjoint = [0, psi_h, psi_v * P / m**2]  # Which sign precedes the derivatives of $H$? (hint 1)
# Which sign does the thrust have in $H$, and which its derivative in $m$? (hint 1)
adjoint = [0, -psi_h, psi_v * P / m**2]
adjoint = [v, g - P / m, -P / c]  # Are these the equations of motion themselves? (hint 1)
transversality = [psi_h - 1]  # Is the height free at the end, or the mass? (hint 1)
transversality = [psi_m + 1]  # Is the final mass minimised or maximised? (hint 2)
transversality = [psi_m - 1, psi_v]  # Is the velocity free at the end? (hint 1)
switching = psi_v / m - psi_m / c  # In which direction does the thrust push here? (hint 2)
# Does full thrust maximise or minimise $H$ where this is positive? (hint 1)
switching = psi_v / m + psi_m / c
rate = -psi_h / m  # Which sign does the velocity's costate have in the switching function? (hint 1)
rate = psi_h / m - 2 * psi_v * P / (c * m**2)  # Do the two terms with the thrust add up? (hint 1)
# Does the mass in the denominator change as well? (hint 1)
rate = psi_h / m + psi_v * P / (c * m**2)
duration = c * sp.log(m0 / m_k) / g  # With which velocity does the descent begin? (hint 1)
# Does a greater velocity downwards make the landing longer? (hint 1)
duration = (c * sp.log(m0 / m_k) + v0) / g
duration = c * (m0 - m_k) / P_max  # Does the engine run all the time? (hint 1)
# Can the engine burn all fuel in an instant? (hint 2)
height = ((c * sp.log(m0 / m_k)) ** 2 - v0**2) / (2 * g)
# Which part of the flight is this? (hint 1)
s = (c * sp.log(m0 / m_k) - v0) / g - c * (m0 - m_k) / P_max
height = v0 * s + g * s**2 / 2
# Is the engine on in the first part of this descent, or in the last one? (hint 1)
height = (c**2 * sp.log(m0 / m_k) ** 2 - v0**2) / (2 * g) - c**2 / P_max * (
    m0 * sp.log(m0 / m_k) - m0 + m_k
)
law = P_max  # Is the vehicle to hover, or to land? (hint 1)
# What does gravity do during the burn? (hint 2)
law = sp.Piecewise((P_max, v >= c * sp.log(m / m_k)), (0, True))
# Is this the order for a rocket that climbs? (hint 1)
law = sp.Piecewise((P_max, m > m_k), (0, True))
# Is it worthwhile to descend at a constant speed? (hint 1)
law = sp.Piecewise((m * g, v >= 0.3), (0, True))
# Was the mass taken as a constant during the burn? (hint 2)
control = [[0, sp.sqrt(2)], [2, 2 * sp.sqrt(2)]]
control = [[2, 0.917076], [0, 2.453929]]  # What is the order of the two arcs? (hint 1)
control = [[1, 2.453929]]  # Does the vehicle descend with this thrust? (hint 1)
left = sp.exp(-sp.Rational(1, 2))  # Is this a burn in an instant, at the ground? (hint 1)
left = 0.458538  # Is this the fuel that is burnt, or the mass that is left? (hint 1)
left = 1 - 1 / sp.sqrt(2)  # Was the mass taken as a constant during the burn? (hint 1)

# %% right
transversality = sp.Eq(psi_m, 1)  # a single equation
switching = -c * psi_v - m * psi_m  # multiplied by $m c$
# the equations of the fall and of the burn, one after the other
tau = c * (m0 - m_k) / P_max
s = (c * sp.log(m0 / m_k) - v0) / g - tau
w = v0 + g * s
height = (
    v0 * s
    + g * s**2 / 2
    + w * tau
    + g * tau**2 / 2
    - c**2 / P_max * (m0 - m_k - m_k * sp.log(m0 / m_k))
)
# the remaining time for the burn compared with its duration
law = P_max * sp.Heaviside(c * (m - m_k) / P_max - (c * sp.log(m / m_k) - v) / g, 1)
control = [[0, 1.536853414], [2, 2.453929358]]  # a list of arcs

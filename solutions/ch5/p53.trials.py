# %% wrong
pontryagin = psi_x * v + psi_v * P / m - psi_m * P / c  # Was the drag forgotten? (hint 1)
# Is the range an integral here? (hint 1)
pontryagin = x + psi_x * v + psi_v * (P - Q) / m - psi_m * P / c
# Does the mass grow while the engine runs? (hint 1)
pontryagin = psi_x * v + psi_v * (P - Q) / m + psi_m * P / c
# Does the drag depend on the mass? (hint 2)
adjoint = [0, -psi_x + sp.diff(Q, v) / m * psi_v, psi_v * (P - Q) / m**2]
# Which sign precedes the derivatives of $H$? (hint 1)
adjoint = [0, psi_x - sp.diff(Q, v) / m * psi_v, -psi_v * ((P - Q) / m**2 + sp.diff(Q, m) / m)]
# Does the drag depend on the speed? (hint 1)
adjoint = [0, -psi_x, psi_v * (P - Q) / m**2 + psi_v * sp.diff(Q, m) / m]
printed_end = [psi_x - 1]  # Is the speed given at the end, as printed? (hint 1)
printed_end = [psi_x - 1, psi_v, psi_m]  # Is the mass free at the end? (hint 1)
# Which sign does the terminal cost have if it is minimised? (hint 2)
printed_end = [psi_x + 1, psi_v]
end = [psi_x - 1, psi_v]  # Is the speed still free at the end? (hint 1)
end = [psi_x + 1]  # Which sign belongs to a range that is maximised? (hint 1)
switching = psi_v  # Does a burn change the speed alone? (hint 1)
# Does full thrust maximise or minimise $H$ where this is positive? (hint 1)
switching = psi_m / c - psi_v / m
rate = -psi_x / m  # Is this the derivative without drag? (hint 1)
# Was the drag in the equation for $\psi_m$ forgotten? (hint 1)
rate = -psi_x / m + psi_v / m**2 * sp.diff(Q, v)
# Does the drag depend on the mass? (hint 1)
rate = -psi_x / m + psi_v / m**2 * (sp.diff(Q, v) + Q / c)
surface = sp.Eq(a * v**4, 3 * b * m**2)  # Does the exhaust speed not matter? (hint 1)
surface = sp.Eq(a * v**4, b * m**2)  # Is this the speed of the minimum drag? (hint 1)
# Is $H$ zero on this surface, too? (hint 2)
surface = sp.Eq(a * v**4 * (1 + v / c), b * m**2 * (1 - v / c))
control = Q  # Is the speed constant on the surface? (hint 1)
control = sp.Integer(0)  # Does the aircraft stay on the surface without thrust? (hint 1)
# With which sign does the thrust change the mass? (hint 1)
S = v * sp.diff(Q, v) - Q + v / c * (Q - m * sp.diff(Q, m))
control = c * Q * sp.diff(S, v) / (c * sp.diff(S, v) + m * sp.diff(S, m))
power_surface = sp.Eq(v * q, c * (p - 1))  # Was a term with $Q/c$ forgotten? (hint 1)
power_surface = sp.Eq(
    v, c * (q - 1) / (p - 1)
)  # Which exponent belongs to which derivative? (hint 1)
power_control = sp.Integer(0)  # Does the aircraft keep its speed without thrust? (hint 1)
power_control = p * power_drag / q  # Is the speed constant with this thrust? (hint 1)
power_kelley = True  # Was the sign tested on the surface itself? (hint 1)
glide = m / (2 * a) * sp.log(v1 / v2)  # Was the second part of the drag forgotten? (hint 1)
# Is this a time, or a distance? (hint 1)
glide = m / (4 * a) * sp.log((a * v1**4 + b * m**2) / (a * v2**4 + b * m**2)) / v1
# At which speed does this glide end? (hint 1)
glide = m / (4 * a) * sp.log(1 + a * v1**4 / (b * m**2))
# Is it worthwhile to become as fast as possible? (hint 1)
law = sp.Piecewise((0, w <= v), (P_max, True))
# Where does the speed settle under this law? (hint 1)
law = sp.Piecewise((0, w <= v), (P_max, a * v**4 < b * mass**2), (0, True))
# Are the two sides of the surface interchanged? (hint 1)
law = sp.Piecewise(
    (0, w <= v), (0, a * v**4 * (1 + v / c) < b * mass**2 * (3 + v / c)), (P_max, True)
)
way = 1.315701  # Is this full thrust until the fuel is spent? (hint 1)
way = 1.26526  # Does the flight end when the fuel does? (hint 2)

# %% right
end = sp.Eq(psi_x, 1)  # a single equation
switching = c * psi_v - m * psi_m  # multiplied by $m c$
# with the drag as it stands
rate = (
    psi_v / m**2 * (2 * a * v - 2 * b * m**2 / v**3 + (a * v**2 - b * m**2 / v**2) / c) - psi_x / m
)
surface = a * v**4 * (c + v) - b * m**2 * (3 * c + v)  # a polynomial
# with both variables
S = v * sp.diff(Q, v) - Q + v / c * (Q - m * sp.diff(Q, m))
control = c * Q * sp.diff(S, v) / (c * sp.diff(S, v) - m * sp.diff(S, m))
power_surface = v / c - (p - 1) / (q - 1)  # a difference
# with what holds on the surface
power_control = power_drag * v * (q - 1) / (c * (p - 1))
# two logarithms
glide = m / (4 * a) * (sp.log(a * v1**4 / m**2 + b) - sp.log(a * v2**4 / m**2 + b))

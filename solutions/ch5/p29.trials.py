# %% wrong
# Which force besides the thrust acts on the rocket? (hint 1)
pontryagin = psi_h * v + psi_v * P / m - psi_m * P / c
# Does the mass grow while the engine runs? (hint 1)
pontryagin = psi_h * v + psi_v * (P / m - g) + psi_m * P / c
# Is the height an integral here? (hint 1)
pontryagin = h + psi_h * v + psi_v * (P / m - g) - psi_m * P / c
adjoint = [0, psi_h, -psi_v * P / m**2]  # Which sign precedes the derivatives of $H$? (hint 1)
adjoint = [0, -psi_h, 0]  # Does $H$ depend on the mass? (hint 1)
adjoint = [v, P / m - g, -P / c]  # Are these the equations of motion themselves? (hint 1)
transversality = [psi_h + 1]  # Is the height minimised or maximised? (hint 2)
transversality = [psi_h - 1, psi_v]  # Is the velocity free at the end? (hint 1)
transversality = [psi_h - 1, psi_m]  # Is the mass free at the end? (hint 1)
transversality = [psi_v, psi_m]  # Which of the states has no given value at the end? (hint 1)
switching = psi_v  # Does a burn change the speed alone? (hint 1)
# Does full thrust maximise or minimise $H$ where this is positive? (hint 1)
switching = psi_m / c - psi_v / m
switching = psi_v / m + psi_m / c  # Does the mass grow while the engine runs? (hint 1)
rate = -psi_h / m + psi_v * P / (c * m**2)  # Was the equation for $\psi_m$ inserted? (hint 1)
# Does the mass in the denominator change as well? (hint 1)
rate = -psi_h / m - psi_v * P / (c * m**2)
rate = psi_h / m  # Is the sign in the adjoint equation of the velocity right? (hint 1)
duration = c * (m0 - m_T) / P_max  # Does the flight end when the fuel is spent? (hint 2)
duration = c * sp.log(m0 / m_T) / g  # With which velocity does the flight begin? (hint 1)
# Can the engine burn all fuel in an instant? (hint 1)
height = (v0 + c * sp.log(m0 / m_T)) ** 2 / (2 * g)
# Where is the rocket when the coast begins? (hint 1)
height = (v0 + c * sp.log(m0 / m_T) - g * c * (m0 - m_T) / P_max) ** 2 / (2 * g)
# Is the rocket at rest when the fuel is spent? (hint 1)
tau = c * (m0 - m_T) / P_max
height = v0 * tau - g * tau**2 / 2 + c**2 / P_max * (m0 - m_T - m_T * sp.log(m0 / m_T))
law = P_max  # What happens when the fuel is spent? (hint 2)
law = sp.Piecewise((m * g, m > m_T), (0, True))  # Is it worthwhile to save thrust? (hint 1)
# Does the switching depend on the velocity? (hint 2)
law = sp.Piecewise((P_max, v <= 0.2), (0, True))

# %% right
transversality = sp.Eq(psi_h, 1)  # a single equation
switching = c * psi_v - m * psi_m  # multiplied by $m c$
rate = -1 / m  # with the constant value of the costate
# in the speed and the height at the end of the burn
L, tau = sp.log(m0 / m_T), c * (m0 - m_T) / P_max
end = v0 + c * L - g * tau
height = tau * (v0 + end) / 2 + end**2 / (2 * g) + c * tau - c**2 / P_max * L * (m0 + m_T) / 2
law = P_max * sp.Heaviside(m - m_T, 0)  # a step

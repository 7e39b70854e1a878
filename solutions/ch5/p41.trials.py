# %% wrong
# Is the area itself to be minimised? (hint 1)
a_pontryagin = psi_x * (v * sp.cos(theta) - V) + psi_y * v * sp.sin(theta) - sweep(theta)
# Does the wind carry the aircraft?
a_pontryagin = psi_x * v * sp.cos(theta) + psi_y * v * sp.sin(theta) + sweep(theta)
a_adjoint = [0, 0]  # Does the integral contain the coordinates? (hint 1)
# Which sign precedes the derivative of $H$? (hint 1)
a_adjoint = [v * sp.sin(theta) / 2, -(v * sp.cos(theta) - V) / 2]
# Does the integrand of the area contain the wind? (hint 1)
a_adjoint = [-v * sp.sin(theta) / 2, v * sp.cos(theta) / 2]
a_maximum = sp.atan2(psi_y, psi_x)  # Does the heading enter the cost, too? (hint 1)
# Which of two opposite headings does this give? (hint 2)
a_maximum = sp.atan((psi_y + x / 2) / (psi_x - y / 2))
a_maximum = sp.atan2(psi_y - x / 2, psi_x + y / 2)  # Which sign does the area have in $H$? (hint 1)
b_pace = T / (2 * sp.pi)  # Where does a flight that turns uniformly end in this wind? (hint 3)
# Is the pace proportional to the distance from the fixed point, or to its square? (hint 3)
b_pace = T * sp.sqrt(v**2 - V**2) / (2 * sp.pi * (v - V * sp.cos(theta)))
# On which heading is the aircraft far from the focus? (hint 2)
b_pace = T * (v**2 - V**2) ** sp.Rational(3, 2) / (2 * sp.pi * v * (v + V * sp.cos(theta)) ** 2)
b_across = T * (v**2 - V**2) / (sp.pi * v)  # Which of the two axes lies across the wind? (hint 1)
b_across = v * T / sp.pi  # Is this the flight without wind? (hint 2)
b_along = T * sp.sqrt(v**2 - V**2) / sp.pi  # Which of the two axes lies along the wind? (hint 1)
b_along = T * (v - V) / sp.pi  # Does the wind act against the aircraft all the way round? (hint 1)
b_area = v**2 * T**2 / (4 * sp.pi)  # Is this the area without wind? (hint 1)
b_area = T**2 * (v**2 - V**2) / (4 * sp.pi)  # Is the loop a circle, flown at a mean speed? (hint 1)

# %% right
# opposite to the heading where $H$ has its minimum
a_maximum = sp.pi + sp.atan2(-psi_y - x / 2, y / 2 - psi_x)
# by the eccentricity
b_pace = (
    T * (1 - (V / v) ** 2) ** sp.Rational(3, 2) / (2 * sp.pi * (1 - V / v * sp.cos(theta)) ** 2)
)
b_across = T * v * sp.sqrt(1 - (V / v) ** 2) / sp.pi  # by the eccentricity
b_along = T * (v - V**2 / v) / sp.pi  # as a difference
b_area = T**2 * v**2 * (1 - (V / v) ** 2) ** sp.Rational(3, 2) / (4 * sp.pi)  # by the eccentricity

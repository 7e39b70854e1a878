# %% wrong
# What is integrated to get the time? (hint 1)
pontryagin = psi1 * v_x + psi2 * v_y + a * (psi3 * sp.cos(theta) + psi4 * sp.sin(theta))
# From which axis is the angle measured?
pontryagin = psi1 * v_x + psi2 * v_y + a * (psi3 * sp.sin(theta) + psi4 * sp.cos(theta)) - 1
transversality = [psi3]  # Is the final speed free, or the range? (hint 1)
transversality = [psi1, psi3 - 1]  # Is the speed a cost here, or a condition? (hint 1)
transversality = [psi2]  # Is the height at the end free? (hint 1)
slope = 2 * a * sp.tan(theta0) / U  # Is this the time that the speed alone would take? (hint 2)
# Does the thrust stop at the horizon, or go below it? (hint 1)
slope = a * sp.asinh(sp.tan(theta0)) / U
duration = U / a  # Does all of the thrust go into the speed along the line? (hint 1)
duration = U / (a * sp.cos(theta0))  # Does the thrust keep one inclination all the time? (hint 1)
# What is the angle of the thrust at the end? (hint 1)
duration = U * sp.tan(theta0) / (2 * a * sp.asinh(sp.tan(theta0)))
# Does the thrust keep one inclination in each half of the time? (hint 1)
height = U**2 * sp.tan(theta0) / (4 * a)
# Was one of the two times in the square of $T$ left out? (hint 1)
height = (
    U
    / (4 * a)
    * (sp.tan(theta0) / sp.cos(theta0) - sp.asinh(sp.tan(theta0)))
    / sp.asinh(sp.tan(theta0))
)
angle = 45.9  # Is this the plan with two directions? (hint 1)
angle = 1.114  # In which unit is the angle required?
angle = 26.18  # From which axis is the angle measured?
time = 3.675  # Does the ascent take no time? (hint 1)
time = 4.472  # Is this the time of the ascent alone? (hint 1)
time = 512.4  # In which unit is the time required?
law = 1.1138 - 0.43473 * t  # Is it the angle that falls linearly, or its tangent?
law = 1.1138  # Is the rocket level at the end, if the thrust never points down?

# %% right
slope = a / U * sp.log((1 + sp.sin(theta0)) / (1 - sp.sin(theta0)))  # by the logarithm
# by the logarithm
duration = 2 * U * sp.tan(theta0) / (a * sp.log((1 + sp.sin(theta0)) / (1 - sp.sin(theta0))))
angle = 63.8  # three digits
law = sp.atan(2.0339 - 0.79384 * t)  # in decimals

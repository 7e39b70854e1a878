# %% wrong
# Where is the cost? (hint 1)
pontryagin = psi1 * v_x + psi2 * v_y + a * (psi3 * sp.cos(theta) + psi4 * sp.sin(theta))
# From which axis is the angle measured?
pontryagin = psi1 * v_x + psi2 * v_y + a * (psi3 * sp.sin(theta) + psi4 * sp.cos(theta)) - 1
adjoint = [0, 0, psi1, psi2]  # Which sign precedes the derivative of $H$? (hint 1)
# Which states does $H$ contain, the positions or the velocities? (hint 1)
adjoint = [-psi3, -psi4, 0, 0]
direction = sp.atan(psi4 / psi3)  # Try a thrust that has to point backwards. (hint 2)
direction = sp.atan2(-psi4, -psi3)  # Does this maximise or minimise $H$? (hint 1)
rest_time = sp.sqrt(2 * sp.sqrt(x0**2 + y0**2) / a)  # Does the ship stop at its target? (hint 2)
# Is half of the distance covered in this half of the time? (hint 2)
rest_time = 2 * sp.sqrt(2 * sp.sqrt(x0**2 + y0**2) / a)
rest_control = sp.atan2(-y0, -x0)  # Does the ship come to a stop with this? (hint 1)
# In which direction does the ship move first? (hint 1)
half = (x0**2 + y0**2) ** sp.Rational(1, 4) / sp.sqrt(a)
rest_control = sp.Piecewise((sp.atan2(y0, x0), t < half), (sp.atan2(y0, x0) + sp.pi, True))
# Is the costate along the position vector, or along the thrust? (hint 1)
far = sp.sqrt(x0**2 + y0**2)
rest = 2 * sp.sqrt(far / a)
rest_costate = [
    2 * x0 / (a * rest * far),
    2 * y0 / (a * rest * far),
    x0 * (1 - 2 * t / rest) / (a * far),
    y0 * (1 - 2 * t / rest) / (a * far),
]
# Does $H$ vanish at the end with these? (hint 2)
far = sp.sqrt(x0**2 + y0**2)
rest = 2 * sp.sqrt(far / a)
rest_costate = [
    -2 * x0 / (rest * far),
    -2 * y0 / (rest * far),
    -x0 * (1 - 2 * t / rest) / far,
    -y0 * (1 - 2 * t / rest) / far,
]
# What does a ship do that is too fast to stop at the target? (hint 2)
line_time = (w + sp.sqrt(2 * w**2 + 4 * a * rho)) / a
line_time = 2 * sp.sqrt(rho / a)  # Was the initial velocity forgotten? (hint 1)
beside_time = 2.986727  # Does the ship stop at its target? (hint 1)
angle = sp.atan2(-2, -1)  # Does the thrust keep its direction? (hint 1)
# Is the thrust reversed at once if the velocity does not point at the target? (hint 1)
angle = sp.Piecewise((sp.atan2(-2, -1), t < 1.93), (sp.atan2(2, 1), True))

# %% right
# the second direction by its own signs
half = sp.sqrt(sp.sqrt(x0**2 + y0**2) / a)
rest_control = [[sp.atan2(-y0, -x0), half], [sp.atan2(y0, x0), 2 * half]]

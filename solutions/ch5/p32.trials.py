# %% wrong
a_transversality = [psi1, psi3 + 1]  # Is the final speed maximised or minimised? (hint 2)
a_transversality = [psi1, psi3 - 1, psi4]  # Is the vertical speed at the end free? (hint 1)
a_transversality = [psi1, psi2, psi3 - 1]  # Is the height at the end free? (hint 1)
# Where does the thrust point at the end, and can the rocket be level then? (hint 2)
a_law = mu * (T - t)
a_law = T / 2 - t  # Is height worth as much as speed, whatever its price? (hint 1)
a_law = mu * (t - T / 2)  # Does the rocket begin with a dive? (hint 1)
# Which vertical speed is left if the thrust is never below the horizontal? (hint 1)
a_slope = sp.tan(theta0) / T
a_slope = 2 * theta0 / T  # Is it the angle that falls linearly, or its tangent?
# What is the vertical speed of the rocket when it gets there? (hint 1)
a_shortest = sp.sqrt(2 * h / a)
a_shortest = sp.sqrt(h / a)  # How far does the rocket get in one half of the time? (hint 1)
# Was the time replaced everywhere, or is its derivative a constant? (hint 1)
b_motion = [
    a / c**2 * (sp.cos(theta) - sp.cos(theta0)),
    a / c**2 * (sp.sin(theta0) - sp.sin(theta)),
    a / c * (sp.sin(theta0) - sp.sin(theta)),
    a / c * (sp.cos(theta) - sp.cos(theta0)),
]
# Does the angle grow or fall while the time grows? (hint 1)
tau, tau0 = sp.tan(theta), sp.tan(theta0)
sigma, sigma0 = 1 / sp.cos(theta), 1 / sp.cos(theta0)
ell, ell0 = sp.asinh(tau), sp.asinh(tau0)
b_motion = [
    a / c**2 * (sigma0 - sigma - tau * (ell0 - ell)),
    a / c**2 * (sigma0 * (tau0 - tau) - (sigma0 * tau0 - sigma * tau + ell0 - ell) / 2),
    a / c * (ell - ell0),
    a / c * (sigma - sigma0),
]
# Does the rocket keep one direction in each half of the time? (hint 1)
b_height = a * T**2 / 4 * sp.sin(theta0)
# What is the angle of the thrust at the end: does it point along the line? (hint 1)
b_height = (
    a
    * T**2
    / (2 * sp.tan(theta0) ** 2)
    * (sp.tan(theta0) / sp.cos(theta0) - sp.asinh(sp.tan(theta0)))
)
b_speed = a * T * sp.cos(theta0)  # Does the rocket keep one inclination all the time? (hint 1)
# Does the angle stop at zero, or does it go on? (hint 1)
b_speed = a * T * sp.asinh(sp.tan(theta0)) / (2 * sp.tan(theta0))
b_angle = 30  # Is this the plan with two directions? (hint 1)
b_angle = 36.87  # Is the angle small enough for the first term of the series? (hint 1)
b_angle = 0.738  # In which unit is the angle required?
b_best = 3.464  # Is this the plan with two directions? (hint 1)
b_best = 4.0  # Is this the speed without any ascent? (hint 1)
b_best = 2.959  # Does the rocket keep one inclination all the time? (hint 1)

# %% right
a_transversality = sp.And(sp.Eq(psi1, 0), sp.Eq(psi3, 1)).args  # equations
a_slope = sp.tan(theta0) / (T / 2)  # over the half of the time
# with one logarithm
logarithm = sp.log((1 + sp.sin(theta0)) * sp.cos(theta) / ((1 + sp.sin(theta)) * sp.cos(theta0)))
tau, sigma = sp.tan(theta), sp.sec(theta)
tau0, sigma0 = sp.tan(theta0), sp.sec(theta0)
b_motion = [
    a / c**2 * (sigma0 - sigma - tau * logarithm),
    a / (2 * c**2) * ((tau0 - tau) * sigma0 - tau * (sigma0 - sigma) - logarithm),
    a / c * logarithm,
    a / c * (sigma0 - sigma),
]
# by the logarithm
b_speed = a * T / (2 * sp.tan(theta0)) * sp.log((1 + sp.sin(theta0)) / (1 - sp.sin(theta0)))
b_angle = 42.3  # three digits

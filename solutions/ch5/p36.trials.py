# %% wrong
# In which direction does gravity act?
pontryagin = psi1 * v_x + psi2 * v_y + a * (psi3 * sp.cos(theta) + psi4 * sp.sin(theta)) + g * psi4
# Was the gravity left out? (hint 1)
pontryagin = psi1 * v_x + psi2 * v_y + a * (psi3 * sp.cos(theta) + psi4 * sp.sin(theta))
adjoint = [0, 0, -psi1, -psi2 - g]  # Is gravity multiplied by a state in $H$? (hint 1)
adjoint = [0, 0, psi1, psi2]  # Which sign precedes the derivative of $H$?
# Is a large coordinate with a positive weight good or bad?
transversality = [psi1 + k1, psi2 + k2, psi3 + k3, psi4 + k4]
transversality = [psi1, psi2, psi3, psi4]  # Does the cost not depend on the final state? (hint 1)
# Is the cosine of your angle ever negative? (hint 2)
angle = sp.atan((k4 + k2 * (T - t)) / (k3 + k1 * (T - t)))
# Does the gravity term depend on the angle? (hint 1)
angle = sp.atan2(k4 + k2 * (T - t) + g / a, k3 + k1 * (T - t))
angle = sp.atan2(k4 - k2 * t, k3 - k1 * t)  # At which end are the values of the costates known?
# Does the gravity term depend on the angle? (hint 1)
tangent = (k4 + k2 * (T - t)) / (k3 + k1 * (T - t)) + g / a
# Which component of the thrust is in the numerator of a tangent? (hint 1)
tangent = (k3 + k1 * (T - t)) / (k4 + k2 * (T - t))
shortest = 2 * sp.sqrt(h / a)  # Is this the time without gravity? (hint 1)
shortest = 2 * sp.sqrt(h / (a - g))  # Does the rocket brake as slowly as it gains speed? (hint 1)
# What is the vertical speed of the rocket when it gets there? (hint 1)
shortest = sp.sqrt(2 * h / (a - g))
# Is the vertical speed zero at the end with this angle, if gravity acts? (hint 1)
last = -sp.tan(theta0)
last = sp.tan(theta0)  # Which of the two roots is the known one? (hint 2)
# What is the coefficient of the square? (hint 2)
last = 2 * g * (a / sp.cos(theta0) - g * sp.tan(theta0)) / a**2 - sp.tan(theta0)
# Is the last angle the opposite of the first one? (hint 1)
height = (
    a
    * T**2
    / (4 * sp.tan(theta0) ** 2)
    * (sp.tan(theta0) / sp.cos(theta0) - sp.asinh(sp.tan(theta0)))
)
# Was an integral left out? (hint 1)
tau0, tau1 = sp.tan(theta0), sp.tan(theta1)
height = a * T**2 / (2 * (tau0 - tau1) ** 2) * (tau0 / sp.cos(theta1) - tau1 / sp.cos(theta0))
# Is the last angle the opposite of the first one? (hint 1)
speed = a * T * sp.asinh(sp.tan(theta0)) / sp.tan(theta0)
# Does the angle fall linearly, or its tangent? (hint 1)
speed = a * T * (sp.sin(theta0) - sp.sin(theta1)) / (theta0 - theta1)
first_angle = 42.3  # Is this the angle without gravity? (hint 1)
first_angle = 1.209  # In which unit is the angle required?
first_angle = 29.37  # Does a rocket with this angle climb, or fly level? (hint 1)
best = 3.588  # Is this the speed without gravity? (hint 1)
best = 3.486  # Is this the speed in level flight? (hint 1)

# %% right
# sum and difference
transversality = [psi1 - k1, psi2 - k2, psi3 + psi4 - k3 - k4, psi3 - psi4 - k3 + k4]
angle = sp.arg(k3 + k1 * (T - t) + sp.I * (k4 + k2 * (T - t))) + 2 * sp.pi  # another turn
# by the sine of the angle at which the rocket holds its height
hover = g / a
last = (2 * hover / sp.cos(theta0) - (1 + hover**2) * sp.tan(theta0)) / (1 - hover**2)
# by the logarithm
first, final = ((1 + sp.sin(q)) / (1 - sp.sin(q)) for q in (theta0, theta1))
speed = a * T * sp.log(first / final) / (2 * (sp.tan(theta0) - sp.tan(theta1)))
first_angle = 69.3  # three digits
best = 2.81  # three digits

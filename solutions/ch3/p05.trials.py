# %% wrong
# Is this the hanging pendulum? To which side must a stick lean to be carried along? (hint 1)
angles = [-sp.atan(w / g) + 2 * sp.pi * n, sp.pi - sp.atan(w / g) + 2 * sp.pi * n]
# Is there only one direction along which the rod can rest? (hint 2)
angles = [sp.atan(w / g) + 2 * sp.pi * n]
# Was the acceleration of the cart left out? (hint 1)
angles = [
    2 * sp.pi * n,
    sp.pi + 2 * sp.pi * n,
]
# Is this a pendulum on a cart at rest? What does the lean change?
matrix = sp.Matrix([[0, 1], [g / l, 0]])
# Does the moment of the inertial force change with the angle, too? (hint 1)
matrix = sp.Matrix([[0, 1], [g * sp.cos(phis) / l, 0]])
# Near which of the two positions does gravity draw the pendulum back, and near which away?
matrix = sp.Matrix([[0, 1], [-g / (l * sp.cos(phis)), 0]])
# Does an acceleration of the cart act fully on a pendulum that leans?
inputs = sp.Matrix([0, -1 / l])
# In the frame of the cart, to which side does the inertial force point?
inputs = sp.Matrix([0, sp.cos(phis) / l])
# Multiply A by the column B once more: what does its first line give?
control_matrix = sp.Matrix([[0, -b], [-b, kappa]])
# What is the order of the columns of Kalman's matrix? (hint 1)
control_matrix = sp.Matrix([[-b, 0], [0, -b]])
# Is there a stiffness, or its opposite, in the pendulum itself? (hint 1)
angle_gain = sp.Matrix([beta1, beta2])
# Is this for the hanging pendulum? Mind the sign of the stiffness here.
angle_gain = sp.Matrix([beta1, beta2 - kappa])
# Is a correction of the first line alone enough for a motion that grows? (hint 2)
angle_observer = [e2 + (z - e1), kappa * e1 - b * u]
# Does the copy contain the control of the pendulum? (hint 1)
angle_observer = [e2 + (z - e1), kappa * z + (z - e1)]
# Mind a sign: what is the determinant of the matrix of the errors? (hint 1)
speed_gain = sp.Matrix([1 - beta2 / kappa, beta1])
# Is this the gain for a measured angle? Here the rate is measured. (hint 1)
speed_gain = sp.Matrix([beta1, beta2 + kappa])
# Is friction alone enough to stop an error that grows? (hint 1)
speed_observer = [e2, kappa * e1 - b * u + (z - e2)]
# To which side does the control push the pendulum?
speed_observer = [2 * z - e2, kappa * e1 + b * u + (z - e2)]
# What is the sign of the last coefficient of the characteristic polynomial? (hint 2)
a_gain = sp.Matrix([beta1 - beta3 / kappa, beta2 + kappa, beta3 / kappa])
# Is the system in canonical form? Compare the coefficients one by one. (hint 1)
a_gain = sp.Matrix([beta1, beta2 + kappa, beta3])
# Which sign must the product of the roots have, and what follows for the third gain? (hint 1)
a_observer = [e2 + 3 * (z - e1 - e3), kappa * e1 - b * u + 2 * kappa * (z - e1 - e3), z - e1 - e3]
# What would the instrument show if the estimates were right? (hint 1)
a_observer = [e2 + 3 * (z - e1), kappa * e1 - b * u + 2 * kappa * (z - e1), -(z - e1)]
# What is the sign of the last coefficient of the characteristic polynomial? (hint 2)
b_gain = sp.Matrix([1 + beta2 / kappa, beta1 - beta3 / kappa, beta3 / kappa])
# Is this the gain for the angle with an offset? Here the rate is measured. (hint 1)
b_gain = sp.Matrix([beta1 + beta3 / kappa, beta2 + kappa, -beta3 / kappa])

# %% right
angles = [sp.asin(w / sp.sqrt(g**2 + w**2)) + sp.pi * n]  # both in one family
# before the fraction is reduced
matrix = sp.Matrix([[0, 1], [(g * sp.cos(phis) + g * sp.tan(phis) * sp.sin(phis)) / l, 0]])
inputs = sp.Matrix([[0], [-sp.sin(sp.pi / 2 - phis) / l]])  # by the sine
control_matrix = -b * sp.Matrix([[0, 1], [1, 0]])  # a multiple of a permutation
angle_observer = [e2 + 3 * (z - e1), kappa * e1 - b * u + (5 + 2 * kappa) * (z - e1)]  # other gains
speed_gain = sp.Matrix([(kappa + beta2) / kappa, beta1])  # over one denominator
# other gains, with a decimal
speed_observer = [
    e2 + 4 * (z - e2),
    kappa * e1 - b * u + 2.5 * (z - e2),
]
a_gain = [beta1 + beta3 / kappa, beta2 + kappa, -beta3 / kappa]  # a flat list
# other gains, the second one with a number
a_observer = [
    e2 + 5 * (z - e1 - e3),
    kappa * e1 - b * u + (1 + 3 * kappa) * (z - e1 - e3),
    (e1 + e3 - z) / 2,
]

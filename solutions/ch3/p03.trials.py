# %% wrong
# Does the pendulum lean forward or backward when the suspension is accelerated? (hint 1)
a_angles = [sp.atan(w / g) + 2 * sp.pi * n, sp.pi + sp.atan(w / g) + 2 * sp.pi * n]
# Was the acceleration of the suspension forgotten? (hint 1)
a_angles = [2 * sp.pi * n, sp.pi + 2 * sp.pi * n]
# Is there another equilibrium, opposite to this one? (hint 2)
a_angles = [-sp.atan(w / g) + 2 * sp.pi * n]
a_unstable = [-sp.atan(w / g) + 2 * sp.pi * n]  # Is this the hanging position? (hint 1)
b_deviation = -g / l * psi  # Is this the equation of a pendulum on a suspension at rest? (hint 1)
# What is the sign of the derivative of the cosine? (hint 1)
b_deviation = -(g * sp.cos(phis) + w * sp.sin(phis)) / l * psi
# Is this the sign for an inverted pendulum? (hint 1)
b_deviation = (g * sp.cos(phis) - w * sp.sin(phis)) / l * psi
c_angle_gain = sp.Matrix([beta1, beta2])  # Was gravity forgotten? (hint 1)
c_angle_gain = sp.Matrix([beta1, beta2 + k])  # What is the sign of k in the polynomial? (hint 1)
c_angle_observer = [e2, -k * e1]  # Do the errors decay without any correction? (hint 1)
# Is a spring added to the errors where friction is needed? (hint 1)
c_angle_observer = [e2, -k * e1 + (z - e1)]
# Is the measurement fed in, or its difference from what is expected? (hint 1)
c_angle_observer = [e2 + z, -k * e1]
c_speed_observable = sp.true  # Does the rate determine the angle for every equation? (hint 2)
c_speed_observable = k > 0  # Does a pendulum have to hang to be observable? (hint 1)
c_speed_gain = sp.Matrix([beta1, beta2 - k])  # Is this the gain for a measured angle? (hint 1)
c_speed_gain = sp.Matrix([1 + beta2 / k, beta1])  # Was a sign lost in the determinant? (hint 1)
# Does a correction of the first equation damp the errors here? (hint 1)
c_speed_observer = [e2 + (z - e2), -k * e1]
c_speed_observer = [e2, -k * e1 + (z - e1)]  # Is a rate compared with an angle here? (hint 1)
# Does the initial error decay if the measured rate is only integrated? (hint 1)
c_speed_observer = [z, -k * e1 + 7 * (z - e2)]

# %% right
# by the arcsine
a_angles = [
    -sp.asin(w / sp.sqrt(g**2 + w**2)) + 2 * sp.pi * n,
    sp.pi * (2 * n + 1) - sp.asin(w / sp.sqrt(g**2 + w**2)),
]
# with the tilted gravity
b_deviation = -psi / l * sp.sqrt(g**2 + w**2) * sp.cos(phis + sp.atan(w / g))
# the angle itself in the second equation
c_angle_observer = [e2 + 4 * (z - e1), -k * z + 2 * (z - e1)]
c_angle_observer = [2 * z - 2 * e1 + e2, -k * e1 + 3.5 * (z - e1)]  # both corrected
c_speed_observable = sp.Or(k < 0, k > 0)  # either sign
c_speed_gain = sp.Matrix([(k - beta2) / k, beta1])  # over one denominator
# the mean of the measured rate and its estimate
c_speed_observer = [(z + e2) / 2, -k * e1 + 7 * (z - e2)]

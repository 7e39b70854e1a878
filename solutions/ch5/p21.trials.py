# %% wrong
a_control = 2 * t / 9  # Is this the control for one duration only? (hint 2)
a_control = 1 / T  # Does this constant push reach the place, too? (hint 1)
a_motion = t**2 / (2 * T)  # Is the place at the end the given one? (hint 1)
a_motion = t**3 / 27  # Is this the motion for one duration only? (hint 1)
a_effort = (T**2 - 3 * T + 3) / T**3  # Was a factor lost in the integral? (hint 1)
a_effort = sp.Rational(2, 9)  # Is this the effort for one duration only? (hint 1)
a_still = 2  # Is this where the control becomes constant? (hint 1)
a_still = sp.Rational(3, 2)  # Is this the time of another item? (hint 1)
a_best = "yes"  # Is a stationary point always a minimum? (hint 1)
b_control = (6 - 2 * T) / T**2 + (6 * T - 12) * t / T**3  # Is this the control of item a? (hint 1)
b_control = 4 * t / T**2  # Does this reach the place in every duration? (hint 1)
b_motion = (3 - T) * t**2 / T**2 + (T - 2) * t**3 / T**3  # Is this the motion of item a? (hint 1)
b_motion = t**2 / T**2  # Which velocity does this motion have at the end? (hint 1)
b_effort = 2 * (T**2 - 3 * T + 3) / T**3  # Is this the effort of item a? (hint 1)
b_effort = 8 / T  # Is this only how the effort behaves for long durations? (hint 1)
b_still = 3  # Is this the time of item a? (hint 1)
b_still = 1  # Is this where the control becomes constant? (hint 1)
b_best = "yes"  # Does the derivative change its sign? (hint 1)
c_control = t / 6  # Is this the control for one duration only? (hint 1)
c_control = (36 - 6 * T) / T**2  # Was the part that grows with time forgotten? (hint 1)
c_motion = t**3 / 36  # Is this the motion for one duration only? (hint 1)
c_motion = 6 * t**2 / T**2  # Which velocity does this motion have at the end? (hint 1)
c_effort = 36 * (T**2 - 6 * T + 12) / T**3  # Was the half before the integral forgotten? (hint 1)
c_effort = sp.Integer(1)  # Is this the effort for one duration only? (hint 1)
c_still = 4  # Is this where the control becomes constant? (hint 1)
c_still = 2  # Is this the place divided by the velocity? (hint 1)
c_best = "yes"  # What is the effort for a still longer duration? (hint 1)
# Which sign has the mixed term? (hint 1)
d_effort = 2 * (3 * X**2 + 3 * X * V * T + V**2 * T**2) / T**3
d_effort = 6 * X**2 / T**3  # Was the velocity at the end forgotten? (hint 1)

# %% right
a_control = (6 * T - 2 * T**2 + 6 * T * t - 12 * t) / T**3  # over one denominator
a_control = [[2 * (3 - T) / T**2 + 6 * (T - 2) * t / T**3, T]]  # a list of one arc
# both states
a_motion = [
    t**2 * ((3 - T) * T + (T - 2) * t) / T**3,
    t * (2 * (3 - T) * T + 3 * (T - 2) * t) / T**3,
]
a_effort = 2 / T - 6 / T**2 + 6 / T**3  # powers
a_still = 3.0  # a decimal
a_best = False  # a truth value
b_control = 2 * (3 * T - 2 * T**2 + 6 * (T - 1) * t) / T**3  # over one denominator
b_motion = t**2 * (3 * T - 2 * T**2 + 2 * (T - 1) * t) / T**3  # over one denominator
b_effort = 8 / T - 12 / T**2 + 6 / T**3  # powers
b_still = 1.5  # a decimal
b_best = False  # a truth value
c_control = 6 * (6 * T - T**2 + 3 * (T - 4) * t) / T**3  # over one denominator
c_motion = 3 * t**2 * (T * (6 - T) + (T - 4) * t) / T**3  # over one denominator
c_effort = 18 * ((T - 3) ** 2 + 3) / T**3  # a square completed
c_still = sp.sqrt(36)  # a root
c_best = False  # a truth value
d_effort = (V**2 + 3 * (V - 2 * X / T) ** 2) / (2 * T)  # a sum of squares

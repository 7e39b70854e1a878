# %% wrong
a_control = a_control.subs(T, a_still)  # Is this the control for one duration only? (hint 2)
a_control = end_a[1] / T  # Does this constant push reach the place, too? (hint 1)
a_motion = end_a[1] * t**2 / (2 * T)  # Is the place at the end the given one? (hint 1)
a_motion = a_motion.subs(T, a_still)  # Is this the motion for one duration only? (hint 1)
a_effort = a_effort / 2  # Was a factor lost in the integral? (hint 1)
a_effort = a_effort.subs(T, a_still)  # Is this the effort for one duration only? (hint 1)
a_still = sp.Rational(
    2 * end_a[0], end_a[1]
)  # Is this where the control becomes constant? (hint 1)
a_still = b_still  # Is this the time of another item? (hint 1)
a_best = "yes"  # Is a stationary point always a minimum? (hint 1)
b_control = a_control  # Is this the control of item a? (hint 1)
b_control = 2 * end_b[1] * t / T**2  # Does this reach the place in every duration? (hint 1)
b_motion = a_motion  # Is this the motion of item a? (hint 1)
b_motion = end_b[0] * t**2 / T**2  # Which velocity does this motion have at the end? (hint 1)
b_effort = a_effort  # Is this the effort of item a? (hint 1)
b_effort = 2 * end_b[1] ** 2 / T  # Is this only how the effort behaves for long durations? (hint 1)
b_still = a_still  # Is this the time of item a? (hint 1)
b_still = sp.Rational(
    2 * end_b[0], end_b[1]
)  # Is this where the control becomes constant? (hint 1)
b_best = "yes"  # Does the derivative change its sign? (hint 1)
c_control = c_control.subs(T, c_still)  # Is this the control for one duration only? (hint 1)
c_control = c_control.subs(t, 0)  # Was the part that grows with time forgotten? (hint 1)
c_motion = c_motion.subs(T, c_still)  # Is this the motion for one duration only? (hint 1)
c_motion = end_c[0] * t**2 / T**2  # Which velocity does this motion have at the end? (hint 1)
c_effort = 2 * c_effort  # Was the half before the integral forgotten? (hint 1)
c_effort = c_effort.subs(T, c_still)  # Is this the effort for one duration only? (hint 1)
c_still = sp.Rational(
    2 * end_c[0], end_c[1]
)  # Is this where the control becomes constant? (hint 1)
c_still = sp.Rational(*end_c)  # Is this the position divided by the velocity? (hint 1)
c_best = "yes"  # What is the effort for a still longer duration? (hint 1)
# Which sign does the mixed term have? (hint 1)
d_effort = 2 * (3 * X**2 + 3 * X * V * T + V**2 * T**2) / T**3
d_effort = 6 * X**2 / T**3  # Was the velocity at the end forgotten? (hint 1)

# %% right
a_control = sp.together(a_control)  # over one denominator
a_control = [[a_control, T]]  # a list of one arc
a_motion = [a_motion, sp.diff(a_motion, t)]  # both states
a_effort = sp.expand(a_effort)  # powers
a_still = float(a_still)  # a decimal
a_best = False  # a truth value
b_control = sp.together(b_control)  # over one denominator
b_motion = sp.together(b_motion)  # over one denominator
b_effort = sp.expand(b_effort)  # powers
b_still = float(b_still)  # a decimal
b_best = False  # a truth value
c_control = sp.together(c_control)  # over one denominator
c_motion = sp.together(c_motion)  # over one denominator
# a square completed
half = c_still / 2
c_effort = 2 * end_c[1] ** 2 * ((T - half) ** 2 + half**2 / 3) / T**3
c_still = float(c_still)  # a decimal
c_best = False  # a truth value
d_effort = (V**2 + 3 * (V - 2 * X / T) ** 2) / (2 * T)  # a sum of squares

# %% numbers
end_a, end_b, end_c = [
    ([X, V], [X, V_b], list(end))
    for X, V, V_b, end in [
        *[(1, 1, 2, (6, 3)), (2, 1, 2, (3, 2)), (1, 2, 3, (4, 3)), (3, 2, 1, (2, 3))],
        *[(2, 3, 1, (5, 3)), (3, 1, 2, (4, 1)), (1, 3, 4, (5, 2)), (4, 3, 2, (1, 2))],
        *[(2, 5, 3, (6, 2)), (5, 3, 2, (3, 4)), (1, 5, 1, (1, 1)), (4, 1, 3, (2, 5))],
        *[(4, 4, 1, (1, 3)), (5, 2, 3, (6, 5)), (7, 1, 2, (1, 4))],
    ]
]
shown = [rf"x(t_k) = «end_{item}[0]», \quad \dot x(t_k) = «end_{item}[1]»;" for item in "abc"]


def answers(X, V):
    """Control, motion, effort, and the duration at which the effort is stationary."""
    control = 2 * (3 * X - V * T) / T**2 + 6 * (V * T - 2 * X) * t / T**3
    motion = (3 * X - V * T) * t**2 / T**2 + (V * T - 2 * X) * t**3 / T**3
    effort = 2 * (3 * X**2 - 3 * X * V * T + V**2 * T**2) / T**3
    return control, motion, effort, sp.Rational(3 * X, V)


a_control, a_motion, a_effort, a_still = answers(*end_a)
b_control, b_motion, b_effort, b_still = answers(*end_b)
c_control, c_motion, c_effort, c_still = answers(*end_c)

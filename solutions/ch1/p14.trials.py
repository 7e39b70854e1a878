# %% wrong
a_gains = k > 0  # Does the equation have a spring of its own? (hint 1)
# Does the control have the wrong sign after it was moved to the other side? (hint 1)
a_gains = k < stiffness
# Does a root at zero leave the zero solution asymptotically stable? (hint 2)
a_gains = k >= -stiffness
b_gains = k > 0  # Does the equation have friction of its own? (hint 1)
# Do imaginary roots leave the zero solution asymptotically stable? (hint 1)
b_gains = k >= -damping
b_gains = (k + damping) / 2 >= sp.sqrt(mass * stiffness)  # Must the roots be real?
# Is it enough that the order does not drop? Divide by the leading coefficient. (hint 1)
c_gains = sp.Ne(k, -mass)
# Are complex roots forbidden?
c_gains = sp.And(k > -mass, k <= sp.Rational(damping**2, 4 * stiffness) - mass)
# Was the inequality multiplied by k without regard to its sign? (hint 1)
d_gains = sp.Ne(k, 0)
# Must the roots be real?
d_gains = sp.And(k > 0, k <= sp.Rational(damping**2, 4 * stiffness))

# %% right
a_gains = stiffness + sp.Symbol("k") > 0  # the coefficient as it comes, with a plain symbol
b_gains = [damping + k > 0, (damping + k) * stiffness > 0]  # both minors as they come
c_gains = damping / (mass + k) > 0  # the divided coefficients
c_gains = k >= -mass  # the value of lower order counted in
d_gains = sp.Interval(0, sp.oo)  # the value of lower order counted in, as an interval

# %% numbers
mass, damping, stiffness = [
    (1, 1, 1),
    (2, 3, 5),
    (3, 2, 4),
    (4, 5, 2),
    (5, 4, 3),
    (8, 7, 6),
    (6, 8, 7),
    (7, 6, 13),
    (11, 10, 11),
    (10, 12, 9),
    (9, 9, 12),
    (13, 15, 8),
    (12, 11, 10),
    (14, 13, 14),
]
shown = [
    r"«mass*»\ddot x + «damping*»\dot x + «stiffness*»x + u = 0",
    r"$k\ddot x + «damping*»\dot x + «stiffness*»x = 0$",
]
a_gains = k > -stiffness
b_gains = k > -damping
c_gains = k > -mass

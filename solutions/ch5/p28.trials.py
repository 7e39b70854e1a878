# %% wrong
# Is this an integral of the equation with the conditions at the left alone? (hint 1)
a_motion = t**4
a_motion = t**4 - 2 * t**3 + t**2  # Were position and slope fixed at the right end? (hint 1)
a_motion = 6 * t**2 - 4 * t**3  # Was the load forgotten in the equation? (hint 1)
# Which sign does psi1 have in the adjoint equation for psi2? (hint 2)
a_costate = [48 * (t - 1), 24 * (1 - t) ** 2]
a_costate = [24 * (1 - t), 12 * (1 - t) ** 2]  # Was a factor lost at the maximum of H? (hint 1)
# Is this the integral of the squared second derivative alone? (hint 1)
a_value = sp.Rational(144, 5)
a_value = -sp.Rational(288, 5)  # Is this the linear part alone? (hint 1)
b_motion = t  # Does the line satisfy the equation? (hint 1)
b_motion = sp.sin(t)  # Is the slope at the right end as given? (hint 1)
# Was the second derivative made zero at the right end, instead of the third? (hint 2)
q = 1 / (sp.cosh(sp.pi / 2) + sp.sinh(sp.pi / 2) + 1)
b_motion = q * (sp.cosh(t) - sp.cos(t)) + q * sp.sinh(t) + (1 - q) * sp.sin(t)
# Were the two costates interchanged? (hint 1)
B = (1 - sp.sinh(sp.pi / 2)) / (2 * sp.cosh(sp.pi / 2))
b_costate = [
    sp.cosh(t) + sp.cos(t) + 2 * B * sp.sinh(t) - 2 * (1 - B) * sp.sin(t),
    -sp.sinh(t) + sp.sin(t) - 2 * B * sp.cosh(t) + 2 * (1 - B) * sp.cos(t),
]
b_value = -2  # Was the term at the right end left out? (hint 1)
b_value = 1 / sp.cosh(sp.pi / 2)  # Was the term at the left end left out? (hint 1)
b_maximum = "yes"  # Is the functional bounded from above? (hint 1)
c_motion = 2 * t**2 / T**2  # Does this have the slope given at the right end? (hint 2)
# Is this the best motion without the velocity in the integrand? (hint 1)
c_motion = (T - 4) * t**3 / T**3 + (6 - T) * t**2 / T**2
# Is this the value without the velocity in the integrand? (hint 1)
c_value = 4 * (T**2 - 6 * T + 12) / T**3
c_value = 1 + 1 / (T - 2)  # Is this only how the value behaves for long durations? (hint 1)
c_best = "yes"  # Where would the derivative of the value vanish? (hint 2)

# %% right
a_motion = t**2 * ((t - 2) ** 2 + 2)  # a square completed
a_costate = sp.Matrix([48 - 48 * t, 24 - 48 * t + 24 * t**2])  # expanded, a column
a_value = -28.8  # a decimal
# over one denominator
S, K = sp.sinh(sp.pi / 2), sp.cosh(sp.pi / 2)
b_motion = (K * (sp.cosh(t) - sp.cos(t)) + (1 - S) * sp.sinh(t) + (2 * K - 1 + S) * sp.sin(t)) / (
    2 * K
)
# over one denominator
S, K = sp.sinh(sp.pi / 2), sp.cosh(sp.pi / 2)
b_costate = [
    (-K * (sp.sinh(t) - sp.sin(t)) - (1 - S) * sp.cosh(t) + (2 * K - 1 + S) * sp.cos(t)) / K,
    (K * (sp.cosh(t) + sp.cos(t)) + (1 - S) * sp.sinh(t) - (2 * K - 1 + S) * sp.sin(t)) / K,
]
b_value = -1.60146  # decimals
b_value = 2 * sp.exp(sp.pi / 2) / (sp.exp(sp.pi) + 1) - 2  # exponentials
b_maximum = False  # a truth value
# exponentials for the hyperbolic functions
e, f = (sp.exp(T) + sp.exp(-T)) / 2, (sp.exp(T) - sp.exp(-T)) / 2
c_motion = ((2 * f - e + 1) * (t - sp.sinh(t)) + (T - f + 2 * e - 2) * (sp.cosh(t) - 1)) / (
    T * f + 2 - 2 * e
)
# by the half-angle
r = sp.tanh(T / 2)
c_value = ((T - 4) * (1 + r**2) + 6 * r + 4 * (1 - r**2)) / (
    2 * T * r + 2 * (1 - r**2) - 2 * (1 + r**2)
)
c_best = False  # a truth value

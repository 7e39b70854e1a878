# %% wrong
# Was the initial speed due to the drift forgotten? (hint 1)
a_speed = (
    -R * eps
    + v0 * sp.cos(sp.sqrt(g / R) * t)
    + (b - g * phi0) * sp.sqrt(R / g) * sp.sin(sp.sqrt(g / R) * t)
)
# Was the frequency inverted? (hint 2)
a_speed = (
    -R * eps
    + (v0 + R * eps) * sp.cos(sp.sqrt(R / g) * t)
    + (b - g * phi0) * sp.sqrt(g / R) * sp.sin(sp.sqrt(R / g) * t)
)
# Was the feedback by the curvature of the Earth left out? (hint 1)
a_speed = v0 + (b - g * phi0) * t - g * eps * t**2 / 2
b_unobservable_change = [0, 1, 0, -g]  # Which sign must the tilt have to hide the bias? (hint 1)
# Does this change not cause an oscillation of the speed? (hint 1)
b_unobservable_change = [-R, 0, 1, 0]
b_unobservable_change = [0, 0, 0, 0]  # Is no change at all a change? (hint 1)
c_error = b / g  # Is this the truth minus the estimate? (hint 1)
c_error = 0  # Is an error harmless because it is unobservable? (hint 1)
# Were the errors added as if they were independent? (hint 2)
d_worst = (
    delta
    * sp.sqrt(2 + 4 * sp.cos(sp.sqrt(g / R) * tau) ** 2)
    / (2 * R * (1 - sp.cos(sp.sqrt(g / R) * tau)))
)
d_worst = delta / R  # Can the errors of the three measurements have different signs? (hint 2)
d_worst = 4 * delta / (g * tau**2)  # Does this hold for short arcs only? (hint 1)

# %% right
# plain symbols, by the half angle
T, G, L, V, P, E, B = sp.symbols("t g R v0 phi0 eps b")
a_speed = (
    V * sp.cos(T * sp.sqrt(G / L))
    - 2 * L * E * sp.sin(T * sp.sqrt(G / L) / 2) ** 2
    + (B - G * P) * sp.sqrt(L / G) * sp.sin(T * sp.sqrt(G / L))
)
b_unobservable_change = sp.Matrix([0, 1 / g, 0, 1])  # divided by g, as a column
b_unobservable_change = (0, -2, 0, -2 * g)  # with the opposite sign
c_error = -1.0 * b / g  # a decimal factor
# by the half angle
d_worst = (
    delta
    * (1 + sp.sqrt(sp.cos(tau * sp.sqrt(g / R)) ** 2))
    / (2 * R * sp.sin(tau * sp.sqrt(g / R) / 2) ** 2)
)

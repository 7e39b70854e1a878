# %% wrong
# What else does a turn move? (hint 1)
a_pontryagin = v * (psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha)) + omega * psi3 - 1
# Is the cost minimised or maximised? (hint 1)
a_pontryagin = (
    v * (psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha))
    + 1
    + omega * (psi3 + k0 * (psi2 * sp.cos(alpha) - psi1 * sp.sin(alpha)))
)
# Was the part with the offset differentiated, too? (hint 1)
a_adjoint = [0, 0, v * (psi1 * sp.sin(alpha) - psi2 * sp.cos(alpha))]
# Which sign precedes the derivative of $H$?
a_adjoint = [
    0,
    0,
    (
        v * (psi2 * sp.cos(alpha) - psi1 * sp.sin(alpha))
        - k0 * omega * (psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha))
    ),
]
# Is transversality a condition on the switching function or on the costate? (hint 1)
a_transversality = [psi3 + k0 * psi2]
a_transversality = [psi1, psi2]  # Is the final position free, or the direction? (hint 1)
# What else is multiplied by the rate of turn? (hint 1)
a_control = [
    vbar * sp.Piecewise((1, psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha) > 0), (0, True)),
    omegabar * sp.sign(psi3),
]
# Can the speed be negative? (hint 2)
a_control = [
    vbar * sp.sign(psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha)),
    omegabar * sp.sign(psi3 + k0 * (psi2 * sp.cos(alpha) - psi1 * sp.sin(alpha))),
]
# Does the offset have no influence? (hint 1)
a_greatest = (
    vbar * sp.Max(psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha), 0) + omegabar * sp.Abs(psi3) - 1
)
b_order = 2  # Is this the number of the derivative? (hint 1)
b_costates = [sp.cos(alpha), sp.sin(alpha), 0]  # Is $H = 0$ with these? (hint 2)
# What is the component of the first two across the robot? (hint 1)
b_costates = [sp.cos(alpha) / v, sp.sin(alpha) / v, -k0 / v]
b_control = omegabar  # Does the switching function stay zero under this control? (hint 1)
# Does the robot keep the direction of the first two costates? (hint 1)
b_control = vbar / k0
b_kelley = 1  # Which sign belongs to the order one?
# Does the offset stay in the derivatives of the switching function? (hint 1)
b_kelley = -1 - k0
b_speed = [0, 0, 0]  # What is $H$ with these costates? (hint 1)
# How fast does the switching function of $v$ change then? (hint 1)
b_speed = [-sp.sin(alpha), sp.cos(alpha), -k0]
# Is the target measured from the marked point or from the wheel axle? (hint 1)
c_spot = sp.Max(sp.Abs(phi) - sp.acos(vbar / omegabar / r), 0) / omegabar
# Does the robot stand still until it points at the target? (hint 3)
c_spot = sp.Abs(sp.atan2(r * sp.sin(phi), r * sp.cos(phi) + k0)) / omegabar
# Does the marked point arrive at the same time as the middle of the axle? (hint 1)
c_duration = sp.Piecewise(
    (
        (sp.Abs(phi) - sp.acos(vbar / omegabar / r) + sp.pi / 2) / omegabar
        + (sp.sqrt(r**2 - vbar**2 / omegabar**2) - vbar / omegabar) / vbar,
        r * sp.cos(phi) < vbar / omegabar,
    ),
    (r / vbar, True),
)
c_duration = r / vbar  # In which direction does the robot point at first? (hint 2)

# %% right
a_transversality = sp.Eq(psi3, 0)  # a single equation
# by the sign
a_control = [
    vbar * (1 + sp.sign(psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha))) / 2,
    omegabar * sp.sign(psi3 + k0 * (psi2 * sp.cos(alpha) - psi1 * sp.sin(alpha))),
]
b_costates = [sp.cos(alpha) / vbar, sp.sin(alpha) / vbar, 0]  # with the bound
b_kelley = -vbar * (psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha))  # with the costates
b_speed = [0, 0, omega / omegabar**2]  # by the sign of the rate
# by the other inverse function
c_spot = (
    sp.Max(
        sp.atan2(sp.Abs(r * sp.sin(phi)), r * sp.cos(phi) + k0)
        - sp.pi / 2
        + sp.asin(vbar / omegabar / sp.sqrt(r**2 + 2 * r * k0 * sp.cos(phi) + k0**2)),
        0,
    )
    / omegabar
)

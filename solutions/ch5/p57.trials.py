# %% wrong
# Where is the cost? (hint 1)
a_pontryagin = v * (psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha)) + omega * psi3
# Is the cost minimised or maximised? (hint 1)
a_pontryagin = v * (psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha)) + omega * psi3 + 1
# Which sign precedes the derivative of $H$?
a_adjoint = [0, 0, v * (psi2 * sp.cos(alpha) - psi1 * sp.sin(alpha))]
a_adjoint = [0, 0, 0]  # Does the direction of the robot enter no right-hand side? (hint 1)
a_transversality = [psi1, psi2]  # Is the final position free, or the direction? (hint 1)
a_transversality = [psi1, psi2, psi3]  # Which coordinates are given at the end? (hint 1)
# Can the speed be negative? (hint 2)
a_control = [vbar * sp.sign(psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha)), omegabar * sp.sign(psi3)]
a_control = [vbar, omegabar * sp.sign(psi3)]  # Does a high speed always increase $H$? (hint 1)
# What does $H$ gain from a speed where the switching function of $v$ is negative? (hint 1)
a_greatest = vbar * (psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha)) + omegabar * sp.Abs(psi3) - 1
# This is its value along an extremal. What is it for arbitrary costates? (hint 1)
a_greatest = sp.Integer(0)
b_costates = [0, 0, 0]  # Can all multipliers vanish, and is $H$ then zero? (hint 2)
b_costates = [sp.cos(alpha), sp.sin(alpha), 0]  # Is $H = 0$ with these? (hint 2)
# Is the derivative of $\psi_3$ zero with these? (hint 1)
b_costates = [-sp.sin(alpha) / v, sp.cos(alpha) / v, 0]
b_control = omegabar  # Does $\psi_3$ stay zero under this control? (hint 1)
b_control = vbar  # Is this a rate of turn? (hint 1)
b_kelley = 1  # Which sign belongs to the order one? (hint 2)
b_kelley = 0  # Does the control not appear in the second derivative? (hint 1)
b_holds = "no"  # Look at the sign of the switching function of $v$ on the arc once more.
b_speed = [0, 0, 0]  # What is $H$ with these costates? (hint 1)
# How fast does the switching function of $v$ change then? (hint 1)
b_speed = [-sp.sin(alpha), sp.cos(alpha), 0]
# Is this the turn towards the target itself? Does the robot still turn while it moves? (hint 1)
c_spot = sp.Abs(sp.atan2(b, a)) / omegabar
# Is the arc that follows always a quarter? (hint 2)
c_spot = sp.Max(sp.Abs(sp.atan2(b, a)) - sp.pi / 2, 0) / omegabar
# Does this hold for targets that are near, too? (hint 2)
c_spot = (
    sp.Max(sp.Abs(sp.atan2(b, a)) - sp.acos(sp.Min(1, vbar / omegabar / sp.sqrt(a**2 + b**2))), 0)
    / omegabar
)
# Is this an angle or a time?
c_spot = sp.Max(
    0,
    sp.Abs(sp.atan2(b, a))
    + sp.pi / 4
    - sp.asin(sp.Min(omegabar * sp.sqrt(a**2 + b**2) / (2 * vbar), 1 / sp.sqrt(2)))
    - sp.acos(sp.Min(vbar / omegabar / sp.sqrt(a**2 + b**2), 1 / sp.sqrt(2))),
)
c_duration = sp.sqrt(a**2 + b**2) / vbar  # In which direction does the robot point at first?
# This path begins with a turn on the spot towards the target. May the robot move meanwhile?
# (hint 1)
c_duration = sp.Abs(sp.atan2(b, a)) / omegabar + sp.sqrt(a**2 + b**2) / vbar
# Is a circle and its tangent the best path to every target? Does it exist for each? (hint 1)
c_duration = (
    sp.atan2(sp.Abs(b) - vbar / omegabar, a)
    + sp.atan2(vbar / omegabar, sp.sqrt(a**2 + b**2 - 2 * vbar * sp.Abs(b) / omegabar))
) / omegabar + sp.sqrt(a**2 + b**2 - 2 * vbar * sp.Abs(b) / omegabar) / vbar

# %% right
a_transversality = sp.Eq(psi3, 0)  # a single equation
# by the sign
a_control = [
    vbar * (1 + sp.sign(psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha))) / 2,
    omegabar * sp.sign(psi3),
]
# by an absolute value
a_greatest = (
    vbar
    * (
        psi1 * sp.cos(alpha)
        + psi2 * sp.sin(alpha)
        + sp.Abs(psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha))
    )
    / 2
    + omegabar * sp.Abs(psi3)
    - 1
)
b_costates = [sp.cos(alpha) / vbar, sp.sin(alpha) / vbar, 0]  # with the bound
b_kelley = -vbar * (psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha))  # with the costates
b_speed = [0, 0, omega / omegabar**2]  # by the sign of the rate
# cases
c_spot = (
    sp.Piecewise(
        (
            sp.Max(
                0,
                sp.Abs(sp.atan2(b, a))
                - sp.asin(sp.Min(1, omegabar * sp.sqrt(a**2 + b**2) / (2 * vbar))),
            ),
            a**2 + b**2 < 2 * vbar**2 / omegabar**2,
        ),
        (
            sp.Max(
                0,
                sp.Abs(sp.atan2(b, a)) - sp.acos(sp.Min(1, vbar / omegabar / sp.sqrt(a**2 + b**2))),
            ),
            True,
        ),
    )
    / omegabar
)

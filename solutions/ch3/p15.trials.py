# %% wrong
controllable = sp.true  # Can the robot reach every position at zero speed?
controllable = sp.Ne(V0, 0) & sp.Ne(k0, 0)  # Can a point on the wheel axis not move sideways?
controllable = V0 > 0  # Does the sign of the determinant matter?
# Left of the track, which way does the robot have to turn?
gain = sp.Matrix([[1, k1 + k2 * V0 - k1 * V0 / (k3 * k0) - 1]])
gain = sp.Matrix([[-1, -1]])  # What if the robot is fast, or $k_0$ short?
gain = sp.Matrix([[-1, k1 + k2 * V0 - 1]])  # What does the second Hurwitz minor require?
gain = []  # Does the angle have no effect on y?
# Does the measured point have to be ahead of the axis?
general = (V0 * k_eps < 0) & (k_omega < k1 + k2 * V0 - k1 * V0 / (k3 * k0))
# Are positive coefficients enough for a cubic?
general = (k0 * V0 > 0) & (V0 * k_eps < 0) & (k_omega < k1 + k2 * V0)
# May the robot not drive backwards with the point behind the axis? (hint 1)
general = (k0 > 0) & (V0 > 0) & (k_eps < 0) & (k_omega < k1 + k2 * V0 - k1 * V0 / (k3 * k0))
# Does this law stabilise a robot that drives backwards, too?
region = (k_eps < 0) & (k_omega < 1 - 3 * V0 / 10)
# Are positive coefficients enough for a cubic?
region = (V0 > 0) & (k_eps < 0) & (k_omega < 1 + V0 / 5)
# What is the sign of the last coefficient?
region = (V0 > 0) & (k_eps > 0) & (k_omega < 1 - 3 * V0 / 10)
region = (V0 > 0) & (k_eps < 0) & (k_omega < 0)  # How much damping does the speed require?

# %% right
controllable = sp.Or(V0 > 0, V0 < 0)  # either direction
controllable = sp.Ne(k3**3 * V0 / k1**3, 0)  # the determinant
# a gain that grows with the speed
gain = sp.Matrix([[-V0 * k0, k1 + k2 * V0 - 2 * k1 * V0 / (k3 * k0)]])
# closer to the border
gain = sp.Matrix([[-3, k1 + k2 * V0 - k1 * V0 / (k3 * k0) - sp.Rational(1, 10)]])
# the four conditions as they come
c, d = k3 * (1 + k2 * V0 / k1), k3 / k1
general = (
    (c - d * k_omega > 0)
    & (k0 * k_eps < 0)
    & (V0 * k_eps < 0)
    & (-(c - d * k_omega) * d * k0 * k_eps > -d * V0 * k_eps)
)
# without a division
general = (
    (V0 * k_eps < 0) & (k0 * k_eps < 0) & (k0**2 * k3 * (k1 + k2 * V0 - k_omega) > k0 * k1 * V0)
)
# the coefficients and the minor as they come
c = 2 + 2 * V0 / 5
region = (
    (c - 2 * k_omega > 0) & (-V0 * k_eps > 0) & (-(c - 2 * k_omega) * 2 * k_eps > -2 * V0 * k_eps)
)
# the last product for the sign of the gain
region = (V0 * k_eps < 0) & (V0 > 0) & (10 * k_omega + 3 * V0 < 10)

# %% wrong
# Is the time to be maximised here? (hint 1)
a_pontryagin = psi_x * (sailing[0] + U) + psi_y * (sailing[1] + V) + 1
a_pontryagin = psi_x * sailing[0] + psi_y * sailing[1] - 1  # Does the water stand still? (hint 2)
# Which function is differentiated with respect to which coordinate? (hint 1)
a_adjoint = [-psi_x * U.diff(x) - psi_y * U.diff(y), -psi_x * V.diff(x) - psi_y * V.diff(y)]
# Which sign precedes the derivative of $H$? (hint 1)
a_adjoint = [psi_x * U.diff(x) + psi_y * V.diff(x), psi_x * U.diff(y) + psi_y * V.diff(y)]
a_maximum = sp.atan(psi_y / psi_x)  # What does this give when $\psi_x$ is negative? (hint 2)
a_maximum = sp.atan2(
    -psi_y, -psi_x
)  # Does $H$ have a maximum or a minimum on this heading? (hint 1)
# The problem book prints this. What becomes of its last term when the axes are turned by a right
# angle? (hint 2)
a_equation = (
    U_x * sp.sin(theta) ** 2
    + (U_x - V_y) * sp.sin(theta) * sp.cos(theta)
    - U_y * sp.cos(theta) ** 2
)
# To which side does a front turn whose left part moves faster? Follow the signs once more. (hint 2)
a_equation = (
    U_y * sp.cos(theta) ** 2
    - (U_x - V_y) * sp.sin(theta) * sp.cos(theta)
    - V_x * sp.sin(theta) ** 2
)
# Are these derivatives, or the current itself? (hint 1)
b_equation = U_0 * sp.sin(theta) - V_0 * sp.cos(theta)
# Which derivative of a constant current does not vanish? (hint 1)
b_equation = sp.cos(theta) ** 2
b_time = sp.sqrt(X**2 + Y**2) / v  # Is this the time in still water? (hint 1)
# Is the speed of the ship through the water added to the current in the direction of the target?
# (hint 1)
b_time = sp.sqrt(X**2 + Y**2) / (v + w * X / sp.sqrt(X**2 + Y**2))
# Where does the water carry a ship that points at its target? (hint 1)
b_heading = sp.atan2(Y, X)
# Is the drift to be added to the required displacement, or subtracted? (hint 1)
b_heading = sp.atan2(
    Y, X + w * (X**2 + Y**2) / (w * X + sp.sqrt(v**2 * (X**2 + Y**2) - w**2 * Y**2))
)
b_side = d * v / w  # Is the ship to point straight across the current? (hint 2)
# A side and the hypotenuse of which triangle are $v$ and $w$? (hint 2)
b_side = d * v / sp.sqrt(w**2 + v**2)
c_heading = sp.atan(T - t)  # Where does the ship arrive on this course? (hint 2)
# Is the path along the bank the fastest, though the water is faster farther out? (hint 1)
c_heading = sp.Integer(0)
c_heading = sp.atan(t - T / 2)  # Does the ship leave the bank for the faster water? (hint 1)
c_distance = T  # Is this the path along the bank? (hint 1)
c_distance = T / 2 * sp.sqrt(1 + T**2 / 4)  # Was one part of the integral lost? (hint 2)
c_distance = T**2 / 4  # Does the ship reach the fast water in no time? (hint 1)

# %% right
# by the two arguments of the unit vector, as a product
a_maximum = 2 * sp.atan2(psi_y, psi_x + sp.sqrt(psi_x**2 + psi_y**2))
# with the names of the derivatives and the double angle
a_equation = (
    (V_x - U_y) / 2 + (U_x - V_y) / 2 * sp.sin(2 * theta) - (U_y + V_x) / 2 * sp.cos(2 * theta)
)
# the root of the quadratic equation as it comes
b_time = (sp.sqrt((v**2 - w**2) * (X**2 + Y**2) + w**2 * X**2) - w * X) / (v**2 - w**2)
# the course over ground and the angle of drift
b_heading = sp.atan2(Y, X) + sp.asin(w * Y / (v * sp.sqrt(X**2 + Y**2)))
b_side = d * sp.tan(sp.asin(v / w))  # through the half-angle of the sector
c_heading = sp.asin((T - 2 * t) / sp.sqrt(4 + (T - 2 * t) ** 2))  # by its sine
c_distance = T / 4 * sp.sqrt(4 + T**2) + sp.log(T / 2 + sp.sqrt(1 + T**2 / 4))  # with a logarithm

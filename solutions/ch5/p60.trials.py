# %% wrong
# Is the time part of the cost? (hint 1)
a_pontryagin = psi1 * omega + psi2 * (alpha + u) + psi3 * v + psi4 * u - k * x**2
# Is the cost minimised or maximised? (hint 1)
a_pontryagin = psi1 * omega + psi2 * (alpha + u) + psi3 * v + psi4 * u + 1 + k * x**2
# Which sign does the price of the displacement have in $H$? (hint 1)
a_adjoint = [-psi2, -psi1, -2 * k * x, -psi3]
a_adjoint = [psi2, -psi1, 2 * k * x, -psi3]  # Is the pendulum upright or hanging? (hint 1)
a_regular = bound * sp.sign(psi4)  # Does the control move the cart only? (hint 1)
a_regular = sp.sign(psi2 + psi4)  # What are the bounds of the control? (hint 1)
b_order = 4  # Is this the number of the derivative itself? (hint 1)
b_order = 1  # Does the second derivative contain the control? (hint 1)
c_kelley = 2 * k  # Which power of $-1$ belongs to this order? (hint 1)
c_kelley = -2  # Where is the price of the displacement? (hint 1)
c_holds = "no"  # Which sign does the condition require? (hint 1)
# Check the derivatives: what follows from the second one for $\psi_2$? (hint 1)
d_control = -x
d_control = x - alpha  # Does the pendulum really occur in the last derivative? (hint 1)
d_surface = sp.Eq(alpha * x - omega * v, 0)  # Was $H = 0$ used with all its terms? (hint 2)
# Was the time left out of the cost? (hint 2)
d_surface = sp.Eq(2 * (alpha * x - omega * v + v**2) - x**2, 0)
d_motion = -(4 * b + 3 * c) * (2 - t)  # Does this satisfy the law of motion of the cart? (hint 1)
# Two constants are needed to stop the pendulum. (hint 3)
d_motion = -b * sp.exp(-t) - c * sp.exp(-t)

# %% right
d_control = x + 0 * alpha  # with a term that is zero
d_surface = sp.Eq(alpha * x - omega * v + v**2, x**2 / 2 + 1 / (2 * k))  # divided by 2k
# with exponentials
p, q = sp.symbols("p q")
path = p * sp.exp(t) + q * sp.exp(-t)
fall, rise = (sp.integrate(sp.expand(path * sp.exp(sign * t)), (t, 0, 2)) for sign in (-1, 1))
found = sp.solve([b + c + fall, b - c - rise], [p, q], dict=True)[0]
d_motion = path.subs(found)

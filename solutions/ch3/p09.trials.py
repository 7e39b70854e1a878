# %% wrong
a_gain = sp.Matrix([[2, 2]])  # What is the sign of the feedback in the statement? (hint 1)
# How does a pendulum move if it is pushed back but not damped? (hint 1)
a_gain = sp.Matrix([[-2, 0]])
a_gain = sp.Matrix([[0, -2]])  # Does a pendulum that falls slowly not fall? (hint 1)
a_gain = []  # Is the growing motion uncontrollable?
# How strong must the restoring force be to stop the growing motion? (hint 2)
a_region = (k1 < 0) & (k2 < 0)
a_region = (k1 > 1) & (k2 > 0)  # What is the sign of the feedback in the statement?
# Is there still a growing motion when the other gain has the wrong sign? (hint 1)
a_region = k1 < -1
a_margins = mu < 1  # Is the rate of the free motion a limit, or do the gains move it? (hint 1)
b_gain = sp.Matrix([[-2, 0]])  # Does a stiffer spring make the oscillation die out? (hint 1)
b_region = (k1 < 0) & (k2 < 0)  # Is the spring that is there not enough? (hint 1)
# What if the feedback pushes away harder than the spring pulls back? (hint 1)
b_region = k2 < 0
b_region = (k1 < 1) & (k2 <= 0)  # What does the motion do without any damping? (hint 1)
# Is the frequency a limit? What do the gains do to the coefficients? (hint 1)
b_margins = mu <= 1
# Where does the body come to rest with more damping only? (hint 1)
c_gain = sp.Matrix([[0, -1]])
c_region = (k1 < 0) & (k2 < 0)  # How much of the existing friction can be removed? (hint 1)
# Does the friction have the right sign? Write the polynomial down once more. (hint 1)
c_region = (k1 < 0) & (k2 < -1)
# Is this the limit for feedback of the position alone? The velocity is known, too. (hint 1)
c_margins = mu <= sp.Rational(1, 2)
# Is the rate of the friction fixed, or does the control act on the velocity? (hint 1)
c_margins = mu <= 1
d_gain = sp.Matrix([[1, -3]])  # Which equation does the control enter? (hint 1)
d_gain = []  # Do the uncontrollable roots have to be moved? (hint 1)
d_region = (k1 < 0) & (k2 < 0)  # Do both gains appear in the characteristic polynomial? (hint 2)
# Does the control enter the same equation as in the previous system? (hint 1)
d_region = (k1 < 0) & (k2 < 1)
# Is this the condition for a degree of stability, and not for stability? (hint 1)
d_region = k1 < -1
# The gain moves one eigenvalue as far as one likes. And the other one? (hint 1)
d_margins = sp.true
d_margins = mu < 1  # Does the definition of a degree of stability exclude equality? (hint 2)
d_margins = sp.false  # How fast does the uncontrollable part decay? (hint 1)

# %% right
a_gain = [-5, -1]  # a flat list, other numbers
a_gain = sp.Matrix([-1.25, -3.0])  # decimals, upright
a_region = (k1 + 1 < 0) & (-k2 > 0)  # the coefficients of the polynomial
a_margins = mu > 0  # the assumption on mu itself
b_gain = [sp.Rational(1, 2), -1]  # a push away from the equilibrium
b_region = (1 - k1 > 0) & (k2 < 0)  # the coefficients
b_margins = sp.Or(mu <= 1, mu > 1)  # everything, in two parts
c_gain = [-3, sp.Rational(1, 2)]  # less damping than by itself
c_region = sp.Not(sp.Or(k1 >= 0, k2 >= 1))  # what is forbidden, denied
c_margins = mu > 0  # the assumption on mu itself
d_gain = [-1, 100]  # any gain of x2
d_region = (k1 < 0) & (k2**2 >= 0)  # with a condition that always holds
d_margins = (mu > 0) & (mu <= 1)  # an interval
d_margins = sp.Interval.Lopen(0, 1)  # the interval as a set

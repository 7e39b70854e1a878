# %% wrong
# Was the velocity made zero at the free end, as without a cost there? (hint 2)
a_motion = sp.cosh(t)
# Which sign does the terminal cost have in the natural condition? (hint 2)
a_motion = sp.exp(-t)
a_motion = sp.cos(t) + sp.sin(t)  # Was the sign in Euler's equation reversed? (hint 1)
a_value = sp.exp(2) - 1  # Was the terminal cost left out? (hint 1)
a_value = -sp.tanh(1)  # Is this the value for another natural condition? (hint 1)
b_motion = sp.sqrt(1 - 2 * t)  # Is this motion real up to the end? (hint 2)
b_motion = sp.Integer(1)  # Is the condition at the free end satisfied? (hint 2)
b_motion = 1 - t  # Is Euler's equation for x the same as for its square? (hint 1)
b_value = 0  # Which y(1) belongs to this value, and is it half of a square? (hint 1)
b_value = 1  # Is this the value for the motion at rest? (hint 1)
# This one satisfies all conditions. Is there another, with a smaller value? (hint 1)
b_other_motion = sp.sqrt(1 - t)
b_other_motion = sp.sqrt(1 + t)  # Is the natural condition satisfied? (hint 1)
b_other_value = sp.Rational(1, 4)  # Are there two extremals? Compare them. (hint 1)
b_other_value = 4  # Which sign does the terminal cost have? (hint 1)
c_motion = 2 * t / T  # Was the term without a square forgotten? (hint 2)
c_motion = -(t**2) / 4 + T * t / 2  # Does the motion end at the right position? (hint 1)
c_motion = t**2 / 4 + (2 / T - T / 4) * t  # Which sign does the second derivative have? (hint 2)
c_value = 4 / T - T  # Is this the value of the straight line? (hint 1)
# Was the square integrated term by term, with its middle term? (hint 1)
c_value = 4 / T - T - T**3 / 12
c_best = "yes"  # Where would the derivative of the value vanish? (hint 1)
d_motion = (t**4 - t) / 24  # Which sign does the second derivative have? (hint 1)
d_motion = t * (1 - t) / 12  # Was the load taken as constant? (hint 1)
d_value = sp.Rational(1, 224)  # Was the term with the velocity left out? (hint 1)
d_value = -sp.Rational(1, 448)  # Is this the value with the other sign? (hint 1)

# %% right
a_motion = sp.cosh(t) + sp.sinh(t)  # hyperbolic functions
a_motion = 2.71828**t  # decimals
a_value = sp.cos(sp.pi)  # in another form
a_value = sp.exp(2) - 1 - sp.exp(2)  # the integral and the end
b_motion = sp.Piecewise((sp.sqrt(1 - t), t < 1), (0, True))  # with its end apart
b_motion = sp.exp(sp.log(1 - t) / 2)  # a power, by the logarithm
b_value = 0.25  # a decimal
b_other_motion = sp.sqrt(2) * sp.sqrt(t + sp.Rational(1, 2))  # a factor taken out
b_other_value = 1 - 3  # the integral and the end
c_motion = t * (8 + T**2 - T * t) / (4 * T)  # over one denominator
c_motion = 2 * t / T + t * (T - t) / 4  # the straight line and a bulge
c_value = (192 - 48 * T**2 - T**4) / (48 * T)  # over one denominator
c_best = False  # a truth value
d_motion = t * (1 - t) * (1 + t + t**2) / 24  # factors
d_value = sp.Rational(3, 28) / 48  # a product

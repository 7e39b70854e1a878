# %% wrong
a_gains = k > 0  # Does the equation have a spring of its own? (hint 1)
# Did the control get the wrong sign when it was moved to the other side? (hint 1)
a_gains = k < 1
a_gains = k >= -1  # Does a root at zero leave the zero solution asymptotically stable? (hint 2)
b_gains = k > 0  # Does the equation have friction of its own? (hint 1)
b_gains = k >= -1  # Do imaginary roots leave the zero solution asymptotically stable? (hint 1)
b_gains = k >= 1  # Must the roots be real?
# Is it enough that the order is kept? Divide by the leading coefficient. (hint 1)
c_gains = sp.Ne(k, -1)
c_gains = sp.And(k > -1, k <= -sp.Rational(3, 4))  # Are complex roots forbidden?
# Was the inequality multiplied by k without asking for its sign? (hint 1)
d_gains = sp.Ne(k, 0)
d_gains = sp.And(k > 0, k <= sp.Rational(1, 4))  # Must the roots be real?

# %% right
a_gains = 1 + sp.Symbol("k") > 0  # the coefficient as it comes, with a plain symbol
b_gains = [1 + k > 0, (1 + k) * 1 > 0]  # both minors as they come
c_gains = 1 / (1 + k) > 0  # the divided coefficients
c_gains = k >= -1  # the value of lower order counted in
d_gains = sp.Interval(0, sp.oo)  # the value of lower order counted in, as an interval

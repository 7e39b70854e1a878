# %% wrong
a_gains = k > 0  # the spring of the equation itself forgotten
a_gains = k < 1  # the sign of the control turned: x'' + x' + x = u
a_gains = k >= -1  # a root at zero counted as asymptotically stable
b_gains = k > 0  # the friction of the equation itself forgotten
b_gains = k >= -1  # imaginary roots counted as asymptotically stable
b_gains = k >= 1  # real roots demanded
c_gains = sp.Ne(k, -1)  # only the order looked at, not the sign of the leading coefficient
c_gains = sp.And(k > -1, k <= -sp.Rational(3, 4))  # complex roots excluded
d_gains = sp.Ne(k, 0)  # the inequality multiplied by k without asking for its sign
d_gains = sp.And(k > 0, k <= sp.Rational(1, 4))  # real roots demanded

# %% right
a_gains = 1 + sp.Symbol("k") > 0  # the coefficient as it comes, with a plain symbol
b_gains = [1 + k > 0, (1 + k)*1 > 0]  # both minors as they come
c_gains = 1/(1 + k) > 0  # the divided coefficients
c_gains = k >= -1  # the value of lower order counted in
d_gains = sp.Interval(0, sp.oo)  # the value of lower order counted in, as an interval

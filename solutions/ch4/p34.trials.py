# %% wrong
estimate = a * y + h * P / R * (z - y)  # What value of z does the filter expect? (hint 1)
estimate = a * y + P / R * (z - h * y)  # Where does h appear in the gain? (hint 1)
estimate = a * y  # Is the measurement used?
riccati = 2 * a * P + Q - P**2 / R  # How does the gain depend on h? (hint 1)
riccati = 2 * a * P - Q - h**2 * P**2 / R  # Does noise make the variance smaller?
riccati = a * P + Q - h**2 * P**2 / R  # At what rate does the square of an error change?
exists = sp.Ne(h, 0)  # Is a measurement always needed, and is it always enough? (hint 1)
exists = sp.And(sp.Ne(h, 0), Q > 0)  # Are these conditions needed for every sign of a? (hint 1)
# What becomes of the gain for an undisturbed constant? (hint 2)
exists = sp.Or(sp.Ne(h, 0), a < 0)
exists = a < 0  # Can a growing process not be estimated? (hint 1)
# What if the process grows without noise? (hint 2)
exists = sp.And(sp.Or(sp.Ne(h, 0), a < 0), sp.Or(Q > 0, a < 0))
steady = R * (a - sp.sqrt(a**2 + Q * h**2 / R)) / h**2  # Is this a variance? (hint 1)
steady = R * (a + sp.sqrt(a**2 + Q / R))  # Is everything measured with the factor 1 here?
# Does a growing process have the smaller variance?
steady = R * (-a + sp.sqrt(a**2 + Q * h**2 / R)) / h**2
gain = (a + sp.sqrt(a**2 + Q * h**2 / R)) / h**2  # Is the variance multiplied with h? (hint 1)
# What if a larger x gives a smaller z? (hint 1)
gain = (a + sp.sqrt(a**2 + Q * h**2 / R)) / sp.Abs(h)
decay = sp.sqrt(a**2 + Q * h**2 / R)  # Do errors of this filter decay? (hint 1)
decay = a  # Does the correction have no effect on the errors?
decay = -2 * sp.sqrt(a**2 + Q * h**2 / R)  # Is this the rate of the square of an error?
unobservable_variance = Q / (2 * a)  # Is this a variance? (hint 1)
unobservable_variance = -Q / a  # At what rate does the square of an error change?
unobservable_variance = 0 * Q  # Is there no noise where nothing is measured?
quiet = 0 * a  # What becomes of an error that is not zero? (hint 1)
quiet = a * R / h**2  # At what rate does the variance of a growing process change?
quiet = 2 * a * R  # Is everything measured with the factor 1 here?

# %% right
steady = Q / (sp.sqrt(a**2 + Q * h**2 / R) - a)  # the other form of the root
# by the sign of a
exists = sp.Or(a < 0, sp.And(sp.Ne(h, 0), a > 0), sp.And(sp.Ne(h, 0), Q > 0))
gain = h * Q / R / (sp.sqrt(a**2 + Q * h**2 / R) - a)  # the other form of the root

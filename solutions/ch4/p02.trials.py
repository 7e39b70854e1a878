# %% wrong
a_zero = h > 0  # Does it matter whether the satellites are above or below the origin? (hint 2)
a_zero = sp.true  # Are the three vectors independent for every height? (hint 2)
b_fixes = [(2 - sp.sqrt(3 * q - 8)) / 3]  # In how many points do three spheres meet?
# How many components of the difference are squared? (hint 1)
b_fixes = [(2 + sign * sp.sqrt(3 * q - 4)) / 3 for sign in (1, -1)]
b_fixes = [sp.sqrt(q / 3), -sp.sqrt(q / 3)]  # From where are the ranges measured? (hint 1)
b_real = q > 0  # Do three spheres meet however small they are? (hint 2)
b_real = 3 * q > 8  # What happens if the spheres just touch? (hint 1)
b_real = q >= 3  # Is the distance between receiver and plane zero yet? (hint 1)
c_other = sp.Integer(0)  # Put the second root into the fourth residual. (hint 2)
c_other = 64 * (sp.Rational(4, 3) - a) ** 2  # Do all four residuals count? (hint 2)
c_other = 192 * (sp.Rational(4, 3) - a) ** 2  # Was the fourth satellite left out of the sum?
# Which part of the gradient do the normal equations not contain? (hint 1)
d_slope = sp.Integer(0)
# In which direction does a residual change when x moves? (hint 1)
d_slope = 4 * (1 - 3 * p) * e4 * sum(c**2 for c in x)
d_slope = -4 * e4 * sum(c**2 for c in x)  # Are the first three residuals zero? (hint 2)
# Two factors of 2 arise here: one of the squares, and another one.
d_slope = 2 * (3 * p - 1) * e4 * sum(c**2 for c in x)
e_sum = sp.Rational(25, 144)  # Is this one square or all of them?
e_sum = sp.Rational(49, 4)  # Are both roots equally good? (hint 2)
e_least = sp.Integer(0)  # Do four spheres with an error have a common point?
e_least = sp.Rational(25, 36)  # Is the gradient zero at the algebraic estimate? (hint 1)
e_least = sp.Rational(1, 4)  # Is this the value at the true position?

# %% right
a_zero = sp.Ne(h**2, 0)  # by the determinant of G
# by completing the square
b_fixes = [sp.Rational(2, 3) + sign * sp.sqrt(q / 3 - sp.Rational(8, 9)) for sign in (1, -1)]
b_real = sp.sqrt(q) >= sp.sqrt(sp.Rational(8, 3))  # by the range instead of its square
c_other = 64 * (sp.Rational(8, 3) - 2 * a) ** 2  # by the distance of the roots
d_slope = -4 * (e4 - 3 * p * e4) * sum(c**2 for c in x)  # by the sum of the residuals
e_sum = 0.694  # rounded
e_least = 0.0740  # rounded

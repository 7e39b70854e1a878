# %% wrong
a_unobservable_displacements = []  # Does it depend on the vectors from the origin, or on the lines of sight? (hint 2)
# Does a displacement towards a satellite leave its range as it is? (hint 1)
a_unobservable_displacements = [[1, 0, 0]]
# Is this the criterion as it is printed? Try it on item a. (hint 2)
b_determined = sp.Or(sp.Ne(h, 0), sp.Ne(k, 0))
b_determined = sp.Ne(h, 0)  # What is special about the height of the origin? (hint 2)
b_determined = h > k  # Is the position of a receiver above its satellites undetermined? (hint 1)
# Are the three satellites at these distances? (hint 1)
c_determined = sp.Ne(x[0] + x[1] + x[2], 1)
# Does a satellite lie in the plane of this equation? (hint 1)
c_determined = sp.Ne(a * x[0] + b * x[1] + c * x[2], 1)
# Is this right for a receiver outside the plane through the origin? (hint 1)
d_unobservable_displacements = [[0, 0, 1]]
# Check one dot product with a line of sight. (hint 1)
d_unobservable_displacements = [[b * x[2], a * x[2], b * x[0] + a * x[1] - a * b]]
d_unobservable_displacements = []  # Do two numbers determine three? (hint 1)
e_determined = sp.Ne(p, 1)  # Which three points determine the plane? (hint 1)
e_determined = sp.Ne(p, 0)  # Is the origin one of the points? (hint 1)
# Does it matter on which side of the plane the fourth one is?
e_determined = p > sp.Rational(1, 3)

# %% right
a_unobservable_displacements = [[0, 0, -5]]  # downwards
b_determined = sp.Or(h > k, h < k)  # above or below
c_determined = sp.Ne(x[0] / a + x[1] / b + x[2] / c, 1)  # by the intercepts
d_unobservable_displacements = [[x[2] / a, x[2] / b, 1 - x[0] / a - x[1] / b]]  # another multiple
e_determined = sp.Ne((3 * p - 1) ** 2, 0)  # as a square

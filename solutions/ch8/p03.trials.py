# %% wrong
# Is the product greatest halfway between two nodes? (hint 2)
a_product = 3 * h**3 / 8
a_product = sp.Integer(
    0
)  # Where are the zeros of the product, and where are its extremes? (hint 2)
a_product = 2 * h**2 / (3 * sp.sqrt(3))  # How many factors does the product have? (hint 1)
b_bound = h**3 / (9 * sp.sqrt(3))  # Which of the curves changes fastest? (hint 1)
b_bound = 4 * h**3 / (3 * sp.sqrt(3))  # Was the factorial left out? (hint 2)
# Does the third derivative decrease along the curve? Where is it greatest? (hint 1)
b_bound = 2 * h**3 * sp.exp(-2 * h) / (9 * sp.sqrt(3))
c_chebyshev = h**3 * 2 / 3  # What is the length of the interval, over four? (hint 2)
c_chebyshev = h**3 / 4  # This is the greatest product. What is its factor? (hint 1)
c_chebyshev = 2 * h**3 / (9 * sp.sqrt(3))  # Does only the number of nodes matter? (hint 1)
d_quotient = sp.exp(-2 * h)  # Is this the greatest or the least quotient? (hint 2)
# Are both values on the same curve? (hint 1)
d_quotient = 2 * sp.exp(2 * h)
d_quotient = sp.exp(h)  # How long is the interval? (hint 2)
e_rate = h**2 / 3  # Is the node at the end or in the middle? (hint 2)
# This is the bound of the value. Which factor of the product is lost by the derivative? (hint 1)
e_rate = 2 * h**3 / (9 * sp.sqrt(3))
e_rate = sp.Integer(0)  # Does an exact value imply an exact slope? (hint 1)

# %% right
a_product = sp.sqrt(sp.Rational(4, 27)) * h**3  # under one root
a_product = sp.Abs((h / sp.sqrt(3)) ** 3 - h**3 / sp.sqrt(3))  # the value at the extreme itself
b_bound = sp.Max(1, 2) * 2 * h**3 * sp.sqrt(3) / 54  # the greater of the two curves
c_chebyshev = 2 * (2 * h / 4) ** 3 / 3  # by (8.5)
d_quotient = (sp.cosh(h) + sp.sinh(h)) ** 2  # by hyperbolic functions
e_rate = (2 * h) ** 2 / 6  # over the factorial

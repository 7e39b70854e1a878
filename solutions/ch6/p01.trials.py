# %% wrong
# Are the signs of two entries taken as the paper prints them? (hint 2)
a_polynomial = (
    lam**4
    + (kappa / 6 - 4) * lam**3
    + (kappa / 3 + 6) * lam**2
    - (kappa / 6 + 4) * lam
    + 1
    + 2 * kappa / 3
)
# Are these the eigenvalues of the motion without measurements? (hint 1)
a_polynomial = (lam - 1) ** 4
# Is the square of w the same as the sum of the two squares? (hint 2)
b_reduced = w**2 + (kappa / 6 - 4) * w + 2 * kappa / 3 + 6
b_reduced = (w - 2) ** 2 + kappa * (w + 4)  # Was a factor in front of $\kappa$ lost? (hint 1)
# What is the sum of $\lambda$ and its inverse on the circle? (hint 1)
b_circle = (sp.cos(phi) - 2) ** 2 + kappa / 6 * (sp.cos(phi) + 4)
# Is this still complex, without the division that makes it real?
b_circle = (sp.exp(sp.I * phi) - 1) ** 4 + kappa / 6 * sp.exp(sp.I * phi) * (
    sp.exp(2 * sp.I * phi) + 4 * sp.exp(sp.I * phi) + 1
)
c_kappa = 0  # Is this the trivial zero of the discriminant? (hint 2)
c_kappa = 24  # Is this where a coefficient vanishes, instead of the discriminant? (hint 2)
d_digits = 0.500  # To which base was the logarithm taken? (hint 2)
d_digits = 1.649  # Is this the eigenvalue itself? How many digits does it correspond to? (hint 2)
# Does an error grow with the smallest eigenvalue or with the greatest? (hint 1)
d_digits = -0.217

# %% right
b_reduced = w**2 - 4.0 * w + 4.0 + kappa * w / 6 + kappa * 2 / 3  # decimals
# by the half angle
b_circle = 16 * sp.sin(phi / 2) ** 4 + kappa * (1 - sp.Rational(2, 3) * sp.sin(phi / 2) ** 2)
# by the double angle
b_circle = 6 - 8 * sp.cos(phi) + 2 * sp.cos(2 * phi) + kappa * (sp.cos(phi) + 2) / 3
# exact, by the complex root
z = sp.Rational(95, 48) + sp.I * sp.sqrt(575) / 48
d_digits = sp.log(sp.Abs((z + sp.sqrt(z**2 - 4)) / 2), 10).evalf(8)

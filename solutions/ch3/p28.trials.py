# %% wrong
a_gain = [6, 6]  # The law is $u = Kx$, with the sign plus. Does this gain stabilise?
a_gain = [-6, 0]  # Does this law leave a root without change of sign? (hint 1)
a_gain = [-4, -4]  # Is 4 the coefficient of the loop, which contains the free motion? (hint 2)
a_filter_gain = [-6, -6]  # The errors obey $A - LH$. Do they decay? (hint 1)
a_filter_gain = [6, 0]  # Does the noise act on the second equation, too? (hint 2)
# This is the guarantee for all regulators. Does this loop allow more? (hint 1)
b_factors = [sp.Rational(1, 2), sp.oo]
b_factors = [0, sp.oo]  # Without control the state grows. (hint 1)
b_factors = [sp.Rational(1, 3), 3]  # Which coefficient becomes negative for large $m$? (hint 1)
b_disk = 2  # What is $|1 + L|$ at high frequencies? (hint 1)
b_disk = sp.Rational(1, 2)  # Does the curve of an optimal regulator come so close to $-1$? (hint 1)
# For these factors all coefficients are positive. Is this enough for degree four? (hint 2)
c_factors = [sp.Rational(8, 9), sp.Rational(37, 36)]
# This is the guarantee of the regulator. Does the observer compute with this factor? (hint 1)
c_factors = [sp.Rational(1, 2), sp.oo]
c_factors = [sp.Rational(1, 3), sp.oo]  # Is this the interval of the whole state? (hint 1)
c_factors = [
    (19 - 2 * sp.sqrt(29)) / 9,
    sp.oo,
]  # Is there a coefficient that decreases with $m$? (hint 1)
c_disk = 1  # Is this the disk margin with the whole state? (hint 1)
c_disk = sp.Rational(1, 36)  # This is $m_2 - 1$. What is $|1 + L(0)|$? (hint 1)
c_disk = 37  # Is this the peak of the sensitivity?

# %% right
# by the spectral factor
a_gain = sp.Matrix([[-2 - sp.sqrt(4 + strength), -2 - sp.sqrt(4 + strength)]])
a_filter_gain = sp.Matrix([2 + sp.sqrt(4 + strength), 2 + sp.sqrt(4 + strength)])  # a column
b_factors = [(sp.sqrt(4 + strength) - 2) * 2 / strength, sp.oo]  # by the other root
b_disk = 1.0  # a decimal
c_factors = [sp.N(c_factors[0]), sp.N(c_factors[1])]  # decimals
c_disk = 1 / (1 + (2 + sp.sqrt(4 + strength)) ** 2)  # by the strength

# %% numbers
strength = [12, 5, 21, 32, 45, 77, 96, 117, 140, 165, 192, 221, 252, 285]
f = 2 + sp.sqrt(4 + strength)
D, p, second = f**2, 2 * f - 4, f**2 - 4 * f + 6
linear = p * (4 - 2 * second - p)
shown = [
    r"\int_0^\infty\big(«strength»\,(x_1 + x_2)^2 + u^2\big)\,dt",
    r"of the intensity $«strength»$ acts",
    r"$Q = «strength»\begin{pmatrix}",
]
a_gain = [-f, -f]
a_filter_gain = [f, f]
b_factors = [2 / f, sp.oo]
b_disk = 1
c_factors = [
    1 - (linear + sp.sqrt(linear**2 - 16 * p**2 * (2 - second))) / (8 * D),
    1 + 1 / D,
]
c_disk = 1 / (1 + D)

# %% wrong
# the signs of the entries (1,4) and (2,4) as they are printed in the paper
a_polynomial = lam**4 + (kappa/6 - 4)*lam**3 + (kappa/3 + 6)*lam**2 - (kappa/6 + 4)*lam + 1 + 2*kappa/3
a_polynomial = (lam - 1)**4  # the eigenvalues of the motion without measurements
b_reduced = w**2 + (kappa/6 - 4)*w + 2*kappa/3 + 6  # lambda^2 + 1/lambda^2 taken for w^2
b_reduced = (w - 2)**2 + kappa*(w + 4)  # the factor 6 of kappa lost
b_circle = (sp.cos(phi) - 2)**2 + kappa/6*(sp.cos(phi) + 4)  # w = cos(phi) instead of 2 cos(phi)
# P itself, still complex
b_circle = (sp.exp(sp.I*phi) - 1)**4 + kappa/6*sp.exp(sp.I*phi)*(sp.exp(2*sp.I*phi) + 4*sp.exp(sp.I*phi) + 1)
c_kappa = 0  # the trivial zero of the discriminant
c_kappa = 24  # the zero of the coefficient of w
d_digits = 0.500  # the natural logarithm
d_digits = 1.649  # the eigenvalue itself
d_digits = -0.217  # the digits that the smallest eigenvalue wins

# %% right
b_reduced = w**2 - 4.0*w + 4.0 + kappa*w/6 + kappa*2/3  # decimals
b_circle = 16*sp.sin(phi/2)**4 + kappa*(1 - sp.Rational(2, 3)*sp.sin(phi/2)**2)  # by the half angle
b_circle = 6 - 8*sp.cos(phi) + 2*sp.cos(2*phi) + kappa*(sp.cos(phi) + 2)/3  # by the double angle
# exact, by the complex root
z = sp.Rational(95, 48) + sp.I*sp.sqrt(575)/48
d_digits = sp.log(sp.Abs((z + sp.sqrt(z**2 - 4))/2), 10).evalf(8)

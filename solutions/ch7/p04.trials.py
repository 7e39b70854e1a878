# %% wrong
a_error = [5, 0, 0]  # an error of the good measurement
a_error = [0, sp.Rational(1, 100), 0]  # an error that is as great, but small beside H x
a_error = [0, 0, 100]  # an error that the estimate does not see
b_rows = 51540  # rounded up
b_rows = 17179  # n taken for the number of epochs with three measurements each
b_rows = 4545443  # K taken for n
c_condition = 2/delta  # only the leading term, given as exact
c_condition = (1 + sp.sqrt(1 + delta**2))**2/delta**2  # the ratio of the eigenvalues of the Gram matrix
d_fooling = 2/M  # only the leading term
d_fooling = 1/(M - 1)  # the square root dropped

# %% right
a_error = [0, -1000, 0]  # a greater error
a_error = sp.Matrix([-sp.Rational(1, 2), 6, 1])  # with small errors of the other measurements, as a column
c_condition = sp.cot(sp.atan(delta)/2)  # by the half angle
# by the cosine
c = (1 + delta**2)**sp.Rational(-1, 2)
c_condition = sp.sqrt((1 + c)/(1 - c))
d_fooling = 1/(M - 1) + 1/(M + 1)  # by partial fractions
d_fooling = sp.tan(2*sp.atan(1/M))  # by the half angle

# %% wrong
a_error = [5, 0, 0]  # Does an error of the good measurement matter? (hint 1)
a_error = [0, sp.Rational(1, 100), 0]  # Is this error small compared with the measurement? (hint 2)
a_error = [0, 0, 100]  # Does this error affect the estimate at all? (hint 1)
b_rows = 51540  # In which direction was it rounded? (hint 1)
b_rows = 17179  # Does n count rows or epochs of three measurements? (hint 1)
b_rows = 4545443  # Is K the same as n? (hint 1)
c_condition = 2 / delta  # Is this the leading term only? (hint 2)
# Is this the square of the condition number? (hint 2)
c_condition = (1 + sp.sqrt(1 + delta**2)) ** 2 / delta**2
d_fooling = 2 / M  # Is this the leading term only? (hint 1)
d_fooling = 1 / (M - 1)  # Was the square root dropped? (hint 1)

# %% right
a_error = [0, -1000, 0]  # a greater error
# with small errors of the other measurements, as a column
a_error = sp.Matrix([-sp.Rational(1, 2), 6, 1])
c_condition = sp.cot(sp.atan(delta) / 2)  # by the half angle
# by the cosine
c = (1 + delta**2) ** sp.Rational(-1, 2)
c_condition = sp.sqrt((1 + c) / (1 - c))
d_fooling = 1 / (M - 1) + 1 / (M + 1)  # by partial fractions
d_fooling = sp.tan(2 * sp.atan(1 / M))  # by the half angle

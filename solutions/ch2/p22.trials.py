# %% wrong
# Did the trace get the right sign? (hint 2)
first_equation = sp.Eq(x1.diff(t, 2) + 2 * x1.diff(t) + 4 * x1, u1)
# How do the off-diagonal elements enter the determinant? (hint 2)
first_equation = sp.Eq(x1.diff(t, 2) - 2 * x1.diff(t) - 2 * x1, u1)
# Was $x_2$ left out of the second equation? (hint 1)
first_equation = sp.Eq(x1.diff(t, 2), x1.diff(t) - 3 * x1 + u1)
# Was the control differentiated along with the equation? (hint 2)
second_equation = sp.Eq(x2.diff(t, 2) - 2 * x2.diff(t) + 4 * x2, u1)
# Was the control lost where $x_1$ was replaced? (hint 1)
second_equation = sp.Eq(x2.diff(t, 2) - 2 * x2.diff(t) + 4 * x2, u1.diff(t))
# Was a sign lost where $x_1$ was replaced? (hint 1)
second_equation = sp.Eq(x2.diff(t, 2) - 2 * x2.diff(t) + 4 * x2, u1.diff(t) + u1)
coordinate = [0, 1]  # Is this the coordinate that the control enters at once? (hint 1)
# Which sign does the control have in the equation of this coordinate? (hint 2)
coordinate = [-1, 0]

# %% right
# solved for the second derivative
first_equation = sp.Eq(x1.diff(t, 2), 2 * x1.diff(t) - 4 * x1 + u1)
# a square completed, with functions of one's own
s = sp.Symbol("t")
X, U = sp.Function("x1")(s), sp.Function("u1")(s)
inner = X.diff(s) - X
first_equation = sp.Eq(U, inner.diff(s) - inner + 3 * X)
# all on one side, times 3
second_equation = sp.Eq(3 * x2.diff(t, 2) - 6 * x2.diff(t) + 12 * x2 - 3 * u1.diff(t) + 3 * u1, 0)
# a derivative that is not carried out
second_equation = sp.Eq(sp.Derivative(x2.diff(t) - x2 - u1, t), x2.diff(t) - 4 * x2 - u1)

# %% wrong
first_equation = sp.Eq(x1.diff(t, 2) + 2*x1.diff(t) + 4*x1, u1)  # the sign of the trace
first_equation = sp.Eq(x1.diff(t, 2) - 2*x1.diff(t) - 2*x1, u1)  # the determinant taken as 1 - 3
first_equation = sp.Eq(x1.diff(t, 2), x1.diff(t) - 3*x1 + u1)  # x2 forgotten in the second equation
second_equation = sp.Eq(x2.diff(t, 2) - 2*x2.diff(t) + 4*x2, u1)  # the control not differentiated
second_equation = sp.Eq(x2.diff(t, 2) - 2*x2.diff(t) + 4*x2, u1.diff(t))  # the control lost where x1 is replaced
second_equation = sp.Eq(x2.diff(t, 2) - 2*x2.diff(t) + 4*x2, u1.diff(t) + u1)  # a sign where x1 is replaced
coordinate = [0, 1]  # the coordinate that the control enters
coordinate = [-1, 0]  # the other sign

# %% right
first_equation = sp.Eq(x1.diff(t, 2), 2*x1.diff(t) - 4*x1 + u1)  # solved for the second derivative
# a square completed, with functions of one's own
s = sp.Symbol("t")
X, U = sp.Function("x1")(s), sp.Function("u1")(s)
inner = X.diff(s) - X
first_equation = sp.Eq(U, inner.diff(s) - inner + 3*X)
second_equation = sp.Eq(3*x2.diff(t, 2) - 6*x2.diff(t) + 12*x2 - 3*u1.diff(t) + 3*u1, 0)  # all on one side, times 3
# a derivative that is not carried out
second_equation = sp.Eq(sp.Derivative(x2.diff(t) - x2 - u1, t), x2.diff(t) - 4*x2 - u1)

# %% wrong
a_law = -sp.sign(x1 + x2*sp.Abs(x2)/2)  # the transfer to the origin
a_law = -sp.sign(x2)  # brake
a_time = x2 + sp.sqrt(x2**2 + 2*sp.Abs(x1))  # right on one side only
a_time = sp.sign(x1)*x2 + 2*sp.sqrt(x2**2/2 + sp.Abs(x1))  # the time to the origin
a_reached = v > 0  # the motion leaves to the right there
a_others = x2**2 >= 2*sp.Abs(x1)  # motions away from the line counted in
a_others = False  # the maximum principle taken for sufficient
a_other_time = sp.Abs(x2) - sp.sqrt(x2**2 - 2*sp.Abs(x1))  # the first meeting with the line, where H = 0 fails
b_law = -sp.sign(x1)  # towards the line x1 = 0
b_time = x2  # the sign of the velocity forgotten
b_others = sp.And(x1*x2 < 0, x2**2 >= 2*sp.Abs(x1))  # as in item a

# %% right
a_law = sp.Piecewise((-1, x1 > 0), (1, True))  # two cases
a_law = -x1/sp.Abs(x1)  # a quotient
a_time = sp.Piecewise((x2 + sp.sqrt(x2**2 + 2*x1), x1 > 0), (-x2 + sp.sqrt(x2**2 - 2*x1), True))  # case by case
a_time = 2.0*sp.Abs(x1)/((x2**2 + 2*sp.Abs(x1))**0.5 - sp.sign(x1)*x2)  # the quotient form of the root, three digits
a_reached = sp.Interval(-sp.oo, 0)  # an interval
a_reached = -v >= 0  # with the border
a_others = sp.Or(sp.And(x1 > 0, x2 <= -sp.sqrt(2*x1)), sp.And(x1 < 0, x2 >= sp.sqrt(-2*x1)))  # side by side
# without roots and absolute values
a_others = sp.Or(sp.And(x1 > 0, x2 < 0, x2**2 > 2*x1), sp.And(x1 < 0, x2 > 0, x2**2 > -2*x1))
a_other_time = -sp.sign(x1)*x2 + sp.sqrt(x2**2 - 2*x1*sp.sign(x1))  # with the sign
a_other_time = sp.Piecewise((-x2 + sp.sqrt(x2**2 - 2*x1), x1 > 0), (x2 + sp.sqrt(x2**2 + 2*x1), True))  # case by case
b_law = sp.Piecewise((-1, x2 > 0), (1, x2 < 0), (0, True))  # two cases
b_law = 1 - 2*sp.Heaviside(x2)  # a step function
b_time = sp.Max(x2, -x2)  # the larger of two
b_others = sp.S.EmptySet  # the empty set

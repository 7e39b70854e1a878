# %% wrong
# Is this the law of the transfer to the origin? The velocity is free here. (hint 1)
a_law = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)
a_law = -sp.sign(x2)  # Is this a law that only brakes? (hint 1)
# Does this hold on both sides of the line? (hint 2)
a_time = x2 + sp.sqrt(x2**2 + 2 * sp.Abs(x1))
# Is this the time to the origin, where the velocity is zero too? (hint 1)
a_time = sp.sign(x1) * x2 + 2 * sp.sqrt(x2**2 / 2 + sp.Abs(x1))
# Does a motion from the right arrive with such a velocity, or leave? (hint 1)
a_reached = v > 0
# Do these motions meet the line, or move away from it? (hint 1)
a_others = x2**2 >= 2 * sp.Abs(x1)
a_others = False  # Is every extremal optimal, so that there is only one? (hint 1)
# Is this the first meeting with the line? Look at H there. (hint 1)
a_other_time = sp.Abs(x2) - sp.sqrt(x2**2 - 2 * sp.Abs(x1))
b_law = -sp.sign(x1)  # Is this the law for the other line? (hint 1)
b_time = x2  # Can the velocity be negative as well? (hint 1)
b_others = sp.And(x1 * x2 < 0, x2**2 >= 2 * sp.Abs(x1))  # Is this the condition of item a? (hint 1)

# %% right
a_law = sp.Piecewise((-1, x1 > 0), (1, True))  # two cases
a_law = -x1 / sp.Abs(x1)  # a quotient
# case by case
a_time = sp.Piecewise((x2 + sp.sqrt(x2**2 + 2 * x1), x1 > 0), (-x2 + sp.sqrt(x2**2 - 2 * x1), True))
# the quotient form of the root, three digits
a_time = 2.0 * sp.Abs(x1) / ((x2**2 + 2 * sp.Abs(x1)) ** 0.5 - sp.sign(x1) * x2)
a_reached = sp.Interval(-sp.oo, 0)  # an interval
a_reached = -v >= 0  # with the border
# side by side
a_others = sp.Or(sp.And(x1 > 0, x2 <= -sp.sqrt(2 * x1)), sp.And(x1 < 0, x2 >= sp.sqrt(-2 * x1)))
# without roots and absolute values
a_others = sp.Or(sp.And(x1 > 0, x2 < 0, x2**2 > 2 * x1), sp.And(x1 < 0, x2 > 0, x2**2 > -2 * x1))
a_other_time = -sp.sign(x1) * x2 + sp.sqrt(x2**2 - 2 * x1 * sp.sign(x1))  # with the sign
# case by case
a_other_time = sp.Piecewise(
    (-x2 + sp.sqrt(x2**2 - 2 * x1), x1 > 0), (x2 + sp.sqrt(x2**2 + 2 * x1), True)
)
b_law = sp.Piecewise((-1, x2 > 0), (1, x2 < 0), (0, True))  # two cases
b_law = 1 - 2 * sp.Heaviside(x2)  # a step function
b_time = sp.Max(x2, -x2)  # the larger of two
b_others = sp.S.EmptySet  # the empty set

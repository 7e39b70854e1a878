# %% wrong
least_rate = x - 1  # Does this hold for negative states as well? (hint 2)
# Is this the rate of x instead of that of its absolute value? (hint 1)
least_rate = sp.sign(x) * (x - 1)
least_rate = sp.Abs(x) + 1  # Is this the maximum rate instead of the minimum? (hint 1)
least_rate = -1  # Was the instability forgotten? (hint 1)
# Can the origin be reached from everywhere, as the problem book says? (hint 2)
solvable = sp.true
solvable = sp.Abs(x0) <= 1  # Can the state be moved inwards from the boundary? (hint 2)
solvable = x0 < 1  # Does this hold for negative states as well? (hint 1)
time = sp.log(1 + sp.Abs(x0))  # Is this the time of a stable system? (hint 1)
time = -sp.log(1 - x0)  # Does this hold for negative states as well? (hint 1)
time = sp.Abs(x0)  # Was the instability forgotten? (hint 1)
control = sp.sign(x0)  # Does this push away from zero instead of towards it? (hint 2)
control = -1  # Does this hold for negative states as well? (hint 2)
control = -x0  # Is this the control that keeps the state constant? (hint 2)
control = -sp.sign(x0) * (1 + sp.Abs(x0)) / 2  # Is a part of the force left unused here? (hint 1)
# Is this the motion of a stable system? (hint 1)
trajectory = sp.sign(x0) * ((1 + sp.Abs(x0)) * sp.exp(-t) - 1)
trajectory = x0 - t * sp.sign(x0)  # Was the instability forgotten? (hint 1)
trajectory = 1 - (1 - x0) * sp.exp(t)  # Does this hold for negative states as well? (hint 1)
# Does the costate grow like the state? (hint 1)
costate = -sp.sign(x0) * sp.exp(t) / (1 - sp.Abs(x0))
# Does H vanish with this costate? It has to be normalised. (hint 1)
costate = -sp.sign(x0) * sp.exp(-t)
# Does H have a maximum or a minimum for this sign? (hint 1)
costate = sp.sign(x0) * sp.exp(-t) / (1 - sp.Abs(x0))

# %% right
least_rate = (x**2 - sp.Abs(x)) / sp.Abs(x)  # as a quotient
least_rate = sp.Piecewise((x - 1, x > 0), (-x - 1, True))  # cases
solvable = sp.And(x0 > -1, x0 < 1, sp.Ne(x0, 0))  # two inequalities, zero left out
solvable = x0**2 < 1  # a square
time = sp.log(1 / (1 - sp.Abs(x0)))  # the logarithm of a quotient
# cases, plain symbols
p = sp.Symbol("x0")
time = sp.Piecewise((-sp.log(1 - p), p > 0), (-sp.log(1 + p), True))
control = -x0 / sp.Abs(x0)  # a quotient
control = [(-sp.sign(x0), -sp.log(1 - sp.Abs(x0)))]  # a list of one arc
control = sp.Piecewise((-1, x0 > 0), (1, True))  # cases
trajectory = sp.sign(x0) * (1 - sp.exp(t + sp.log(1 - sp.Abs(x0))))  # by the minimum time
# cases
trajectory = sp.Piecewise((1 - (1 - x0) * sp.exp(t), x0 > 0), ((1 + x0) * sp.exp(t) - 1, True))
costate = sp.exp(-t) / (x0 - sp.sign(x0))  # without the absolute value
costate = [-sp.sign(x0) * sp.exp(-sp.log(1 - sp.Abs(x0)) - t)]  # by the remaining time

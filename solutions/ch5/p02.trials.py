# %% wrong
least_rate = x - 1  # for positive x only
least_rate = sp.sign(x)*(x - 1)  # the rate of x with u = -1, which is the least rate of x and not of |x|
least_rate = sp.Abs(x) + 1  # the greatest rate
least_rate = -1  # the instability forgotten
solvable = sp.true  # every start, as the problem book has it
solvable = sp.Abs(x0) <= 1  # the border counted in, from which the point cannot be moved inwards
solvable = x0 < 1  # for positive x0 only
time = sp.log(1 + sp.Abs(x0))  # a stable system assumed, x' = -x + u
time = -sp.log(1 - x0)  # for positive x0 only
time = sp.Abs(x0)  # x' = u
control = sp.sign(x0)  # along with the start instead of against it
control = -1  # for positive x0 only
control = -x0  # the control that holds the point where it is
control = -sp.sign(x0)*(1 + sp.Abs(x0))/2  # arrives, but too late: half the force is left unused for small x0
trajectory = sp.sign(x0)*((1 + sp.Abs(x0))*sp.exp(-t) - 1)  # a stable system assumed
trajectory = x0 - t*sp.sign(x0)  # x' = u
trajectory = 1 - (1 - x0)*sp.exp(t)  # for positive x0 only
costate = -sp.sign(x0)*sp.exp(t)/(1 - sp.Abs(x0))  # grows like the state
costate = -sp.sign(x0)*sp.exp(-t)  # not normalised
costate = sp.sign(x0)*sp.exp(-t)/(1 - sp.Abs(x0))  # the sign turned: H is least then

# %% right
least_rate = (x**2 - sp.Abs(x))/sp.Abs(x)  # as a quotient
least_rate = sp.Piecewise((x - 1, x > 0), (-x - 1, True))  # cases
solvable = sp.And(x0 > -1, x0 < 1, sp.Ne(x0, 0))  # two inequalities, zero left out
solvable = x0**2 < 1  # a square
time = sp.log(1/(1 - sp.Abs(x0)))  # the logarithm of a quotient
# cases, plain symbols
p = sp.Symbol("x0")
time = sp.Piecewise((-sp.log(1 - p), p > 0), (-sp.log(1 + p), True))
control = -x0/sp.Abs(x0)  # a quotient
control = [(-sp.sign(x0), -sp.log(1 - sp.Abs(x0)))]  # a list of one arc
control = sp.Piecewise((-1, x0 > 0), (1, True))  # cases
trajectory = sp.sign(x0)*(1 - sp.exp(t + sp.log(1 - sp.Abs(x0))))  # by the least time
trajectory = sp.Piecewise((1 - (1 - x0)*sp.exp(t), x0 > 0), ((1 + x0)*sp.exp(t) - 1, True))  # cases
costate = sp.exp(-t)/(x0 - sp.sign(x0))  # without the absolute value
costate = [-sp.sign(x0)*sp.exp(-sp.log(1 - sp.Abs(x0)) - t)]  # by the time that is left

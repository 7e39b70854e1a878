# %% wrong
time = (b - a)/A  # only for b to the right of a
time = sp.Abs(b - a)  # the bound forgotten
time = A*sp.Abs(b - a)  # multiplied by the speed
control = A  # always to the right
control = sp.sign(b - a)  # the unit velocity
control = b - a  # a constant velocity that would need the time 1
control = A*sp.sign(a - b)  # away from b
trajectory = a - A*t*sp.sign(b - a)  # away from b
trajectory = b + A*t*sp.sign(b - a)  # starts at b
trajectory = a + (b - a)*t  # uniform, but arriving at t = 1
costate = sp.sign(b - a)  # not normalised: H = 0 does not hold
costate = -sp.sign(b - a)/A  # the sign turned: H is least then
costate = t*sp.sign(b - a)/A  # a costate that grows with time
reached = b - a <= A*T  # to the right only
reached = sp.Abs(b - a) < A*T  # the border left out, though it is reached at the time T
reached = sp.Abs(b - a) <= T  # the distance compared with the time

# %% right
time = sp.Piecewise(((b - a)/A, b > a), ((a - b)/A, True))  # cases
control = A*(b - a)/sp.Abs(b - a)  # as a quotient
control = sp.Piecewise((A, b > a), (-A, True))  # cases
control = [[A*sp.sign(b - a), sp.Abs(b - a)/A]]  # a list of one arc [value, until]
# cases, plain symbols
p, q, s, c = sp.symbols("a b t A")
trajectory = sp.Piecewise((p + c*s, q > p), (p - c*s, True))
trajectory = a + (b - a)*t/(sp.Abs(b - a)/A)  # by the least time
trajectory = [a + A*sp.sign(b - a)*t]  # a list with one state
costate = (b - a)/(A*sp.Abs(b - a))  # a quotient
costate = sp.Matrix([sp.Piecewise((1/A, b > a), (-1/A, True))])  # a column, cases
reached = sp.And(b <= a + A*T, b >= a - A*T)  # two inequalities
reached = (b - a)**2 <= A**2*T**2  # squares

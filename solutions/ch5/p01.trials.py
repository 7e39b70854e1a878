# %% wrong
time = (b - a) / A  # Can b lie on the other side of a as well? (hint 1)
time = sp.Abs(b - a)  # Was the bound of the speed forgotten? (hint 1)
time = A * sp.Abs(b - a)  # Is the distance multiplied by the speed here? (hint 1)
control = A  # Does the motion always go to the right? (hint 2)
control = sp.sign(b - a)  # Is the bound of the control 1? (hint 1)
control = b - a  # Does this velocity need just the time 1, whatever the bound? (hint 1)
control = A * sp.sign(a - b)  # Does this lead away from b? (hint 2)
trajectory = a - A * t * sp.sign(b - a)  # Does this lead away from b? (hint 1)
trajectory = b + A * t * sp.sign(b - a)  # Where does the motion begin? (hint 1)
trajectory = a + (b - a) * t  # Does the motion arrive at the time 1, whatever the bound? (hint 1)
costate = sp.sign(b - a)  # Does H vanish with this costate? It has to be normalised. (hint 1)
costate = -sp.sign(b - a) / A  # Does H have a maximum or a minimum for this sign? (hint 1)
costate = t * sp.sign(b - a) / A  # Does the costate change with time?
reached = b - a <= A * T  # Can b lie on the other side of a as well? (hint 1)
reached = sp.Abs(b - a) < A * T  # Is b also reached at the final time itself? (hint 2)
reached = sp.Abs(b - a) <= T  # Was the bound of the speed forgotten? (hint 1)

# %% right
time = sp.Piecewise(((b - a) / A, b > a), ((a - b) / A, True))  # cases
control = A * (b - a) / sp.Abs(b - a)  # as a quotient
control = sp.Piecewise((A, b > a), (-A, True))  # cases
control = [[A * sp.sign(b - a), sp.Abs(b - a) / A]]  # a list of one arc [value, until]
# cases, plain symbols
p, q, s, c = sp.symbols("a b t A")
trajectory = sp.Piecewise((p + c * s, q > p), (p - c * s, True))
trajectory = a + (b - a) * t / (sp.Abs(b - a) / A)  # by the minimum time
trajectory = [a + A * sp.sign(b - a) * t]  # a list with one state
costate = (b - a) / (A * sp.Abs(b - a))  # a quotient
costate = sp.Matrix([sp.Piecewise((1 / A, b > a), (-1 / A, True))])  # a column, cases
reached = sp.And(b <= a + A * T, b >= a - A * T)  # two inequalities
reached = (b - a) ** 2 <= A**2 * T**2  # squares

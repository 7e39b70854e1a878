# %% wrong
point = [sp.atan(k/k1), sp.sqrt(g)/(k**2 + k1**2)**sp.Rational(1, 4)]  # a climb: the sign of the sine overlooked
point = [-sp.atan(k1/k), sp.sqrt(g)/(k**2 + k1**2)**sp.Rational(1, 4)]  # lift and drag exchanged
point = [-sp.atan(k/k1), sp.sqrt(g)/sp.sqrt(k**2 + k1**2)]  # the fourth root taken as a square root
# the two parts of d(angle rate)/dv cancelled instead of added
matrix = sp.Matrix([[-k*v, 0], [-k1*v**2, -2*k*v]]).subs(v, sp.sqrt(g)/(k**2 + k1**2)**sp.Rational(1, 4))
# the order of the state not kept
matrix = sp.Matrix([[-2*k*v, -k1*v**2], [2*k1, -k*v]]).subs(v, sp.sqrt(g)/(k**2 + k1**2)**sp.Rational(1, 4))
stability = "stable"  # the oscillation without drag in mind
focus = 9*k**2 < 2*(k**2 + k1**2)  # the trace compared with the determinant instead of its fourfold
focus = k < 8*k1  # the root of 8 forgotten
node = k**2 < 8*k1**2  # the condition of the focus
node = k > k1  # more drag than lift taken for enough
angle_curve = sp.sqrt(g*sp.cos(theta))  # the drag coefficient in the place of the lift
angle_curve = g*sp.cos(theta)/k1  # the square root forgotten
speed_curve = sp.sqrt(g*sp.sin(theta)/k)  # the sign of the weight turned
speed_curve = -g*sp.sin(theta)/k  # the square root forgotten
no_cycles = [sp.Integer(1), g*sp.sin(theta)/v - 2*k*v]  # no multiplier: the divergence changes its sign
no_cycles = [v, v*(g*sp.sin(theta)/v - 2*k*v)]  # the multiplier not differentiated
integral = v**2/2  # the energy of the speed alone
integral = k1*v**2/2 - g*sp.cos(theta)*sp.log(v)  # the square instead of the cube: the multiplier left out
integral = g/k1  # a constant is kept, too, but tells nothing
border = sp.sqrt(g*sp.cos(theta)/k1)  # the curve where the angle rests, taken for a motion
border = 3*sp.sqrt(g*sp.cos(theta)/k1)  # the right factor outside of the root

# %% right
# the angle by its sine, plain symbols
point = [-sp.asin(sp.Symbol("k")/sp.sqrt(sp.Symbol("k")**2 + sp.Symbol("k1")**2)),
         sp.sqrt(sp.Symbol("g")/sp.sqrt(sp.Symbol("k")**2 + sp.Symbol("k1")**2))]
# the derivatives as they come
matrix = field.jacobian(state).subs({theta: -sp.atan(k/k1), v: sp.sqrt(g)/(k**2 + k1**2)**sp.Rational(1, 4)})
focus = k < 2.83*k1  # solved for k, with decimals
focus = sp.Symbol("k")**2 - 8*sp.Symbol("k1")**2 <= 0  # the discriminant, plain symbols, the border counted in
node = k1 < k/(2*sp.sqrt(2))  # solved for the lift
node = sp.Not(k < sp.sqrt(8)*k1)  # not the focus
angle_curve = (sp.Symbol("g")*sp.cos(sp.Symbol("theta"))/sp.Symbol("k1"))**0.5  # a decimal power, plain symbols
speed_curve = [sp.sqrt(-sp.sin(theta))*sp.sqrt(g/k)]  # as a list with one branch
no_cycles = [-2*v, 6*k*v**2]  # another factor
integral = (v*sp.sqrt(k1/g))**3 - 3*v*sp.sqrt(k1/g)*sp.cos(theta)  # in units of the speed of level flight
integral = sp.exp(v*(k1*v**2 - 3*g*sp.cos(theta))/(10*g))  # a function of a first integral is one as well
border = (3*sp.Symbol("g")*sp.cos(sp.Symbol("theta"))/sp.Symbol("k1"))**sp.Rational(1, 2)  # a plain power

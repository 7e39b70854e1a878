# %% wrong
# Does an aircraft without an engine climb? Look at the sign of the sine. (hint 1)
point = [sp.atan(k / k1), sp.sqrt(g) / (k**2 + k1**2) ** sp.Rational(1, 4)]
# Were lift and drag swapped? (hint 2)
point = [-sp.atan(k1 / k), sp.sqrt(g) / (k**2 + k1**2) ** sp.Rational(1, 4)]
# Which power of the speed does the sum of the squares give? (hint 2)
point = [-sp.atan(k / k1), sp.sqrt(g) / sp.sqrt(k**2 + k1**2)]
# The rate of the angle contains v twice. Do the two parts of its derivative add or cancel? (hint 2)
matrix = sp.Matrix([[-k * v, 0], [-k1 * v**2, -2 * k * v]]).subs(
    v, sp.sqrt(g) / (k**2 + k1**2) ** sp.Rational(1, 4)
)
# In which order does the problem list the state? (hint 1)
matrix = sp.Matrix([[-2 * k * v, -k1 * v**2], [2 * k1, -k * v]]).subs(
    v, sp.sqrt(g) / (k**2 + k1**2) ** sp.Rational(1, 4)
)
stability = "stable"  # Is this true of the flight without drag? (hint 1)
# Was the squared trace compared with the determinant instead of four times the determinant? (hint
# 1)
focus = 9 * k**2 < 2 * (k**2 + k1**2)
focus = k < 8 * k1  # Was a root forgotten? The discriminant compares squares. (hint 1)
node = k**2 < 8 * k1**2  # Is this the condition for the other type of point? (hint 1)
node = k > k1  # Is it enough that there is more drag than lift? (hint 1)
# Does the lift or the drag turn the trajectory? (hint 1)
angle_curve = sp.sqrt(g * sp.cos(theta))
angle_curve = g * sp.cos(theta) / k1  # Was the square root forgotten? (hint 1)
speed_curve = sp.sqrt(g * sp.sin(theta) / k)  # Which sign does the sine have in a glide? (hint 1)
speed_curve = -g * sp.sin(theta) / k  # Was the square root forgotten? (hint 1)
# Does this divergence keep its sign? Without a multiplier no conclusion follows. (hint 1)
no_cycles = [sp.Integer(1), g * sp.sin(theta) / v - 2 * k * v]
# Was the multiplier differentiated as well? (hint 2)
no_cycles = [v, v * (g * sp.sin(theta) / v - 2 * k * v)]
integral = v**2 / 2  # Is the kinetic energy conserved by itself? What about the height? (hint 1)
# Was the multiplier left out, so that a square appears instead of a cube? (hint 1)
integral = k1 * v**2 / 2 - g * sp.cos(theta) * sp.log(v)
integral = g / k1  # Does a constant distinguish one motion from another? (hint 2)
# Is this the curve where the angle is constant? It is not a motion. (hint 1)
border = sp.sqrt(g * sp.cos(theta) / k1)
border = 3 * sp.sqrt(g * sp.cos(theta) / k1)  # Does this factor belong inside the root? (hint 2)

# %% right
# the angle by its sine, plain symbols
point = [
    -sp.asin(sp.Symbol("k") / sp.sqrt(sp.Symbol("k") ** 2 + sp.Symbol("k1") ** 2)),
    sp.sqrt(sp.Symbol("g") / sp.sqrt(sp.Symbol("k") ** 2 + sp.Symbol("k1") ** 2)),
]
# the derivatives as they come
matrix = field.jacobian(state).subs(
    {theta: -sp.atan(k / k1), v: sp.sqrt(g) / (k**2 + k1**2) ** sp.Rational(1, 4)}
)
focus = k < 2.83 * k1  # solved for k, with decimals
# the discriminant, plain symbols, the border counted in
focus = sp.Symbol("k") ** 2 - 8 * sp.Symbol("k1") ** 2 <= 0
node = k1 < k / (2 * sp.sqrt(2))  # solved for the lift
node = sp.Not(k < sp.sqrt(8) * k1)  # not the focus
# a decimal power, plain symbols
angle_curve = (sp.Symbol("g") * sp.cos(sp.Symbol("theta")) / sp.Symbol("k1")) ** 0.5
speed_curve = [sp.sqrt(-sp.sin(theta)) * sp.sqrt(g / k)]  # as a list with one branch
no_cycles = [-2 * v, 6 * k * v**2]  # another factor
# in units of the speed of level flight
integral = (v * sp.sqrt(k1 / g)) ** 3 - 3 * v * sp.sqrt(k1 / g) * sp.cos(theta)
# a function of a first integral is one as well
integral = sp.exp(v * (k1 * v**2 - 3 * g * sp.cos(theta)) / (10 * g))
# a plain power
border = (3 * sp.Symbol("g") * sp.cos(sp.Symbol("theta")) / sp.Symbol("k1")) ** sp.Rational(1, 2)

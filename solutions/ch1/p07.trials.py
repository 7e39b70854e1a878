# %% wrong
exists = P >= m*g  # the hovering rocket counted as a climb
exists = P > g  # the thrust compared with the acceleration of gravity: the mass forgotten
exists = sp.Ne(P, m*g)  # both signs of the radicand thought possible
speed = sp.sqrt((P + m*g)/k)  # the sign of the weight turned
speed = sp.sqrt((P - g)/k)  # the weight written without the mass
speed = -sp.sqrt((P - m*g)/k)  # the root of the formula that lies outside its range
deviation = -sp.sqrt(k*(P - m*g))/m  # the square differentiated without its factor 2
deviation = 2*sp.sqrt(k*(P - m*g))/m  # the second root put in
deviation = -2*sp.sqrt(k*(P - m*g))  # the mass lost
stability = "unstable"  # growth seen in the positive thrust
stability = "stable"  # the velocity does come back, not only stay close
fall_acceleration = sp.Integer(0)  # the drag left pointing downwards: the second root taken for a motion
fall_acceleration = (P - m*g)/m  # the drag forgotten

# %% right
exists = sp.Symbol("P")/(sp.Symbol("m")*sp.Symbol("g")) > 1  # as a ratio of thrust and weight, plain symbols
exists = (P - m*g)/k > 0  # the radicand
speed = sp.sqrt((sp.Symbol("P") - sp.Symbol("m")*sp.Symbol("g"))/sp.Symbol("k"))  # with plain symbols
speed = [(P/k - m*g/k)**sp.Rational(1, 2)]  # as a list with one solution, in powers
deviation = sp.Matrix([[-2.0*sp.sqrt(k*P - k*m*g)/m]])  # as a matrix with one element, a decimal factor

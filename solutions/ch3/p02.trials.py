# %% wrong
# Are these the coefficients of the polynomial instead of the gain? (hint 1)
a_gain = sp.Matrix([beta1, beta2, beta3])
# Was the last coefficient compared without the other gains? (hint 2)
a_gain = sp.Matrix([beta1, beta2 + 2, beta3 + 2])
a_gain = []  # Does a growing motion rule out an observer?
a_margins = mu <= 1  # Is this the best of all choices, or only one of them? (hint 1)
# Is this the gain of item a? Another coordinate is measured here. (hint 1)
b_gain = sp.Matrix([beta1, beta2 + 2, beta1 - beta2 + beta3])
# Was a factor lost in the determinant? (hint 1)
b_gain = sp.Matrix([beta3 + 1, beta1, beta2 - beta1 - beta3 + 1])
b_margins = sp.false  # Is the position not observable from a rate in this system? (hint 1)
# Were all three coefficients compared, or only two? (hint 1)
c_gain = sp.Matrix([beta1 + 2, beta2, beta1 + 2])
c_margins = sp.true  # Does the condition cover the fixed root as well? (hint 1)
c_margins = mu <= 1  # Is zero a degree of stability? (hint 1)
c_obstacle = {}  # Is a constant error no obstacle? (hint 1)
c_obstacle = {0: [1, -1, 0]}  # Is this state unobservable? Put it into z. (hint 1)
c_obstacle = {2: [2, 1, 1]}  # Is this the growing motion, and is it unobservable? (hint 1)
d_gain = sp.Matrix([beta1, beta2, beta3])  # Is this polynomial possible at all? (hint 1)
d_margins = mu <= 1  # Is this an observable eigenvalue, which can be moved? (hint 1)
d_obstacle = {-1: [2, -1, 1]}  # Does this motion decay? (hint 1)
d_obstacle = {0: [1, 0, -1]}  # Was a sign lost? Put the state into the equations. (hint 1)
# Were all three coefficients compared, or only two? (hint 1)
e_gain = sp.Matrix([beta2, beta1 + 2, 0])
e_margins = sp.true  # Can a correction act on an error that is not measured? (hint 1)
e_obstacle = {0: [2, -1, 1]}  # Is this the equilibrium, and is it unobservable? (hint 1)
e_obstacle = {}  # Is it enough that the measured coordinate contains both others? (hint 1)
# Does the third entry of L act on the third coordinate? (hint 1)
f_gain = sp.Matrix([beta1 + 6, 0, beta2])
f_margins = mu <= 1  # What is the sign of the fixed root? (hint 1)
f_obstacle = {1: [1, 0, 0]}  # Is this a motion of the system at all? (hint 1)
f_obstacle = {}  # Does a coordinate become known because a measured quantity drives it? (hint 1)

# %% right
a_gain = [beta1, beta2 + 2, beta3 + beta1 - beta2]  # a flat list
a_margins = mu**2 > 0  # the same as every degree of stability
# over two, as a row
b_gain = sp.Matrix([[beta3 + 2, 2 * beta1, 2 * beta2 - 2 * beta1 - beta3 + 2]]) / 2
c_margins = mu < 0  # never, since mu is positive
c_obstacle = {0: sp.Matrix([0, -2, 2])}  # another multiple
e_obstacle = {1.0: [0.5, 0, 0.5]}  # decimals
f_obstacle = {sp.Integer(1): sp.Matrix([[0, 0, -3]])}  # a row

# %% wrong
a_gain = sp.Matrix([beta1, beta2])  # Was the repulsion forgotten in the matrix? (hint 1)
# What is the sign of the repulsion in the characteristic polynomial? (hint 2)
a_gain = sp.Matrix([beta1, beta2 - 1])
# Is this the sign of a feedback $u = Kx$? The correction $L(z - He)$ enters the errors with a
# minus. (hint 1)
a_gain = sp.Matrix([-beta1, -beta2 - 1])
# Does the degree of stability end at the rate of the system's own motion? (hint 1)
a_margins = mu <= 1
# Is this the gain of item a? Another coordinate is measured here. (hint 1)
b_gain = sp.Matrix([beta1, beta2 + 1])
b_margins = sp.false  # Is the position not observable from a speed in this system? (hint 1)
# Is this the gain of item a? Both coordinates are measured at once here. (hint 1)
c_gain = sp.Matrix([beta1, beta2 + 1])
# Was only one of the two coefficients compared? (hint 1)
c_gain = sp.Matrix([beta1 / 2, beta1 / 2])
c_margins = sp.true  # Is there a root that no gain moves? (hint 1)
c_margins = sp.false  # Does every unobservable motion rule out an observer? (hint 2)
c_margins = mu < 1  # Is the rate of the fixed root itself not a degree of stability? (hint 2)
# Must both gains be large, or only the combination in the moving root? (hint 1)
c_region = sp.And(l1 > 1, l2 > 1)
c_region = l1 + l2 > 0  # Is it enough to look at the sum of the roots? (hint 1)
# Is this the gain of item a? The sign of the force differs. (hint 1)
d_gain = sp.Matrix([beta1, beta2 + 1])
d_margins = sp.false  # Does an undamped oscillation rule out an observer? (hint 1)
e_gain = sp.Matrix([beta2 - 1, beta1])  # Was a sign lost in the determinant? (hint 1)
e_margins = mu <= 2  # Is this the best of all choices, or only one of them? (hint 1)
f_gain = []  # Is this system like item c? Look at what z does not show. (hint 1)
# Is this half of the gain? Put it into the polynomial. (hint 1)
f_gain = sp.Matrix([beta1 - beta2 + 1, beta1 + beta2 - 1]) / 4
f_margins = mu <= 1  # Is this system like item c? Look at what z does not show. (hint 1)
g_gain = sp.Matrix([0, beta1 + 2])  # Was only the sum of the roots compared? (hint 1)
g_margins = sp.true  # Was the second coordinate looked at alone? (hint 1)
g_margins = mu <= 1  # What is the sign of the fixed root? (hint 1)
g_obstacle = {}  # Does z show the first coordinate after some time? (hint 1)
g_obstacle = {1: [0, 1]}  # Is this vector unobservable? Put it into z. (hint 1)
g_obstacle = {-1: [1, 0]}  # What is the sign of the root of this motion? (hint 1)
# Was a sign lost in the determinant? (hint 1)
h_gain = sp.Matrix([beta2 + 1, beta1 - beta2 + 3])
h_gain = []  # Is a double root never observable? Count its eigenvectors.
h_margins = sp.false  # Is a double root never observable? Count its eigenvectors. (hint 1)
# Is this system like item a? Look for a motion that z does not show. (hint 1)
i_gain = sp.Matrix([beta1, beta2])
i_gain = sp.Matrix([beta1 + 2, 0])  # Was only the sum of the roots compared? (hint 1)
i_obstacle = {1: [a, 1]}  # Was a sign lost? Put the vector into z. (hint 1)
i_obstacle = {1: [1, -1 / a]}  # What becomes of this vector where the divisor vanishes? (hint 2)
i_obstacle = {}  # Is it enough that both coordinates enter the measurement? (hint 1)

# %% right
a_gain = [beta1, 1 + beta2]  # a flat list
a_margins = mu > 0  # the same as every degree of stability
c_margins = 1 / mu >= 1  # divided by mu
c_region = sp.Not(l1 <= 1 - l2)  # the complement
# a sum, as a row
f_gain = sp.Matrix([[beta1, beta1]]) / 2 + sp.Matrix([[1 - beta2, beta2 - 1]]) / 2
g_obstacle = {1.0: [-3.0, 0]}  # decimals
h_gain = sp.Matrix([1 - beta2, beta1 + 2 - (1 - beta2)])  # not collected
i_obstacle = {1: [a, -1]}  # the opposite vector
i_obstacle = {1: [-a * (a**2 + 1), a**2 + 1]}  # a multiple that is never zero

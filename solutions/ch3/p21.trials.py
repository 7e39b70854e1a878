# %% wrong
# With what does the last equation hold the derivative of u: was it dropped? (hint 1)
system = [system[0], sp.Matrix([0, 0, 3]), *system[2:]]
# Is the new state variable the second derivative plus the control, or less the control? (hint 1)
system = [system[0], sp.Matrix([0, -1, 9]), *system[2:]]
# What does the 6 before the second derivative make of the control that was added to it? (hint 1)
system = [system[0], sp.Matrix([0, 1, 3]), *system[2:]]
# Can all three initial values of x be chosen in this form, or only two? (hint 2)
system = [system[0], sp.Matrix([0, 0, 1]), sp.Matrix([[3, 1, 0]]), sp.Matrix([[9, 6, 1]])]
# Which motions of the equation were lost when the common factor was cancelled? (hint 2)
system = [
    sp.Matrix([[0, 1], [-2, -3]]),
    sp.Matrix([0, 1]),
    sp.Matrix([[1, 0]]),
    sp.Matrix([[3, 1]]),
]
# Is z formed with the numbers in the order of the derivatives?
system = [*system[:3], sp.Matrix([[1, 3, 0]])]
# Were the signs on the left-hand side kept when the terms changed sides?
system = [sp.Matrix([[0, 1, 0], [0, 0, 1], [6, 11, 6]]), *system[1:]]
margins = sp.true  # Was something cancelled on the way? (hint 2)
margins = mu <= 1  # Is this what the system has without any feedback?
margins = mu < 3  # Look at the end of your interval: may all roots be as slow as that one?
margins = sp.false  # Something is lost. Does it grow or decay?
margins = mu <= 2  # Which of the three roots is the one that stays? (hint 1)
gains = [*system, -gains[4], gains[5]]  # Which sign has $K$ in $u = Ke$? (hint 1)
gains = [*system, gains[4], -gains[5]]  # Which sign has L in the observer? (hint 2)
# Is the loop faster than without a control? (hint 1)
gains = [*system, sp.zeros(1, 3), gains[5]]
gains = [*gains[:5], sp.zeros(3, 1)]  # How do the errors decay without a correction? (hint 2)
# Were these computed for an equation without a derivative of u?
gains = [*system, sp.Matrix([[-7, -sp.Rational(16, 3), -1]]), gains[5]]
# Does this form hold the derivative of u?
gains = [
    system[0],
    sp.Matrix([0, 0, 3]),
    *system[2:],
    sp.Matrix([[-7, -sp.Rational(16, 3), -1]]),
    gains[5],
]
static_region = k > -sp.Rational(2, 3)  # Was the feedback taken with a minus sign? (hint 1)
static_region = k < 3  # Is it enough that the sum of the roots is negative? (hint 1)
static_region = k <= sp.Rational(2, 3)  # What is the root at the end of your interval?
static_region = k < 2  # What was put into the place of the control, x or z? (hint 1)

# %% right
# the measurement and its rate as state variables: x, z, z' - u
system = [sp.Matrix([[-3, 1, 0], [0, 0, 1], [0, -2, -3]]), [0, 1, 0], [1, 0, 0], [0, 1, 0]]
# the observable canonical form
system = [
    sp.Matrix([[-6, 1, 0], [-11, 0, 1], [-6, 0, 0]]),
    sp.Matrix([0, 1, 3]),
    sp.Matrix([[1, 0, 0]]),
    sp.Matrix([[-3, 1, 0]]),
]
# other units
system = [system[0], 10.0 * system[1], system[2] / 10.0, system[3] / 10.0]
margins = sp.And(mu > 0, mu - 3 <= 0)  # in another form
# faster roots beside the one that stays
gains = [*system, sp.Matrix([[-18, -6, 0]]), sp.Matrix([1, 1, -5])]
# for the state x, z, z' - u: the feedback u = -4 z
gains = [
    sp.Matrix([[-3, 1, 0], [0, 0, 1], [0, -2, -3]]),
    [0, 1, 0],
    [1, 0, 0],
    [0, 1, 0],
    [0, -4, 0],
    [0, 4, 4],
]
static_region = 3 * k < 2  # a multiple

# %% wrong
process = {y: t, v: 1, w: 0}  # What does the friction do to a steady velocity?
process = {y: t, v: t, w: 1 + t}  # What is the derivative of t?
process = {y: t, v: 1, w: t}  # Which of the two derivatives enters the equation?
stability = "asymptotically stable"  # What does the friction do to a delay?
stability = "unstable"  # Is the zero eigenvalue a multiple one?
limit = [0, 0]  # Which combination of the deviations is constant?
limit = [x10, 0]  # How far does the system move while the velocity deviation decays?
limit = [x10 - x20, 0]  # Does a velocity that is too large make up a delay or add to it?
controllable = False  # Does the control not act on the position through the velocity?
place_gain = sp.Matrix([-3, -1])  # What is the sign of L in the observer?
place_gain = sp.Matrix([1, -1])  # Does that error decay?
place_gain = []  # What does the record of the position show about the velocity?
place_region = (l1 > 0) & (l2 > 0)  # Which expressions in the gains have to be positive?
place_region = (l1 > -1) & (l2 > 0)  # Does $l_1$ not enter it, too?
place_region = l1 > -1  # Can one root be positive while the sum is negative?
speed_gain = sp.Matrix([0, 3])  # The velocity is estimated well, but is the position?
speed_gain = sp.Matrix([3, 1])  # What is A - LH now?
speed_obstacle = {}  # Which column of the matrix N is zero?
speed_obstacle = {-1: [1, -1]}  # Is a decaying mode an obstacle?
speed_obstacle = {0: [0, 1]}  # Does the instrument not show it?

# %% right
process = [t, 1, 1]  # a list, the control last
limit = sp.Matrix([x20 + x10, 0])  # a column
place_gain = [1, 0]  # one coefficient is enough
place_gain = [0.0, 2.5]  # the other one alone
place_region = (1 + l1 > 0) & (l2 > -l1)  # solved for l2
speed_obstacle = {0.0: [-2.0, 0.0]}  # decimals, another multiple

# %% wrong
# Does the longitude not depend on the height? Differentiate it. (hint 1)
a_observable = False
# Does the longitude stay at rest when the height is constant? (hint 1)
a_unobservable_states = [[0, 1, 0, 0]]
# Does the rank fall wherever the upper square is singular? There is one more row. (hint 2)
a_unobservable_eigenvalues = {0, sp.I * Omega, -sp.I * Omega}
b_observable = True  # Does the height determine the longitude completely? (hint 1)
# Is this orbit really unobservable from the height? (hint 2)
b_unobservable_states = [[1, 0, 0, 0], [0, 2 * r0, -3 * Omega, 0]]
b_unobservable_states = [
    [0, 0, 1, 0]
]  # Do the equations allow a steady rate at height zero? (hint 2)
b_unobservable_eigenvalues = {
    sp.I * Omega,
    -sp.I * Omega,
}  # Is the oscillation unobservable from the height? (hint 1)
# Does integrating a rate give the quantity itself, or only up to a constant? (hint 1)
c_observable = True
# Is only the initial output of these states zero? What do its derivatives show? (hint 1)
c_unobservable_states = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]]
c_unobservable_eigenvalues = (
    set()
)  # Was the row of the measurement written with its factor $\lambda$? (hint 1)
# Does the velocity determine the height, and the height everything else? Look at the constants.
# (hint 1)
d_observable = True
# Must there be as many unobservable states as the theorem finds exceptions? (hint 1)
d_unobservable_states = [[1, 0, 0, 0]]
# Does the height change without any change of the rate? (hint 2)
d_unobservable_states = [[1, 0, 0, 0], [0, 1, 0, 0]]
# Does the higher of two satellites move ahead? (hint 2)
d_unobservable_states = [[1, 0, 0, 0], [0, 2 * r0, 3 * Omega, 0]]
d_unobservable_eigenvalues = {
    0,
    sp.I * Omega,
}  # Must every unobservable state have its own number? (hint 1)
e_observable = False  # If neither measurement is enough, can their sum not be enough? (hint 1)
# Does the sum vanish along this motion for ever, or at one instant? (hint 1)
e_unobservable_states = [[1, -1, 0, 0]]
e_unobservable_eigenvalues = {0}  # Is the sum zero along the motion of item b? (hint 1)

# %% right
a_unobservable_states = sp.zeros(4, 0)  # a matrix without columns
b_unobservable_states = [[-3, 0, 0, 0]]  # another length and sign
b_unobservable_states = sp.Matrix([r0, 0, 0, 0])  # a column
c_unobservable_states = [sp.Matrix([7, 0, 0, 0])]  # a list of columns
# floats
import numpy as np

c_unobservable_states = [np.array([1.0, 0.0, 0.0, 0.0])]
# the other order, with the height as the unit
d_unobservable_states = [[0, 1, -3 * Omega / (2 * r0), 0], [2, 0, 0, 0]]
# a shift added to the drift, plain symbols
w, r = sp.symbols("Omega r0")
d_unobservable_states = [[1, 0, 0, 0], [5, -2 * r, 3 * w, 0]]
d_unobservable_states = sp.Matrix(
    [[1, 1], [0, 2 * r0], [0, -3 * Omega], [0, 0]]
)  # the columns of a matrix
e_unobservable_states = sp.zeros(4, 0)  # a matrix without columns

# %% wrong
observable = True  # Is it enough that every state acts on another one? (hint 1)
unseen = [[1, 0, -1]]  # Was a sign lost when z and its derivative were put to zero? (hint 1)
# Are all states hidden that are not measured directly? (hint 1)
unseen = [[1, 0, 0], [0, 0, 1]]
# Is the measured coordinate alone the observable part? (hint 1)
split = sp.Matrix([[0, 1, 0], [1, 0, 0], [0, 0, 1]])
# Is this the matrix of the basis instead of that of the coordinates? (hint 1)
split = sp.Matrix([[0, 1, 0], [1, 1, -1], [1, 0, 1]]).inv()
# Are the three rows independent? (hint 2)
split = sp.Matrix([[0, 1, 0], [1, 1, -1], [0, 2, 0]])
# Does the hidden coordinate act on what is seen here? Was the matrix transposed? (hint 1)
split_system = [sp.Matrix([[0, 2, 0], [1, 0, 1], [0, 0, 0]]), sp.Matrix([[1, 0, 0]])]
# Was a sign lost in the second equation? (hint 1)
split_system = [sp.Matrix([[0, 1, 0], [-2, 0, 0], [0, 1, 0]]), sp.Matrix([[1, 0, 0]])]
# Do the coefficients stand in the right order? (hint 2)
canonical = [sp.Matrix([[2, 1], [0, 0]]), sp.Matrix([[1, 0]])]
# Has the whole system a canonical form, or only its observable part? (hint 1)
canonical = [sp.Matrix([[0, 1, 0], [2, 0, 1], [0, 0, 0]]), sp.Matrix([[1, 0, 0]])]
# Which coordinate is measured in the canonical form?
canonical = [sp.Matrix([[0, 1], [2, 0]]), sp.Matrix([[0, 1]])]
# Was a factor lost? The first coordinate has to be the output itself. (hint 1)
canonical_coordinates = sp.Matrix([[0, 2, 0], [2, 2, -2]])
# Which coefficient is subtracted in the second coordinate? (hint 1)
canonical_coordinates = sp.Matrix([[0, 1, 0], [1, 0, -1]])

# %% right
unseen = [(-2, 0, -2)]  # another length and sign
unseen = sp.Matrix([1, 0, 1]) / 3  # a column
# the first integral as the last coordinate
split = sp.Matrix([[0, 1, 0], [1, 1, -1], [1, -1, 1]])
# x2, the difference x1 - x3, and x1: no derivative needed
split = [[0, 1, 0], [1, 0, -1], [1, 0, 0]]
# floats, the modes of the observable part as coordinates
import numpy as np

split = np.array([[1, 1 + np.sqrt(2), -1], [1, 1 - np.sqrt(2), -1], [0, 0, 1]])
# with the first integral
split_system = [sp.Matrix([[0, 1, 0], [2, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 0, 0]])]
# in the coordinates x2, x1 - x3, x1
split_system = [[[1, 1, 0], [1, -1, 0], [1, 0, 0]], [[1, 0, 0]]]
canonical = [[[0, 1], [2, 0]], [1, 0]]  # lists, the output as a plain list
# floats
import numpy as np

canonical = [np.array([[0, 1.0], [2.0, 0]]), np.array([[1.0, 0]])]
# floats
import numpy as np

canonical_coordinates = np.array([[0.0, 1, 0], [1, 1, -1]])

# %% wrong
observable = True  # every state acts on another one, so all are thought to be known
unseen = [[1, 0, -1]]  # what z and dz/dt leave open, with a wrong sign
unseen = [[1, 0, 0], [0, 0, 1]]  # all that is not measured directly
# the measured coordinate alone taken for the observable part, the rest left as it is
split = sp.Matrix([[0, 1, 0], [1, 0, 0], [0, 0, 1]])
# the matrix of the basis instead of that of the coordinates
split = sp.Matrix([[0, 1, 0], [1, 1, -1], [1, 0, 1]]).inv()
# the rows of N taken as they come, though the third repeats the first
split = sp.Matrix([[0, 1, 0], [1, 1, -1], [0, 2, 0]])
# the matrix transposed: eta would act on what is seen
split_system = [sp.Matrix([[0, 2, 0], [1, 0, 1], [0, 0, 0]]), sp.Matrix([[1, 0, 0]])]
# an error of sign in the second equation
split_system = [sp.Matrix([[0, 1, 0], [-2, 0, 0], [0, 1, 0]]), sp.Matrix([[1, 0, 0]])]
# the coefficients in the other order, from the lowest power down
canonical = [sp.Matrix([[2, 1], [0, 0]]), sp.Matrix([[1, 0]])]
# the canonical form of the whole matrix, which an unobservable system does not have
canonical = [sp.Matrix([[0, 1, 0], [2, 0, 1], [0, 0, 0]]), sp.Matrix([[1, 0, 0]])]
canonical = [sp.Matrix([[0, 1], [2, 0]]), sp.Matrix([[0, 1]])]  # the output measures the second coordinate
canonical_coordinates = sp.Matrix([[0, 2, 0], [2, 2, -2]])  # a scale lost: the first coordinate is no longer the output
# the second coordinate taken as dz/dt - z, as if alpha_2 were 1
canonical_coordinates = sp.Matrix([[0, 1, 0], [1, 0, -1]])

# %% right
unseen = [(-2, 0, -2)]  # another length and sign
unseen = sp.Matrix([1, 0, 1])/3  # a column
split = sp.Matrix([[0, 1, 0], [1, 1, -1], [1, -1, 1]])  # the first integral as the last coordinate
split = [[0, 1, 0], [1, 0, -1], [1, 0, 0]]  # x2, the difference x1 - x3, and x1: no derivative needed
# floats, the modes of the observable part as coordinates
import numpy as np
split = np.array([[1, 1 + np.sqrt(2), -1], [1, 1 - np.sqrt(2), -1], [0, 0, 1]])
split_system = [sp.Matrix([[0, 1, 0], [2, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 0, 0]])]  # with the first integral
split_system = [[[1, 1, 0], [1, -1, 0], [1, 0, 0]], [[1, 0, 0]]]  # in the coordinates x2, x1 - x3, x1
canonical = [[[0, 1], [2, 0]], [1, 0]]  # lists, the output as a plain list
# floats
import numpy as np
canonical = [np.array([[0, 1.0], [2.0, 0]]), np.array([[1.0, 0]])]
# floats
import numpy as np
canonical_coordinates = np.array([[0.0, 1, 0], [1, 1, -1]])

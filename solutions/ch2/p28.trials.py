# %% wrong
controllable = True  # Is it enough that every equation holds the control? (hint 1)
uncontrolled = []  # Is nothing lost? The control enters both equations alike. (hint 1)
uncontrolled = [[1, 1]]  # Is this the direction in which the control pushes? (hint 1)
uncontrolled = [[1, -2]]  # Is this an eigenvector of A instead of its transpose? (hint 2)
lost = [2]  # Is this the eigenvalue of the direction in which the control pushes? (hint 1)
lost = [-1, 2]  # Are all eigenvalues lost? (hint 1)
lost = []  # Is no eigenvalue lost, though a combination escapes the control? (hint 1)
# Does this lead from x to the new coordinates, instead of from them to x? (hint 1)
split = sp.Matrix([[1, 1], [1, -2]]).inv()
split = sp.Matrix([[1, 1], [-2, 1]])  # Which coordinate has to stand first? (hint 1)
split = sp.Matrix([[1, 2], [1, 2]])  # Has this matrix an inverse? (hint 1)
split = sp.eye(2)  # Can the coordinates be left as they are? (hint 1)
# Does the control still enter the equation of what is lost? (hint 2)
split_system = [sp.Matrix([[2, 0], [0, -1]]), sp.Matrix([1, 1])]
# Does the coupling stand on the right side of the diagonal? (hint 1)
split_system = [sp.Matrix([[2, 0], [2, -1]]), sp.Matrix([1, 0])]
# Have the two eigenvalues changed places? (hint 1)
split_system = [sp.Matrix([[-1, 0], [0, 2]]), sp.Matrix([1, 0])]

# %% right
uncontrolled = [[5, -5]]  # another length and sign
lost = [-sp.sqrt(1)]  # the number in another form
split = sp.Matrix([[1, 1], [1, 0]])  # b and the first axis
split = sp.Matrix([[-3, 0], [-3, 7]])  # another length of b, the second axis
# with the first axis: eta acts on xi
split_system = [sp.Matrix([[2, 2], [0, -1]]), sp.Matrix([1, 0])]
split_system = [sp.Matrix([[2, -5], [0, -1]]), sp.Matrix([3, 0])]  # other lengths

# %% wrong
a_uncontrolled = [[0, 1, 0]]  # Is this the variable that the control enters? (hint 1)
a_uncontrolled = [[1, 0, -1]]  # Does $x_2$ cancel in the difference, or in the sum? (hint 1)
# Does this lead from x to the new coordinates, instead of from them to x?
a_split = sp.Matrix([[0, 1, 2], [1, 1, 3], [0, -1, -3]]).inv()
# Which coordinates have to stand first? (hint 1)
a_split = sp.Matrix([[2, 1, 0], [3, 1, 1], [-3, -1, 0]])
a_split = sp.Matrix.hstack(b_a, A_a * b_a, A_a**2 * b_a)  # Has this matrix an inverse? (hint 1)
b_uncontrolled = []  # Is it enough that the driven variable acts on both others? (hint 1)
b_uncontrolled = [[1, 1, 1]]  # Does the sum of all three equations lose the control? (hint 1)
# Does this lead from x to the new coordinates, instead of from them to x?
b_split = sp.Matrix([[0, 1, 1], [1, 0, 0], [0, -1, 0]]).inv()
# Which coordinates have to stand first? (hint 1)
b_split = sp.Matrix([[1, 1, 0], [0, 0, 1], [0, -1, 0]])
b_split = sp.eye(3)  # Can the coordinates be left as they are? (hint 1)
c_uncontrolled = [[1, 0, -1]]  # Which sign has the effect of $x_2$ on the other two? (hint 1)
c_uncontrolled = [[1, 1, -1]]  # Is this an eigenvector of A instead of its transpose?
# Does this lead from x to the new coordinates, instead of from them to x?
c_split = sp.Matrix([[0, 1, 1], [1, 1, 0], [0, -1, 0]]).inv()
# Which coordinates have to stand first? (hint 1)
c_split = sp.Matrix([[1, 1, 0], [0, 1, 1], [0, -1, 0]])
c_split = sp.Matrix.hstack(b_c, A_c * b_c, A_c**2 * b_c)  # Has this matrix an inverse? (hint 1)
# The control cancels here, but does the derivative hold only the combination itself? (hint 1)
d_uncontrolled = [[1, -1, 0]]
d_uncontrolled = [[1, 1, -1]]  # Is this an eigenvector of A instead of its transpose? (hint 1)
# Does this lead from x to the new coordinates, instead of from them to x?
d_split = sp.Matrix([[1, -1, 1], [1, 0, 1], [0, 1, -1]]).inv()
# Which coordinates have to stand first? (hint 1)
d_split = sp.Matrix([[1, -1, 1], [1, 0, 1], [-1, 1, 0]])
d_split = sp.Matrix.hstack(b_d, A_d * b_d, A_d**2 * b_d)  # Has this matrix an inverse? (hint 1)
# Must the control enter an equation directly? Ask who drives this variable. (hint 1)
e_uncontrolled = [[1, 0, 0]]
# Are both variables lost that have no u in their equations? (hint 1)
e_uncontrolled = [[0, 1, 0], [1, 0, 0]]
# Does this lead from x to the new coordinates, instead of from them to x?
e_split = sp.Matrix([[0, 1, 1], [0, 0, 1], [1, 1, 0]]).inv()
# Which coordinates have to stand first? (hint 1)
e_split = sp.Matrix([[1, 1, 0], [1, 0, 0], [0, 1, 1]])
e_split = sp.eye(3)  # Can the coordinates be left as they are? (hint 1)
# The control cancels here, but does the derivative hold only the combination itself? (hint 1)
f_uncontrolled = [[1, -1, 0]]
f_uncontrolled = [[0, 1, 1]]  # Is this an eigenvector of A instead of its transpose? (hint 1)
# Which coordinates have to stand first? (hint 1)
f_split = sp.Matrix([[0, 1, 1], [1, -2, 1], [1, 0, 0]])
g_uncontrolled = [[1, -1, 0]]  # Was a sign lost? Does $x_3$ act on this difference? (hint 1)
# Are both variables lost that have no u in their equations? (hint 1)
g_uncontrolled = [[1, 0, 0], [0, 1, 0]]
# Which coordinates have to stand first? (hint 1)
g_split = sp.Matrix([[1, 1, 0], [0, -1, 0], [0, 1, 1]])
g_split = sp.Matrix.hstack(b_g, A_g * b_g, A_g**2 * b_g)  # Has this matrix an inverse? (hint 1)
h_uncontrolled = [[0, 1, 0]]  # Is this variable the lost combination by itself? (hint 1)
# The control cancels here, but does the derivative hold only the combination itself? (hint 1)
h_uncontrolled = [[1, -1, 0]]
# Does this lead from x to the new coordinates, instead of from them to x?
h_split = sp.Matrix([[1, -1, 0], [1, 0, 1], [0, 1, 0]]).inv()
# Which coordinates have to stand first? (hint 1)
h_split = sp.Matrix([[0, -1, 1], [1, 0, 1], [0, 1, 0]])
h_split = sp.eye(3)  # Can the coordinates be left as they are? (hint 1)
i_uncontrolled = [[0, 1, 1]]  # Is this an eigenvector of A instead of its transpose? (hint 1)
# Does a multiple eigenvalue mean that as many combinations are lost? (hint 1)
i_uncontrolled = [[1, -1, 1], [0, 1, -1]]
# Does this lead from x to the new coordinates, instead of from them to x?
i_split = sp.Matrix([[1, -1, 1], [1, 0, 0], [0, 1, 0]]).inv()
# Which coordinates have to stand first? (hint 1)
i_split = sp.Matrix([[1, -1, 1], [0, 0, 1], [0, 1, 0]])
i_split = sp.Matrix.hstack(b_i, A_i * b_i, A_i**2 * b_i)  # Has this matrix an inverse? (hint 1)
# Does the control cancel in the difference, or in the sum? (hint 1)
j_uncontrolled = [[1, 0, -1]]
# Does the control cancel when all three equations are added? (hint 1)
j_uncontrolled = [[1, 1, 1]]
# Which coordinates have to stand first? (hint 1)
j_split = sp.Matrix([[1, 1, 0], [-1, 1, 1], [1, -1, 0]])
k_uncontrolled = [[0, 1, 0]]  # Is this the variable that the control enters? (hint 1)
# Is nothing lost? Look for a combination whose derivative does not hold u. (hint 1)
k_uncontrolled = []
# Which coordinates have to stand first? (hint 1)
k_split = sp.Matrix([[1, 1, 0], [0, 1, 1], [1, -1, 0]])
# The control cancels here, but does the derivative hold only the combination itself? (hint 1)
l_uncontrolled = [[1, -1, 0]]
l_uncontrolled = [[1, 1, 0]]  # Is this the direction in which the control pushes? (hint 1)
# Which coordinates have to stand first? (hint 1)
l_split = sp.Matrix([[0, 0, 1], [0, 1, 1], [1, 1, 0]])
l_split = sp.eye(3)  # Can the coordinates be left as they are? (hint 1)

# %% right
a_uncontrolled = [[-3, 0, -3]]  # another length and sign
# another basis of the plane, another third column
a_split = sp.Matrix([[1, 2, 2], [2, 2, 2], [-1, -2, -3]])
b_uncontrolled = [[-3, 0, -3]]  # another length and sign
# another basis of the plane, another third column
b_split = sp.Matrix([[1, 2, 1], [1, 0, -1], [-1, -2, 0]])
c_uncontrolled = [[-3, 0, -3]]  # another length and sign
# another basis of the plane, another third column
c_split = sp.Matrix([[1, 2, 1], [2, 2, -1], [-1, -2, 0]])
d_uncontrolled = [[-3, 3, -3]]  # another length and sign
# another basis of the plane, another third column
d_split = sp.Matrix([[0, -2, 0], [1, 0, 0], [1, 2, -1]])
e_uncontrolled = [[0, -3, 0]]  # another length and sign
# another basis of the plane, another third column
e_split = sp.Matrix([[1, 2, 1], [0, 0, 1], [2, 2, -1]])
f_uncontrolled = [[0, 0, -3]]  # another length and sign
# another basis of the plane, another third column
f_split = sp.Matrix([[2, 2, -1], [-1, -4, 0], [0, 0, 1]])
g_uncontrolled = [[-3, -3, 0]]  # another length and sign
# another basis of the plane, another third column
g_split = sp.Matrix([[1, 2, 1], [-1, -2, 0], [2, 2, -1]])
h_uncontrolled = [[-3, 3, -3]]  # another length and sign
# another basis of the plane, another third column
h_split = sp.Matrix([[0, -2, -1], [1, 0, 0], [1, 2, 0]])
i_uncontrolled = [[-3, 3, -3]]  # another length and sign
# another basis of the plane, another third column
i_split = sp.Matrix([[0, -2, 0], [1, 0, -1], [1, 2, 0]])
j_uncontrolled = [[-3, 0, -3]]  # another length and sign
# another basis of the plane, another third column
j_split = sp.Matrix([[1, 2, 1], [2, 2, -2], [-1, -2, 1]])
k_uncontrolled = [[-3, 0, -3]]  # another length and sign
# another basis of the plane, another third column
k_split = sp.Matrix([[1, 2, 1], [2, 2, -1], [-1, -2, 1]])
l_uncontrolled = [[-3, 3, -3]]  # another length and sign
# another basis of the plane, another third column
l_split = sp.Matrix([[1, 0, -1], [2, 2, -1], [1, 2, 1]])

# %% wrong
a_margins = sp.true  # Does the measurement show the motion along (1, -2)?
a_margins = sp.false  # Does the hidden motion grow?
# What is the sign of the product of the roots of the errors?
a_gains = [sp.Matrix([[-4, -2]]), sp.Matrix([4, 1, 4])]
# Is the feedback taken with a minus sign, $u = -Ke$?
a_gains = [sp.Matrix([[4, 2]]), sp.Matrix([4, 1, -4])]
# Can an estimate of r that is never corrected converge?
a_gains = [sp.Matrix([[-4, -2]]), sp.Matrix([4, 1, 0])]
# Is anything fixed here? Look at both eigenvectors, from the side of u and from the side of z.
b_margins = mu <= 1
b_margins = mu <= 2  # Does this measurement hide the motion with the root -2?
# What is the polynomial of the errors at zero?
b_gains = [sp.Matrix([[-3, 2]]), sp.Matrix([6, 3, 4])]
# Which gain belongs to which coordinate?
b_gains = [sp.Matrix([[2, -3]]), sp.Matrix([6, 3, -4])]
c_margins = mu <= 1  # Which of the two roots belongs to the unobservable motion?
c_margins = sp.true  # Put the two eigenvectors into $2x_1 - x_2$.
# In which combination do the first two numbers enter here?
c_gains = [sp.Matrix([[-3, 2]]), sp.Matrix([0, 9, -4])]
# Is the feedback taken with a minus sign, $u = -Ke$?
c_gains = [sp.Matrix([[3, -2]]), sp.Matrix([4, -1, -4])]
d_margins = sp.false  # Is the unobservable motion the growing one?
d_margins = mu <= 2  # Which root belongs to the vector (1, 1)?
# With which sign does the second number enter?
d_gains = [sp.Matrix([[-2, 2]]), sp.Matrix([0, 9, -4])]
# Look at the product of the roots of the regulator.
d_gains = [sp.Matrix([[-2, 4]]), sp.Matrix([9, 0, -4])]
e_margins = sp.true  # Everything is observable. Is everything controllable?
e_margins = mu < 1  # Look at the degree of stability 1 itself: which root could be slower?
# Where does this control place the root that can be moved?
e_gains = [sp.Matrix([[-2, 0]]), sp.Matrix([11, 10, -4])]
# What is the polynomial of the errors at zero?
e_gains = [sp.Matrix([[-3, 0]]), sp.Matrix([11, 10, 4])]

# %% right
a_margins = mu**2 <= 1  # a square
a_gains = [[-4.0, -2.0], [0.0, 9.0, -4.0]]  # decimals, another splitting of the sum
# another regulator, with the roots -2 +- i
a_gains = [sp.Matrix([[-10, -4]]), sp.Matrix([4, 1, -4])]
b_margins = mu < sp.oo  # no bound
b_gains = [sp.Matrix([[-6, 3]]), sp.Matrix([6, 3, -4])]  # a faster regulator
c_margins = sp.And(mu > 0, mu <= 2)  # with what is known of mu
c_gains = [[-3, 2], [0, -9, -4]]  # flat lists, another splitting
d_margins = sp.Not(mu > 1)  # a negation
d_gains = [sp.Matrix([-2, 2]), sp.Matrix([[10, 1, -4]])]  # upright and lying down
e_margins = mu - 1 <= 0  # moved to one side
e_gains = [sp.Matrix([[0, -5]]), sp.Matrix([11, 10, -4])]  # the other coordinate alone

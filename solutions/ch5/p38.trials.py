# %% wrong
# Where is the drag? (hint 1)
pontryagin = psi1 * v * sp.cos(theta) + psi2 * v * sp.sin(theta) - psi3 * sp.sin(theta)
# Does the drag push the point forwards? (hint 1)
pontryagin = psi1 * v * sp.cos(theta) + psi2 * v * sp.sin(theta) + psi3 * (v**2 - sp.sin(theta))
# Does a higher speed cost nothing in air? (hint 1)
adjoint = [0, 0, -psi1 * sp.cos(theta) - psi2 * sp.sin(theta)]
# Follow the two minus signs of the drag. (hint 1)
adjoint = [0, 0, -psi1 * sp.cos(theta) - psi2 * sp.sin(theta) - 2 * v * psi3]
# Which sign does a range that is to be maximised have in a cost? (hint 1)
transversality = [psi1 + 1, psi2, psi3]
transversality = [psi1 - 1, psi2]  # Is the speed prescribed at the end? (hint 1)
equation = sp.cos(theta) / v  # Is this the flight without drag? (hint 1)
# Was the drag inserted only in the equation of the speed? (hint 2)
equation = sp.cos(theta) / v * (1 + v**2 * sp.sin(theta))
# Which sign does the drag have in the adjoint equation? (hint 1)
equation = sp.cos(theta) / v * (1 - v**2 * sp.sin(theta))
# Can the other factor of the rate vanish as well? (hint 1)
rest = [[-sp.asin(1 / sp.sqrt(3)), 3 ** sp.Rational(-1, 4)]]
rest = [[-sp.pi / 2, 1]]  # Which other factor does the rate of the angle have? (hint 1)
# Was a root of the speed forgotten? (hint 2)
rest = [[-sp.asin(1 / sp.sqrt(3)), 1 / sp.sqrt(3)], [-sp.pi / 2, 1]]
# Does the row of the angle come first? (hint 1)
glide_matrix = [[-2 * 3**-0.25, -sp.sqrt(2) / sp.sqrt(3)], [-2 * sp.sqrt(2), 2 * 3**-0.25]]
# Does the bracket in the rate of the angle depend on the angle, too? (hint 1)
glide_matrix = [[0, -2 * sp.sqrt(2)], [-sp.sqrt(2) / sp.sqrt(3), -2 * 3**-0.25]]
# Is the steady glide stable for a fixed angle, or for an angle that varies? (hint 1)
glide_kind = "stable node"
# A first integral allows two kinds. Which sign distinguishes them? (hint 1)
glide_kind = "centre"
fall_matrix = [[2, 0], [0, -2]]  # Which sign does the bracket have at the fall? (hint 1)
fall_matrix = [[-2, -1], [-1, -2]]  # What is the derivative of the sine at this angle? (hint 1)
fall_kind = "saddle"  # Which sign does the bracket have at the fall? (hint 1)
fall_kind = "stable node"  # Does the matrix have two eigendirections, or more? (hint 1)
portrait = v / sp.cos(theta)  # Is this constant without drag only? (hint 2)
# Which sign does the last costate have in a dive? (hint 2)
portrait = (v - v**3 * sp.sin(theta)) / sp.cos(theta)
# Is this the speed of the glide, or its horizontal component? (hint 1)
pace = 3 ** sp.Rational(-1, 4)
pace = sp.sqrt(2) / 3  # Was a root of the speed forgotten? (hint 1)
greatest = sp.log(5)  # Is this a level flight? (hint 1)
greatest = 1.2408  # Does the flight last that long at the pace of a glide? (hint 1)

# %% right
transversality = [sp.Eq(psi1, 1), sp.Eq(psi2, 0), sp.Eq(psi2 - psi3, 0)]  # combined
# expanded, with the double angle
equation = sp.cos(theta) / v + sp.Rational(3, 2) * v * sp.sin(2 * theta)
# by the tangent, in the other order
rest = [[-sp.pi / 2, 1], [-sp.atan(1 / sp.sqrt(2)), sp.sqrt(1 / sp.sqrt(3))]]
portrait = (1 / v + v * sp.sin(theta)) ** 2 * v**4 / (1 - sp.sin(theta) ** 2)  # its square
pace = 0.620403  # six digits

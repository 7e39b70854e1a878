# %% wrong
# Were the Coriolis forces left out? (hint 2)
a_modes = [
    0,
    n1 * v_x + n2 * v_y,
    n1 * x + n2 * y + n3 * z,
    (n1 * v_x + n2 * v_y + n3 * v_z) / omega,
]
# In which direction is the drift? (hint 2)
a_modes = [
    n1 * (4 * x + 2 * v_y / omega) + n2 * (y - 2 * v_x / omega),
    3 * n2 * (v_y + 2 * omega * x),
    n1 * (-3 * x - 2 * v_y / omega) + 2 * n2 * v_x / omega + n3 * z,
    (n1 * v_x + n3 * v_z) / omega + 2 * n2 * (3 * x + 2 * v_y / omega),
]
# Do displacements across the line of sight remain there? (hint 1)
b_unobservable_states = [[-n2, n1, 0, 0, 0, 0], [0, -n3, n2, 0, 0, 0]]
# Are these two states really independent? (hint 2)
b_unobservable_states = [
    [1, 0, -n1 / n3, 0, -2 * omega, 2 * n2 * omega / n3],
    [2, 0, -2 * n1 / n3, 0, -4 * omega, 4 * n2 * omega / n3],
]
# Is it enough that position and velocity are perpendicular to the line of sight? (hint 1)
b_unobservable_states = [
    [1, 0, -n1 / n3, 0, 0, 0],
    [0, 2, -2 * n2 / n3, omega, 0, -n1 * omega / n3],
]
c_ranks = [4, 4, 4]  # Does every direction show all four functions? (hint 1)
c_ranks = [2, 2, 2]  # Does a range in one direction depend on that coordinate only? (hint 1)
d_insufficient = sp.Eq(n1 * k3, n3 * k1)  # Is one equality enough? (hint 2)
# Must the directions be perpendicular or parallel? (hint 2)
d_insufficient = sp.Eq(n1 * k1 + n2 * k2 + n3 * k3, 0)
# Do both equalities have to hold, or is either enough? (hint 2)
d_insufficient = sp.Or(sp.Eq(n1 * k3, n3 * k1), sp.Eq(n2 * k3, n3 * k2))

# %% right
# a column over a common denominator, plain symbols
N1, N2, N3, W, X0, Y0, Z0, VX, VY, VZ = sp.symbols("n1 n2 n3 omega x y z v_x v_y v_z")
a_modes = sp.Matrix(
    [
        (N1 * (4 * W * X0 + 2 * VY) + N2 * (W * Y0 - 2 * VX)) / W,
        -3 * N2 * (VY + 2 * W * X0),
        (2 * N2 * VX - N1 * (3 * W * X0 + 2 * VY) + N3 * W * Z0) / W,
        (N1 * VX + N3 * VZ + 2 * N2 * (3 * W * X0 + 2 * VY)) / W,
    ]
)
# without fractions
b_unobservable_states = [
    [n3, 0, -n1, 0, -2 * omega * n3, 2 * n2 * omega],
    [0, 2 * n3, -2 * n2, omega * n3, 0, -n1 * omega],
]
# their sum and difference, as columns
one = sp.Matrix([1, 0, -n1 / n3, 0, -2 * omega, 2 * n2 * omega / n3])
two = sp.Matrix([0, 2, -2 * n2 / n3, omega, 0, -n1 * omega / n3])
b_unobservable_states = [one + two, one - two]
# the determinant
d_insufficient = sp.Eq((n1 / n3 - k1 / k3) ** 2 + 4 * (n2 / n3 - k2 / k3) ** 2, 0)
# unit vectors at an angle of 0 or 180 degrees
d_insufficient = sp.Eq((n1 * k1 + n2 * k2 + n3 * k3) ** 2, 1)
# all three components of the cross product, as a list
d_insufficient = [
    sp.Eq(n2 * k3 - n3 * k2, 0),
    sp.Eq(n3 * k1 - n1 * k3, 0),
    sp.Eq(n1 * k2 - n2 * k1, 0),
]

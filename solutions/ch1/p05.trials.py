# %% wrong
# Were the Coriolis terms of the first two equations swapped?
a_matrix = sp.Matrix(
    [
        [0, 0, 0, 1, 0, 0],
        [0, 0, 0, 0, 1, 0],
        [0, 0, 0, 0, 0, 1],
        [0, 0, 0, 0, 2 * r0 * Omega, 0],
        [0, 3 * Omega**2, 0, -2 * Omega / r0, 0, 0],
        [0, 0, -(Omega**2), 0, 0, 0],
    ]
)
# In which order does the problem list the state? (hint 1)
a_matrix = sp.Matrix(
    [
        [0, 1, 0, 0, 0, 0],
        [0, 0, 0, -2 * Omega / r0, 0, 0],
        [0, 0, 0, 1, 0, 0],
        [0, 2 * r0 * Omega, 3 * Omega**2, 0, 0, 0],
        [0, 0, 0, 0, 0, 1],
        [0, 0, 0, 0, -(Omega**2), 0],
    ]
)
# Does a double eigenvalue always have two independent eigenvectors? (hint 2)
a_eigenvalues = [[0, 2, 2], [sp.I * Omega, 2, 2], [-sp.I * Omega, 2, 2]]
# Does every double eigenvalue have only one eigenvector? The motion across the plane is decoupled.
# (hint 1)
a_eigenvalues = [[0, 2, 1], [sp.I * Omega, 2, 1], [-sp.I * Omega, 2, 1]]
# Was the Coriolis coupling forgotten, so that the height is decoupled?
a_eigenvalues = [
    [0, 2, 1],
    [sp.sqrt(3) * Omega, 1, 1],
    [-sp.sqrt(3) * Omega, 1, 1],
    [sp.I * Omega, 1, 1],
    [-sp.I * Omega, 1, 1],
]
# Does a satellite that flies higher run ahead or fall behind? (hint 2)
a_growing = sp.Matrix([3 * Omega * h / (2 * r0) * t, h, 0, 3 * Omega * h / (2 * r0), 0, 0])
# This is a motion, but does it grow? (hint 1)
a_growing = sp.Matrix(
    [
        2 * h / r0 * sp.cos(Omega * t),
        h * sp.sin(Omega * t),
        0,
        -2 * Omega * h / r0 * sp.sin(Omega * t),
        Omega * h * sp.cos(Omega * t),
        0,
    ]
)
# Does the second equation allow this drift at height zero? (hint 2)
a_growing = sp.Matrix([h / r0 * Omega * t, 0, 0, h / r0 * Omega, 0, 0])
# Is it enough that no root lies on the right? Check whether the eigenvalues on the axis are
# semisimple. (hint 1)
a_stability = "stable"
# Was the wrong coordinate struck out? (hint 1)
b_matrix = sp.Matrix(
    [
        [0, 0, 0, 1, 0],
        [0, 0, 0, 0, 1],
        [0, 0, 0, -2 * Omega / r0, 0],
        [0, 0, 2 * r0 * Omega, 0, 0],
        [0, -(Omega**2), 0, 0, 0],
    ]
)
# Is this the spectrum of the full system? Which eigenvalue is removed with $x_1$? (hint 1)
b_eigenvalues = [[0, 2, 1], [sp.I * Omega, 2, 2], [-sp.I * Omega, 2, 2]]
# Are both zero eigenvalues removed with $x_1$? (hint 1)
b_eigenvalues = [[sp.I * Omega, 2, 2], [-sp.I * Omega, 2, 2]]
# Is this form positive in every direction, or is there one along which it is zero? (hint 1)
b_integral = v2**2 + (3 * Omega * x2 + 2 * r0 * y1) ** 2 + v3**2 + Omega**2 * x3**2
# About which height does the satellite oscillate? Which combination is constant? (hint 2)
b_integral = v2**2 + Omega**2 * x2**2 + r0**2 * y1**2 + v3**2 + Omega**2 * x3**2
# This is constant, but is it positive definite?
b_integral = v2**2 + r0**2 * y1**2 - 3 * Omega**2 * x2**2 + v3**2 + Omega**2 * x3**2
b_stability = "asymptotically stable"  # Must bounded motions tend to zero? (hint 1)

# %% right
# in another order, as tuples
a_eigenvalues = [(-sp.I * Omega, 2, 2), (sp.I * Omega, 2, 2), (0, 2, 1)]
# a list, with the sign of h turned
a_growing = [sp.Rational(3, 2) * Omega * h * t / r0, -h, 0, 3 * Omega * h / r0 / 2, 0, 0]
# the drift in loops of a satellite that starts faster, with another oscillation across the plane
a_growing = [
    h * (4 * sp.sin(Omega * t) - 3 * Omega * t) / r0,
    2 * h * (1 - sp.cos(Omega * t)),
    h * sp.sin(Omega * t) / r0,
    h * Omega * (4 * sp.cos(Omega * t) - 3) / r0,
    2 * h * Omega * sp.sin(Omega * t),
    h * Omega * sp.cos(Omega * t) / r0,
]
# in another order, as tuples
b_eigenvalues = [(sp.I * Omega, 2, 2), (0, 1, 1), (-sp.I * Omega, 2, 2)]
# as a dict from the value to its multiplicities
b_eigenvalues = {0: (1, 1), sp.I * Omega: (2, 2), -sp.I * Omega: (2, 2)}
# other weights of the conserved parts, multiplied out
b_integral = sp.expand(
    2 * (v2**2 + (3 * Omega * x2 + 2 * r0 * y1) ** 2)
    + 5 * (2 * Omega * x2 + r0 * y1) ** 2
    + 7 * (v3**2 + Omega**2 * x3**2)
)
# by the constant C and the shifted centre
C = y1 + 2 * Omega / r0 * x2
b_integral = (
    (v2**2 + Omega**2 * (x2 - 2 * r0 * C / Omega) ** 2) / 2
    + (r0 * C) ** 2
    + (v3**2 + Omega**2 * x3**2) / 2
)

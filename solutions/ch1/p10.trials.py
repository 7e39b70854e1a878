# %% wrong
# Does the robot keep its speed without any voltage, as the problem book assumes? (hint 2)
a_program = {"x": V0 * t, "y": 0, "alpha": 0, "V": V0, "omega": 0, "u_S": 0, "u_D": 0}
# Is the position on the track constant while the robot moves? (hint 1)
a_program = {"x": 0, "y": 0, "alpha": 0, "V": V0, "omega": 0, "u_S": V0, "u_D": 0}
# Is the term $V \sin\alpha$ small of second order? The nominal speed is not zero. (hint 2)
a_matrix = sp.Matrix(
    [
        [0, 0, 0, 1, 0],
        [0, 0, 0, 0, k0],
        [0, 0, 0, 0, 1],
        [0, 0, 0, -1, 0],
        [0, 0, 0, 0, -k3 * (1 + k2 * V0 / k1)],
    ]
)
# Was the nominal speed substituted, or is this the linearisation about rest? (hint 1)
a_matrix = sp.Matrix(
    [[0, 0, 0, 1, 0], [0, 0, V0, 0, k0], [0, 0, 0, 0, 1], [0, 0, 0, -1, 0], [0, 0, 0, 0, -k3]]
)
# Was the square of $\omega$ treated as a linear term? (hint 1)
a_matrix = sp.Matrix(
    [
        [0, 0, 0, 1, 0],
        [0, 0, V0, 0, k0],
        [0, 0, 0, 0, 1],
        [0, 0, 0, -1, 2 * k1 * k2],
        [0, 0, 0, 0, -k3 * (1 + k2 * V0 / k1)],
    ]
)
# Were the two columns swapped? Which control comes first? (hint 1)
a_inputs = sp.Matrix([[0, 0], [0, 0], [0, 0], [0, 1], [k3 / k1, 0]])
# Was the coefficient of a control lost? (hint 1)
a_inputs = sp.Matrix([[0, 0], [0, 0], [0, 0], [1, 0], [0, 1]])
# The subsystem is of order two: does it contain only the speed? (hint 1)
b_eigenvalues = [[-1, 2, 1]]
# Does the deviation of the speed grow or decay? (hint 1)
b_eigenvalues = [[0, 1, 1], [1, 1, 1]]
b_limit = sp.Matrix([0, 0])  # Does the position on the track recover after a disturbance? (hint 2)
# What distance does the robot cover while its speed recovers? (hint 1)
b_limit = sp.Matrix([dx0, 0])
b_stability = "asymptotically stable"  # The speed recovers, but does the position? (hint 1)
b_stability = "unstable"  # Does a zero eigenvalue always mean instability? (hint 1)
# How many independent eigenvectors does the double eigenvalue have? (hint 2)
c_eigenvalues = [[0, 2, 2], [-k3 * (1 + k2 * V0 / k1), 1, 1]]
# Does the eigenvalue have the wrong sign? (hint 1)
c_eigenvalues = [[0, 2, 1], [k3 * (1 + k2 * V0 / k1), 1, 1]]
# Does the equation for $\omega$ allow the robot to keep turning? (hint 1)
c_growing = sp.Matrix([V0 * alpha0 * t**2 / 2, alpha0 * t, alpha0])
c_growing = sp.Matrix([alpha0, 0, 0])  # Does a mere displacement grow? (hint 1)
c_stability = "stable"  # Is it enough that no eigenvalue lies on the right? (hint 1)
# Does this assume a position of the centre of mass? (hint 1)
c_heading = sp.And(k1 > 0, k3 > 0)
# Is the subsystem still stable where the two eigenvalues meet at zero? (hint 1)
c_heading = k1 + k2 * V0 >= 0
# Must the centre of mass lie ahead of the wheels, or can the speed matter too? (hint 1)
c_heading = k2 > 0

# %% right
a_program = [V0 * t, 0, 0, V0, 0, V0, 0]  # a list, the state first and the controls last
# a dict from the symbols
a_program = {
    x: sp.Symbol("V0") * sp.Symbol("t"),
    y: 0,
    alpha: 0,
    V: V0,
    omega: 0,
    u_S: V0,
    u_D: 0.0,
}
b_eigenvalues = [(-1, 1, 1), (0, 1, 1)]  # another order, tuples
c_eigenvalues = [[-k3 * (k1 + k2 * V0) / k1, 1, 1], [0, 2, 1]]  # over a common denominator
# a dict from the value to its multiplicities
c_eigenvalues = {0: (2, 1), -k3 - k2 * k3 * V0 / k1: (1, 1)}
# a list, to the other side and with a displacement at the start
c_growing = [alpha0 - V0 * alpha0 * t, -alpha0, 0]
# with a turning that dies out or grows
c_growing = [
    alpha0
    * (
        V0 * t
        + (V0 / (k3 * (1 + k2 * V0 / k1)) - k0)
        / (k3 * (1 + k2 * V0 / k1))
        * sp.exp(-k3 * (1 + k2 * V0 / k1) * t)
    ),
    alpha0 * (1 - sp.exp(-k3 * (1 + k2 * V0 / k1) * t) / (k3 * (1 + k2 * V0 / k1))),
    alpha0 * sp.exp(-k3 * (1 + k2 * V0 / k1) * t),
]
c_heading = k3 * (1 + k2 * V0 / k1) > 0  # p > 0 as it stands
# solved for the speed, by the sign of k2
c_heading = sp.Or(k2 >= 0, sp.And(k2 < 0, V0 < -k1 / k2))

# %% wrong
# Was the growth of the coordinates forgotten? Look at the second row of A. (hint 1)
root = sp.sqrt(intensity)
first = sp.sqrt(2 * root)
covariance = sp.Matrix([[first, root], [root, first * root]])
# Is this for an oscillator? What is the sign of $x_1$ in the second equation? (hint 1)
joint = covariance[0, 1] - 2 * growth
first = sp.sqrt(2 * joint)
covariance = sp.Matrix([[first, joint], [joint, first * (joint + growth)]])
# Are the errors of both coordinates uncorrelated? (hint 1)
covariance = sp.diag(covariance[0, 0], covariance[1, 1])
# Which term of the middle equation was left out? (hint 1)
first, joint, *_ = covariance
covariance = sp.Matrix([[first, joint], [joint, first * joint]])
gain = gain[::-1]  # Were the two entries interchanged? (hint 1)
# Which column of the covariance belongs to this measurement? (hint 1)
gain = list(covariance[:, 1])
# Is the variance that belongs to this gain more than zero? (hint 1)
gain = [0, 2 * growth - gain[1]]
# Are these the eigenvalues of the system, without a filter? (hint 1)
eigenvalues = list(A.eigenvals())
# Was the entry of A in the position of the second gain forgotten? (hint 2)
eigenvalues = [gain[0] * (-1 + sign * sp.I) / 2 for sign in (1, -1)]
eigenvalues = [-value for value in eigenvalues]  # Do errors with these eigenvalues decay? (hint 2)

# %% right
# by the modulus and the angle
modulus = sp.sqrt(gain[1] - growth)
angle = sp.acos(-gain[0] / (2 * modulus))
eigenvalues = [modulus * sp.exp(sign * sp.I * angle) for sign in (1, -1)]
gain = [sp.sqrt(2) * sp.sqrt(gain[1]), sp.sqrt(gain[1] ** 2)]  # other roots

# %% numbers
growth, intensity = [
    (growth, root**2 - growth**2)
    for growth, root in [
        *[(1, 2), (1, 3), (1, 4), (1, 5), (4, 10), (6, 7), (2, 5)],
        *[(5, 10), (3, 5), (3, 6), (7, 9), (4, 6), (5, 6), (5, 7)],
    ]
]
shown = [
    r"\dot x_2 &= «growth*»x_1 + \xi,",
    r"«intensity»\,\delta(t - s)",
    r"$k_2 - «growth»$",
]
joint = growth + sp.sqrt(growth**2 + intensity)
first = sp.sqrt(2 * joint)
covariance = sp.Matrix([[first, joint], [joint, first * (joint - growth)]])
gain = [first, joint]
eigenvalues = [(-first + sign * sp.I * sp.sqrt(2 * joint - 4 * growth)) / 2 for sign in (1, -1)]

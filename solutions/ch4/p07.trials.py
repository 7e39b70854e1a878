# %% wrong
covariance = -covariance  # With which signs does the common term enter? (hint 2)
covariance = 0  # Are the sums independent because their terms are? (hint 2)
# Is a mean meant here, or the mean of a product of deviations? (hint 1)
covariance = first[0] * second[0] * means[0] ** 2 + covariance
# Does the denominator contain the variances, or their square roots? (hint 1)
correlation = correlation**2 / covariance
# Was every coefficient squared? (hint 2)
own = [abs(w) * s**2 for w, s in zip(first + second, [*sigma[:3], sigma[0], sigma[3]])]
correlation = covariance / sp.sqrt(sum(own[:3]) * sum(own[3:]))
correlation = covariance  # Is this the covariance? (hint 1)

# %% right
correlation = covariance / sp.sqrt(covariance**2 / correlation**2)  # under one root
correlation = sp.sign(covariance) * sp.sqrt(correlation**2)  # the root of its square

# %% numbers
first, second, sigma = [
    ([1, 5, 2], [-1, 1], [1, 2, 3, 1]),
    ([2, 1, 3], [1, -1], [1, 3, 2, 2]),
    ([3, 2, 1], [-2, 1], [1, 2, 2, 3]),
    ([1, 2, 4], [3, -1], [2, 1, 1, 3]),
    ([2, 2, 1], [-4, -1], [2, 1, 1, 4]),
    ([1, 3, 2], [-2, 3], [2, 1, 3, 1]),
    ([4, 1, 2], [1, -2], [1, 2, 3, 2]),
    ([2, 5, 1], [3, 1], [1, 1, 2, 4]),
    ([3, 1, 2], [-1, 2], [2, 3, 1, 1]),
    ([1, 4, 3], [2, -1], [3, 1, 2, 2]),
    ([1, 2, 1], [-1, -1], [2, 6, 1, 4]),
    ([5, 2, 1], [1, 1], [1, 2, 3, 3]),
    ([1, 3, 1], [1, 1], [4, 2, 4, 2]),
    ([1, 1, 7], [2, 3], [2, 3, 1, 1]),
]
shown = [
    r"y_1 &= «first[0]*»x_1 «+first[1]*»x_2 «+first[2]*»x_3,",
    r"y_2 &= «second[0]*»x_1 «+second[1]*»x_4 .",
    r"\sigma_{x_1} = «sigma[0]»$",
    r"\sigma_{x_2} = «sigma[1]»$",
    r"\sigma_{x_3} = «sigma[2]»$",
    r"\sigma_{x_4} = «sigma[3]»$",
]
covariance = first[0] * second[0] * sigma[0] ** 2
B = sp.Matrix([y1, y2]).jacobian(x)
K_y = B * K_x * B.T
correlation = covariance / sp.sqrt(K_y[0, 0] * K_y[1, 1])

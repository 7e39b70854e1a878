# %% wrong
# Is the mean of a power the power of the mean? (hint 1)
means = [(plus - minus) ** k for k in (1, 2, 3, 4)]
# Were the values taken as equally likely? (hint 1)
means = [0, sp.Rational(2, 3), 0, sp.Rational(2, 3)]
covariance = plus - minus  # Is this the mean of the product alone? (hint 1)
covariance = 0  # Uncorrelated by symmetry? Are the values 1 and -1 equally likely? (hint 2)
correlation = 1  # One determines the other; is that what the coefficient measures? (hint 1)
# Does the denominator contain the variances, or their square roots? (hint 1)
correlation = correlation**2
correlation = covariance / means[1]  # Are means of squares the variances? (hint 2)

# %% right
# under one root
variances = plus + minus - (plus - minus) ** 2, (plus + minus) * zero
correlation = sp.sign(covariance) * sp.sqrt(covariance**2 / (variances[0] * variances[1]))
means = [plus - minus, plus + minus, plus - minus, plus + minus]  # as sums

# %% numbers
zero, plus, minus = [(sp.Rational(1, 3), sp.Rational(1, 2), sp.Rational(1, 6))] + [
    (1 - plus - minus, plus, minus)
    for plus, minus in [
        (sp.Rational(*p), sp.Rational(*m))
        for p, m in [
            ((1, 4), (1, 2)),
            ((1, 2), (1, 3)),
            ((1, 6), (1, 2)),
            ((1, 4), (1, 6)),
            ((1, 2), (1, 8)),
            ((1, 3), (1, 6)),
            ((2, 5), (1, 5)),
            ((1, 5), (3, 5)),
            ((3, 8), (1, 8)),
            ((1, 8), (5, 8)),
            ((1, 2), (1, 10)),
            ((1, 4), (2, 3)),
            ((3, 4), (1, 8)),
        ]
    ]
]
shown = ["the probabilities $«str(zero)», «str(plus)», «str(minus)»$"]
means = [plus - minus, plus + minus, plus - minus, plus + minus]
covariance = (plus - minus) * zero
correlation = covariance / sp.sqrt((means[1] - means[0] ** 2) * means[1] * zero)

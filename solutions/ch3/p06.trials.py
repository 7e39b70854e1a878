# %% wrong
# Are these the coefficients of the polynomial instead of the gain? (hint 2)
family = sp.Matrix([beta1, beta2, beta3])
# Was the change of coordinates left out that the canonical form needs? (hint 1)
family = sp.Matrix([beta1 + 1, beta2 + 1, beta3 - 2])
# Is this the sign of a feedback $u = Kx$? The correction enters the errors with a minus. (hint 2)
family = (
    -sp.Matrix(
        [
            9 * beta1 - 6 * beta2 + 4 * beta3 - 5,
            -5 * beta1 + 9 * beta2 - 6 * beta3 + 16,
            16 * beta1 - 5 * beta2 + 9 * beta3 - 7,
        ]
    )
    / 17
)
# Are positive coefficients enough for a cubic? (hint 2)
region = sp.And(2 * l2 > 1, l2 + 2 * l3 > 1, 3 * l3 - 3 * l2 + 2 > 0)
region = sp.And(l2 > 0, l3 > 0)  # Is it enough that the gains are positive? (hint 1)
region = 4 * l2 * l3 + 2 * l2**2 - 5 * l3 - 1 > 0  # Is the last minor enough by itself? (hint 2)
# Is it enough to correct the last line alone? (hint 1)
equations = [e2, e3, -2 * e1 + e2 + e3 + 5 * (z - 3 * e1 - 2 * e2)]
# Do errors decay with a gain on the border? (hint 1)
equations = [e2, e3 + z - 3 * e1 - 2 * e2, -2 * e1 + e2 + e3 + z - 3 * e1 - 2 * e2]
# Is the measurement fed in, or its difference from what is expected? (hint 1)
equations = [e2, e3 + 2 * z, -2 * e1 + e2 + e3 + 2 * z]
# What should z be compared with? It is not x itself. (hint 1)
equations = [e2, e3 + 2 * (z - e1), -2 * e1 + e2 + e3 + 2 * (z - e1)]

# %% right
# expanded differently, as a row
family = (
    sp.Matrix(
        [
            [
                9 * beta1 - 6 * beta2 + 4 * beta3 - 5,
                -5 * beta1 + 9 * beta2 - 6 * beta3 + 16,
                16 * beta1 - 5 * beta2 + 9 * beta3 - 7,
            ]
        ]
    )
    / 17
)
# the product not expanded
region = sp.And(
    2 * l2 > 1, 3 * l3 > 3 * l2 - 2, (2 * l2 - 1) * (l2 + 2 * l3 - 1) > 3 * l3 - 3 * l2 + 2
)
# all roots at -1
equations = [
    e2 + sp.Rational(8, 17) * (z - 3 * e1 - 2 * e2),
    e3 + sp.Rational(22, 17) * (z - 3 * e1 - 2 * e2),
    -2 * e1 + e2 + e3 + sp.Rational(35, 17) * (z - 3 * e1 - 2 * e2),
]
# other gains, collected, with decimals
equations = [e2, e3 + 2.5 * z - 7.5 * e1 - 5 * e2, 3 * z - 11 * e1 - 5 * e2 + e3]

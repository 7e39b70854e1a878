# %% wrong
# Does the second or the fourth derivative matter here? (hint 1)
a_gain = rho / (rho - M * omega**2)
a_gain = 1 / (1 + (M * omega**4 / rho) ** 2)  # Was a ratio squared that should not be? (hint 1)
# Is this the part that is lost instead of the remaining factor? (hint 1)
a_gain = M * omega**4 / (rho + M * omega**4)
# Is this the modulus of the exponents instead of their real part? (hint 2)
a_decay = (rho / M) ** sp.Rational(1, 4)
# Is this the exponent with its sign instead of the rate? (hint 1)
a_decay = -((rho / (4 * M)) ** sp.Rational(1, 4))
# Was the factor of the reconstruction set equal to the bound? (hint 1)
b_weight = rho / omega**4 * (1 / D - 1)
b_weight = rho / omega**4 * (a / D - 1)  # Is the amplitude bounded, or the acceleration? (hint 1)
# Was the 1 in the denominator forgotten? (hint 1)
b_weight = rho * a / (D * omega**2)
# Is the matrix positive definite with this root? (hint 2)
c_riccati = sp.Matrix(
    [
        [-sp.sqrt(2) * rho ** sp.Rational(3, 4) * M ** sp.Rational(1, 4), sp.sqrt(rho * M)],
        [sp.sqrt(rho * M), -sp.sqrt(2) * rho ** sp.Rational(1, 4) * M ** sp.Rational(3, 4)],
    ]
)
# Were $\rho$ and $M$ interchanged? (hint 2)
c_riccati = sp.Matrix(
    [
        [sp.sqrt(2) * rho ** sp.Rational(1, 4) * M ** sp.Rational(3, 4), sp.sqrt(rho * M)],
        [sp.sqrt(rho * M), sp.sqrt(2) * rho ** sp.Rational(3, 4) * M ** sp.Rational(1, 4)],
    ]
)
# Are these the signs of the matrix that the paper writes down? (hint 1)
c_riccati = -sp.Matrix(
    [
        [sp.sqrt(rho * M), sp.sqrt(2) * rho ** sp.Rational(1, 4) * M ** sp.Rational(3, 4)],
        [sp.sqrt(2) * rho ** sp.Rational(3, 4) * M ** sp.Rational(1, 4), sp.sqrt(rho * M)],
    ]
)

# %% right
# by the cut-off frequency
cut = (rho / M) ** sp.Rational(1, 4)
a_gain = 1 / (1 + (omega / cut) ** 4)
a_gain = 1 - M * omega**4 / (rho + M * omega**4)  # one minus what is lost

# %% wrong
# Was the sign kept when the bracket was multiplied out? (hint 2)
a_matrix = sp.Matrix([[0, 1], [-1, -epsilon]])
# Is this a damped oscillator? What is the sign of the friction near zero? (hint 1)
a_stable = epsilon > 0
# Do imaginary roots make the linearisation asymptotically stable? (hint 1)
a_stable = epsilon <= 0
a_unstable = epsilon >= 0  # Is everything unstable that is not asymptotically stable? (hint 1)
# Do the motions come closer to zero, or do they only stay near it? (hint 2)
a_critical = "asymptotically stable"
# Was a factor lost in the derivative of the kinetic part? (hint 1)
b_rate = -epsilon * (x1**2 - 1) * x2
# What is the sign of the term with $\varepsilon$ on the right-hand side? (hint 1)
b_rate = epsilon * (x1**2 - 1) * x2**2
b_null = sp.Eq(x2, 0)  # Does this product have another factor that can vanish? (hint 1)
# Is a derivative of V that vanishes everywhere a proof of asymptotic stability? (hint 1)
b_stable = epsilon <= 0
# Do all motions in this strip stay in it? The set has to be bounded by a level of V. (hint 2)
b_basin = sp.Abs(x1) < 1
# Is this the disc $V < 1$? Does it lie inside the strip where V does not grow? (hint 2)
b_basin = x1**2 + x2**2 < 2

# %% right
a_stable = -epsilon > 0  # the damping coefficient
b_null = sp.Eq((x1**2 - 1) * x2**2, 0)  # one equation
b_null = sp.Or(sp.Eq(x2, 0), sp.Eq(sp.Abs(x1), 1))  # with the modulus
b_basin = V < sp.Rational(1, 2)  # by the level of V
b_basin = sp.sqrt(x1**2 + x2**2) < 1.0  # by the radius, with decimals

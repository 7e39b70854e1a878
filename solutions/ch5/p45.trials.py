# %% wrong
# Does the time have the sign that this aim requires? (hint 1)
pontryagin = psi1 * v + psi2 * rho * omega**2 + psi3 * (k - 2 * v) * omega / rho + 1
# Where is the Coriolis term? (hint 1)
pontryagin = psi1 * v + psi2 * rho * omega**2 + psi3 * k * omega / rho - 1
# Which sign precedes the derivative of $H$? (hint 1)
adjoint = [
    psi2 * omega**2 - psi3 * (k - 2 * v) * omega / rho**2,
    psi1 - 2 * psi3 * omega / rho,
    2 * psi2 * rho * omega + psi3 * (k - 2 * v) / rho,
]
# Does the third equation of motion contain the distance? (hint 1)
adjoint = [
    -psi2 * omega**2,
    -psi1 + 2 * psi3 * omega / rho,
    -2 * psi2 * rho * omega - psi3 * (k - 2 * v) / rho,
]
transversality = [psi1, psi2, psi3]  # Is the distance free at the end? (hint 1)
transversality = [psi2]  # Is the rate of turn at the end given? (hint 1)
switching = psi3  # Can the rate of turn be negative? (hint 1)
# Is this the factor of the gain, or the whole term? (hint 1)
switching = psi3 * (k - 2 * v) * omega / rho
switching = -psi3 * omega / rho  # Does $H$ grow or fall with the gain? (hint 1)
gain = kbar * sp.sign(psi3)  # Which other factor has a sign? (hint 1)
gain = -kbar * sp.sign(psi3 * omega)  # Does $H$ have a maximum or a minimum there? (hint 1)
rate = -2 * psi2 * omega**2  # Does the distance change meanwhile? (hint 1)
# By what was the product of costate and rate of turn divided? (hint 1)
rate = -2 * psi2 * rho * omega**2 - psi3 * v * omega / rho**2
# Does the gain have no effect when the distance is momentarily constant? (hint 1)
surface = sp.Eq(v, 0)
# Follow the costates one after the other: which of them can be non-zero? (hint 2)
surface = sp.Eq(rho * omega**2, v**2)
kept = rho**2 * omega  # Is there no acceleration across the line of sight? (hint 1)
kept = v**2 + rho**2 * omega**2  # Does the thrust do no work? (hint 1)
# Which sign does the vector subtracted from the velocity have? (hint 1)
kept = (v + k) ** 2 + rho**2 * omega**2
away_gain = sp.Integer(-1)  # Does this gain make the turn faster or slower? (hint 1)
away_gain = sp.Integer(0)  # Does the gain have no effect on the escape? (hint 1)
away_time = sp.Float("1.7321")  # Is this the time without any thrust? (hint 1)
away_time = sp.Integer(1)  # Is the speed constant? (hint 1)
# Does a faster turn accelerate the satellite inwards or outwards? (hint 1)
closer_gain = sp.Integer(1)
closer_gain = sp.Integer(0)  # Does the gain have no effect on the turn? (hint 1)
closer_time = half  # Does the initial speed last? (hint 1)
closer_time = sp.Float("1.1939")  # Is this the time of the other item? (hint 1)

# %% right
switching = psi3 * omega  # without the distance, which is positive
transversality = [psi2 + psi3, psi2 - psi3]  # two combinations
kept = sp.sqrt((v - k) ** 2 + (rho * omega) ** 2)  # the length of the vector
surface = sp.Eq(omega**3 * rho, 0)  # a multiple and a power
away_time = sp.Float("1.1939")  # to five digits

# %% wrong
# Was the factor of the sine lost in the equilibrium equation? (hint 1)
a_exists = k >= -sp.Rational(3, 2)
# Is there no stationary solution where the two families meet? (hint 1)
a_exists = k > -sp.Rational(3, 4)
# Is the principal value of the arcsine the only angle with this sine? (hint 2)
a_stationary = [sp.asin(4 * k / 3) / 2 + sp.pi * n]
# Is it the sine of the angle itself that the equation fixes? (hint 1)
a_stationary = [sp.asin(4 * k / 3) + 2 * sp.pi * n, sp.pi - sp.asin(4 * k / 3) + 2 * sp.pi * n]
# What is the period of the double angle, and what does this mean for the angle itself? (hint 1)
a_stationary = [
    sp.asin(4 * k / 3) / 2 + 2 * sp.pi * n,
    sp.pi / 2 - sp.asin(4 * k / 3) / 2 + 2 * sp.pi * n,
]
# Was the inner derivative of the sine of the double angle lost? (hint 1)
a_deviation = -2 * k * Omega * dpsi + sp.Rational(3, 2) * Omega**2 * sp.cos(2 * phi0) * psi
# Does a constant moment appear in a deviation equation? (hint 1)
a_deviation = -2 * k * Omega * dpsi + 3 * Omega**2 * sp.cos(2 * phi0) * psi - 2 * k * Omega**2
a_saddle = sp.cos(2 * phi0) < 0  # Is the sign of the restoring term that of a pendulum? (hint 1)
a_saddle = sp.sin(2 * phi0) < 0  # Is every unstable angle a saddle? (hint 1)
# Are the roots complex right up to the border of existence? (hint 1)
a_foci = k > -sp.Rational(3, 4)
a_foci = 4 * k**4 + 16 * k**2 < 9  # Was the inner derivative lost in the discriminant? (hint 1)
# What is the sign of the friction here? Remember the sign of k. (hint 1)
a_stable = [sp.pi / 2 - sp.asin(4 * k / 3) / 2 + sp.pi * n]
# Is this the friction of item a? (hint 1)
b_deviation = -2 * k * Omega * dpsi + 3 * Omega**2 * sp.cos(2 * phi0) * psi
# Was the restoring term written down with the sign it has for a pendulum?
b_deviation = -2 * k1 * Omega * dpsi - 3 * Omega**2 * sp.cos(2 * phi0) * psi
b_stable = [sp.asin(4 * k / 3) / 2 + sp.pi * n]  # Is this the family of the saddles? (hint 2)
# Is the opposite direction left out? The double angle has a shorter period. (hint 2)
b_stable = [sp.pi / 2 - sp.asin(4 * k / 3) / 2 + 2 * sp.pi * n]
# Are all of them unstable here too, as in item a? (hint 1)
b_unstable = [sp.asin(4 * k / 3) / 2 + sp.pi * n, sp.pi / 2 - sp.asin(4 * k / 3) / 2 + sp.pi * n]
b_unstable = [sp.pi / 2 - sp.asin(4 * k / 3) / 2 + sp.pi * n]  # Is this the other family? (hint 1)
b_sign = sp.cos(2 * phi0) <= 0  # Is there no root at zero where the two families meet? (hint 1)
# Is it the cosine of the angle itself that decides, or that of the double angle? (hint 1)
b_sign = sp.cos(phi0) < 0
b_saddle = sp.cos(2 * phi0) < 0  # Were the signs swapped? (hint 1)
# Is the point where the families meet still a saddle? One root vanishes there. (hint 1)
b_saddle = sp.cos(2 * phi0) >= 0
# Is this the condition for foci? (hint 1)
b_nodes = sp.And(k > -sp.Rational(3, 4), k1**4 < 9 - 16 * k**2)
b_nodes = k1**2 >= 3  # Is the cosine of the double angle equal to 1 at these points? (hint 1)

# %% right
a_exists = sp.Interval.Ropen(-sp.Rational(3, 4), 0)  # as an interval
a_exists = sp.Abs(4 * sp.Symbol("k") / 3) <= 1  # by the modulus of the sine, with a plain symbol
# one formula with a sign that alternates
a_stationary = [(-1) ** n * sp.asin(4 * k / 3) / 2 + sp.pi * n / 2]
# each of the four angles of one turn by itself
a_stationary = [
    angle + 2 * sp.pi * n
    for angle in (
        sp.asin(4 * k / 3) / 2,
        sp.asin(4 * k / 3) / 2 + sp.pi,
        sp.pi / 2 - sp.asin(4 * k / 3) / 2,
        3 * sp.pi / 2 - sp.asin(4 * k / 3) / 2,
    )
]
# a common factor taken out
a_deviation = Omega * (3 * Omega * psi * (1 - 2 * sp.sin(phi0) ** 2) - 2 * k * dpsi)
# with k replaced by what it is at a stationary angle
a_deviation = (
    -sp.Rational(3, 2) * sp.sin(2 * phi0) * Omega * dpsi + 3 * Omega**2 * sp.cos(2 * phi0) * psi
)
a_saddle = sp.cos(phi0) ** 2 > sp.sin(phi0) ** 2  # by squares
a_saddle = sp.sin(phi0) ** 2 < sp.Rational(1, 2)  # by the sine
a_foci = sp.And(k > -sp.sqrt(sp.sqrt(73) - 8), k < 0)  # solved for k
# the discriminant as it comes, with the condition of existence
a_foci = sp.And(k >= -sp.Rational(3, 4), k**2 - 3 * sp.sqrt(1 - 16 * k**2 / 9) < 0)
# with the cosine of the single angle
b_deviation = -2 * k1 * Omega * dpsi + 3 * Omega**2 * (2 * sp.cos(phi0) ** 2 - 1) * psi
# two opposite directions, by the arccosine
b_stable = {
    3 * sp.pi / 4 - sp.acos(-4 * k / 3) / 2 + 2 * sp.pi * n,
    7 * sp.pi / 4 - sp.acos(-4 * k / 3) / 2 + 2 * sp.pi * n,
}
b_unstable = [sp.asin(4 * k / 3) / 2 - sp.pi * n]  # counted backwards
# two opposite directions
b_unstable = [
    sp.pi + sp.asin(4 * k / 3) / 2 + 2 * sp.pi * n,
    sp.asin(4 * k / 3) / 2 - 2 * sp.pi * n,
]
b_sign = sp.sin(phi0) ** 2 > sp.Rational(1, 2)  # by the sine
b_sign = sp.cos(phi0) ** 2 < sp.sin(phi0) ** 2  # by squares, turned round
b_saddle = sp.sin(phi0) ** 2 < sp.Rational(1, 2)  # by the sine
# solved for k1, with a root, the degenerate node left out
b_nodes = k1 > (9 - 16 * k**2) ** sp.Rational(1, 4)
b_nodes = k1**2 - 3 * sp.sqrt(1 - 16 * k**2 / 9) >= 0  # the discriminant as it comes

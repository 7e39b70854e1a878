# %% wrong
a_exists = k >= -sp.Rational(3, 2)  # the factor 2 lost: sin(2 phi0) = 2k/3
a_exists = k > -sp.Rational(3, 4)  # the border left out, where the two families meet
a_stationary = [sp.asin(4*k/3)/2 + sp.pi*n]  # only the main value of the arcsine
a_stationary = [sp.asin(4*k/3) + 2*sp.pi*n, sp.pi - sp.asin(4*k/3) + 2*sp.pi*n]  # the double angle forgotten
# a period of 2 pi taken for phi0, while the double angle repeats after 2 pi
a_stationary = [sp.asin(4*k/3)/2 + 2*sp.pi*n, sp.pi/2 - sp.asin(4*k/3)/2 + 2*sp.pi*n]
a_deviation = -2*k*Omega*dpsi + sp.Rational(3, 2)*Omega**2*sp.cos(2*phi0)*psi  # the inner derivative of sin(2 phi) lost
a_deviation = -2*k*Omega*dpsi + 3*Omega**2*sp.cos(2*phi0)*psi - 2*k*Omega**2  # the constant moment kept
a_saddle = sp.cos(2*phi0) < 0  # the sign of the restoring term taken as for a pendulum
a_saddle = sp.sin(2*phi0) < 0  # all unstable angles called saddles
a_foci = k > -sp.Rational(3, 4)  # the node next to the border of existence overlooked
a_foci = 4*k**4 + 16*k**2 < 9  # the inner derivative lost in the discriminant: 4 k**4 + 16 k**2 < 9
a_stable = [sp.pi/2 - sp.asin(4*k/3)/2 + sp.pi*n]  # the sign of the friction 2 k Omega overlooked: k is negative
b_deviation = -2*k*Omega*dpsi + 3*Omega**2*sp.cos(2*phi0)*psi  # the friction of item a
b_deviation = -2*k1*Omega*dpsi - 3*Omega**2*sp.cos(2*phi0)*psi  # the restoring term with the sign of a pendulum
b_stable = [sp.asin(4*k/3)/2 + sp.pi*n]  # the family of saddles
b_stable = [sp.pi/2 - sp.asin(4*k/3)/2 + 2*sp.pi*n]  # the opposite direction left out
b_unstable = [sp.asin(4*k/3)/2 + sp.pi*n, sp.pi/2 - sp.asin(4*k/3)/2 + sp.pi*n]  # all stationary angles, as in item a
b_unstable = [sp.pi/2 - sp.asin(4*k/3)/2 + sp.pi*n]  # the stable family
b_sign = sp.cos(2*phi0) <= 0  # the border counted in, where the families meet and one root is zero
b_sign = sp.cos(phi0) < 0  # the cosine of phi0 in the place of that of the double angle
b_saddle = sp.cos(2*phi0) < 0  # the signs exchanged
b_saddle = sp.cos(2*phi0) >= 0  # the border counted in: there it is a saddle-node
b_nodes = sp.And(k > -sp.Rational(3, 4), k1**4 < 9 - 16*k**2)  # the condition for foci
b_nodes = k1**2 >= 3  # |cos(2 phi0)| taken to be 1

# %% right
a_exists = sp.Interval.Ropen(-sp.Rational(3, 4), 0)  # as an interval
a_exists = sp.Abs(4*sp.Symbol("k")/3) <= 1  # by the modulus of the sine, with a plain symbol
a_stationary = [(-1)**n*sp.asin(4*k/3)/2 + sp.pi*n/2]  # one formula with a sign that alternates
# four angles of one turn
a_stationary = [sp.asin(4*k/3)/2, sp.asin(4*k/3)/2 + sp.pi, sp.pi/2 - sp.asin(4*k/3)/2, 3*sp.pi/2 - sp.asin(4*k/3)/2]
a_deviation = Omega*(3*Omega*psi*(1 - 2*sp.sin(phi0)**2) - 2*k*dpsi)  # a common factor taken out
# with k replaced by what it is at a stationary angle
a_deviation = -sp.Rational(3, 2)*sp.sin(2*phi0)*Omega*dpsi + 3*Omega**2*sp.cos(2*phi0)*psi
a_saddle = sp.cos(phi0)**2 > sp.sin(phi0)**2  # by squares
a_saddle = sp.sin(phi0)**2 < sp.Rational(1, 2)  # by the sine
a_foci = sp.And(k > -sp.sqrt(sp.sqrt(73) - 8), k < 0)  # solved for k
# the discriminant as it comes, with the condition of existence
a_foci = sp.And(k >= -sp.Rational(3, 4), k**2 - 3*sp.sqrt(1 - 16*k**2/9) < 0)
b_deviation = -2*k1*Omega*dpsi + 3*Omega**2*(2*sp.cos(phi0)**2 - 1)*psi  # with the cosine of the single angle
b_stable = {3*sp.pi/4 - sp.acos(-4*k/3)/2, 7*sp.pi/4 - sp.acos(-4*k/3)/2}  # two opposite directions, by the arccosine
b_unstable = [sp.asin(4*k/3)/2 - sp.pi*n]  # counted backwards
b_unstable = [sp.pi + sp.asin(4*k/3)/2, 2*sp.pi + sp.asin(4*k/3)/2]  # two opposite directions between 0 and 2 pi
b_sign = sp.sin(phi0)**2 > sp.Rational(1, 2)  # by the sine
b_sign = sp.cos(phi0)**2 < sp.sin(phi0)**2  # by squares, turned round
b_saddle = sp.sin(phi0)**2 < sp.Rational(1, 2)  # by the sine
b_nodes = k1 > (9 - 16*k**2)**sp.Rational(1, 4)  # solved for k1, with a root, the degenerate node left out
b_nodes = k1**2 - 3*sp.sqrt(1 - 16*k**2/9) >= 0  # the discriminant as it comes

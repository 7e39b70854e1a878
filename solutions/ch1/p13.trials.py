# %% wrong
# Is $x_1 \dot x_1 + x_2 \dot x_2$ the rate of $r$ itself? (hint 1)
a_polar = [-(r**2) * (r**2 - 1), -1]
a_polar = [-r * (r**2 - 1), 1]  # In which sense do the motions turn? (hint 2)
# Is this the transverse velocity instead of the rate of the angle? (hint 2)
a_polar = [-r * (r**2 - 1), -r]
a_origin = "stable"  # Was the 1 in the bracket overlooked? It gives a linear term. (hint 1)
a_origin = "asymptotically stable"  # Was a sign lost in front of the bracket? (hint 1)
# Was the factor 2 in the exponent lost with the substitution? (hint 2)
a_motion = 1 / sp.sqrt(1 + (1 / r0**2 - 1) * sp.exp(-t))
a_motion = 1 + (1 / r0**2 - 1) * sp.exp(-2 * t)  # Is this the new unknown instead of r? (hint 2)
# Is this the solution of the linearised equation? (hint 1)
a_motion = 1 + (r0 - 1) * sp.exp(-2 * t)
a_cycles = [0, 1]  # Is an equilibrium a limit cycle? (hint 1)
a_cycles = [1, -1]  # Can a radius be negative? (hint 1)
# Does an unstable equilibrium inside make the cycle unstable? Look at both sides of it. (hint 1)
a_kind = "unstable"
a_slope = sp.exp(-2)  # Is this the factor for a unit of time instead of a turn? (hint 1)
# Is this the slope of the rate $\dot r$ instead of that of the return map? (hint 1)
a_slope = -2
b_polar = [-r * (r**2 - 1), -1]  # Are these the rates of system a? (hint 1)
b_polar = [r * (r**2 - 1), 1]  # Was time reversed for the rotation too? (hint 1)
# Was the sign in front of the bracket mistaken for that of the linear term? (hint 1)
b_origin = "unstable"
b_cycles = []  # Is an unstable cycle no cycle? (hint 1)
# That motions inside do not cross the cycle holds for any cycle. Do they come closer? (hint 1)
b_kind = "stable"
b_slope = sp.exp(-4 * sp.pi)  # Is this the slope of system a? (hint 1)
b_slope = sp.exp(2)  # Does a turn take one unit of time? (hint 1)
c_polar = [-r * (r**2 - 1), -1]  # Was the square of the bracket lost? (hint 1)
c_polar = [-((r * (r**2 - 1)) ** 2), -1]  # Does the square belong to the factor r as well? (hint 1)
c_origin = "unstable"  # Was the square of -1 forgotten? (hint 1)
c_cycles = [1, -1]  # Does a double zero make two cycles? (hint 1)
c_cycles = []  # Does a cycle exist only where the rate of r changes its sign? (hint 1)
c_kind = "stable"  # Were only the motions outside considered? (hint 1)
c_kind = "unstable"  # Were only the motions inside considered? (hint 1)
c_slope = 0  # Is this the exponent instead of its exponential? (hint 1)
# Which derivative of $\dot r$ belongs in the exponent, the first or the second one? (hint 1)
c_slope = sp.exp(-16 * sp.pi)

# %% right
a_polar = sp.Matrix([r - r**3, -1])  # multiplied out, as a column
# not simplified, with the angle still in it
a_polar = [
    r * sp.cos(phi) ** 2 + r * sp.sin(phi) ** 2 - r**3,
    -(sp.sin(phi) ** 2) - sp.cos(phi) ** 2,
]
a_motion = r0 * sp.exp(t) / sp.sqrt(1 + r0**2 * (sp.exp(2 * t) - 1))  # with the growing exponential
a_cycles = 1.0  # the only radius, as a number

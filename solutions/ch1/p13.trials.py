# %% wrong
a_polar = [-r**2*(r**2 - 1), -1]  # x1 x1' + x2 x2' taken for r', though it is r r'
a_polar = [-r*(r**2 - 1), 1]  # the sense of rotation turned
a_polar = [-r*(r**2 - 1), -r]  # the transverse velocity r phi' given for phi'
a_origin = "stable"  # the 1 in the bracket overlooked: eigenvalues i and -i
a_origin = "asymptotically stable"  # the sign of -x1*(-1) lost
a_motion = 1/sp.sqrt(1 + (1/r0**2 - 1)*sp.exp(-t))  # the factor 2 of the exponent lost when the square was substituted
a_motion = 1 + (1/r0**2 - 1)*sp.exp(-2*t)  # u = 1/r**2 given for r
a_motion = 1 + (r0 - 1)*sp.exp(-2*t)  # the linearised equation solved instead of the full one
a_cycles = [0, 1]  # the equilibrium counted as a cycle
a_cycles = [1, -1]  # both roots of r**2 = 1
a_kind = "unstable"  # an unstable equilibrium inside taken for a sign of an unstable cycle
a_slope = sp.exp(-2)  # the factor for a unit of time, not for a turn
a_slope = -2  # the slope of r' instead of that of the return map
b_polar = [-r*(r**2 - 1), -1]  # the rates of system a
b_polar = [r*(r**2 - 1), 1]  # time reversal applied to the rotation as well
b_origin = "unstable"  # the sign before the bracket taken for that of the linear term
b_cycles = []  # an unstable cycle taken for none
b_kind = "stable"  # stable because motions inside do not cross it
b_slope = sp.exp(-4*sp.pi)  # the slope of system a
b_slope = sp.exp(2)  # 2*pi forgotten in the exponent
c_polar = [-r*(r**2 - 1), -1]  # the square of the bracket lost
c_polar = [-(r*(r**2 - 1))**2, -1]  # the factor r squared along with the bracket
c_origin = "unstable"  # the square of -1 forgotten
c_cycles = [1, -1]  # the double zero counted as two cycles
c_cycles = []  # no cycle, because r' does not change its sign
c_kind = "stable"  # only the motions outside looked at
c_kind = "unstable"  # only the motions inside looked at
c_slope = 0  # the exponent instead of its exponential
c_slope = sp.exp(-16*sp.pi)  # the second derivative of r' put in where the first one vanishes

# %% right
a_polar = sp.Matrix([r - r**3, -1])  # multiplied out, as a column
# not simplified, with the angle still in it
a_polar = [r*sp.cos(phi)**2 + r*sp.sin(phi)**2 - r**3, -sp.sin(phi)**2 - sp.cos(phi)**2]
a_motion = r0*sp.exp(t)/sp.sqrt(1 + r0**2*(sp.exp(2*t) - 1))  # with the growing exponential
a_cycles = 1.0  # the only radius, as a number

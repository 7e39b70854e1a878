# %% wrong
a_controllable = True  # the second equation holds the control, and the first one its effect
a_lost = [sp.I*Omega, -sp.I*Omega]  # the oscillation for the constant
a_lost = []  # thought to be controllable
a_lost = [0, sp.I*Omega, -sp.I*Omega]  # all roots of the determinant
a_uncontrolled = [[0, 0, 1, 0]]  # the rate of x1 alone, whose equation holds x2'
a_uncontrolled = [[0, -2*Omega/r0, 1, 0]]  # a sign lost in the integration
a_uncontrolled = [[0, 2*Omega, 1, 0]]  # r0 lost: an angle and a height added up
a_uncontrolled = [[1, 0, 0, 0], [0, 2*Omega/r0, 1, 0]]  # the angle counted as well
b_controllable = False  # the height thought to be out of reach of a thrust along the orbit
b_lost = [0]  # the root that is lost in case a
b_lost = [sp.sqrt(3)*Omega, -sp.sqrt(3)*Omega]  # where the minor vanishes, though these are no roots
c_region = sp.Or(sp.Ne(b1, 0), sp.Ne(b2, 0))  # any thrust at all taken for enough
c_region = sp.And(sp.Ne(b1, 0), sp.Ne(b2, 0))  # both components asked for
c_region = sp.Ne(b2, 0)  # the cases a and b interchanged

# %% right
a_lost = [Omega - Omega]  # a zero that is computed
a_uncontrolled = [[0, 2*Omega, r0, 0]]  # multiplied by r0
a_uncontrolled = [[0, -1, -r0/(2*Omega), 0]]  # as a height
c_region = sp.Ne(b1**2*(4*b1**2 + b2**2), 0)  # the determinant
c_region = sp.Or(b1 < 0, b1 > 0)  # two half-planes

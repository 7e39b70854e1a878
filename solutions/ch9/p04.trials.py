# %% wrong
a_east = sp.sin(theta)  # Is this how far it comes to the north? (hint 1)
a_east = theta * sp.sin(theta)  # Does the vehicle have its last heading all the time? (hint 2)
a_east = sp.Integer(
    0
)  # Does the vehicle move straight ahead, as the published section does? (hint 1)
a_east = theta**2 / 2  # Is a parabola an arc of a circle for long steps, too? (hint 2)
b_north = theta * sp.sin(theta)  # This is the end of the published section. (hint 1)
b_north = 1 - sp.cos(2 * theta)  # What is the heading after a turn of two steps? (hint 1)
b_north = 1 - sp.cos(theta)  # Does it move to the east while it turns back? (hint 2)
c_covered = t <= s / delta  # How far apart are the two remaining nodes? (hint 1)
c_covered = t >= s / (2 * delta)  # Do the sections move apart or together? (hint 1)
c_covered = sp.true  # Do sections of different speeds stay together? (hint 1)

# %% right
a_east = 2 * sp.sin(theta / 2) ** 2  # by the chord
b_north = sp.Integral(sp.sin(t), (t, 0, theta)).doit() * 2  # as an integral of one arc, twice
b_north = 4 * sp.sin(theta / 2) ** 2  # by two chords
c_covered = s - 2 * delta * t >= 0  # by the overlap
c_covered = delta <= s / (2 * t)  # solved for the distance of the nodes

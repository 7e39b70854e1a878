# %% wrong
estimate = estimate[::-1]  # Were height and slope interchanged? (hint 1)
# Is this the height in the middle of the times? Where does the line start? (hint 2)
estimate = [sum(estimate), estimate[1]]
# Does the line have to pass through the first point? (hint 1)
estimate = [readings[0], estimate[1]]
# Does the sum of squares include the first point? (hint 1)
slope = readings[2] - readings[1]
estimate = [readings[1] - slope, slope]
first_two = [first_two[0], -first_two[1]]  # Does the line rise or fall? (hint 1)
first_two = estimate  # Is this the estimate with the third measurement? (hint 1)

# %% right
# from the means
slope = sp.Rational(readings[2] - readings[0], 2)
estimate = [sp.Rational(sum(readings), 3) - slope, slope]

# %% numbers
readings = [
    [2, 1, 4],
    [1, 3, 2],
    [3, 1, 4],
    [5, 2, 1],
    [2, 5, 3],
    [4, 1, 6],
    [1, 4, 5],
    [3, 5, 2],
    [6, 2, 3],
    [5, 1, 3],
    [4, 6, 5],
    [7, 3, 1],
    [2, 3, 1],
    [6, 4, 1],
]
shown = [r"$z(0) = «readings[0]»$, $z(1) = «readings[1]»$, $z(2) = «readings[2]»$"]
first_two = [readings[0], readings[1] - readings[0]]
slope = sp.Rational(readings[2] - readings[0], 2)
estimate = [sp.Rational(sum(readings), 3) - slope, slope]

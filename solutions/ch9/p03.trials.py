# %% wrong
# Which headings other than north can precede the heading north? (hint 1)
r = sp.sqrt(2)
a_forecast = [
    (4 * r + 1) * a,
    5 * r * a,
    a,
    -3 * r * a,
    (1 - 4 * r) * a,
    -3 * r * a,
    a,
    5 * r * a,
]
# Does a section move with its old heading or with its new one? (hint 2)
r = sp.sqrt(2)
a_forecast = [
    (4 * r + 1) * a,
    (4 + 3 * r) * a,
    (2 * r + 1) * a,
    0 * a,
    -(2 * r - 1) * a,
    0 * a,
    (2 * r + 1) * a,
    (4 + 3 * r) * a,
]
# How far does a square reach in the direction of its corner? (hint 2)
r = sp.sqrt(2)
a_forecast = [
    (4 * r + 1) * a,
    (2 * r + 3) * a,
    3 * a,
    -a,
    -(2 * r + 1) * a,
    -a,
    3 * a,
    (2 * r + 3) * a,
]
# Are all of the lesser values tight? (hint 1)
r = sp.sqrt(2)
b_measured = [
    (4 * r + 1) * a,
    (3 * r + 2) * a,
    3 * a,
    -a / r,
    -6 * a,
    -7 * a / r,
    -a,
    7 * a / r,
]
# The eastern side is right. What is then the corner in the south-east? (hint 2)
r = sp.sqrt(2)
b_measured = [
    (4 * r + 1) * a,
    (3 * r + 2) * a,
    2 * r * a,
    -a / r,
    -6 * a,
    -7 * a / r,
    -a,
    4 * a,
]
# Did the vehicle fly both steps to the north-east? (hint 1)
c_east = sp.And(3 * a <= c, c <= 5 * a)
# Must the whole square be inside the measured one? (hint 2)
c_east = sp.Eq(c, (2 * sp.sqrt(2) + 1) * a)
# Can the measured square also be too low? (hint 2)
c_east = c <= (2 * sp.sqrt(2) + 3) * a

# %% right
# greatest values over all corners
a_forecast = [
    sp.Max(*(octagon.row(i).dot(sp.Matrix(p).T).subs(a, 1) for p in to_north)) * a for i in range(8)
]
# over the corners of the polygon, as one matrix
cornering = sp.Matrix(
    [[1, 6], [2 * sp.sqrt(2), 6], [5 - 2 * sp.sqrt(2), 4 * sp.sqrt(2) + 1], [1, 4 * sp.sqrt(2) + 1]]
)
b_measured = [a * sp.Max(*(octagon.row(i) * cornering.T)) for i in range(8)]
c_east = sp.Abs(c - (2 * sp.sqrt(2) + 1) * a) <= 2 * a  # by the distance of the middles

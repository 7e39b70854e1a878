# %% wrong
# Do all six sides still touch the remaining set? (hint 2)
a_tight = [w, w, 3 * w, w, w, -w]
# How far from zero is the last strip at least? (hint 2)
a_tight = [0, w, 2 * w, w, 0, w]
# Was the side moved to the strip's middle instead of the corner of its neighbours? (hint 2)
a_tight = [0, w, 2 * w, w, 0, -2 * w]
# Is the first corner cut off there, or is the set empty? (hint 2)
b_common = c <= 2 * w
b_common = c < 3 * w  # Does a position on two coinciding sides agree with both? (hint 2)
b_common = sp.true  # Were opposite values added before they were tight? (hint 1)
# Which corner do both squares have in the south-east? (hint 1)
c_tight = [d, sp.sqrt(2) * d, d, (a + d) / sp.sqrt(2), 0, 0, 0, (a + d) / sp.sqrt(2)]
c_tight = [d, d, d, d, 0, 0, 0, d]  # Do all eight normals have the length 1? (hint 2)
# Is this the hull of the two squares instead of their intersection? (hint 1)
c_tight = [
    a + d,
    sp.sqrt(2) * (a + d),
    a + d,
    (a + d) / sp.sqrt(2),
    a,
    sp.sqrt(2) * a,
    a,
    (a + d) / sp.sqrt(2),
]

# %% right
a_tight = list(w * sp.Matrix([0, 1, 2, 1, 0, -1]))  # a vector times the width
# by the corners of the triangle
a_tight = [
    sp.Max(0, -w),
    sp.Max(-w, w),
    sp.Max(w, 2 * w),
    sp.Max(0, w),
    sp.Min(0, w),
    -sp.Min(w, 2 * w),
]
b_common = sp.Abs(c - w) <= 2 * w  # by the distance from the middle
b_common = sp.Ge(sp.Min(2 * w, 3 * w - c), 0)  # the opposite sums
# by angles
c_tight = [
    d,
    2 * d * sp.cos(sp.pi / 4),
    d,
    d * sp.sin(3 * sp.pi / 4),
    0,
    0,
    0,
    d * sp.cos(sp.pi / 4),
]

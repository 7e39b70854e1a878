"""Information sets of a planar vehicle from measurements with bounded errors.

A vehicle moves by x' = V sin psi, y' = V cos psi, psi' = k u/V, V' = w with |u| <= 1 and mu1 <= w
<= mu2 (psi from the y axis clockwise); u and w are unknown. A measurement states that (x, y) lies
in a convex set. The information set is the set of all states (x, y, psi, V) that are compatible
with all measurements so far. It is stored as convex polygons in the plane, one for each node of a
grid of headings and speeds, each polygon by its support values on m fixed normals. Source: Kumkov,
Patsko, Pyatko and Fedotov (2000), with the corrections listed in chapter 9 of the book.

>>> from trajlib import infosets
>>> "InformationSet" in dir(infosets)
True
"""

from trajlib._lazy import lazy_names

_EXPORTS = {
    "polygons": ["SupportPolygons"],
    "regions": ["Region"],
    "errors": ["EmptyInformationSet"],
    "known_speed": ["ConstantSpeedInformationSet"],
    "unknown_speed": ["InformationSet"],
    "dubins": ["DubinsReachable", "dubins_reachable"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)

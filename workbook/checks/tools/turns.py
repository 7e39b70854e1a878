"""Angles modulo a turn.

Where an integer numbers the values that are asked for, all of them are: a turn more of each is one
too, a list of finitely many is not all, and a family is followed through several turns. Where a
domain is given instead, the values in it are asked for, as they are written.
"""

import sympy as sp

from workbook.checks.tools.values import number_at

#: The most members of a family on either side of its middle one.
MOST = 60


def members_of(family, values, integer, reach):
    """Return the members of a family between -reach and reach, and a few beyond either end.

    Parameters
    ----------
    family : sympy.Expr
        The expression in the integer and parameters; without the integer it has one member.
    values : dict
        Values of the parameters.
    integer : sympy.Symbol or None
        The integer.
    reach : float
        The size up to which members are wanted.

    Returns
    -------
    list
        Triples (text on the member for a message, its complex number, values with the integer).
    """

    def member(k):
        member_values = values if integer is None else values | {integer: sp.Integer(k)}
        return number_at(family, member_values, "your value"), member_values

    if integer is None or not family.has(integer):
        return [("", *member(0))]
    # Of a family such as (-1)^n a + pi n every second step is the same.
    (start, _), (following, _) = member(0), member(2)
    step = abs(following - start) / 2
    centre = round((2 * start / (start - following)).real) if step > 1e-9 else 0
    extent = min(int(reach / step) + 3, MOST) if step > 1e-9 else 12
    return [
        (f" ({integer} = {k})", *member(k)) for k in range(centre - extent, centre + extent + 1)
    ]


def finite_list_text(noun, value, where, integer):
    """Return the message on a list that gives finitely many of the values that an integer numbers."""
    return (
        f"not all {noun} are there: {value:.4g} is one too{where}, and a list has an end; write the "
        f"family with the integer {integer}"
    )

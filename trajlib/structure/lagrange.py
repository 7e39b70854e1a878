"""Small motions of a driven mechanical system, M q'' + K q = L u, from the energies.

With the kinetic energy T(q, q', v) and the potential energy V(q), where v is the speed of the
driven part (a cart, a table) and u = v' its acceleration, Lagrange's equations are d/dt T_q' - T_q
+ V_q = 0. Near an equilibrium q = 0

    M = T_q'q',   K = V_qq,   L = -T_q'v   at q = 0, q' = 0, v = 0:

the terms with v alone, v T_q'vq q' from the first part and T_q from the second, cancel each other.
"""

from collections.abc import Sequence
from typing import NamedTuple

import sympy as sp

__all__ = ["SmallMotions", "small_motions"]


class SmallMotions(NamedTuple):
    """The equations of small motions M q'' + K q = L u.

    Attributes
    ----------
    M, K : sympy.Matrix, shape (n, n)
        Matrices of inertia and stiffness (kg m^2 and N m for angles).
    L : sympy.Matrix, shape (n, 1)
        Column of the control.
    """

    M: sp.Matrix
    K: sp.Matrix
    L: sp.Matrix


def small_motions(
    kinetic: sp.Expr,
    potential: sp.Expr,
    coordinates: Sequence[sp.Symbol],
    rates: Sequence[sp.Symbol],
    speed: sp.Symbol,
) -> SmallMotions:
    """Return the equations of small motions near q = 0, driven by the acceleration u = v'.

    Parameters
    ----------
    kinetic : sympy.Expr
        Kinetic energy in the coordinates, their rates and the speed; other symbols are parameters.
    potential : sympy.Expr
        Potential energy in the coordinates.
    coordinates : sequence of sympy.Symbol
        q.
    rates : sequence of sympy.Symbol
        q', one for each coordinate.
    speed : sympy.Symbol
        v, the speed of the driven part.

    Returns
    -------
    SmallMotions
        M, K and L.

    Raises
    ------
    ValueError
        If the numbers of coordinates and rates differ, or if q = 0 is no equilibrium.

    Examples
    --------
    >>> import sympy as sp
    >>> m, l, g = sp.symbols("m l g", positive=True)
    >>> phi, rate, v = sp.symbols("phi w v", real=True)
    >>> kinetic = m*((v + l*rate*sp.cos(phi))**2 + (l*rate*sp.sin(phi))**2)/2      # an inverted pendulum on a cart
    >>> small_motions(kinetic, m*g*l*sp.cos(phi), [phi], [rate], v)
    SmallMotions(M=Matrix([[l**2*m]]), K=Matrix([[-g*l*m]]), L=Matrix([[-l*m]]))
    """
    if len(coordinates) != len(rates):
        raise ValueError(
            f"rates: expected one for each of the {len(coordinates)} coordinates, got {len(rates)}"
        )
    equilibrium = dict.fromkeys([*coordinates, *rates, speed], 0)
    force = [sp.simplify(sp.diff(potential, q).subs(equilibrium)) for q in coordinates]
    if any(force):
        raise ValueError(f"potential: the position 0 is no equilibrium, its slope there is {force}")

    def second(function, first_variables, second_variables):
        return sp.Matrix(
            [
                [sp.expand(sp.diff(function, a, b).subs(equilibrium)) for b in second_variables]
                for a in first_variables
            ]
        )

    return SmallMotions(
        second(kinetic, rates, rates),
        second(potential, coordinates, coordinates),
        -second(kinetic, rates, [speed]),
    )

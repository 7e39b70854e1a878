"""Oracle of gains at equilibria: the points as they are written, SymPy's polynomials of the loops by
Hurwitz's minors."""

import sympy as sp

from oracles.feedback.loops import _minors


def equilibrium_gains(mutant, reference, field, state, controls, domain=None, zeros=None):
    """A point of the reference each, once; a gain where the reference has one, and none where it
    has none."""
    if not all(
        isinstance(pair, (list, tuple)) and len(pair) == 2 and len(list(pair[0])) == len(state)
        for pair in mutant
    ):
        return False
    left = {_numbers(place): K for place, K in reference}
    for place, K in mutant:
        near = [
            other
            for other in left
            if all(abs(a - b) < 1e-9 for a, b in zip(_numbers(place), other))
        ]
        if len(near) != 1:
            return False
        known = left.pop(near[0])
        if len(list(K)) != (len(state) * len(controls) if list(known) else 0):
            return False
        if not list(K):
            continue
        at = dict(zip(state, place)) | dict.fromkeys(controls, 0)
        A, B = (sp.Matrix(field).jacobian(names).subs(at) for names in (state, controls))
        s = sp.Dummy("s")
        loop = A + B * sp.Matrix(len(controls), len(state), list(K))
        polynomial = (s * sp.eye(len(state)) - loop).det(method="berkowitz")
        if not all(
            sp.re(minor) > 0 and sp.im(minor) == 0 for minor in _minors(sp.expand(polynomial), s)
        ):
            return False
    return not left


def _numbers(place):
    return tuple(complex(sp.sympify(x).evalf()) for x in place)


ORACLES = {"equilibrium_gains": equilibrium_gains}

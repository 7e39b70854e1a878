"""Reachability as conditions on the symbols, by closed forms for linear systems.

The controls of x' = Ax + bu lie between two bounds. With zero between them, and (A, b)
controllable, the starts that can be brought to the origin are all those whose parts along the
growing modes are small enough (Brammer 1972; Sontag 1984): for a left eigenvector w of an
eigenvalue lambda > 0 they are the w.x0 between -max w.bu/lambda and -min w.bu/lambda, ends left
out, since w.x0 = -int e^{-lambda s} w.bu ds.
"""

import sympy as sp


def on_a_line(dynamics, control, bounds, start, end):
    """Return the condition that x' = f(x, u) comes from start to end; None if not linear.

    It does if the rate towards the end is positive at both, and so between them.
    """
    ((x, rate),) = dynamics.items()
    if not linear([rate], [x, control]):
        return None
    greatest, least = _extremes(rate, control, bounds)

    def condition(direction, rate):
        return sp.And(
            direction * (end - start) > 0,
            *(direction * rate.subs(x, point) > 0 for point in (start, end)),
        )

    return sp.Or(condition(1, greatest), condition(-1, least))


def in_time(dynamics, control, bounds, start, end, duration):
    """Return the condition that x' = f(u) comes from `start` to `end` within the duration.

    None where the rate depends on the state.
    """
    ((x, rate),) = dynamics.items()
    if rate.has(x) or not linear([rate], [control]):
        return None
    greatest, least = _extremes(rate, control, bounds)
    return sp.Or(
        sp.Eq(start, end),
        sp.And(end > start, duration * greatest >= end - start),
        sp.And(end < start, duration * least <= end - start),
    )


def to_origin(A, b, bounds, start):
    """Return the condition that x' = Ax + bu in the plane can be brought to the origin.

    None if no closed form is known here.
    """
    low, high = bounds
    chain = sp.Matrix.hstack(b, A * b)
    if chain.det() == 0 or not (low.is_number and high.is_number):
        return None
    if not any(A**2):
        row = sp.Matrix([[0, 1]]) * chain.inv()  # z1 = row.x has z1' = z2, z2' = u
        return _braked(*(row * sp.Matrix(start)), *(row * A * sp.Matrix(start)), low, high)
    modes = [
        (value, left_vector)
        for value, _, vectors in A.T.eigenvects()
        for left_vector in vectors
        if sp.re(value) > 0
    ]
    if not (low < 0 < high) or len(modes) > 1 or any(not value.is_real for value, _ in modes):
        return None
    inside = []
    for value, left_vector in modes:
        ends = sorted((left_vector.T * b)[0] * end / value for end in bounds)
        component = (left_vector.T * sp.Matrix(start))[0]
        inside += [ends[0] < -component, -component < ends[1]]
    return sp.And(*inside)


def _braked(z, speed, low, high):
    """Return the condition that z'' = u can be brought to rest at zero.

    With pushes to one side alone only what comes from that side can, from between the distances of
    braking with the one bound and with the other.
    """
    if low < 0 < high:
        return sp.true
    if high <= 0:
        z, speed, low, high = -z, -speed, -high, -low
    return sp.And(speed < 0, 2 * high * z >= speed**2, *([2 * low * z <= speed**2] if low else []))


def arrivals(field, state, control, bounds, target, ends):
    """Return the least rate of the target's expression at the points `ends`.

    A motion arrives from where the expression is positive if the rate is negative, and none does where
    it is positive.
    """
    at = dict(zip(state, ends))
    rates = [
        sum(sp.diff(target, x) * f.subs(control, u) for x, f in zip(state, field)).subs(
            at, simultaneous=True
        )
        for u in bounds
    ]
    middle, half = (rates[0] + rates[1]) / 2, (rates[1] - rates[0]) / 2
    return sp.expand(middle) - sp.Abs(sp.factor(half))


def touching(field, state, control, bounds, target):
    """Return the condition that a motion touches the border from the positive side.

    No other control brings it closer there; the second condition is wider, with what lies on the border.
    """

    def rate(part, u):
        return sum(sp.diff(part, x) * f.subs(control, u) for x, f in zip(state, field))

    conditions, wider_conditions = [], []
    for u, opposite in (bounds, bounds[::-1]):
        on_border = sp.And(sp.Eq(target, 0), sp.Eq(rate(target, u), 0))
        rate_difference = sp.expand(rate(target, opposite) - rate(target, u))
        bend = rate(rate(target, u), u)
        conditions.append(sp.And(on_border, rate_difference > 0, bend > 0))
        turns, stays = bend > 0, sp.And(rate_difference >= 0, sp.Eq(bend, 0))
        wider = sp.Or(sp.And(rate_difference > 0, turns), stays)
        wider_conditions.append(sp.And(on_border, wider))
    return sp.Or(*conditions), sp.Or(*wider_conditions)


def beyond_line(A, b, bounds, state, line, time):
    """Return how far beyond the line c.x + d = 0, to either side, states are reached at a time.

    They are two polynomials in state and time; None if they are none, or if the control that goes
    farthest switches. The costate at the end of an extremal is normal to the line, so it ends where one
    of these crosses zero upwards.
    """
    normal = sp.Matrix([line]).jacobian(state)
    effect = sp.expand((normal * (sp.eye(2) + A * time) * b)[0])
    signs = {sp.sign(c) for c in effect.as_coefficients_dict().values()} - {0}
    if any(A**2) or len(signs) != 1 or not all(bound.is_number for bound in bounds):
        return None
    free = sp.expand(line + (normal * A * sp.Matrix(state))[0] * time)
    integrals = sorted(
        (bound * sp.integrate(effect, (time, 0, time)) for bound in bounds),
        key=lambda integral: integral.subs(time, 1),
    )
    return sp.expand(free + integrals[1]), sp.expand(-free - integrals[0])


def linear(expressions, symbols):
    """Return whether expressions are polynomials of degree one in the symbols."""
    return all(
        sp.expand(e).is_polynomial(*symbols) and sp.Poly(e, *symbols).total_degree() <= 1
        for e in expressions
    )


def _extremes(rate, control, bounds):
    """Return the greatest and the least value of what is linear in the control."""
    values = [rate.subs(control, u) for u in bounds]
    return sp.Max(*values), sp.Min(*values)


def linear_parts(dynamics, control):
    """Return A, b and the constant part of a linear system."""
    state = list(dynamics)
    field = sp.Matrix(list(dynamics.values()))
    zero = dict.fromkeys([*state, control], 0)
    return field.jacobian(state), field.jacobian([control]), list(field.subs(zero))

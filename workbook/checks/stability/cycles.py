"""Planar motions in polar coordinates: equations, limit cycles and neighbouring motions.

The closed orbits of these checks are circles around zero. They are found from the field alone: on
such a circle the radial velocity vanishes at every angle and the angular velocity nowhere.
"""

import functools
import math

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression, Expressions, Number
from workbook.checks.contract.members import NUMBERS, members
from workbook.checks.contract.tolerance import REPEATED, agree, in_decimals, rounds_to
from workbook.checks.contract.verdict import Invalid, UnsuitableData, Wrong, judged
from workbook.checks.references.equilibria import equilibria_of
from workbook.checks.references.fields import cached_field
from workbook.checks.tools.substitution import real_at
from workbook.checks.tools.values import number_at, uncertainty_at, value_at
from workbook.checks.tools.wording import other_text, sample_text

CYCLES = ("stable", "unstable", "semistable")
#: Sample angles on a circle; no multiples of pi/2, where single terms of a field vanish.
ANGLES = 0.4 + 2 * math.pi * np.arange(24) / 24


@judged(Expressions("polar", length=2))
def polar_form(rates, field, state, polar):
    """Check the pair (r', phi') of a planar system, in the polar coordinates `polar`.

    Can decide when the field has values at random points, where both rates are compared.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> r, phi = sp.symbols("r phi", positive=True)
    >>> checks.polar_form([-r, -1], [y - x, -x - y], [x, y], [r, phi]).status
    'right'
    >>> checks.polar_form([r, -1], [y - x, -x - y], [x, y], [r, phi]).status
    'wrong'
    """
    flow = cached_field(tuple(field), tuple(state))
    random = np.random.default_rng(8)
    for _ in range(20):
        r, phi = random.uniform(0.2, 2.5), random.uniform(0, 2 * math.pi)
        true = _polar_velocity(flow, r, phi)
        size = (
            abs(true[0]) / r + abs(true[1]) + np.linalg.norm(flow(_cartesian(r, phi))) * (1 + 1 / r)
        )
        for name, rate, value in zip(("r'", "phi'"), rates, true):
            stated = number_at(rate, dict(zip(polar, (r, phi))), f"your expression for {name}")
            if not abs(stated - value) <= 1e-9 * size:
                raise Wrong(
                    f"at r = {r:.3g}, phi = {phi:.3g} "
                    + other_text(f"{name} of the motion", stated.real, value)
                )
    return "both rates agree with the velocity of the motion at random points"


@judged(Expression("time", "start"))
def radial_motion(claim, field, state, time, start):
    """Check the distance r(t) from zero of the motion with r(0) = r0.

    It is asked for t >= 0, as long as the motion lasts.

    For fields whose r' does not depend on the angle. Judged by substitution: the initial value
    and the rate of change.

    Can decide when the rate of r does not depend on the angle; five motions are tried.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> t, r0 = sp.symbols("t r0", positive=True)
    >>> checks.radial_motion(r0*sp.exp(-t), [y - x, -x - y], [x, y], t, r0).status
    'right'
    >>> checks.radial_motion(r0*(1 - t), [y - x, -x - y], [x, y], t, r0).status
    'wrong'
    """
    slope = sp.diff(claim, time)
    flow = cached_field(tuple(field), tuple(state))
    for r0 in (0.3, 0.85, 1.0, 1.4, 2.3):
        life = _lifetime(flow, r0)
        for t in (0.0, 0.1 * life, 0.35 * life, 0.8 * life):
            values = {time: sp.Float(t, 25), start: sp.Float(r0, 25)}
            r = value_at(claim, values, "r")
            if t == 0 and not abs(r - r0) <= 1e-9 * r0:
                raise Wrong(f"for r0 = {r0:g} your motion starts at r(0) = {r:.4g}")
            if r <= 0:
                raise Wrong(
                    f"for r0 = {r0:g} your motion has r = {r:.4g} at t = {t:.3g}; a distance from "
                    "zero stays positive here"
                )
            true, stated = (
                _polar_velocity(flow, r, ANGLES[0])[0],
                value_at(slope, values, "r, differentiated,"),
            )
            if not abs(stated - true) <= 1e-9 * (abs(true) + r) < math.inf:
                raise Wrong(
                    f"for r0 = {r0:g} your motion does not satisfy the equation for r': at t = {t:.3g} "
                    f"its r is {r:.4g} and the derivative of its r is {stated:.4g}"
                )
    return "it starts at r0, and everywhere r' is that of the system, for motions from five initial states"


@judged
def limit_cycles(answer, field, state):
    """Check the radii of all limit cycles that are circles around zero.

    Can decide when the cycles are circles about zero.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> size = x**2 + y**2 - 4
    >>> checks.limit_cycles([2], [y - x*size, -x - y*size], [x, y]).status
    'right'
    >>> checks.limit_cycles([2, 4], [y - x*size, -x - y*size], [x, y]).status
    'wrong'
    """
    flow = cached_field(tuple(field), tuple(state))
    entries = members(answer, "a list of radii", single=(*NUMBERS, Relational))
    if any(isinstance(entry, Relational) for entry in entries):
        raise Invalid("expected the radii themselves, without equations")
    numbers = [coercion.as_number(entry) for entry in coercion.as_expressions(entries)]
    radii = list(map(float, numbers))
    reference_radii = _circles(flow)
    for number, radius in zip(numbers, radii):
        if radius == 0:
            raise Wrong("r = 0 is a position of equilibrium, not a closed orbit")
        if radius < 0:
            raise Wrong(f"the radius {radius:.4g} is negative")
        if not any(
            agree(radius, reference, number, computed=REPEATED) for reference in reference_radii
        ):
            rates = [_polar_velocity(flow, radius, phi)[0] for phi in ANGLES]
            raise Wrong(
                f"the circle r = {radius:.4g} is not a closed orbit: r' = "
                f"{max(rates, key=abs):.4g} at a point of it"
            )
    missed = [
        reference
        for reference in reference_radii
        if not any(
            agree(radius, reference, number, computed=REPEATED)
            for number, radius in zip(numbers, radii)
        )
    ]
    if missed:
        raise Wrong(
            "your list does not hold all of them: there is another circle around zero on which r' "
            "vanishes"
        )
    if in_decimals(*numbers):
        evidence = "to three digits"
    elif _proved(numbers, sp.Matrix(field), state):
        evidence = "proved"
    else:
        evidence = "agrees at sample angles"
    return f"on these circles, and on no others, r' vanishes at every angle while phi' does not: {evidence}"


def _proved(radii, field, state):
    """Return whether these radii are proved to be all circles of a polynomial field.

    With x = r cos, y = r sin the rates are polynomials in cos and sin, of first degree in sin; all
    coefficients of r' have to vanish.
    """
    r, c, s = sp.symbols("r c s")
    rates = field.subs(dict(zip(state, (r * c, r * s))), simultaneous=True).applyfunc(sp.expand)
    if not all(rate.is_polynomial(r, c, s) for rate in rates):
        return False
    f, g = rates
    outward, around = (
        sp.Poly(sp.rem(rate, c**2 + s**2 - 1, s), c, s) for rate in (c * f + s * g, c * g - s * f)
    )
    radial = sp.Poly(functools.reduce(sp.gcd, outward.coeffs()), r)
    if not around.is_ground or len(set(radii)) != radial.count_roots(0) - (radial.eval(0) == 0):
        return False
    return all(radial.eval(radius) == 0 != around.as_expr().subs(r, radius) for radius in radii)


@judged
def cycle_stability(answer, field, state, radius=None):
    """Check whether a limit cycle is stable, unstable or semistable.

    It is the only one, or the one of radius `radius`. Judged by motions that start a little inside
    and a little outside of it.

    Can decide when motions that start near the cycle move away or towards it within the time for
    which they are followed.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> size = x**2 + y**2 - 1
    >>> checks.cycle_stability("stable", [y - x*size, -x - y*size], [x, y]).status
    'right'
    >>> checks.cycle_stability("unstable", [y - x*size, -x - y*size], [x, y]).status
    'wrong'
    """
    # "semi-stable" is accepted too.
    joined = "".join(answer.replace("-", " ").split()) if isinstance(answer, str) else answer
    claim = coercion.as_choice(joined, CYCLES)
    flow = cached_field(tuple(field), tuple(state))
    radius = _circle(flow, radius)
    inside, outside = (_tendency(flow, radius, side) for side in (-1, 1))
    reference = {("to", "to"): "stable", ("from", "from"): "unstable"}.get(
        (inside, outside), "semistable"
    )
    if claim != reference:
        claimed = {"stable": ("to", "to"), "unstable": ("from", "from")}.get(claim)
        if claimed is None:
            raise Wrong(
                "semistable means that motions on one side move towards the cycle and motions on "
                f"the other away from it: try r = {0.95 * radius:g} and r = {1.05 * radius:g}"
            )
        side, start = (
            ("inside", 0.95 * radius) if inside != claimed[0] else ("outside", 1.05 * radius)
        )
        movement = {"to": "towards", "from": "away from"}[inside if side == "inside" else outside]
        raise Wrong(
            f"this does not agree with the neighbouring motions: the one that starts {side}, at r "
            f"= {start:g}, moves {movement} the cycle"
        )
    return (
        f"motions inside move {'towards' if inside == 'to' else 'away from'} it, "
        f"motions outside {'towards' if outside == 'to' else 'away from'} it"
    )


@judged(Expression("parameters"))
def cycle_period(claim, radial, angular, radius, parameters):
    """Check the period of the closed orbit of r' = R(r), phi' = W(r).

    In one period the angle grows by 2 pi at the rate W.

    Can decide when the rates depend on the radius alone and there is one closed orbit; with
    parameters at sample values.

    Examples
    --------
    >>> r = sp.Symbol("r", positive=True)
    >>> checks.cycle_period(sp.pi, r*(1 - r**2), 1 + r, r, []).status
    'right'
    >>> checks.cycle_period(2*sp.pi, r*(1 - r**2), 1 + r, r, []).status
    'wrong'
    """
    family = equilibria_of([radial], [radius], parameters, _positive_domain(radius))
    angular_rate = equilibria_of([angular], [radius], parameters, _positive_domain(radius))
    for values, numbers, equilibrium in family.samples(claim):
        period = real_at(claim, values)
        if period is None:
            raise Wrong(
                f"{sample_text(values)}there is a closed orbit, but your expression gives no "
                "real number"
            )
        rate = float(angular_rate(equilibrium, numbers)[0])
        if period <= 0 or not agree(
            rate * period,
            math.copysign(2 * math.pi, rate),
            claim,
            uncertain=abs(rate) * uncertainty_at(claim, values),
        ):
            raise Wrong(
                f"{sample_text(values)}the angle does not gain just one turn within your time "
                f"{period:.4g}"
            )
    return "in this time the angle gains one full turn on the closed orbit"


def _positive_domain(radius):
    return {radius: sp.Interval.open(0, sp.oo)}


@judged(Number())
def return_map_slope(claim, field, state, radius=None):
    """Check the slope of the return map r -> P(r) at a limit cycle.

    One turn multiplies a small deviation by this number.

    Judged by Liouville's formula: in the plane it is exp of the integral of the divergence over
    one turn.

    Can decide when the cycle is a circle about zero.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> size = x**2 + y**2 - 1
    >>> checks.return_map_slope(sp.exp(-4*sp.pi), [y - x*size, -x - y*size], [x, y]).status
    'right'
    >>> checks.return_map_slope(1, [y - x*size, -x - y*size], [x, y]).status
    'wrong'
    """
    flow = cached_field(tuple(field), tuple(state))
    radius = _circle(flow, radius)
    exponent = 0.0
    # the trapezoidal rule is exact here for trigonometric polynomials below degree 24
    for phi in ANGLES:
        x = _cartesian(radius, phi)
        exponent += (
            np.trace(flow.jacobian(x))
            / abs(_polar_velocity(flow, radius, phi)[1])
            * 2
            * math.pi
            / len(ANGLES)
        )
    if abs(exponent) < 1e-10:
        exponent = 0.0
    slope = math.exp(exponent)
    # A large slope may be rounded to a whole number.
    if not agree(float(claim), slope, claim) and not (claim.is_Integer and rounds_to(claim, slope)):
        if float(claim) <= 0:
            raise Wrong(
                "the slope is positive: a motion that starts outside the cycle stays outside, for "
                "motions do not cross"
            )
        if rounds_to(claim, slope) and not in_decimals(claim):
            raise Wrong(
                "the expression agrees with the slope to three digits only; it is written exactly, "
                "and is not equal to it"
            )
        raise Wrong(
            f"one turn does not multiply a small deviation by {float(claim):.4g}: linearise r' at "
            "the cycle, and let the deviation grow for one turn"
        )
    return "it agrees with the integral of the divergence over one turn (Liouville's formula)"


def _cartesian(r, phi):
    return r * np.array([math.cos(phi), math.sin(phi)])


def _polar_velocity(flow, r, phi):
    """Return (r', phi') of the motion at a point, from its velocity in the plane."""
    x = _cartesian(r, phi)
    velocity = flow(x)
    return x @ velocity / r, (x[0] * velocity[1] - x[1] * velocity[0]) / r**2


@functools.lru_cache(maxsize=16)
def _circles(flow):
    """Return the radii below 20 of the circles around zero that are closed orbits.

    r' is computed along a ray on a fine grid: a cycle is a zero of r' or, where r' keeps its sign,
    of its derivative.
    """
    phi = ANGLES[0]
    unit = _cartesian(1.0, phi)

    def rate(r):
        return _polar_velocity(flow, r, phi)[0]

    def growth(r):
        return unit @ flow.derivative(r * unit, unit)

    grid = np.geomspace(0.013, 20.0, 400)
    if max(abs(rate(r)) / r for r in grid) < 1e-12:
        raise UnsuitableData(
            "field: all circles around zero are closed orbits, and none of them is a limit cycle"
        )
    candidates = _zeros(rate, grid) + _zeros(growth, grid)
    radii = []
    for radius in sorted(candidates):
        velocities = [_polar_velocity(flow, radius, angle) for angle in ANGLES]
        closed = max(abs(v[0]) for v in velocities) < 1e-9 * radius * max(
            abs(v[1]) for v in velocities
        )
        rotating = min(abs(v[1]) for v in velocities) > 1e-9
        if closed and rotating and not any(abs(radius - other) < 1e-5 * radius for other in radii):
            radii.append(float(radius))
    return radii


def _zeros(function, grid):
    """Return the zeros of a function at its changes of sign, by bisection."""
    values = [function(r) for r in grid]
    zeros = [r for r, value in zip(grid, values) if value == 0]
    for low, high, low_value, high_value in zip(grid, grid[1:], values, values[1:]):
        if low_value * high_value < 0:
            for _ in range(60):
                middle = (low + high) / 2
                low, high = (middle, high) if function(middle) * low_value > 0 else (low, middle)
            zeros.append((low + high) / 2)
    return zeros


def _circle(flow, radius):
    """Return the closed circular orbit of the given radius, or the only one."""
    circles = [c for c in _circles(flow) if radius is None or abs(c - float(radius)) < 1e-6 * c]
    if len(circles) != 1:
        raise UnsuitableData(f"field: expected one circular limit cycle, found {len(circles)}")
    return circles[0]


@functools.lru_cache(maxsize=16)
def _tendency(flow, radius, side):
    """Return "to" or "from": whether motions on one side approach the cycle or leave it."""
    start = radius * (1 + 0.05 * side)
    end = flow.motion([start, 0.0], 60.0, escape=10 * radius)
    if end is None:
        return "from"
    ratio = abs(np.linalg.norm(end) - radius) / abs(start - radius)
    if 0.7 < ratio < 1.4:
        raise RuntimeError(
            "neighbouring motions keep their distance: this is no limit cycle, or a very slow one"
        )
    return "to" if ratio < 1 else "from"


def _lifetime(flow, r0):
    """Return how long a motion stays bounded, at most 2."""
    duration = 2.0
    for _ in range(12):
        if flow.motion([r0, 0.0], duration, escape=100.0) is not None:
            return duration
        duration /= 1.6
    raise RuntimeError("the motion leaves every bound at once")

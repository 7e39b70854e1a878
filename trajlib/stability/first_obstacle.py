"""The level at which a growing component of {V < c} meets its first obstacle.

Which obstacle is met first is a question of order and connection: it is decided by descending from
each along -grad V, for three sample values of the parameters.
"""

import numpy as np
import sympy as sp

from trajlib.stability.lyapunov import is_positive_definite, separate_parts


def first_level(V, obstacles, state):
    """Return the level of the first obstacle, the obstacles there, and the reason."""
    parameters = sorted(
        V.free_symbols.union(*(v.free_symbols for p, _ in obstacles for v in p)) - set(state),
        key=str,
    )
    levels = [_height(V.subs(dict(zip(state, p)), simultaneous=True)) for p, _ in obstacles]
    verdicts = set()
    for sample in _samples(parameters):
        obstacles_met = _first_met(
            V.subs(sample),
            state,
            [_numbers(p, sample) for p, _ in obstacles],
            [float(level.subs(sample)) for level in levels],
        )
        verdicts.add(obstacles_met)
    if len(verdicts) > 1:
        raise ValueError(
            "V: which obstacle comes first depends on the parameters; substitute numbers"
        )
    (obstacles_met,) = verdicts
    level = levels[obstacles_met[0]] if obstacles_met else sp.oo
    doubts = {
        _bounded(V.subs(sample), state, level.subs(sample)) for sample in _samples(parameters)
    } - {""}
    if not obstacles_met:
        if doubts:
            raise ValueError(
                "V: no obstacle is met, but V is not known to grow without bound in all directions"
            )
        return level, (), "V grows without bound and meets no obstacle: attraction from everywhere"
    reason = "; ".join(
        f"at {tuple(map(short, obstacles[i][0]))}: {obstacles[i][1]}" for i in obstacles_met
    )
    return (
        level,
        tuple(obstacles[i][0] for i in obstacles_met),
        reason + "".join(f"; {d}" for d in doubts),
    )


def short(value):
    """Return roots of polynomials as decimals."""
    return value.evalf(6) if value.has(sp.CRootOf) else value


def _height(level):
    return level if level.has(sp.CRootOf) else sp.factor(sp.simplify(level))


def _numbers(point, sample):
    return np.array([float(v.subs(sample)) for v in point])


def _samples(parameters):
    """Return three sets of values that respect the assumptions on the parameters."""
    if not parameters:
        return [{}]
    values = [
        (
            sp.Rational(1),
            sp.Rational(3, 2),
            sp.Rational(2, 3),
            sp.Rational(5, 4),
            sp.Rational(4, 5),
        ),
        (
            sp.Rational(1, 3),
            sp.Rational(7, 3),
            sp.Rational(1, 2),
            sp.Rational(3),
            sp.Rational(9, 7),
        ),
        (
            sp.Rational(5, 2),
            sp.Rational(1, 5),
            sp.Rational(8, 3),
            sp.Rational(1, 4),
            sp.Rational(6, 5),
        ),
    ]
    return [
        {p: -row[i % 5] if p.is_negative else row[i % 5] for i, p in enumerate(parameters)}
        for row in values
    ]


def _first_met(V, state, points, levels):
    """Return the indices of the obstacles that the growing component meets first."""
    order = sorted((i for i in range(len(points)) if levels[i] > 1e-12), key=lambda i: levels[i])
    descend = _descent(V, state)
    for i in order:
        if descend(points[i]):
            return tuple(
                j
                for j in order
                if abs(levels[j] - levels[i]) <= 1e-9 * levels[i] and (j == i or descend(points[j]))
            )
    return ()


def _descent(V, state):
    """Return a test whether {V < V(p)} joins p to the origin, by descent from near p."""
    from scipy.integrate import solve_ivp

    value = sp.lambdify(state, V, "numpy")
    gradient = sp.lambdify(state, [sp.diff(V, x) for x in state], "numpy")
    directions = np.random.default_rng(0).normal(size=(24, len(state)))
    directions = np.vstack([np.eye(len(state)), -np.eye(len(state)), directions])

    def reaches_origin(point):
        size = np.linalg.norm(point)
        height = value(*point)
        for direction in directions:
            start = point + 1e-3 * size * direction / np.linalg.norm(direction)
            if value(*start) >= height:
                continue

            def down(_, x):
                return -np.asarray(gradient(*x), dtype=float) * size**2 / abs(height)

            def arrived(_, x):
                return np.linalg.norm(x) - 1e-2 * size

            def diverged(_, x):
                return np.linalg.norm(x) - 50 * size

            arrived.terminal = diverged.terminal = True
            # LSODA rests cheaply where the descent ends in another minimum.
            end = solve_ivp(
                down,
                (0, 1e5),
                start,
                "LSODA",
                events=(arrived, diverged),
                rtol=1e-6,
                atol=1e-9 * size,
            ).t_events
            if end[0].size:
                return True
        return False

    return reaches_origin


def _bounded(V, state, level):
    """Return "" if the component of {V < level} is known to be bounded, else a remark."""
    for part, variables in separate_parts(V, state):
        if _grows(part, variables):
            continue
        if len(variables) > 1 or level == sp.oo or not _walled(part, variables[0], float(level)):
            return "that the component is bounded was not shown"
    return ""


def _grows(part, variables):
    """Whether a part of V tends to +oo in all directions, by its terms of highest degree."""
    if not part.is_polynomial(*variables):
        return False
    poly = sp.Poly(part, *variables)
    degree = poly.total_degree()
    top = sum(
        c * sp.prod(x**k for x, k in zip(variables, m)) for m, c in poly.terms() if sum(m) == degree
    )
    return degree % 2 == 0 and is_positive_definite(top, variables).condition is sp.true


def _walled(part, x, level):
    """Whether part(x) rises to the level on both sides, without falling below 0 before."""
    profile = sp.lambdify(x, part, "numpy")
    for side in (1, -1):
        steps = side * np.linspace(0, 100 * (1 + abs(level)), 400001)
        values = profile(steps) * np.ones_like(steps)
        # The level may be touched between two grid points.
        crossed = np.flatnonzero(values >= level * (1 - 1e-6))
        if not crossed.size or values[: crossed[0]].min() < -1e-12 * level:
            return False
    return True

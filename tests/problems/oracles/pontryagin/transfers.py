"""Oracles of fastest and slowest transfers."""

import numpy as np

from oracles.sameness import compiled, same_value


def same_transfer(mutant, reference, *_):
    """True if two functions of time and parameters agree at random values: at single instants, of
    switchings, they may differ."""
    if isinstance(mutant, (list, tuple)) or isinstance(reference, (list, tuple)):
        return same_value(mutant, reference)
    random, symbols = (
        np.random.default_rng(29),
        tuple(sorted(mutant.free_symbols | reference.free_symbols, key=str)),
    )
    functions = [compiled(symbols, e) for e in (mutant, reference)]
    for _ in range(60):
        values = [
            int(random.integers(1, 9))
            if s.is_integer
            else random.uniform(0.05, 4) * (1 if s.is_positive else random.choice((-1, 1)))
            for s in symbols
        ]
        with np.errstate(all="ignore"):
            one, other = (complex(function(*values)) for function in functions)
        if not (
            np.isclose(one, other, rtol=1e-9, atol=1e-9) or (np.isnan(one) and np.isnan(other))
        ):
            return False
    return True


def same_count(mutant, reference, problem, parameters=()):
    """As `same_transfer` for an expression in parameters; without them the count is a number."""
    compare = same_transfer if parameters else same_value
    return compare(mutant, reference)


ORACLES = dict.fromkeys(
    (
        "optimal_switching",
        "meeting_time",
        "isochrone_radius",
        "least_rate",
        "polar_angle_rate",
    ),
    same_transfer,
) | {"switching_count": same_count}

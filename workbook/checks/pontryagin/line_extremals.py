"""Extremals to a line besides the fastest one: where they exist, and their time.

The data are those of `syntheses`.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.pontryagin.closed_loop import Law
from workbook.checks.pontryagin.synthesis_units import in_natural_units, time_unit
from workbook.checks.references.optima import reach
from workbook.checks.references.optima.sampled_optimum import sampled_optimum, synthesis_data
from workbook.checks.references.optima.state_batch import StateBatch
from workbook.checks.tools.conditions import Case, ReferenceCondition, compare
from workbook.checks.tools.line_search import bisect
from workbook.checks.tools.values import left_open
from workbook.checks.tools.wording import value_text, values_text


@judged
@in_natural_units()
def other_extremal_exists(answer, system, target, start=None):
    """Check the condition on the initial state for an extremal that is not the fastest one.

    The extremal leads to the line, which it may cross before.

    Can decide when the system is linear in two states and the target is a line; for all initial
    states where the condition is polynomial.

    Examples
    --------
    >>> from workbook.systems import Controlled
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> cart = Controlled({x: v, v: u}, {u: (-1, 1)})
    >>> checks.other_extremal_exists(False, cart, [v]).status
    'right'
    >>> checks.other_extremal_exists(True, cart, [v]).status
    'wrong'
    """
    reference = _second_extremal(system, target, start)
    agreement = compare(
        answer,
        system.state,
        reference,
        lambda point, holds: (
            f"from {values_text(point)} there is {'another' if holds else 'no other'} extremal "
            "besides the fastest one"
        ),
    )
    return f"there is another extremal from these initial states and from no others: {agreement}"


def _second_extremal(system, target, start):
    """Return the condition on initial states off the line that have two extremals.

    It is decided exactly if the controls on the extremals do not switch, else at samples.
    """
    state, control, bounds = system.state, system.control, system.bounds
    line, zero = sp.sympify(target[0]), dict.fromkeys([*state, control], 0)
    plant = sp.Matrix([sp.sympify(f) for f in system.field])
    first, second = (sp.Dummy(name, real=True) for name in ("T1", "T2"))
    beyond = None
    if not any(plant.subs(zero)):
        parts = plant.jacobian(state), plant.diff(control), list(map(sp.sympify, bounds))
        beyond = reach.beyond_line(*parts, state, line, first)
    if beyond is None:
        batch, second_times = _line_extremals(
            sampled_optimum(*synthesis_data(system, target, {}, start))
        )
        has_second = {
            tuple(map(sp.Rational, x)): np.isfinite(T) for x, T in zip(batch.x, second_times)
        }
        return ReferenceCondition(
            at=lambda point: has_second[tuple(point.values())],
            points=lambda: (dict(zip(state, x)) for x in has_second),
        )

    def ends(time, steepness):
        """Return the condition that an extremal ends at a time, where it crosses the line.

        If it only touches the line there, either answer is accepted.
        """
        return sp.Or(
            *(
                sp.And(sp.Eq(F.subs(first, time), 0), steepness(F.diff(first).subs(first, time), 0))
                for F in beyond
            )
        )

    def two_ends(steepness):
        return sp.And(0 < first, first < second, ends(first, steepness), ends(second, steepness))

    off_line = sp.And(sp.Ne(line, 0), sp.true if start is None else start)

    def at(point):
        times = {T for F in beyond for T in sp.Poly(F.subs(point), first).real_roots() if T > 0}
        crossed, touched = (
            sum(bool(ends(T, steepness).subs(point)) for T in times) >= 2
            for steepness in (sp.Gt, sp.Ge)
        )
        return crossed if crossed == touched else None

    return ReferenceCondition(
        (Case(sp.And(off_line, two_ends(sp.Gt)), (first, second)),),
        (Case(sp.And(off_line, sp.Not(two_ends(sp.Ge))), (first, second), every=True),),
        at,
    )


@judged(Expression("system.state"))
@in_natural_units(time_unit)
def other_extremal_time(claim, system, target, start=None):
    """Check the time that the extremal of `other_extremal_exists` takes, where there is one."""
    reference = sampled_optimum(*synthesis_data(system, target, {}, start))
    batch, second_times = _line_extremals(reference)
    claimed = Law(claim, reference)(batch.x, batch.case)
    uncertainty = left_open([claim], lambda parts: Law(*parts, reference)(batch.x, batch.case))
    for k in np.flatnonzero(
        np.isfinite(second_times)
        & ~(abs(claimed - second_times) <= 1e-6 * second_times + uncertainty)
    ):
        point = ", ".join(f"{s} = {v:.4g}" for s, v in zip(system.state, batch.x[k]))
        raise Wrong(
            f"from {point} your expression gives {value_text(claimed[k])}, which is not the time of an extremal "
            "slower than the fastest one"
        )
    return "it is the time of the slower extremal, from all sample initial states that have one"


def _line_extremals(reference):
    """Return initial states, and the times of their second fastest extremals to a line.

    The time is inf where there is none.

    The costate at the end is p = +-c for the line c.y + d = 0, so F(T) = max p.y over R(T) decides:
    an extremal ends at T if F reaches the line there and increases, since its rate is the
    Hamiltonian; the first one is the fastest. Initial states close to a border of their set are
    left out.
    """
    if "extremals" in reference.cache:
        return reference.cache["extremals"]
    plant, (points, case) = reference.plant, reference._points(1000, seed=7)
    c, d = reference.convex._c[0], reference.convex._d[0]
    times = 60 * (np.arange(0, 1501) / 1500) ** 1.5
    transitions = plant.exponential(times)
    point_indices, crossing_times, doubtful = [], [], np.zeros(len(points), dtype=bool)
    for p, level in ((c, -d), (-c, d)):

        def support_gap(T, x, p=p, level=level):
            rows = np.tile(p, (len(T), 1))
            return (
                np.einsum("i,nij,nj->n", p, plant.exponential(T), x)
                + plant.extreme(rows, T, np.ones(len(T)))
                - level
            )

        reach = plant.extreme(np.tile(p, (len(times), 1)), times, np.ones(len(times)))
        F = np.einsum("i,tij,nj->nt", p, transitions, points) + reach - level
        n, j = np.nonzero((F[:, :-1] < 0) & (F[:, 1:] >= 0))
        low, high = bisect(
            lambda T, k, n=n: support_gap(T, points[n[k]]) < 0, times[j], times[j + 1], 45
        )
        point_indices.append(n)
        crossing_times.append((low + high) / 2)
        turning = (F[:, 1:-1] < F[:, :-2]) & (F[:, 1:-1] < F[:, 2:]) | (F[:, 1:-1] > F[:, :-2]) & (
            F[:, 1:-1] > F[:, 2:]
        )
        doubtful |= (
            turning & (abs(F[:, 1:-1]) < 0.004 * (0.3 + np.linalg.norm(points, axis=1))[:, None])
        ).any(axis=1)
    ends = np.full(
        (len(points), 1 + max(np.bincount(np.concatenate(point_indices)), default=0)), np.inf
    )
    rows, column = np.concatenate(point_indices), np.zeros(len(points), dtype=int)
    for n, T in zip(rows, np.concatenate(crossing_times)):
        ends[n, column[n]], column[n] = T, column[n] + 1
    ends = np.sort(ends, axis=1)
    first = ends[:, 0].copy()
    ends[ends <= first[:, None] * (1 + 1e-6) + 1e-6] = np.inf
    keep = ~doubtful & np.isfinite(first) & (first > 0.02)
    reference.cache["extremals"] = (
        StateBatch(x=points, case=case, time=first).take(keep),
        ends.min(axis=1)[keep],
    )
    return reference.cache["extremals"]

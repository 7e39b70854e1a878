"""Points of singular arcs, as numbers: states and costates at which H does not depend on a control.

The problem is a `pontryagin.Problem`, of which the statement alone is used, with lambda_0 = 1. For
a control u that enters H linearly, S = dH/du and its derivatives along the trajectories vanish on a
singular arc, up to the order 2q of the first that contains u, and H does if the duration is free.
The other controls make H greatest. Where all of this holds with no costate but zero, it is not a
singular arc.
"""

import copy
import functools
import itertools

import numpy as np
import sympy as sp

from workbook.checks.references.optima.units import in_units, sample_units
from workbook.checks.tools.domains import random_value, scaled_interval
from workbook.checks.tools.numeric_functions import multiprecision_function, real_function
from workbook.checks.tools.samples import cached_points

#: From so many points the search for points begins, and so many points are enough.
STARTS, ENOUGH = 160, 8
#: Newton's steps, the last of them relative to the point, and what is left of the equations at a
#: point, as a share of their terms.
STEPS, LAST_STEP, SOLVED = 40, 1e-9, 1e-11
#: What counts as zero in the derivative of dH/du that holds the control.
VANISHES = 1e-6


def hamiltonian(problem, costates):
    """Return H with lambda_0 = 1."""
    sign = -1 if problem.maximise else 1
    return (
        sum((psi * f for psi, f in zip(costates, problem.field)), sp.S.Zero)
        - sign * problem.running
    )


def known_costates(problem, costates):
    """Return {costate: value} for costates that are constant and given by the final cost.

    Their states enter neither the equations nor the target, and the final cost linearly.
    """
    sign = -1 if problem.maximise else 1
    entered = set().union(
        *(e.free_symbols for e in (*problem.field, problem.running, *problem.terminal))
    )
    slopes = {
        psi: -sign * sp.diff(problem.final, y)
        for psi, y in zip(costates, problem.state)
        if y not in entered
    }
    return {
        psi: slope for psi, slope in slopes.items() if not slope.free_symbols & set(problem.state)
    }


@functools.lru_cache(maxsize=32)
def singular_arcs(problem, control, costates):
    """Return the `SingularArcs` of a control; `costates` is a tuple of symbols."""
    return SingularArcs(problem, control, costates, sample_units(problem, costates))


class SingularArcs:
    """The singular arcs of one control.

    `derivatives`: S, S', ... up to the last that does not hold the control; `order`: q, or None if
    none holds it; `highest`: the derivative of order 2q, or None.
    """

    def __init__(self, problem, control, costates, units=None):
        #: The units in which points are computed, and the arcs of the problem in these units.
        self.units = units
        self._scaled = None
        if any(unit != 1 for unit in (units or {}).values()):
            self._scaled = SingularArcs(in_units(problem, units), control, costates)
        self.problem, self.control, self.costates = problem, control, list(costates)
        self.state, self.parameters = list(problem.state), list(problem.parameters)
        self.other_controls = [u for u in problem.control if u != control]
        H = hamiltonian(problem, costates)
        self._flow = dict(problem.dynamics) | {
            psi: -sp.diff(H, y) for psi, y in zip(costates, self.state)
        }
        self._known_costates = known_costates(problem, costates)
        self.derivatives, self.highest = self._derivatives(sp.expand(sp.diff(H, control)))
        self.order = None if self.highest is None else len(self.derivatives) // 2
        equations = list(self.derivatives)
        if problem.duration is None:
            equations.append(H.subs(control, 0))
        self._equations = [
            e for e in (sp.expand(e.subs(self._known_costates)) for e in equations) if e != 0
        ]
        self._unknown = [s for s in (*self.state, *self.costates) if s not in self._known_costates]
        #: Whether the equations leave the size of the costates open, which may be any then, but
        #: not zero.
        self._scalable = (
            bool(self._equations)
            and not any(self._known_costates.values())
            and all(e.subs(dict.fromkeys(self.costates, 0)) == 0 for e in self._equations)
        )
        self._costate = np.array([s in self.costates for s in self._unknown])
        self._symbols = [*self._unknown, *self.parameters, *self.other_controls]
        self._gain = real_function(
            self._symbols, [sp.diff(H, u).subs(self._known_costates) for u in self.other_controls]
        )
        #: The derivative of order 2q without the control, and the factor of the control in it.
        self._last_parts = (
            [sp.S.Zero, sp.S.One]
            if self.highest is None
            else [self.highest.subs(control, 0), sp.diff(self.highest, control)]
        )
        self._evaluate_by(real_function)

    def _evaluate_by(self, kind):
        slopes = [sp.diff(e, s) for e in self._equations for s in self._unknown]
        self._values, self._slopes, self._last = (
            kind(self._symbols, expressions)
            for expressions in (self._equations, slopes, self._last_parts)
        )

    def multiprecision(self):
        """Return the same arcs, with equations that are evaluated in multiprecision numbers."""
        arcs = copy.copy(self)
        arcs._scaled = self._scaled and self._scaled.multiprecision()
        arcs._evaluate_by(multiprecision_function)
        return arcs

    @cached_points
    def points(self, domain=None):
        """Return values {symbol: number} at points of singular arcs, at most `ENOUGH`.

        They are values of states, costates, parameters and other controls; the symbols range over the
        intervals of `domain`, or what their assumptions allow.
        """
        if self._scaled is not None:
            domain = {
                s: scaled_interval(i, 1 / self.units.get(s, 1)) for s, i in (domain or {}).items()
            }
            return [
                {s: float(self.units.get(s, 1)) * number for s, number in values.items()}
                for values in self._scaled.points(domain)
            ]
        random, samples = np.random.default_rng(17), []
        for k in range(STARTS):
            values = {p: random_value(random, p, domain) for p in self.parameters}
            ends = [
                tuple(
                    None if b.is_finite is False else float(b.subs(values))
                    for b in self.problem.controls[u]
                )
                for u in self.other_controls
            ]
            start = [random_value(random, s, domain) for s in self._unknown]
            # Neither bound of the other controls always comes first.
            for bound_values in list(itertools.product(*ends))[:: (-1) ** k]:
                point = (
                    self._closest_solution(start, [*values.values(), *bound_values])
                    if None not in bound_values
                    else None
                )
                if point is None or not self._inside(point, domain):
                    continue
                gains = self._gain(*point, *values.values(), *bound_values)
                remainder, factor = self._last(*point, *values.values(), *bound_values)
                if abs(factor) <= VANISHES * (1 + abs(remainder)) and abs(remainder) > VANISHES:
                    continue  # no control keeps S at zero here
                if all(
                    (gain >= -1e-9) == (u == high)
                    for gain, u, (_, high) in zip(gains, bound_values, ends)
                ):
                    values |= dict(zip(self._unknown, point)) | dict(
                        zip(self.other_controls, bound_values)
                    )
                    samples.append(
                        values | {s: float(e.subs(values)) for s, e in self._known_costates.items()}
                    )
                    break
            if len(samples) == ENOUGH:
                break
        return samples

    def multipliers_exist(self, values, share):
        """Return whether costates exist with which a state is a point of a singular arc.

        `values` holds all symbols but these. None if the equations are not defined there.
        """
        if self._scaled is not None:
            scaled = {s: number / float(self.units.get(s, 1)) for s, number in values.items()}
            return self._scaled.multipliers_exist(scaled, share)
        unknown_costates = [s for s in self._unknown if s in self.costates]
        at = np.flatnonzero(self._costate)
        bounds = (self.problem.controls[u] for u in self.other_controls)
        ends = ([float(b.subs(values)) for b in pair] for pair in bounds)
        for bound_values in itertools.product(*ends):
            point = [0.0 if s in unknown_costates else values[s] for s in self._unknown]
            fixed_values = [*(values[p] for p in self.parameters), *bound_values]
            constant = self._values(*point, *fixed_values)
            slopes = self._slopes(*point, *fixed_values).reshape(len(constant), -1)
            matrix = slopes[:, at]
            # An equation between states alone, or nearly, is as large as it may become next to the
            # point.
            general = self._slopes(
                *(1.0 if s in unknown_costates else values[s] for s in self._unknown), *fixed_values
            )
            size = np.abs(general.reshape(slopes.shape)).max(axis=1) + np.abs(constant)
            if not np.isfinite([*size, *constant]).all():
                return None
            matrix, constant = matrix / size[:, None], constant / size

            def last(costates, point=point, fixed_values=fixed_values):
                full = np.array(point, dtype=float)
                full[at] = costates
                return self._last(*full, *fixed_values)

            solvable = _solvable_with_unit_costates if self._scalable else _solvable_with_control
            if solvable(matrix, constant, last, share):
                return True
        return False

    def _derivatives(self, first):
        derivatives = [first]
        for _ in range(2 * len(self.state)):
            terms = (sp.diff(derivatives[-1], s) * rate for s, rate in self._flow.items())
            following = sp.expand(sum(terms, sp.S.Zero))
            entered = sp.simplify(sp.diff(following, self.control).subs(self._known_costates)) != 0
            if entered and len(derivatives) % 2 == 0:
                return derivatives, following.subs(self._known_costates)
            derivatives.append(following.subs(self.control, 0))
        return derivatives, None

    def _closest_solution(self, start, fixed_values):
        """Return the point near a start where the equations hold, by steps of least length, or None."""
        point = np.array(start, dtype=float)
        for _ in range(STEPS):
            residual = self._values(*point, *fixed_values)
            slopes = self._slopes(*point, *fixed_values).reshape(len(residual), -1)
            if self._scalable:
                costates = np.where(self._costate, point, 0.0)
                residual = np.append(residual, costates @ costates - 1)
                slopes = np.vstack([slopes, 2 * costates])
            if not (np.isfinite(residual).all() and np.isfinite(slopes).all()):
                return None
            step = np.linalg.lstsq(slopes, residual, rcond=1e-12)[0]
            # Where surfaces touch, the equations nearly hold far from their common points.
            if np.linalg.norm(step) <= LAST_STEP * (1 + np.linalg.norm(point)) and np.all(
                np.abs(residual) <= SOLVED * (np.abs(slopes) @ (1 + np.abs(point)))
            ):
                return point
            point = point - step
        return None

    def _inside(self, point, domain):
        """Return whether the states lie in the domain; the point must not be the limit of an escape."""
        for s, value in zip(self._unknown, point):
            interval = (domain or {}).get(s)
            if interval is not None and not float(interval.inf) < value < float(interval.sup):
                return False
            if (s.is_positive and value <= 1e-9) or (s.is_negative and value >= -1e-9):
                return False
        return bool(np.abs(point).max(initial=0) < 1e3)


def _solvable_with_unit_costates(matrix, _, last, share):
    """Return whether costates of length 1 solve the equations and a control keeps S at zero.

    `last(costates)` are the two parts of the derivative of order 2q.
    """
    costates = np.linalg.svd(matrix)[2][-1]
    remainder, factor = last(costates)
    return bool(
        np.all(np.abs(matrix @ costates) <= share * (np.abs(matrix) @ np.abs(costates)))
        and (abs(factor) > share * (1 + abs(remainder)) or abs(remainder) <= share)
    )


def _solvable_with_control(matrix, constant, last, share):
    """Return whether for some costates that satisfy the equations a control keeps S at zero."""
    solution, count = _least_squares(matrix, -constant), matrix.shape[1]
    residual = np.abs(matrix @ solution + constant)
    if not np.all(residual <= share * (1 + np.abs(matrix) @ np.abs(solution))):
        return False
    zero = last(np.zeros(count))
    slopes = np.array([last(row) - zero for row in np.eye(count)]).reshape(count, 2)
    _, sizes, basis = np.linalg.svd(matrix)
    free = basis[int((sizes > 1e-9 * max(sizes.max(initial=0), 1e-300)).sum()) :]
    remainder, factor = zero + solution @ slopes
    # Each of the two has units of its own: it is compared with its terms, for costates that
    # contribute alike to the equations, or of size one where all of them are zero.
    columns = _column_sizes(matrix)
    alike = np.linalg.norm(solution * columns) / columns
    costate_sizes = alike if np.abs(constant).max() > share else np.ones(len(alike))
    terms = np.abs(zero) + costate_sizes @ np.abs(slopes)
    changes, largest = (np.abs(part).max(axis=0, initial=0) for part in (free @ slopes, slopes))
    changes_with_costates = changes > share * largest
    if abs(factor) > share * terms[1] or changes_with_costates[1]:
        return True
    return abs(remainder) <= share * terms[0] or changes_with_costates[0]


def _least_squares(matrix, right):
    """Return the least squares solution; unknowns of other sizes are brought to one."""
    sizes = _column_sizes(matrix)
    return np.linalg.lstsq(matrix / sizes, right, rcond=1e-9)[0] / sizes


def _column_sizes(matrix):
    sizes = np.linalg.norm(matrix, axis=0)
    return np.where(sizes > 0, sizes, 1)

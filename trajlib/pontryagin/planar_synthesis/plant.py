"""The right-hand sides of extremals in the plane, for controls that H determines one by one.

For x' = f(x, u), the least int f_0(x, u) dt and lambda_0 >= 0, the controls enter

    H = psi^T f - lambda_0 f_0 = ... + sum_j [ (psi^T f_j - lambda_0 g_j) u_j - lambda_0 (k_j |u_j| + r_j u_j^2/2) ]

each by itself, if f is linear in them and f_0 has no products of two. So u_j is a function of one
number, its switching function, with the levels u_-, between, 0, between, u_+, as far as they occur;
a surface e = 0 in the space of (x, psi, lambda_0) separates each from the next (`control_terms`). A
*mode* is one level for every control.

A point of an extremal is a column z = (x1, x2, psi1, psi2, lambda_0, cost, held): the cost from
there to the target, and `held` the value of a control that the maximum condition leaves open for
good.
"""

from itertools import product

import numpy as np
import sympy as sp

from trajlib.pontryagin.planar_synthesis.array_functions import array_function
from trajlib.pontryagin.planar_synthesis.control_sequences import ControlSequences
from trajlib.pontryagin.planar_synthesis.integration import (
    SERIES_NORM,
    extrapolated_step,
    series_step,
    steps_needed,
)

ROWS = 7
COST, HELD = 5, 6


class Plant:
    """The numeric right-hand sides; points z are arrays of shape (7, N), modes of shape (N,)."""

    def __init__(self, problem, terms):
        """Compile the functions of a problem; `terms`: a `ControlTerm` for each control."""
        self.terms = terms
        #: Whether the cost is the time.
        self.counts_time = problem.time_optimal and not problem.maximise
        self.controls = problem.control
        sign = -1 if problem.maximise else 1
        x = sp.Matrix(problem.state)
        psi, lambda_0 = sp.Matrix(sp.symbols("psi_1:3")), sp.Symbol("lambda_0")
        f, cost = sp.Matrix(problem.field), sign * problem.running
        motion, u = [*problem.state, *psi, lambda_0], list(self.controls)
        # dz/dtau in full: lambda_0 and a held control do not change.
        rates = sp.Matrix(
            [
                *(-f),
                *(f.jacobian(x).T * psi - lambda_0 * sp.Matrix([cost]).jacobian(x).T),
                sp.Integer(0),
                cost,
                sp.Integer(0),
            ]
        )
        self._rate = array_function([*motion, *u], rates)
        slope = rates.jacobian(motion)
        #: d(dz/dtau)/dz where it is the same everywhere, as for linear plants with the time or the
        #: fuel as the cost.
        self._matrix = (
            None if slope.free_symbols else np.array(slope.row_join(sp.zeros(ROWS, 2)), dtype=float)
        )
        self._growth = None if self._matrix is None else np.linalg.norm(self._matrix, 1)
        self._levels = [term.levels for term in terms]
        surfaces = [
            (j, e, size) for j, term in enumerate(terms) for e, size in term.surfaces(psi, lambda_0)
        ]
        self._owner = np.array([j for j, _, _ in surfaces], int)
        self._surfaces = array_function(motion, [e for _, e, _ in surfaces])
        self._sizes = array_function(motion, [size for _, _, size in surfaces])
        slopes = [
            sp.Matrix([e]).jacobian(x) * f
            + sp.Matrix([e]).jacobian(psi)
            * (lambda_0 * sp.Matrix([cost]).jacobian(x).T - f.jacobian(x).T * psi)
            for _, e, _ in surfaces
        ]
        self._slopes = array_function([*motion, *u], [sp.expand(s[0]) for s in slopes])
        self._between = [
            {i: array_function(motion, [value]) for i, value in term.between(psi, lambda_0).items()}
            for term in terms
        ]
        self._tabulate()
        self.sequences = ControlSequences(len(self.modes))
        #: det(F, F_j, [F, F_j]) of the fields with the cost as a third state: extremals can be
        #: singular only where one of them vanishes.
        self.singular = [d for j, term in enumerate(terms) for d in term.singular]
        self.singular_at = array_function(problem.state, self.singular or [sp.Integer(1)])

    def _tabulate(self):
        """Tabulate the modes, the signs that each requires, and the modes beyond the surfaces."""
        self.modes = list(product(*(range(len(levels)) for levels in self._levels)))
        number = {mode: m for m, mode in enumerate(self.modes)}
        self._value = np.array(
            [
                [
                    np.nan if levels[i].value is None else levels[i].value
                    for levels, i in zip(self._levels, mode)
                ]
                for mode in self.modes
            ]
        )
        self._plain = ~np.isnan(self._value).any(axis=1)
        count = self._owner.size
        self.required_sign, self.next_mode = (
            np.zeros((len(self.modes), count), int),
            np.full((len(self.modes), count), -1),
        )
        self.crossing = np.full((len(self.modes), len(self.modes)), -1)
        for m, mode in enumerate(self.modes):
            for s, j in enumerate(self._owner):
                if self._levels[j][mode[j]].name == "open":
                    continue
                # of this surface among those of the control
                rank = s - int(np.argmax(self._owner == j))
                self.required_sign[m, s] = 1 if mode[j] > rank else -1
                step = 1 if self.required_sign[m, s] < 0 else -1
                neighbour = number[(*mode[:j], mode[j] + step, *mode[j + 1 :])]
                self.next_mode[m, s] = neighbour
                if mode[j] == rank + (step < 0):
                    self.crossing[m, neighbour] = s

    def name(self, mode):
        """Return the names of the levels of a mode: a string for one control, a tuple for several."""
        names = tuple(levels[i].name for levels, i in zip(self._levels, self.modes[mode]))
        return names[0] if len(names) == 1 else names

    def open_mode(self, mode, j):
        """Return the mode in which control j is held at a value of its own."""
        levels = (*self.modes[mode][:j], len(self._levels[j]) - 1, *self.modes[mode][j + 1 :])
        return self.modes.index(levels)

    def owner(self, surface):
        """Return the number of the control whose levels a surface separates."""
        return int(self._owner[surface])

    @property
    def has_interior(self):
        """Whether a control may lie between its bounds, where psi determines it."""
        return any(level.name == "interior" for levels in self._levels for level in levels)

    def corners(self):
        """Return the combinations of bounds, and of zero where |u| has a cost: shape (number, k)."""
        return np.array(
            list(
                product(
                    *(
                        [level.value for level in levels if level.value is not None]
                        for levels in self._levels
                    )
                )
            )
        )

    def control(self, z, mode):
        """Return the controls, shape (k, N)."""
        return self._filled(z, *self._plan(np.broadcast_to(mode, z.shape[1:])))

    def _plan(self, mode):
        """Return the controls that modes determine, (k, N), and those that depend on z.

        The latter as a list of (control, its level, columns).
        """
        u, moving = self._value[mode].T, []
        if not self._plain[mode].all():
            for m, j in np.argwhere(np.isnan(self._value)):
                columns = np.flatnonzero(mode == m)
                if columns.size:
                    moving.append((j, self.modes[m][j], columns))
        return u, moving

    def _filled(self, z, u, moving):
        """Return the controls with those that depend on z."""
        if not moving:
            return u
        u = u.copy()
        # next to lambda_0 = 0 no level lies between the bounds
        with np.errstate(all="ignore"):
            for j, i, columns in moving:
                held = self._levels[j][i].name == "open"
                u[j, columns] = (
                    z[HELD, columns] if held else self._between[j][i](*z[:5, columns])[0]
                )
        return u

    def rate(self, z, mode):
        """Return dz/dtau backwards in time."""
        return self._rate(*z[:5], *self.control(z, mode))

    def velocity(self, z, mode):
        """Return x', shape (2, N)."""
        return -self._rate(*z[:5], *self.control(z, mode))[:2]

    def costs(self, z, mode):
        """Return f_0 (with the opposite sign for a maximum), shape (N,)."""
        return self._rate(*z[:5], *self.control(z, mode))[COST]

    def at(self, x, u):
        """Return x', (2, N), and f_0, (N,), for given controls."""
        values = self._rate(*x, *np.zeros((3, np.shape(x)[1])), *u)
        return -values[:2], values[COST]

    def surfaces(self, z):
        """Return the functions whose signs determine the levels, shape (S, N)."""
        return self._surfaces(*z[:5])

    def slope(self, z, mode, surface):
        """Return d/dt of one surface for every column."""
        return self._slopes(*z[:5], *self.control(z, mode))[surface, np.arange(z.shape[1])]

    def first_mode(self, z):
        """Return the mode just before the end; -1 where a surface and its derivative vanish."""
        e, size = self.surfaces(z), self._sizes(*z[:5]) + 1e-300
        close = np.abs(e) <= 1e-9 * size
        mode = self._mode(np.where(close, -1.0, e))
        if close.any():
            with np.errstate(all="ignore"):
                before = -self._slopes(*z[:5], *self.control(z, mode))
            length = np.hypot(*z[2:4]) + np.abs(z[4])
            singular = (close & ~(np.abs(before) > 1e-12 * length)).any(axis=0)
            mode = np.where(singular, -1, self._mode(np.where(close, before, e)))
        return mode

    def _mode(self, e):
        """Return the modes for surfaces with these signs."""
        index = np.zeros((len(self.terms), e.shape[1]), int)
        for s, j in enumerate(self._owner):
            index[j] += e[s] > 0
        result = np.zeros(e.shape[1], int)
        for j, levels in enumerate(self._levels):
            result = result * len(levels) + index[j]
        return result

    def maximises(self, z, mode, accuracy):
        """Check which modes satisfy the maximum condition up to a relative accuracy, (N,)."""
        size = np.hypot(*z[2:4]) * (1 + np.hypot(*z[:2])) + np.abs(z[4])
        return (self.surfaces(z) * self.required_sign[mode].T >= -accuracy * size).all(axis=0)

    def step(self, z, mode, h):
        """Return z after a step of length `h` (a number, or one a column) in the same mode."""
        # diverging extremals leave the box
        with np.errstate(over="ignore", invalid="ignore"):
            u, moving = self._plan(mode)
            if self._matrix is not None and not moving:
                return series_step(self._matrix, self._growth, self._rate(*z[:5], *u), z, h)
            return extrapolated_step(
                lambda y: self._rate(*y[:5], *self._filled(y, u, moving)), z, h
            )

    def follow(self, z, mode, times, longest):
        """Return z after `times`, one a column, in the same modes.

        The steps are at most `longest`, unless a series allows longer ones.
        """
        if self._matrix is not None and self._plain[mode].all():
            longest = np.inf if self._growth == 0 else SERIES_NORM / self._growth
        steps = steps_needed(times, longest)
        for _ in range(steps):
            z = self.step(z, mode, times / steps)
        return z

    def advance(self, z, mode, h):
        """Take a step in which the mode changes where a surface is crossed.

        Returns z and mode at its end, and the switchings on the way: (columns, time since the
        beginning of the step, z there, modes before and after).
        """
        h = np.broadcast_to(np.asarray(h, dtype=float), mode.shape)
        gone, switchings = np.zeros(mode.shape), []
        start, mode = z, mode.copy()
        end = self.step(start, mode, h)
        for _ in range(4 * len(self.terms) + 2):
            crossed = self.surfaces(end) * self.required_sign[mode].T < 0
            crossing = np.flatnonzero(crossed.any(axis=0))
            if not crossing.size:
                break
            when, crossing_z, surface = self._earliest(
                start[:, crossing],
                mode[crossing],
                (h - gone)[crossing],
                end[:, crossing],
                crossed[:, crossing],
            )
            start = start.copy()
            start[:, crossing], gone[crossing] = crossing_z, gone[crossing] + when
            old = mode[crossing]
            mode[crossing] = self.next_mode[old, surface]
            switchings.append((crossing, gone[crossing], crossing_z, old, mode[crossing]))
            end = end.copy()
            end[:, crossing] = self.step(crossing_z, mode[crossing], h[crossing] - gone[crossing])
        return end, mode, switchings

    def _earliest(self, z, mode, h, end, crossed):
        """Return when each column first crosses a surface, z there, and which surface it is."""
        when, crossing_z, surface = np.full(h.shape, np.inf), end.copy(), np.zeros(h.shape, int)
        for s in np.flatnonzero(crossed.any(axis=1)):
            candidates = np.flatnonzero(crossed[s])
            first, zero_z = self.first_zero(
                z[:, candidates],
                mode[candidates],
                np.full(candidates.size, s),
                h[candidates],
                end[:, candidates],
            )
            earlier = first < when[candidates]
            candidates = candidates[earlier]
            when[candidates], surface[candidates] = first[earlier], s
            crossing_z[:, candidates] = zero_z[:, earlier]
        return when, crossing_z, surface

    def first_zero(self, z, mode, surface, h, end):
        """Solve surface = 0 in the step by Newton's method, with bisection outside of the bracket.

        It begins at the zero of the inverse cubic interpolation with the values and slopes of both
        ends.
        """
        columns, required_sign = np.arange(h.size), self.required_sign[mode, surface]
        low, high, when, zero_z = np.zeros(h.shape), h.copy(), h, end
        first, value = (self.surfaces(y)[surface, columns] for y in (z, end))
        # derivatives in forward time
        first_slope, slope = (self.slope(y, mode, surface) for y in (z, end))
        # A point that rounding has put beyond the surface, and that moves on beyond it, has crossed
        # it at once.
        high[(required_sign * first <= 0) & (required_sign * first_slope >= 0)] = 0
        with np.errstate(all="ignore"):
            share = first / (first - value)
            new = h * share**2 * (3 - 2 * share) - (value - first) * share * (1 - share) * (
                (1 - share) / first_slope - share / slope
            )
        for _ in range(40):
            bad = ~((new >= low) & (new <= high))
            new[bad] = ((low + high) / 2)[bad]
            done = (np.abs(new - when) < 1e-10 * h).all() or not high.any()
            when = new
            zero_z = self.step(z, mode, when)
            if done:
                break
            value = self.surfaces(zero_z)[surface, columns]
            beyond = required_sign * value < 0
            low, high = np.where(beyond, low, when), np.where(beyond, when, high)
            with np.errstate(all="ignore"):
                new = when + value / self.slope(zero_z, mode, surface)
        return when, zero_z

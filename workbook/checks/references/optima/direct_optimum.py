"""The best process of a problem with any cost, found by direct optimisation: no costate and no
maximum principle.

The states are polynomials on pieces of the duration that satisfy the equations at Radau's points.
First the control is constant on many equal pieces. This is an admissible process, so that no error
of the discretisation makes it look better than any process is, and it shows the arcs: where the
control lies on a bound, vanishes with an absolute value in the cost, or is inside. Then these arcs
get lengths of their own and polynomials as controls, within the bounds between the points too, and
the cost is known to about nine digits. The problem is a `pontryagin.Problem`; only its statement is
used.

A problem whose plant is not linear, whose cost is not convex, or whose duration is free is searched
from several controls, and the best process counts. An answer that does better than it shows that
the search has failed, and is not judged.
"""

import functools
import itertools

import casadi as ca
import numpy as np
import sympy as sp

from workbook.checks.references.optima.transfer_optima import rk4
from workbook.checks.tools.domains import sample_cases

#: Pieces and degree of the first run, and of each arc in the second.
COARSE, FINE = (48, 3), (4, 6)
#: A free duration lies between these.
SHORTEST, LONGEST = 1e-3, 40.0
#: From how many controls a search begins, each constant on so many parts of one of these durations.
STARTS, PARTS, DURATIONS = 6, 6, (3.0, 1.5, 6.0)
#: Where a motion is so many times as fast as usual it has met a pole of the field: then of so many
#: others one counts.
WILD, TRIED = 20, 240
#: Durations that are given first, one after the other, where with a free one no process was found.
FIXED = (8.0, 16.0, 32.0, 4.0)
#: A least cost that was found twice, up to this, is not searched for any longer.
TWICE = 1e-6
#: How close to a bound, as a part of the distance of both, a control lies on it.
ON_BOUND = 2e-4
#: Which part of the duration an arc has to take to be one.
SHORT = 1e-4
#: To what share of the distance of its bounds a control is about zero, and up to what two costs are
#: the same.
QUIET, SAME = 0.05, 1e-9
#: IPOPT's first barriers, each with the most steps: from the higher one it looks farther, from the
#: lower one it converges more often.
BARRIERS = {1e-4: 150, 1e-1: 50}
SOLVER = {
    "ipopt.print_level": 0,
    "print_time": False,
    "ipopt.sb": "yes",
    "ipopt.tol": 1e-11,
    "ipopt.bound_relax_factor": 0.0,
    "ipopt.acceptable_iter": 0,
    "ipopt.compl_inf_tol": 1e-11,
    "ipopt.constr_viol_tol": 1e-11,
    "ipopt.dual_inf_tol": 1e-8,
    "show_eval_warnings": False,
    # of which it would complain where a search fails
    "error_on_fail": False,
    "calc_lam_p": False,
}

#: CasADi's options for derivatives that are known, and what it calls them itself.
DERIVATIVES = {"grad_f": "nlp_grad_f", "jac_g": "nlp_jac_g", "hess_lag": "nlp_hess_l"}


def optima(problem, parameters=None, places=None):
    """Pairs ({parameter: value}, `Optimum`) for sample values of the parameters, a dict from
    symbols to intervals, or for the values that `places` are, dicts from the same symbols."""
    stated = (
        *(tuple(table.items()) for table in (problem.dynamics, problem.controls, problem.initial)),
        tuple(problem.terminal),
        problem.running,
        problem.final,
        problem.duration,
        problem.maximise,
        problem.first_return,
    )
    if places is None:
        return _optima(stated, tuple((parameters or {}).items()))
    return [(place, _search(stated, tuple(place)).best(tuple(place.values()))) for place in places]


@functools.lru_cache(maxsize=64)
def _optima(stated, parameters):
    names = tuple(symbol for symbol, _ in parameters)
    return [
        (dict(zip(names, case)), _search(stated, names).best(case))
        for case in sample_cases(dict(parameters))
    ]


@functools.lru_cache(maxsize=64)
def _search(stated, names):
    return _Search(stated, names)


class Optimum:
    """An optimal process: `cost`, `duration`, `times` after the start with `states` (n rows) and
    `controls` there.

    `arcs`: triples (value, begin, end), the value being None where the control is not constant. The
    last entry of `start` and of `field(y, u)` belongs to the integral of the running cost.
    """

    #: To what share the cost is known next to parameters for which an arc vanishes: a short one may
    #: be missed.
    MISSED = 5e-4

    def __init__(self, search, case, cost, times, states, controls, arcs):
        self.cost, self.duration, self.controls, self.arcs = cost, times[-1], controls, arcs
        self.times, self.states, self.start = times[1:], states[:, 1:], np.append(states[:, 0], 0.0)
        self.bounds = search.bounds(case)
        self._search, self._case = search, case

    def changes(self):
        """What goes on where one arc follows another: triples (index of the time and the state
        there, value of the control before it, value after it), None being a control that is not
        constant."""
        long = [arc for arc in self.arcs if arc[2] - arc[1] > SHORT * self.duration]
        return [
            (int(np.argmin(abs(self.times - (one[2] + other[1]) / 2))), one[0], other[0])
            for one, other in itertools.pairwise(long)
            if one[0] is None or one[0] != other[0]
        ]

    def left(self):
        """States on the way, not next to a change nor on the last arc, and what it costs from there
        to the end."""
        degree = FINE[1]
        rates = np.array(
            [self.field(np.append(y, 0), u)[-1] for y, u in zip(self.states.T, self.controls)]
        )
        steps = np.diff(np.append(0, self.times[degree - 1 :: degree]))
        parts = (
            np.einsum("ij,kj->ki", _integrals(degree), rates.reshape(-1, degree)) * steps[:, None]
        )
        spent = (parts + np.append(0, np.cumsum(parts[:, -1])[:-1])[:, None]).ravel()
        borders = [self.times[j] for j, *_ in self.changes()]
        keep = self.times < max(borders, default=0)
        for border in borders:
            keep &= abs(self.times - border) > 1e-3 * self.duration
        return self.states[:, keep], (self.cost - spent)[keep]

    def jacobians(self, y, u):
        """The derivatives of `field` in the states: (n + 1) x n; those of the final cost; those of
        what vanishes."""
        return [np.array(one, dtype=float) for one in self._search.jacobians(*y, u, *self._case)]

    def field(self, y, u):
        return np.array(self._search.rates(*y[:-1], u, *self._case), dtype=float)

    def gap(self, y):
        """What vanishes at the end."""
        return np.array(self._search.gap(*y[:-1], *self._case), dtype=float)

    def total(self, y):
        """The cost of a process that ends in y."""
        return float(y[-1] + self._search.final(*y[:-1], *self._case))

    def told_duration(self, said):
        return "the best process found ends " + ("earlier" if said > self.duration else "later")

    def size(self):
        return float(max(1e-9, np.abs(self.states).max()))

    def cost_size(self):
        """The size of the terms of the cost, which may cancel."""
        ends = [
            abs(self._search.final(*y, *self._case))
            for y in (self.states[:, 0], self.states[:, -1])
        ]
        rates = [self.field(np.append(y, 0), u)[-1] for y, u in zip(self.states.T, self.controls)]
        return float(max(abs(self.cost), *ends, np.abs(rates).mean() * self.duration))


class _Search:
    def __init__(self, stated, parameters):
        (
            dynamics,
            controls,
            initial,
            terminal,
            self._running,
            self._final,
            self._duration,
            maximise,
            returns,
        ) = stated
        self._state, self._field = zip(*dynamics)
        ((self._control, self._bounds),) = controls
        self._initial, self._terminal = [value for _, value in initial], terminal
        self._sign, self._returns, self._parameters = (
            (-1 if maximise else 1),
            returns,
            list(parameters),
        )
        ends = [*self._state, *parameters]
        self.rates = sp.lambdify(
            [*self._state, self._control, *parameters], [*self._field, self._running], "math"
        )
        self.gap = sp.lambdify(ends, list(terminal), "math")
        self.final = sp.lambdify(ends, self._final, "math")
        parts = [
            sp.Matrix(rows).jacobian(self._state).tolist() if rows else []
            for rows in ([*self._field, self._running], [self._final], list(terminal))
        ]
        self.jacobians = sp.lambdify([*self._state, self._control, *parameters], parts, "math")
        self._programmes = {}
        self._bounded = [b is not None and b.is_finite is not False for b in self._bounds]
        #: Each |u| becomes an unknown that is not less than u and -u.
        self._absolute = sorted(sp.Add(self._running, *self._field).atoms(sp.Abs), key=str)
        #: Whether a control between the bounds may pay because of the cost of its square.
        self._curved = any(sp.diff(e, self._control, 2) != 0 for e in (self._running, *self._field))

    def bounds(self, case):
        low, high = (self._value(bound, case) for bound in self._bounds)
        return (-np.inf if low is None else low), (np.inf if high is None else high)

    def best(self, case):
        """The best process for values of the parameters."""
        free = self._duration is None or isinstance(self._duration, tuple)
        pair = (
            self._duration
            if isinstance(self._duration, tuple)
            else (self._duration, self._duration)
        )
        low, high = (self._value(d, case) for d in pair)
        span = (SHORTEST if low is None else low, LONGEST if high is None else high)
        straight = all(
            not sp.diff(f, v).free_symbols & {*self._state, self._control}
            for f in self._field
            for v in (*self._state, self._control)
        )
        found, random = [], np.random.default_rng(11)
        for side in self._sides(case):
            costs = []
            for attempt in range(1 if straight and not free and self._convex(case) else STARTS):
                one = self._run(case, span, side, *self._guess(case, span, random, attempt))
                if one:
                    found.append(one)
                    costs = sorted([*costs, one[0]])
                elif (
                    straight
                    and free
                    and attempt == 0
                    and (given := self._with_durations(case, span, side, random))
                ):
                    # For a linear plant that search is convex: there is nothing else to be found.
                    found, costs = found + given, [given[0][0]]
                    break
                if len(costs) > 1 and costs[1] - costs[0] <= TWICE * (1 + abs(costs[0])):
                    break
            if not costs and free and not straight:
                found += self._with_durations(case, span, side, random)
        if not found:
            raise RuntimeError("no process that satisfies the conditions was found")
        _cost, arcs, unknown, side = min(found, key=lambda one: one[0])
        others = free + self._initial.count(None)
        guesses = [self._arcs(case, arcs, unknown, others, short) for short in (False, True)]
        fine = [
            one
            for k, guess in enumerate(guesses)
            if k == 0 or _kinds(guess[0]) != _kinds(guesses[0][0])
            for barrier in BARRIERS
            if (one := self._run(case, span, side, *guess, barrier))
        ]
        if not fine:
            raise RuntimeError("the arcs of the best process could not be made exact")
        least = min(fine, key=lambda one: one[0])
        quiet = self._quiet(case, *guesses[0])
        zero = quiet and self._run(case, span, side, *quiet)
        if zero and zero[0] <= least[0] + SAME * (1 + abs(least[0])) + 10 * self._defect(
            case, *least[1:3]
        ):
            least = zero
        return self._optimum(case, *least[:3])

    def _quiet(self, case, arcs, unknown):
        """The same arcs with the control zero on those inside the bounds on which it is about zero
        on the average, or None: there the cost hardly tells where such an arc begins, unless its
        control is a single number."""
        (low, high), count = self.bounds(case), FINE[0] * FINE[1]
        if (
            self._curved
            or self._absolute
            or not low < 0 < high
            or not np.isfinite(high - low)
            or len(arcs) == 1
        ):
            return None
        *_, controls, _ = self._unpacked(arcs, unknown)
        middles = [
            controls[k * count : (k + 1) * count][count // 4 : -count // 4]
            for k in range(len(arcs))
        ]
        kinds = [
            0.0 if kind is None and abs(middle.mean()) <= QUIET * (high - low) else kind
            for (kind, _), middle in zip(arcs, middles)
        ]
        return (
            ([(kind, pieces) for kind, (_, pieces) in zip(kinds, arcs)], unknown)
            if kinds != _kinds(arcs)
            else None
        )

    def _defect(self, case, arcs, unknown):
        """How far the states at the end of a piece are from where the control, followed in small
        steps, leads to."""
        times, states, controls, _ = self._unpacked(arcs, unknown)
        degree, worst = _degree(arcs), 0.0
        for begin in range(0, len(controls), degree):
            nodes = times[begin + 1 : begin + degree + 1]
            held = np.polynomial.Polynomial.fit(nodes, controls[begin : begin + degree], degree - 1)
            y, h = states[:, begin], (nodes[-1] - times[begin]) / 20

            def rates(t, z, held=held):
                return np.array(self.rates(*z, held(t), *case)[:-1])

            for k in range(20):
                y = rk4(rates, times[begin] + k * h, y, h)
            worst = max(worst, np.abs(y - states[:, begin + degree]).max())
        return worst

    def _convex(self, case):
        """Whether no pair of points shows that the cost is not convex."""
        random, n = np.random.default_rng(7), len(self._state)
        for _ in range(30):
            one, other = random.normal(scale=3, size=(2, n + 1))
            a, b, middle = (
                self._sign
                * np.array([self.rates(*p, *case)[-1], self.final(*p[:-1], *case)], float)
                for p in (one, other, (one + other) / 2)
            )
            if not np.all(middle <= (a + b) / 2 + 1e-9 * (np.abs(a) + np.abs(b))):
                return False
        return True

    def _with_durations(self, case, span, side, random):
        """A process that begins from one with a given duration, in a list; for a linear plant that
        search is convex."""
        for duration in filter(lambda d: span[0] <= d <= span[1], FIXED):
            given = (duration, duration)
            one = self._run(case, given, side, *self._guess(case, given, random, 0))
            one = one and self._run(case, span, side, one[1], one[2])
            if one:
                return [one]
        return []

    def _value(self, expression, case):
        return (
            None
            if expression is None
            else float(sp.sympify(expression).subs(dict(zip(self._parameters, case))))
        )

    def _start(self, case, free):
        return np.array([free if v is None else self._value(v, case) for v in self._initial])

    def _sides(self, case):
        """The sides of the target on which a process that returns to it may run: all that a control
        leads to."""
        if not self._returns:
            return [0]
        low, high = self.bounds(case)
        found = set()
        for u in (low, (low + high) / 2, high):
            y = rk4(
                lambda _, z: np.array(self.rates(*z, u, *case)[:-1]),
                0,
                self._start(case, 0.1),
                1e-2,
            )
            found.add(float(np.sign(self.gap(*y, *case)[0])))
        return sorted(found - {0.0})

    def _guess(self, case, span, random, attempt):
        """Equal pieces under a control that is constant on parts of the duration, followed in small
        steps."""
        pieces, degree = COARSE
        low, high = np.clip(self.bounds(case), -3, 3)
        duration = span[0] if span[0] == span[1] else np.clip(DURATIONS[attempt % 3], *span)
        parts = random.uniform(low, high, PARTS) if attempt else np.full(PARTS, (low + high) / 2)
        states, speeds = self._followed(case, duration, parts)
        if span[0] != span[1] and not speeds.max() <= WILD * np.median(speeds):
            duration, parts = self._closest(case, span, attempt)
            states, _ = self._followed(case, duration, parts)
        controls = np.repeat(parts, degree * pieces // PARTS)
        return [(None, pieces)], self._packed(self._start(case, 0.1), states, controls, [duration])

    def _followed(self, case, duration, parts):
        """The states at Radau's points under a control that is constant on parts of the duration,
        and their speeds."""
        pieces, degree = COARSE
        y, t, states, speeds = self._start(case, 0.1), 0.0, [], []
        for k, u in enumerate(np.repeat(parts, pieces // PARTS)):

            def field(_, z, u=u):
                return np.array(self.rates(*z, u, *case)[:-1])

            for end in (k + _radau(degree)[0][1:]) * duration / pieces:
                y = rk4(field, t, y, end - t)
                t = end
                states.append(y)
                speeds.append(np.linalg.norm(field(t, y)))
        return np.array(states).T, np.array(speeds)

    def _closest(self, case, span, attempt):
        """Of random durations and controls that are constant on parts of them those that end
        closest to the target."""
        low, high = np.clip(self.bounds(case), -3, 3)
        rates, _, gap, insides = self._in_casadi
        parts = (
            low + (high - low) * np.random.default_rng(attempt).integers(0, 3, (PARTS, TRIED)) / 2
        )
        durations = np.clip(np.resize(DURATIONS, TRIED), *span)
        y = np.repeat(self._start(case, 0.1)[:, None], TRIED, axis=1)
        for u in np.repeat(parts, 4, axis=0):
            y = rk4(
                lambda _, z, u=u[None]: np.array(rates(z, u, abs(insides(z, u, case)), case))[:-1],
                0,
                y,
                durations / PARTS / 4,
            )
        missed = np.linalg.norm(np.array(gap(y, case)), axis=0)
        chosen = np.argmin(np.where(np.isfinite(missed), missed, np.inf))
        return durations[chosen], parts[:, chosen]

    def _packed(self, start, states, controls, lengths):
        bends = np.repeat(np.abs(controls), len(self._absolute))
        return np.concatenate([start, states.ravel("F"), controls, bends, lengths])

    def _unpacked(self, arcs, unknown):
        """Times from 0 on, the states there, the controls without that at 0, and the lengths of the
        arcs."""
        n, degree = len(self._state), _degree(arcs)
        count = degree * sum(pieces for _, pieces in arcs)
        lengths = unknown[-len(arcs) :]
        steps = np.concatenate(
            [np.full(pieces, length / pieces) for length, (_, pieces) in zip(lengths, arcs)]
        )
        begins = np.append(0, np.cumsum(steps))[:-1]
        times = np.append(0, (begins[:, None] + steps[:, None] * _radau(degree)[0][1:]).ravel())
        states = unknown[: n * (count + 1)].reshape(count + 1, n).T
        return times, states, unknown[n * (count + 1) : n * (count + 1) + count], lengths

    def _arcs(self, case, arcs, unknown, free, short):
        """The arcs of a control that is constant on equal pieces, and the unknowns for them;
        `free`: how many numbers beside the lengths of the arcs are free to meet the target;
        `short`: a piece or two at the beginning, at the end or between two arcs may hold an arc of
        another kind, whose length may come out as zero."""
        times, states, controls, (duration,) = self._unpacked(arcs, unknown)
        pieces, degree = COARSE
        values, (low, high) = controls[::degree], self.bounds(case)
        near = ON_BOUND * (high - low if np.isfinite(high - low) else 1 + np.abs(values).max())
        special = [low, high, *([0.0] if self._absolute else [])]
        kinds = [next((v for v in special if abs(u - v) <= near), None) for u in values]
        runs, k = [], 0
        for kind, group in itertools.groupby(kinds):
            count = len(list(group))
            # A piece or two between other arcs hold a jump, and are no arc.
            if kind is not None or count > 2:
                runs.append((kind, k, k + count))
            elif short:
                before, after = (kinds[j] if 0 <= j < pieces else None for j in (k - 1, k + count))
                runs += [
                    (one, k, k + count) for one in self._between(before, after, values[k], special)
                ]
            k += count
        kept = []
        for kind, begin, end in runs or [(None, 0, pieces)]:
            if kept and kept[-1][0] == kind:
                kept[-1][2] = end
            else:
                kept.append([kind, begin, end])
        borders = [0, *((one[2] + other[1]) / 2 for one, other in itertools.pairwise(kept)), pieces]
        # The lengths alone may be too few to meet the target.
        found = [
            (kind if len(kept) - 1 + free >= len(self._terminal) else None, FINE[0])
            for kind, _, _ in kept
        ]
        steps = np.repeat(np.diff(borders), FINE[0]) / FINE[0]
        begins = np.append(0, np.cumsum(steps))[:-1]
        moments = (
            (begins[:, None] + steps[:, None] * _radau(FINE[1])[0][1:]).ravel() * duration / pieces
        )
        states = np.array([np.interp(moments, times, row) for row in states])
        return found, self._packed(
            unknown[: len(self._state)],
            states,
            np.interp(moments, (times[1:] + times[:-1]) / 2, controls),
            np.diff(borders) * duration / pieces,
        )

    def _between(self, before, after, value, special):
        """The kind of arc that a piece with a value between those of its neighbours may hold, in a
        list."""
        if not self._absolute:
            return [None] * self._curved
        known = [u for u in (before, after) if u is not None]
        if len(known) == 2:
            return [u for u in special if min(known) < u < max(known)]
        beyond = [u for u in special if known and (u - value) * (known[0] - value) < 0]
        return [min(beyond, key=lambda u: abs(u - value))] if beyond else []

    def _run(self, case, span, side, arcs, guess, barrier=min(BARRIERS)):
        """(cost, arcs, unknowns, side) of IPOPT's optimum from a guess, or None."""
        solver, equalities, inequalities = self._programme(arcs, barrier)
        n, degree = len(self._state), _degree(arcs)
        counts = [degree * pieces for _, pieces in arcs]
        (low, high), free = self.bounds(case), np.full(n * sum(counts), np.inf)
        lows, highs = (
            np.repeat([bound if kind is None else kind for kind, _ in arcs], counts)
            for bound in (low, high)
        )
        bends = [
            np.repeat(
                np.repeat([bound if kind is None else abs(kind) for kind, _ in arcs], counts),
                len(self._absolute),
            )
            for bound in (-np.inf, np.inf)
        ]
        lower = np.concatenate(
            [self._start(case, -np.inf), -free, lows, bends[0], np.zeros(len(arcs))]
        )
        upper = np.concatenate(
            [self._start(case, np.inf), free, highs, bends[1], np.full(len(arcs), span[1])]
        )
        found = solver(
            x0=np.clip(guess, lower, upper),
            lbx=lower,
            ubx=upper,
            p=[*case, side, *np.nan_to_num(self.bounds(case))],
            lbg=np.concatenate([np.zeros(equalities + inequalities), span[:1]]),
            ubg=np.concatenate([np.zeros(equalities), np.full(inequalities, np.inf), span[1:]]),
        )
        if solver.stats()["return_status"] != "Solve_Succeeded":
            return None
        return float(found["f"]), arcs, np.array(found["x"]).ravel(), side

    def _optimum(self, case, cost, arcs, unknown):
        times, states, controls, lengths = self._unpacked(arcs, unknown)
        ends = np.cumsum(lengths)
        return Optimum(
            self,
            case,
            self._sign * cost,
            times,
            states,
            controls,
            list(zip(_kinds(arcs), ends - lengths, ends)),
        )

    def _programme(self, arcs, barrier):
        """The nonlinear programme for arcs with so many pieces: IPOPT's function, the numbers of
        conditions."""
        shape = (
            tuple(pieces for _, pieces in arcs),
            tuple(kind is None for kind, _ in arcs),
            _degree(arcs),
        )
        if shape not in self._programmes:
            self._programmes[shape] = self._written(*shape), {}
        (programme, *counts), solvers = self._programmes[shape]
        if barrier not in solvers:
            # Its derivatives, which take the time, are the same whatever the barrier.
            known = {
                option: solver.get_function(name)
                for solver in list(solvers.values())[:1]
                for option, name in DERIVATIVES.items()
            }
            solvers[barrier] = ca.nlpsol(
                "direct",
                "ipopt",
                programme,
                SOLVER | known | {"ipopt.mu_init": barrier, "ipopt.max_iter": BARRIERS[barrier]},
            )
        return solvers[barrier], *counts

    def _written(self, pieces, free, degree):
        """The programme and the numbers of its conditions, equations and inequalities."""
        n, count = len(self._state), degree * sum(pieces)
        _, derivative, between = _radau(degree)
        y0, y, u = ca.SX.sym("y0", n), ca.SX.sym("y", n, count), ca.SX.sym("u", count)
        bends, lengths = ca.SX.sym("a", len(self._absolute), count), ca.SX.sym("T", len(pieces))
        p, side, low, high = (
            ca.SX.sym("p", len(self._parameters)),
            *(ca.SX.sym(name) for name in ("s", "l", "h")),
        )
        rates, final, gap, insides = self._in_casadi
        # Everything at once: one call for all points costs little more than one for each.
        arcs = np.repeat(np.arange(len(pieces)), pieces)
        h = ca.horzcat(*(lengths[int(arc)] / pieces[arc] for arc in arcs))
        begins = ca.horzcat(y0, y[:, degree - 1 : -1 : degree])
        nodes = [begins, *(y[:, j::degree] for j in range(degree))]
        at_nodes, inside = rates(y, u.T, bends, p), insides(y, u.T, p)
        moved = ca.repmat(h, n, 1)
        equal = [
            sum(float(share) * node for share, node in zip(row, nodes))
            - moved * at_nodes[:n, j::degree]
            for j, row in enumerate(derivative)
        ]
        if degree == COARSE[1]:
            equal += [(u[j::degree] - u[j - 1 :: degree]).T for j in range(1, degree)]
        free = np.repeat(np.repeat(free, pieces), degree)
        positive = [
            ca.vec((bends + sign * inside)[:, [int(i) for i in np.flatnonzero(free)]])
            for sign in (-1, 1)
        ]
        if self._returns:
            positive.append(ca.vec(side * gap(y[:, :-1], p)))
        controls, moduli = (
            [u[j::degree].T for j in range(degree)],
            [bends[:, j::degree] for j in range(degree)],
        )
        cost = 0
        inner = [int(k) for k in np.flatnonzero(free[::degree])] if degree == FINE[1] else []
        for weight, shares, mix in between:
            state, held, bent = (
                sum(float(share) * part for share, part in zip(by, parts))
                for by, parts in ((shares, nodes), (mix, controls), (mix, moduli))
            )
            cost += weight * ca.dot(h, rates(state, held, bent, p)[n, :])
            if inner:
                positive += [(held[inner] - low).T] * self._bounded[0] + [
                    (high - held[inner]).T
                ] * self._bounded[1]
        end = y[:, -1]
        equal = ca.vertcat(*map(ca.vec, equal), gap(end, p))
        positive = ca.vertcat(ca.SX(0, 1), *positive)
        return (
            {
                "x": ca.vertcat(y0, ca.vec(y), u, ca.vec(bends), lengths),
                "p": ca.vertcat(p, side, low, high),
                "f": self._sign * (cost + final(end, p)),
                "g": ca.vertcat(equal, positive, ca.sum1(lengths)),
            },
            equal.numel(),
            positive.numel(),
        )

    @functools.cached_property
    def _in_casadi(self):
        y, p = ca.SX.sym("y", len(self._state)), ca.SX.sym("p", len(self._parameters))
        u, a = ca.SX.sym("u"), ca.SX.sym("a", len(self._absolute))
        names = {e: sp.Dummy() for e in self._absolute}
        symbols = [*self._state, self._control, *self._parameters, *names.values()]

        def function(name, arguments, expressions):
            values = sp.lambdify(symbols, [sp.sympify(e).xreplace(names) for e in expressions], ca)
            found = values(*ca.vertsplit(y), u, *ca.vertsplit(p), *ca.vertsplit(a))
            return ca.Function(name, arguments, [ca.vertcat(ca.SX(0, 1), *found)])

        return (
            function("rates", [y, u, a, p], [*self._field, self._running]),
            function("final", [y, p], [self._final]),
            function("gap", [y, p], self._terminal),
            function("insides", [y, u, p], [e.args[0] for e in self._absolute]),
        )


def _kinds(arcs):
    return [kind for kind, _ in arcs]


def _degree(arcs):
    return COARSE[1] if len(arcs) == 1 and arcs[0][1] == COARSE[0] else FINE[1]


@functools.lru_cache
def _radau(degree):
    """Radau's points with 0 before them; the derivatives there of the polynomials that are 1 at one
    of them; and for Gauss's sum with twice as many points triples (weight, these polynomials, those
    without the point 0)."""
    points = np.append(0, ca.collocation_points(degree, "radau"))

    def basis(among):
        return [
            np.poly1d(np.delete(among, j), True) / np.prod(among[j] - np.delete(among, j))
            for j in range(len(among))
        ]

    derivative = np.array([np.polyval(np.polyder(one), points[1:]) for one in basis(points)]).T
    places, weights = np.polynomial.legendre.leggauss(2 * degree)
    between = [
        (
            weight / 2,
            *([float(one(place)) for one in basis(among)] for among in (points, points[1:])),
        )
        for place, weight in zip((places + 1) / 2, weights)
    ]
    return points, derivative, between


@functools.lru_cache
def _integrals(degree):
    """The integrals from 0 to each of Radau's points of the polynomials that are 1 at one of them
    and 0 at others."""
    points = _radau(degree)[0][1:]
    basis = [
        np.poly1d(np.delete(points, j), True) / np.prod(points[j] - np.delete(points, j))
        for j in range(degree)
    ]
    return np.array([[np.polyval(np.polyint(one), point) for one in basis] for point in points])

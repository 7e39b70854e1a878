"""The least (or greatest) value of a functional of a motion, by direct optimisation.

Neither Euler's equation nor natural conditions are used. On N equal intervals the n-th derivative
is constant on each, lower ones follow by the trapezoidal rule, and the integrand is evaluated in
the middles; IPOPT makes this least over all values at the nodes, with the given ends. The result
has an error in even powers of the step, and three grids remove the first two of them. Where a motion
is infinitely fast at an end, as for x^2 x'^2 down to x = 0, this is right to six digits, while the
polynomials of `direct_optimum` give two.
"""

import functools
import itertools
from collections.abc import Callable
from types import SimpleNamespace
from typing import NamedTuple

import numpy as np
import sympy as sp

from trajlib._lazy import casadi as ca
from workbook.checks.references.natural_units import COST, TIME, natural_units

#: Intervals of the three grids.
GRIDS = (20, 40, 80)
#: How far apart the last two steps of the extrapolation may be, as a share, for a value to count as
#: known.
KNOWN = 1e-6
SOLVER = {
    "ipopt.print_level": 0,
    "print_time": False,
    "ipopt.sb": "yes",
    "ipopt.tol": 1e-11,
    "ipopt.max_iter": 200,
}


class FunctionalOptimum:
    """The optimum for given values of all parameters.

    It has the `value`, on the interval from `begin` of length `duration`.
    """

    def __init__(self, functional):
        self.functional = functional
        _, begin, end = functional.interval
        self.begin, self.duration = float(begin), float(end - begin)
        self._units = units_of(functional)
        #: The part of the value that is the same for all motions.
        self.constant = float(constant_of(functional))

    @property
    def value(self):
        """The optimal value."""
        return self.constant + self.varying_value

    @functools.cached_property
    def varying_value(self):
        """The optimal value without the constant."""
        value, before = _extrapolated([self._on(count) for count in GRIDS])
        if not abs(value - before) <= KNOWN * (1e-3 + abs(value)):
            raise RuntimeError("the optimum was not found: the grids disagree")
        return float(self._units.cost) * (-value if self.functional.maximise else value)

    def convex(self, count=40):
        """Return whether the discrete functional, with its sign, is strictly convex.

        That is along all motions with the given ends; for integrands that are at most quadratic it decides
        whether there is an optimum.
        """
        programme = _programme(self._form, count)
        rows = programme.equations(self._guess(count), self._numbers).full()
        curvature = programme.hessian(self._guess(count), self._numbers).full()
        _, sizes, directions = np.linalg.svd(rows)
        free = directions[np.sum(sizes > 1e-10 * sizes[0]) :].T
        return bool(np.linalg.eigvalsh(free.T @ curvature @ free)[0] > 0)

    def _on(self, count):
        solver = _programme(self._form, count).solver
        result = solver(x0=self._guess(count), p=self._numbers, lbg=0, ubg=0)
        if not solver.stats()["success"]:
            raise RuntimeError("the optimum was not found: the search did not end")
        return float(result["f"])

    @functools.cached_property
    def _form(self):
        functional, units = self.functional, self._units
        rates = zip(functional.derivatives, _symbols(functional.order), units.rates)
        motion = {d: unit * symbol for d, symbol, unit in rates}
        at_end = {
            d.subs(functional.time, functional.interval[2]): symbol for d, symbol in motion.items()
        }
        integrand = functional.integrand.subs(dict(reversed(motion.items())))
        return _Form(
            functional.time,
            integrand.subs(functional.time, units.time * functional.time) * units.time / units.cost,
            (functional.final.subs(at_end) - constant_of(functional)) / units.cost,
            functional.order,
            -1 if functional.maximise else 1,
            *(
                tuple(k for k, value in enumerate(ends) if value is not None)
                for ends in (functional.start, functional.end)
            ),
        )

    @functools.cached_property
    def _numbers(self):
        """The parameters of the programme: begin, duration and the values given at both ends."""
        starts, ends = self._ends
        return [
            self.begin / float(self._units.time),
            self.duration / float(self._units.time),
            *(value for value in (*starts, *ends) if value is not None),
        ]

    @property
    def _ends(self):
        return [
            [
                None if value is None else float(value / unit)
                for value, unit in zip(values, self._units.rates)
            ]
            for values in (self.functional.start, self.functional.end)
        ]

    def _guess(self, count):
        n = self.functional.order
        level = next((ends[0] for ends in self._ends if ends[0] is not None), 0.0)
        return np.concatenate([np.tile([level] + [0.0] * (n - 1), count + 1), np.zeros(count)])


class MotionUnits(NamedTuple):
    """Units of time, of the motion and its derivatives, and of the functional."""

    time: sp.Rational
    rates: tuple
    cost: sp.Rational


def units_of(functional):
    """Return the `MotionUnits` in which the numbers of a functional are near one.

    An end of the interval that is a symbol says nothing of them.
    """
    symbols, clock = _symbols(functional.order), sp.Dummy("clock")
    motion = dict(zip(functional.derivatives, symbols))
    time, begin, end = functional.interval
    at_end = {d.subs(time, end): symbol for d, symbol in motion.items()}
    record = SimpleNamespace(
        state=[clock, *symbols[:-1]],
        control=[symbols[-1]],
        dynamics={clock: sp.S.One, **dict(itertools.pairwise(symbols))},
        controls={},
        initial={clock: begin, **dict(zip(symbols, functional.start))},
        running=functional.integrand.subs(dict(reversed(motion.items()))).subs(time, clock),
        final=functional.final.subs(at_end) - constant_of(functional),
        terminal=[s - value for s, value in zip(symbols, functional.end) if value is not None],
        duration=None if end.free_symbols else end - begin,
    )
    units = natural_units(record)
    rates = [units[symbols[0]] / units[TIME] ** k for k in range(functional.order + 1)]
    return MotionUnits(units[TIME], tuple(rates), units[COST])


def constant_of(functional):
    """Return the part of a functional that is the same for all motions."""
    symbols = _symbols(functional.order)
    time, begin, end = functional.interval

    def constant(expression, at):
        motion = {d.subs(time, at): symbol for d, symbol in zip(functional.derivatives, symbols)}
        bare = sp.expand(expression.subs(dict(reversed(motion.items()))))
        return bare.as_independent(*symbols, as_Add=True)[0]

    running = constant(functional.integrand, time)
    return constant(functional.final, end) + sp.integrate(running, (time, begin, end))


class _Form(NamedTuple):
    """A functional without its interval and end values, in the symbols of `_symbols`.

    `started` and `ended` are the orders of the derivatives given at the ends.
    """

    time: sp.Symbol
    integrand: sp.Expr
    final: sp.Expr
    order: int
    sign: int
    started: tuple
    ended: tuple


class _Programme(NamedTuple):
    """IPOPT's solver, the Hessian of the functional and the Jacobian of the conditions.

    All are functions of the values at the nodes and of the programme's parameters.
    """

    solver: Callable
    hessian: Callable
    equations: Callable


@functools.cache
def _symbols(order):
    """Return the symbols that replace the motion and its derivatives."""
    return tuple(sp.Dummy(f"x{k}") for k in range(order + 1))


def _extrapolated(values):
    """Return the limit of three grids, each twice as fine as the last, and of the last two."""
    coarse, middle, fine = values
    first, second = middle + (middle - coarse) / 3, fine + (fine - middle) / 3
    return second + (second - first) / 15, second


@functools.lru_cache(maxsize=32)
def _programme(form, count):
    """Return the programme on so many intervals, written once for all durations and ends."""
    n, symbols = form.order, _symbols(form.order)
    begin, duration = ca.SX.sym("begin"), ca.SX.sym("duration")
    starts, ends = ca.SX.sym("start", len(form.started)), ca.SX.sym("end", len(form.ended))
    h = duration / count
    nodes, top = ca.SX.sym("x", n, count + 1), ca.SX.sym("u", 1, count)
    middle = (nodes[:, 1:] + nodes[:, :-1]) / 2
    slopes = ca.vertcat(middle[1:, :], top)
    conditions = [ca.vec(nodes[:, 1:] - nodes[:, :-1] - h * slopes)]
    for column, components, values in ((0, form.started, starts), (count, form.ended, ends)):
        conditions += [nodes[k, column] - values[j] for j, k in enumerate(components)]
    integrand = sp.lambdify([form.time, *symbols], form.integrand, ca)
    final = sp.lambdify(symbols[:-1], form.final, ca)
    total = sum(
        h * integrand(begin + (k + 0.5) * h, *ca.vertsplit(middle[:, k]), top[k])
        for k in range(count)
    )
    total = form.sign * (total + final(*ca.vertsplit(nodes[:, count])))
    unknown, conditions = ca.vertcat(ca.vec(nodes), ca.vec(top)), ca.vertcat(*conditions)
    numbers = ca.vertcat(begin, duration, starts, ends)
    solver = ca.nlpsol(
        "functional", "ipopt", {"x": unknown, "p": numbers, "f": total, "g": conditions}, SOLVER
    )
    return _Programme(
        solver,
        ca.Function("hessian", [unknown, numbers], [ca.hessian(total, unknown)[0]]),
        ca.Function("equations", [unknown, numbers], [ca.jacobian(conditions, unknown)]),
    )

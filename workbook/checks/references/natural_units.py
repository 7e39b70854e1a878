"""Natural units of a problem of optimal control, in which the numbers of its statement are near one.

The logarithms of the units of states, controls, time and cost solve linear equations in the sense of
least squares: each coefficient, bound, end and initial value of the statement should be one.
"""

import itertools

import numpy as np
import sympy as sp

from workbook.checks.tools.domains import sample_cases

#: A unit whose logarithm is smaller than this is one: the search is robust enough. Others are powers
#: of ten.
PLAIN = 1.5
#: So many terms of a product of sums are looked at.
MOST_TERMS = 64
#: The weight of a chosen unit in the least squares.
CHOSEN = 1e4
TIME, COST = sp.Dummy("time"), sp.Dummy("cost")


def natural_units(problem, parameters=None, unknown=()):
    """Return the units of states, controls, `TIME` and `COST` as exact numbers, by symbol.

    Parameters
    ----------
    problem : pontryagin.Problem
        The problem, or a record with its attributes.
    parameters : dict, optional
        Intervals of parameters, which have the size of the numbers in them.
    unknown : list of sympy.Symbol
        Parameters of any size, which get units of their own.
    """
    symbols = [*problem.state, *problem.control, *unknown, TIME, COST]
    sizes = Sizes(problem, parameters or {}, unknown)
    logs = sizes.solution(symbols)
    if max(map(abs, logs.values())) <= PLAIN:
        return dict.fromkeys(symbols, sp.S.One)
    # One after the other, the time first: the units of the others then go with those that are chosen.
    units = {}
    for s in (TIME, *(s for s in symbols if s != TIME)):
        units[s] = sp.Integer(10) ** _exponent(sizes.solution(symbols)[s])
        sizes.choose(s, units[s])
    _keep_plain(problem, units)
    return units


def _keep_plain(problem, units):
    """Change units so that x1' = x2, x' = u and x' = 1 are so in these units, too."""
    for x, rate in problem.dynamics.items():
        if rate == 1:
            units[x] = units[TIME]
        elif rate in units and rate != x:
            units[rate] = units[x] / units[TIME]


def _exponent(log):
    return round(log) if abs(log) > PLAIN else 0


class Sizes:
    """Equations for the logarithms of units: each term of the statement should have size one."""

    def __init__(self, problem, parameters, unknown=()):
        cases = np.abs(np.array(sample_cases(parameters), dtype=float))
        self._log_sizes = {
            p: float(np.mean(np.log10(column[column > 0]))) if (column > 0).any() else 0.0
            for p, column in zip(parameters, cases.T)
        }
        self._equations = []
        self._units = {TIME, COST}
        if problem is None:
            return
        self._units = {*problem.state, *problem.control, *unknown}
        for x, rate in problem.dynamics.items():
            self._equate(rate, {x: 1, TIME: -1})
        for s, value in [
            *problem.initial.items(),
            *((u, bound) for u, pair in problem.controls.items() for bound in pair),
            *((TIME, end) for end in _ends(problem)),
        ]:
            if value is not None and value.is_finite is not False:
                self._equate(value, {s: 1})
        self._equate(problem.running, {COST: 1, TIME: -1})
        self._equate(problem.final, {COST: 1})
        for gap in problem.terminal:
            self._equate(gap, {sp.Dummy(): 1})

    def solution(self, symbols):
        """Return the logarithms of the units of symbols, the smallest that fit best."""
        unknowns = list(dict.fromkeys([*symbols, *(s for _, w in self._equations for s in w)]))
        rows = np.array([[float(w.get(s, 0)) for s in unknowns] for _, w in self._equations])
        right = -np.array([log for log, _ in self._equations])
        logarithms = np.linalg.lstsq(rows, right, rcond=1e-9)[0]
        return dict(zip(unknowns, logarithms[: len(symbols)]))

    def choose(self, symbol, unit):
        """Demand, before all other equations, that a symbol has this unit."""
        self._equations.append((-CHOSEN * float(sp.log(unit, 10)), {symbol: CHOSEN}))

    def _equate(self, expression, unit):
        for log, weights in self.terms(sp.sympify(expression)):
            self._equations.append(
                (log, {s: weights.get(s, 0) - unit.get(s, 0) for s in {**weights, **unit}})
            )

    def terms(self, expression):
        """Return the terms of an expression: pairs of a logarithm and {symbol: exponent}."""
        if expression.is_number:
            size = abs(complex(expression))
            return [(float(np.log10(size)), {})] if 0 < size < np.inf else []
        if expression.is_Symbol:
            if expression in self._units:
                return [(0.0, {expression: 1.0})]
            return [(self._log_sizes.get(expression, 0.0), {})]
        if isinstance(expression, (sp.Add, sp.Max, sp.Min)):
            return [term for part in expression.args for term in self.terms(part)]
        if isinstance(expression, sp.Piecewise):
            return [term for part, _ in expression.args for term in self.terms(part)]
        if isinstance(expression, sp.Abs):
            return self.terms(expression.args[0])
        if isinstance(expression, sp.Mul):
            chosen = itertools.product(*map(self.terms, expression.args))
            return [_product(terms) for terms in itertools.islice(chosen, MOST_TERMS)]
        if isinstance(expression, sp.Pow) and expression.exp.is_number:
            power = float(expression.exp)
            return [
                (power * log, {s: power * w for s, w in weights.items()})
                for log, weights in self.terms(expression.base)
            ]
        if not isinstance(expression, (sp.sign, sp.Heaviside)):
            for part in expression.args:
                self._equate(part, {})
        return [(0.0, {})]


def _product(terms):
    weights = {}
    for _, term_weights in terms:
        for s, w in term_weights.items():
            weights[s] = weights.get(s, 0.0) + w
    return sum(log for log, _ in terms), weights


def _ends(problem):
    return problem.duration if isinstance(problem.duration, tuple) else (problem.duration,)

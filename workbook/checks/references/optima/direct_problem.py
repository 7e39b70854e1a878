"""A problem of optimal control as functions of numbers and of CasADi's symbols."""

import functools

import numpy as np
import sympy as sp

from trajlib._lazy import casadi as ca
from workbook.checks.references.optima.runge_kutta import rk4
from workbook.checks.tools.domains import sample_cases

#: IPOPT's options in all searches; a search that fails is answered by what comes next.
IPOPT = {
    "ipopt.print_level": 0,
    "print_time": False,
    "ipopt.sb": "yes",
    "ipopt.bound_relax_factor": 0.0,
    "ipopt.acceptable_iter": 0,
    "show_eval_warnings": False,
    "error_on_fail": False,
    "calc_lam_p": False,
}


def statement(problem):
    """Return the statement of a `pontryagin.Problem` as a tuple, by which a search is kept."""
    return (
        *(tuple(table.items()) for table in (problem.dynamics, problem.controls, problem.initial)),
        tuple(problem.terminal),
        problem.running,
        problem.final,
        problem.duration,
        problem.maximise,
        problem.first_return,
    )


class DirectProblem:
    """The statement of a `pontryagin.Problem` at values of its parameters, `case`."""

    #: The values of the parameters at which answers are tried.
    cases = staticmethod(sample_cases)

    def __init__(self, stated, parameters):
        dynamics, controls, initial, terminal, *cost, maximise, returns = stated
        self._running, self._final, self._duration = cost
        self._state, self._field = zip(*dynamics)
        self._controls, bounds = zip(*controls)
        self._bounds = tuple(zip(*bounds))
        self._initial, self._terminal = [value for _, value in initial], terminal
        self._sign, self._returns = -1 if maximise else 1, returns
        self._parameters = list(parameters)
        ends = [*self._state, *parameters]
        self.rates = sp.lambdify(
            [*self._state, *self._controls, *parameters], [*self._field, self._running], "math"
        )
        self.gap = sp.lambdify(ends, list(terminal), "math")
        self.final = sp.lambdify(ends, self._final, "math")
        parts = [
            sp.Matrix(rows).jacobian(self._state).tolist() if rows else []
            for rows in ([*self._field, self._running], [self._final], list(terminal))
        ]
        self.jacobians = sp.lambdify([*self._state, *self._controls, *parameters], parts, "math")
        self._programmes = {}
        self._bounded = [
            all(b is not None and b.is_finite is not False for b in side) for side in self._bounds
        ]
        #: Each |u| becomes an unknown that is not less than u and -u.
        self._absolute = sorted(sp.Add(self._running, *self._field).atoms(sp.Abs), key=str)
        #: Whether a control between the bounds may pay because of the cost of its square.
        self._curved = any(
            sp.diff(e, u, 2) != 0 for e in (self._running, *self._field) for u in self._controls
        )

    def bounds(self, case):
        """Return the bounds of the control, infinite if there is none; of several controls in arrays."""
        low, high = (
            [infinite if bound is None else self._value(bound, case) for bound in side]
            for side, infinite in zip(self._bounds, (-np.inf, np.inf))
        )
        return (low[0], high[0]) if len(low) == 1 else (np.array(low), np.array(high))

    def _value(self, expression, case):
        if expression is None:
            return None
        return float(sp.sympify(expression).subs(dict(zip(self._parameters, case))))

    def _start(self, case, free):
        return np.array([free if v is None else self._value(v, case) for v in self._initial])

    def _sides(self, case):
        """Return the sides of the target on which a process that returns to it may run.

        They are all to which a control leads.
        """
        if not self._returns:
            return [0]
        low, high = self.bounds(case)
        sides = set()
        for u in (low, (low + high) / 2, high):
            start = self._start(case, 0.1)
            y = rk4(lambda _, z: np.array(self.rates(*z, u, *case)[:-1]), 0, start, 1e-2)
            sides.add(float(np.sign(self.gap(*y, *case)[0])))
        return sorted(sides - {0.0})

    def _convex(self, case):
        """Return whether no pair of points shows that the cost is not convex."""
        random, n = np.random.default_rng(7), len(self._state)
        for _ in range(30):
            first, second = random.normal(scale=3, size=(2, n + 1))
            a, b, middle = (
                self._sign
                * np.array([self.rates(*p, *case)[-1], self.final(*p[:-1], *case)], float)
                for p in (first, second, (first + second) / 2)
            )
            if not np.all(middle <= (a + b) / 2 + 1e-9 * (np.abs(a) + np.abs(b))):
                return False
        return True

    @functools.cached_property
    def casadi_functions(self):
        y, p = ca.SX.sym("y", len(self._state)), ca.SX.sym("p", len(self._parameters))
        u, a = ca.SX.sym("u", len(self._controls)), ca.SX.sym("a", len(self._absolute))
        names = {e: sp.Dummy() for e in self._absolute}
        symbols = [*self._state, *self._controls, *self._parameters, *names.values()]

        def function(name, arguments, expressions):
            values = sp.lambdify(symbols, [sp.sympify(e).xreplace(names) for e in expressions], ca)
            results = values(*(part for vector in (y, u, p, a) for part in ca.vertsplit(vector)))
            return ca.Function(name, arguments, [ca.vertcat(ca.SX(0, 1), *results)])

        return (
            function("rates", [y, u, a, p], [*self._field, self._running]),
            function("final", [y, p], [self._final]),
            function("gap", [y, p], self._terminal),
            function("insides", [y, u, p], [e.args[0] for e in self._absolute]),
        )

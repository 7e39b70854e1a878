"""The least (or greatest) value of a functional of a motion and its derivatives, found by direct optimisation: neither
Euler's equation nor natural conditions are used.

On N equal intervals the n-th derivative is constant on each, lower ones follow by the rule of the trapezium, and the
integrand is taken in the middles; IPOPT makes this least over all values at the nodes, with the given ends. What is
found has an error in even powers of the step, and three grids remove the first two of them.
"""

import functools

import casadi as ca
import numpy as np
import sympy as sp

#: Intervals of the three grids.
GRIDS = (20, 40, 80)
#: How far apart the last two steps of the extrapolation may be, as a share, for a value to count as known.
KNOWN = 1e-6
SOLVER = {"ipopt.print_level": 0, "print_time": False, "ipopt.sb": "yes", "ipopt.tol": 1e-11, "ipopt.max_iter": 200}


class FunctionalOptimum:
    """The optimum for given values of all parameters: `value`, on the interval from `begin` of length `duration`."""

    def __init__(self, functional):
        self.functional = functional
        _, begin, end = functional.interval
        self.begin, self.duration = float(begin), float(end - begin)

    @functools.cached_property
    def value(self):
        value, before = _extrapolated([self._on(count) for count in GRIDS])
        if not abs(value - before) <= KNOWN * (1e-3 + abs(value)):
            raise RuntimeError("the optimum was not found: the grids disagree")
        return -value if self.functional.maximise else value

    def convex(self, count=40):
        """Whether the discrete functional, with its sign, is strictly convex along all motions with the given ends; for
        integrands that are at most quadratic this says whether there is an optimum."""
        _, hessian, equations, guess = _programme(self.functional, count)
        rows, curvature = equations(guess).full(), hessian(guess).full()
        _, sizes, directions = np.linalg.svd(rows)
        free = directions[np.sum(sizes > 1e-10 * sizes[0]):].T
        return bool(np.linalg.eigvalsh(free.T @ curvature @ free)[0] > 0)

    def _on(self, count):
        solver, _, _, guess = _programme(self.functional, count)
        found = solver(x0=guess, lbg=0, ubg=0)
        if not solver.stats()["success"]:
            raise RuntimeError("the optimum was not found: the search did not end")
        return float(found["f"])


def _extrapolated(values):
    """What three grids tend to, each twice as fine as the one before, and what the last two alone do."""
    coarse, middle, fine = values
    first, second = middle + (middle - coarse) / 3, fine + (fine - middle) / 3
    return second + (second - first) / 15, second


def _programme(functional, count):
    """IPOPT's solver, Hessian and Jacobian of the conditions as functions, and a guess."""
    n, sign = functional.order, -1 if functional.maximise else 1
    time, begin, end = functional.interval
    h = float(end - begin) / count
    nodes, top = ca.SX.sym("x", n, count + 1), ca.SX.sym("u", 1, count)
    middle = (nodes[:, 1:] + nodes[:, :-1]) / 2
    slopes = ca.vertcat(middle[1:, :], top)
    conditions = [ca.vec(nodes[:, 1:] - nodes[:, :-1] - h * slopes)]
    for column, given in ((0, functional.start), (count, functional.end)):
        conditions += [nodes[k, column] - float(value) for k, value in enumerate(given) if value is not None]
    symbols = [time, *(sp.Dummy(f"x{k}") for k in range(n + 1))]
    names = dict(reversed(list(zip(functional.derivatives, symbols[1:]))))
    integrand = sp.lambdify(symbols, functional.integrand.subs(names), ca)
    at_end = {d.subs(time, end): s for d, s in zip(functional.derivatives, symbols[1:-1])}
    final = sp.lambdify(symbols[1:-1], functional.final.subs(at_end), ca)
    total = sum(h * integrand(float(begin) + (k + 0.5) * h, *ca.vertsplit(middle[:, k]), top[k]) for k in range(count))
    total = sign * (total + final(*ca.vertsplit(nodes[:, count])))
    unknown, conditions = ca.vertcat(ca.vec(nodes), ca.vec(top)), ca.vertcat(*conditions)
    solver = ca.nlpsol("functional", "ipopt", {"x": unknown, "f": total, "g": conditions}, SOLVER)
    level = next((float(v) for v in (functional.start[0], functional.end[0]) if v is not None), 0.0)
    guess = np.concatenate([np.tile([level] + [0.0] * (n - 1), count + 1), np.zeros(count)])
    return (solver, ca.Function("hessian", [unknown], [ca.hessian(total, unknown)[0]]),
            ca.Function("equations", [unknown], [ca.jacobian(conditions, unknown)]), guess)

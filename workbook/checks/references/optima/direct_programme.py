"""The nonlinear programme of a direct optimisation on arcs, solved by IPOPT."""

import numpy as np

from trajlib._lazy import casadi as ca
from workbook.checks.references.optima.direct_problem import IPOPT, DirectProblem
from workbook.checks.references.optima.radau import radau
from workbook.checks.references.optima.runge_kutta import rk4

#: Pieces and degree of the first run, and of each arc in the second.
COARSE, FINE = (48, 3), (4, 6)
#: IPOPT's first barriers, each with the most steps: from the higher one it looks farther, from the
#: lower one it converges more often.
BARRIERS = {1e-4: 150, 1e-1: 50}
SOLVER = IPOPT | {
    "ipopt.tol": 1e-11,
    "ipopt.compl_inf_tol": 1e-11,
    "ipopt.constr_viol_tol": 1e-11,
    "ipopt.dual_inf_tol": 1e-8,
}
#: CasADi's options for derivatives that are known, and what it calls them itself.
DERIVATIVES = {"grad_f": "nlp_grad_f", "jac_g": "nlp_jac_g", "hess_lag": "nlp_hess_l"}


class DirectProgramme(DirectProblem):
    """The programme for arcs, pairs (value of the control there or None, number of pieces)."""

    def _packed(self, start, states, controls, lengths):
        absolutes = np.repeat(np.abs(controls), len(self._absolute))
        return np.concatenate([start, states.ravel("F"), controls, absolutes, lengths])

    def _unpacked(self, arcs, unknown):
        """Return times from 0, states there, controls after 0, and the lengths of the arcs."""
        n, degree = len(self._state), degree_of(arcs)
        count = degree * sum(pieces for _, pieces in arcs)
        lengths = unknown[-len(arcs) :]
        steps = np.concatenate(
            [np.full(pieces, length / pieces) for length, (_, pieces) in zip(lengths, arcs)]
        )
        piece_starts = np.append(0, np.cumsum(steps))[:-1]
        times = np.append(
            0, (piece_starts[:, None] + steps[:, None] * radau(degree)[0][1:]).ravel()
        )
        states = unknown[: n * (count + 1)].reshape(count + 1, n).T
        return times, states, unknown[n * (count + 1) : n * (count + 1) + count], lengths

    def _run(self, case, span, side, arcs, guess, barrier=min(BARRIERS)):
        """Return (cost, arcs, unknowns, side) of IPOPT's optimum from a guess, or None."""
        solver, equalities, inequalities = self._programme(arcs, barrier)
        n, degree = len(self._state), degree_of(arcs)
        counts = [degree * pieces for _, pieces in arcs]
        (low, high), free = self.bounds(case), np.full(n * sum(counts), np.inf)
        lows, highs = (
            np.repeat([bound if kind is None else kind for kind, _ in arcs], counts)
            for bound in (low, high)
        )
        absolutes = [
            np.repeat(
                np.repeat([bound if kind is None else abs(kind) for kind, _ in arcs], counts),
                len(self._absolute),
            )
            for bound in (-np.inf, np.inf)
        ]
        lower = np.concatenate(
            [self._start(case, -np.inf), -free, lows, absolutes[0], np.zeros(len(arcs))]
        )
        upper = np.concatenate(
            [self._start(case, np.inf), free, highs, absolutes[1], np.full(len(arcs), span[1])]
        )
        result = solver(
            x0=np.clip(guess, lower, upper),
            lbx=lower,
            ubx=upper,
            p=[*case, side, *np.nan_to_num(self.bounds(case))],
            lbg=np.concatenate([np.zeros(equalities + inequalities), span[:1]]),
            ubg=np.concatenate([np.zeros(equalities), np.full(inequalities, np.inf), span[1:]]),
        )
        if solver.stats()["return_status"] != "Solve_Succeeded":
            return None
        return float(result["f"]), arcs, np.array(result["x"]).ravel(), side

    def _programme(self, arcs, barrier):
        """Return IPOPT's function for arcs with so many pieces, and the numbers of conditions."""
        shape = (
            tuple(pieces for _, pieces in arcs),
            tuple(kind is None for kind, _ in arcs),
            degree_of(arcs),
        )
        if shape not in self._programmes:
            self._programmes[shape] = self._written(*shape), {}
        (programme, *counts), solvers = self._programmes[shape]
        if barrier not in solvers:
            # Its derivatives, which take the time, are the same whatever the barrier.
            derivative_functions = {
                option: solver.get_function(name)
                for solver in list(solvers.values())[:1]
                for option, name in DERIVATIVES.items()
            }
            solvers[barrier] = ca.nlpsol(
                "direct",
                "ipopt",
                programme,
                SOLVER
                | derivative_functions
                | {"ipopt.mu_init": barrier, "ipopt.max_iter": BARRIERS[barrier]},
            )
        return solvers[barrier], *counts

    def _written(self, pieces, free, degree):
        """Return the programme and the numbers of its equations and inequalities."""
        n, count = len(self._state), degree * sum(pieces)
        _, derivative, between = radau(degree)
        y0, y, u = ca.SX.sym("y0", n), ca.SX.sym("y", n, count), ca.SX.sym("u", count)
        absolutes, lengths = ca.SX.sym("a", len(self._absolute), count), ca.SX.sym("T", len(pieces))
        p = ca.SX.sym("p", len(self._parameters))
        side, low, high = map(ca.SX.sym, ("s", "l", "h"))
        rates, final, gap, insides = self.casadi_functions
        # Everything at once: one call for all points costs little more than one for each.
        arcs = np.repeat(np.arange(len(pieces)), pieces)
        h = ca.horzcat(*(lengths[int(arc)] / pieces[arc] for arc in arcs))
        piece_starts = ca.horzcat(y0, y[:, degree - 1 : -1 : degree])
        nodes = [piece_starts, *(y[:, j::degree] for j in range(degree))]
        at_nodes, inside = rates(y, u.T, absolutes, p), insides(y, u.T, p)
        piece_lengths = ca.repmat(h, n, 1)
        equal = [
            sum(float(share) * node for share, node in zip(row, nodes))
            - piece_lengths * at_nodes[:n, j::degree]
            for j, row in enumerate(derivative)
        ]
        if degree == COARSE[1]:
            equal += [(u[j::degree] - u[j - 1 :: degree]).T for j in range(1, degree)]
        free = np.repeat(np.repeat(free, pieces), degree)
        positive = [
            ca.vec((absolutes + sign * inside)[:, [int(i) for i in np.flatnonzero(free)]])
            for sign in (-1, 1)
        ]
        if self._returns:
            positive.append(ca.vec(side * gap(y[:, :-1], p)))
        controls = [u[j::degree].T for j in range(degree)]
        moduli = [absolutes[:, j::degree] for j in range(degree)]
        cost = 0
        inner = [int(k) for k in np.flatnonzero(free[::degree])] if degree == FINE[1] else []
        for weight, shares, mix in between:
            state, control, absolute = (
                sum(float(share) * part for share, part in zip(node_weights, parts))
                for node_weights, parts in ((shares, nodes), (mix, controls), (mix, moduli))
            )
            cost += weight * ca.dot(h, rates(state, control, absolute, p)[n, :])
            if inner:
                positive += [(control[inner] - low).T] * self._bounded[0] + [
                    (high - control[inner]).T
                ] * self._bounded[1]
        end = y[:, -1]
        equal = ca.vertcat(*map(ca.vec, equal), gap(end, p))
        positive = ca.vertcat(ca.SX(0, 1), *positive)
        return (
            {
                "x": ca.vertcat(y0, ca.vec(y), u, ca.vec(absolutes), lengths),
                "p": ca.vertcat(p, side, low, high),
                "f": self._sign * (cost + final(end, p)),
                "g": ca.vertcat(equal, positive, ca.sum1(lengths)),
            },
            equal.numel(),
            positive.numel(),
        )

    def _defect(self, case, arcs, unknown):
        """Return the largest distance of states at ends of pieces from those of a fine integration."""
        times, states, controls, _ = self._unpacked(arcs, unknown)
        degree, worst = degree_of(arcs), 0.0
        for begin in range(0, len(controls), degree):
            nodes = times[begin + 1 : begin + degree + 1]
            control = np.polynomial.Polynomial.fit(
                nodes, controls[begin : begin + degree], degree - 1
            )
            y, h = states[:, begin], (nodes[-1] - times[begin]) / 20

            def rates(t, z, control=control):
                return np.array(self.rates(*z, control(t), *case)[:-1])

            for k in range(20):
                y = rk4(rates, times[begin] + k * h, y, h)
            worst = max(worst, np.abs(y - states[:, begin + degree]).max())
        return worst


def kinds_of(arcs):
    """Return the kinds of arcs: the constant value of the control, or None."""
    return [kind for kind, _ in arcs]


def degree_of(arcs):
    """Return the degree of the polynomials on these arcs."""
    return COARSE[1] if len(arcs) == 1 and arcs[0][1] == COARSE[0] else FINE[1]

"""Enclosure of an exact extremal with given arcs next to a computed one.

For linear plants with a quadratic cost (`linear_arcs`) the conditions of the maximum principle on
given arcs are as many equations as unknowns, the free half of (y, psi)(0) and the lengths of the
arcs:

    at a switching: dH/du = 0 (where a singular arc begins: with its derivatives)
    at the end: terminal equations, transversality, and H = 0 or the given duration

Krawczyk's test: if K(V) = v - Y F(v) + (I - Y F'(V)) (V - v) lies in the interior of the box V
around v, then F has a zero in K(V), exactly one in V. The balls contain all errors of rounding
(python-flint's Arb). Then the maximum condition is proved along each arc.
"""

from fractions import Fraction

import sympy as sp

from trajlib.pontryagin.verification.ball_arithmetic import (
    NotProved,
    Undetermined,
    enclosure,
    taylor_range,
    to_ball,
    to_balls,
)
from trajlib.pontryagin.verification.linear_arcs import LinearArcs

# Share of the bits that the box of Krawczyk's test takes.
SHARE = 0.6
# How far the exact extremal may lie from the computed one, relative to its size.
NEAR = 1e-7
# Terms of Taylor's formula on a piece of an arc, and how often a piece is halved at most.
TERMS, HALVINGS = 8, 12


class EnclosedExtremal:
    """The equations for one structure, and `vanishing_rows` for z at the ends of the arcs."""

    def __init__(self, problem, arcs, state, costate):
        self.problem, self.model = problem, LinearArcs(problem)
        self.arcs = [
            self.model.arc((kind,) if isinstance(kind, str) else tuple(kind)) for kind, _, _ in arcs
        ]
        self.rates = [to_balls(arc.rate) for arc in self.arcs]
        n = self.model.n
        initial_values = list(problem.initial.values())
        # Unknown at t = 0: the costate of a given state, and the state where it is free (its
        # costate is zero).
        self.unknown = [i if value is None else n + i for i, value in enumerate(initial_values)]
        self.count = n + len(arcs)
        self.guess = [
            *(float(state[i] if i < n else costate[i - n]) for i in self.unknown),
            *(end - begin for _, begin, end in arcs),
        ]
        self.start = to_balls(sp.Matrix([*(value or 0 for value in initial_values), *[0] * n, 1]))
        fixed = sp.eye(self.model.size)
        fixed[:n, -1] = -sp.Matrix([value or 0 for value in initial_values])
        starts = fixed.extract(
            [i if value is not None else n + i for i, value in enumerate(initial_values)],
            list(range(self.model.size)),
        )
        self.rows, self.vanishing_rows = self._equations_at_nodes(starts)
        self.ball_rows = [to_balls(rows) for rows in self.rows]
        equations = sum(rows.rows for rows in self.rows) + 1
        if equations != self.count:
            raise NotProved(
                f"the conditions of these arcs are {equations} equations for {self.count} unknowns"
            )
        self.hamiltonian = (
            to_balls(self.model.hamiltonian(self.arcs[-1])) if problem.free_time else None
        )

    def _equations_at_nodes(self, starts):
        """Return the independent rows that vanish at the ends of the arcs, and all such rows.

        The others follow from the initial conditions, and along a singular arc from the rows that
        vanish where the arc begins.
        """
        conditions = [self._at_switching(k) for k in range(len(self.arcs))]
        conditions.append(sp.Matrix.vstack(self.model.target, self.model.transversality))
        rows, vanishing_rows = [], []
        for k, candidates in enumerate(conditions):
            vanishing = (
                starts if k == 0 else self._stacked(sum(self.arcs[k - 1].invariants.values(), []))
            )
            rows.append(self._stacked([]))
            for row in map(candidates.row, range(candidates.rows)):
                if not _follows(row, vanishing):
                    rows[k], vanishing = rows[k].col_join(row), vanishing.col_join(row)
            vanishing_rows.append(vanishing)
        return rows, vanishing_rows

    def _stacked(self, rows):
        return sp.Matrix.vstack(sp.zeros(0, self.model.size), *rows)

    def _at_switching(self, k):
        """Return the rows that vanish where arc k begins."""
        arc, rows = self.arcs[k], []
        for j, kind in enumerate(arc.kinds):
            before = self.arcs[k - 1].kinds[j] if k else None
            if kind == "singular":
                rows += arc.invariants[j]
            elif before is not None and before not in (kind, "singular"):
                # dH/du at the bound, whichever side it is on.
                rows.append((self.arcs[k - 1] if kind == "interior" else arc).slopes[j, :])
        return self._stacked(rows)

    def values(self):
        """Return enclosures of cost, duration, switching times and costate, all conditions proved.

        Raises `NotProved` where a condition is not proved.
        """
        lengths, nodes = self._enclosed()
        for k in range(len(self.arcs)):
            self._maximum_condition(k, nodes[k], nodes[k + 1], lengths[k])
        times, total = [], 0
        for length in lengths:
            total = total + length
            times.append(total)
        duration = to_ball(self.problem.duration) if not self.problem.free_time else total
        cost = duration if self.problem.time_optimal else self._cost(nodes, lengths)
        n = self.model.n
        return (
            enclosure(cost),
            enclosure(duration),
            tuple(map(enclosure, times[:-1])),
            tuple(enclosure(nodes[0][n + i, 0]) for i in range(n)),
        )

    def _enclosed(self):
        """Return lengths of the arcs and z at their ends, after Krawczyk's test."""
        from flint import arb, arb_mat, ctx

        n, v = self.model.n, arb_mat([[arb(g)] for g in self.guess])
        try:
            for _ in range(6):
                F, jacobian, _ = self._equations(v)
                v = (v - jacobian.mid().solve(F.mid())).mid()
            F, jacobian, _ = self._equations(v)
            Y = jacobian.mid().inv()
        except ZeroDivisionError:
            raise Undetermined(
                "the conditions of these arcs do not determine the costate and the switchings"
            ) from None
        far = max(abs(float(v[i, 0]) - g) / (1 + abs(g)) for i, g in enumerate(self.guess))
        if not far < NEAR:
            raise NotProved("no exact extremal with these arcs lies near the values given")
        radius = arb(2) ** -int(SHARE * ctx.prec)
        box = arb_mat([[arb(v[i, 0], radius * (1 + abs(g)))] for i, g in enumerate(self.guess)])
        identity = arb_mat([[int(i == j) for j in range(self.count)] for i in range(self.count)])
        K = v - Y * F + (identity - Y * self._equations(box)[1]) * (box - v)
        if not all(box[i, 0].contains_interior(K[i, 0]) for i in range(self.count)):
            raise Undetermined(
                "Krawczyk's test fails: the conditions of these arcs hardly determine the costate "
                "and the switchings"
            )
        if not all(K[i, 0] > 0 for i in range(n, self.count)):
            raise NotProved("an arc has no positive length")
        return [K[i, 0] for i in range(n, self.count)], self._equations(K)[2]

    def _equations(self, v):
        """Return F (count, 1), F' (count, count) and the nodes z at unknowns v."""
        from flint import arb_mat

        n, N = self.model.n, self.model.size
        z = self.start.table()
        slopes = [[0] * self.count for _ in range(N)]
        for column, i in enumerate(self.unknown):
            z[i][0], slopes[i][column] = v[column, 0], 1
        z, slopes = arb_mat(z), arb_mat(slopes)
        nodes, values, derivatives = [z], [], []

        def collect(rows):
            if rows.nrows():
                values.extend((rows * z).table())
                derivatives.extend((rows * slopes).table())

        for k, rate in enumerate(self.rates):
            collect(self.ball_rows[k])
            flow = (rate * v[n + k, 0]).exp()
            z, slopes = flow * z, (flow * slopes).table()
            motion = rate * z
            for i in range(N):
                slopes[i][n + k] += motion[i, 0]
            slopes = arb_mat(slopes)
            nodes.append(z)
        collect(self.ball_rows[-1])
        if self.problem.free_time:
            # H = z^T S z - 1
            S = self.hamiltonian
            values.append([(z.transpose() * S * z)[0, 0] - 1])
            derivatives.extend((z.transpose() * (S + S.transpose()) * slopes).table())
        else:
            values.append(
                [sum((v[n + k, 0] for k in range(len(self.arcs))), -to_ball(self.problem.duration))]
            )
            derivatives.append([int(i >= n) for i in range(self.count)])
        return arb_mat(values), arb_mat(derivatives), nodes

    def _maximum_condition(self, k, first, last, length):
        """Prove the signs of dH/du along arc k, and that other controls keep their bounds."""
        arc, inequalities = self.arcs[k], []
        for j, (kind, (low, high)) in enumerate(zip(arc.kinds, self.model.bounds)):
            if kind in ("u-", "u+"):
                inequalities.append(
                    (arc.slopes[j, :] * (1 if kind == "u+" else -1), "the switching function")
                )
                continue
            for bound, sign in ((low, 1), (high, -1)):
                if bound.is_finite:
                    row = sign * arc.control[j, :]
                    row[-1] -= sign * bound
                    inequalities.append((row, "the control's distance from a bound"))
        for row, name in inequalities:
            if not self._positive(row, k, first, last, length):
                raise NotProved(
                    f"{name} was not proved to have one sign on arc {k + 1} "
                    f"({', '.join(arc.kinds)})"
                )

    def _positive(self, row, k, first, last, length):
        """Check whether row z > 0 inside arc k; exact zeros at its ends are allowed."""
        derivatives, balls = [row], [to_balls(row)]
        for _ in range(self.model.size + TERMS):
            derivatives.append(derivatives[-1] * self.arcs[k].rate)
            balls.append(to_balls(derivatives[-1]))
        zeros = []
        for z, vanishing_rows in (
            (first, self.vanishing_rows[k]),
            (last, self.vanishing_rows[k + 1]),
        ):
            order = 0
            while (balls[order] * z)[0, 0].contains(0) and _follows(
                derivatives[order], vanishing_rows
            ):
                order += 1
                if order == self.model.size:
                    # All derivatives vanish: zero on the whole arc.
                    return True
            zeros.append(order)
        # Pieces of the arc as (begin as a share of its length, number of halvings).
        pieces, rate = [(Fraction(0), 0)], self.rates[k]
        while pieces:
            begin, halvings = pieces.pop()
            width = Fraction(1, 2**halvings)
            tests = [(0, 1)]
            if begin == 0 and zeros[0]:
                tests.append((zeros[0], 1))
            if begin + width == 1 and zeros[1]:
                tests.append((zeros[1], (-1) ** zeros[1]))
            middle, half = (length * to_ball(share) for share in (begin + width / 2, width / 2))
            z = (rate * middle).exp() * first
            if any(
                sign * taylor_range(balls[order : order + TERMS + 1], rate, z, half) > 0
                for order, sign in tests
            ):
                continue
            if halvings == HALVINGS:
                return False
            pieces += [(begin, halvings + 1), (begin + width / 2, halvings + 1)]
        return True

    def _cost(self, nodes, lengths):
        """Return phi_0 and the integral of f_0 = z^T P z by the exponential of ((-M^T, P), (0, M)).

        The formula is Van Loan's.
        """
        from flint import arb_mat

        N, total = self.model.size, 0
        for k, arc in enumerate(self.arcs):
            P, M = to_balls(self.model.running(arc)).table(), self.rates[k].table()
            block = [[-M[j][i] for j in range(N)] + P[i] for i in range(N)] + [
                [0] * N + M[i] for i in range(N)
            ]
            flow = (arb_mat(block) * lengths[k]).exp().table()
            through = arb_mat([line[N:] for line in flow[N:]])
            gained = through.transpose() * arb_mat([line[N:] for line in flow[:N]])
            total = total + (nodes[k].transpose() * gained * nodes[k])[0, 0]
        values = {s: nodes[-1][i, 0] for i, s in enumerate(self.problem.state)}
        return total + to_ball(sp.expand(self.problem.final), values)


def _follows(row, vanishing_rows):
    """Check whether row z = 0 follows exactly from linear equations."""
    if not any(row):
        return True
    return (
        bool(vanishing_rows.rows)
        and sp.Matrix.vstack(vanishing_rows, row).rank() == vanishing_rows.rank()
    )

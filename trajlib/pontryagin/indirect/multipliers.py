"""Multipliers of a bang-bang trajectory that are not unique: the maximum condition chooses.

Along arcs at the bounds the state does not depend on the costate, and all equations for lambda_0,
psi(0) and the multipliers of the target are linear and homogeneous. With few switchings they leave
more than one solution (an initial state on a switching curve, or on a corner of one), of which
Newton's method finds any. The maximum condition is linear too, slope times sign >= 0 along the
arcs, so a linear programme finds the solution that is farthest from its border.
"""

from copy import copy

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.indirect.maximum_condition import FRACTIONS

# Singular values below this share of the largest count as zero.
RANK = 1e-9


def choose_multipliers(numeric, shot, duration):
    """Return the solution with multipliers that satisfy the maximum condition, or None.

    None also where arcs are not all at the bounds, and where the multipliers are unique up to a
    factor.
    """
    if len(shot.jumps) or any(
        kind not in ("u-", "u+") for flow in shot.flows for kind in flow.kinds
    ):
        return None
    basis = _Basis(numeric, shot)
    free = _null_space(basis.equations(duration))
    if free.shape[1] < 2:
        return None
    # Loaded here, since most problems need none of it and loading takes as long as solving one.
    from scipy.optimize import linprog

    slopes, room = basis.signed_slopes()
    slopes = slopes @ free[: numeric.n + 1]
    # Greatest share of `room`, for multipliers of which the slopes add up to the number of points.
    result = linprog(
        np.append(np.zeros(free.shape[1]), -1.0),
        A_ub=np.vstack([np.column_stack([-slopes, room]), np.append(-free[0], 0.0)]),
        b_ub=np.zeros(len(room) + 1),
        A_eq=np.append(slopes.sum(axis=0), 0.0)[None],
        b_eq=[len(room)],
        bounds=(None, None),
    )
    if not result.success or result.x[-1] < 0:
        return None
    return basis.with_multipliers(free @ result.x[:-1])


class _Basis:
    """The costates for lambda_0 = 1 alone and for each psi_i(0) = 1 alone, a basis of all.

    `starts`: (segments + 1, n, 1 + n), the costates at the beginnings of the segments and at the
    end.
    """

    def __init__(self, numeric, shot):
        self.numeric, self.shot, n = numeric, shot, numeric.n
        costates = np.eye(n, n + 1, 1)
        self.starts = [costates]
        for flow, start, length, steps in zip(shot.flows, shot.starts, shot.lengths, shot.steps):
            self.end, by_start, by_lambda, _ = flow.transition(
                start, shot.multiplier, length, steps
            )
            costates = by_start[n:, n:] @ costates
            costates[:, 0] += by_lambda[n:]
            self.starts.append(costates)

    def equations(self, duration):
        """Return all linear equations for (lambda_0, psi(0), multipliers of the target), each a row."""
        numeric, shot, n, m = self.numeric, self.shot, self.numeric.n, self.numeric.m
        rows = [np.eye(1, n + 1, 1 + i) for i in range(n) if np.isnan(numeric.start[i])]
        for left, right, start, costates in zip(
            shot.flows, shot.flows[1:], shot.starts[1:], self.starts[1:]
        ):
            switched = [j for j in range(numeric.k) if left.kinds[j] != right.kinds[j]]
            rows.append(
                self._along("slopes", right, start[:n, None], costates[:, None])[switched, 0]
            )
        x = self.end[:n]
        if duration is None:
            rows.append(
                self._along("hamiltonian", shot.flows[-1], x[:, None], self.starts[-1][:, None])[
                    :, 0
                ]
            )
        final = (
            ca.Function("final", [numeric.x], [ca.gradient(numeric.final, numeric.x)])(x)
            .full()
            .ravel()
        )
        transversality = self.starts[-1].copy()
        transversality[:, 0] += final
        normals = numeric.target_value(x)[1].full().T if m else np.zeros((n, 0))
        conditions = np.vstack(rows) if rows else np.zeros((0, n + 1))
        return np.block([[transversality, normals], [conditions, np.zeros((len(conditions), m))]])

    def signed_slopes(self):
        """Return dH/du times the sign of u along the arcs, and the margin that each may need.

        The margin is zero at the ends of the segments, where slopes may vanish.
        """
        n, rows, room = self.numeric.n, [], []
        fractions = np.concatenate([[0.0], FRACTIONS, [1.0]])
        for flow, start, length, costates in zip(
            self.shot.flows, self.shot.starts, self.shot.lengths, self.starts
        ):
            paths = [
                flow.nodes(
                    np.concatenate([start[:n], costates[:, i], [0.0]]),
                    float(i == 0),
                    length,
                    len(fractions) - 1,
                    fractions[1:],
                )[:, : 2 * n]
                for i in range(n + 1)
            ]
            slopes = self._along(
                "slopes",
                flow,
                paths[0][:, :n].T,
                np.array([path[:, n:].T for path in paths]).transpose(1, 2, 0),
            )
            for j, kind in enumerate(flow.kinds):
                rows.append(slopes[j] if kind == "u+" else -slopes[j])
                room.append(4 * fractions * (1 - fractions))
        return np.vstack(rows), np.concatenate(room)

    def _along(self, name, flow, states, costates):
        """Evaluate a function of the flow, linear in (lambda_0, psi), for every member of the basis.

        `states`: (n, N), `costates`: (n, N, 1 + n); the result has the shape (values, N, 1 + n).
        """
        return np.stack(
            [
                flow.values(name, np.vstack([states, costates[:, :, i]]), float(i == 0))
                for i in range(self.numeric.n + 1)
            ],
            axis=-1,
        )

    def with_multipliers(self, multipliers):
        """Return the same trajectory with multipliers (lambda_0, psi(0), of the target)."""
        n, changed = self.numeric.n, copy(self.shot)
        changed.multiplier = max(float(multipliers[0]), 0.0)
        changed.terminal_multipliers = multipliers[n + 1 :]
        changed.starts = [
            np.concatenate([start[:n], costates @ multipliers[: n + 1]])
            for start, costates in zip(self.shot.starts, self.starts)
        ]
        return changed


def _null_space(matrix):
    _, sizes, directions = np.linalg.svd(matrix)
    return directions[np.count_nonzero(sizes > RANK * sizes[0]) :].T

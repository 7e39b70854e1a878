"""Sample starts of plane syntheses, and the optima around them."""

import numpy as np
import sympy as sp

from workbook.checks.references.optima.convex_targets import ConvexTarget
from workbook.checks.references.optima.fastest_times import FastestTimes
from workbook.checks.references.optima.linear_plant import Plant
from workbook.checks.references.optima.state_batch import StateBatch
from workbook.checks.tools.domains import sample_cases
from workbook.checks.tools.line_search import bisect

#: How many sets of states around starts are kept with their optima.
RINGS = 64


class SampledStarts(FastestTimes):
    """Random starts that the problem allows, and neighbours of starts, with their optima."""

    def __init__(self, field, state, control, bounds, target, parameters, start):
        self.state, self.parameters, self.start = state, dict(parameters), start
        self.cases = sample_cases(self.parameters)
        super().__init__(
            Plant(field, state, control, bounds),
            ConvexTarget(target, state, list(self.parameters), self.cases),
        )
        # whether some starts cannot be steered to the target: not known yet
        self.cache, self._limited = {}, None
        self._rings = {}

    def _points(self, count, seed=4):
        """Return starts that the problem allows, about half of all for each case."""
        for factor in (1, 4, 16):
            points, cases = self._random_starts(factor * count, seed)
            if len(points) > count * len(self.cases) / 2:
                break
        return points, cases

    def _random_starts(self, count, seed):
        random, points, cases = np.random.default_rng(seed), [], []
        for case in range(len(self.cases)):
            normal_points = (
                random.normal(size=(count, 2)) * np.array([0.7, 2, 4])[np.arange(count) % 3, None]
            )
            candidates = np.concatenate(
                [normal_points, self.convex.around(random, case, count // 2)]
            )
            points.append(candidates)
            cases.append(np.full(len(candidates), case))
        points, cases = np.concatenate(points), np.concatenate(cases)
        keep = self.allowed(points, cases)
        return points[keep], cases[keep]

    def allowed(self, x, case):
        """Return which states the problem allows as starts."""
        return self.condition(self.start if self.start is not None else sp.true)(x, case)

    def condition(self, condition):
        """Return a SymPy condition as a function of states and cases."""
        test = sp.lambdify([*self.state, *self.parameters], condition, "numpy", docstring_limit=0)
        cases = np.array(self.cases, dtype=float).reshape(len(self.cases), len(self.parameters))

        def holds(x, case):
            with np.errstate(all="ignore"):
                return np.broadcast_to(
                    np.asarray(test(x[:, 0], x[:, 1], *cases[case].T), dtype=bool), len(x)
                )

        return holds

    def _around(self, batch, share, far=False, count=8):
        """Return the optimum at some states around each start, as columns.

        Laws that differ from the optimum do so from the same starts, mostly; so the last rings are kept.
        """
        key = (batch.x.tobytes(), batch.case.tobytes(), share, far, count)
        if key not in self._rings:
            while len(self._rings) >= RINGS:
                del self._rings[next(iter(self._rings))]
            self._rings[key] = self._ring(batch, share, far, count)
        return self._rings[key]

    def _ring(self, batch, share, far, count):
        angle = np.arange(count) * 2 * np.pi / count + 0.3
        ring = np.column_stack([np.cos(angle), np.sin(angle)])
        size = share * (0.3 + np.linalg.norm(batch.x, axis=1))
        points = (batch.x[:, None] + size[:, None, None] * ring).reshape(-1, 2)
        case = np.repeat(batch.case, count)
        solved = self.solve(points, case, far)
        comparable = (solved.inside == np.repeat(batch.inside, count)) & self.allowed(points, case)
        return StateBatch(
            time=np.where(comparable, solved.time, 0).reshape(-1, count),
            control=np.where(comparable, solved.control, np.repeat(batch.control, count)).reshape(
                -1, count
            ),
        )

    def _between(self, batch, kind, count, far=False):
        """Return points where `kind` changes, by bisection between neighbours that differ.

        The result is (points, directions across, cases).
        """
        left, right, case, random = [], [], [], np.random.default_rng(6)
        for k in range(len(self.cases)):
            case_rows = np.flatnonzero(batch.case == k)
            if not len(case_rows):
                continue
            marks, x = kind(batch)[case_rows], batch.x[case_rows]
            ones = random.permutation(np.flatnonzero(marks == marks.max()))
            different = np.flatnonzero(marks != marks.max())
            if not len(different):
                continue
            for start_index in ones[:count]:
                # A start inside D is no neighbour of one outside: between the two lies the target.
                comparable = different[
                    batch.inside[case_rows][different] == batch.inside[case_rows][start_index]
                ]
                if self.convex.kind == "line":
                    side = np.sign(self.convex.g(x, np.full(len(x), k)))
                    comparable = comparable[side[comparable] == side[start_index]]
                if len(comparable):
                    near = comparable[
                        np.argsort(np.linalg.norm(x[comparable] - x[start_index], axis=1))[
                            random.integers(0, min(3, len(comparable)))
                        ]
                    ]
                    left.append(x[start_index])
                    right.append(x[near])
                    case.append(k)
        if not left:
            return None
        left, right, case = np.array(left), np.array(right), np.array(case)
        direction = (right - left) / np.linalg.norm(right - left, axis=1)[:, None]
        kinds = kind(self.solve(left, case, far))
        left, right = bisect(
            lambda points, rows: kind(self.solve(points, case[rows], far)) == kinds[rows],
            left,
            right,
            16,
        )
        return (left + right) / 2, direction, case

    def start_text(self, batch, k):
        """Return the parameters and the state of a start for a message."""
        values = self.cases[batch.case[k]]
        named = ", ".join(f"{p} = {v:.4g}" for p, v in zip(self.parameters, values))
        point = ", ".join(f"{s} = {v:.4g}" for s, v in zip(self.state, batch.x[k]))
        return f"{'for ' + named + ', ' if named else ''}from {point}"

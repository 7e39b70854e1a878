"""A vector field given by the data, made numeric: values, derivatives, rest points, motions.

Only fields of data cells come here, never an answer: they are turned into code by `lambdify`.
"""

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp

#: Step of the complex-step derivative: no subtraction, so the result is exact to rounding (Squire and Trapp, 1998).
STEP = 1e-30


class Field:
    """The field `f(state)`, with values for its parameters."""

    def __init__(self, field, state, values=None):
        self.state = list(state)
        self.expressions = [sp.sympify(component).subs(values or {}) for component in field]
        left = set().union(*(e.free_symbols for e in self.expressions)) - set(self.state)
        if left:
            raise ValueError(f"the field still contains {left}")
        self._function = sp.lambdify(self.state, self.expressions, "numpy")

    def __call__(self, point):
        """f at a point; nan where it is not defined."""
        with np.errstate(all="ignore"):
            return np.array([complex(value) if np.iscomplexobj(point) else value for value in self._function(*point)])

    def jacobian(self, point):
        """The matrix of partial derivatives at a point, by complex steps."""
        n = len(self.state)
        steps = np.asarray(point, dtype=complex)[:, None] + 1j * STEP * np.eye(n)  # the k-th column goes along the k-th variable
        with np.errstate(all="ignore"):
            return np.array([np.broadcast_to(value, n) for value in self._function(*steps)]).imag / STEP

    def derivative(self, point, direction):
        """The derivative of f at a point along a direction."""
        return self(np.asarray(point, dtype=complex) + 1j * STEP * np.asarray(direction)).imag / STEP

    def refine(self, start, steps=60):
        """The rest point that a damped Newton iteration reaches from `start`, or None."""
        x = np.array(start, dtype=float)
        value = self(x)
        for _ in range(steps):
            if not np.all(np.isfinite(value)):
                return None
            try:
                move = np.linalg.solve(self.jacobian(x), -value)
            except np.linalg.LinAlgError:
                return None
            if np.linalg.norm(move) < 1e-13 * (1 + np.linalg.norm(x)):
                return x
            for _ in range(30):
                trial = self(x + move)
                if np.all(np.isfinite(trial)) and np.linalg.norm(trial) < np.linalg.norm(value) * (1 + 1e-9):
                    break
                move = move / 2
            else:
                trial = self(x + move)
            x, value = x + move, trial
        # Steps that do not shrink lead nowhere, however small the field has become: exp(x) falls without end.
        return None

    def rest_points(self, starts=240, seed=3, reach=None):
        """The rest points that a search finds, sorted: from many starts at several scales, or evenly within `reach`."""
        random, found, n = np.random.default_rng(seed), [], len(self.state)
        for k in range(starts):
            start = random.normal(scale=(0.5, 2, 8)[k % 3], size=n) if reach is None else random.uniform(-reach, reach, size=n)
            point = self.refine(start)
            if point is not None and all(np.linalg.norm(point - other) > 1e-6 * (1 + np.linalg.norm(other)) for other in found):
                found.append(point)
        return sorted(found, key=tuple)

    def motion(self, start, duration, escape=1e3):
        """The state after `duration`, or None if the motion leaves the ball of radius `escape` before."""
        def outside(_, x):
            return escape - np.linalg.norm(x)

        outside.terminal = True
        path = solve_ivp(lambda _, x: self(x), (0, duration), start, method="DOP853", rtol=1e-9, atol=1e-12, events=outside)
        return None if path.t[-1] < duration else path.y[:, -1]


def sample_values(parameters, count=6, seed=5):
    """Rational values for parameters, of both signs unless their assumptions say otherwise: a list of dicts.

    Among any four that follow one another from the start on, a parameter has sizes below and above one, of either sign.
    """
    random = np.random.default_rng(seed)
    samples = []
    for k in range(count):
        if k % 4 == 0:
            kinds = {p: random.permutation(4) for p in parameters}
        sizes = {p: int(random.integers(14, 40) if kind[k % 4] % 2 else random.integers(3, 13)) for p, kind in kinds.items()}
        signs = {p: 1 if p.is_positive else -1 if p.is_negative or kind[k % 4] < 2 else 1 for p, kind in kinds.items()}
        samples.append({p: sp.Rational(signs[p] * sizes[p], 13) for p in parameters})
    return samples


def as_text(point):
    """Numbers for a message: `(1, -0.5)`."""
    return "(" + ", ".join(f"{float(x):.4g}" for x in point) + ")"

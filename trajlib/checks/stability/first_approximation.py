"""The first approximation at a stationary solution, and what it says of stability."""

import functools
from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib.checks.contract.claims import Choice, Matrix
from trajlib.checks.contract.verdict import Wrong, judged
from trajlib.checks.tools.comparisons import Word
from trajlib.checks.tools.samples import sample_values
from trajlib.checks.tools.values import matrix_at
from trajlib.checks.tools.wording import other_rate, where_text
from trajlib.checks.truths.fields import Field, known_field
from trajlib.checks.truths.spectra import compare_region

STABILITY = ("asymptotically stable", "stable", "unstable")
#: Below this a derivative is zero: what complex steps leave of terms of higher order.
FLOOR = 1e-25


@judged(Matrix("parameters", shape=lambda data: (len(data["state"]),) * 2))
def linearisation(claim, field, state, at, parameters=()):
    """The n x n matrix A of the equations in deviations x' = A x at the stationary point `at` (n expressions)
    of the field (n expressions in the n symbols `state`)."""
    for values in sample_values(parameters):
        true = Field(field, state, values).jacobian([float(sp.sympify(x).subs(values)) for x in at])
        yield Rates(claim, true, state, values)
    return "for small deviations in every direction the field changes as the matrix says"


@dataclass
class Rates:
    """A matrix of equations in deviations says at which rates the right-hand sides change with each of the symbols."""

    claim: sp.MatrixBase
    true: np.ndarray
    symbols: list
    values: dict

    def judge(self):
        said, size = matrix_at(self.claim, self.values), max(np.linalg.norm(self.true), FLOOR)
        for symbol, own, column in zip(self.symbols, said.T, self.true.T):
            if not np.linalg.norm(own - column) <= 1e-9 * size:
                raise Wrong(f"{other_rate(symbol, own, column)}{where_text(self.values)}")


@judged
def first_approximation_stable(answer, field, state, at, parameters):
    """The parameters for which all eigenvalues of the first approximation at `at` have negative real parts."""
    return compare_region(answer, _matrix(field, state, at), parameters, "asymptotically stable")


@judged
def first_approximation_unstable(answer, field, state, at, parameters):
    """The parameters for which some eigenvalue of the first approximation at `at` has a positive real part."""
    return compare_region(answer, _matrix(field, state, at), parameters,
                          "unstable by a root with positive real part", unstable=True)


@judged(Choice(words=STABILITY))
def zero_stability(claim, field, state):
    """Whether x = 0 is asymptotically stable, stable (and no more) or unstable.

    Decided by the spectrum of the first approximation; where that is silent, by motions that start close to zero.
    """
    flow = known_field(tuple(field), tuple(state))
    real_part = max(np.linalg.eigvals(flow.jacobian([0.0] * len(state))).real)
    if abs(real_part) > 1e-9:
        truth = "unstable" if real_part > 0 else "asymptotically stable"
        reason = f"the first approximation has an eigenvalue with real part {real_part:.4g}" if real_part > 0 else \
            f"all eigenvalues of the first approximation have real parts of at most {real_part:.4g}"
    else:
        truth, reason = _by_motions(flow)
    return (yield Word(claim, truth, reason, "this does not agree with the motions near zero: "))


def _matrix(field, state, at):
    """The exact matrix of partial derivatives at a point."""
    rest = dict(zip(state, at))
    return sp.Matrix([[sp.diff(component, x).subs(rest) for x in state] for component in field])


@functools.lru_cache(maxsize=16)
def _by_motions(flow, radius=0.05, duration=200.0):
    """Stability of zero from motions that start on a small sphere, for fields whose first approximation is critical.

    What decides is whether the motions still shrink or grow after the fast parts have died out: the largest distance
    in a late stretch of time against that in an earlier one. Distance is measured in the coordinates of the
    eigenvectors, in which the linear terms change the amplitude of no critical part.
    """
    _, vectors = np.linalg.eig(flow.jacobian([0.0] * len(flow.state)))
    measure = np.linalg.inv(vectors) if np.linalg.cond(vectors) < 1e6 else np.eye(len(flow.state))
    random = np.random.default_rng(2)
    trends = []
    for _ in range(2):
        start = random.normal(size=len(flow.state))
        for side in (radius, -radius):  # a motion may come to zero from one side and leave it on the other
            trends.append(_trend(flow, measure, side * start / np.linalg.norm(start), duration))
    low, high = min(trends) - 1, max(trends) - 1
    if high == np.inf:
        return "unstable", f"a motion that starts at distance {radius} from zero leaves the ball of radius 1"
    told = (f"in motions that start at distance {radius} the amplitude changes by {100 * low:.2g} to {100 * high:.2g} "
            f"per cent between the times {duration / 2:g} and {duration:g}")
    if low > 1e-4:
        return "unstable", told
    if high < -1e-4:
        return "asymptotically stable", told
    if max(-low, high) < 1e-5:
        return "stable", told
    raise RuntimeError(f"motions near zero do not decide: {told}")


def _trend(flow, measure, start, duration, escape=1.0):
    """The amplitude of a motion near the end of `duration` divided by that near its middle; inf if it runs away."""
    from scipy.integrate import solve_ivp

    def outside(_, x):
        return escape - np.linalg.norm(x)

    outside.terminal = True
    times = np.concatenate([np.linspace(end - 0.1, end, 600) for end in (0.5, 1.0)]) * duration
    with np.errstate(all="ignore"):
        path = solve_ivp(flow.velocity, (0, duration), start, method="DOP853", rtol=1e-9, atol=1e-12, t_eval=times,
                         events=outside)
    if path.t_events[0].size:
        return np.inf
    amplitudes = np.linalg.norm(measure @ path.y, axis=0)
    middle, late = amplitudes[:600].max(), amplitudes[600:].max()
    return late / middle if middle > 1e-8 else 0.0

"""Accumulating switchings, numerically: the best processes with K arcs, K = 2, 3, ...

With the control at its bounds in turn on K arcs, and the singular control after them where there is
time left, only the lengths of the arcs are unknown. Each such process is admissible, so that its
cost is an upper bound; in Fuller's problem the excess falls by the factor 4.13^5 = 1200 with every
arc. The change by the last arc bounds the error of truncation.
"""

from dataclasses import dataclass

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.direct.ipopt import Ipopt
from trajlib.pontryagin.indirect.flow import extrapolated_midpoint

# Steps of the integrator on an arc, largest number of arcs, and relative change of the cost below
# which more arcs change nothing.
STEPS, MAX_ARCS, SETTLED = 12, 9, 1e-13
# The factor by which a further arc is guessed to be shorter than the one before.
SHORTER = 4.0


@dataclass(frozen=True)
class Accumulation:
    """The best process with finitely many arcs, and the limit of infinitely many.

    Attributes
    ----------
    cost, cost_error : float
        The cost of the process, and by how much it is higher with one arc less, which is more than
        all further arcs gain.
    ratio, ratio_error : float
        Of the length of an arc to that of the next (the geometric mean over two); how much one
        further arc changed it, or how much it varies from arc to arc.
    lengths : tuple of float
        Of the arcs at the bounds, the first of which is a part of an arc.
    """

    cost: float
    cost_error: float
    ratio: float
    ratio_error: float
    lengths: tuple[float, ...]

    def __str__(self):
        return (
            f"the optimal cost is {self.cost:.9g} (breaking off after {len(self.lengths)} arcs "
            f"changes it by {self.cost_error:.0e}), and each arc is {self.ratio:.7g} times as long "
            f"as the next (to {self.ratio_error:.0e})"
        )


def estimate_accumulation(numeric, arcs, singular, duration):
    """Return the `Accumulation` of arcs that begin with bounds, or None.

    `arcs`: as `detect_arcs` returns them; `singular`: the `ArcFlow` of the singular arc;
    `duration`: None if it is free. None where other arcs follow, or the costs do not converge.
    """
    kinds = [arc.kinds[0] for arc in arcs]
    leading = next((i for i, kind in enumerate(kinds) if kind == "singular"), len(kinds))
    depends = ca.depends_on(singular.control, ca.vertcat(numeric.psi, numeric.multiplier))
    if (
        numeric.k > 1
        or not leading
        or leading < len(kinds) - 1
        or np.isnan(numeric.start).any()
        or (duration is not None and depends)
    ):
        return None
    singular_control = singular.control if duration is not None else None
    first, lengths, processes = kinds[0], [arc.end - arc.begin for arc in arcs[:leading]], []
    for count in range(max(2, leading), MAX_ARCS + 1):
        lengths += [lengths[-1] / SHORTER] * (count - len(lengths))
        best = _best_process(numeric, first, np.array(lengths), singular_control, duration)
        if best is None:
            break
        processes.append(best)
        lengths = list(best[1])
        if len(processes) > 3 and abs(processes[-2][0] - best[0]) < SETTLED * (1 + abs(best[0])):
            break
    return _limit(numeric, processes) if len(processes) > 3 else None


def _limit(numeric, processes):
    """Return the cost, the ratio of the arcs, and their errors from the processes with K arcs."""
    (before, shorter), (cost, lengths) = processes[-2:]
    # Over two arcs, since the arcs at one bound may be longer than those at the other; the first is
    # a part of an arc.
    old, ratios = (
        np.sqrt(arc_lengths[1:-2] / arc_lengths[3:]) for arc_lengths in (shorter, lengths)
    )
    truncation = np.abs(ratios[:-1] - old)
    # The ratio itself may still change from arc to arc, beyond the error of truncation.
    changing = np.abs(np.diff(ratios)) - np.append(truncation[1:], np.inf)
    errors = np.maximum(truncation, changing)
    best = int(np.argmin(errors))
    return Accumulation(
        -cost if numeric.problem.maximise else cost,
        abs(before - cost) + SETTLED * (1 + abs(cost)),
        float(ratios[best]),
        float(errors[best]),
        tuple(map(float, lengths)),
    )


def _best_process(numeric, first, guess, singular_control, duration):
    """Return (cost, lengths) of the best process with as many arcs as guessed, or None."""
    lengths, state = ca.SX.sym("lengths", len(guess)), ca.vertcat(*numeric.start, 0.0)
    bounds = [numeric.lower, numeric.upper] if first == "u-" else [numeric.upper, numeric.lower]
    for i in range(len(guess)):
        state = _integrated(numeric, ca.DM(bounds[i % 2]), state, lengths[i])
    if duration is not None:
        state = _integrated(numeric, singular_control, state, duration - ca.sum1(lengths))
    cost = state[-1] + ca.substitute(numeric.final, numeric.x, state[: numeric.n])
    target = (
        ca.substitute(numeric.target, numeric.x, state[: numeric.n]) if numeric.m else ca.SX(0, 1)
    )
    total = ca.sum1(lengths)
    nlp = {"x": lengths, "f": cost, "g": ca.vertcat(target, total)}
    programme = Ipopt("lengths", nlp, 1e-14, 100, mu_strategy="monotone")
    result = programme(
        x0=guess,
        lbx=0,
        lbg=np.zeros(numeric.m + 1),
        ubg=np.append(np.zeros(numeric.m), np.inf if duration is None else duration),
    )
    result_lengths = result["x"].full().ravel()
    # IPOPT may stop at the limit of its accuracy: the test is whether the process ends on the
    # target.
    target_error = float(ca.norm_inf(result["g"][:-1])) if numeric.m else 0.0
    if target_error > 1e-9 or not np.all(result_lengths > 0):
        return None
    return _newton(lengths, cost, target, result_lengths, result["lam_g"].full().ravel()[:-1])


def _newton(lengths, cost, target, result_lengths, multipliers):
    """Solve for the stationary lengths by Newton's method, or return None.

    Each length is scaled, since the last ones are very short.
    """
    multiplier = ca.SX.sym("multiplier", target.numel())
    unknown = ca.vertcat(lengths, multiplier)
    equations = ca.vertcat(ca.gradient(cost + ca.dot(multiplier, target), lengths), target)
    system = ca.Function("system", [unknown], [equations, ca.jacobian(equations, unknown)])
    z = np.concatenate([result_lengths, multipliers])
    for _ in range(6):
        scale = np.concatenate([z[: len(result_lengths)], np.ones(len(multipliers))])
        residual, matrix = (value.full() for value in system(z))
        z = (
            z
            - scale
            * np.linalg.lstsq(
                scale[:, None] * matrix * scale, scale * residual.ravel(), rcond=1e-15
            )[0]
        )
    final = ca.Function("cost", [lengths], [cost, target])(z[: len(result_lengths)])
    close = np.allclose(z[: len(result_lengths)], result_lengths, rtol=0.5) and np.all(
        np.abs(final[1].full()) < 1e-12
    )
    return (float(final[0]), z[: len(result_lengths)]) if close else None


def _integrated(numeric, control, state, length):
    """Return the state with the cost after an arc of a given length."""
    rate = ca.Function(
        "rate",
        [numeric.x],
        [ca.substitute(ca.vertcat(numeric.field, numeric.density), numeric.u, control)],
    )
    for _ in range(STEPS):
        state = extrapolated_midpoint(lambda y: rate(y[: numeric.n]), state, length / STEPS)
    return state

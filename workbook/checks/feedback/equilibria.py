"""Gains that stabilise a nonlinear system at its equilibria, one for each equilibrium.

The linearisation decides. Where it is inconclusive under every gain, since an eigenvalue that none
changes lies on the imaginary axis, motions that start close to the equilibrium do, as they do for
`zero_solution_stability`.
"""

import functools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Claim, Expressions
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.feedback.loops import Gain
from workbook.checks.references.fields import Field, cached_field
from workbook.checks.references.fixed_modes import ON_BORDER, fixed_eigenvalues
from workbook.checks.references.near_equilibrium import stability_from_motions
from workbook.checks.references.pairs import pair_of
from workbook.checks.references.stationary_points import stationary_points_of
from workbook.checks.tools.values import matrix_at, numbers_at
from workbook.checks.tools.wording import point_text, roots_text

#: Loops that are tried at an equilibrium with an inconclusive linearisation, and how fast
#: their movable part is.
TRIED, DECAY = 3, 0.3


class GainsAtPoints(Claim):
    """A list of pairs [point, K]; an empty list in the place of K is None."""

    def read(self, answer, data):
        point, gain = (
            Expressions(length="state"),
            Gain(shape=lambda d: (len(d["controls"]), len(d["state"]))),
        )
        if not (
            isinstance(answer, (list, tuple))
            and answer
            and all(isinstance(pair, (list, tuple)) and len(pair) == 2 for pair in answer)
        ):
            raise Invalid("expected a list of pairs [point, K], with [] for K where there is none")
        return [(point.read(where, data), gain.read(K, data)) for where, K in answer]


@judged(GainsAtPoints())
def equilibrium_gains(claim, field, state, controls, domain=None, zeros=None):
    """Check pairs [y*, K] for all equilibria y* in the domain that need no control.

    The linearisation under u = K (y - y*) has to be asymptotically stable; K is [] where no
    gain makes y* asymptotically stable.

    Where derivatives vanish at a point as well, `zeros` are functions that have the same zeros
    as the right-hand sides without a control, all simple.
    """
    flow = cached_field(tuple(field), (*state, *controls))
    at_rest = [sp.sympify(f).subs(dict.fromkeys(controls, 0)) for f in field]
    family = stationary_points_of(at_rest if zeros is None else zeros, state, [], domain)
    (rests,) = family.rests(np.zeros((0, 1)))
    missed = list(rests)
    for written, gain in claim:
        position = family.reduced(numbers_at(written, {}, [f"coordinate {x}" for x in state]).real)
        here = [k for k, rest in enumerate(missed) if family.same(position.copy(), rest, written)]
        if not here:
            if any(family.same(position.copy(), rest, written) for rest in rests):
                raise Wrong(f"the point {point_text(position)} stands twice in your list")
            rates = flow([*position, *[0.0] * len(controls)])
            raise Wrong(
                f"your point {point_text(position)} is no equilibrium: without a control the "
                f"right-hand sides are {point_text(np.where(abs(rates) > 1e-12, rates, 0))} there"
            )
        rest = missed.pop(here[0])
        if gain is None:
            _hold_none(flow, state, rest)
        else:
            _hold(flow, state, rest, matrix_at(gain, {}))
    if missed:
        raise Wrong("there is an equilibrium for which your answer gives no gain, not even []")
    return "each gain draws the motions near its equilibrium to it, and where there is none no gain does"


def _hold(flow, state, rest, gain):
    if abs(gain.imag).max() > 0:
        raise Wrong(f"the gain for {point_text(rest)} is not real")
    A, B = _first_approximation(flow, state, rest)
    eigenvalues = np.linalg.eigvals(A + B @ gain.real)
    stable, reason = (
        max(eigenvalues.real) < -ON_BORDER,
        f"the loop has the eigenvalues {roots_text(eigenvalues)}",
    )
    if (
        not stable
        and abs(max(eigenvalues.real)) <= ON_BORDER
        and abs(_slowest_fixed(A, B)) <= ON_BORDER
    ):
        found, reason = _by_motions(flow, tuple(state), tuple(rest), tuple(map(tuple, gain.real)))
        stable = found == "asymptotically stable"
    if not stable:
        raise Wrong(
            f"with your gain the equilibrium {point_text(rest)} is not as required: {reason}"
        )


def _hold_none(flow, state, rest):
    A, B = _first_approximation(flow, state, rest)
    slowest = _slowest_fixed(A, B)
    if slowest > ON_BORDER:
        return
    if slowest < -ON_BORDER:
        raise Wrong(
            f"some gain makes the equilibrium {point_text(rest)} asymptotically stable: no mode "
            "that stays the same forbids it"
        )
    verdicts = {_by_motions(flow, tuple(state), tuple(rest), gain)[0] for gain in _tried(A, B)}
    if "asymptotically stable" in verdicts:
        raise Wrong(
            f"some gain makes the equilibrium {point_text(rest)} asymptotically stable: motions "
            "that start close to it come back"
        )


def _first_approximation(flow, state, rest):
    n = len(state)
    matrix = flow.jacobian([*rest, *[0.0] * (len(flow.state) - n)])
    matrix = np.where(abs(matrix) > 1e-12 * max(np.linalg.norm(matrix), 1e-300), matrix, 0.0)
    return matrix[:, :n], matrix[:, n:]


def _fixed(A, B):
    """The different eigenvalues that no gain changes."""
    A, B = (
        sp.Matrix(*part.shape, [sp.Rational(str(round(x, 9))) for x in part.ravel()])
        for part in (A, B)
    )
    return fixed_eigenvalues(pair_of(A.T, B.T))[0]


def _slowest_fixed(A, B):
    return max(_fixed(A, B).real, default=-np.inf)


def _tried(A, B):
    """Some gains under which all eigenvalues but those that none changes have clearly negative real
    parts."""
    random, found, fixed = np.random.default_rng(7), [], _fixed(A, B)
    for _ in range(2000):
        gain = 3 * random.normal(size=(B.shape[1], len(A)))
        movable = [z for z in np.linalg.eigvals(A + B @ gain) if not (abs(z - fixed) < 1e-6).any()]
        if max((z.real for z in movable), default=-np.inf) < -DECAY:
            found.append(tuple(map(tuple, gain)))
        if len(found) == TRIED:
            return found
    raise RuntimeError("no gains were found to try at a critical equilibrium")


@functools.lru_cache(maxsize=64)
def _by_motions(flow, state, rest, gain):
    """The verdict of motions on the deviations from an equilibrium, and what they show."""
    deviations = sp.Matrix(state)
    values = dict(zip(flow.state[len(state) :], sp.Matrix(gain) * deviations))
    values |= {x: x + position for x, position in zip(state, rest)}
    return stability_from_motions(
        Field([f.subs(values, simultaneous=True) for f in flow.expressions], state)
    )

"""Gains that stabilise a nonlinear system at its equilibria, one for each equilibrium.

The linearisation decides. It is inconclusive under every gain if an eigenvalue that no gain changes
lies on the imaginary axis. Then motions that start close to the equilibrium decide, as in
`zero_solution_stability`.

No check here is declared by a reference: any stabilising gain is right.
"""

import functools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Claim, Expressions, Parts
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.feedback.loops import Gain
from workbook.checks.references.equilibria import equilibria_of
from workbook.checks.references.fields import Field, cached_field
from workbook.checks.references.fixed_modes import ON_BORDER, fixed_eigenvalues
from workbook.checks.references.near_equilibrium import stability_from_motions
from workbook.checks.references.pairs import pair_of
from workbook.checks.tools.values import matrix_at, numbers_at
from workbook.checks.tools.wording import point_text, roots_text

#: Number of gains that are tried at an equilibrium with an inconclusive linearisation, and the
#: least decay rate of the modes that a gain can change.
SAMPLES, DECAY = 3, 0.3


class GainsAtPoints(Claim):
    """A list of pairs [point, K]; an empty list for K is read as None."""

    def read(self, answer, data):
        expected = "a list of pairs [point, K], with [] for K where there is none"
        if not (isinstance(answer, (list, tuple)) and answer):
            raise Invalid(f"expected {expected}")
        gain = Gain(shape=(len(data["controls"]), len(data["state"])))
        pair = Parts(Expressions(length="state"), gain, expected=expected)
        return [pair.read(part, data) for part in answer]


@judged(GainsAtPoints())
def equilibrium_gains(claim, field, state, controls, domain=None, zeros=None):
    """Check pairs [y*, K] for all equilibria y* in the domain that need no control.

    The linearisation under u = K (y - y*) has to be asymptotically stable; K is [] where no
    gain makes y* asymptotically stable.

    Where derivatives vanish at a point as well, `zeros` are functions that have the same zeros
    as the right-hand sides without a control, all simple.

    Can decide when the equilibria without a control are simple zeros of the right-hand sides, or
    of the `zeros`.

    Examples
    --------
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> checks.equilibrium_gains([[(0, 0), [-2, -2]]], [v, x + u], [x, v], [u]).status
    'right'
    >>> checks.equilibrium_gains([[(0, 0), [0, -2]]], [v, x + u], [x, v], [u]).status
    'wrong'
    """
    flow = cached_field(tuple(field), (*state, *controls))
    uncontrolled = [sp.sympify(f).subs(dict.fromkeys(controls, 0)) for f in field]
    family = equilibria_of(uncontrolled if zeros is None else zeros, state, [], domain)
    (equilibria,) = family.points(np.zeros((0, 1)))
    unmatched = list(equilibria)
    for point, gain in claim:
        position = numbers_at(point, {}, [f"coordinate {x}" for x in state]).real
        if not family.inside(family.rounded_inside(position, point)):
            raise Wrong(f"your point {point_text(position)} lies outside the domain")
        matches = [
            k
            for k, equilibrium in enumerate(unmatched)
            if family.is_same_point(position, equilibrium, point)
        ]
        if not matches:
            if any(
                family.is_same_point(position, equilibrium, point) for equilibrium in equilibria
            ):
                raise Wrong(f"the point {point_text(position)} stands twice in your list")
            rates = flow([*position, *[0.0] * len(controls)])
            raise Wrong(
                f"your point {point_text(position)} is no equilibrium: without a control the "
                f"right-hand sides are {point_text(np.where(abs(rates) > 1e-12, rates, 0))} there"
            )
        equilibrium = unmatched.pop(matches[0])
        if gain is None:
            _judge_no_gain(flow, state, equilibrium)
        else:
            _judge_gain(flow, state, equilibrium, matrix_at(gain, {}))
    if unmatched:
        raise Wrong(
            "there is an equilibrium for which your answer gives neither a gain nor an empty list"
        )
    return "with each gain the motions near its equilibrium converge to it, and where there is no gain none does this"


def _judge_gain(flow, state, equilibrium, gain):
    if abs(gain.imag).max() > 0:
        raise Wrong(f"the gain for {point_text(equilibrium)} is not real")
    A, B = _linearisation(flow, state, equilibrium)
    eigenvalues = np.linalg.eigvals(A + B @ gain.real)
    largest = max(eigenvalues.real)
    reason = f"the loop has the eigenvalues {roots_text(eigenvalues)}"
    stable = largest < -ON_BORDER
    if abs(largest) <= ON_BORDER and abs(_slowest_fixed(A, B)) <= ON_BORDER:
        rows = tuple(map(tuple, gain.real))
        verdict, reason = _stability_from_motions(flow, tuple(state), tuple(equilibrium), rows)
        stable = verdict == "asymptotically stable"
    if not stable:
        raise Wrong(
            f"with your gain the equilibrium {point_text(equilibrium)} is not asymptotically stable: {reason}"
        )


def _judge_no_gain(flow, state, equilibrium):
    A, B = _linearisation(flow, state, equilibrium)
    failure = f"some gain makes the equilibrium {point_text(equilibrium)} asymptotically stable: "
    slowest = _slowest_fixed(A, B)
    if slowest > ON_BORDER:
        return
    if slowest < -ON_BORDER:
        raise Wrong(failure + "every mode that no gain changes decays")
    verdicts = {
        _stability_from_motions(flow, tuple(state), tuple(equilibrium), gain)[0]
        for gain in _sample_gains(A, B)
    }
    if "asymptotically stable" in verdicts:
        raise Wrong(failure + "motions that start close to it come back")


def _linearisation(flow, state, equilibrium):
    n = len(state)
    matrix = flow.jacobian([*equilibrium, *[0.0] * (len(flow.state) - n)])
    matrix = np.where(abs(matrix) > 1e-12 * max(np.linalg.norm(matrix), 1e-300), matrix, 0.0)
    return matrix[:, :n], matrix[:, n:]


def _fixed(A, B):
    """Return the different eigenvalues that no gain changes."""
    A, B = (
        sp.Matrix(*part.shape, [sp.Rational(str(round(x, 9))) for x in part.ravel()])
        for part in (A, B)
    )
    return fixed_eigenvalues(pair_of(A.T, B.T))[0]


def _slowest_fixed(A, B):
    return max(_fixed(A, B).real, default=-np.inf)


def _sample_gains(A, B):
    """Return gains under which every eigenvalue that a gain can change decays at least as DECAY."""
    generator, gains, fixed = np.random.default_rng(7), [], _fixed(A, B)
    for _ in range(2000):
        gain = 3 * generator.normal(size=(B.shape[1], len(A)))
        movable = [z for z in np.linalg.eigvals(A + B @ gain) if not (abs(z - fixed) < 1e-6).any()]
        if max((z.real for z in movable), default=-np.inf) < -DECAY:
            gains.append(tuple(map(tuple, gain)))
        if len(gains) == SAMPLES:
            return gains
    raise RuntimeError("no gains were found to try at a critical equilibrium")


@functools.lru_cache(maxsize=64)
def _stability_from_motions(flow, state, equilibrium, gain):
    """Return the stability of an equilibrium, decided by motions close to it, and the reason."""
    deviations = sp.Matrix(state)
    values = dict(zip(flow.state[len(state) :], sp.Matrix(gain) * deviations))
    values |= {x: x + position for x, position in zip(state, equilibrium)}
    return stability_from_motions(
        Field([f.subs(values, simultaneous=True) for f in flow.expressions], state)
    )

"""The conditions of the maximum principle written out, and what they say of singular arcs.

`problem` is a `pontryagin.Problem`; `costates` are the symbols psi_1, ..., psi_n in the order of
its states. The cost has the multiplier lambda_0 = 1: H = psi^T f - f_0, or + f_0 if the cost is to
be great. Each answer is judged by what it says at values of states, costates, controls and
parameters; `domain` gives intervals for these where their symbols may not take all values. Points
of singular arcs come from `truths.singular_arcs`.
"""

import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression, Expressions, Integer, YesNo
from workbook.checks.contract.members import members
from workbook.checks.contract.tolerance import (
    DECIMALS,
    EXACT,
    agree,
    in_decimals,
    perturbed,
    relative_tolerance,
)
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.pontryagin.followed import reach
from workbook.checks.pontryagin.in_time import Control, Steering
from workbook.checks.references.optima.transfer_optima import rk4
from workbook.checks.references.singular_arcs import hamiltonian, known_costates, singular_arcs
from workbook.checks.tools.comparisons import Word
from workbook.checks.tools.conditions import decide, exactly, place_text
from workbook.checks.tools.samples import draw, ends, found_once, sample_cases
from workbook.checks.tools.values import (
    at_once,
    number_at,
    real_at,
    real_function,
    uncertain_entries,
    value_at,
)
from workbook.checks.tools.wording import rounded_text

#: At so many places an identity is tried, and with so many other controls a greatest value is
#: compared.
PLACES, RIVALS = 8, 41
#: How well points of singular arcs and of a claimed surface are known.
POINTS = 1e-7
#: How close to a switching a control is looked at, as a share of the way there.
NEXT_TO = 1e-4
#: Between what a control without a bound is compared.
UNBOUNDED = 20.0


@judged(
    Expression(
        lambda data: [
            *data["problem"].state,
            *data["problem"].control,
            *data["costates"],
            *data["problem"].parameters,
        ]
    )
)
def pontryagin_function(claim, problem, costates, domain=None):
    """Pontryagin's function H with lambda_0 = 1, in states, controls, costates and parameters."""
    true = hamiltonian(problem, costates)
    for values in _places(problem, costates, domain):
        _equal(claim, true, values, "H")
    return f"it is H, tried at {PLACES} places"


@judged(
    Expressions(
        lambda data: [
            *data["problem"].state,
            *data["problem"].control,
            *data["costates"],
            *data["problem"].parameters,
        ],
        length="costates",
    )
)
def adjoint_equations(claims, problem, costates, domain=None):
    """The right-hand sides of the adjoint equations with lambda_0 = 1, in the order of the
    states."""
    H = hamiltonian(problem, costates)
    for psi, y, claim in zip(costates, problem.state, claims):
        for values in _places(problem, costates, domain):
            _equal(claim, -sp.diff(H, y), values, f"{psi}'")
    return f"they are the adjoint equations at {PLACES} places"


@judged(
    Expression(
        lambda data: [
            *data["problem"].state,
            *data["problem"].control,
            *data["costates"],
            *data["problem"].parameters,
        ]
    )
)
def switching_function(claim, problem, costates, control=None, domain=None):
    """What decides by its sign on which bound a control lies: dH/du, up to a positive factor."""
    control = control or problem.control[0]
    slope = sp.diff(hamiltonian(problem, costates), control)
    for values in _places(problem, costates, domain, known=True):
        said, true = (value_at(e, values, "the switching function") for e in (claim, slope))
        if np.sign(said) != np.sign(true):
            raise Wrong(
                f"for {rounded_text(values)}, H {'grows' if true > 0 else 'falls'} with {control}, "
                f"and your function is {said:.4g}"
            )
    _has_the_sign(claim, slope, control, known_costates(problem, costates), domain)
    # Of one sign at random places is less than vanishing together: there each has to.
    return _vanish_together(claim, slope, problem, costates, domain)


@judged(
    Expression(
        lambda data: [
            *data["problem"].state,
            *data["problem"].control,
            *data["costates"],
            *data["problem"].parameters,
        ]
    )
)
def switching_rate(claim, problem, costates, control=None, domain=None):
    """The time derivative of dH/du along the trajectories and the adjoint equations."""
    first, *_ = singular_arcs(problem, control or problem.control[0], tuple(costates)).derivatives
    H = hamiltonian(problem, costates)
    flow = dict(problem.dynamics) | {psi: -sp.diff(H, y) for psi, y in zip(costates, problem.state)}
    true = sum((sp.diff(first, s) * rate for s, rate in flow.items()), sp.S.Zero)
    for values in _places(problem, costates, domain, known=True):
        _equal(claim, true, values, "the derivative of dH/du")
    return f"it is the derivative of dH/du at {PLACES} places"


@judged
def transversality(answer, problem, costates):
    """What vanishes at the end of the process, with lambda_0 = 1: a list of expressions or
    equations in costates, states and parameters, without the multipliers of the target. H = 0 does
    not belong to them."""
    symbols = [*costates, *problem.state, *problem.parameters]
    claims = [
        _difference(part, symbols)
        for part in members(
            answer, "a list of expressions that vanish at the end", single=(sp.Expr, sp.Eq)
        )
    ]
    sign = -1 if problem.maximise else 1
    target = real_function(
        [*problem.state, *problem.parameters],
        [sp.diff(g, y) for g in problem.terminal for y in problem.state],
    )
    for values in _on_target(problem):
        normals = target(*(float(values[s]) for s in (*problem.state, *problem.parameters)))
        tangents = _kernel(normals.reshape(-1, len(problem.state)))
        gradient = np.array([float(sp.diff(problem.final, y).subs(values)) for y in problem.state])
        true = np.column_stack([tangents, sign * tangents @ gradient])
        said = _affine_rows(claims, costates, values)
        more, less = _rank(said) - _rank(true), _rank(np.vstack([said, true])) - _rank(said)
        if (less and more >= 0) or more > 0:
            raise Wrong(
                f"at the end {rounded_text(values)} your conditions demand what need not hold: "
                "there are costates that satisfy the condition of transversality and not yours"
            )
        if less:
            raise Wrong(
                f"at the end {rounded_text(values)} your conditions allow costates that are not "
                "orthogonal to the target"
            )
    return "they say what the condition of transversality says"


@judged
def maximising_control(answer, problem, costates, domain=None):
    """The control that makes H greatest, in states, costates and parameters; of several controls a
    list."""
    symbols = [*problem.state, *costates, *problem.parameters]
    controls = list(problem.control)
    single = len(controls) == 1 and not isinstance(answer, (list, tuple, sp.MatrixBase))
    claims = (
        [coercion.as_expression(answer, symbols)]
        if single
        else coercion.as_expressions(answer, symbols, len(controls))
    )
    H = real_function([*symbols, *controls], [hamiltonian(problem, costates)])
    for values in (
        *_places(problem, costates, domain, controls=False),
        *_near_switching(problem, costates, domain),
    ):
        numbers, bounds = [float(values[s]) for s in symbols], _bounds(problem, values)
        said = np.array([value_at(claim, values, str(u)) for claim, u in zip(claims, controls)])
        for u, value, (low, high) in zip(controls, said, bounds):
            slack = relative_tolerance(*claims) * (1 + abs(value))
            if not low - slack <= value <= high + slack:
                raise Wrong(
                    f"for {rounded_text(values)} your {u} is {value:.4g}, which is not admissible"
                )
        # What decimals leave open is a control, of which H near its maximum says little.
        open_ = uncertain_entries(sp.Matrix(claims), values).ravel()
        near, rivals = (
            np.array(np.meshgrid(*parts)).reshape(len(controls), -1)
            for parts in (
                [
                    np.clip(value + one * np.linspace(-1, 1, 21), *pair)
                    for value, one, pair in zip(said, open_, bounds)
                ],
                [_rivals(value, *pair) for value, pair in zip(said, bounds)],
            )
        )
        found, others = (
            H(*numbers, *near)[0] if open_.any() else H(*numbers, *said)[:1],
            H(*numbers, *rivals)[0],
        )
        if not found.max() >= np.nanmax(others) - 1e-9 * np.ptp(others) - 0.01 * np.ptp(found):
            raise Wrong(
                f"for {rounded_text(values)} your control gives H = {H(*numbers, *said)[0]:.4g}, "
                f"another admissible one {np.nanmax(others):.4g}"
            )
    return f"no admissible control gives a greater H, tried at {PLACES} places"


@judged(
    Expression(
        lambda data: [*data["problem"].state, *data["costates"], *data["problem"].parameters]
    )
)
def maximised_hamiltonian(claim, problem, costates, domain=None):
    """The greatest value of H over the admissible controls with lambda_0 = 1, of controls that
    enter it linearly."""
    H, controls = sp.expand(hamiltonian(problem, costates)), list(problem.control)
    if any(sp.diff(H, one, other) != 0 for one in controls for other in controls):
        raise ValueError("H is not linear in the controls")
    rest, slopes = H.subs(dict.fromkeys(controls, 0)), [sp.diff(H, u) for u in controls]
    for values in (
        *_places(problem, costates, domain, controls=False),
        *_near_switching(problem, costates, domain),
    ):
        numbers = [float(e.subs(values)) for e in slopes]
        terms = [
            max(slope * low, slope * high)
            for slope, (low, high) in zip(numbers, _bounds(problem, values))
        ]
        parts = [float(part.subs(values)) for part in sp.Add.make_args(rest)]
        said, wanted = value_at(claim, values, "the greatest value of H"), sum(parts) + sum(terms)
        if not agree(said, wanted, claim, size=max(map(abs, [*parts, *terms])), computed=EXACT):
            raise Wrong(
                f"for {rounded_text(values)} your expression gives {said:.4g}; "
                + (
                    "no admissible control gives H so great a value"
                    if said > wanted
                    else "there are admissible controls that give H a greater value"
                )
            )
    return f"it is the greatest value of H, at {PLACES} places"


# Singular arcs.


@judged(Integer())
def singular_order(claim, problem, costates, control=None):
    """The order q of the singular arcs: the control appears first in the derivative of order 2q of
    dH/du."""
    arcs = _arcs(problem, costates, control)
    if claim != arcs.order:
        raise Wrong(
            f"differentiate dH/du along the trajectories: {arcs.control} does not appear first in "
            f"the derivative of order {2 * int(claim)}"
        )
    return f"{arcs.control} appears first in the derivative of order {2 * arcs.order}"


@judged
def singular_surface(answer, problem, costates, control=None, domain=None):
    """Where singular arcs lie: an equation in states and parameters, or a list of equations that
    hold together."""
    arcs = _arcs(problem, costates, control)
    symbols = [*problem.state, *problem.parameters]
    claims = [
        _difference(part, symbols)
        for part in members(
            answer, "an equation in the states, or several", single=(sp.Expr, sp.Eq)
        )
    ]
    surface = _Zeros(claims, list(problem.state), list(problem.parameters))
    for values in _points(arcs, domain):
        if not surface.distance(values) <= surface.left_open(values):
            raise Wrong("there are singular arcs on which your equation does not hold")
    seen = 0
    random = np.random.default_rng(23)
    for _ in range(6 * PLACES):
        values = {s: draw(random, s, domain) for s in symbols}
        place = surface.near(values)
        if place is None or not _allowed(place, domain):
            continue
        seen += 1
        if not arcs.multipliers_exist(place, 20 * surface.left_open(place)):
            raise Wrong(
                f"at {rounded_text(place)} your equation holds, and with no costates this is a "
                "point of a singular arc"
            )
        if seen == PLACES:
            break
    return f"singular arcs lie there and nowhere else, tried at {PLACES} places on either side"


@judged(
    Expression(
        lambda data: [
            *data["problem"].state,
            *data["problem"].control,
            *data["costates"],
            *data["problem"].parameters,
        ]
    )
)
def singular_control(claim, problem, costates, control=None, domain=None):
    """The control on singular arcs, in states and parameters; what holds on the arcs may be
    used."""
    arcs = _arcs(problem, costates, control)
    rest, slope = arcs.highest.subs(arcs.control, 0), sp.diff(arcs.highest, arcs.control)
    _without_control(claim, arcs)
    for values in _points(arcs, domain):
        a, b = (real_at(e, values) for e in (rest, slope))
        if b is None or abs(b) < POINTS * (1 + abs(a)):
            continue
        said = value_at(claim, values, f"the singular {arcs.control}")
        low, high = _bounds(problem, values)[list(problem.control).index(arcs.control)]
        # of a control that is zero
        rounded = np.isfinite(high - low) and abs(said + a / b) <= POINTS * (high - low)
        if not rounded and not agree(said, -a / b, claim, size=abs(a / b), computed=POINTS):
            raise Wrong(
                f"at a point of a singular arc your control gives {said:.4g}, under which "
                f"dH/d{arcs.control} does not stay zero"
            )
    return "it keeps dH/du at zero on singular arcs"


@judged(
    Expressions(
        lambda data: [
            *data["problem"].state,
            *data["problem"].control,
            *data["problem"].parameters,
        ],
        length="costates",
    )
)
def singular_costates(claims, problem, costates, control=None, domain=None):
    """What the costates are, with lambda_0 = 1, as long as one control is singular, in states,
    parameters and the other controls, which lie on their bounds; the conditions at the end have no
    part in it."""
    arcs = singular_arcs(problem, control or problem.control[0], tuple(costates))
    for values in _points(arcs, domain):
        for psi, claim in zip(costates, claims):
            if arcs.control in claim.free_symbols:
                raise Wrong(
                    f"your {psi} depends on {arcs.control}, which can have any value there for a "
                    "moment"
                )
            said, size = (
                value_at(claim, values, str(psi)),
                max(abs(values[one]) for one in costates),
            )
            if not agree(said, values[psi], claim, size=size, computed=POINTS):
                raise Wrong(
                    f"for {rounded_text({s: values[s] for s in (*arcs.state, *arcs.others)})} your "
                    f"{psi} is {said:.4g}; with it dH/d{arcs.control} does not vanish for a while, "
                    "or H does not"
                )
    return "with them dH/du stays zero, and H is what it has to be"


@judged(
    Expression(
        lambda data: [
            *data["problem"].state,
            *data["problem"].control,
            *data["costates"],
            *data["problem"].parameters,
        ]
    )
)
def kelley_expression(claim, problem, costates, control=None, domain=None):
    """The left-hand side of Kelley's condition, (-1)^q d/du d^(2q)/dt^(2q) dH/du, on singular
    arcs."""
    arcs = _arcs(problem, costates, control)
    true = (-1) ** arcs.order * sp.diff(arcs.highest, arcs.control)
    _without_control(claim, arcs)
    for values in _points(arcs, domain):
        said = value_at(claim, values, "Kelley's expression")
        if not agree(said, real_at(true, values), claim, computed=POINTS):
            raise Wrong(
                f"at a point of a singular arc your expression gives {said:.4g}, which is not the "
                "left-hand side of Kelley's condition there"
            )
    return "it is Kelley's expression on singular arcs"


@judged(YesNo())
def kelley_holds(claim, problem, costates, control=None, domain=None):
    """Whether Kelley's condition holds on the singular arcs."""
    arcs = _arcs(problem, costates, control)
    kelley = (-1) ** arcs.order * sp.diff(arcs.highest, arcs.control)
    signs = {bool(real_at(kelley, values) <= 0) for values in _points(arcs, domain)}
    if len(signs) > 1:
        raise RuntimeError("Kelley's condition holds on a part of the singular arcs")
    yield Word(
        claim,
        signs.pop(),
        "look at the sign of (-1)^q d/du d^(2q)/dt^(2q) dH/du on the arc, with lambda_0 = 1",
    )
    return "its sign was looked at on singular arcs"


@judged
def extremal_control(answer, problem, time, parameters=None, start=None):
    """A control in time under which the maximum principle holds, whether or not it is optimal.

    For problems with one control, a given duration and a free end: forward in time go the states,
    backward the costates. `parameters` is a dict from symbols in the control to intervals; with
    `start`, the control begins with this one of them.
    """
    u, (low, high) = problem.control[0], _bounds(problem, {})[0]
    arcs = Control.coerce(answer, [time, *(parameters or {})], time)
    read, sign = Steering(arcs, time, parameters), -1 if problem.maximise else 1
    costates = [sp.Dummy() for _ in problem.state]
    H, symbols = hamiltonian(problem, costates), [*problem.state, *costates, u]
    function = real_function(symbols, [H])
    flow = real_function(symbols, [*problem.field, *(-sp.diff(H, y) for y in problem.state)])
    last = real_function(problem.state, [-sign * sp.diff(problem.final, y) for y in problem.state])

    def advantage(steps):
        """By how much the control makes H greater than others do: a row for each step, a column for
        each of these."""
        y = np.array([float(v) for v in problem.initial.values()])
        for _, h, controls in steps:
            y = _step(lambda z, v: flow(*z, *np.zeros_like(z), v)[: len(z)], y, h, controls)
        z, rows = np.concatenate([y, last(*y)]), []
        for _, h, controls in reversed(steps):
            z = _step(lambda z, v: flow(*z, v), z, -h, controls[::-1])
            rows.append(
                function(*z, controls[0])[0] - function(*z, np.linspace(low, high, RIVALS))[0]
            )
        return np.array(rows[::-1])

    for case in sample_cases(parameters or {}):
        values = dict(zip(parameters or {}, case))
        where = f"for {rounded_text(values)} " if values else ""
        ends = read.ends(values)
        if ends and ends[-1] < float(problem.duration) * (1 - read.lasting):
            raise Wrong(
                f"{where}your last arc ends at {ends[-1]:.4g}, and the process lasts longer"
            )
        steps = _steps(read.sections(values, float(problem.duration)))
        for t, _, controls in steps:
            for value in controls:
                if not low - read.rounding <= value <= high + read.rounding:
                    raise Wrong(
                        f"{where}your control is {value:.4g} near t = {t:.4g}, outside its bounds"
                    )
        if start is not None and not abs(steps[0][2][0] - values[start]) <= read.rounding:
            raise Wrong(f"{where}your control begins with {steps[0][2][0]:.4g}")
        found = advantage(steps)
        others = [
            [advantage(_steps(side.sections(values, float(problem.duration)))) for side in sides]
            for sides in read.changed
        ]
        gained = sum(
            (
                reach(*(side - found for side in sides))[1]
                for sides in others
                if all(side.shape == found.shape for side in sides)
            ),
            np.zeros_like(found),
        )
        slack = 10 * read.rounding * (1 + np.abs(found).max())
        for k in np.flatnonzero((found + gained < -slack).any(axis=1))[-1:]:
            raise Wrong(
                f"{where}at t = {steps[k][0]:.4g} your control, with the costates that belong to "
                "it, gives an "
                f"H that is less by {-found[k].min():.4g} than another admissible one does"
            )
    return "it makes H greatest all the time, with the costates that belong to it"


def _steps(sections, count=120):
    """A control in small steps: (time, length, values at the beginning, middle and end)."""
    found = []
    for begin, end, u in sections:
        said, h = u(np.linspace(begin, end, 2 * count + 1)), (end - begin) / count
        found += [(begin + k * h, h, said[2 * k : 2 * k + 3]) for k in range(count)]
    return found


def _step(field, y, h, controls):
    """A step of the method of Runge and Kutta, the time counted in steps."""
    return rk4(lambda part, z: h * field(z, controls[round(2 * part)]), 0.0, y, 1.0)


def _arcs(problem, costates, control):
    arcs = singular_arcs(problem, control or problem.control[0], tuple(costates))
    if arcs.order is None:
        raise RuntimeError("no derivative of dH/du holds the control")
    return arcs


def _without_control(claim, arcs):
    if arcs.control in claim.free_symbols:
        raise Wrong(
            f"your expression contains {arcs.control} itself, on which nothing depends that is "
            "asked for here"
        )


def _points(arcs, domain):
    found = arcs.points(domain)
    if len(found) < 3:
        raise RuntimeError("no points of singular arcs were found")
    return found


class _Zeros:
    """The places where several expressions in `symbols` vanish."""

    def __init__(self, claims, symbols, parameters):
        self._symbols, self._parameters, self._count = symbols, parameters, len(claims)
        self._values = real_function([*symbols, *parameters], claims)
        self._slopes = real_function(
            [*symbols, *parameters], [sp.diff(e, s) for e in claims for s in symbols]
        )
        followed = perturbed(*claims) if in_decimals(*claims) else []
        self._most = POINTS if followed == [] else DECIMALS
        self._changed = [
            [real_function([*symbols, *parameters], side) for side in sides]
            for sides in followed or ()
        ]

    def left_open(self, values):
        """How far from them a point may be, counted as `distance` is, for what decimals leave
        open."""
        if not self._changed:
            return self._most
        numbers = [float(values[s]) for s in (*self._symbols, *self._parameters)]
        here, slopes = self._values(*numbers), self._slopes(*numbers).reshape(self._count, -1)
        moved = sum(
            np.fmax(*(abs(side(*numbers) - here) for side in sides)) for sides in self._changed
        )
        steps = moved / np.maximum(np.linalg.norm(slopes, axis=1), 1e-300)
        return float(
            np.fmin(
                self._most,
                POINTS + steps.max() / (1 + np.linalg.norm(numbers[: len(self._symbols)])),
            )
        )

    def distance(self, values):
        """How far a point is from them, as a share of its own size, to first order; infinite where
        undefined."""
        numbers = [float(values[s]) for s in (*self._symbols, *self._parameters)]
        rest, slopes = self._values(*numbers), self._slopes(*numbers).reshape(self._count, -1)
        if not (np.isfinite(rest).all() and np.isfinite(slopes).all()):
            return np.inf
        steps = [
            0.0 if r == 0 else abs(r) / max(np.linalg.norm(row), 1e-300)
            for r, row in zip(rest, slopes)
        ]
        return max(steps) / (1 + np.linalg.norm(numbers[: len(self._symbols)]))

    def near(self, values):
        """The place of zeros next to a point, as a dict, or None."""
        given = [float(values[s]) for s in self._parameters]
        point = np.array([float(values[s]) for s in self._symbols])
        for _ in range(80):  # at double zeros each step halves the distance
            rest, slopes = (
                self._values(*point, *given),
                self._slopes(*point, *given).reshape(self._count, -1),
            )
            if not (np.isfinite(rest).all() and np.isfinite(slopes).all()):
                return None
            step = np.linalg.lstsq(slopes, rest, rcond=1e-12)[0]
            point = point - step
            if np.linalg.norm(step) <= 1e-12 * (1 + np.linalg.norm(point)):
                found = values | dict(zip(self._symbols, point))
                return found if self.distance(found) < 1e-9 else None
        return None


# Small things.


@found_once
def _places(problem, costates, domain, controls=True, known=False):
    """Random values of all symbols, the controls on their bounds first; costates that are `known`
    may have their values."""
    random, values = np.random.default_rng(11), known_costates(problem, costates) if known else {}
    symbols = [
        *problem.state,
        *costates,
        *problem.parameters,
        *(problem.control if controls else ()),
    ]
    # Each symbol takes values all over its range.
    shares = {
        s: (random.permutation(PLACES) + random.uniform(size=PLACES)) / PLACES for s in symbols
    }
    for k in range(PLACES):
        place = {s: draw(random, s, domain, shares[s][k]) for s in symbols}
        if controls and k < 2:
            place |= {
                u: pair[k]
                for u, pair in zip(problem.control, _bounds(problem, place))
                if np.isfinite(pair[k])
            }
        yield place | {psi: float(value.subs(place)) for psi, value in values.items()}


@found_once
def _near_switching(problem, costates, domain):
    """Places next to those where a control does not enter H: a smooth imitation of a jump is seen
    there."""
    symbols = [*costates, *problem.state]
    for slope in (sp.diff(hamiltonian(problem, costates), u) for u in problem.control):
        if slope.free_symbols & set(problem.control):
            continue
        zeros = _Zeros([slope], symbols, list(problem.parameters))
        for values in itertools.islice(_places(problem, costates, domain, controls=False), 2):
            place = zeros.near(values)
            if place is not None and _allowed(place, domain):
                yield {s: v + NEXT_TO * (values[s] - v) for s, v in place.items()}


def _allowed(values, domain):
    """Whether values lie where those of their symbols may."""
    return all(low < values[s] < high for s in values for low, high in [ends(s, domain)])


def _equal(claim, true, values, what):
    true = sp.expand(true)
    parts = [abs(number_at(part, values)) for part in sp.Add.make_args(true)]
    said, wanted = value_at(claim, values, what), number_at(true, values).real
    if not agree(said, wanted, claim, size=max(parts), computed=EXACT):
        if true.is_number:  # the true number would be the answer itself
            raise Wrong(f"{what} is not {said:.4g}, which your expression gives")
        raise Wrong(
            f"for {rounded_text(values)}, {what} is {wanted:.4g}; your expression gives {said:.4g}"
        )


def _has_the_sign(claim, slope, control, known, domain):
    """Raise `Wrong` where a function has not the sign of dH/du, if that can be decided of all
    places: a factor may change its sign where none was tried. Where a sign changes in decimals is
    open."""
    if in_decimals(claim):
        return
    claim, slope = claim.subs(known), slope.subs(known)
    symbols = sorted({*claim.free_symbols, *slope.free_symbols}, key=str)
    given = sp.And(*(domain[s].as_relational(s) for s in symbols if s in (domain or {})))
    for sign, does, not_ in ((sp.Gt, "grows", "does not grow"), (sp.Lt, "falls", "does not fall")):
        _, place = decide(sign(claim, 0), symbols, exactly(sign(slope, 0), given))
        if place:
            values, holds = place
            raise Wrong(
                f"for {place_text(values)}, H {does if holds else not_} with {control}, and your "
                "function has another sign"
            )


def _vanish_together(claim, slope, problem, costates, domain):
    known = known_costates(problem, costates)
    symbols = [s for s in (*costates, *problem.state) if s not in known]
    own, other = (
        _Zeros([e.subs(known)], symbols, [*problem.parameters, *problem.control])
        for e in (claim, slope)
    )
    for values in _places(problem, costates, domain, known=True):
        for zeros, rival in ((own, other), (other, own)):
            place = zeros.near({s: v for s, v in values.items() if s not in known})
            if (
                place is not None
                and _allowed(place, domain)
                and not rival.distance(place) <= own.left_open(place)
            ):
                raise Wrong(
                    f"for {rounded_text(place)} your function "
                    + (
                        "vanishes, and dH/du does not"
                        if zeros is own
                        else "does not vanish, and dH/du does"
                    )
                )
    return "it has the sign of dH/du and vanishes with it"


def _difference(part, symbols):
    if isinstance(part, sp.Eq):
        return coercion.as_expression(part.lhs, symbols) - coercion.as_expression(part.rhs, symbols)
    return coercion.as_expression(part, symbols)


@found_once
def _on_target(problem):
    """States at the end, and parameters, as dicts."""
    zeros = (
        _Zeros(list(problem.terminal), list(problem.state), list(problem.parameters))
        if problem.terminal
        else None
    )
    random, found, symbols = np.random.default_rng(3), [], (*problem.state, *problem.parameters)
    for k in range(4 * PLACES):
        if k % PLACES == 0:  # each symbol takes values all over its range
            shares = {
                s: (random.permutation(PLACES) + random.uniform(size=PLACES)) / PLACES
                for s in symbols
            }
        values = {s: draw(random, s, None, shares[s][k % PLACES]) for s in symbols}
        place = zeros.near(values) if zeros else values
        if place is not None and len(found) < PLACES:
            found.append(place)
    if not found:
        raise RuntimeError("no point of the target was found")
    return found


def _affine_rows(claims, costates, values):
    """Rows (coefficients of the costates, constant) of conditions at an end. A sum of squares
    vanishes where all of them do."""
    rows, zero = [], dict.fromkeys(costates, 0)
    for claim in claims:
        put = sp.expand(claim.subs(values))
        row = [sp.diff(put, psi) for psi in costates]
        if any(sp.diff(c, psi).free_symbols for c in row for psi in costates):
            raise Invalid("expected conditions that are linear in the costates, or sums of squares")
        bends = np.array(
            [[number_at(sp.diff(c, psi), {}).real for psi in costates] for c in row], dtype=float
        )
        slopes, rest = ([number_at(c.subs(zero), {}).real for c in part] for part in (row, [put]))
        rows += _squares(bends, np.array(slopes), *rest) if bends.any() else [[*slopes, *rest]]
    return np.array(rows, dtype=float).reshape(len(rows), len(costates) + 1)


def _squares(bends, slopes, rest):
    """The rows that vanish where psi.bends.psi/2 + slopes.psi + rest does, which is to be its least
    or greatest value, zero."""
    least, (sizes, _) = np.linalg.lstsq(bends, -slopes, rcond=1e-9)[0], np.linalg.eigh(bends)
    size = np.abs(bends).max()
    if (
        (sizes.min() < -1e-9 * size and sizes.max() > 1e-9 * size)
        or not np.allclose(bends @ least, -slopes)
        or not abs(rest + slopes @ least / 2)
        <= 1e-9 * (abs(rest) + abs(slopes) @ abs(least) + size)
    ):
        raise Invalid("expected conditions that are linear in the costates, or sums of squares")
    return np.column_stack([bends, slopes]).tolist()


def _kernel(rows):
    """An orthonormal basis of the vectors that all rows are orthogonal to, as rows."""
    _, sizes, basis = np.linalg.svd(rows)
    return basis[int((sizes > 1e-9 * sizes.max(initial=0)).sum()) :]


def _rank(rows):
    if not rows.size:
        return 0
    rows = rows / np.maximum(np.abs(rows).max(axis=1, keepdims=True), 1e-300)
    sizes = np.linalg.svd(rows, compute_uv=False)
    return int((sizes > 1e-6 * max(sizes.max(), 1.0)).sum())


def _bounds(problem, values):
    return [
        tuple(
            float(at_once(b, values)) if b.is_finite is not False else np.inf * (1 if k else -1)
            for k, b in enumerate(pair)
        )
        for pair in problem.controls.values()
    ]


def _rivals(value, low, high):
    """Admissible controls with which one is compared: all over its interval, and around it."""
    low, high = max(low, value - UNBOUNDED), min(high, value + UNBOUNDED)
    around = (1 + abs(value)) * np.geomspace(1e-4, 0.1, 13)
    return np.unique(
        np.concatenate(
            [
                np.linspace(low, high, RIVALS),
                np.clip([value - around, value + around], low, high).ravel(),
            ]
        )
    )

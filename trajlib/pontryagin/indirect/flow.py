"""Flow of states and costates along an arc, to rounding error, with exact derivatives.

The kinds, one for each control: "u-" and "u+" (at a bound), "boundary" (of a state constraint; see
`boundary_arc`), "interior" (dH/du = 0 between the bounds; the direction of a zero thrust has the
limit of those of weak thrusts) and "singular" (H linear in u, dH/du = 0 on the arc). On an interior
arc the control w is a further component of the flow,

    w' = -(d2H/du2)^-1 d/dt(dH/du with u held),

so that no equation has to be solved on the way and no root be chosen. An angle whose part of H
vanishes at one instant jumps there by half a turn: where it is constant before and after, the arcs
are "ahead" (u = w) and "back" (u = w + pi) with w' = 0 (motion along a line under a thrust that
only reverses). The integrator is the extrapolated explicit midpoint rule (Gragg) with 2, 4, 6 and 8
substeps, of order 8; it needs no table of coefficients.
"""

from functools import cached_property

import numpy as np

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.indirect.boundary_arc import boundary_conditions, boundary_control
from trajlib.pontryagin.problem.arcs import BOUNDARY, CONSTANT_ANGLES, boundary_constraint
from trajlib.pontryagin.problem.errors import NotUnique, WrongStructure
from trajlib.pontryagin.problem.numeric import NumericProblem

_SUBSTEPS = (2, 4, 6, 8)


class ArcFlow:
    """The flow of y = (x, psi, w) along arcs of given kinds (a tuple, one for each control).

    Attributes
    ----------
    control : casadi.SX
        The controls as an expression in `y` and `multiplier`.
    entry : casadi.SX
        Expressions that vanish where an arc begins: dH/du for interior controls, the switching
        function and its derivatives for singular ones.
    size : int
        Length of y.
    orders : dict
        {index of a singular control: q}.
    boundary, touch : int or None
        The path constraint that is active along the arc; the one that is touched at its beginning.
    """

    def __init__(self, numeric: NumericProblem, kinds: tuple[str, ...], touch: int | None = None):
        self.numeric, self.kinds = numeric, kinds
        self.boundary, self.touch = boundary_constraint(kinds), touch
        self.interior = [
            i
            for i, kind in enumerate(kinds)
            if kind == "interior"
            or kind in CONSTANT_ANGLES
            or (kind.startswith(BOUNDARY) and not numeric.affine[i])
        ]
        self.singular = [i for i, kind in enumerate(kinds) if kind == "singular"]
        self.w = ca.SX.sym("w", len(self.interior))
        self.y = ca.vertcat(numeric.x, numeric.psi, self.w)
        self.size = 2 * numeric.n + len(self.interior)
        self.orders = {}
        control = ca.SX(numeric.k, 1)
        for i, kind in enumerate(kinds):
            bound = {"u-": numeric.lower[i], "u+": numeric.upper[i]}.get(kind, 0.0)
            if not np.isfinite(bound):
                raise WrongStructure(
                    f"an arc {kind} of {numeric.problem.control[i]}, which has no such bound"
                )
            control[i] = bound
        for component, i in enumerate(self.interior):
            control[i] = self.w[component] + CONSTANT_ANGLES.get(kinds[i], 0.0)
        conditions = []
        for i in self.singular:
            derivatives, value = singular_control(numeric, i, control, kinds)
            self.orders[i] = len(derivatives) // 2
            conditions += derivatives
            control[i] = value
        for i in self._solved_for_boundary:
            derivatives, value = boundary_control(numeric, self.boundary, i, control)
            conditions += derivatives
            control[i] = value
        self.control = control
        self.stationary = {i: self._stationary(i) for i in self.interior}
        for i in self.interior:
            conditions += (
                constant_angle_conditions(numeric, i)
                if kinds[i] in CONSTANT_ANGLES
                else [self.stationary[i]]
            )
        if touch is not None:
            g = numeric.path[touch]
            conditions += [g, ca.jtimes(g, numeric.x, numeric.field)]
        conditions = list(map(self._with_control, conditions))
        self.path_multiplier = ca.SX(0)
        if self.boundary is not None:
            conditions += self._boundary_conditions()
        self.entry = ca.vertcat(*conditions)

    @property
    def _solved_for_boundary(self):
        """The controls that g^(p) = 0 determines: at most one."""
        return [
            i
            for i, kind in enumerate(self.kinds)
            if kind.startswith(BOUNDARY) and i not in self.interior
        ]

    def _boundary_conditions(self):
        """Set `path_multiplier`; return the conditions that it keeps."""
        numeric = self.numeric
        order, solved = numeric.path_orders[self.boundary], self._solved_for_boundary
        moving = ca.vertcat(*(self.stationary[i] for i in self.interior))
        if self.singular or (
            solved and self.interior and any(ca.which_depends(moving, numeric.u[solved[0]]))
        ):
            raise WrongStructure(
                "a boundary arc while another control that acts on the same condition moves between "
                "its bounds: such arcs are not provided for"
            )
        expression = numeric.slopes[solved[0]] if solved else numeric.path[self.boundary]
        conditions, self.path_multiplier = boundary_conditions(
            self, self._with_control(expression), order if solved else 2 * order
        )
        return conditions

    def continues(self, left: "ArcFlow") -> bool:
        """Check whether a segment with this flow continues the arc of the segment before."""
        return self.kinds == left.kinds and self.touch is None

    def _with_control(self, expression):
        return ca.substitute(expression, self.numeric.u, self.control)

    def _stationary(self, i):
        """Return the expression that vanishes for an interior control: dH/du_i.

        Where it vanishes for every u_i, since another control is zero (the direction of a zero
        thrust), its derivative with respect to that control.
        """
        numeric, slope = self.numeric, self.numeric.slopes[i]
        for j, kind in enumerate(self.kinds):
            off = (
                kind in ("u-", "u+")
                and numeric.affine[j]
                and ca.which_depends(slope, numeric.u[j])[0]
            )
            if off and _vanishes(numeric, ca.substitute(slope, numeric.u[j], self.control[j])):
                return ca.jacobian(slope, numeric.u[j])
        return slope

    @cached_property
    def rate(self):
        """y', an expression in y and lambda_0."""
        return self.rate_with(self.path_multiplier)

    def rate_with(self, path_multiplier):
        """Return y' for a multiplier of the path constraint that is active along the arc."""
        numeric = self.numeric
        adjoint = numeric.adjoint
        if self.boundary is not None:
            adjoint += path_multiplier * ca.gradient(numeric.path[self.boundary], numeric.x)
        motion = ca.vertcat(numeric.field, adjoint)
        if self.interior:
            moving = [i for i in self.interior if self.kinds[i] not in CONSTANT_ANGLES]
            slopes, free = ca.vertcat(*(self.stationary[i] for i in moving)), numeric.u[moving]
            drift = ca.jtimes(slopes, ca.vertcat(numeric.x, numeric.psi), motion)
            turning = ca.SX(numeric.k, 1)
            turning[moving] = -ca.solve(ca.jacobian(slopes, free), drift) if moving else 0
            motion = ca.vertcat(motion, turning[self.interior])
        return self._with_control(motion)

    @cached_property
    def functions(self):
        """{name: function of (y, lambda_0)}: control, hamiltonian, slopes (dH/du), entry."""
        numeric, arguments = self.numeric, [self.y, self.numeric.multiplier]
        hamiltonian = self._with_control(numeric.hamiltonian)
        variables = ca.vertcat(self.y, numeric.multiplier)
        slopes = self._with_control(numeric.slopes)
        return {
            "control": ca.Function("control", arguments, [self.control]),
            "path multiplier": ca.Function("eta", arguments, [self.path_multiplier]),
            "hamiltonian": ca.Function(
                "hamiltonian", arguments, [hamiltonian, ca.jacobian(hamiltonian, variables)]
            ),
            "slopes": ca.Function("slopes", arguments, [slopes, ca.jacobian(slopes, variables)]),
            "entry": ca.Function(
                "entry", arguments, [self.entry, ca.jacobian(self.entry, variables)]
            ),
        }

    @cached_property
    def step(self):
        """Function (y with the cost, lambda_0, h) -> the same after time h."""
        cost, h = ca.SX.sym("cost"), ca.SX.sym("h")
        rate = ca.Function(
            "rate",
            [self.y, self.numeric.multiplier],
            [ca.vertcat(self.rate, self._with_control(self.numeric.density))],
        )
        full = ca.vertcat(self.y, cost)
        after = extrapolated_midpoint(
            lambda z: rate(z[: self.size], self.numeric.multiplier), full, h
        )
        return ca.Function("step", [full, self.numeric.multiplier, h], [after])

    @cached_property
    def variational_step(self):
        """Function (y with its derivatives by start and lambda_0; lambda_0, h) -> the same after h."""
        size, h = self.size, ca.SX.sym("h")
        Phi = ca.SX.sym("Phi", size, size + 1)
        arguments = ca.vertcat(self.y, self.numeric.multiplier)
        linear = ca.jacobian(self.rate, arguments)
        # d/dt dy/d(start, lambda_0) = f_y dy/d(start, lambda_0) + (0, f_lambda)
        growth = ca.mtimes(linear[:, :size], Phi) + ca.horzcat(ca.SX(size, size), linear[:, size])
        joined = ca.vertcat(self.y, ca.vec(Phi))
        rate = ca.Function(
            "rate", [joined, self.numeric.multiplier], [ca.vertcat(self.rate, ca.vec(growth))]
        )
        after = extrapolated_midpoint(lambda z: rate(z, self.numeric.multiplier), joined, h)
        return ca.Function("step", [joined, self.numeric.multiplier, h], [after])

    def nodes(self, start, multiplier, length, steps, fractions=None):
        """Return y and the cost at the ends of the steps, (steps+1, size+1).

        The steps are equal, or end at the given `fractions` of the length, (steps,).
        """
        widths = (
            length / steps
            if fractions is None
            else ca.DM(length * np.diff(fractions, prepend=0.0)).T
        )
        after = self._accumulated("step", steps)(start, multiplier, widths).full()
        return np.vstack([start, after.T])

    def values(self, name, points, multiplier):
        """Evaluate one of `functions` at several points (columns)."""
        value = self.functions[name].map(points.shape[1])(points, multiplier)
        return (value[0] if isinstance(value, (tuple, list)) else value).full()

    def transition(self, start, multiplier, length, steps):
        """Return the end of the arc and its derivatives by the start, lambda_0 and the length.

        Their shapes are (size,), (size, size), (size,), (size,).
        """
        size = self.size
        joined = np.concatenate([start, np.eye(size, size + 1).ravel(order="F")])
        after = (
            self._accumulated("variational_step", steps)(joined, multiplier, length / steps)[:, -1]
            .full()
            .ravel()
        )
        end, Phi = after[:size], after[size:].reshape(size, size + 1, order="F")
        return end, Phi[:, :size], Phi[:, size], self._rate_function(end, multiplier).full().ravel()

    @cached_property
    def _rate_function(self):
        return ca.Function("rate", [self.y, self.numeric.multiplier], [self.rate])

    def _accumulated(self, name, steps):
        mapaccums = self.__dict__.setdefault("_mapaccums", {})
        if (name, steps) not in mapaccums:
            mapaccums[name, steps] = getattr(self, name).mapaccum(f"{name}s", steps)
        return mapaccums[name, steps]


def extrapolated_midpoint(rate, start, h):
    """Return one step of length h of y' = rate(y) by the extrapolated midpoint rule.

    The explicit midpoint rule with 2, 4, 6, 8 substeps is extrapolated to h -> 0.
    """
    slope, result = rate(start), start
    for m in _SUBSTEPS:
        # Increments are extrapolated instead of values: the weights add up to one, and rounding
        # errors are those of the increments.
        previous, current = 0 * start, h / m * slope
        for _ in range(m - 1):
            previous, current = current, previous + 2 * h / m * rate(start + current)
        weight = np.prod([m**2 / (m**2 - o**2) for o in _SUBSTEPS if o != m])
        result = result + weight * current
    return result


def singular_control(numeric, i, control, kinds):
    """Return dH/du with its derivatives of orders 0 to 2q-1 for control i, and the control -a/b.

    Expressions in x, psi, lambda_0; controls at their bounds have the values in `control`. Raises
    `NotUnique` if no derivative contains the control, `WrongStructure` if another control that is
    not at a bound acts on them, or if all of them vanish for zero multipliers only: then the control is
    at its bounds, as in every controllable linear plant, and there is no such arc.
    """
    if not numeric.affine[i]:
        raise WrongStructure(
            f"a singular arc of {numeric.problem.control[i]}, in which H is not linear"
        )
    motion = ca.vertcat(numeric.field, numeric.adjoint)
    # numeric.u[i] remains a symbol; bounds are constants of the arc. A control that moves along the
    # arc must not act here.
    bounded = [j for j in range(numeric.k) if j != i and kinds[j] in ("u-", "u+")]
    moving = [numeric.u[j] for j in range(numeric.k) if j != i and j not in bounded]
    fixed = ca.vertcat(*(numeric.u[j] for j in bounded)), ca.vertcat(*(control[j] for j in bounded))
    motion, slope = (
        ca.substitute(e, *fixed) if bounded else e for e in (motion, numeric.slopes[i])
    )
    u, point = numeric.u[i], ca.vertcat(numeric.x, numeric.psi)
    derivatives = [slope]
    for order in range(1, 2 * numeric.n + 1):
        derivative = ca.jtimes(derivatives[-1], point, motion)
        if any(
            not _vanishes(numeric, ca.jacobian(derivative, control_symbol))
            for control_symbol in moving
        ):
            raise WrongStructure(
                f"a singular arc of {numeric.problem.control[i]} while another control moves "
                "between its bounds acts on it: such arcs are not provided for"
            )
        factor = ca.jacobian(derivative, u)
        if order % 2 == 0 and not _vanishes(numeric, factor):
            return derivatives, -_without(derivative, u, moving) / _without(factor, u, moving)
        derivatives.append(_without(derivative, u, moving))
    name = numeric.problem.control[i]
    if _zero_multipliers_only(numeric, derivatives):
        raise WrongStructure(
            f"{name} has no singular arc, since the maximum condition leaves it open at single instants "
            "only; where the grid shows such an arc, switchings nearly coincide"
        )
    raise NotUnique(
        f"the maximum condition leaves {name} open on an arc: its switching function vanishes there "
        "whatever it does"
    )


def _zero_multipliers_only(numeric, derivatives):
    """Check whether expressions linear in (psi, lambda_0), and H of a free final time, have no common zero.

    At fixed points as in `_vanishes`: for a nonlinear plant true but for exceptional states.
    """
    free_time = [numeric.hamiltonian] if numeric.problem.free_time else []
    multipliers = ca.vertcat(numeric.psi, numeric.multiplier)
    rows = ca.jacobian(ca.vertcat(*derivatives, *free_time), multipliers)
    # Shares of the largest entry of a row: the derivatives have units of their own.
    values = [
        value / np.maximum(abs(value).max(axis=1, keepdims=True), 1e-300)
        for value in _at_fixed_points(numeric, rows)
    ]
    return all(np.linalg.matrix_rank(value, tol=1e-9) == numeric.n + 1 for value in values)


def constant_angle_conditions(numeric, i):
    """Return dH/du of a constant angle and its time derivatives, which vanish on its arc."""
    motion, point = ca.vertcat(numeric.field, numeric.adjoint), ca.vertcat(numeric.x, numeric.psi)
    derivatives = [numeric.slopes[i]]
    for _ in range(2 * numeric.n - 1):
        derivative = ca.jtimes(derivatives[-1], point, motion)
        if _vanishes(numeric, derivative):
            break
        derivatives.append(derivative)
    return derivatives


def _without(expression, u, moving):
    """Set controls to zero that do not act on an expression."""
    symbols = ca.vertcat(u, *moving)
    return ca.substitute(expression, symbols, ca.SX.zeros(symbols.numel()))


def _vanishes(numeric, factor):
    """Check whether an expression is zero identically, by its values at fixed points.

    Lie brackets cancel only after simplification.
    """
    if factor.nnz() == 0:
        return True
    return max(np.abs(value).max() for value in _at_fixed_points(numeric, factor)) < 1e-9


def _at_fixed_points(numeric, expression):
    """Return the values of an expression at four fixed points near the initial state."""
    arguments = [numeric.x, numeric.psi, numeric.u, numeric.multiplier]
    function = ca.Function("values", arguments, [expression])
    random = np.random.default_rng(0)
    centre = numeric.assumed_start
    return [
        function(
            centre + 0.1 * random.standard_normal(numeric.n) * (1 + np.abs(centre)),
            random.standard_normal(numeric.n),
            numeric.middle(),
            1.0,
        ).full()
        for _ in range(4)
    ]

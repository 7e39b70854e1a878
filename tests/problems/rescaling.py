"""The same problem in other units, with the answers to it, by the name of the check.

States x become l x, times T t, costs s J + c. What is multiplied by a factor is the symbol itself:
`x` in the rescaled problem is the number of the new units.
"""

import dataclasses
import inspect

import sympy as sp
from sympy.logic.boolalg import Boolean, BooleanAtom

from workbook import checks
from workbook.checks.references.singular_arcs import singular_arcs
from workbook.systems import Quadratic


@dataclasses.dataclass(frozen=True)
class Units:
    """Factors of times, states and costs, and a constant that is added to the cost."""

    time: sp.Rational = sp.S.One
    length: sp.Rational = sp.S.One
    cost: sp.Rational = sp.S.One
    constant: sp.Rational = sp.S.Zero


#: One change of units at a time, so that a failure names its cause.
CHANGES = {
    "cost * 1e-9": Units(cost=sp.Rational(1, 10**9)),
    "cost * 1e9": Units(cost=sp.Integer(10) ** 9),
    "cost + 1000": Units(constant=sp.Integer(1000)),
    "time * 1e4": Units(time=sp.Integer(10) ** 4),
    "time * 1e-4": Units(time=sp.Rational(1, 10**4)),
    "length * 1e6": Units(length=sp.Integer(10) ** 6),
    "length * 1e-6": Units(length=sp.Rational(1, 10**6)),
}


class NoRule(Exception):
    """Raised for a call of a check that no rule rescales."""


class Rescaled:
    """The data of a check in other units.

    `factors` are those of symbols: of states, controls, costates, time, and of the parameters that
    are initial values, durations or bounds. All other parameters stay numbers.
    """

    def __init__(self, arguments, units):
        self.time, self.cost, self.constant = units.time, units.cost, units.constant
        self.factors = {}
        self._of_record(arguments, units)
        if "costates" in arguments:
            self.factors |= dict(
                zip(arguments["costates"], (self.cost / self.factors[x] for x in self.state))
            )
        for name in ("time", "duration"):
            if isinstance(arguments.get(name), sp.Symbol):
                self.factors[arguments[name]] = self.time
        self.arguments = {
            name: ARGUMENTS[name](self, value) if name in ARGUMENTS and value is not None else value
            for name, value in arguments.items()
        }

    def value(self, written, factor=1):
        """Return an answer, or a part of one, in the new units, times a factor or factors."""
        if isinstance(written, (bool, str, BooleanAtom, type(None))):
            return written
        if isinstance(written, (list, tuple)):
            factors = factor if isinstance(factor, list) else [factor] * len(written)
            return type(written)(self.value(*pair) for pair in zip(written, factors))
        if isinstance(written, dict):
            return {key: self.value(part, factor) for key, part in written.items()}
        if isinstance(written, sp.MatrixBase):
            factors = factor if isinstance(factor, list) else [factor] * len(written)
            return type(written)(
                *written.shape, [self.value(*pair) for pair in zip(written, factors)]
            )
        if isinstance(written, sp.Set):
            return _scaled(written, factor)
        put = {s: s / f for s, f in self.factors.items() if f != 1}
        written = sp.sympify(written)
        if isinstance(written, sp.Eq):
            return sp.Eq(*(e.subs(put, simultaneous=True) for e in written.args), evaluate=False)
        written = written.subs(put, simultaneous=True)
        holds = isinstance(written, Boolean) and not written.is_Symbol
        return written if holds else factor * written

    def domain(self, domain):
        """Return intervals or sets of symbols in the new units."""
        if not isinstance(domain, dict):
            return domain
        return {s: _scaled(values, self.factors.get(s, 1)) for s, values in domain.items()}

    def points(self, points):
        """Return points of the plane, or expressions that vanish on a target."""
        if all(isinstance(point, (list, tuple)) for point in points):
            return [self.value(list(point), self.of_state) for point in points]
        return self.value(list(points))

    @property
    def of_state(self):
        """The factors of the states, a list."""
        return [self.factors[x] for x in self.state]

    @property
    def of_control(self):
        """The factor of the first control."""
        return self.factors[self.control[0]]

    def _of_record(self, arguments, units):
        problem = arguments.get("problem", arguments.get("system"))
        self.state, self.control = list(problem.dynamics), list(problem.controls)
        running, final = getattr(problem, "running", 1), getattr(problem, "final", 0)
        if running == 1 and final == 0 and units.cost == 1:
            self.cost = units.time  # the cost is the time, in its units
        self._of_states(problem.dynamics, sp.Tuple(*problem.field, running, final), units)
        for u in self.control:
            rates = [x for x, f in problem.dynamics.items() if f == u]
            self.factors[u] = self.factors[rates[0]] / units.time if rates else sp.S.One
        for name in ("parameters", "unknown"):
            if isinstance(arguments.get(name), dict):
                self._of_parameters(problem, arguments[name])

    def _of_states(self, dynamics, expressions, units):
        """A state whose rate is another state, or 1, has units that go with these; an angle none."""
        arguments = expressions.atoms(sp.Function)
        for x in dynamics:
            if x in self.factors:
                continue
            angle = any(x in f.free_symbols and not isinstance(f, sp.Abs) for f in arguments)
            factor = sp.S.One if angle else units.length
            if dynamics[x] == 1:
                factor = units.time
            while x in dynamics and x not in self.factors:
                self.factors[x] = factor
                x, factor = dynamics[x], factor / units.time

    def _of_parameters(self, problem, parameters):
        initial = getattr(problem, "initial", {})
        for value, factor in [
            *((value, self.factors[x]) for x, value in initial.items()),
            (getattr(problem, "duration", None), self.time),
            *((b, self.factors[u]) for u, pair in problem.controls.items() for b in pair),
        ]:
            if value in parameters and value not in self.factors:
                self.factors[value] = factor

    def problem(self, problem):
        """Return a problem in the new units."""
        value, factors = self.value, self.factors
        pair = isinstance(problem.duration, tuple)
        times = [
            None if d is None else value(d, self.time)
            for d in (problem.duration if pair else (problem.duration,))
        ]
        return dataclasses.replace(
            problem,
            **self._motion(problem),
            initial={
                x: None if v is None else value(v, factors[x]) for x, v in problem.initial.items()
            },
            terminal=[value(g) for g in problem.terminal],
            running=value(problem.running, self.cost / self.time),
            final=value(problem.final, self.cost) + self.constant,
            duration=tuple(times) if pair else times[0],
        )

    def system(self, system):
        """Return a `Controlled` system in the new units."""
        return dataclasses.replace(system, **self._motion(system))

    def _motion(self, record):
        return {
            "dynamics": {
                x: self.value(f, self.factors[x] / self.time) for x, f in record.dynamics.items()
            },
            "controls": {
                u: tuple(self.value(b, self.factors[u]) for b in bounds)
                for u, bounds in record.controls.items()
            },
        }


class RescaledField(Rescaled):
    """The data of a check on the vector field of a phase plane in other units."""

    def _of_record(self, arguments, units):
        if units.length != 1:
            raise NoRule("points of a phase plane have no common form of an answer")
        self.state = list(arguments["state"])
        field = sp.Tuple(*arguments["field"])
        self._of_states(dict(zip(self.state, field)), field, units)

    def system(self, field):
        """Return the right-hand sides in the new units."""
        return self.value(list(field), [f / self.time for f in self.of_state])


class RescaledFunctional(Rescaled):
    """The data of a check on a `Functional` in other units."""

    def _of_record(self, arguments, units):
        self.motion = units.length
        self.factors[arguments["functional"].time] = units.time

    def functional(self, functional):
        """Return the functional in the new units."""
        time, begin, end = functional.interval
        rates = [self.motion / self.time**k for k in range(functional.order + 1)]

        def value(written, at, factor):
            parts = {
                (d if at is None else d.subs(time, at)): sp.Dummy() for d in functional.derivatives
            }
            written = written.subs(dict(reversed(parts.items())))
            written = self.value(written, factor)
            back = functional.derivatives
            if at is not None:
                back = [d.subs(time, self.value(at, self.time)) for d in back]
            return written.subs(
                {s: d / f for s, d, f in zip(parts.values(), back, rates)}, simultaneous=True
            )

        return dataclasses.replace(
            functional,
            integrand=value(functional.integrand, None, self.cost / self.time),
            interval=(time, self.value(begin, self.time), self.value(end, self.time)),
            start=self.value(functional.start, rates),
            end=self.value(functional.end, rates),
            final=value(functional.final, end, self.cost) + self.constant,
        )


class RescaledQuadratic(Rescaled):
    """The data of a check on a `Quadratic` problem in other units; all states have the same."""

    def _of_record(self, arguments, units):
        self.length = units.length
        if self.constant:
            raise NoRule("a quadratic cost has no constant term")

    def problem(self, problem):
        """Return the problem in the new units; the control keeps its own."""
        square = self.cost / self.length**2
        return dataclasses.replace(
            problem,
            A=self.value(problem.A, 1 / self.time),
            B=self.value(problem.B, self.length / self.time),
            G=self.value(problem.G, square / self.time),
            N=self.value(problem.N, self.cost / self.time),
            F=self.value(problem.F, square),
            duration=problem.duration
            if problem.duration == sp.oo
            else self.value(problem.duration, self.time),
        )


#: What becomes of an argument of a check, by its name.
ARGUMENTS = {
    "problem": lambda new, problem: new.problem(problem),
    "system": lambda new, system: new.system(system),
    "field": lambda new, field: new.system(field),
    "functional": lambda new, functional: new.functional(functional),
    "parameters": Rescaled.domain,
    "domain": Rescaled.domain,
    "unknown": Rescaled.domain,
    "target": Rescaled.points,
    "ends": lambda new, ends: new.value(ends, new.of_state),
    "curve": lambda new, curve: (
        curve[0],
        new.value(curve[1], new.of_state[0]),
        new.value(curve[2], new.of_state),
        *curve[3:],
    ),
    "law": lambda new, law: new.value(law, new.of_control),
    "quantity": Rescaled.value,
    "expression": Rescaled.value,
}


def rescaled(name, answer, data, options, units):
    """Return an answer and the data of the check `name` in other units.

    Raises
    ------
    NoRule
        If no rule is known for the check, or for this form of answer.
    """
    if name not in RULES:
        raise NoRule(name)
    bound = inspect.signature(getattr(checks, name)).bind(answer, *data, **options)
    bound.apply_defaults()
    arguments = dict(list(bound.arguments.items())[1:])
    record = Rescaled
    if isinstance(arguments.get("problem"), Quadratic):
        record = RescaledQuadratic
    elif "field" in arguments:
        record = RescaledField
    elif "functional" in arguments:
        record = RescaledFunctional
    new = record(arguments, units)
    return RULES[name](new, answer, new.arguments), new.arguments


def _scaled(values, factor):
    if factor == 1:
        return values
    if isinstance(values, sp.FiniteSet):
        return sp.FiniteSet(*(factor * value for value in values))
    return sp.Interval(
        factor * values.start, factor * values.end, values.left_open, values.right_open
    )


def _times(factor):
    """Return the rule of an answer that is multiplied by a factor, or by one for each entry."""
    return lambda new, answer, arguments: new.value(answer, factor(new))


def _control(new, answer, arguments):
    if isinstance(answer, (list, tuple)):  # arcs: [value, until]
        return [new.value(list(arc), [new.of_control, new.time]) for arc in answer]
    return new.value(answer, new.of_control)


def _several(factors):
    """Return the rule of an answer with one entry for each state; of one alone, no list."""

    def rule(new, answer, arguments):
        several = isinstance(answer, (list, tuple, sp.MatrixBase))
        return new.value(answer, factors(new) if several else factors(new)[0])

    return rule


def _curve(new, answer, arguments):
    ((variable, _),) = arguments["domain"].items()
    (other,) = set(new.state) - {variable}
    return new.value(answer, new.factors[other])


def _arc(new, answer, arguments):
    arguments["value"] = new.value(arguments["value"], new.factors[arguments["control"]])
    return new.value(answer, new.time)


def _gain(new, answer, arguments):
    return new.value(answer, 1 / new.length)


def _maximum(new, answer, arguments):
    if isinstance(answer, (list, tuple)):
        return new.value(answer, [new.factors[u] for u in new.control])
    return new.value(answer, new.of_control)


def _slopes(new):
    first, second = new.of_state
    return second / first


def _matrix(new, answer, arguments):
    factors = new.of_state
    return new.value(answer, [f / g / new.time for f in factors for g in factors])


def _crossing(new):
    first, second = new.of_state
    return first * second / new.time


def _singular(new, answer, arguments):
    return new.value(answer, new.factors[arguments["control"] or new.control[0]])


def _kelley(new, answer, arguments):
    control = arguments["control"] or new.control[0]
    order = singular_arcs(arguments["problem"], control, tuple(arguments["costates"])).order
    return new.value(answer, new.cost / new.factors[control] ** 2 / new.time ** (2 * order + 1))


UNCHANGED, TIME = _times(lambda new: 1), _times(lambda new: new.time)
COST, CONTROL = _times(lambda new: new.cost), _times(lambda new: new.of_control)
RATE_OF_COST = _times(lambda new: new.cost / new.time)
COSTATES = _several(lambda new: [new.cost / f for f in new.of_state])

RULES = {
    # processes
    "optimal_control": _control,
    "extremal_control": _control,
    "optimal_motion": _several(lambda new: new.of_state),
    "motion_under_law": _several(lambda new: new.of_state),
    "optimal_costate": COSTATES,
    "optimal_law": CONTROL,
    "optimal_cost": lambda new, answer, _: new.value(answer, new.cost) + new.constant,
    "optimal_duration": TIME,
    "optimal_range": UNCHANGED,
    "initial_arc_duration": _arc,
    "arc_transition_curve": _curve,
    "final_value_under_law": UNCHANGED,
    "duration_equation": UNCHANGED,
    # the maximum principle
    "pontryagin_function": RATE_OF_COST,
    "maximised_hamiltonian": RATE_OF_COST,
    "adjoint_equations": _several(lambda new: [new.cost / f / new.time for f in new.of_state]),
    "transversality": UNCHANGED,
    "maximising_control": _maximum,
    "control_equation": _times(lambda new: new.of_control / new.time),
    "switching_function": RATE_OF_COST,
    "switching_rate": _times(lambda new: new.cost / new.of_control / new.time**2),
    "singular_control": _singular,
    "singular_surface": UNCHANGED,
    "singular_costates": COSTATES,
    "singular_order": UNCHANGED,
    "kelley_expression": _kelley,
    "kelley_holds": UNCHANGED,
    # feedback in least time
    "time_optimal_law": CONTROL,
    "minimal_time": TIME,
    "reachable_initial_states": UNCHANGED,
    "reached_target_points": UNCHANGED,
    "minimal_time_continuous": UNCHANGED,
    "switching_curve": _curve,
    "barrier": _curve,
    "dispersal_curve": _curve,
    "switching_points": _times(lambda new: new.of_state),
    "switching_curve_crossing": _times(_crossing),
    "other_extremal_exists": UNCHANGED,
    "other_extremal_time": TIME,
    # transfers in least time
    "optimal_switching": _times(lambda new: new.cost / new.time / new.of_control),
    "isochrone_radius": _several(lambda new: new.of_state),
    "switching_interval": TIME,
    "switching_count": UNCHANGED,
    "transferable_initial_states": UNCHANGED,
    "reachable_in_time": UNCHANGED,
    "meeting_time": TIME,
    "polar_angle_rate": None,
    "least_rate": _times(lambda new: 1 / new.time),
    # the calculus of variations
    "extremum_motion": _times(lambda new: new.motion),
    "extremum_value": lambda new, answer, _: new.value(answer, new.cost) + new.constant,
    "extremum_exists": UNCHANGED,
    "stationary_duration": TIME,
    # quadratic costs
    "optimal_gain": _gain,
    "optimal_eigenvalues": _times(lambda new: 1 / new.time),
    "cost_matrix": _times(lambda new: new.cost / new.length**2),
    # phase planes
    "first_integral": UNCHANGED,
    "stationary_points": UNCHANGED,
    "stationary_type": UNCHANGED,
    "stationary_stability": UNCHANGED,
    "stationary_linearisation": _matrix,
    "equilibrium_types": UNCHANGED,
    "saddle_slopes": _times(_slopes),
}

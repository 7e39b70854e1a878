"""The same problem in other units, with the answers to it, by the name of the check.

States x become l x, times T t, costs s J + c. What is multiplied by a factor is the symbol itself:
`x` in the rescaled problem is the number of the new units.
"""

import dataclasses
import inspect

import sympy as sp

from workbook import checks


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
    """A problem of optimal control in other units."""

    def __init__(self, problem, parameters, units):
        self.time, self.cost, self.constant = units.time, units.cost, units.constant
        if problem.running == 1 and problem.final == 0 and units.cost == 1:
            self.cost = units.time  # the cost is the time, in its units
        self.factors = self._of_states(problem, units)
        for u in problem.control:
            rates = [x for x, f in problem.dynamics.items() if f == u]
            self.factors[u] = self.factors[rates[0]] / units.time if rates else sp.S.One
        if isinstance(parameters, dict):
            self._of_parameters(problem, parameters)
        self.problem = self._problem(problem)
        self.parameters = (
            {p: _scaled(domain, self.factors.get(p, 1)) for p, domain in parameters.items()}
            if isinstance(parameters, dict)
            else parameters
        )

    def _of_states(self, problem, units):
        """A state whose rate is another state, or 1, has units that go with these; an angle none."""
        factors = {}
        arguments = sp.Tuple(*problem.field, problem.running, problem.final).atoms(sp.Function)
        for x in problem.state:
            if x in factors:
                continue
            angle = any(x in f.free_symbols and not isinstance(f, sp.Abs) for f in arguments)
            factor = sp.S.One if angle else units.length
            if problem.dynamics[x] == 1:
                factor = units.time
            while x in problem.dynamics and x not in factors:
                factors[x] = factor
                x, factor = problem.dynamics[x], factor / units.time
        return factors

    def _of_parameters(self, problem, parameters):
        for value, factor in [
            *((value, self.factors[x]) for x, value in problem.initial.items()),
            (problem.duration, self.time),
            *((b, self.factors[u]) for u, pair in problem.controls.items() for b in pair),
        ]:
            if value in parameters and value not in self.factors:
                self.factors[value] = factor

    def _problem(self, problem):
        value, factors = self.expression, self.factors
        pair = isinstance(problem.duration, tuple)
        times = [
            None if d is None else value(d, self.time)
            for d in (problem.duration if pair else (problem.duration,))
        ]
        return dataclasses.replace(
            problem,
            dynamics={x: value(f, factors[x] / self.time) for x, f in problem.dynamics.items()},
            controls={
                u: tuple(value(b, factors[u]) for b in bounds)
                for u, bounds in problem.controls.items()
            },
            initial={
                x: None if v is None else value(v, factors[x]) for x, v in problem.initial.items()
            },
            terminal=[value(g) for g in problem.terminal],
            running=value(problem.running, self.cost / self.time),
            final=value(problem.final, self.cost) + self.constant,
            duration=tuple(times) if pair else times[0],
        )

    def expression(self, written, factor=1, time=None):
        """Return an expression of the old units as one of the new ones, times a factor."""
        factors = self.factors if time is None else self.factors | {time: self.time}
        put = {s: s / f for s, f in factors.items() if f != 1}
        return factor * sp.sympify(written).subs(put, simultaneous=True)


def rescaled(name, answer, data, options, units):
    """Return an answer and the data of the check `name` in other units.

    Raises
    ------
    NoRule
        If no rule is known for the check, or for this form of answer.
    """
    rule = RULES.get(name)
    if rule is None:
        raise NoRule(name)
    bound = inspect.signature(getattr(checks, name)).bind(answer, *data, **options)
    bound.apply_defaults()
    _, *rest = bound.arguments
    arguments = {key: bound.arguments[key] for key in rest}
    parameters = arguments.get("parameters")
    new = Rescaled(arguments["problem"], parameters, units)
    arguments["problem"] = new.problem
    if "parameters" in arguments:
        arguments["parameters"] = new.parameters
    return rule(new, answer, arguments), arguments


def _control(new, answer, arguments):
    (u,), time = new.problem.control, arguments["time"]
    if not isinstance(answer, (list, tuple)):
        return _expression(new, answer, new.factors[u], time)
    return [
        [_expression(new, value, new.factors[u], time), _expression(new, until, new.time)]
        for value, until in answer
    ]


def _each_state(new, answer, arguments, factors):
    time = arguments["time"]
    several = isinstance(answer, (list, tuple, sp.MatrixBase))
    parts = list(answer) if several else [answer]
    found = [_expression(new, part, f, time) for part, f in zip(parts, factors)]
    return found if several else found[0]


def _motion(new, answer, arguments):
    return _each_state(new, answer, arguments, [new.factors[x] for x in new.problem.state])


def _costate(new, answer, arguments):
    return _each_state(
        new, answer, arguments, [new.cost / new.factors[x] for x in new.problem.state]
    )


def _law(new, answer, arguments):
    (u,), time = new.problem.control, arguments["time"]
    if isinstance(answer, sp.Eq):
        return sp.Eq(*(_expression(new, side, 1, time) for side in answer.args), evaluate=False)
    return _expression(new, answer, new.factors[u], time)


def _transition(new, answer, arguments):
    ((given, domain),) = arguments["domain"].items()
    arguments["domain"] = {given: _scaled(domain, new.factors[given])}
    (other,) = set(new.problem.state) - {given}
    return _expression(new, answer, new.factors[other])


def _arc(new, answer, arguments):
    arguments["value"] = new.expression(arguments["value"], new.factors[arguments["control"]])
    return _expression(new, answer, new.time)


def _range(new, answer, arguments):
    arguments["quantity"] = new.expression(arguments["quantity"])
    return _expression(new, answer)


def _expression(new, written, factor=1, time=None):
    if not isinstance(written, (sp.Expr, int, float)):
        raise NoRule(type(written).__name__)
    return new.expression(written, factor, time)


def _scaled(domain, factor):
    if factor == 1:
        return domain
    if isinstance(domain, sp.FiniteSet):
        return sp.FiniteSet(*(factor * value for value in domain))
    return sp.Interval(
        factor * domain.start, factor * domain.end, domain.left_open, domain.right_open
    )


RULES = {
    "optimal_control": _control,
    "optimal_motion": _motion,
    "optimal_costate": _costate,
    "optimal_law": _law,
    "optimal_cost": lambda new, answer, _: _expression(new, answer, new.cost) + new.constant,
    "optimal_duration": lambda new, answer, _: _expression(new, answer, new.time),
    "initial_arc_duration": _arc,
    "optimal_range": _range,
    "arc_transition_curve": _transition,
}

"""The same problem in other units.

States x become l x, times T t, costs s J + c. What is multiplied by a factor is the symbol itself:
`x` in the rescaled problem is the number of the new units.
"""

import dataclasses

import sympy as sp
from sympy.logic.boolalg import Boolean, BooleanAtom


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

    @property
    def of_state(self):
        """The factors of the states, a list."""
        return [self.factors[x] for x in self.state]

    @property
    def of_control(self):
        """The factor of the first control."""
        return self.factors[self.control[0]]

    def _of_record(self, arguments, units):
        problem = arguments["problem"]
        self.state, self.control = list(problem.dynamics), list(problem.controls)
        running, final = problem.running, problem.final
        if running == 1 and final == 0 and units.cost == 1:
            self.cost = units.time  # the cost is the time, in its units
        self._of_states(problem.dynamics, sp.Tuple(*problem.field, running, final), units)
        for u in self.control:
            rates = [x for x, f in problem.dynamics.items() if f == u]
            self.factors[u] = self.factors[rates[0]] / units.time if rates else sp.S.One
        for name in ("parameters", "unknown"):
            if isinstance(arguments.get(name), dict):
                self._of_parameters(problem, arguments[name])
        if isinstance(arguments.get("start"), sp.Symbol):  # the value with which a control begins
            self.factors[arguments["start"]] = self.of_control

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
        for value, factor in [
            *((value, self.factors[x]) for x, value in problem.initial.items()),
            (problem.duration, self.time),
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

    def field(self, field):
        """Return the right-hand sides in the new units."""
        return self.value(list(field), [f / self.time for f in self.of_state])


class RescaledSynthesis(Rescaled):
    """The data of a synthesis in the plane in other units; its cost is the time."""

    def _of_record(self, arguments, units):
        system = arguments["system"]
        if units.cost != 1 or units.constant != 0:
            raise NoRule("the cost is the time itself")
        self.state, self.control = system.state, [system.control]
        self._of_states(system.dynamics, sp.Tuple(*system.field), units)
        self.factors[system.control] = next(
            self.factors[x] / units.time
            for x, f in system.dynamics.items()
            if system.control in f.free_symbols
        )
        if arguments.get("curve"):
            self.factors[arguments["curve"][0]] = self.of_state[1]

    def system(self, system):
        """Return the system in the new units."""
        return dataclasses.replace(system, **self._motion(system))

    def target(self, target):
        """Return the target, expressions that vanish on it or points, in the new units."""
        return [
            self.value(part, self.of_state if isinstance(part, (list, tuple)) else 1)
            for part in (target if isinstance(target, (list, tuple)) else [target])
        ]

    def with_curve(self, curve):
        """Return the switching curve that a law may name, in the new units."""
        symbol, abscissa, ends, *numbered = curve
        first = self.of_state[0]
        return symbol, self.value(abscissa, first), self.value(list(ends), self.of_state), *numbered


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
    """The data of a check on a `Quadratic` problem or a `Process` in other units.

    All states have the same unit, and so have their measurements.
    """

    def _of_record(self, arguments, units):
        if self.constant:
            raise NoRule("a quadratic cost has no constant term")
        self.length = units.length
        for name, factor in {
            "start": self.length,
            "estimates": self.length,
            "outputs": self.length,
            "cost": self.cost / self.length**2,
        }.items():
            symbols = sp.Tuple(*arguments.get(name, ())).free_symbols
            self.factors |= dict.fromkeys(symbols, factor)

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

    def process(self, process):
        """Return the process in the new units; intensities are covariances times a time."""
        square = self.length**2
        return dataclasses.replace(
            process,
            A=self.value(process.A, 1 / self.time),
            Q=self.value(process.Q, square / self.time),
            R=self.value(process.R, square * self.time),
        )


#: What becomes of an argument of a check, by its name.
ARGUMENTS = {
    "problem": lambda new, problem: new.problem(problem),
    "field": lambda new, field: new.field(field),
    "process": lambda new, process: new.process(process),
    "functional": lambda new, functional: new.functional(functional),
    "system": lambda new, system: new.system(system),
    "target": lambda new, target: new.target(target),
    "ends": lambda new, ends: new.value(list(ends), new.of_state),
    "curve": lambda new, curve: new.with_curve(curve),
    "parameters": Rescaled.domain,
    "start": lambda new, start: (
        new.value(start) if isinstance(start, Boolean) and not start.is_Symbol else start
    ),
    "domain": Rescaled.domain,
    "unknown": Rescaled.domain,
    "law": lambda new, law: new.value(law, new.of_control),
    "quantity": Rescaled.value,
    "expression": Rescaled.value,
}


def _scaled(values, factor):
    if factor == 1:
        return values
    if isinstance(values, sp.FiniteSet):
        return sp.FiniteSet(*(factor * value for value in values))
    return sp.Interval(
        factor * values.start, factor * values.end, values.left_open, values.right_open
    )

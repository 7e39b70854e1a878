"""The statement of an optimal control problem: dynamics, bounds, end conditions, cost.

    y' = f(y, u),   u_- <= u <= u_+,   y(0) = y*,   phi_i(y(t_k)) = 0,   J = phi_0(y(t_k)) + int_0^t_k f_0(y, u) dt

and g_j(y) <= 0 along the path

(equations (5.1) - (5.3) of the problem book, with the integral written out instead of an additional
state). A symbol for the time, where the statement depends on it, becomes the last state, t' = 1.

All functions of the package work on a `Statement`; the public class `optimal_control.Problem` adds
the methods that call them.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from itertools import combinations
from typing import Any, Self

import sympy as sp

from trajlib._arguments.symbols import exact_decimals, join_names, read_expression
from trajlib.flows import lie_derivative
from trajlib.pontryagin.problem.arguments import (
    bounds_from_path,
    inequalities,
    read_bounds,
    read_duration,
    read_inequalities,
    read_initial,
    read_table,
    read_terminal,
)
from trajlib.pontryagin.problem.singular import vanishes_identically


@dataclass(frozen=True, eq=False)
class Statement:
    """The data of an optimal control problem, read and checked; see `optimal_control.Problem`."""

    dynamics: Mapping
    controls: Mapping
    initial: Mapping
    terminal: Sequence | Mapping = ()
    running: sp.Expr = None
    final: sp.Expr = None
    duration: sp.Expr = None
    maximise: bool = False
    first_return: bool = False
    path: Sequence = ()
    terminal_inequalities: Sequence = ()
    time: sp.Symbol = None

    def __post_init__(self):
        self._add_time()
        # Neither part given: the time. One of them given: the other is zero.
        time_optimal = self.running is None and self.final is None
        values = {
            "dynamics": read_table(self.dynamics),
            "controls": read_bounds(self.controls),
            "running": read_expression(
                int(time_optimal) if self.running is None else self.running, "running"
            ),
            "final": read_expression(0 if self.final is None else self.final, "final"),
            "duration": read_duration(self.duration),
            "initial": read_initial(self.initial),
            "path": read_inequalities(self.path, "path"),
        }
        values["terminal"], inequalities = read_terminal(self.terminal)
        values["terminal_inequalities"] = (
            *read_inequalities(self.terminal_inequalities, "terminal_inequalities"),
            *inequalities,
        )
        values["controls"], values["path"] = bounds_from_path(values["controls"], values["path"])
        for name in ("running", "final"):
            values[name] = exact_decimals(values[name])
        for name, value in values.items():
            object.__setattr__(self, name, value)
        for name in ("maximise", "first_return"):
            if not isinstance(getattr(self, name), bool):
                raise TypeError(f"{name}: expected True or False, got {getattr(self, name)!r}")
        self._check_symbols()
        self._check_ends()
        self._check_path()
        self._impose_at_end()

    @property
    def state(self) -> tuple[sp.Symbol, ...]:
        """The state symbols, a tuple of length n."""
        return tuple(self.dynamics)

    @property
    def control(self) -> tuple[sp.Symbol, ...]:
        """The control symbols, a tuple of length k."""
        return tuple(self.controls)

    @property
    def field(self) -> tuple[sp.Expr, ...]:
        """The right-hand sides f(y, u), a tuple of length n."""
        return tuple(self.dynamics.values())

    @property
    def constraints(self) -> tuple[sp.Expr, ...]:
        """The expressions g(y) of the inequalities g <= 0 along the path."""
        return tuple(relation.lhs for relation in self.path)

    @property
    def end_constraints(self) -> tuple[sp.Expr, ...]:
        """The expressions g(y) of the inequalities g <= 0 at the final time."""
        return tuple(relation.lhs for relation in self.terminal_inequalities)

    @property
    def constrained(self) -> bool:
        """Whether there are inequalities along the path or at the final time."""
        return bool(self.path or self.terminal_inequalities)

    @property
    def bounds_depend_on_state(self) -> bool:
        """Whether a bound of a control contains a state."""
        bounds = (b for pair in self.controls.values() for b in pair)
        return any(b.free_symbols & set(self.state) for b in bounds)

    @property
    def parameters(self) -> tuple[sp.Symbol, ...]:
        """The symbols without a value, sorted by name."""
        symbols = set().union(*(e.free_symbols for e in self._expressions()))
        return tuple(sorted(symbols - set(self.state) - set(self.control), key=lambda s: s.name))

    @property
    def free_time(self) -> bool:
        """Whether the final time is to be found."""
        return self.duration is None or isinstance(self.duration, tuple)

    @property
    def time_optimal(self) -> bool:
        """Whether the cost is the duration itself."""
        return self.running == 1 and self.final == 0 and self.free_time

    def subs(self, values: Mapping) -> Self:
        """Return the same problem with values for some of its parameters.

        Parameters
        ----------
        values : dict
            {parameter: number or expression}.

        Returns
        -------
        Problem
            With the values substituted everywhere.

        Raises
        ------
        TypeError
            If `values` is not a dict.
        ValueError
            If a symbol is not a parameter of this problem.
        """
        if not isinstance(values, Mapping):
            raise TypeError(f"subs: expected a dict from parameters to values, got {values!r}")
        values = {s: exact_decimals(read_expression(v, f"subs, {s}")) for s, v in values.items()}
        unknown = set(values) - set(self.parameters)
        if unknown:
            names = ", ".join(map(str, self.parameters)) or "none"
            raise ValueError(
                f"subs: {', '.join(sorted(map(str, unknown)))} is no parameter here (parameters: "
                f"{names})"
            )

        def substituted(e):
            return None if e is None else e.subs(values, simultaneous=True)

        pair = isinstance(self.duration, tuple)
        return replace(
            self,
            dynamics={s: substituted(f) for s, f in self.dynamics.items()},
            controls={
                u: tuple(substituted(b) for b in bounds) for u, bounds in self.controls.items()
            },
            initial={s: substituted(v) for s, v in self.initial.items()},
            terminal=[substituted(g) for g in self.terminal],
            running=substituted(self.running),
            final=substituted(self.final),
            duration=tuple(map(substituted, self.duration)) if pair else substituted(self.duration),
            path=inequalities(map(substituted, self.constraints)),
            terminal_inequalities=inequalities(map(substituted, self.end_constraints)),
        )

    def cached(self, name: str, compute: Callable[[], Any]) -> Any:
        """Return the result of `compute()`, computed once: a statement never changes.

        Parameters
        ----------
        name : str
            Name under which the result is kept.
        compute : callable
            Function without arguments.
        """
        results = self.__dict__.setdefault("_cached", {})
        if name not in results:
            results[name] = compute()
        return results[name]

    def __repr__(self):
        shown = ", ".join(f"{f.name}={getattr(self, f.name)}" for f in fields(self))
        return f"{type(self).__name__}({shown})"

    def _expressions(self):
        durations = self.duration if isinstance(self.duration, tuple) else (self.duration,)
        return [
            e
            for e in (
                *self.field,
                *(b for pair in self.controls.values() for b in pair),
                *self.initial.values(),
                *self.terminal,
                *self.constraints,
                *self.end_constraints,
                self.running,
                self.final,
                *durations,
            )
            if e is not None
        ]

    def _add_time(self):
        """Put the time among the states; it is then no separate part of the statement."""
        if self.time is None:
            return
        if not isinstance(self.time, sp.Symbol):
            raise TypeError(f"time: expected a symbol, got {self.time!r}")
        tables = {"dynamics": self.dynamics, "controls": self.controls, "initial": self.initial}
        for name, table in tables.items():
            if isinstance(table, Mapping) and self.time in table:
                raise ValueError(f"time: {self.time} is among {name} already; leave it out there")
        for name, value in (("dynamics", 1), ("initial", 0), ("time", None)):
            table = tables.get(name)
            # what is no table is refused where it is read
            changed = {**table, self.time: value} if isinstance(table, Mapping) else table
            object.__setattr__(self, name, changed)

    def _check_symbols(self):
        states, controls = set(self.state), set(self.control)
        if states & controls:
            raise ValueError(f"controls: {join_names(states & controls)} is a state already")
        if set(self.initial) != states:
            missing, extra = states - set(self.initial), set(self.initial) - states
            if extra:
                raise ValueError(
                    f"initial: {join_names(extra)} is no state (states: {join_names(states)})"
                )
            raise ValueError(
                f"initial: no value for {join_names(missing)}; write None for a state that is free "
                "at t = 0"
            )
        for name, expressions in (
            ("terminal", self.terminal),
            ("terminal", self.end_constraints),
            ("final", [self.final]),
        ):
            for e in expressions:
                if e.free_symbols & controls:
                    raise ValueError(
                        f"{name}: {e} contains a control; only states have a value at the end"
                    )
        for u, bounds in self.controls.items():
            if any(b.free_symbols & controls for b in bounds):
                raise ValueError(
                    f"controls: the bounds of {u} contain a control; expected numbers, parameters "
                    "or states"
                )
            if not any(u in e.free_symbols for e in (*self.field, self.running)):
                raise ValueError(
                    f"controls: {u} acts neither on the dynamics nor on the running cost"
                )
        values = [v for v in self.initial.values() if v is not None]
        values += (
            list(self.duration)
            if isinstance(self.duration, tuple)
            else [self.duration]
            if self.duration is not None
            else []
        )
        for e in values:
            if e.free_symbols & (states | controls):
                raise ValueError(f"initial, duration: expected numbers or parameters, got {e}")

    def _check_path(self):
        if self.path and self.first_return:
            raise ValueError("first_return: not provided for together with path constraints")
        for relation, g in zip(self.path, self.constraints):
            if not g.free_symbols & set(self.state):
                raise ValueError(f"path: {relation} does not depend on the state")
            if g.atoms(sp.Abs, sp.sign, sp.Max, sp.Min, sp.Piecewise, sp.Heaviside):
                raise ValueError(
                    f"path: {relation} is not smooth; write one inequality for each smooth part"
                )
        for (first, a), (second, b) in combinations(zip(self.path, self.constraints), 2):
            if sp.cancel(a / b).is_positive:
                raise ValueError(
                    f"path: {first} and {second} are the same inequality, so its multiplier is not unique"
                )

    def _impose_at_end(self):
        """Impose path constraints at the end alone where they hold at all times if they hold there.

        So it is for g' = 0, as on a parameter k with k' = 0, and for g' > 0, as on the time. A
        constant g that is not positive at the start is left out.
        """
        given = {y: value for y, value in self.initial.items() if value is not None}
        path, ends = [], []
        for relation in (*self.path, *self.terminal_inequalities):
            g, at_end = relation.lhs, relation in self.terminal_inequalities
            rate = sp.expand(lie_derivative(g, self.dynamics))
            constant = vanishes_identically(rate)
            if constant and g.subs(given).is_nonpositive:
                continue
            growing = rate.is_positive and not rate.has(*self.control)
            (ends if at_end or constant or growing else path).append(relation)
        object.__setattr__(self, "path", tuple(path))
        object.__setattr__(self, "terminal_inequalities", tuple(dict.fromkeys(ends)))

    def _check_ends(self):
        if len(self.terminal) > len(self.state):
            raise ValueError(
                f"terminal: {len(self.terminal)} equations for {len(self.state)} states; expected "
                "at most as many"
            )
        for g in self.terminal:
            if not g.free_symbols & set(self.state):
                raise ValueError(
                    f"terminal: {g} does not depend on the state, so it cannot be a condition on "
                    "its end"
                )
        for g in self.end_constraints:
            if not g.free_symbols & set(self.state):
                raise ValueError(f"terminal: {g} <= 0 does not depend on the state")
        if self.free_time and not self.terminal and self.duration is None:
            raise ValueError(
                "terminal: with a free final time something must end the process; give terminal "
                "equations or a duration"
            )
        if self.first_return and len(self.terminal) != 1:
            raise ValueError(
                f"first_return: expected one terminal equation, got {len(self.terminal)}"
            )
        if self.running == 0 and self.final == 0:
            raise ValueError(
                "running, final: both are zero, so every trajectory is as good as any other"
            )

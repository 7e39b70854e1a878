"""The statement of an optimal control problem: dynamics, bounds on the controls, ends of the
trajectory, cost.

    y' = f(y, u),   u_- <= u <= u_+,   y(0) = y*,   phi_i(y(t_k)) = 0,   J = phi_0(y(t_k)) + int_0^t_k f_0(y, u) dt

(equations (5.1) - (5.3) of the problem book, with the integral written out instead of an additional
state). A problem whose right-hand side depends on time has time among its states, t' = 1.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace

import sympy as sp

from trajlib._arguments.symbols import exact_decimals, read_expression
from trajlib.pontryagin.arguments import (
    names_of,
    read_bounds,
    read_duration,
    read_initial,
    read_table,
    read_terminal,
)


@dataclass(frozen=True, eq=False)
class Problem:
    """An optimal control problem in SymPy.

    Parameters
    - `dynamics`: {state: right-hand side}, in the order in which the states are to be counted;
    - `controls`: {control: (lower, upper)}, the bounds being expressions in the parameters; None or
      oo for no bound;
    - `initial`: {state: value}, a value None for a state that is free at t = 0;
    - `terminal`: expressions that vanish at the end (or equations, or {state: value}); none for a
      free end;
    - `running`, `final`: f_0(state, control) and phi_0(state at the end). If neither is given, the
      cost is the time;
    - `duration`: None for a free final time, a number for a fixed one, (shortest, longest) for one
      between bounds;
    - `maximise`: whether the cost is to be as large as possible;
    - `first_return`: the process ends when the trajectory first meets the target at some t > 0; for
      a start on the target, and for costs that would gain from passing through it. Takes one
      terminal equation.

    All other symbols are parameters; `subs` gives them values. Units are the user's: time in that
    of the dynamics. Raises TypeError or ValueError, with the argument's name, for whatever is not
    of this form. Source: (5.1) - (5.3) of the problem book.

    >>> import sympy as sp
    >>> x1, x2, u, a = sp.symbols("x1 x2 u a")
    >>> transfer = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: a, x2: 0}, terminal=[x1, x2])
    >>> transfer.running, transfer.parameters
    (1, (a,))
    >>> round(transfer.subs({a: 1}).solve().duration, 9)
    2.0
    """

    dynamics: Mapping
    controls: Mapping
    initial: Mapping
    terminal: Iterable = ()
    running: sp.Expr = None
    final: sp.Expr = None
    duration: sp.Expr = None
    maximise: bool = False
    first_return: bool = False

    def __post_init__(self):
        # Neither part given: the time. One of them given: the other is zero.
        time_optimal = self.running is None and self.final is None
        put = {
            "dynamics": read_table(self.dynamics),
            "controls": read_bounds(self.controls),
            "terminal": read_terminal(self.terminal),
            "running": read_expression(
                int(time_optimal) if self.running is None else self.running, "running"
            ),
            "final": read_expression(0 if self.final is None else self.final, "final"),
            "duration": read_duration(self.duration),
            "initial": read_initial(self.initial),
        }
        for name in ("running", "final"):
            put[name] = exact_decimals(put[name])
        for name, value in put.items():
            object.__setattr__(self, name, value)
        for name in ("maximise", "first_return"):
            if not isinstance(getattr(self, name), bool):
                raise TypeError(f"{name}: expected True or False, got {getattr(self, name)!r}")
        self._check_symbols()
        self._check_ends()

    @property
    def state(self):
        """The state symbols, a tuple of length n."""
        return tuple(self.dynamics)

    @property
    def control(self):
        """The control symbols, a tuple."""
        return tuple(self.controls)

    @property
    def field(self):
        """The right-hand sides f(y, u), a tuple of length n."""
        return tuple(self.dynamics.values())

    @property
    def parameters(self):
        """The symbols that have no value yet, sorted by name."""
        found = set().union(*(e.free_symbols for e in self._expressions()))
        return tuple(sorted(found - set(self.state) - set(self.control), key=lambda s: s.name))

    @property
    def free_time(self):
        """Whether the final time is to be found."""
        return self.duration is None or isinstance(self.duration, tuple)

    @property
    def time_optimal(self):
        """Whether the cost is the duration itself."""
        return self.running == 1 and self.final == 0 and self.free_time

    def subs(self, values):
        """The same problem with values (numbers or expressions) for some of its parameters.

        Raises ValueError for a symbol that is not a parameter of this problem.
        """
        if not isinstance(values, Mapping):
            raise TypeError(f"subs: expected a dict from parameters to values, got {values!r}")
        values = {s: exact_decimals(read_expression(v, f"subs, {s}")) for s, v in values.items()}
        strangers = set(values) - set(self.parameters)
        if strangers:
            known = ", ".join(map(str, self.parameters)) or "none"
            raise ValueError(
                f"subs: {', '.join(sorted(map(str, strangers)))} is no parameter here (parameters: "
                f"{known})"
            )

        def put(e):
            return None if e is None else e.subs(values, simultaneous=True)

        pair = isinstance(self.duration, tuple)
        return replace(
            self,
            dynamics={s: put(f) for s, f in self.dynamics.items()},
            controls={u: tuple(put(b) for b in bounds) for u, bounds in self.controls.items()},
            initial={s: put(v) for s, v in self.initial.items()},
            terminal=[put(g) for g in self.terminal],
            running=put(self.running),
            final=put(self.final),
            duration=tuple(map(put, self.duration)) if pair else put(self.duration),
        )

    def conditions(self):
        """The conditions of the maximum principle, derived and ready to be shown: `Conditions`."""
        from trajlib.pontryagin.derivation import conditions

        # A problem does not change: its conditions are derived once.
        if "_conditions" not in self.__dict__:
            object.__setattr__(self, "_conditions", conditions(self))
        return self._conditions

    def solve(self, structure=None, guess=None):
        """An extremal of the problem with its arcs and switching times: `Extremal`; see
        `extremal.solve`."""
        from trajlib.pontryagin.extremal import solve

        return solve(self, structure, guess)

    def __repr__(self):
        shown = ", ".join(f"{f.name}={getattr(self, f.name)}" for f in fields(self))
        return f"Problem({shown})"

    def _repr_markdown_(self):
        from trajlib.pontryagin.presentation import problem_markdown

        return problem_markdown(self)

    def _expressions(self):
        durations = self.duration if isinstance(self.duration, tuple) else (self.duration,)
        return [
            e
            for e in (
                *self.field,
                *(b for pair in self.controls.values() for b in pair),
                *self.initial.values(),
                *self.terminal,
                self.running,
                self.final,
                *durations,
            )
            if e is not None
        ]

    def _check_symbols(self):
        states, controls = set(self.state), set(self.control)
        if states & controls:
            raise ValueError(f"controls: {names_of(states & controls)} is a state already")
        if set(self.initial) != states:
            missing, extra = states - set(self.initial), set(self.initial) - states
            if extra:
                raise ValueError(
                    f"initial: {names_of(extra)} is no state (states: {names_of(states)})"
                )
            raise ValueError(
                f"initial: no value for {names_of(missing)}; write None for a state that is free "
                "at t = 0"
            )
        for name, expressions in (("terminal", self.terminal), ("final", [self.final])):
            for e in expressions:
                if e.free_symbols & controls:
                    raise ValueError(
                        f"{name}: {e} contains a control; only states have a value at the end"
                    )
        for u, bounds in self.controls.items():
            if any(b.free_symbols & (states | controls) for b in bounds):
                raise ValueError(
                    f"controls: the bounds of {u} depend on the state; expected numbers or "
                    "parameters"
                )
            if not any(u in e.free_symbols for e in (*self.field, self.running)):
                raise ValueError(
                    f"controls: {u} acts neither on the dynamics nor on the running cost"
                )
        others = [v for v in self.initial.values() if v is not None]
        others += (
            list(self.duration)
            if isinstance(self.duration, tuple)
            else [self.duration]
            if self.duration is not None
            else []
        )
        for e in others:
            if e.free_symbols & (states | controls):
                raise ValueError(f"initial, duration: expected numbers or parameters, got {e}")

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

"""A phase of an optimal control problem, and the symbols that stand for it in the joined problem."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from trajlib._arguments.symbols import exact_decimals, join_names, read_expression
from trajlib.pontryagin.problem.arguments import (
    read_bounds,
    read_duration,
    read_inequalities,
    read_table,
    read_terminal,
)


@dataclass(frozen=True, eq=False)
class Phase:
    """A phase of a `PhasedProblem`: its dynamics, and how it ends.

    Parameters
    ----------
    dynamics : dict
        {state: right-hand side}.
    controls : dict
        {control: (lower, upper)} as for `Problem`.
    terminal : list of sympy.Expr, list of sympy.Equality or dict, optional
        What holds at the end of the phase, before the jump: equations and inequalities.
    running : sympy.Expr, optional
        The running cost of the phase.
    duration : float or tuple, optional
        None for a free duration, a number, or (shortest, longest).
    path : list of sympy inequalities, optional
        Constraints during the phase.
    jump : dict, optional
        {state of the next phase: its initial value, an expression in the states at the end of this
        one}; states that are not named are continuous.

    Raises
    ------
    TypeError, ValueError
        If an argument is not of this form; the message begins with the argument's name.

    Examples
    --------
    >>> import sympy as sp
    >>> h, v, m, u = sp.symbols("h v m u")
    >>> booster = Phase({h: v, v: u / m - 1, m: -u}, {u: (0, 4)}, {m: 0.6}, jump={m: m - 0.1})
    >>> booster.jump
    {m: m - 1/10}
    """

    dynamics: Mapping
    controls: Mapping
    terminal: Sequence | Mapping = ()
    running: sp.Expr = None
    duration: sp.Expr = None
    path: Sequence = ()
    jump: Mapping = field(default_factory=dict)

    def __post_init__(self):
        if not isinstance(self.jump, Mapping):
            raise TypeError(f"jump: expected a dict {{state: expression}}, got {self.jump!r}")
        running = None if self.running is None else read_expression(self.running, "running")
        equations, inequalities = read_terminal(self.terminal)
        values = {
            "dynamics": read_table(self.dynamics),
            "controls": read_bounds(self.controls),
            "terminal": (*equations, *inequalities),
            "running": running if running is None else exact_decimals(running),
            "duration": read_duration(self.duration),
            "path": read_inequalities(self.path, "path"),
            "jump": {
                y: exact_decimals(read_expression(e, f"jump of {y}")) for y, e in self.jump.items()
            },
        }
        if values["duration"] == sp.oo:
            raise ValueError("duration: expected a finite duration for a phase, got oo")
        for name, value in values.items():
            object.__setattr__(self, name, value)
        for y, e in self.jump.items():
            if foreign := e.free_symbols & set(self.controls):
                raise ValueError(
                    f"jump: the value of {y} contains {join_names(foreign)}; expected states at "
                    "the end of the phase"
                )

    @property
    def free_duration(self) -> bool:
        """Whether the duration is to be found."""
        return self.duration is None or isinstance(self.duration, tuple)

    def __repr__(self):
        return f"Phase({join_names(self.dynamics)}; duration={self.duration})"


def moving(symbol: sp.Symbol, index: int) -> sp.Symbol:
    """Return the symbol of a control, or of a state since the beginning of phase `index`, from 0."""
    return _marked(symbol, f"{index + 1}")


def beginning(state: sp.Symbol, index: int) -> sp.Expr:
    """Return the symbol of a state at the beginning of a phase; the first phase needs none: 0."""
    return _marked(state, f"{index + 1},0") if index else sp.Integer(0)


def joined_duration(phase: Phase, index: int) -> sp.Expr:
    """Return the duration of a phase if it is given, else the symbol that stands for it."""
    return _marked(sp.Symbol("T"), f"{index + 1}") if phase.free_duration else phase.duration


def _marked(symbol, mark):
    return sp.Symbol(f"{symbol.name}^({mark})", **symbol._assumptions_orig)

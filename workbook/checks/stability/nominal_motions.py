"""Nominal motions: that they satisfy the equations, and the linearisation along them.

A program is a dict from the prescribed components of the state to functions of time,
`{x: V0*t, y: 0}`; the other components and the controls along it are constants, which the checks
compute by Newton's method.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Matrix
from workbook.checks.contract.members import in_order
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.references.fields import STEP
from workbook.checks.stability.linearisation import Rates
from workbook.checks.tools.samples import in_every_case, sample_values
from workbook.checks.tools.values import number_at, numbers_at
from workbook.checks.tools.wording import values_text

#: The message on a right matrix of deviation equations.
MATRIX_VERIFIED = (
    "for small deviations in every direction the right-hand sides change as the matrix predicts"
)


@judged
def nominal_motion(answer, field, state, parameters, program, controls, time):
    """Check a nominal motion and its controls as functions of time.

    The answer is a dict by names, or a list with the controls last.

    Judged by the equations and by what the program prescribes, at random times and parameters.

    Can decide when the functions are differentiable, at random times and parameters.

    Examples
    --------
    >>> x, v, u = sp.symbols("x v u")
    >>> t, c = sp.symbols("t c", positive=True)
    >>> checks.nominal_motion([c*t, c, c], [v, u - v], [x, v], [c], {x: c*t}, [u], t).status
    'right'
    >>> checks.nominal_motion([c*t, c, 0], [v, u - v], [x, v], [c], {x: c*t}, [u], t).status
    'wrong'
    """
    names = [*state, *controls]
    motion = dict(
        zip(
            names, coercion.as_expressions(in_order(answer, names), [time, *parameters], len(names))
        )
    )
    rates = [sp.diff(motion[s], time) for s in state]
    random = np.random.default_rng(9)
    samples = [
        values | {time: sp.Rational(int(random.integers(1, 400)), 97)}
        for values in sample_values(parameters)
    ]
    for at in in_every_case(samples, list(motion.values()), time >= 0):
        values = {p: at[p] for p in parameters}
        position = dict(zip(motion, numbers_at(motion.values(), at, motion).tolist()))
        where = f"for {values_text(at)}"
        for symbol, expression in program.items():
            prescribed = complex(sp.sympify(expression).subs(at).evalf(20))
            if not abs(position[symbol] - prescribed) <= 1e-9 * (1 + abs(prescribed)):
                raise Wrong(
                    f"your motion does not follow the given program of {symbol}: {where} your "
                    f"{symbol} is {position[symbol].real:.4g}, and that of the program is not"
                )
        for symbol, rate, right_side in zip(state, rates, field):
            rate_value = number_at(rate, at, f"the derivative of your {symbol}")
            terms = [
                complex(term.subs(values).subs(position).evalf(20))
                for term in sp.Add.make_args(sp.expand(right_side))
            ]
            if (
                not abs(rate_value - sum(terms))
                <= 1e-9 * (abs(rate_value) + sum(map(abs, terms)) + 1e-3)
                < np.inf
            ):
                raise Wrong(
                    f"the equation for {symbol}' does not hold: {where} the derivative of your "
                    f"{symbol} is {rate_value.real:.4g}, and the right-hand side is not"
                )
    return "it is the program, and all equations hold at random times and parameters"


@judged(Matrix("parameters", shape=lambda data: (len(data["state"]),) * 2))
def linearisation(claim, field, state, at, parameters=()):
    """Check the n x n matrix A of the deviation equations x' = A x + B w from the motion `at`.

    The motion is an equilibrium (n expressions) or a program.

    Can decide when the right-hand sides are differentiable along the motion, at sample times and
    parameters.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.linearisation([[0, 1], [-1, 0]], [y, -sp.sin(x)], [x, y], [0, 0]).status
    'right'
    >>> checks.linearisation([[0, 1], [1, 0]], [y, -sp.sin(x)], [x, y], [0, 0]).status
    'wrong'
    """
    motion = Motion(field, state, parameters, at if isinstance(at, dict) else dict(zip(state, at)))
    for values in in_every_case(sample_values(parameters), claim):
        yield Rates(claim, motion.matrix(values), state, values)
    return MATRIX_VERIFIED


@judged(Matrix("parameters", shape=lambda data: (len(data["state"]), len(data["controls"]))))
def input_matrix(claim, field, state, parameters, program, controls):
    """Check the n x s matrix B of the deviation equations x' = A x + B w from a nominal motion.

    The s controls are the symbols `controls`.

    Can decide when the right-hand sides are differentiable along the motion that the program
    determines, at sample values of the parameters.

    Examples
    --------
    >>> x, v, u, t = sp.symbols("x v u t", real=True)
    >>> checks.input_matrix([[0], [1]], [v, u - v], [x, v], [], {x: t}, [u]).status
    'right'
    >>> checks.input_matrix([[1], [0]], [v, u - v], [x, v], [], {x: t}, [u]).status
    'wrong'
    """
    motion = Motion(field, state, parameters, program)
    for values in in_every_case(sample_values(parameters), claim):
        yield Rates(claim, motion.input_matrix(values, controls), controls, values)
    return MATRIX_VERIFIED


class Motion:
    """A nominal motion; Newton's method finds the components that the program does not prescribe."""

    def __init__(self, field, state, parameters, program):
        self.parameters = list(parameters)
        prescribed = {s: sp.sympify(e) for s, e in program.items()}
        field = [sp.sympify(f) for f in field]
        arguments = {*state, *parameters}
        times = set().union(*(e.free_symbols for e in prescribed.values())) - arguments
        controls = sorted(
            set().union(*(f.free_symbols for f in field)) - arguments - times, key=str
        )
        self._symbols = [*state, *controls]
        self._state = list(range(len(state)))
        self._free = [k for k, s in enumerate(self._symbols) if s not in prescribed]
        now = {t: sp.Rational(7, 19) for t in times}
        rates = [
            sum((sp.diff(prescribed.get(s, sp.S.Zero), t) for t in times), sp.S.Zero) for s in state
        ]
        self._function = sp.lambdify(
            [*self._symbols, *self.parameters],
            [(f - r).subs(now) for f, r in zip(field, rates)],
            "numpy",
        )
        self._prescribed = sp.lambdify(
            self.parameters,
            [prescribed.get(s, sp.S.Zero).subs(now) for s in self._symbols],
            "numpy",
        )

    def matrix(self, values):
        """Return A, the derivatives of the right-hand sides with respect to the state."""
        return self._columns(self._state, *self._solution(values))

    def input_matrix(self, values, controls):
        """Return B, the derivatives of the right-hand sides with respect to the controls."""
        return self._columns([self._symbols.index(u) for u in controls], *self._solution(values))

    def _columns(self, columns, point, numbers):
        moved = point.astype(complex) + 1j * STEP * np.eye(len(point))[columns]
        return np.array(
            [
                [complex(value).imag / STEP for value in self._function(*position, *numbers)]
                for position in moved
            ]
        ).T

    def _solution(self, values):
        numbers = [float(values[p]) for p in self.parameters]
        point = np.array(self._prescribed(*numbers), dtype=float)
        for _ in range(50):
            residual = np.array(self._function(*point, *numbers), dtype=float)
            if np.linalg.norm(residual) < 1e-12 * (1 + np.linalg.norm(point)):
                return point, numbers
            point[self._free] -= np.linalg.lstsq(
                self._columns(self._free, point, numbers), residual, rcond=None
            )[0]
        raise RuntimeError("no motion was found that satisfies the program")

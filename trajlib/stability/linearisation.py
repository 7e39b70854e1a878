"""Linearisation about equilibria and nominal trajectories, equations (1.2) and (1.3).

For y' = f(y, u, t) and a nominal trajectory y*(t), u*(t) the deviations x = y - y*, w = u - u*
satisfy, to first order, x' = A x + B w with A = df/dy and B = df/du taken along the nominal
trajectory.
"""

import numpy as np
import sympy as sp

from trajlib._arguments.symbols import join_names, read_expressions, read_field, read_symbols
from trajlib._real_symbols import vanishes
from trajlib._typing import Expressions, Matrix, Symbols


def linearise(
    field: Expressions,
    state: Symbols,
    at: Expressions | np.ndarray,
    inputs: Symbols = (),
    inputs_at: Expressions = (),
) -> Matrix | tuple[Matrix, Matrix]:
    """Return the linearisation of x' = f(x, u) about an equilibrium.

    Parameters
    ----------
    field : sequence of n sympy.Expr
        Right-hand sides f(x).
    state : sequence of n sympy.Symbol
        The state variables x.
    at : sequence of n values
        The equilibrium.
    inputs : sequence of r sympy.Symbol, optional
        The control variables u.
    inputs_at : sequence of r values, optional
        Their constant values there.

    Returns
    -------
    A : matrix, shape (n, n)
        df/dx; a SymPy matrix, or a NumPy array of floats if `at` is a NumPy array of numbers.
    B : matrix, shape (n, r)
        df/du, only if there are inputs.

    Raises
    ------
    ValueError
        If the field does not vanish at the point; the message has the residual.

    Notes
    -----
    MATLAB: ``linearize``, ``jacobian``. Source: equation (1.3) of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> x, v, d, w = sp.symbols("x v delta omega")
    >>> linearise([v, -d*v - w**2*sp.sin(x)], [x, v], at=[sp.pi, 0])
    Matrix([
    [       0,      1],
    [omega**2, -delta]])
    """
    field, state = read_field(field, state)
    inputs = read_symbols(inputs, "inputs")
    values = read_expressions(at, len(state), "at") + read_expressions(
        inputs_at, len(inputs), "inputs_at"
    )
    point = dict(zip(state + inputs, values))
    floats = isinstance(at, np.ndarray) and at.dtype.kind in "fiu"
    residual = sp.Matrix([_at(f, point, "field") for f in field])
    if not (
        _vanishes_numerically(residual, field, point) if floats else all(map(vanishes, residual))
    ):
        raise ValueError(
            f"at: {tuple(values)} is not an equilibrium; the field there is {list(residual)}"
        )
    A, B = (
        matrix.applyfunc(lambda e: _at(e, point, "the derivative of the field"))
        for matrix in _jacobians(field, state, inputs)
    )
    if floats:
        if A.free_symbols | B.free_symbols:
            raise ValueError(
                "at: floats need a field without further symbols; substitute numbers for "
                f"{join_names(A.free_symbols | B.free_symbols)} first"
            )
        A, B = (np.array(M.tolist(), dtype=float).reshape(M.shape) for M in (A, B))
    return (A, B) if inputs else A


def linearise_along(
    field: Expressions,
    state: Symbols,
    motion: Expressions,
    time: sp.Symbol,
    inputs: Symbols = (),
    inputs_along: Expressions = (),
) -> tuple[sp.Matrix, sp.Matrix]:
    """Return the linearisation A(t), B(t) of y' = f(y, u, t) along a nominal trajectory.

    Parameters
    ----------
    field : sequence of n sympy.Expr
        Right-hand sides f(x).
    state : sequence of n sympy.Symbol
        The state variables x.
    motion : sequence of n sympy.Expr
        The nominal trajectory, in the symbol `time`.
    time : sympy.Symbol
        The time t.
    inputs : sequence of r sympy.Symbol, optional
        The control variables u.
    inputs_along : sequence of r sympy.Expr, optional
        The nominal input, in the symbol `time`.

    Returns
    -------
    A : sympy.Matrix, shape (n, n)
        df/dy along the trajectory.
    B : sympy.Matrix, shape (n, r)
        df/du along the trajectory.

    Raises
    ------
    ValueError
        If the trajectory does not satisfy the equation; the message has the residual dy*/dt - f(y*,
        u*, t).

    Notes
    -----
    Source: equations (1.2), (1.3) of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> x, y, u, t, V0 = sp.symbols("x y u t V0")
    >>> A, B = linearise_along([u*sp.cos(y), u*sp.sin(y)], [x, y], [V0*t, 0], t, [u], [V0])
    >>> A, B
    (Matrix([
    [0,  0],
    [0, V0]]), Matrix([
    [1],
    [0]]))
    """
    field, state = read_field(field, state)
    inputs = read_symbols(inputs, "inputs")
    (time,) = read_symbols(time, "time")
    if time in state or time in inputs:
        raise ValueError(f"time: {time} is also a state variable or an input")
    motion = read_expressions(motion, len(state), "motion")
    point = dict(
        zip(state + inputs, motion + read_expressions(inputs_along, len(inputs), "inputs_along"))
    )
    residual = sp.Matrix([sp.diff(y, time) - _at(f, point, "field") for y, f in zip(motion, field)])
    if not all(map(vanishes, residual)):
        raise ValueError(
            "motion: it does not satisfy the equation; dy/dt - f is "
            f"{list(residual.applyfunc(sp.simplify))}"
        )
    A, B = _jacobians(field, state, inputs)
    return tuple(
        M.applyfunc(lambda e: _at(e, point, "the derivative of the field")) for M in (A, B)
    )


def _jacobians(field, state, inputs):
    f = sp.Matrix(field)
    B = f.jacobian(inputs) if inputs else sp.zeros(len(state), 0)
    return f.jacobian(state), B


def _at(expression, point, name):
    value = expression.subs(point, simultaneous=True)
    if value.has(sp.nan, sp.zoo, sp.oo, -sp.oo):
        raise ValueError(f"at: {name} {expression} is not defined there")
    return value


def _vanishes_numerically(residual, field, point):
    """Whether a residual is of rounding size, compared with the terms that cancel."""
    for value, f in zip(residual, field):
        size = sum(
            abs(complex(term.subs(point, simultaneous=True)))
            for term in sp.Add.make_args(sp.expand(f))
        )
        if abs(complex(value)) > 1e-9 * max(size, 1):
            return False
    return True

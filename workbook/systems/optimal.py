"""Optimal control problems and their systems as records."""

from dataclasses import dataclass

import sympy as sp

from workbook.systems._matrices import set_matrices, to_matrix


@dataclass(frozen=True)
class Controlled:
    """The system x' = f(x, u) with one control u that lies between two bounds.

    Parameters
    ----------
    dynamics : dict
        {state: right-hand side}.
    controls : dict
        {u: (lower, upper)}.

    Raises
    ------
    ValueError
        If there is not one control with two bounds.

    Notes
    -----
    Unpacked it gives both, in the form that `pontryagin.Problem` takes:
    `Problem(*system, initial, terminal)`.

    Examples
    --------
    >>> x1, x2, u = sp.symbols("x1 x2 u")
    >>> oscillator = Controlled({x1: x2, x2: u - x1}, {u: (-1, 1)})
    >>> oscillator.state, oscillator.field, oscillator.bounds
    ([x1, x2], [x2, u - x1], (-1, 1))
    """

    dynamics: dict
    controls: dict

    def __post_init__(self):
        if [len(bounds) for bounds in self.controls.values()] != [2]:
            raise ValueError("expected one control with two bounds, as {u: (-1, 1)}")

    def __iter__(self):
        return iter((self.dynamics, self.controls))

    @property
    def state(self):
        """The states, a list of symbols."""
        return list(self.dynamics)

    @property
    def field(self):
        """The right-hand sides, a list of expressions."""
        return list(self.dynamics.values())

    @property
    def control(self):
        """The control, a symbol."""
        (control,) = self.controls
        return control

    @property
    def bounds(self):
        """The lower and the upper bound of the control."""
        return tuple(self.controls[self.control])


@dataclass(frozen=True)
class Quadratic:
    """The system x' = A x + B u with a quadratic cost, which is to be least.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system.
    B : matrix_like, shape (n, s)
        A column for each control.
    G, N : matrix_like, shapes (n, n) and (s, s)
        Symmetric weights of the state and of the control.
    F : matrix_like, shape (n, n), optional
        Symmetric weight of the final state; left out, zero.
    duration : sympy.Expr, optional
        The final time T; left out, infinite.
    factor : sympy.Expr, optional
        Factor of the whole cost.
    anywhere : bool
        Whether, in infinite time, also laws are admitted that do not bring every state to zero:
        states that the cost does not depend on may then move arbitrarily.

    Raises
    ------
    ValueError
        If shapes do not fit or a weight is not symmetric.

    Notes
    -----
    The cost is J = factor (int_0^T (x^T G x + u^T N u) dt + x(T)^T F x(T)). What is 1 x 1 may be
    written as a number or an expression.

    Examples
    --------
    >>> from workbook.systems import Quadratic
    >>> Quadratic(A=1, B=1, G=1, N=2, factor=sp.Rational(1, 2)).N
    Matrix([[2]])
    """

    A: sp.Matrix
    B: sp.Matrix
    G: sp.Matrix
    N: sp.Matrix
    F: sp.Matrix = 0
    duration: sp.Expr = sp.oo
    factor: sp.Expr = 1
    anywhere: bool = False

    def __post_init__(self):
        n, s = to_matrix(self.A, None).rows, to_matrix(self.B, None).cols
        shapes = {"A": (n, n), "B": (n, s), "G": (n, n), "N": (s, s), "F": (n, n)}
        set_matrices(self, shapes, "A and B", ("G", "N", "F"), "the weight of a square")

    def subs(self, *values):
        """Return the problem with values, or other expressions, for its symbols."""
        parts = (
            sp.sympify(getattr(self, name)).subs(*values)
            for name in ("A", "B", "G", "N", "F", "duration", "factor")
        )
        return Quadratic(*parts, anywhere=self.anywhere)


@dataclass(frozen=True)
class Functional:
    """A functional of the calculus of variations.

    Parameters
    ----------
    integrand : sympy.Expr
        L, an expression in t, x(t) and derivatives of x(t).
    motion : sympy.Expr
        x(t), a function applied to the symbol of time.
    interval : tuple
        (t, a, b), with parameters if need be.
    start, end : list, optional
        Values of x, x', ... at a and at b, None for one that is free; those left out are free, too.
    final : sympy.Expr, optional
        Phi, an expression in x(b) and the derivatives there, written as `x(t).diff(t).subs(t, b)`.
    maximise : bool
        Whether the functional is to be greatest instead of least.

    Raises
    ------
    ValueError
        With the argument's name, if one is not of this form.

    Notes
    -----
    J[x] = int_a^b L(t, x, x', ..., x^(n)) dt + Phi(x(b), ..., x^(n-1)(b)).

    Examples
    --------
    >>> t, x = sp.Symbol("t"), sp.Function("x")
    >>> Functional(x(t).diff(t, 2)**2, x(t), (t, 0, 1), start=[0]).start
    (0, None)
    """

    integrand: sp.Expr
    motion: sp.Expr
    interval: tuple
    start: tuple = ()
    end: tuple = ()
    final: sp.Expr = 0
    maximise: bool = False

    def __post_init__(self):
        values = {name: sp.sympify(getattr(self, name)) for name in ("integrand", "final")}
        values["interval"] = tuple(map(sp.sympify, self.interval))
        if len(values["interval"]) != 3 or not isinstance(values["interval"][0], sp.Symbol):
            raise ValueError(f"interval: expected (t, begin, end), got {self.interval}")
        if (
            getattr(self.motion, "args", None) != (values["interval"][0],)
            or not self.motion.is_Function
        ):
            raise ValueError(
                f"motion: expected a function of {values['interval'][0]}, got {self.motion}"
            )
        for name, value in values.items():
            object.__setattr__(self, name, value)
        if not self.order:
            raise ValueError(f"integrand: no derivative of {self.motion} stands in it")
        for name in ("start", "end"):
            boundary = [
                None if value is None else sp.sympify(value) for value in getattr(self, name)
            ]
            if len(boundary) > self.order:
                raise ValueError(
                    f"{name}: {len(boundary)} values; with derivatives up to order {self.order} at "
                    f"most {self.order} can be given"
                )
            object.__setattr__(self, name, (*boundary, *[None] * (self.order - len(boundary))))

    @property
    def time(self):
        """The symbol t of the time."""
        return self.interval[0]

    @property
    def order(self):
        """The order n of the highest derivative in the integrand."""
        return max(
            (
                int(d.derivative_count)
                for d in self.integrand.atoms(sp.Derivative)
                if d.expr == self.motion
            ),
            default=0,
        )

    @property
    def derivatives(self):
        """x, x', ..., x^(n): a tuple of n + 1 expressions."""
        return (self.motion, *(self.motion.diff(self.time, k) for k in range(1, self.order + 1)))

    @property
    def parameters(self):
        """The symbols besides time, sorted by name."""
        symbols = set().union(
            *(
                e.free_symbols
                for e in (self.integrand, self.final, *self.interval, *self.start, *self.end)
                if e is not None
            )
        )
        return tuple(sorted(symbols - {self.time}, key=str))

    def subs(self, values):
        """Return the same functional with values for its parameters."""

        def substituted(e):
            return None if e is None else e.subs(values)

        return Functional(
            substituted(self.integrand),
            self.motion,
            tuple(map(substituted, self.interval)),
            tuple(map(substituted, self.start)),
            tuple(map(substituted, self.end)),
            substituted(self.final),
            self.maximise,
        )

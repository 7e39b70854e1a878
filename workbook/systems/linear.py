"""Linear systems and measurements as records."""

from dataclasses import dataclass, field, fields

import sympy as sp

from workbook.systems._matrices import is_zero, set_matrices


@dataclass(frozen=True)
class Linear:
    """The linear system x' = A x + B u with the output z = H x.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system, with symbols or without.
    B : matrix_like, shape (n, s), optional
        A column for each control; left out, there is no control.
    H : matrix_like, shape (m, n), optional
        A row for each output; left out, there is no output.

    Raises
    ------
    ValueError
        If the shapes do not fit.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> Linear([[0, 1], [0, 0]], H=[[1, 0]]).dual.B
    Matrix([
    [1],
    [0]])
    """

    A: sp.Matrix
    B: sp.Matrix = ()
    H: sp.Matrix = ()

    def __post_init__(self):
        n, s, m = sp.Matrix(self.A).rows, sp.Matrix(self.B).cols, sp.Matrix(self.H).rows
        set_matrices(self, {"A": (n, n), "B": (n, s), "H": (m, n)}, "A")

    @property
    def unknowns(self):
        """The number of coordinates of an initial state."""
        return self.A.rows

    @property
    def dual(self):
        """The dual system x' = A^T x + H^T u with the output z = B^T x."""
        return Linear(self.A.T, self.H.T, self.B.T)

    def subs(self, *values):
        """Return the system with values, or other expressions, for its symbols."""
        return type(self)(*(getattr(self, f.name).subs(*values) for f in fields(self)))


@dataclass(frozen=True)
class WithError(Linear):
    """A linear system measured with an error of a known kind: z = H x + c w, w' = S w.

    Parameters
    ----------
    A, B, H : matrix_like
        As for `Linear`.
    S : matrix_like, shape (k, k)
        Matrix of the error's equations.
    c : matrix_like, shape (m, k)
        The row of each output in which the error enters.
    start : matrix_like, shape (k, 1), optional
        The direction of the error's initial state: w(0) = C start with an unknown number C. Left out,
        w(0) may be anything.

    Raises
    ------
    ValueError
        If the shapes do not fit.

    Examples
    --------
    >>> from workbook.systems import WithError
    >>> WithError([[0]], H=[[1]], S=[[0]], c=[[1]], start=[1]).unknowns
    2
    """

    S: sp.Matrix = ()
    c: sp.Matrix = ()
    start: sp.Matrix = ()

    def __post_init__(self):
        super().__post_init__()
        k, known = sp.Matrix(self.S).rows, sp.Matrix(self.start).rows > 0
        set_matrices(
            self, {"S": (k, k), "c": (self.H.rows, k), "start": (k * known, 1 * known)}, "H and S"
        )

    @property
    def unknowns(self):
        """The number of coordinates of an initial state: of x(0), and the amplitude C or w(0)."""
        return self.A.rows + (self.start.cols or self.S.rows)


@dataclass(frozen=True)
class Varying:
    """The system x' = A x with the output z = H(t) x, whose row depends on time.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system.
    H : matrix_like, shape (1, n)
        Row of sines, cosines, exponentials and powers of the time.
    time : sympy.Symbol
        The time t.

    Raises
    ------
    ValueError
        If the shapes do not fit.

    Examples
    --------
    >>> t = sp.Symbol("t")
    >>> from workbook.systems import Varying
    >>> Varying([[0, 1], [0, 0]], [[sp.cos(t), 0]], t).subs(t, 0).H
    Matrix([[1, 0]])
    """

    A: sp.Matrix
    H: sp.Matrix
    time: sp.Symbol

    def __post_init__(self):
        n = sp.Matrix(self.A).rows
        set_matrices(self, {"A": (n, n), "H": (1, n)}, "A")

    @property
    def unknowns(self):
        """The number of coordinates of an initial state."""
        return self.A.rows

    def subs(self, *values):
        """Return the system with values, or other expressions, for its symbols."""
        return Varying(self.A.subs(*values), self.H.subs(*values), self.time)


@dataclass(frozen=True)
class Measurements:
    """Measurements z = h(x) of constant unknowns x.

    Parameters
    ----------
    quantities : list of sympy.Expr
        The measured functions h of the unknowns.
    unknown : list of sympy.Symbol
        The unknowns x.
    at : dict, optional
        {symbol: expression}: the values of the unknowns; left out, they may have any values.

    Examples
    --------
    >>> x, y = sp.symbols("x y")
    >>> from workbook.systems import Measurements
    >>> Measurements([x**2 + y**2], [x, y]).jacobian
    Matrix([[2*x, 2*y]])
    """

    quantities: list
    unknown: list
    at: dict = field(default_factory=dict)

    @property
    def unknowns(self):
        """The number of unknowns."""
        return len(self.unknown)

    @property
    def jacobian(self):
        """The derivatives of the quantities by the unknowns, at the values of these."""
        derivatives = sp.Matrix(self.quantities).jacobian(list(self.unknown))
        return derivatives.subs(self.at, simultaneous=True).as_immutable()


@dataclass(frozen=True)
class Deviations:
    """The linear system of small deviations from a motion of y' = f(y).

    Parameters
    ----------
    field : list of sympy.Expr
        The n right-hand sides f.
    state : list of sympy.Symbol
        The n symbols y.
    motion : dict
        {symbol: function of time}: the motion, along which the linear system is constant.

    Raises
    ------
    ValueError
        If the three have different lengths.

    Examples
    --------
    >>> r, w, t = sp.symbols("r w t")
    >>> from workbook.systems import Deviations
    >>> Deviations([0, r], [r, w], {r: 1, w: t}).state
    [r, w]
    """

    field: list
    state: list
    motion: dict

    def __post_init__(self):
        if not len(self.field) == len(self.state) == len(self.motion):
            raise ValueError(
                f"field, state, motion: expected as many of each, got {len(self.field)}, "
                f"{len(self.state)}, {len(self.motion)}"
            )


@dataclass(frozen=True)
class Mechanical:
    """The mechanical system M x'' + D x' + K x = L u with the output z = H1 x + H2 x'.

    Parameters
    ----------
    M, D, K : matrix_like, shape (n, n)
        Inertia, damping and stiffness, with symbols or without; 0 stands for a zero matrix.
    L : matrix_like, shape (n, s), optional
        A column for each control; 0 or left out, there is no control.
    H1, H2 : matrix_like, shape (m, n), optional
        Rows for the outputs of positions and of velocities; 0 or left out, zero matrices.

    Raises
    ------
    ValueError
        If the shapes do not fit.
    """

    M: sp.Matrix
    D: sp.Matrix
    K: sp.Matrix
    L: sp.Matrix = 0
    H1: sp.Matrix = 0
    H2: sp.Matrix = 0

    def __post_init__(self):
        n = sp.Matrix(self.M).rows
        outputs = max(
            [sp.Matrix(rows).rows for rows in (self.H1, self.H2) if not is_zero(rows)], default=1
        )
        shapes = {
            "M": (n, n),
            "D": (n, n),
            "K": (n, n),
            "L": (n, None),
            "H1": (outputs, n),
            "H2": (outputs, n),
        }
        for name, (rows, columns) in shapes.items():
            value = getattr(self, name)
            matrix = sp.zeros(rows, columns or 1) if is_zero(value) else sp.Matrix(value)
            if matrix.rows != rows or columns not in (None, matrix.cols):
                raise ValueError(
                    f"{name} has the shape {matrix.shape}; with this M it has to have {rows} rows"
                    + (f" and {columns} columns" if columns else "")
                )
            object.__setattr__(self, name, matrix.as_immutable())

    @property
    def unknowns(self):
        """The number of coordinates of an initial state, x(0) and x'(0)."""
        return 2 * self.M.rows

    @property
    def dual(self):
        """The dual system M^T x'' + D^T x' + K^T x = 0 with the output z = L^T x."""
        return Mechanical(self.M.T, self.D.T, self.K.T, H1=self.L.T)

    def subs(self, *values):
        """Return the system with values, or other expressions, for its symbols."""
        return Mechanical(
            *(getattr(self, name).subs(*values) for name in ("M", "D", "K", "L", "H1", "H2"))
        )


@dataclass(frozen=True)
class Scalar:
    """The system left(d/dt) x = right(d/dt) u with the output z = measured(d/dt) x.

    Parameters
    ----------
    left, right, measured : sympy.Expr
        Polynomials in `symbol`; the degrees of `right` and `measured` are below that of `left`, so
        that neither x nor z contains u itself or its derivatives.
    symbol : sympy.Symbol
        The symbol that stands for d/dt.

    Raises
    ------
    ValueError
        If the degrees are not of this kind.

    Examples
    --------
    >>> from sympy.abc import s
    >>> from workbook.systems import Scalar
    >>> Scalar(s**2 - s - 2, s + 1, 1, s).order
    2
    """

    left: sp.Expr
    right: sp.Expr
    measured: sp.Expr
    symbol: sp.Symbol

    def __post_init__(self):
        for name in ("right", "measured"):
            if not self._poly(name).degree() < self.order:
                raise ValueError(f"{name}: expected a lower degree than that of left, {self.order}")
        if self._poly("right").degree() + self._poly("measured").degree() >= self.order:
            raise ValueError("right, measured: z holds the control itself")

    def _poly(self, name):
        return sp.Poly(getattr(self, name), self.symbol)

    @property
    def order(self):
        """The order of the equation, the degree of `left`."""
        return self._poly("left").degree()

    @property
    def coefficients(self):
        """Three lists: the coefficients of left, right and measured, that of the power 0 first."""
        return [self._poly(name).all_coeffs()[::-1] for name in ("left", "right", "measured")]

"""Systems and functionals as records: what belongs together under one name, as the data cells of
problems state it.

>>> from workbook.systems import Mechanical
>>> pendulums = Mechanical(M=[[2, 1], [1, 1]], D=0, K=[[-5, 0], [0, 6]], H1=[[1, 3]])
>>> pendulums.K
Matrix([
[-5, 0],
[ 0, 6]])
>>> pendulums.H2
Matrix([[0, 0]])
"""

from dataclasses import dataclass, field, fields

import sympy as sp


@dataclass(frozen=True)
class Linear:
    """The system x' = A x + B u with the output z = H x; what is left out is not there.

    A: n x n; B: n x s, a column for each control; H: m x n, a row for each output. Matrices or
    lists of rows, with symbols or without.

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
        _set_matrices(self, {"A": (n, n), "B": (n, s), "H": (m, n)}, "A")

    @property
    def unknowns(self):
        """How many numbers a start consists of."""
        return self.A.rows

    @property
    def dual(self):
        """The system whose output shows what the control of this one reaches."""
        return Linear(self.A.T, self.H.T, self.B.T)

    def subs(self, *values):
        """The system with values, or other expressions, for its symbols."""
        return type(self)(*(getattr(self, one.name).subs(*values) for one in fields(self)))


@dataclass(frozen=True)
class WithError(Linear):
    """A linear system that is measured with an error of a known kind and an unknown size: z = H x +
    c w, w' = S w, w(0) = C `start`.

    S: k x k; c: m x k; start: k numbers, left out where w(0) may be anything.

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
        _set_matrices(
            self, {"S": (k, k), "c": (self.H.rows, k), "start": (k * known, 1 * known)}, "H and S"
        )

    @property
    def unknowns(self):
        """How many numbers a start consists of: x(0), and the amplitude C or w(0)."""
        return self.A.rows + (self.start.cols or self.S.rows)


@dataclass(frozen=True)
class Varying:
    """The system x' = A x with the output z = H(t) x, whose row changes with the `time`.

    A: n x n; H: 1 x n, of sines, cosines, exponentials and powers of the time.

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
        _set_matrices(self, {"A": (n, n), "H": (1, n)}, "A")

    @property
    def unknowns(self):
        """How many numbers a start consists of."""
        return self.A.rows

    def subs(self, *values):
        """The system with values, or other expressions, for its symbols."""
        return Varying(self.A.subs(*values), self.H.subs(*values), self.time)


@dataclass(frozen=True)
class Measurements:
    """Measurements z = h(x) of constant unknowns x: the `quantities` measured, the symbols that are
    `unknown`, and `at` {symbol: expression} where these are, unless they stand for any values.

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
        """How many numbers are unknown."""
        return len(self.unknown)

    @property
    def jacobian(self):
        """The derivatives of the quantities by the unknowns, where these are."""
        found = sp.Matrix(self.quantities).jacobian(list(self.unknown))
        return found.subs(self.at, simultaneous=True).as_immutable()


@dataclass(frozen=True)
class Deviations:
    """The linear system of small deviations from a motion of y' = f(y), which is constant along the
    motion.

    field: the n right-hand sides; state: the n symbols; motion: {symbol: function of time}.

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
    """The system M x'' + D x' + K x = L u with the output z = H1 x + H2 x'; what is 0 or left out
    is not there.

    M, D, K: n x n; L: n x s, a column for each control; H1, H2: m x n, a row for each output.
    Matrices or lists, with symbols or without.
    """

    M: sp.Matrix
    D: sp.Matrix
    K: sp.Matrix
    L: sp.Matrix = 0
    H1: sp.Matrix = 0
    H2: sp.Matrix = 0

    def __post_init__(self):
        n = sp.Matrix(self.M).rows
        outputs = max([sp.Matrix(rows).rows for rows in (self.H1, self.H2) if rows != 0], default=1)
        shapes = {
            "M": (n, n),
            "D": (n, n),
            "K": (n, n),
            "L": (n, None),
            "H1": (outputs, n),
            "H2": (outputs, n),
        }
        for name, (rows, columns) in shapes.items():
            given = getattr(self, name)
            matrix = sp.zeros(rows, columns or 1) if given == 0 else sp.Matrix(given)
            if matrix.rows != rows or columns not in (None, matrix.cols):
                raise ValueError(
                    f"{name} has the shape {matrix.shape}; with this M it has to have {rows} rows"
                    + (f" and {columns} columns" if columns else "")
                )
            object.__setattr__(self, name, matrix.as_immutable())

    @property
    def unknowns(self):
        """How many numbers a start consists of, x(0) and x'(0)."""
        return 2 * self.M.rows

    @property
    def dual(self):
        """The system whose output shows what the control of this one reaches."""
        return Mechanical(self.M.T, self.D.T, self.K.T, H1=self.L.T)

    def subs(self, *values):
        """The system with values, or other expressions, for its symbols."""
        return Mechanical(
            *(getattr(self, name).subs(*values) for name in ("M", "D", "K", "L", "H1", "H2"))
        )


@dataclass(frozen=True)
class Controlled:
    """The system x' = f(x, u) with one control u that lies between two bounds.

    dynamics: {state: right-hand side}; controls: {u: (lower, upper)}. Unpacked it gives both, in
    the form that `pontryagin.Problem` takes: `Problem(*system, initial, terminal)`.

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
        return list(self.dynamics)

    @property
    def field(self):
        return list(self.dynamics.values())

    @property
    def control(self):
        (control,) = self.controls
        return control

    @property
    def bounds(self):
        return tuple(self.controls[self.control])


@dataclass(frozen=True)
class Process:
    """A random process x' = A x + q, in discrete time x(k + 1) = A x(k) + q(k), measured as z = H x
    + r.

    q and r are white noises without a mean, independent of each other and of x(0), which has the
    `mean` and the `covariance`. In continuous time Q is the intensity of q, in discrete time its
    covariance; R belongs to r, and to a single measurement it is a covariance in continuous time
    too. A, Q and the covariance: n x n; H: m x n; R: m x m; mean: n x 1. Matrices, lists or, where
    they are 1 x 1, numbers and symbols; what is 0 or left out is not there.

    >>> from workbook.systems import Process
    >>> Process(A=-1, Q=2, H=1, R=1, mean=1, covariance=3).covariance
    Matrix([[3]])
    """

    A: sp.Matrix
    Q: sp.Matrix = 0
    H: sp.Matrix = 0
    R: sp.Matrix = 0
    mean: sp.Matrix = 0
    covariance: sp.Matrix = 0
    discrete: bool = False

    def __post_init__(self):
        n, m = _matrix(self.A, None).rows, _matrix(self.H, None).rows if self.H != 0 else 0
        shapes = {
            "A": (n, n),
            "Q": (n, n),
            "H": (m, n),
            "R": (m, m),
            "mean": (n, 1),
            "covariance": (n, n),
        }
        _set_matrices(
            self, shapes, "A and H", ("Q", "R", "covariance"), "a covariance or an intensity"
        )

    @property
    def unknowns(self):
        """How many numbers a start consists of."""
        return self.A.rows

    def subs(self, *values):
        """The process with values, or other expressions, for its symbols."""
        return Process(
            *(
                getattr(self, name).subs(*values)
                for name in ("A", "Q", "H", "R", "mean", "covariance")
            ),
            discrete=self.discrete,
        )


@dataclass(frozen=True)
class Quadratic:
    """The system x' = A x + B u with a quadratic cost, which is to be least:

        J = factor (int_0^T (x^T G x + u^T N u) dt + x(T)^T F x(T)).

    A, G, F: n x n; B: n x s; N: s x s. Matrices, lists or, where they are 1 x 1, numbers and
    symbols; F left out is not there. Without a `duration` T the time is infinite. Then only laws
    count that bring every state to zero, unless `anywhere`: the states that the cost does not see
    may then do what they like.

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
        n, s = _matrix(self.A, None).rows, _matrix(self.B, None).cols
        shapes = {"A": (n, n), "B": (n, s), "G": (n, n), "N": (s, s), "F": (n, n)}
        _set_matrices(self, shapes, "A and B", ("G", "N", "F"), "the weight of a square")

    def subs(self, *values):
        """The problem with values, or other expressions, for its symbols."""
        parts = (
            sp.sympify(getattr(self, name)).subs(*values)
            for name in ("A", "B", "G", "N", "F", "duration", "factor")
        )
        return Quadratic(*parts, anywhere=self.anywhere)


@dataclass(frozen=True)
class Coloured:
    """A system x' = A x + B w, z = H x + C w + r with a noise w of which the correlation function
    is known.

    w is a single stationary process without a mean, `correlation` = M[w(t) w(t + delay)] for a
    `delay` >= 0, an expression in this symbol; r is white noise of the intensity R. w, r and x(0),
    which has the `covariance` and no mean, do not correlate. A and the covariance: n x n, H: m x n,
    B: n x 1, C: m x 1, R: m x m, as for `Process`. If w itself is what is measured, A, B and H are
    left out.

    >>> tau = sp.Symbol("tau", nonnegative=True)
    >>> from workbook.systems import Coloured
    >>> Coloured(8*sp.exp(-tau), tau, A=0, B=1, H=1, R=1).C
    Matrix([[0]])
    """

    correlation: sp.Expr
    delay: sp.Symbol
    A: sp.Matrix = ()
    B: sp.Matrix = ()
    H: sp.Matrix = ()
    C: sp.Matrix = 0
    R: sp.Matrix = 0
    covariance: sp.Matrix = 0

    def __post_init__(self):
        n = (
            sp.Matrix(self.A).rows
            if isinstance(self.A, (list, tuple))
            else _matrix(self.A, None).rows
        )
        m = _matrix(self.H if n else self.C, None).rows
        shapes = {
            "A": (n, n),
            "B": (n, 1),
            "H": (m, n),
            "C": (m, 1),
            "R": (m, m),
            "covariance": (n, n),
        }
        _set_matrices(self, shapes, "A and H")
        object.__setattr__(self, "correlation", sp.sympify(self.correlation))

    def subs(self, *values):
        """The system with values, or other expressions, for its symbols."""
        return Coloured(
            self.correlation.subs(*values),
            self.delay,
            *(
                getattr(self, name).subs(*values)
                for name in ("A", "B", "H", "C", "R", "covariance")
            ),
        )


@dataclass(frozen=True)
class FilterErrors:
    """The errors x - y of the filter y' = A y + K (z - H y), in discrete time y(k + 1) = A y(k) + K
    (z(k) - H y(k)), with any gain K, from y(0), the mean of x(0).

    process: the `Process` or `Coloured` system that is measured, of the latter the noise belongs to
    x; gain: n x m.

    >>> K = sp.Symbol("K")
    >>> from workbook.systems import FilterErrors, Process
    >>> FilterErrors(Process(A=-1, Q=2, H=1, R=1), [[K]]).gain
    Matrix([[K]])
    """

    process: Process | Coloured
    gain: sp.Matrix

    def __post_init__(self):
        n, m = self.process.A.rows + isinstance(self.process, Coloured), self.process.H.rows
        _set_matrices(self, {"gain": (n, m)}, "process")


def _set_matrices(record, shapes, given, symmetric=(), meaning=""):
    """Make the named fields matrices of these shapes; those `symmetric` are what `meaning` says."""
    for name, shape in shapes.items():
        matrix = _matrix(getattr(record, name), shape) if 0 not in shape else sp.zeros(*shape)
        if matrix.shape != shape:
            raise ValueError(
                f"{name} has the shape {matrix.shape}; with this {given} it has to have {shape}"
            )
        if name in symmetric and sp.expand(matrix - matrix.T) != sp.zeros(*shape):
            raise ValueError(f"{name} is {meaning}, so it has to be symmetric")
        object.__setattr__(record, name, matrix.as_immutable())


def _matrix(given, shape):
    if shape is not None and not isinstance(given, (list, tuple, sp.MatrixBase)) and given == 0:
        return sp.zeros(*shape)
    return sp.Matrix(
        given
        if isinstance(given, (list, tuple, sp.MatrixBase)) or hasattr(given, "shape")
        else [[given]]
    )


@dataclass(frozen=True)
class Functional:
    """A functional of the calculus of variations,

        J[x] = int_a^b L(t, x, x', ..., x^(n)) dt + Phi(x(b), ..., x^(n-1)(b)).

    - `integrand`: an expression in t, x(t) and derivatives of x(t);
    - `motion`: x(t), a function applied to the symbol of time;
    - `interval`: (t, a, b), with parameters if need be;
    - `start`, `end`: lists of the values of x, x', ... at both ends, None for one that is free;
      what is left out is free, too;
    - `final`: an expression in x(b) and the derivatives there, written as `x(t).diff(t).subs(t,
      b)`;
    - `maximise`: whether the functional is to be made greatest.

    Raises ValueError, with the argument's name, for whatever is not of this form.

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
        put = {name: sp.sympify(getattr(self, name)) for name in ("integrand", "final")}
        put["interval"] = tuple(map(sp.sympify, self.interval))
        if len(put["interval"]) != 3 or not isinstance(put["interval"][0], sp.Symbol):
            raise ValueError(f"interval: expected (t, begin, end), got {self.interval}")
        if (
            getattr(self.motion, "args", None) != (put["interval"][0],)
            or not self.motion.is_Function
        ):
            raise ValueError(
                f"motion: expected a function of {put['interval'][0]}, got {self.motion}"
            )
        for name, value in put.items():
            object.__setattr__(self, name, value)
        if not self.order:
            raise ValueError(f"integrand: no derivative of {self.motion} stands in it")
        for name in ("start", "end"):
            given = [None if value is None else sp.sympify(value) for value in getattr(self, name)]
            if len(given) > self.order:
                raise ValueError(
                    f"{name}: {len(given)} values; with derivatives up to order {self.order} at "
                    f"most {self.order} can be given"
                )
            object.__setattr__(self, name, (*given, *[None] * (self.order - len(given))))

    @property
    def time(self):
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
        """x, x', ..., x^(n), a tuple of n + 1 expressions."""
        return (self.motion, *(self.motion.diff(self.time, k) for k in range(1, self.order + 1)))

    @property
    def parameters(self):
        """The symbols besides time, sorted by name."""
        found = set().union(
            *(
                e.free_symbols
                for e in (self.integrand, self.final, *self.interval, *self.start, *self.end)
                if e is not None
            )
        )
        return tuple(sorted(found - {self.time}, key=str))

    def subs(self, values):
        """The same functional with values for its parameters."""

        def put(e):
            return None if e is None else e.subs(values)

        return Functional(
            put(self.integrand),
            self.motion,
            tuple(map(put, self.interval)),
            tuple(map(put, self.start)),
            tuple(map(put, self.end)),
            put(self.final),
            self.maximise,
        )


@dataclass(frozen=True)
class Scalar:
    """The system left(d/dt) x = right(d/dt) u with the output z = measured(d/dt) x: one equation,
    one control, one output.

    Three polynomials in `symbol`, which stands for d/dt; the degrees of `right` and `measured` are
    below that of `left`, so that neither x nor z holds u itself or its derivatives.

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
        return self._poly("left").degree()

    @property
    def coefficients(self):
        """Those of left, right and measured, of the power 0 first: three lists."""
        return [self._poly(name).all_coeffs()[::-1] for name in ("left", "right", "measured")]

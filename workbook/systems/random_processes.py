"""Random processes and the errors of their filters as records."""

from dataclasses import dataclass

import sympy as sp

from workbook.systems._matrices import is_zero, set_matrices, to_matrix


@dataclass(frozen=True)
class Process:
    """A random process x' = A x + q, or x(k + 1) = A x(k) + q(k), measured as z = H x + r.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the process.
    Q : matrix_like, shape (n, n), optional
        Intensity of the noise q, in discrete time its covariance.
    H : matrix_like, shape (m, n), optional
        A row for each measurement; left out, nothing is measured.
    R : matrix_like, shape (m, m), optional
        Intensity of the noise r, in discrete time its covariance; for a single measurement in
        continuous time its covariance, too.
    mean : matrix_like, shape (n, 1), optional
        Mean of x(0).
    covariance : matrix_like, shape (n, n), optional
        Covariance of x(0).
    discrete : bool
        Whether time is discrete.

    Raises
    ------
    ValueError
        If shapes do not fit, or a covariance or an intensity is not symmetric.

    Notes
    -----
    q and r are white noises of zero mean, independent of each other and of x(0). What is 1 x 1 may be
    written as a number or an expression; what is 0 or left out is a zero matrix.

    Examples
    --------
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
        n, m = to_matrix(self.A, None).rows, 0 if is_zero(self.H) else to_matrix(self.H, None).rows
        shapes = {
            "A": (n, n),
            "Q": (n, n),
            "H": (m, n),
            "R": (m, m),
            "mean": (n, 1),
            "covariance": (n, n),
        }
        set_matrices(
            self, shapes, "A and H", ("Q", "R", "covariance"), "a covariance or an intensity"
        )

    @property
    def unknowns(self):
        """The number of coordinates of an initial state."""
        return self.A.rows

    def subs(self, *values):
        """Return the process with values, or other expressions, for its symbols."""
        return Process(
            *(
                getattr(self, name).subs(*values)
                for name in ("A", "Q", "H", "R", "mean", "covariance")
            ),
            discrete=self.discrete,
        )


@dataclass(frozen=True)
class Coloured:
    """A system x' = A x + B w, z = H x + C w + r with a coloured noise w.

    Parameters
    ----------
    correlation : sympy.Expr
        Correlation function E[w(t) w(t + delay)] of w, a stationary process of zero mean, for a
        delay >= 0.
    delay : sympy.Symbol
        Its argument.
    A : matrix_like, shape (n, n), optional
        Matrix of the system. Without A, B and H, the noise w itself is measured.
    B : matrix_like, shape (n, 1), optional
        Column in which w enters the system.
    H : matrix_like, shape (m, n), optional
        A row for each measurement.
    C : matrix_like, shape (m, 1), optional
        Column in which w enters the measurements.
    R : matrix_like, shape (m, m), optional
        Intensity of the white noise r.
    covariance : matrix_like, shape (n, n), optional
        Covariance of x(0), whose mean is zero.

    Raises
    ------
    ValueError
        If shapes do not fit.

    Notes
    -----
    w, r and x(0) are uncorrelated.

    Examples
    --------
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
            else to_matrix(self.A, None).rows
        )
        m = to_matrix(self.H if n else self.C, None).rows
        shapes = {
            "A": (n, n),
            "B": (n, 1),
            "H": (m, n),
            "C": (m, 1),
            "R": (m, m),
            "covariance": (n, n),
        }
        set_matrices(self, shapes, "A and H")
        object.__setattr__(self, "correlation", sp.sympify(self.correlation))

    def subs(self, *values):
        """Return the system with values, or other expressions, for its symbols."""
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
    """The errors x - y of the filter y' = A y + K (z - H y) with any gain K.

    Parameters
    ----------
    process : Process or Coloured
        The measured system; of a `Coloured` one, the noise belongs to x.
    gain : matrix_like, shape (n, m)
        The gain K.

    Raises
    ------
    ValueError
        If shapes do not fit.

    Notes
    -----
    In discrete time y(k + 1) = A y(k) + K (z(k) - H y(k)). Initially y(0) is the mean of x(0).

    Examples
    --------
    >>> K = sp.Symbol("K")
    >>> from workbook.systems import FilterErrors, Process
    >>> FilterErrors(Process(A=-1, Q=2, H=1, R=1), [[K]]).gain
    Matrix([[K]])
    """

    process: Process | Coloured
    gain: sp.Matrix

    def __post_init__(self):
        n, m = self.process.A.rows + isinstance(self.process, Coloured), self.process.H.rows
        set_matrices(self, {"gain": (n, m)}, "process")

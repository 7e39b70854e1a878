r"""Decomposition by the components of the control and of the output, example 7.

Control, x' = Ax + b^1 u_1 + ... + b^s u_s; new coordinates y with x = P y, P = T^-1.

*Sequential.* The columns of P are the chain b^1, A b^1, ..., A^(k_1 - 1) b^1 as long as it is
independent, then the chain of b^2 as long as it is independent of all columns before it, and so on.
Then T A P is block upper triangular:

    y_1' = C_1 y_1 + A_12 y_2 + ... + e_1 u_1,    y_2' = C_2 y_2 + ... + e_1 u_2,    ...

C_i has ones below the diagonal and coefficients in the last column, A_ij (i < j) is zero but for
its last column. The last subsystem is controlled by u_s alone, for any others; u_1 alone
controls the first one, the others being its disturbances. If b^j depends on the columns before it,
its subsystem is empty (size 0), and u_j acts on the earlier ones.

*Parallel (shuttle).* The vectors are taken in the order b^1, ..., b^s, A b^1, ..., A b^s, A^2 b^1,
...; a vector that depends on the ones before it ends its chain. With the lengths k_1, ..., k_s so
found, the coordinates are those of Luenberger's canonical form: each subsystem has the form (2.4),

    y_i1' = y_i2,   ...,   y_ik' = (all coordinates) + u_i   (k = k_i),

so that A is zero outside the diagonal blocks but for the last row of each block; the subsystems
meet only in the equations that contain the controls, and each u_i can cancel that. Where k_j < k_i,
j > i, the last equation of subsystem i may also contain u_j.

Output, z_i = h_i x; new coordinates y = T x. By duality:

*Sequential.* The rows of T are h_1, h_1 A, ..., h_1 A^(k_1 - 1), then the chain of h_2 as long as
it is independent, ... T A T^-1 is block lower triangular: each diagonal block has ones above the
diagonal and coefficients in the last row, the blocks to its left are zero but for their last row,
and z_i = y_i1. The first subsystem is observed in z_1 alone, the second from z_2 with the first
known.

*Parallel (shuttle).* Chains in the order h_1, ..., h_m, h_1 A, ..., h_m A, ...; each subsystem has
the form (2.5) and is coupled to the others only through their outputs: A is zero outside the
diagonal blocks but for the first column of each block, and z_i = y_i1 (plus a combination of
earlier outputs where k_i is smaller than theirs).

If the pair is not controllable (observable), these are the decompositions of its controllable
(observable) part, as in (2.6) and (2.7): the remaining coordinates, `remaining` in number, come
last and make the matrix block triangular once more.

Example 7 as printed does not do this: its f^3 has wrong coefficients (f^3 = -g^1 + (1/2) g^2 -
(3/2) f^1 + (5/2) f^2), and its p^1, v^1 take off only the own chain, whereas the coupling must go
too: p^1 = g^2 - (7/2) g^1 - (1/2) f^1, v^1 = f^2 - (5/2) f^1 - (1/2) g^1.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import MatrixLike
from trajlib.structure import exact
from trajlib.structure.decomposition import holds_where, named_matrices


@dataclass(frozen=True)
class ComponentDecomposition:
    """A system split into subsystems, one for each component of the output or of the control.

    Attributes
    ----------
    transformation : sympy.Matrix, shape (n, n)
        T, y = T x.
    matrix : sympy.Matrix, shape (n, n)
        T A T^-1.
    sizes : tuple of int
        The number of coordinates of each subsystem, in the order of the components (0 for one that
        adds nothing).
    remaining : int
        The number of coordinates, the last ones, that are unobservable (or uncontrollable).
    form : str
        "sequential" or "parallel".
    outputs : sympy.Matrix or None
        H T^-1, for a decomposition by outputs.
    inputs : sympy.Matrix or None
        T B, for a decomposition by inputs.
    """

    transformation: sp.Matrix
    matrix: sp.Matrix
    sizes: tuple[int, ...]
    remaining: int
    form: str
    outputs: sp.Matrix | None = None
    inputs: sp.Matrix | None = None

    @property
    def basis(self) -> sp.Matrix:
        """Return the inverse of the transformation, x = `basis` y."""
        return exact.inverse(self.transformation)

    @property
    def where(self) -> sp.Basic:
        """Return the condition on the symbols under which this holds, as in a `Decomposition`."""
        return holds_where(self.transformation, self.basis, self.matrix, self.outputs, self.inputs)

    def _repr_latex_(self):
        return named_matrices(
            {
                "T": self.transformation,
                "TAT^{-1}": self.matrix,
                "HT^{-1}": self.outputs,
                "TB": self.inputs,
            },
            self.where,
        )


@accepts_state_space("A", "H", C="H")
def decompose_by_outputs(A: MatrixLike, H: MatrixLike, form: str) -> ComponentDecomposition:
    """Return the decomposition by the components of the output, sequential or parallel.

    The forms are described in the module `trajlib.structure.components`.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax; exact, with symbols generic. A StateSpace stands for A and H:
        `decompose_by_outputs(sys, form)`.
    H : matrix_like, shape (m, n)
        Matrix of the output z = Hx; exact.
    form : {"sequential", "parallel"}
        Parallel is also called shuttle.

    Returns
    -------
    ComponentDecomposition
        With `outputs`; unobservable coordinates come last.

    Raises
    ------
    ValueError
        For another `form`, if shapes do not fit, or for floats, whose chains would end by a decision
        on rounding.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    MATLAB has no word for it; it is Luenberger's form. Source: example 7, problems 2.14
    and 2.15 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> A = sp.Matrix([[0, 1, 0], [0, 0, 0], [1, 0, 2]])
    >>> found = decompose_by_outputs(A, sp.Matrix([[1, 0, 0], [0, 0, 1]]), "sequential")
    >>> found.sizes, found.matrix
    ((2, 1), Matrix([
    [0, 1, 0],
    [0, 0, 0],
    [1, 0, 2]]))
    """
    A, H = read_observed(A, H)
    T, sizes = _coordinates(A, H, form, "H")
    inverse = exact.inverse(T)
    return ComponentDecomposition(
        T,
        exact.product(T, A, inverse),
        sizes,
        A.rows - sum(sizes),
        form,
        outputs=exact.product(H, inverse),
    )


@accepts_state_space("A", "B")
def decompose_by_inputs(A: MatrixLike, B: MatrixLike, form: str) -> ComponentDecomposition:
    """Return the decomposition by the components of the control, sequential or parallel.

    The forms are described in the module `trajlib.structure.components`.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu; exact, with symbols generic. A StateSpace stands for A and B:
        `decompose_by_inputs(sys, form)`.
    B : matrix_like, shape (n, s)
        Matrix of the control; exact.
    form : {"sequential", "parallel"}
        Parallel is also called shuttle.

    Returns
    -------
    ComponentDecomposition
        With `inputs`; uncontrollable coordinates come last.

    Raises
    ------
    ValueError
        As `decompose_by_outputs`.

    Notes
    -----
    MATLAB has no word for it; it is Luenberger's form. Source: example 7, problems 2.33 and 2.34 of
    the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> A = sp.Matrix([[1, 1, 0, 0], [0, 1, 0, 0], [0, 0, 2, 1], [0, 0, 0, 2]])
    >>> B = sp.Matrix([[1, 0], [0, 1], [0, 1], [1, 0]])
    >>> decompose_by_inputs(A, B, "sequential").matrix
    Matrix([
    [0, 0,  4,  6],
    [1, 0, -8, -7],
    [0, 1,  5,  2],
    [0, 0,  0,  1]])
    >>> decompose_by_inputs(A, B, "parallel").matrix
    Matrix([
    [   0,   1,    0,   0],
    [  -3, 7/2,   -1, 1/2],
    [   0,   0,    0,   1],
    [-1/2, 1/2, -3/2, 5/2]])
    """
    A, H = read_controlled(A, B)
    rows, sizes = _coordinates(A, H, form, "B")
    if form == "parallel":
        rows = _reversed_blocks(rows, sizes)
    basis = rows.T
    T = exact.inverse(basis)
    return ComponentDecomposition(
        T,
        exact.product(T, A.T, basis),
        sizes,
        A.rows - sum(sizes),
        form,
        inputs=exact.product(T, H.T),
    )


def _coordinates(A, H, form, name):
    """Return the rows of T for a decomposition by outputs, and the sizes of the subsystems."""
    if form not in ("sequential", "parallel"):
        raise ValueError(f'form: expected "sequential" or "parallel", got {form!r}')
    if isinstance(A, np.ndarray):
        raise ValueError(
            f"{name}: expected exact matrices (SymPy), since every chain ends by an exact "
            "decision; write the numbers as integers or sp.Rational"
        )
    chains = _sequential_chains(A, H) if form == "sequential" else _shuttle_chains(A, H)
    sizes = tuple(len(chain) for chain in chains)
    rows = sp.Matrix.vstack(sp.zeros(0, A.rows), *(row for chain in chains for row in chain))
    rows = sp.Matrix.vstack(rows, exact.null_columns(rows).T)
    return (rows if form == "sequential" else _luenberger(A, rows, sizes)), sizes


def _sequential_chains(A, H):
    rows, chains = sp.zeros(0, A.rows), []
    for i in range(H.rows):
        chain, row = [], H[i, :]
        while exact.rank(longer := sp.Matrix.vstack(rows, row)) > rows.rows:
            rows = longer
            chain.append(row)
            row = (row * A).applyfunc(sp.expand)
        chains.append(chain)
    return chains


def _shuttle_chains(A, H):
    rows, chains = sp.zeros(0, A.rows), [[] for _ in range(H.rows)]
    current = {i: H[i, :] for i in range(H.rows)}
    while current:
        for i, row in list(current.items()):
            longer = sp.Matrix.vstack(rows, row)
            if exact.rank(longer) > rows.rows:
                rows = longer
                chains[i].append(row)
                current[i] = (row * A).applyfunc(sp.expand)
            else:
                del current[i]
    return chains


def _luenberger(A, rows, sizes):
    """Return coordinates in which each subsystem has the form (2.5), coupled by the outputs.

    With the chains as rows of S, the columns q_i of S^-1 that belong to the ends of the chains
    generate the basis of the space: the columns A^(k-1) q_i, ..., A q_i, q_i, subsystem by
    subsystem (and the unobservable directions last).
    """
    inverse = exact.inverse(rows)
    columns, end = [], 0
    for size in sizes:
        end += size
        if size:
            chain = [inverse[:, end - 1]]
            while len(chain) < size:
                chain.append(exact.tidy(A * chain[-1]))
            columns += chain[::-1]
    columns += [inverse[:, j] for j in range(end, A.rows)]
    return exact.inverse(sp.Matrix.hstack(*columns))


def _reversed_blocks(rows, sizes):
    """Return the rows with the order of each subsystem reversed, as in the controller form."""
    order, start = [], 0
    for size in sizes:
        order += range(start + size - 1, start - 1, -1)
        start += size
    return rows.extract([*order, *range(start, rows.rows)], list(range(rows.cols)))

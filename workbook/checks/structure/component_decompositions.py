"""Decompositions by the components of the output or of the control.

Example 7 and problems 2.14, 2.15, 2.33, 2.34: the coordinates come in parts, part i with the
output z_i or the control u_i, then the rest. Each output contains its own part alone, each control
enters its own part alone; a component that has no part (the others observe or reach all that it
does) is free of this.

- Sequential: part 1 is all that the first component observes or reaches, part 2 what the second
  adds to it, and so on. By outputs the derivatives of part i contain the parts 1..i only, by
  controls the parts i, i+1, ... only.
- Parallel (the source calls it a shuttle): rows h1, h2, h1 A, h2 A, ... (columns b1, b2, A b1, A
  b2, ...) are taken by turns as long as they are independent. Part i is spanned by the rows h_i A^k
  (columns A^k b_i) taken from its own chain, each up to rows taken with lower powers of A: so the
  canonical form of each part, as in example 7, is accepted as well as the chains. The parts may act
  on one another, yet each is observable by its own output (controllable by its own control).

No check here is declared by a reference: any coordinates with the zeros asked are right.
"""

import numpy as np

from workbook.checks.contract.claims import Matrix
from workbook.checks.contract.tolerance import relative_tolerance
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.references.invariant_subspaces import echelon, product, unobservable_subspace
from workbook.checks.structure.decompositions import (
    by_equations,
    by_observation,
    judge_system,
    require_invertible,
)
from workbook.checks.tools.values import matrix_at


@judged(Matrix(shape="system.A"))
def sequential_decomposition(claim, system):
    """Check new coordinates in parts that the components determine one after the other.

    Part 1 is all that the first component observes or reaches, part 2 what the second adds, and
    so on, the rest last.

    Of a system with an output it is the matrix T of the coordinates T x: the derivatives of
    part i contain the parts 1..i alone; z_i shows part i alone, unless it adds nothing to those
    before. With a control it is P of x = P xi: the derivatives of part i contain the parts from
    i on; u_i enters part i alone, unless it adds nothing.

    Can decide when the entries are exact numbers.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> pair = Linear(A=[[1, 0], [0, 2]], H=[[0, 1], [1, 0]])
    >>> checks.sequential_decomposition([[0, 1], [1, 0]], pair).status
    'right'
    >>> checks.sequential_decomposition([[1, 0], [0, 1]], pair).status
    'wrong'
    """
    return _judge_components(claim, system, sequential=True)


@judged(Matrix(shape="system.A"))
def parallel_decomposition(claim, system):
    """Check new coordinates in parts, one for each component, the rest last.

    With an output the answer is the matrix T of T x, z_i contains part i alone and makes it
    observable; with a control it is P of x = P xi, u_i enters part i alone and makes it
    controllable.

    Part i is spanned by the rows of its chain that are taken when h1, h2, h1 A, h2 A, ...
    (columns b1, b2, A b1, ...) are taken by turns while independent, each up to those with
    lower powers of A.

    Can decide when the entries are exact numbers.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> pair = Linear(A=sp.zeros(2), H=[[0, 1], [1, 0]])
    >>> checks.parallel_decomposition([[0, 1], [1, 0]], pair).status
    'right'
    >>> checks.parallel_decomposition([[1, 0], [0, 1]], pair).status
    'wrong'
    """
    return _judge_components(claim, system, sequential=False)


@judged
def parallel_system(answer, system):
    """Check the system [A', H'] or [A', B'] in coordinates of a parallel decomposition.

    A change of variables turns the given system into it, and its own coordinates stand in the parts
    of a parallel decomposition.

    Can decide when the entries are exact numbers. Any such coordinates are accepted.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> pair = Linear(A=sp.zeros(2), H=[[0, 1], [1, 0]])
    >>> checks.parallel_system([sp.zeros(2), sp.eye(2)], pair).status
    'right'
    >>> checks.parallel_system([sp.zeros(2), [[0, 1], [1, 0]]], pair).status
    'wrong'
    """
    matrix, coupling, pair, side = by_equations(answer, system)
    judge_system(matrix, coupling, pair, side)
    A, H = matrix_at(matrix, {}), matrix_at(coupling, {})
    ((_, point),) = pair.samples
    part = _parts(_sizes_by_turns(*pair.at(point)), pair.order)
    _judge_parts(np.eye(len(A)), A, H, part, relative_tolerance(matrix, coupling), side, False)
    return "a change of variables turns the given system into yours, and its parts are as asked"


def _judge_components(claim, system, sequential):
    """Judge the zeros outside the blocks of a decomposition by components, by observation."""
    claim, pair, side = by_observation(claim, system)
    tolerance, n, m = relative_tolerance(claim), pair.order, pair.outputs
    ((_, A, H, _),), ((_, point),) = pair.systems, pair.samples
    sizes = (_sizes_in_turn if sequential else _sizes_by_turns)(*pair.at(point))
    part = _parts(sizes, n)
    claimed = matrix_at(claim, {})
    require_invertible(claimed, tolerance, {})
    try:
        _judge_parts(claimed, A, H, part, tolerance, side, sequential)
    except Wrong:
        # The rows in the order in which they are taken.
        turns = sorted(
            range(n), key=lambda k: (part[k] == m, k - np.flatnonzero(part == part[k])[0], part[k])
        )
        if not sequential and _is_parallel(claimed[np.argsort(turns)], A, H, part, tolerance, side):
            raise Wrong(
                f"your {'columns' if side.by_control else 'rows'} stand in the order in which they "
                "are taken by turns; asked is part by part, first all that belong to the first "
                "component"
            ) from None
        raise
    return "the matrix is invertible, and every zero that the decomposition requires is one"


def _parts(sizes, n):
    """Return the number of the part of every coordinate; the rest is the last one."""
    return np.repeat(np.arange(len(sizes) + 1), [*sizes, n - sum(sizes)])


def _is_parallel(claimed, *arguments):
    try:
        _judge_parts(claimed, *arguments, sequential=False)
    except Wrong:
        return False
    return True


def _judge_parts(claimed, A, H, part, tolerance, side, sequential):
    """Judge the zeros of a decomposition; `part` is the number of the part of every coordinate.

    The coordinates that belong to no component have the last number.
    """
    n, m = len(A), len(H)
    sizes = [int((part == k).sum()) for k in range(m)]
    inverse = np.linalg.inv(claimed)
    new_A, new_H = claimed @ A @ inverse, H @ inverse
    names = [f"coordinate {k + 1}" for k in range(n)]
    message = "look again at which coordinates make up each part, and how many they are"
    # The largest value that a zero can have when T is rounded to three digits.
    size = tolerance * np.linalg.norm(inverse, axis=0)
    bound = np.linalg.norm(A) * np.outer(np.linalg.norm(claimed, axis=1), size)
    for i, j in np.ndindex(n, n):
        free = part[j] <= part[i] if sequential else part[j] < m or part[i] == m
        if not free and not abs(new_A[i, j]) <= bound[i, j]:
            raise Wrong(
                f"{side.mixed(names[i], names[j], new_A[i, j])}, and it should not: {message}"
            )
    bound = np.outer(np.linalg.norm(H, axis=1), size)
    for k, j in np.ndindex(m, n):
        free = part[j] == k if sizes[k] else part[j] < k if sequential else part[j] < m
        if not free and not abs(new_H[k, j]) <= bound[k, j]:
            raise Wrong(f"{side.shown(k, m, names[j], new_H[k, j])}, and it should not: {message}")
    if not sequential:
        _judge_chains([claimed[part == k] for k in range(m)], A, H, tolerance, side)


def _judge_chains(parts, A, H, tolerance, side):
    """Judge that each part is spanned by its rows h A^k, each up to rows with lower powers of A."""
    lower, ends = np.zeros((0, len(A))), H
    for power in range(max(map(len, parts), default=0)):
        upper = _orthonormal(np.vstack([lower, ends]))
        for k, part in enumerate(parts):
            if power >= len(part):
                continue
            rows = _orthonormal(part)
            u, sizes, _ = np.linalg.svd(rows - rows @ upper.T @ upper)
            inside = u[:, np.pad(sizes, (0, len(rows) - len(sizes))) <= 10 * tolerance].T @ rows
            chain = _orthonormal(np.vstack([lower, ends[k : k + 1]]))
            if (
                len(inside) != power + 1
                or np.linalg.norm(inside - inside @ chain.T @ chain) > 10 * tolerance
            ):
                b, h = f"b{k + 1}", f"h{k + 1}"
                name = f"{b}, A {b}, ..." if side.by_control else f"{h}, {h} A, ..."
                raise Wrong(
                    f"part {k + 1} is not spanned by its own chain {name}, each up to what is "
                    f"taken with lower powers of A: it fails at the power {power}"
                )
        lower, ends = upper, ends @ A


def _orthonormal(rows):
    """Return an orthonormal basis, in rows, of the span of some rows, whatever their lengths."""
    lengths = np.linalg.norm(rows, axis=1)
    _, sizes, v = np.linalg.svd(rows[lengths > 0] / lengths[lengths > 0, None], full_matrices=False)
    return v[sizes > 1e-9 * sizes.max(initial=0)]


def _sizes_in_turn(A, H):
    """Return how much each output adds to the rank of the outputs before it."""
    ranks = [len(A) - len(unobservable_subspace(A, H[:k])) for k in range(1, len(H) + 1)]
    return [after - before for before, after in zip([0, *ranks], ranks)]


def _sizes_by_turns(A, H):
    """Return how many rows each chain h, h A, h A^2, ... gives, taken by turns while independent."""
    transposed, taken, sizes = list(zip(*A)), [], [0] * len(H)
    ends = [list(row) for row in H]
    for _ in range(len(A)):
        for k, row in enumerate(ends):
            if row is not None and len(echelon([*taken, row])[0]) > len(taken):
                taken.append(row)
                sizes[k] += 1
                ends[k] = product(transposed, row)
            else:
                ends[k] = None
    return sizes

"""Equilibria of an autonomous system, their spectra and stability."""

import functools

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.members import in_order
from workbook.checks.contract.tolerance import REPEATED, agree
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.fields import Field
from workbook.checks.tools.values import numbers_at
from workbook.checks.tools.wording import number_text, point_text


@judged
def equilibria(answer, field, state):
    """Check all equilibria of x' = f(x): each point is one, and a search finds no other."""
    flow, reference_points = _field_and_equilibria(tuple(field), tuple(state))
    claimed = [_equilibrium_at(flow, position) for position in _read_points(answer, state)]
    missed = [point for point in reference_points if not _is_member(point, claimed)]
    if missed:
        raise Wrong(
            "an equilibrium is missing: the right-hand sides vanish also at a point that is not in "
            "your list"
        )
    return "the right-hand sides vanish at all of them, and a search from 240 initial points finds no other"


@judged
def spectra(answer, field, state):
    """Check the eigenvalues of the linearisation at every equilibrium.

    The rows are the coordinates of an equilibrium, then the eigenvalues.

    Judged by the characteristic determinant det(lambda I - A) at the numbers given, and by
    their sum, the trace of A.
    """
    flow, reference_points = _field_and_equilibria(tuple(field), tuple(state))
    claimed = []
    for position, numbers in _spectra_by_point(answer, state):
        point = _equilibrium_at(flow, position)
        claimed.append(point)
        _judge_spectrum(numbers, flow.jacobian(point), point)
    missed = [point for point in reference_points if not _is_member(point, claimed)]
    if missed:
        raise Wrong(
            "your list does not hold all of them: a search finds an equilibrium for which you "
            "give no eigenvalues"
        )
    return "at every equilibrium the numbers are the roots of the characteristic equation, each as often as it is one"


@judged
def stable_equilibria(answer, field, state):
    """Check the asymptotically stable equilibria among all, by linearisation."""
    flow, reference_points = _field_and_equilibria(tuple(field), tuple(state))
    claimed = _read_points(answer, state)
    stable = []
    for point in reference_points:
        real_part = max(np.linalg.eigvals(flow.jacobian(point)).real)
        if abs(real_part) < 1e-8:
            raise RuntimeError("the linearisation does not decide here")
        if real_part < 0:
            stable.append(point)
        elif any(_is_at(position, point) for position in claimed):
            raise Wrong(
                f"the point {point_text(point)} is listed as stable, but the linearisation "
                "there has an eigenvalue with a positive real part"
            )
    for position in claimed:
        if not any(_is_at(position, point) for point in stable):
            raise Wrong(
                f"your point {point_text(position)} is not an equilibrium: {_values_text(flow, position)}"
            )
    missed = [point for point in stable if not any(_is_at(position, point) for position in claimed)]
    if missed:
        raise Wrong(
            "not all asymptotically stable equilibria are there: some equilibrium that you leave "
            "out has a linearisation whose eigenvalues all have negative real parts"
        )
    return "at these equilibria, and at no others, all eigenvalues of the linearisation have negative real parts"


@functools.lru_cache(maxsize=16)
def _field_and_equilibria(field, state):
    """Return the field and its equilibria; cached, as several answers concern the same system."""
    flow = Field(field, state)
    return flow, flow.equilibria()


def _read_points(answer, state):
    """Return the points of an answer, a list or a dict from `solve`, as lists in state order."""
    points = [answer] if isinstance(answer, dict) else answer
    if isinstance(points, (list, tuple, set, frozenset, sp.FiniteSet)):
        points = [in_order(point, state) for point in points]
        if len(state) == 1:  # plain numbers for points with a single coordinate
            points = [
                point if isinstance(point, (list, tuple, sp.Tuple)) else [point] for point in points
            ]
    return [list(point) for point in coercion.as_points(points, len(state))]


def _spectra_by_point(answer, state):
    """Yield pairs (point, eigenvalues) as they are written, from rows [*coordinates, *eigenvalues].

    A row may also be a pair of two lists.
    """
    n = len(state)
    if isinstance(answer, sp.MatrixBase):
        answer = answer.tolist()
    if not isinstance(answer, (list, tuple, np.ndarray)):
        raise Invalid(
            f"expected a list with a row of {2 * n} numbers for each equilibrium: its coordinates, "
            "then the eigenvalues"
        )
    rows = (
        [answer]
        if len(answer) == 2 * n
        and not any(isinstance(x, (list, tuple, np.ndarray, sp.MatrixBase)) for x in answer)
        else answer
    )
    for row in rows:
        if isinstance(row, (list, tuple)) and len(row) == 2 and n > 1:
            row = [*coercion.as_expressions(row[0], (), n), *coercion.as_expressions(row[1], (), n)]
        numbers = coercion.as_expressions(row, (), 2 * n)
        yield list(map(coercion.as_number, numbers[:n])), numbers[n:]


def _judge_spectrum(written, matrix, point):
    """Match the numbers one to one with the eigenvalues."""
    numbers = numbers_at(
        written, {}, [f"eigenvalue at {point_text(point)}"] * len(written)
    ).tolist()
    eigenvalues = list(np.linalg.eigvals(matrix))
    remaining = list(eigenvalues)
    for number, claim in zip(numbers, written):
        # A computed double eigenvalue has half of the digits of a float.
        matching = [value for value in eigenvalues if agree(number, value, claim, 1, REPEATED)]
        if not matching:
            residual = abs(np.linalg.det(number * np.eye(len(matrix)) - matrix))
            raise Wrong(
                f"at {point_text(point)} your number {number_text(number)} is no eigenvalue of the "
                f"linearisation: det(lambda I - A) has the modulus {residual:.4g} there, not zero"
            )
        unmatched = [value for value in matching if value in remaining]
        if not unmatched:
            raise Wrong(
                f"at {point_text(point)} the sum of your eigenvalues is "
                f"{number_text(sum(numbers))}, which is not the sum of the diagonal elements of A"
            )
        remaining.remove(min(unmatched, key=lambda value: abs(value - number)))


def _equilibrium_at(flow, position):
    """Return the equilibrium at a point as it is written, or raise `Wrong`."""
    equilibrium = flow.refine(np.array(position, dtype=float))
    if equilibrium is None or not _is_at(position, equilibrium):
        raise Wrong(
            f"your point {point_text(position)} is not an equilibrium: {_values_text(flow, position)}"
        )
    return equilibrium


def _values_text(flow, position):
    values = flow(np.array(position, dtype=float))
    if not np.all(np.isfinite(values)):
        return "the right-hand sides are not defined there"
    return f"the right-hand sides are {point_text(values)} there, not zero"


def _is_at(position, point):
    """Return whether a written point agrees with a computed one; a double zero has half the digits."""
    return agree(
        np.array(position, dtype=float), point, position, np.abs(point).max(), REPEATED
    ).all()


def _is_member(point, points):
    return any(
        np.linalg.norm(point - member) < 1e-6 * (1 + np.linalg.norm(point)) for member in points
    )

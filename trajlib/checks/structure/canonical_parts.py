"""Coordinates in which the observable part of x' = A x, z = h x has the canonical form by observation (2.5).

The system as a whole need not be observable. The coordinates are judged by the equations that the form stands for, z =
xi1 and xi_k' = (a multiple of z) + xi_(k+1), the last one without its second term. No eigenvalues and no polynomial are
needed: with as many rows as the observable part has, the multiples are determined.
"""

import numpy as np

from trajlib.checks.contract import coercion
from trajlib.checks.contract.tolerance import same, share
from trajlib.checks.contract.verdict import Invalid, Wrong, judged
from trajlib.checks.tools.values import matrix_at
from trajlib.checks.tools.wording import number_text, where_text
from trajlib.checks.truths.invariant_subspaces import to_floats
from trajlib.checks.truths.pairs import pair_of


@judged
def canonical_part_coordinates(answer, A, H, parameters=()):
    """The matrix F of coordinates xi = F x in which the observable part of the system has the form (2.5), one
    output."""
    claim = coercion.as_matrix(answer, parameters)
    if claim.cols != A.rows:
        raise Invalid(f"expected a matrix with {A.rows} columns, one for each coordinate of x; the shape of yours is "
                      f"{claim.shape}")
    pair, tolerance = pair_of(A, H, parameters), share(claim)
    if pair.outputs != 1:
        raise ValueError("the canonical form belongs to one output")
    for (values, place), unseen in zip(pair.samples, pair.unseen):
        where, order = where_text(values), pair.order - len(unseen)
        _same_order(claim.rows, order, where)
        A_there, (h,) = (to_floats(rows, pair.order) for rows in pair.at(place))
        said = matrix_at(claim, values)
        if not same(said[0], h, list(claim[0, :]), np.linalg.norm(h)).all():
            j = int(np.argmax(abs(said[0] - h)))
            raise Wrong(f"z has to be xi1 alone{where}; your xi1 holds {number_text(said[0, j])} x{j + 1}")
        for k in range(order):
            rate = said[k] @ A_there
            following = said[k + 1] if k + 1 < order else 0 * h
            rest = rate - following - h * ((rate - following) @ h) / (h @ h)
            if not np.linalg.norm(rest) <= tolerance * (np.linalg.norm(rate) + np.linalg.norm(following)):
                j = int(np.argmax(abs(rest)))
                what = f"xi{k + 1}' - xi{k + 2}" if k + 1 < order else f"xi{k + 1}'"
                raise Wrong(f"{what} has to be a multiple of z{where}; by your rows it differs from the nearest "
                            f"multiple by terms such as {number_text(rest[j])} x{j + 1}")
    return "z = xi1, and the derivatives are as the form (2.5) says"


def _same_order(said, true, where):
    if said > true:
        raise Wrong(f"the output and its derivatives do not hold {said} independent combinations of the "
                    f"coordinates{where}, so not all of yours are observable")
    if said < true:
        raise Wrong(f"the output and its derivatives hold more than {said} independent "
                    f"combination{'s' if said != 1 else ''} of the coordinates{where}; yours are too few for them")

"""Starting guesses that pass the obstacles of path constraints on their other side.

Where the states with g <= 0 are not a convex set, a trajectory may pass the states with g > 0, an
obstacle, on more sides than one, and the search ends on the side of its guess. From the point of a
trajectory where g is greatest a straight line along grad g leads into the obstacle; if it comes out
again, it does so on the other side. From a convex set no such line comes back.
"""

from collections.abc import Iterator

import numpy as np

from trajlib.pontryagin.direct.transcription import DirectSolution
from trajlib.pontryagin.problem.numeric import NumericProblem

# Length of the straight lines, relative to the extent of the trajectory; points on each of them.
LENGTH, POINTS = 4.0, 400
# Distance behind the obstacle, as a share of the way through it.
BEHIND = 0.1
# Nodes at which g is within this share of its range from the greatest value are in contact.
CONTACT = 1e-2


def guesses_on_other_sides(numeric: NumericProblem, solution: DirectSolution) -> Iterator[tuple]:
    """Yield guesses (duration, states, controls) that pass an obstacle where a solution does not.

    Parameters
    ----------
    numeric : NumericProblem
        With path constraints.
    solution : DirectSolution
        Its trajectory is moved to the other side of one obstacle after another, most where it is
        nearest to the obstacle, not at all at its ends.

    Yields
    ------
    tuple
        (duration, states (N+1, n), controls (N, k)).
    """
    states, count = solution.states, len(numeric.path_orders)
    nodes = np.linspace(0, 1, len(states))
    values = numeric.path_value.map(len(states))(states.T)[0].full().T
    movable = np.array([rate.free_symbols != set() for rate in numeric.problem.field])
    for j in range(count):
        g = values[1:-1, j]
        contact = np.nonzero(g >= np.max(g) - CONTACT * np.ptp(values[:, j]))[0] + 1
        nearest = contact[len(contact) // 2]
        slope = numeric.path_value(states[nearest])[1].full()[j] * movable
        if not np.any(slope):
            continue
        direction = slope / np.linalg.norm(slope)
        extent = np.max(np.ptp(states[:, slope != 0], axis=0)) + np.max(np.abs(states[nearest]))
        way = np.linspace(0, LENGTH * extent, POINTS)
        line = states[nearest] + way[:, None] * direction
        inside = numeric.path_value.map(POINTS)(line.T)[0].full()[j] > 0
        entry = np.argmax(inside)
        if not inside.any() or inside[entry:].all():
            continue
        exit_ = entry + np.argmin(inside[entry:])
        share = np.minimum(nodes / nodes[nearest], (1 - nodes) / (1 - nodes[nearest]))
        offset = (1 + BEHIND) * way[exit_] * direction
        yield solution.duration, states + share[:, None] * offset, solution.controls

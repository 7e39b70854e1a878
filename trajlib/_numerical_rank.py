"""The one rule by which singular values and pivots of floats count as zero.

A matrix that is exact but for the rounding of its entries has singular values that are wrong by a
few roundings of the largest one for each row. A value below that is not told from zero: this is no
proof that the rank is lower. `trajlib.solvability` proves a rank; its level for six unknowns is
nearly the same.
"""

import numpy as np

#: Roundings for each row (or column, whichever are more). Some 30 are proved for reflections with
#: three unknowns, some 90 with six (`trajlib.solvability.rounding`).
ROUNDINGS = 100


def zero_level(*shape):
    """Return the share of the largest singular value below which one counts as zero."""
    return ROUNDINGS * max(shape) * float(np.finfo(float).eps)

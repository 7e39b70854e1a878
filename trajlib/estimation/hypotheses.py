"""The hypotheses under which there is a stationary filter, decided without solving for it.

A stabilising solution of the Riccati equation exists if and only if (A, H) is detectable and the
noise Q drives every mode on the border of stability, the imaginary axis or the unit circle. Both
are decided by the rank tests of `structure`: exactly, or in floats in balanced units, where what is
zero within rounding counts as zero.
"""

import numpy as np

from trajlib.structure.fixed_spectrum import rounding, slowest_rate
from trajlib.structure.rank_tests import controllability, observability

DETECTABLE = "not detectable, a mode that does not decay is not measured"
DRIVEN = (
    "a mode on the border of stability is free of noise, so that its gain tends to zero and its "
    "errors do not decay with it"
)
GENERAL = (
    "for general values of the symbols the pair is not detectable, or a mode on the border of "
    "stability is free of noise"
)


def failed_hypothesis(A, H, Q, discrete):
    """Return the hypothesis that does not hold, in words; None if both do.

    With symbols the failure is known already, and only its words are returned.
    """
    if not isinstance(A, np.ndarray) and A.free_symbols | H.free_symbols | Q.free_symbols:
        return GENERAL
    if any(rate >= 0 for rate in _rates(observability(A, H), A, H, discrete)):
        return DETECTABLE
    if any(rate == 0 for rate in _rates(controllability(A, Q), A.T, Q, discrete)):
        return DRIVEN
    return None


def _rates(test, A, H, discrete):
    limit = rounding(A, H)
    return [slowest_rate(mode.eigenvalue, discrete, limit) for mode in test.hidden_modes]

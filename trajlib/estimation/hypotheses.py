"""The hypotheses under which there is a stationary filter, decided without solving for it.

A stabilising solution of the Riccati equation exists if and only if (A, H) is detectable and the
noise Q drives every mode on the border of stability, the imaginary axis or the unit circle. Both
are decided by the rank tests of `structure`: exactly, or in floats in balanced units, where what is
zero within rounding counts as zero.
"""

import numpy as np

from trajlib._real_symbols import sign_of_number
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
    if any(sign >= 0 for sign in _signs(observability(A, H), A, H, discrete)):
        return DETECTABLE
    if 0 in _signs(controllability(A, Q), A.T, Q, discrete):
        return DRIVEN
    return None


def _signs(test, A, H, discrete):
    """Return for each hidden mode whether it decays, -1, is on the border, 0, or grows, 1."""
    limit = rounding(A, H)
    rates = [slowest_rate(mode.eigenvalue, discrete, limit) for mode in test.hidden_modes]
    return [sign_of_number(rate) for rate in rates]

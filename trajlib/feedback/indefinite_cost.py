"""Regulators for costs whose weights are indefinite, and the verdict where there is none.

The cost x^T G x + u^T N u, N > 0, may reward states. Among the controls that bring x to zero there is a law
of least cost if (A, B) is stabilisable and

    Pi(w) = N + B^T (-iw E - A^T)^-1 G (iw E - A)^-1 B > 0    for all frequencies w

(V. M. Popov; J. C. Willems, 1971): then, and only then, the Hamiltonian matrix has no eigenvalue on the
imaginary axis, and S is the stabilising solution of the Riccati equation, indefinite in general. If
v* Pi(w) v < 0 for some v, the control Re(v e^{iwt}) has a negative mean cost, and with enough periods,
steered to zero at last, the cost has no lower bound from any initial state.
"""

import numpy as np
import sympy as sp

from trajlib.estimation.exact_or_float import solve
from trajlib.estimation.riccati import Stabilising, continuous_hamiltonian
from trajlib.estimation.riccati_floats import solve_riccati
from trajlib.structure.fixed_spectrum import stabilisability

#: By so much of the size of its terms Pi(w) has to be negative in floats.
NEGATIVE = 1e-9


def solve_indefinite(A, B, G, N):
    """Return S, K, A + BK, `where`, the reason, residual and error; S is None if there is no law."""
    if isinstance(A, np.ndarray):
        solution = solve_riccati(A.T, B.T, G, N, False)
        if solution is not None:
            parts = solution.P, -solution.gain.T, solution.loop.T, sp.true
            return *parts, _FOUND, solution.residual, solution.error
    else:
        try:
            exact = Stabilising(continuous_hamiltonian(A.T, B.T, G, N))
        except NotImplementedError:
            # That there is no law may be proved all the same.
            if any(M.free_symbols for M in (A, B, G, N)) or not _frequency_of_gain(A, B, G, N):
                raise
            exact = None
        if exact is not None and exact.P is not None:
            gain = -solve(N, B.T * exact.P)
            parts = (exact.in_given_symbols(part) for part in (exact.P, gain, A + B * gain))
            return *parts, exact.where, _FOUND, None, None
    return None, None, None, sp.false, f"no stabilising law of least cost: {_verdict(A, B, G, N)}"


_FOUND = "the stabilising law of least cost; the weights are indefinite"


def _verdict(A, B, G, N):
    """Return why there is no law, or raise LinAlgError if that is not known."""
    if not isinstance(A, np.ndarray) and any(M.free_symbols for M in (A, B, G, N)):
        return "for general values of the symbols Pi(w) is not positive, or (A, B) not stabilisable"
    stabilisable = stabilisability(A, B)
    if not stabilisable:
        return f"not stabilisable; {stabilisable.reason}"
    frequency = _frequency_of_gain(A, B, G, N)
    if frequency is not None:
        return (
            "the cost has no lower bound, since the weights are indefinite and a control of the "
            f"frequency {frequency} makes its mean over time negative"
        )
    if isinstance(A, np.ndarray):
        raise np.linalg.LinAlgError(
            "not found: the weights are indefinite and close to those for which the cost has no lower "
            "bound; give exact entries (SymPy), or make N greater"
        )
    return (
        "the weights are indefinite, and at some frequency a control costs nothing: the least cost is "
        "approached, by no law"
    )


def _frequency_of_gain(A, B, G, N):
    """Return a frequency at which some control lowers the cost, None if none was found.

    Between two eigenvalues of the Hamiltonian matrix on the axis Pi does not change its signs.
    """
    a, b, g, n = (np.array(M.tolist(), dtype=float) for M in (A, B, G, N))
    hamiltonian = np.block([[a, -b @ np.linalg.solve(n, b.T)], [-g, -a.T]])
    ends = np.unique(np.abs(np.linalg.eigvals(hamiltonian).imag).round(12))
    candidates = np.unique([0.0, *ends, *(ends[1:] + ends[:-1]) / 2, *(ends[:1] / 2)])
    for frequency in candidates:
        value = _popov(a, b, g, n, frequency)
        if value is None:
            continue
        least, vector, size = value
        if least < -NEGATIVE * size and (
            isinstance(A, np.ndarray) or _proved(A, B, G, N, frequency, vector)
        ):
            return f"{frequency:.6g}"
    return None


def _popov(a, b, g, n, frequency):
    """Return the least eigenvalue of Pi, its vector, and the size of the terms of Pi."""
    try:
        response = np.linalg.solve(1j * frequency * np.eye(len(a)) - a, b)
    except np.linalg.LinAlgError:
        return None
    gained = response.conj().T @ g @ response
    values, vectors = np.linalg.eigh(n + gained)
    return values[0], vectors[:, 0], np.linalg.norm(n) + np.linalg.norm(gained)


def _proved(A, B, G, N, frequency, vector):
    """Whether v* Pi v < 0 in exact arithmetic, for rational numbers near the frequency and v."""
    w = sp.Rational(f"{frequency:.6g}")
    v = sp.Matrix(
        [sp.Rational(f"{e.real:.6f}") + sp.I * sp.Rational(f"{e.imag:.6f}") for e in vector]
    )
    try:
        response = (sp.I * w * sp.eye(A.rows) - A).LUsolve(B * v)
    except (ValueError, ZeroDivisionError):
        return False
    value = sp.expand((v.H * N * v + response.H * G * response)[0])
    return bool(sp.re(sp.N(sp.radsimp(value), 30)) < 0)

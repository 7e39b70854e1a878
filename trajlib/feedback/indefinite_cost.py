"""Regulators for costs whose weights are indefinite, and the verdict where there is none.

The cost x^T G x + u^T N u, N > 0, may reward states. Among the controls that bring x to zero there is a law
of least cost if (A, B) is stabilisable and

    Pi(z) = N + B^T (z* E - A^T)^-1 G (z E - A)^-1 B > 0    for z = iw, or for |z| = 1 in discrete time

(V. M. Popov; J. C. Willems, 1971): then, and only then, the Hamiltonian matrix has no eigenvalue on the
imaginary axis, and S is the stabilising solution of the Riccati equation, indefinite in general. In
discrete time it is the symplectic pencil and the unit circle, and Pi has the signs of N + B^T S B. If
v* Pi v < 0 for some v, the control Re(v e^{iwt}) has a negative mean cost, and with enough periods,
steered to zero at last, the cost has no lower bound from any initial state.

Up to a final time there is a law of least cost if the solution of the Riccati differential equation
does not escape before (`riccati_or_escape`).
"""

import functools

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import definiteness
from trajlib._real_symbols import sign_of_number
from trajlib.estimation.continuous_filter import (
    propagate_riccati,
    riccati_closed_form,
    riccati_flow,
)
from trajlib.estimation.exact_or_float import identity_like, solve
from trajlib.estimation.hypotheses import failed_hypothesis
from trajlib.estimation.riccati import Stabilising, continuous_hamiltonian, discrete_hamiltonian
from trajlib.estimation.riccati_floats import stabilising_solution
from trajlib.stability.inequalities import positive

#: By so much of the size of its terms, and more where it is ill-conditioned, Pi has to be negative in floats.
NEGATIVE = 1e-9
#: How close to the final time, as a share of it, floats do not tell whether S escapes before it.
CLOSE = 1e-9
#: How far beside its terms E + W^1/2 F W^1/2 has to be from singular, for S to have digits left.
REGULAR = 1e-10
#: How often a short step is halved to find an escape, and how many steps may cover the time to go.
FINEST, MOST = 40, 100_000


def solve_indefinite(A, B, G, N, discrete):
    """Return S, K, A + BK, `where`, the reason, residual and error; S is None if there is no law."""
    verdict = functools.partial(_verdict, A, B, G, N, discrete)
    if isinstance(A, np.ndarray):
        found = stabilising_solution(A.T, B.T, G, N, discrete, False, verdict)
        if not isinstance(found, str):
            gain = -found.gain.T @ A if discrete else -found.gain.T
            return found.P, gain, found.loop.T, sp.true, _FOUND, found.residual, found.error
    else:
        exact = _exact(A, B, G, N, discrete)
        if exact is not None:
            return *exact, _FOUND, None, None
        found = verdict()
    return None, None, None, sp.false, f"no stabilising law of least cost: {found}"


_FOUND = "the stabilising law of least cost; the weights are indefinite"


def _exact(A, B, G, N, discrete):
    """Return S, K, A + BK and the condition for them, or None if there is no law."""
    hamiltonian = discrete_hamiltonian if discrete else continuous_hamiltonian
    try:
        solution = Stabilising(hamiltonian(A.T, B.T, G, N))
    except NotImplementedError:
        # That there is no law may be proved all the same.
        if any(M.free_symbols for M in (A, B, G, N)) or not _frequency_of_gain(
            A, B, G, N, discrete
        ):
            raise
        return None
    S, where = solution.P, solution.where
    if S is None:
        return None
    if discrete:
        # Cramer's rule: the entries have auxiliary symbols for roots, which no field of SymPy has.
        spread = N + B.T * S * B
        gain = -spread.adjugate() * B.T * S * A / spread.det()
        where = sp.And(where, *map(_positive, _leading_minors(solution.in_given_symbols(spread))))
        if where == sp.false:
            return None
    else:
        gain = -solve(N, B.T * S)
    return *(solution.in_given_symbols(part) for part in (S, gain, A + B * gain)), where


def _leading_minors(matrix):
    return [matrix[:k, :k].det() for k in range(1, matrix.rows + 1)]


def _positive(value):
    if value.free_symbols:
        return sp.Gt(value, 0) if value.atoms(sp.Pow) else positive(value)
    return sp.sympify(sign_of_number(value) > 0)


def _verdict(A, B, G, N, discrete):
    """Return why there is no law, or raise LinAlgError if that is not known."""
    if not isinstance(A, np.ndarray) and any(M.free_symbols for M in (A, B, G, N)):
        return "for general values of the symbols Pi is not positive, or (A, B) not stabilisable"
    if failed_hypothesis(A.T, B.T, identity_like(A), discrete):
        return "not stabilisable, a mode that does not decay is not controlled"
    frequency = _frequency_of_gain(A, B, G, N, discrete)
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


def _frequency_of_gain(A, B, G, N, discrete):
    """Return a frequency at which some control lowers the cost, None if none was found.

    Between two eigenvalues on the axis or the circle Pi does not change its signs.
    """
    a, b, g, n = (np.array(M.tolist(), dtype=float) for M in (A, B, G, N))
    last = [np.pi] if discrete else []  # in continuous time Pi tends to N > 0
    ends = np.unique([0.0, *np.abs(_critical_frequencies(a, b, g, n, discrete)), *last])
    # At the eigenvalues themselves Pi is singular, so they are asked last.
    for frequency in (0.0, *last, *(ends[1:] + ends[:-1]) / 2, *ends):
        value = _popov(a, b, g, n, np.exp(1j * frequency) if discrete else 1j * frequency)
        if value is None:
            continue
        least, vector, doubt = value
        negative = (
            least < -doubt
            if isinstance(A, np.ndarray)
            else least < doubt and _proved(A, B, G, N, _exact_point(frequency, discrete), vector)
        )
        if negative:
            return f"{frequency:.6g}" + " radians a step" * discrete
    return None


def _critical_frequencies(a, b, g, n, discrete):
    """Return the frequencies of the eigenvalues of the Hamiltonian matrix, or of the pencil."""
    spread, identity, zero = b @ np.linalg.solve(n, b.T), np.eye(len(a)), np.zeros_like(a)
    if not discrete:
        return np.linalg.eigvals(np.block([[a, -spread], [-g, -a.T]])).imag
    from scipy.linalg import eigvals

    with np.errstate(all="ignore"):
        values = eigvals(
            np.block([[a, zero], [-g, identity]]), np.block([[identity, spread], [zero, a.T]])
        )
    return np.angle(values[np.isfinite(values)])


def _popov(a, b, g, n, z):
    """Return the least eigenvalue of Pi, its vector, and how far rounding may have moved it.

    Near an eigenvalue of A on the axis or the circle the response has no correct digit.
    """
    pencil = z * np.eye(len(a)) - a
    try:
        response = np.linalg.solve(pencil, b)
    except np.linalg.LinAlgError:
        return None
    gained = response.conj().T @ g @ response
    values, vectors = np.linalg.eigh(n + gained)
    share = NEGATIVE + 10 * np.finfo(float).eps * np.linalg.cond(pencil)
    terms = np.linalg.norm(n) + np.linalg.norm(g) * np.linalg.norm(response) ** 2
    return values[0], vectors[:, 0], share * terms


def _exact_point(frequency, discrete):
    """Return a rational point of the axis, or of the circle, near that of a frequency."""
    if not discrete:
        return sp.I * sp.Rational(float(frequency))
    if np.pi - frequency < 1e-6:
        return sp.Integer(-1)
    t = sp.Rational(float(np.tan(frequency / 2)))
    return (1 - t**2 + 2 * sp.I * t) / (1 + t**2)


def _proved(A, B, G, N, z, vector):
    """Whether v* Pi v < 0 in exact arithmetic, for rational numbers near v."""
    v = sp.Matrix(
        [sp.Rational(f"{e.real:.6f}") + sp.I * sp.Rational(f"{e.imag:.6f}") for e in vector]
    )
    try:
        response = (z * sp.eye(A.rows) - A).LUsolve(B * v)
    except (ValueError, ZeroDivisionError):
        return False
    value = sp.expand((v.H * N * v + response.H * G * response)[0])
    return sign_of_number(sp.re(sp.radsimp(value))) < 0


def why_no_law(spread, steps):
    """Return why there is no law with so many steps to go; "" where `spread`, N + B^T S B, is definite.

    Raises LinAlgError if floats do not tell, NotImplementedError for symbols.
    """
    if not isinstance(spread, np.ndarray) and spread.free_symbols:
        raise NotImplementedError("indefinite weights up to a last step are judged for numbers")
    sign = definiteness(spread)
    if sign == 0 and isinstance(spread, np.ndarray):
        raise np.linalg.LinAlgError(
            f"not found: with {steps} steps to go N + B^T S B is singular, as far as floats tell; give "
            "exact entries (SymPy)"
        )
    reasons = {
        -1: "the cost has no lower bound, since N + B^T S B is not positive",
        0: "N + B^T S B is singular, so that no single law attains the least cost",
        1: "",
    }
    return reasons[sign] and f"no law of least cost: with {steps} steps to go {reasons[sign]}"


def solve_indefinite_until(A, B, G, N, F, t):
    """Return S at a time before S = F and the reason; S is None if there is no law."""
    floats = isinstance(A, np.ndarray)
    if t.free_symbols or (not floats and any(M.free_symbols for M in (A, B, G, N, F))):
        raise NotImplementedError(
            "indefinite weights up to a final time are judged for numbers; substitute the symbols"
        )
    arrays = (np.array(M.tolist(), dtype=float) for M in (A, B, G, N, F))
    cost, escape = riccati_or_escape(*arrays, float(t)) if t else (F, None)
    if cost is None:
        return None, (
            "no law of least cost: the cost has no lower bound, S escapes to infinity at the time to go "
            f"{escape:.6g}"
        )
    if t and not floats:
        cost = riccati_closed_form(A.T, B * solve(N, B.T), G, F, t)
    return cost, "the law of least cost up to the end; the weights are indefinite"


def riccati_or_escape(A, B, G, N, F, time_to_go):
    """Return S of -S' = A^T S + S A + G - S B N^-1 B^T S at a time before S = F, and None, in floats.

    If S escapes to infinity before, return None and the time to go at which it does.

    Over a step without escape from zero S = Q + Phi^T F (E + W F)^-1 Phi, where W >= 0 grows with the
    step. So S does not escape on the step if and only if E + W^1/2 F W^1/2 > 0. From zero there is no
    escape on a step that is short beside the norm of the Hamiltonian matrix, and on the double of a
    step if there is none from Q on that step: the steps are doubled, and halved where S may escape.

    Raises LinAlgError if it escapes at the final time, as far as floats tell.
    """
    control = B @ np.linalg.solve(N, B.T)
    size = np.abs(np.block([[A.T, control], [G, A]])).sum(axis=1).max()
    halvings = FINEST + max(0, int(np.ceil(np.log2(max(2 * size * time_to_go, 1)))))
    unit, top = time_to_go / 2**halvings, FINEST
    flow = functools.cache(lambda level: riccati_flow(A.T, control, G, unit * 2**level))
    while top < halvings and _least_eigenvalue(flow(top)[2], flow(top)[1]) > REGULAR:
        top += 1
    S, gone, level, escaped = F, 0, top, 0
    for _ in range(MOST):
        if gone == 2**halvings:
            break
        least = _least_eigenvalue(S, flow(level)[1])
        if least > REGULAR:
            S, gone = propagate_riccati(S, *flow(level)), gone + 2**level
            level += level < top and gone % 2 ** (level + 1) == 0
            continue
        if least < -REGULAR:  # proved; how far up to the escape is refined
            escaped = gone + 2**level
        level -= 1
        if level < 0:
            if not gone < escaped or gone > (1 - CLOSE) * 2**halvings:
                raise np.linalg.LinAlgError(_UNDECIDED)
            return None, gone * unit
    else:
        raise np.linalg.LinAlgError(f"not found: {MOST} steps do not cover the time to go")
    if _least_eigenvalue(S, riccati_flow(A.T, control, G, CLOSE * time_to_go)[1]) <= REGULAR:
        raise np.linalg.LinAlgError(_UNDECIDED)
    return S, None


_UNDECIDED = (
    "not found: floats do not tell whether the solution of the Riccati equation escapes, or it escapes at "
    "the final time; make the time shorter or longer, or the weights more alike in size"
)


def _least_eigenvalue(S, W):
    """Return the least eigenvalue of E + W^1/2 S W^1/2 beside the greatest, or beside one."""
    values, vectors = np.linalg.eigh(W)
    root = vectors * np.sqrt(np.maximum(values, 0))
    values = np.linalg.eigvalsh(np.eye(len(S)) + root.T @ S @ root)
    return values[0] / max(values[-1], 1)

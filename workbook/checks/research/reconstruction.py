"""Reconstruction of a motion from samples: transition matrix, splines, continuous records.

The motion of least cost is found here by dense least squares in positions and velocities at the
samples, where the integral of u^2 between two states is a quadratic form; the sweep is not used.
Expressions are compared at random values of their symbols.
"""

import itertools
import math

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression, Expressions, Number
from workbook.checks.contract.tolerance import agree, half_unit, in_decimals
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.tools.comparisons import SameValue
from workbook.checks.tools.samples import in_every_case, log_spread, random_values
from workbook.checks.tools.values import entry_uncertainties, value_at
from workbook.checks.tools.wording import number_text, rounded_text

RECORDS = 6
#: Of the values of all symbols, the same in every check.
SEED = 64
PIECES = 16
#: By how much the logarithm of a weight M may differ from that of rho tau^3; beyond this range the
#: least squares are singular in floats, and the acceleration is far from any bound.
WEIGHT_RANGE = 30


@judged(Expression("lam", "kappa"))
def transition_polynomial(claim, transition, lam, kappa):
    """Check the characteristic polynomial P(lambda) of a transition matrix.

    It is det(lambda I - A), and the matrix A depends on kappa.

    Where `lam` is written with another symbol, w/2 + sqrt(w^2/4 - 1) or exp(i phi),
    P(lambda)/lambda^(n/2) in this symbol, which is real for a reciprocal polynomial: without
    the imaginary unit on the unit circle.

    Can decide when the entries are expressions of kappa, for random values of the symbols.

    Examples
    --------
    >>> lam, k = sp.symbols("lambda kappa", positive=True)
    >>> checks.research.transition_polynomial(lam**2 - 2*lam + 1 - k, sp.Matrix([[1, k], [1, 1]]), lam, k).status
    'right'
    >>> checks.research.transition_polynomial(lam**2 + 1 - k, sp.Matrix([[1, k], [1, 1]]), lam, k).status
    'wrong'
    """
    if lam.has(sp.I) and claim.has(sp.I):
        raise Wrong(
            "the imaginary unit is left in it: an expression whose sign can be read off was asked "
            "for"
        )
    (symbol,), n, random = lam.free_symbols, transition.rows, np.random.default_rng(61)
    power = 0 if lam == symbol else n // 2
    expression_text = "det(lambda I - A)" + (f"/lambda^{power}" if power else "")
    for stiffness in log_spread(random, 0.1, 9, RECORDS):
        at = random.uniform(-3, 3)
        point = complex(lam.subs(symbol, at))
        true = (
            np.linalg.det(point * np.eye(n) - _matrix(transition, kappa, stiffness)) / point**power
        )
        where = f" at lambda = {number_text(point)}" if power else ""
        values, size = {symbol: at, kappa: stiffness}, abs(true) + 1
        yield SameValue(claim, true.real, expression_text + where, values, size)
    return f"it is {expression_text} for random {symbol} and {kappa}"


@judged(Number())
def multiple_eigenvalues(number, transition, kappa):
    """Check the kappa > 0 for which eigenvalues coincide, to three digits or exactly."""
    claim = float(number)
    if claim <= 0:
        raise Wrong(f"kappa = {claim:.4g} is not positive")
    rounding = half_unit(claim) if in_decimals(number) else 1e-6 * claim
    low, high = (_split(transition, kappa, claim + side * rounding) for side in (-1, 1))
    if not low * high <= 0:
        values = np.linalg.eigvals(_matrix(transition, kappa, claim))
        gap = min(abs(a - b) for k, a in enumerate(values) for b in values[:k])
        raise Wrong(
            f"for kappa = {claim:.4g} the eigenvalues are different: the nearest two are {gap:.3g} "
            "apart"
        )
    return "here pairs of complex eigenvalues meet on the real axis"


@judged(Number())
def digits_lost(number, transition, kappa, value):
    """Check by how many decimal digits the error of the forward recursion grows each sample."""
    claim = float(number)
    greatest = np.abs(np.linalg.eigvals(_matrix(transition, kappa, float(value)))).max()
    if not agree(claim, math.log10(greatest), number):
        factor = 10**claim if abs(claim) < 300 else math.inf
        raise Wrong(
            f"by your answer an error grows by the factor {factor:.4g} with every sample; a vector "
            "multiplied many times by the transition matrix does not"
        )
    return "powers of the transition matrix grow by this many digits a sample"


@judged(Expression("times", "samples", "rho", "M"))
def spline_acceleration(claim, times, samples, rho=None, M=None):
    """Check the acceleration of the motion of least cost at the middle one of three samples.

    The samples have the equal weight rho; without weights the easiest motion through the
    samples is meant.
    """
    for values, t, h in _random_samples(times, samples, *filter(None, (rho, M))):
        states = _least_cost(t, h, values.get(rho), values.get(M))
        size = np.abs(h).max() / t[1] ** 2
        quantity = "the acceleration at the middle sample"
        yield SameValue(claim, _middle(t, *states), quantity, values, size)
    motion_text = (
        "easiest motion through the samples" if rho is None else "motion with the least cost"
    )
    return f"it is that of the {motion_text}, for random values of all symbols"


@judged(Expressions("times", "samples", "rho", "M", length=lambda data: len(data["times"])))
def spline_positions(claims, times, samples, rho, M):
    """Check the positions at the samples of the motion of least cost."""
    for values, t, h in _random_samples(times, samples, rho, M):
        x, _ = _least_cost(t, h, values[rho], values[M])
        for k, claim in enumerate(claims):
            yield SameValue(claim, x[k], f"x{k}", values, np.abs(h).max())
    return "they are those of the motion with the least cost, for random samples and weights"


@judged(Expression("times", "samples", "rho", "D"))
def weight_for_bound(claim, times, samples, rho, D):
    """Check the weight M for which the motion of least cost has the greatest acceleration D."""
    for values, t, h in _bounded(times, samples, rho, D):
        weight = _weight(claim, values)
        wrong = Wrong(
            f"for {rounded_text(values)} the greatest acceleration of the motion of least cost "
            f"with your M = {weight:.4g} is not D"
        )
        if abs(math.log(weight / (values[rho] * t[1] ** 3))) > WEIGHT_RANGE:
            raise wrong
        ((uncertainty,),) = entry_uncertainties(sp.Matrix([[claim]]), values)
        greatest, *accelerations = (
            abs(_middle(t, *_least_cost(t, h, values[rho], max(perturbed_weight, weight / 2))))
            for perturbed_weight in (weight, weight - uncertainty, weight + uncertainty)
        )
        if not abs(greatest - values[D]) <= 1e-8 * values[D] + max(
            abs(acceleration - greatest) for acceleration in accelerations
        ):
            raise wrong
    return "the motion of least cost with this weight has the greatest acceleration D, for random samples and bounds"


@judged(Expression("times", "samples", "rho", "D"))
def spline_misfit(claim, times, samples, rho, D):
    """Check the misfit of the motion of least cost whose greatest acceleration is D.

    The misfit is rho sum (x_k - h_k)^2.
    """
    for values, t, h in _bounded(times, samples, rho, D):
        middle = math.log(values[rho] * t[1] ** 3)
        low, high = middle - WEIGHT_RANGE, middle + WEIGHT_RANGE
        for _ in range(80):
            middle = (low + high) / 2
            states = _least_cost(t, h, values[rho], math.exp(middle))
            low, high = (middle, high) if abs(_middle(t, *states)) > values[D] else (low, middle)
        misfit, size = (values[rho] * np.sum(part**2) for part in (states[0] - h, h))
        yield SameValue(claim, misfit, "the misfit", values, size, 1e-8)
    return (
        "it is the misfit of the motion whose weight meets the bound, for random samples and bounds"
    )


@judged(Expression("times", "samples", "rho", "D"))
def bounded_misfit(claim, times, samples, rho, D):
    """Check the least misfit rho sum (x_k - h_k)^2 among all motions with |u| <= D."""
    from scipy.optimize import lsq_linear

    for values, t, h in _bounded(times, samples, rho, D):
        knots = np.unique(
            np.concatenate([np.linspace(a, b, PIECES + 1) for a, b in itertools.pairwise(t)])
        )
        step = np.diff(knots)
        # x at the samples from x0, y0 and constant accelerations on the pieces
        reach = np.clip(t[:, None] - knots[:-1], 0, None)
        rows = np.column_stack(
            [np.ones(t.size), t - t[0], (reach**2 - np.clip(reach - step, 0, None) ** 2) / 2]
        )
        limits = np.append([np.inf, np.inf], np.full(step.size, values[D]))
        solution = lsq_linear(rows, h, (-limits, limits), method="bvls", tol=1e-14)
        least, size = 2 * values[rho] * solution.cost, values[rho] * np.sum(h**2)
        yield SameValue(claim, least, "the least misfit", values, size, 1e-7)
    return "no motion within the bound fits better, for random samples and bounds"


@judged(Expression("omega", "rho", "M"))
def filter_gain(claim, omega, rho, M):
    """Check the factor g with which x = g cos(omega t) solves the filter equation.

    The equation is M x'''' + rho (x - cos(omega t)) = 0.

    Can decide when the weights are positive, for random values of the symbols.

    Examples
    --------
    >>> w, r, m = sp.symbols("w r m", positive=True)
    >>> checks.research.filter_gain(r/(r + m*w**4), w, r, m).status
    'right'
    >>> checks.research.filter_gain(r/(r + m*w**2), w, r, m).status
    'wrong'
    """
    for values in in_every_case(random_values([omega, rho, M], SEED), claim):
        gain = value_at(claim, values, "the factor")
        residual = values[M] * values[omega] ** 4 * gain + values[rho] * (gain - 1)
        if not abs(residual) <= 1e-9 * (values[M] * values[omega] ** 4 + values[rho]):
            raise Wrong(
                f"for {rounded_text(values)}, at t = 0, your motion leaves M x'''' + rho (x - h) = "
                f"{residual:.4g}"
            )
    return "x = g h satisfies the equation, for random frequencies and weights"


@judged(Expression("rho", "M"))
def boundary_decay(claim, rho, M):
    """Check the rate at which the influence of an end decays.

    It is -Re s of the solutions exp(s t) of M x'''' + rho x = 0 that decay.

    Can decide when the weights are positive, for random values of the symbols.

    Examples
    --------
    >>> r, m = sp.symbols("r m", positive=True)
    >>> checks.research.boundary_decay((r/m)**sp.Rational(1, 4)/sp.sqrt(2), r, m).status
    'right'
    >>> checks.research.boundary_decay((r/m)**sp.Rational(1, 4), r, m).status
    'wrong'
    """
    for values in in_every_case(random_values([rho, M], SEED), claim):
        roots = np.roots([values[M], 0, 0, 0, values[rho]])
        yield SameValue(
            claim, -max(root.real for root in roots if root.real < 0), "the rate of decay", values
        )
    return "the solutions exp(s t) that decay have -Re s equal to it, for random weights"


@judged(Expression("amplitude", "omega", "rho", "D"))
def weight_of_harmonic(claim, amplitude, omega, rho, D):
    """Check the weight M for which a reconstructed harmonic has the greatest acceleration D.

    The harmonic is `amplitude` cos(omega t).
    """
    for values in in_every_case(random_values([amplitude, omega, rho, D], SEED), claim):
        values[D] = values[amplitude] * values[omega] ** 2 * 0.8 * values[D] / (1 + values[D])
        weight = _weight(claim, values)
        # x = size cos(omega t) solves the equation
        size = values[rho] * values[amplitude] / (weight * values[omega] ** 4 + values[rho])
        if not abs(size * values[omega] ** 2 - values[D]) <= 1e-9 * values[D]:
            raise Wrong(
                f"for {rounded_text(values)} the greatest acceleration with your M = {weight:.4g} "
                "is not D"
            )
    return "with this weight the greatest acceleration is D, for random measurements and bounds"


def _matrix(transition, kappa, value):
    return np.array(transition.subs(kappa, value).evalf(), dtype=float)


def _split(transition, kappa, value):
    """Return (w1 - w2)^2 for the two values w of lambda + 1/lambda.

    Its sign changes where pairs of eigenvalues meet.
    """
    _, first, second, _, _ = np.poly(_matrix(transition, kappa, value))
    return first**2 - 4 * (second - 2)


def _least_cost(t, h, rho, M):
    """Return positions and velocities at the samples; with M None the motion is through them."""
    n = t.size
    cost = np.zeros((2 * n, 2 * n))
    for k, tau in enumerate(np.diff(t)):
        miss = np.zeros((2, 2 * n))
        miss[0, [2 * k, 2 * k + 1, 2 * k + 2]] = -1, -tau, 1
        miss[1, [2 * k + 1, 2 * k + 3]] = -1, 1
        cost += miss.T @ np.array([[12 / tau**3, -6 / tau**2], [-6 / tau**2, 4 / tau]]) @ miss
    x, y = slice(0, None, 2), slice(1, None, 2)
    if M is None:
        return h, np.linalg.solve(cost[y, y], -cost[y, x] @ h)
    right = np.zeros(2 * n)
    right[x] = rho * h
    states = np.linalg.solve(M * cost + np.diag(np.tile([rho, 0.0], n)), right)
    return states[x], states[y]


def _middle(t, x, y):
    """Return the acceleration at the second sample, from the cubic before it."""
    tau = t[1] - t[0]
    return (6 * (x[0] - x[1]) / tau + 2 * y[0] + 4 * y[1]) / tau


def _weight(claim, values):
    """Return the number of a claimed weight M, or raise `Wrong` if it is not positive."""
    weight = value_at(claim, values, "M")
    if weight <= 0:
        raise Wrong(f"for {rounded_text(values)} your M = {weight:.4g} is not positive")
    return weight


def _random_samples(times, samples, *further_symbols):
    """Yield random positive values of all symbols, with times and samples as arrays."""
    symbols = sorted(sp.Tuple(*times, *samples).free_symbols, key=str)
    for values in random_values([*symbols, *further_symbols], SEED):
        t, h = (
            np.array([float(sp.sympify(part).subs(values)) for part in parts])
            for parts in (times, samples)
        )
        yield values, t, h


def _bounded(times, samples, rho, D):
    """Yield random samples with an active bound D, active for the direct method too."""
    random = np.random.default_rng(65)
    for values, t, h in _random_samples(times, samples, rho):
        values[D] = random.uniform(0.1, 0.6) * abs(_middle(t, *_least_cost(t, h, 1.0, None)))
        yield values, t, h

"""Moments of a linear process as functions of time: mean, covariance and their limits.

At numbers, the reference is computed from the exponential of a block matrix
(`references/processes.py`), for times and parameters of all sizes. The signs of determinants decide
where a covariance converges and whether it increases.
"""

import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression, Expressions, Matrix, MatrixOrVector, Values
from workbook.checks.contract.verdict import judged
from workbook.checks.references import processes
from workbook.checks.references.spectra import decays
from workbook.checks.tools.comparisons import SameEntries, SameValue
from workbook.checks.tools.conditions import compare, contradiction_message, exactly
from workbook.checks.tools.declared import Truth, declared
from workbook.checks.tools.samples import allowed_values, conjunction, in_every_case
from workbook.checks.tools.wording import (
    number_text,
    part_text,
    tried_text,
    where_text,
)

#: The times at which answers are compared, each with other values of the parameters.
TIMES = (0, sp.Rational(1, 2), 1, sp.Rational(7, 5), 2, 3)
STEPS = (0, 1, 2, 3, 5, 6)
#: The last time at which a case of an answer is compared.
LATEST = 1000


@judged(MatrixOrVector("start", "noises", "parameters", shape=processes.shape_of("mean")))
def state_after_steps(claim, process, start, noises, parameters=(), given=sp.true):
    """Check the state of a process in discrete time after as many steps as there are noises.

    It is a column in the symbols of the initial state and of the noises; of a single coordinate
    an expression.

    Can decide when the process is linear, in discrete time.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> a, m, u, v = sp.symbols("a m u v")
    >>> checks.state_after_steps(a**2*m + a*u + v, Process(A=a, Q=1, discrete=True), [m], [u, v], [a]).status
    'right'
    >>> checks.state_after_steps(a*m + u + v, Process(A=a, Q=1, discrete=True), [m], [u, v], [a]).status
    'wrong'
    """
    columns = [sp.Matrix(c if isinstance(c, (list, tuple)) else [c]) for c in (start, *noises)]
    symbols = dict.fromkeys(s for c in columns for s in sorted(c.free_symbols, key=str))
    samples = allowed_values([*parameters, *symbols], given, len(TIMES))
    for values in in_every_case(samples, claim, given):
        A = processes.to_array(process.A, values)
        true, *disturbances = (processes.to_array(column, values) for column in columns)
        size = abs(true)
        for disturbance in disturbances:
            true, size = A @ true + disturbance, abs(A) @ size + abs(disturbance)
        yield SameEntries(
            claim,
            true,
            lambda claimed, i, j: (
                f"{part_text('state', claimed, i)}{where_text(values)}; it does not satisfy the "
                "equation of the process, applied step by step from the initial state"
            ),
            values,
            size,
        )
    return "the steps, one after the other, lead to this state"


def _wrong_moment(moment, equation):
    """Return the phrase on a moment that does not satisfy its equation or its initial condition."""

    def message(entry):
        time, instant = list(entry.values.items())[-1]
        if instant == 0:
            return (
                f"your {moment} does not satisfy the initial condition: {entry.text} at {time} = 0"
            )
        return f"your {moment} does not satisfy the {equation} of the process{entry.where}: {entry.text}"

    return message


def _at_times(data):
    """Return samples at several times, the time being the last of the values."""
    time, given, times = data["time"], data["given"], data["times"]
    time_range = sp.And(time >= 0, time <= LATEST)
    if times:
        time_range = sp.Or(*(sp.Eq(time, instant) for instant in times))
    times = times or (STEPS if processes.as_process(data["process"]).discrete else TIMES)
    samples = allowed_values(data["parameters"], given, max(len(times), len(TIMES)))
    # However few the times are, the parameters take as many values as elsewhere.
    count = range(max(len(times), len(samples)))
    pairs = zip(itertools.cycle(times), itertools.cycle(samples), count)
    samples = [values | {time: sp.sympify(instant)} for instant, values, _ in pairs]
    return samples, sp.And(conjunction(given), time_range)


@declared(
    MatrixOrVector("time", "parameters", shape=processes.shape_of("mean")),
    right=lambda data: f"it is the mean{tried_text(data['parameters'], 'times')}",
    wrong=_wrong_moment("mean", "equation"),
    samples=_at_times,
)
def mean_at_time(values, process, time, times=None):
    """Check the mean of the process at the time t.

    It is a column; of a single coordinate an expression.

    `times` are those for which the answer is asked, if not for all.

    Can decide when the process is linear, at the times and parameters that are tried.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> t, a, m = sp.symbols("t a m", positive=True)
    >>> checks.mean_at_time(m*sp.exp(-a*t), Process(A=-a, Q=1, mean=m), t, [a, m]).status
    'right'
    >>> checks.mean_at_time(m*sp.exp(a*t), Process(A=-a, Q=1, mean=m), t, [a, m]).status
    'wrong'
    """
    model = processes.at_values(process, values)
    F, _ = processes.transition(model, values[time])
    return Truth(F @ model.mean, abs(F) @ abs(model.mean))


@declared(
    Matrix("time", "parameters", shape=processes.shape_of("A")),
    right=lambda data: f"it is the covariance{tried_text(data['parameters'], 'times')}",
    wrong=_wrong_moment("covariance", "covariance equation"),
    samples=_at_times,
    process="Process or Coloured",
)
def covariance_at_time(values, process, time, times=None):
    """Check the covariance matrix of the process at the time t.

    Of a single coordinate it is an expression.

    `times` are those for which the answer is asked, if not for all.

    Can decide when the process is linear, at the times and parameters that are tried.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> t, q, p = sp.symbols("t q p", positive=True)
    >>> walk = Process(A=0, Q=q, covariance=p)
    >>> checks.covariance_at_time(p + q*t, walk, t, [q, p]).status
    'right'
    >>> checks.covariance_at_time(q*t, walk, t, [q, p]).status
    'wrong'
    """
    model = processes.at_values(process, values)
    F, N = processes.transition(model, values[time])
    # At the initial time too, terms may cancel that are as large as this covariance soon is.
    early = values[time] or (STEPS if model.discrete else TIMES)[1]
    early_covariance = processes.transition(model, early)[1]
    size = abs(F) @ abs(model.covariance) @ abs(F).T + abs(early_covariance)
    return Truth(F @ model.covariance @ F.T + N, size.max())


@judged(Expression("time", "parameters"), process="Process or Coloured")
def correlation_at_time(claim, process, time, of, parameters=(), given=sp.true, times=None):
    """Check the correlation coefficient at the time t of two quantities, with the rows `of`.

    `times` are those for which the answer is asked, if not for all after the start.

    Can decide when the process is linear, at the times and parameters that are tried.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> t = sp.Symbol("t", positive=True)
    >>> walk = Process(A=[[0, 1], [0, 0]], Q=[[0, 0], [0, 1]])
    >>> checks.correlation_at_time(sp.sqrt(3)/2, walk, t, sp.eye(2)).status
    'right'
    >>> checks.correlation_at_time(sp.Rational(3, 4), walk, t, sp.eye(2)).status
    'wrong'
    """
    rows = processes.to_array(of, {})
    correlations = []
    data = {"process": process, "time": time, "parameters": parameters, "given": given}
    samples, domain = _at_times(data | {"times": times or TIMES[1:]})
    for values in in_every_case(samples, claim, domain):
        model = processes.at_values(process, values)
        covariance = rows @ processes.moments(model, values[time])[1] @ rows.T
        correlations.append(
            (covariance[0, 1] / np.sqrt(covariance[0, 0] * covariance[1, 1]), values)
        )
    constant = np.ptp([true for true, _ in correlations]) < 1e-9
    quotient = "the covariance divided by the product of the standard deviations"
    for true, values in correlations:
        yield SameValue(claim, true, quotient, values, constant=constant)
    return f"it is {quotient}"


@judged(Expressions("parameters", length=3), process="Coloured")
def shaping_filter(claims, process, parameters=(), given=sp.true):
    """Check the shaping filter [a, Q, D] of the noise of a `Coloured` process.

    The equation is w' = a w + q, with the intensity Q of q and the variance D of w(0).

    Can decide when the correlation is that of a first-order equation; with parameters at sample
    values.

    Examples
    --------
    >>> from workbook.systems import Coloured
    >>> tau = sp.Symbol("tau", positive=True)
    >>> wind = Coloured(correlation=8*sp.exp(-tau), delay=tau, C=1)
    >>> checks.shaping_filter([-1, 16, 8], wind).status
    'right'
    >>> checks.shaping_filter([1, 16, 8], wind).status
    'wrong'
    """
    for values in in_every_case(allowed_values(parameters, given, len(TIMES)), claims, given):
        D, a = (
            float(expression.subs(values)) for expression in processes.variance_and_rate(process)
        )
        names = "coefficient", "intensity", "initial variance"
        for claim, true, name in zip(claims, (-a, 2 * a * D, D), names):
            quantity = f"the {name} of the equation that keeps the given correlation"
            yield SameValue(claim, true, quantity, values, max(a, a * D, D))
    return "what it makes has the given correlation at all times"


def _at_convergence(data):
    """Return samples of the parameters at which the process converges."""
    process = processes.as_process(data["process"])
    convergence = sp.And(conjunction(data["given"]), decays(process.A, process.discrete))
    return allowed_values(data["parameters"], convergence, len(TIMES)), convergence


@declared(
    Matrix("parameters", shape=processes.shape_of("A")),
    right="the process keeps this covariance, and comes to it from any other",
    wrong=lambda entry: (
        f"a process that had your covariance would not keep it{entry.where}: by the "
        f"covariance equation it changes; {entry.text}"
    ),
    samples=_at_convergence,
    process="Process, Coloured or FilterErrors",
)
def stationary_covariance(values, process):
    """Check the covariance matrix that the process converges to from every initial covariance.

    It is compared at the parameters for which the process converges.

    Can decide when all modes decay; with parameters at sample values that satisfy what is given.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> a, q = sp.symbols("a q", positive=True)
    >>> noise = Process(A=-a, Q=q)
    >>> checks.stationary_covariance(q/(2*a), noise, [a, q]).status
    'right'
    >>> checks.stationary_covariance(q/a, noise, [a, q]).status
    'wrong'
    """
    model = processes.at_values(processes.as_process(process), values, start=False)
    true = processes.stationary_covariance(model)
    return Truth(true, abs(true).max())


@declared(
    Values("parameters", expected="a list or a set of exponents"),
    right="each part of the covariance changes with one of them",
    wrong=(
        "no part of the covariance changes with the exponent {number}{where}",
        "a part of the covariance changes with an exponent that your answer does not name{where}",
    ),
)
def covariance_exponents(values, process):
    """Check the different l with e^(l t), in discrete time l^k, in the covariance of a process.

    The process has any initial covariance; what the noise contributes in the limit is not
    counted.

    Can decide when the process is linear; with parameters at sample values.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> a = sp.Symbol("a", positive=True)
    >>> checks.covariance_exponents([-2*a], Process(A=-a, Q=1), [a]).status
    'right'
    >>> checks.covariance_exponents([-a], Process(A=-a, Q=1), [a]).status
    'wrong'
    """
    process = processes.as_process(process)
    modes = np.linalg.eigvals(processes.to_array(process.A, values))
    pairs = itertools.combinations_with_replacement(modes, 2)
    true = [first * second if process.discrete else first + second for first, second in pairs]
    return Truth(true, max(map(abs, true)))


@judged(process="Process, Coloured or FilterErrors")
def stationary_covariance_exists(answer, process, parameters, given=sp.true):
    """Check the parameters for which the covariance converges whatever it is initially.

    It converges to one and the same matrix.

    Can decide when the entries are polynomials in the parameters; elsewhere the condition is
    compared at points.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> a = sp.Symbol("a", real=True)
    >>> checks.stationary_covariance_exists(a > 0, Process(A=-a, Q=1), [a]).status
    'right'
    >>> checks.stationary_covariance_exists(a >= 0, Process(A=-a, Q=1), [a]).status
    'wrong'
    """
    process = processes.as_process(process)

    def message(values):
        modes = np.linalg.eigvals(processes.to_array(process.A, values))
        kind, sizes = ("modulus", abs(modes)) if process.discrete else ("real part", modes.real)
        return f"the largest {kind} of an eigenvalue is {sizes.max():.4g} there"

    reference = exactly(decays(process.A, process.discrete), given)
    agreement = compare(answer, parameters, reference, contradiction_message(message))
    return f"there and nowhere else all initial covariances lead to the same limit: {agreement}"


@judged
def covariance_increases(answer, process, parameters, given=sp.true):
    """Check the condition under which the variance of every combination increases all the time.

    It is a condition on the parameters; of a single coordinate its variance is meant.

    The rate of change D(0) decides, as D(t) = F D(0) F^T with the transition matrix F.

    Can decide when the coefficients are polynomials in the parameters; elsewhere the condition is
    compared at points.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> a, p = sp.symbols("a p", positive=True)
    >>> checks.covariance_increases(2*a*p < 1, Process(A=-a, Q=1, covariance=p), [a, p]).status
    'right'
    >>> checks.covariance_increases(a*p < 1, Process(A=-a, Q=1, covariance=p), [a, p]).status
    'wrong'
    """
    process = processes.as_process(process)
    A, P = sp.Matrix(process.A), sp.Matrix(process.covariance)
    rate = A * P * A.T + process.Q - P if process.discrete else A * P + P * A.T + process.Q
    minors = (sp.factor(rate[:k, :k].det()) for k in range(1, A.rows + 1))
    invertible = sp.Ne(A.det(), 0) if process.discrete else sp.true
    increases = sp.And(*(minor > 0 for minor in minors), invertible)

    def message(values):
        rate_there = sp.Matrix(rate.subs(values))
        if rate_there.rows == 1:
            return f"at the beginning the variance changes at the rate {number_text(complex(rate_there[0]))}"
        return f"there the variances change at the rates {', '.join(map(str, rate_there.diagonal()))} at the beginning"

    reference = exactly(increases, conjunction(given))
    agreement = compare(answer, parameters, reference, contradiction_message(message))
    return f"it rises there and nowhere else: {agreement}"

"""Optimal estimates and their errors: measurements at single instants, steady filters.

The reference is the conditional law of a Gaussian vector of all states and measurements together, or
the stabilising solution of a Riccati equation at numbers, from an invariant subspace
(`references/processes.py`); no filter is run.

The data `measured` are pairs (time, value or values). Times, values and the time `at` of the
estimated state may contain the parameters. A time may also be `sp.Range(1, n + 1)`: then the value is
measured at each of these times. Without R the measurements are exact. The state of a stationary
process may also be estimated at times before 0.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Matrix, MatrixOrVector, Values
from workbook.checks.contract.verdict import judged
from workbook.checks.references import processes, regulators
from workbook.checks.tools.comparisons import SameEntries
from workbook.checks.tools.conditions import compare
from workbook.checks.tools.declared import Truth, declared
from workbook.checks.tools.riccati_terms import innovation_text, wrong_degree_text
from workbook.checks.tools.samples import allowed_values, in_every_case
from workbook.checks.tools.wording import (
    number_text,
    part_text,
    values_text,
    where_text,
)

COUNT = 6
#: Relative size below which a number is zero up to rounding.
ROUNDED = 1e-9
BEFORE, AFTER = "before", "after"


def _at_time_or_parameters(data):
    """Return samples of the parameters; twice as many if the time has symbols."""
    count = COUNT * (1 + bool(sp.sympify(data["at"]).free_symbols))
    return allowed_values(data["parameters"], data["given"], count), data["given"]


@declared(
    MatrixOrVector("parameters", shape=processes.shape_of("mean")),
    right="it is the mean of the state under the condition of what was measured",
    wrong=lambda entry: (
        f"{part_text('estimate', entry.claimed, entry.row)}{entry.where}; this is not the "
        "conditional mean of the state, given the measurements"
    ),
    samples=_at_time_or_parameters,
    process="Process or Coloured",
)
def estimate(values, process, measured, at):
    """Check the best estimate of the state at a time from the measurements.

    Of a single coordinate it is an expression.

    Can decide when the process is linear and Gaussian; with parameters at sample values that
    satisfy what is given.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> m, z = sp.symbols("m z")
    >>> constant = Process(A=0, Q=0, H=1, R=1, mean=m, covariance=3)
    >>> checks.estimate((m + 3*z)/4, constant, [(0, z)], 2, [m, z]).status
    'right'
    >>> checks.estimate((m + z)/2, constant, [(0, z)], 2, [m, z]).status
    'wrong'
    """
    _, measurements, mean, _ = _conditional_moments(values, process, measured, at)
    largest = max((abs(z) for _, row in measurements for z in row), default=0)
    return Truth(mean, abs(mean).max() + largest)


@declared(
    Matrix("parameters", shape=processes.shape_of("A")),
    right="it is the covariance of the state under the condition of what was measured",
    wrong=lambda entry: (
        "your covariance is not the conditional covariance of the state, given the "
        f"measurements{entry.where}: {entry.text}"
    ),
    samples=_at_time_or_parameters,
    process="Process or Coloured",
)
def estimate_covariance(values, process, measured, at):
    """Check the covariance matrix of the errors of the best estimate at a time.

    Of a single coordinate it is the variance.

    Can decide when the process is linear; with parameters at sample values that satisfy what is
    given.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> z = sp.Symbol("z")
    >>> constant = Process(A=0, Q=0, H=1, R=1, mean=0, covariance=3)
    >>> checks.estimate_covariance(sp.Rational(3, 4), constant, [(0, z)], 2, [z]).status
    'right'
    >>> checks.estimate_covariance(3, constant, [(0, z)], 2, [z]).status
    'wrong'
    """
    model, _, _, covariance = _conditional_moments(values, process, measured, at)
    return Truth(covariance, abs(processes.moments(model, sp.sympify(at).subs(values))[1]).max())


@declared(
    MatrixOrVector("parameters", shape=processes.shape_of("mean")),
    right="its square is the variance of the state under the condition of what was measured",
    wrong=lambda entry: (
        f"{part_text('answer', entry.claimed, entry.row)}{entry.where}; "
        + (
            "a standard deviation is not negative"
            if entry.number.real < 0
            else "its square is not the variance of the error of the best estimate"
        )
    ),
    samples=_at_time_or_parameters,
    process="Process or Coloured",
)
def estimate_standard_deviations(values, process, measured, at):
    """Check the standard deviations of the errors of the best estimate at a time.

    They are a column; of a single coordinate an expression.

    Can decide when the process is linear; with parameters at sample values that satisfy what is
    given.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> z = sp.Symbol("z")
    >>> constant = Process(A=0, Q=0, H=1, R=1, mean=0, covariance=3)
    >>> checks.estimate_standard_deviations(0.866, constant, [(0, z)], 2, [z]).status
    'right'
    >>> checks.estimate_standard_deviations(0.75, constant, [(0, z)], 2, [z]).status
    'wrong'
    """
    *_, covariance = _conditional_moments(values, process, measured, at)
    return Truth(np.sqrt(np.diag(covariance))[:, None])


def _steady_failure(entry):
    """Return the message on the covariance of a steady filter: the property that fails."""
    (model, moment), P = entry.context, entry.claimed.real
    if entry.claimed.imag.any() or not abs(P - P.T).max() <= ROUNDED * abs(P).max():
        failure = "is not real and symmetric"
    elif np.linalg.eigvalsh(P).min() < -ROUNDED * abs(P).max():
        failure = "gives some combination of the states a negative variance"
    else:
        try:
            changes = processes.changes_covariance(model, P, moment == AFTER)
        except np.linalg.LinAlgError:
            changes = True  # no gain: the equation has no meaning there
        failure = (
            "does not satisfy the Riccati equation"
            if changes
            else "satisfies the Riccati equation, but the errors do not decay with its gain"
        )
    return f"your covariance {failure}{entry.where}: {entry.text}"


@declared(
    Matrix("parameters", shape=processes.shape_of("A")),
    right="the Riccati equation keeps this covariance, and with it the errors of the filter decay",
    wrong=_steady_failure,
    process="Process or Coloured",
)
def steady_covariance(values, process, moment=BEFORE):
    """Check the covariance matrix of the errors of the steady filter.

    In discrete time it is that at the `moment` of a measurement, "before" or "after".

    Can decide when the steady filter exists; with parameters at sample values that satisfy what is
    given.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> q, r = sp.symbols("q r", positive=True)
    >>> walk = Process(A=0, Q=q, H=1, R=r)
    >>> checks.steady_covariance(sp.sqrt(q*r), walk, [q, r]).status
    'right'
    >>> checks.steady_covariance(q*r, walk, [q, r]).status
    'wrong'
    """
    model = processes.at_values(process, values, start=False)
    true = processes.steady_covariances(model)[(BEFORE, AFTER).index(moment)]
    return Truth(true, abs(true).max(), (model, moment))


def _gain_effect(entry):
    """Return the message on the gain of a steady filter: its effect on the errors."""
    model, gain = entry.context, entry.claimed
    roots = np.linalg.eigvals(model.A - (model.A @ gain if model.discrete else gain) @ model.H)
    error_grows = (np.log(abs(roots)) if model.discrete else roots.real).max() > 0
    effect = (
        "an error grows"
        if error_grows
        else "the errors settle to a larger covariance than they need"
    )
    return (
        f"with your gain {effect}{entry.where}: look at row {entry.row + 1}, where it is "
        f"{number_text(entry.number)}"
    )


@declared(
    MatrixOrVector(
        "parameters", shape=lambda data: processes.as_process(data["process"]).H.T.shape
    ),
    right="no other gain makes the variances of the errors smaller",
    wrong=_gain_effect,
    process="Process or Coloured",
)
def steady_gain(values, process):
    """Check the gain K of the steady filter, a column for each measurement.

    The filter is y' = A y + K (z - H y), in discrete time y+ = y + K (z - H y).

    Can decide when the steady filter exists; with parameters at sample values that satisfy what is
    given.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> q, r = sp.symbols("q r", positive=True)
    >>> walk = Process(A=0, Q=q, H=1, R=r)
    >>> checks.steady_gain(sp.sqrt(q/r), walk, [q, r]).status
    'right'
    >>> checks.steady_gain(q/r, walk, [q, r]).status
    'wrong'
    """
    model = processes.at_values(process, values, start=False)
    true = processes.filter_gain(model, processes.steady_covariances(model)[0])
    return Truth(true, abs(true).max(), model)


@judged
def steady_filter_exists(answer, process, parameters):
    """Check the condition under which there is a steady filter whose errors decay.

    It is a condition on the parameters.

    Can decide when the coefficients are polynomials in the parameters; elsewhere the condition is
    compared at points.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> h = sp.Symbol("h", real=True)
    >>> checks.steady_filter_exists(sp.Ne(h, 0), Process(A=1, Q=1, H=h, R=1), [h]).status
    'right'
    >>> checks.steady_filter_exists(h > 0, Process(A=1, Q=1, H=h, R=1), [h]).status
    'wrong'
    """

    def message(values, holds):
        if holds:
            return (
                f"your condition does not hold for {values_text(values)}; there a filter settles, "
                "and its errors decay"
            )
        return (
            f"your condition holds for {values_text(values)}; there look at a mode that does not "
            "decay and is not measured, or at one that neither decays nor grows and that the noise "
            "does not reach"
        )

    agreement = compare(answer, parameters, processes.steady_exists(process), message)
    return f"a filter settles, and its errors decay, for these values alone: {agreement}"


@judged(
    MatrixOrVector(
        "estimates", "outputs", "covariance", "parameters", shape=processes.shape_of("mean")
    )
)
def filter_equation(claim, process, estimates, outputs, covariance, parameters=()):
    """Check the right-hand side y' = ... of the equation of the filter in continuous time.

    It is a column in the symbols of the estimates y, of the outputs z and of P, the
    `covariance` of the errors; of a single coordinate an expression.

    Can decide when the process is linear, at sample values of all symbols.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> e, z, p = sp.symbols("e z p")
    >>> checks.filter_equation(p*(z - e), Process(A=0, Q=4, H=1, R=1), [e], [z], sp.Matrix([[p]])).status
    'right'
    >>> checks.filter_equation(p*(e - z), Process(A=0, Q=4, H=1, R=1), [e], [z], sp.Matrix([[p]])).status
    'wrong'
    """
    symbols = [*parameters, *estimates, *outputs, *sorted(covariance.free_symbols, key=str)]
    for values in in_every_case(allowed_values(symbols, sp.true, COUNT), claim):
        model = processes.at_values(process, values, start=False)
        P = processes.to_array(covariance, values)
        y, z = (processes.to_array(sp.Matrix(names), values) for names in (estimates, outputs))
        gain = processes.filter_gain(model, P)
        terms = model.A @ y, gain @ z, -gain @ model.H @ y
        size = sum(map(abs, terms))

        def message(claimed, i, _):
            return (
                f"your rate of change of {estimates[i]} is "
                f"{number_text(claimed[i, 0])}{where_text(values)}; "
                + innovation_text(claim, values, outputs, model.H @ y, terms[0], size)
            )

        yield SameEntries(claim, sum(terms), message, values, size)
    return "the estimate moves like the process, and the innovation is taken in with the best gain"


@judged(Matrix("covariance", "parameters", shape=lambda data: data["covariance"].shape))
def riccati_equation(claim, process, covariance, parameters=()):
    """Check the right-hand side of the Riccati equation of the filter.

    It is a matrix in the symbols of P, the `covariance`: in continuous time P' = ..., in
    discrete time the covariance before the next measurement, if P is that before this one.

    Can decide when the process is linear, at sample values of its parameters and of the
    covariance.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> p = sp.Symbol("p", positive=True)
    >>> checks.riccati_equation(4 - p**2, Process(A=0, Q=4, H=1, R=1), sp.Matrix([[p]])).status
    'right'
    >>> checks.riccati_equation(4 + p**2, Process(A=0, Q=4, H=1, R=1), sp.Matrix([[p]])).status
    'wrong'
    """
    symbols = [*parameters, *sorted(covariance.free_symbols, key=str)]
    units = regulators.covariance_units(processes.as_process(process))
    for k, values in enumerate(in_every_case(allowed_values(symbols, sp.true, COUNT), claim)):
        values = _definite(covariance, values, units / 9 if k % 2 else units)
        model = processes.at_values(process, values, start=False)
        P = processes.to_array(covariance, values)
        A, gain = model.A, processes.filter_gain(model, P)
        if model.discrete:
            terms = A @ P @ A.T, -A @ gain @ model.H @ P @ A.T, model.Q
        else:
            terms = A @ P, P @ A.T, model.Q, -P @ model.H.T @ gain.T
        size = sum(map(abs, terms))

        def message(claimed, i, j):
            entry = f"entry ({i + 1}, {j + 1}) is {number_text(claimed[i, j])}{where_text(values)}"
            if model.discrete:
                return (
                    f"your {entry}; it is not that of the covariance of the error before the next "
                    "measurement"
                )
            text = wrong_degree_text(claim, values, covariance, terms, size, "the covariance")
            return f"your rate of change of the {entry}; {text}"

        yield SameEntries(claim, sum(terms), message, values, size)
    return "the motion, the noise and the measurement change the covariance at this rate"


@declared(
    Values("parameters", expected="a list or a set of eigenvalues"),
    right="these are the modes by which errors of the steady filter decay",
    wrong=(
        "{number} is no eigenvalue of the matrix of the errors{where}: no error is multiplied by it",
        "an error decays by a mode that your answer does not name{where}",
    ),
    process="Process or Coloured",
)
def error_eigenvalues(values, process):
    """Check the different eigenvalues of the error matrix of the steady filter.

    The matrix is A - K H, in discrete time A (I - K H).

    Can decide when the steady filter exists; with parameters at sample values that satisfy what is
    given.

    Examples
    --------
    >>> from workbook.systems import Process
    >>> walk = Process(A=0, Q=4, H=1, R=1)
    >>> checks.error_eigenvalues([-2], walk).status, checks.error_eigenvalues([2], walk).status
    ('right', 'wrong')
    """
    model = processes.at_values(process, values, start=False)
    gain = processes.filter_gain(model, processes.steady_covariances(model)[0])
    loop = model.A - (model.A @ gain if model.discrete else gain) @ model.H
    return Truth(np.linalg.eigvals(loop), np.linalg.norm(loop))


def _definite(covariance, values, sizes):
    """Return values with the diagonal of the covariance enlarged until it is positive definite.

    Its entries are then multiplied by `sizes`.
    """
    matrix = covariance.subs(values)
    added = [sum(map(abs, matrix[k, :])) - matrix[k, k] for k in range(matrix.rows)]
    definite = (matrix + sp.diag(*added)).multiply_elementwise(sizes)
    return values | dict(zip(covariance, definite))


def _conditional_moments(values, process, measured, at):
    """Return the model, the measurements, and mean and covariance given them, at numbers."""
    measurements = [
        (time, [float(sp.sympify(z).subs(values)) for z in np.atleast_1d(np.array(value, object))])
        for instant, value in measured
        for time in _times(sp.sympify(instant).subs(values))
    ]
    model = processes.at_values(process, values)
    moments = processes.conditional_moments(model, measurements, sp.sympify(at).subs(values))
    return model, measurements, *moments


def _times(instant):
    return list(instant) if isinstance(instant, sp.Range) else [instant]

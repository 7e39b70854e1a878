"""Linear-quadratic regulators, `Quadratic`, and feedback by noisy measurements.

A gain is judged by its own cost, which is linear algebra. It is the best one if every state decays
and no other gain is better at first, when the later cost is that under the gain itself (one step of
policy iteration). With a given end, or where states need not decay, the least cost is computed from
the data (`references/regulators.py`).
"""

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression, Matrix, MatrixOrVector, Values
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.feedback.loops import Gain
from workbook.checks.references import processes, regulators
from workbook.checks.references.fixed_modes import ON_BORDER
from workbook.checks.tools.comparisons import SameEntries
from workbook.checks.tools.declared import Truth, at_symbols, declared
from workbook.checks.tools.riccati_terms import innovation_text, wrong_degree_text
from workbook.checks.tools.samples import allowed_values, in_every_case
from workbook.checks.tools.values import matrix_at
from workbook.checks.tools.wording import entry_text, number_text, where_text

COUNT = 6
#: Relative size below which a number is zero up to rounding.
ROUNDED = 1e-9
#: The fractions of the duration at which a law or a cost that depends on time is compared.
PARTS = (0, 0.2, 0.5, 0.8, 0.95, 1)


@judged(Gain("time", "parameters", shape=lambda data: data["problem"].B.T.shape))
def optimal_gain(claim, problem, time=None, parameters=(), given=sp.true):
    """Check the gain K of the law u = Kx of least cost.

    With a given end it is an expression in the symbol of `time`. An empty list says that no law
    is the best of those that bring every state to zero.

    Can decide when the weight of the control is positive definite: the gain is compared with the
    least cost at numbers, for sample values of parameters and times.

    Examples
    --------
    >>> from workbook.systems import Quadratic
    >>> problem = Quadratic(A=1, B=1, G=3, N=1)
    >>> checks.optimal_gain(-3, problem).status, checks.optimal_gain(1, problem).status
    ('right', 'wrong')
    """
    if claim is None:
        if problem.anywhere or problem.duration != sp.oo or regulators.exists(problem):
            raise Wrong(
                "there is a best law: none exists only if a mode that does not decay is "
                "uncontrollable or, where all states have to come to zero, if one on the imaginary "
                "axis is unobservable in the cost"
            )
        return (
            "no law is the best one: a mode that does not decay is uncontrollable, or one on the "
            "imaginary axis is unobservable in the cost"
        )
    for values, regulator, instant in _regulators_in_time(problem, time, claim, parameters, given):
        if np.isfinite(regulator.duration) or regulator.anywhere:
            true = regulator.gain_for(regulator.least(instant))
        else:
            true = _improved_gain(claim, regulator, values)
        message = _gain_message(regulator, where_text(values))
        yield SameEntries(claim, true, message, values, abs(true).max())
    return "every state is led at the least cost"


def _improved_gain(claim, regulator, values):
    """Return the best gain at present if the claimed one is used later."""
    claimed = matrix_at(claim, values)
    if claimed.imag.any():
        raise Wrong(f"your gain is not real{where_text(values)}")
    claimed = claimed.real
    roots = np.linalg.eigvals(regulator.A + regulator.B @ claimed)
    try:
        cost = regulator.cost_of(claimed)
    except np.linalg.LinAlgError:
        raise Wrong(
            f"under your law not every state comes to zero{where_text(values)}: A + BK has the "
            f"eigenvalue {number_text(roots[np.argmax(roots.real)])}"
        ) from None

    return regulator.gain_for(cost)


def _gain_message(regulator, where):
    def message(claimed, i, j):
        if np.isfinite(regulator.duration) or regulator.anywhere:
            return (
                f"with your gain the cost from some states is greater than the least one{where}: "
                f"look at the entry ({i + 1}, {j + 1}) of K, where yours is "
                f"{number_text(claimed[i, j])}"
            )
        # Without the cost: close to the best gain it would show the least cost.
        return (
            f"under your law every state comes to zero{where}, but there is a gain with which it "
            "costs less from some state, and more from none"
        )

    return message


@judged(Matrix("time", "parameters", shape="problem.A"))
def cost_matrix(claim, problem, time=None, parameters=(), given=sp.true):
    """Check the matrix S of the least cost from x, factor x^T S x.

    With a given end it is an expression in the symbol of `time`.

    Can decide when the problem has a law of least cost; with parameters and times at sample values
    of them.

    Examples
    --------
    >>> from workbook.systems import Quadratic
    >>> problem = Quadratic(A=1, B=1, G=3, N=1)
    >>> checks.cost_matrix(3, problem).status, checks.cost_matrix(-1, problem).status
    ('right', 'wrong')
    """
    for values, regulator, instant in _regulators_in_time(problem, time, claim, parameters, given):
        true = regulator.least(instant)
        yield SameEntries(claim, true, _cost_message(regulator, values), values, abs(true).max())
    return "it solves the Riccati equation, and its law has this cost from each state"


def _cost_message(regulator, values):
    def message(claimed, i, j):
        point, S = where_text(values), claimed.real
        if np.isfinite(regulator.duration) or claimed.imag.any():
            return (
                "your matrix does not satisfy the Riccati equation with its condition at the "
                f"end{point}: {entry_text(claimed, i, j)}"
            )
        if not abs(S - S.T).max() <= ROUNDED * abs(S).max():
            return f"your matrix is not symmetric{point}, and that of a cost is"
        rates = regulator.rates(S)
        rate, size = sum(rates), sum(map(abs, rates)).max()
        if not abs(rate).max() <= ROUNDED * size:
            i, j = np.unravel_index(abs(rate).argmax(), rate.shape)
            return (
                f"your matrix would not stay constant{point}: by the Riccati equation its entry "
                f"({i + 1}, {j + 1}) changes at the rate {number_text(rate[i, j])}"
            )
        does_not_decay = (
            not regulator.anywhere
            and np.linalg.eigvals(regulator.A + regulator.B @ regulator.gain_for(S)).real.max()
            >= -ON_BORDER
        )
        return f"your matrix solves the Riccati equation{point}, but " + (
            "a cost cannot be negative"
            if np.linalg.eigvalsh(S).min() < -ROUNDED * abs(S).max()
            else "under its law not every state comes to zero"
            if does_not_decay
            else "there is a law that costs less"
        )

    return message


@declared(
    Expression("start", "parameters"),
    right="there is a law that costs this, and none that costs less",
    wrong="the least cost",
    samples=at_symbols("start", count=2 * COUNT),
)
def least_quadratic_cost(values, problem, start):
    """Check the least cost from an initial state at the time 0, in its symbols.

    Can decide when the problem has a law of least cost; initial states and parameters get sample
    values.

    Examples
    --------
    >>> from workbook.systems import Quadratic
    >>> problem = Quadratic(A=1, B=1, G=3, N=1)
    >>> x = sp.Symbol("x")
    >>> checks.least_quadratic_cost(3*x**2, problem, [x]).status
    'right'
    >>> checks.least_quadratic_cost(x**2, problem, [x]).status
    'wrong'
    """
    regulator = regulators.Regulator(problem, values)
    least, x = regulator.least(), np.array([float(values[s]) for s in start])
    return Truth(regulator.factor * x @ least @ x, regulator.factor * abs(x) @ abs(least) @ abs(x))


@declared(
    Values("parameters", expected="a list or a set of eigenvalues"),
    right="these are the modes of the loop with the best law",
    wrong=(
        "{number} is no eigenvalue of the loop with the best law{where}",
        "the loop with the best law has a mode that your answer does not name{where}",
    ),
)
def optimal_eigenvalues(values, problem):
    """Check the different eigenvalues of A + BK under the law of least cost for infinite time.

    Can decide when the problem has a law of least cost in infinite time; with parameters at sample
    values of them.

    Examples
    --------
    >>> from workbook.systems import Quadratic
    >>> problem = Quadratic(A=1, B=1, G=3, N=1)
    >>> checks.optimal_eigenvalues([-2], problem).status, checks.optimal_eigenvalues([2], problem).status
    ('right', 'wrong')
    """
    loop = regulators.Regulator(problem, values).loop()
    return Truth(np.linalg.eigvals(loop), np.linalg.norm(loop))


@declared(
    MatrixOrVector("start", "parameters", shape=lambda data: (data["problem"].A.rows, 1)),
    right="the motion under the best law comes to rest there",
    wrong=lambda entry: (
        f"the motion under the best law{entry.where} comes to rest elsewhere: look "
        f"at component {entry.row + 1}, where yours is {number_text(entry.number)}"
    ),
    samples=at_symbols("start"),
)
def optimal_limit_state(values, problem, start):
    """Check the limit of the state under the law of least cost.

    It is a column in the symbols of the initial state.

    Can decide when every state has a limit under the law of least cost, at sample values of
    initial state and parameters.

    Examples
    --------
    >>> from workbook.systems import Quadratic
    >>> problem = Quadratic(A=1, B=1, G=3, N=1)
    >>> x = sp.Symbol("x")
    >>> checks.optimal_limit_state([0], problem, [x]).status
    'right'
    >>> checks.optimal_limit_state([x], problem, [x]).status
    'wrong'
    """
    from scipy.linalg import null_space

    loop = regulators.Regulator(problem, values).loop()
    # The limit lies in the right kernel of the loop; the left kernel gives the invariants.
    right_kernel, left_kernel = (null_space(matrix, rcond=ON_BORDER) for matrix in (loop, loop.T))
    initial = np.array([[float(values[s])] for s in start])
    limit = right_kernel @ np.linalg.solve(left_kernel.T @ right_kernel, left_kernel.T @ initial)
    return Truth(limit, abs(initial).max())


@judged(Matrix("cost", "parameters", shape="problem.A"))
def cost_riccati_equation(claim, problem, cost, parameters=()):
    """Check the right-hand side of the Riccati equation S' = ... of the cost.

    It is a matrix in the symbols of S, which are the `cost`.

    Can decide when the weight of the control is invertible, at sample values of the parameters and
    of the cost matrix.

    Examples
    --------
    >>> from workbook.systems import Quadratic
    >>> problem = Quadratic(A=1, B=1, G=3, N=1)
    >>> s = sp.Symbol("s")
    >>> checks.cost_riccati_equation(s**2 - 2*s - 3, problem, sp.Matrix([[s]])).status
    'right'
    >>> checks.cost_riccati_equation(s**2 + 2*s - 3, problem, sp.Matrix([[s]])).status
    'wrong'
    """
    symbols = [*parameters, *sorted(cost.free_symbols, key=str)]
    units = regulators.cost_units(problem)
    samples = [
        values | dict(zip(cost, cost.subs(values).multiply_elementwise(units)))
        for values in allowed_values(symbols, sp.true, COUNT)
    ]
    for values in in_every_case(samples, claim):
        regulator, S = regulators.Regulator(problem, values), processes.to_array(cost, values)
        terms = regulator.rates(S)
        size = sum(map(abs, terms))

        def message(claimed, i, j):
            return (
                f"your entry ({i + 1}, {j + 1}) is {number_text(claimed[i, j])}{where_text(values)}; "
                "it is not that of the Riccati equation of the cost: "
                + wrong_degree_text(claim, values, cost, terms, size, "S")
            )

        yield SameEntries(claim, sum(terms), message, values, size)
    return "the remaining cost changes at this rate along the best motion"


@declared(
    Expression("parameters"),
    right="the covariance of the whole loop with the best gains has this cost",
    wrong="the mean cost, from the stationary covariance of the loop with the best gains,",
)
def steady_cost(values, problem, process):
    """Check the least limit of factor E[x^T G x + u^T N u] with a noise that drives the system.

    The control u may depend on the measurements of the process; on the state itself if the
    process has none.

    Can decide when the loop with the best gains has a stationary covariance; with parameters at
    sample values.

    Examples
    --------
    >>> from workbook.systems import Quadratic
    >>> problem = Quadratic(A=1, B=1, G=3, N=1)
    >>> from workbook.systems import Process
    >>> checks.steady_cost(6, problem, Process(A=1, Q=2)).status
    'right'
    >>> checks.steady_cost(3, problem, Process(A=1, Q=2)).status
    'wrong'
    """
    from scipy.linalg import solve_continuous_lyapunov

    loop, noise, weight = regulators.steady_loop(problem, process, values)
    covariance = solve_continuous_lyapunov(loop, -noise)
    return Truth(float(sp.sympify(problem.factor).subs(values)) * np.trace(weight @ covariance))


def _wrong_controller(entry):
    """Return the message on an equation of the controller: its value, and a term to look at."""
    estimates, outputs, innovation, motion, size = entry.context
    return (
        f"your rate of change of {estimates[entry.row]} is {number_text(entry.number)}{entry.where}; "
        + innovation_text(
            entry.answer, entry.values, outputs, innovation, motion, size, controlled=True
        )
    )


@declared(
    MatrixOrVector(
        "estimates", "outputs", "parameters", shape=lambda data: (data["problem"].A.rows, 1)
    ),
    right=(
        "the estimate moves like the system with its control, and the innovation is taken in with "
        "the best gain"
    ),
    wrong=_wrong_controller,
    samples=at_symbols("estimates", "outputs"),
)
def controller_equations(values, problem, process, estimates, outputs):
    """Check the right-hand sides e' = ... of the best feedback by measurements.

    They are a column in the symbols of the estimates e and of the outputs z, the control u = Ke
    inserted.

    Can decide when the steady filter and the law of least cost exist, at sample values of the
    estimates, the outputs and the parameters.

    Examples
    --------
    >>> from workbook.systems import Process, Quadratic
    >>> e, z = sp.symbols("e z")
    >>> data = Quadratic(A=1, B=1, G=3, N=1), Process(A=1, Q=3, H=1, R=1), [e], [z]
    >>> checks.controller_equations(3*z - 5*e, *data).status
    'right'
    >>> checks.controller_equations(3*z - 2*e, *data).status
    'wrong'
    """
    regulator = regulators.Regulator(problem, values)
    model = processes.at_values(process, values, start=False)
    e, z = (processes.to_array(sp.Matrix(names), values) for names in (estimates, outputs))
    L = processes.filter_gain(model, processes.steady_covariances(model)[0])
    motion = regulator.A @ e, regulator.B @ regulator.gain_for(regulator.least()) @ e
    terms = *motion, L @ z, -L @ model.H @ e
    size = sum(map(abs, terms))
    return Truth(sum(terms), size, (estimates, outputs, model.H @ e, sum(motion), size))


def _regulators_in_time(problem, time, claim, parameters, given):
    """Yield (values, regulator, time) at numbers; with a given end at several times each."""
    for values in in_every_case(allowed_values(parameters, given, COUNT), claim, given):
        regulator = regulators.Regulator(problem, values)
        if time is None:
            yield values, regulator, 0.0
            continue
        for part in PARTS:
            instant = sp.Rational(part).limit_denominator(100) * sp.nsimplify(
                regulator.duration, rational=True
            )
            yield values | {time: instant}, regulator, float(instant)

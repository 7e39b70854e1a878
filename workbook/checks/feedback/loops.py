"""Gains, judged by the spectrum of the closed loop A - LH, A + BK or A + BKH.

With an estimate both spectra are judged.

What is required is data: a characteristic polynomial, whose coefficients may be symbols, or a
degree of stability mu, Re lambda <= -mu (for 0 asymptotic stability, Re lambda < 0), for all values of the
parameters that their assumptions allow. Any gain that meets it is right. An empty list says that
there is none, which is judged by the modes that no gain changes.

No check here is declared by a reference: any gain that meets the requirement is right.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from workbook.checks.contract.answer_forms import is_empty_list
from workbook.checks.contract.claims import Claim, MatrixOrVector, Parts
from workbook.checks.contract.tolerance import EXACT, in_decimals
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.references.exceptional_values import judge_everywhere
from workbook.checks.references.fixed_modes import fixed_eigenvalues, slower_than
from workbook.checks.references.records import augmented, controlled_pair, observed_pair
from workbook.checks.references.spectra import Spectrum
from workbook.checks.tools.conditions import Case, ReferenceCondition, compare, exactly
from workbook.checks.tools.samples import conjunction, general_values, in_every_case
from workbook.checks.tools.values import entry_uncertainties, matrix_at, perturbed_arrays
from workbook.checks.tools.wording import number_text, where_text
from workbook.systems import Linear, Scalar


class Gain(MatrixOrVector):
    """A matrix of a given `shape`, a vector also as a row or a column; None for an empty list."""

    def read(self, answer, data):
        return None if is_empty_list(answer) else super().read(answer, data)


class Gains(Claim):
    """A list of two matrices of given `shapes`; None for an empty list."""

    def read(self, answer, data):
        if is_empty_list(answer):
            return None
        gains = (MatrixOrVector(*self.names, shape=shape) for shape in self.form["shapes"](data))
        expected = "a list of two matrices, [K, L], or an empty list"
        return Parts(*gains, expected=expected).read(answer, data)


@dataclass(frozen=True)
class Requirement:
    """A required characteristic `polynomial` in `symbol`, or else a `degree` of stability.

    It is required where the parameters satisfy the conditions `given`.
    """

    parameters: tuple = ()
    given: object = sp.true
    degree: object = 0
    polynomial: object = None
    symbol: object = None

    def impossible(self, pair):
        """Return whether no gain of the pair meets the requirement."""
        if self.polynomial is None:
            return slower_than(self.degree, pair)
        (parameter_values, *_) = self.samples()
        for (values, _), fixed in zip(pair.samples, fixed_eigenvalues(pair)):
            coefficients = self._coefficients(parameter_values | values)
            sizes = np.polyval(abs(coefficients), abs(fixed))
            if (abs(np.polyval(coefficients, fixed)) > 1e-7 * sizes).any():
                return True
        return False

    def judge(self, loop, gain, matrix_name, answer_name="your gain"):
        """Raise `Wrong` unless the matrix `loop(gain)` meets the requirement; return the message.

        Messages call the matrix `matrix_name` and the answer `answer_name`.
        """
        for values in in_every_case(self.samples(), gain, conjunction(self.given)):
            if abs(matrix_at(gain, values).imag).max(initial=0) > 0:
                raise Wrong(f"with {answer_name} {matrix_name} is not real{where_text(values)}")
            if self.polynomial is not None:
                self._judge_polynomial(loop, gain, matrix_name, answer_name, values)
        if self.polynomial is not None:
            return f"the characteristic polynomial of {matrix_name} is the one required"
        return self._judge_degree(loop, gain, matrix_name, answer_name)

    def _admits(self, values):
        return conjunction(self.given).subs(values) is sp.true

    def samples(self):
        return [values for values in general_values(self.parameters) if self._admits(values)]

    def _coefficients(self, values):
        coefficients = sp.Poly(self.polynomial, self.symbol).all_coeffs()
        numbers = np.array([complex(c.subs(values)) for c in coefficients])
        return numbers / numbers[0]

    def _judge_polynomial(self, loop, gain, matrix_name, answer_name, values):
        def closed(matrix):
            return np.array(loop(matrix).subs(values).evalf(30).tolist(), dtype=complex)

        def coefficients(numbers):
            return np.poly(closed(sp.Matrix(numbers)))

        numbers = matrix_at(gain, values)
        claimed, true = coefficients(numbers), self._coefficients(values)
        if len(claimed) != len(true):
            raise RuntimeError("the required polynomial has not the order of the loop")
        size = np.linalg.norm(closed(gain)) + 1
        allowed = EXACT * np.maximum(abs(true), size ** np.arange(len(true)))
        if in_decimals(gain):
            # Every coefficient is linear in each entry, so this bounds the effect of its last digit.
            uncertainty = entry_uncertainties(gain, values)
            for (perturbed,) in perturbed_arrays((numbers,), [uncertainty]):
                allowed = allowed + abs(coefficients(perturbed) - claimed)
        wrong = ~(abs(claimed - true) <= allowed)
        if wrong.any():
            k = int(np.argmax(wrong))
            raise Wrong(
                f"with {answer_name} the characteristic polynomial of {matrix_name} is not the one required"
                f"{where_text(values)}: the coefficient of {self.symbol}^{len(claimed) - 1 - k} is "
                f"{number_text(claimed[k] if abs(claimed[k]) > EXACT * size**k else 0)}"
            )

    def _judge_degree(self, loop, gain, matrix_name, answer_name):
        matrix, slack = loop(in_fractions(gain)), 0
        if self.degree and in_decimals(gain):
            slack = self._slack(loop, gain)
        spectrum = Spectrum(matrix, self.parameters, self.degree - slack)

        def undefined(values):
            return any(entry.subs(values).has(sp.zoo, sp.nan, sp.oo) for entry in gain)

        def message(values, holds):
            if undefined(values):
                return f"an entry of {answer_name} has no value{where_text(values)}"
            stability = (
                "stable with the required degree" if self.degree else "asymptotically stable"
            )
            return (
                f"with {answer_name} {matrix_name} is not {stability}{where_text(values)}: "
                f"{spectrum.describe(values)}"
            )

        right = f"all eigenvalues of {matrix_name} lie where they have to"
        if not self.parameters:
            border = slack - self.degree + EXACT if self.degree else -EXACT
            if not _largest_real_part(matrix) <= border:
                raise Wrong(message({}, False))
            return right
        given = conjunction(self.given)
        # A pole of an entry may cancel in the characteristic polynomial.
        denominators = (sp.fraction(sp.together(entry))[1] for entry in in_fractions(gain))
        defined = sp.And(*(sp.Ne(denominator, 0) for denominator in denominators))
        compare(sp.true, self.parameters, exactly(defined, given), message)
        inside, outside = (
            Case(sp.And(given, case.condition), case.unknowns, case.every)
            for case, _ in spectrum.stability.cases
        )

        def stable(values):
            if self._admits(values):
                return not undefined(values) and spectrum.is_stable(values)

        reference = ReferenceCondition((inside,), (outside,), stable)
        return f"{right}: {compare(sp.true, self.parameters, reference, message)}"

    def _slack(self, loop, gain):
        """Return how far the rounding of the entries of a gain may shift the spectrum."""

        def largest(entries):
            return _largest_real_part(loop(sp.Matrix(*gain.shape, entries)))

        entries = list(in_fractions(gain))
        perturbed_gains = (
            [*entries[:k], entries[k] * (1 + side * sp.Rational(1, 200)), *entries[k + 1 :]]
            for k in range(len(entries))
            for side in (-1, 1)
        )
        return sp.Rational(
            sum(abs(largest(perturbed) - largest(entries)) for perturbed in perturbed_gains)
        ).limit_denominator(10**6)


def in_fractions(gain):
    return gain.applyfunc(
        lambda entry: sp.nsimplify(entry, rational=True) if entry.has(sp.Float) else entry
    )


def _largest_real_part(matrix):
    """Return the largest real part of the eigenvalues.

    With rational entries, multiple eigenvalues lose no digits.
    """
    polynomial = matrix.charpoly()
    roots = np.roots([float(c) for c in polynomial.sqf_part().all_coeffs()])
    largest = max(roots.real)
    return largest if abs(largest) > EXACT else 0.0


def _judge(gain, loop, matrix_name, requirement, pair):
    if gain is None:
        if not requirement.impossible(pair):
            raise Wrong(
                "some gain makes the spectrum as required: the modes that no gain changes allow it"
            )
        return "there is no such gain: a mode that no gain changes does not allow it"
    # That no gain exists would be the answer, so the message does not say it.
    message = requirement.judge(loop, gain, matrix_name)
    if requirement.polynomial is not None:
        generic = sp.true if pair is None or not pair.parameters else pair.generic_condition
        judge_everywhere(
            gain,
            requirement.parameters,
            lambda: sp.And(conjunction(requirement.given), generic),
            "an entry of your gain has no value",
        )
    if pair is not None and requirement.impossible(pair):
        raise Wrong(f"with your gain the spectrum of {matrix_name} is not as required")
    return message


def _observer_shape(data):
    extended = augmented(data["system"])
    return extended.A.rows, extended.H.rows


def _feedback_shape(data):
    return data["system"].B.cols, data["system"].H.rows or data["system"].A.rows


def loop_of(system):
    """Return (closed loop as a function of the gain, its name in messages).

    The loop is a matrix, or for a `Scalar` its characteristic polynomial.
    """
    if isinstance(system, Scalar):
        return lambda k: sp.expand(
            system.left - k * system.right * system.measured
        ), "the equation of the loop"
    A, B, H = system.A, system.B, system.H
    if not B:
        return lambda L: A - L * H, "the matrix A - LH of the errors"
    if not H:
        return lambda K: A + B * K, "the matrix A + BK of the loop"
    return lambda K: A + B * K * H, "the matrix A + BKH of the loop"


@judged(Gain("parameters", shape=_observer_shape), system="Linear with outputs")
def observer_gain(
    gain, system, parameters=(), given=sp.true, degree=0, polynomial=None, symbol=None
):
    """Check a gain L of an observer, or an empty list if there is none.

    The spectrum of A - LH has to be as required. Of a system `WithError` the gain belongs to
    the state with w below it.

    Required is the `degree` of stability for all values of the parameters as `given`, or the
    `polynomial` in `symbol`, whose coefficients are parameters.

    Can decide when the entries are numbers, or rational functions of the parameters. Any gain with
    the spectrum that is required is right, and so is an empty list where there is none.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> cart = Linear(A=[[0, 1], [0, 0]], H=[[1, 0]])
    >>> checks.observer_gain([3, 2], cart).status, checks.observer_gain([-3, 2], cart).status
    ('right', 'wrong')
    >>> s = sp.Symbol("s")
    >>> checks.observer_gain([3, 2], cart, polynomial=(s + 1)*(s + 2), symbol=s).status
    'right'
    """
    requirement = Requirement(tuple(parameters), given, degree, polynomial, symbol)
    return _judge(gain, *_error_loop(system, parameters, requirement))


@judged(Gain("parameters", shape=_feedback_shape), system="Linear with controls")
def feedback_gain(
    gain, system, parameters=(), given=sp.true, degree=0, polynomial=None, symbol=None
):
    """Check a gain K of the feedback u = Kx, or an empty list if there is none.

    Of a system with an output it is that of the static feedback u = Kz.

    The requirement is that of `observer_gain`, on A + BK or A + BKH. That no static feedback
    will do is decided as a condition on the entries of K.

    Can decide when the entries are numbers, or rational functions of the parameters. Any gain with
    the spectrum that is required is right, and so is an empty list where there is none.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> cart = Linear(A=[[0, 1], [0, 0]], B=[[0], [1]])
    >>> checks.feedback_gain([[-2, -3]], cart).status, checks.feedback_gain([[2, 3]], cart).status
    ('right', 'wrong')
    >>> checks.feedback_gain([[-2, -3]], cart, degree=2).status
    'wrong'
    """
    requirement = Requirement(tuple(parameters), given, degree, polynomial, symbol)
    if not system.H:
        return _judge(gain, *_state_loop(system, parameters, requirement))
    if gain is None:
        return _judge_none_static(system, requirement)
    return _judge(gain, *loop_of(system), requirement, None)


def _judge_none_static(system, requirement):
    """Accept "no gain" if at some values of the parameters no static gain stabilises."""
    shape = system.B.cols, system.H.rows
    entries = sp.symbols(f"k1:{shape[0] * shape[1] + 1}", real=True, cls=sp.Dummy)
    closed, last_error = loop_of(system)[0](sp.Matrix(*shape, entries)), None
    for values in requirement.samples():
        loop = closed.subs(values)
        try:
            compare(
                sp.false,
                entries,
                Spectrum(loop, entries, requirement.degree).stability,
                lambda *_, where=where_text(values): f"there is a gain that does it{where}",
            )
        except Wrong as error:
            last_error = error
        else:
            return "there is no such gain, whatever its entries"
    raise last_error


@judged(
    Gains("parameters", shapes=lambda data: [data["system"].B.T.shape, _observer_shape(data)]),
    system="Linear or WithError with controls and outputs",
)
def observer_feedback_gains(gains, system, parameters=(), given=sp.true, degree=0):
    """Check the gains [K, L] of a feedback u = K e by the estimate e of an observer.

    An empty list says that there are none.

    Of a system `WithError` L belongs to the state with w below it. Required is the `degree` of stability for
    all values of the parameters, of the loop and of the errors.

    Can decide when the entries are numbers, or rational functions of the parameters.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> cart = Linear(A=[[0, 1], [0, 0]], B=[[0], [1]], H=[[1, 0]])
    >>> checks.observer_feedback_gains([[[-2, -3]], [3, 2]], cart).status
    'right'
    >>> checks.observer_feedback_gains([[[-2, -3]], [-3, 2]], cart).status
    'wrong'
    """
    requirement = Requirement(tuple(parameters), given, degree)
    parts = [part(system, parameters, requirement) for part in (_state_loop, _error_loop)]
    if gains is None:
        if not any(requirement.impossible(pair) for *_, pair in parts):
            raise Wrong("there are such gains: the modes that no gain changes allow it")
        return "there are no such gains: a mode that no gain changes does not allow them"
    _, message = [_judge(gain, *part) for gain, part in zip(gains, parts)]
    return f"{message}, and so do those of A + BK"


def _state_loop(system, parameters, requirement):
    """Return the arguments of `_judge` for feedback of the whole state."""
    system = Linear(system.A, system.B)
    pair = controlled_pair(system, _system_parameters(parameters, system.A, system.B))
    return *loop_of(system), requirement, pair


def _error_loop(system, parameters, requirement):
    """Return the arguments of `_judge` for the errors of an observer."""
    extended = augmented(system)
    system = Linear(extended.A, H=extended.H)
    pair = observed_pair(system, _system_parameters(parameters, system.A, system.H))
    return *loop_of(system), requirement, pair


def _system_parameters(parameters, *matrices):
    """Return the parameters in the matrices, without those in the requirement alone."""
    return tuple(p for p in parameters if any(p in matrix.free_symbols for matrix in matrices))

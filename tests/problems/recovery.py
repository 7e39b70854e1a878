"""Corrections of wrong answers from the numbers in messages, as a student could compute them.

One factor or coefficient of a right answer is made wrong, in two ways one after the other. From the
numbers in both messages follow candidates for it: a quotient of numbers, a difference, the value
with which the answer has a number that a message states, the zero of what changes linearly from one
message to the next. None may be right, but where the student could have evaluated the same numbers
from the data alone (`EVALUABLE`).

A candidate is judged only if it is near the right coefficient, since no other can be right.
"""

import functools
import itertools
import math
import re

import sympy as sp
from roundings import awkward_numbers, with_numbers
from sympy.logic.boolalg import Boolean

from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import encode

#: A coefficient is multiplied by one and then by the other: what finds it from both is no chance.
FACTORS = (sp.Rational(15, 11), sp.Rational(9, 14))
#: A candidate nearer to the right coefficient than this share of it is judged.
NEAR = 0.01
#: Terms, and numbers, of an expression that are made wrong.
MOST = 8
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?(?:/\d+)?"
#: A number that is no part of a name, as in `x1`.
NUMBERS = re.compile(rf"(?<![\w.])(?:{NUMBER})(?!\w)")
#: The value of a symbol at which the answer is compared.
VALUES = re.compile(rf"(\w+) = ({NUMBER})(?!\w)")
#: Positions of entries and the like, which are no values.
INDICES = re.compile(
    r"\(\d+, \d+\)|\^\d+"
    r"|(?:vector|component|coordinate|combination|part|entry|equation|side|row|column|order) \d+"
)
#: Checks whose messages have a number of the student's own that shows how far an answer is off, and
#: how the student could compute it from the data and this answer.
EVALUABLE = {
    "canonical_coordinate": "the derivatives of the coordinate along the system",
    "canonical_part_coordinates": "the rows times A, in the coordinates of the answer",
    "conserved_quadratic_form": "the derivative along the motions",
    "cost_matrix": "the right-hand side of the Riccati equation",
    "covariance_at_time": "the covariance at the start, which is given",
    "decomposed_system": "the characteristic polynomial of the answer",
    "decomposition": "the system in the coordinates of the answer",
    "equation_gains": "the equation along the motions of the form",
    "equilibria": "the right-hand sides at the point",
    "equilibrium_gains": "the right-hand sides at the point",
    "equilibrium_linearisation": "the matrix of the answer",
    "equilibrium_values": "the right-hand sides at the value",
    "extremum_motion": "the motion at its ends, which are given",
    "first_integral": "the derivative along the motions",
    "least_squares": "the sum of squares at the estimate",
    "mechanical_equations": "the equations, solved for the accelerations",
    "observer_equations": "the derivative of the error",
    "observer_gain": "the characteristic polynomial of the errors",
    "optimal_law": "the law at the state",
    "optimal_motion": "the motion at the start, which is given",
    "parallel_decomposition": "the system in the coordinates of the answer",
    "parallel_system": "the characteristic polynomial of the answer",
    "research.filter_gain": "the equation with the motion inserted",
    "research.invariant_weights": "the given functions, weighted",
    "sequential_decomposition": "the system in the coordinates of the answer",
    "similarity_matrix": "both systems with the matrix inserted",
    "spectra": "the right-hand sides at the point, the characteristic polynomial",
    "state_space_form": "the equation along the motions of the form",
    "uncorrelated": "the covariance at the angle",
    "undetectable_mode": "H v",
    "unobservable_states": "H A^k v",
    "unobservable_states_at": "H A^k v",
    "uncontrollable_combinations": "w A^k B",
    "uncontrollable_combinations_at": "w A^k B",
}
#: Checks whose messages state a number that the definition of what is asked has: a coefficient 1.
DEFINED = {"canonical_change", "canonical_coordinate", "chain_basis_matrix"}
#: What a number of one message is multiplied by to be tried in another answer: simple fractions, and
#: numbers of steps in which processes are computed.
MULTIPLES = sorted({sp.Rational(a, b) for a in range(1, 5) for b in range(1, 5)} | {100, 240, 480})
#: Numbers of answers that a number in messages on another answer equals by chance: (the answer, its
#: number, the other answer) by problem.
COINCIDENT = {
    # twice as much is near a sample value of alpha, which is drawn without regard to the problem
    "5.22": {("b_control", "1/pi", "general_control"), ("b_energy", "1/pi", "general_control")},
}
#: Numbers that say nothing of where they come from.
SIMPLE = range(10)
TRUE, OWN = "a true value", "a residual"


def recovered(problem, name):
    """Return what a student finds of an answer: [what was wrong, from which kind of number, message].

    Parameters
    ----------
    problem : JudgedProblem
        The problem.
    name : str
        The name of the answer.

    Notes
    -----
    The kind is `TRUE` if the number is the same in the messages on different answers, so that it
    does not come from them, else `OWN`.
    """
    found, symbols = [], set(_symbols(list(problem.data.values())))
    for what, right, put, tries in _tries(problem, name):
        wrong, messages = zip(
            *((float(q), _without_point(verdict.message, symbols)) for q, verdict in tries)
        )
        number = right not in (1, -1)
        known = set.intersection(*(_stated(text) for text, _ in messages))

        def finds(candidates, right=right, put=put):
            return any(
                abs(q - float(right)) <= NEAR * abs(float(right))
                and problem.judge_one(name, decode(encode(put(sp.Float(f"{q:.4g}"))))).status
                == "right"
                for q in candidates
            )

        def from_both(numbers, put=put, wrong=wrong, messages=messages, number=number):
            return all(
                finds(_candidates(q, put, numbers(text), point, number))
                for q, (text, point) in zip(wrong, messages)
            )

        if from_both(lambda text, known=known: known):
            found.append([what, TRUE, tries[0][1].message])
        elif from_both(_stated) or finds(_zeros(wrong, [text for text, _ in messages])):
            found.append([what, OWN, tries[0][1].message])
    return found


def borrowed(problem):
    """Return what messages on one answer tell of another: [answer, its number, whose message, it].

    A number that is in the messages on two different wrong answers does not come from them. It is
    tried, alone and times fractions and numbers of steps, in the place of each awkward number of the
    other answers, to the digits that the message gives.
    """
    found = []
    for name in problem.reference:
        stated = {
            text: tries[0][1].message
            for _, right, put, tries in _tries(problem, name)
            for text in set.intersection(*(_texts(verdict.message) for _, verdict in tries))
            if not _is_own(text, put(right * FACTORS[0]))
        }
        told = [(abs(float(_number(text))), _digits(text), stated[text]) for text in stated]
        for other, value in problem.reference.items():
            numbers = [n for n in dict.fromkeys(awkward_numbers(value)) if not _simple(n)]
            sizes = [(n, abs(float(n))) for n in numbers if other != name]
            for (number, size), (own, digits, message), factor in itertools.product(
                sizes, told, MULTIPLES
            ):
                candidate = float(factor) * own
                unit = 10.0 ** (math.floor(math.log10(own)) - digits + 1) if own else 0.0
                if abs(candidate - size) > min(float(factor) * unit, NEAR * size):
                    continue
                guess = sp.sign(number) * sp.Float(f"{float(candidate):.4g}")
                answer = decode(encode(with_numbers(value, {number: guess})))
                if problem.judge_one(other, answer).status == "right":
                    found.append([other, str(number), name, message])
    return found


def _is_own(text, answer):
    """Return whether a number of a message is one of the answer that it is on."""
    own = [*map(float, awkward_numbers(answer)), *_numbers_at(answer, {})]
    return any(_close(_number(text), abs(number)) for number in own)


def _simple(number):
    return number.is_Rational and number.q < len(SIMPLE)


def _texts(message):
    """Return the numbers in a message that say something of where they come from, as texts."""
    texts = (part.lstrip("+-") for part in NUMBERS.findall(INDICES.sub("", message)))
    return {text for text in texts if _number(text) not in SIMPLE}


def _digits(text):
    """Return the number of significant digits of a number as it is written; a fraction is exact."""
    return 9 if "/" in text else len(text.partition("e")[0].replace(".", "").strip("0") or "0")


@functools.cache
def _tries(problem, name):
    """Return (what is wrong, right number, function that puts another, two verdicts) of an answer."""
    tries = [
        (what, right, put, [(right * f, problem.judge_one(name, put(right * f))) for f in FACTORS])
        for what, right, put in coefficients(problem.reference[name])
    ]
    return [row for row in tries if all(verdict.status == "wrong" for _, verdict in row[3])]


def coefficients(value):
    """Yield (description, right number, function of a number that returns the answer with it)."""
    if isinstance(value, dict):
        for key, part in value.items():
            for what, right, put in coefficients(part):
                yield f"{what} of {key}", right, lambda q, key=key, put=put: value | {key: put(q)}
    elif isinstance(value, sp.MatrixBase):
        yield "factor", sp.S.One, lambda q: value * q
        yield from _of_parts(list(value), lambda parts: type(value)(*value.shape, parts))
    elif isinstance(value, (list, tuple)):
        yield from _of_parts(list(value), type(value))
    elif not isinstance(value, (bool, str)):
        yield from _of_expression(sp.sympify(value))


def _of_parts(parts, build):
    for k, part in enumerate(parts):
        for what, right, put in coefficients(part):
            yield (
                f"{what} of entry {k + 1}",
                right,
                lambda q, k=k, put=put: build([*parts[:k], put(q), *parts[k + 1 :]]),
            )


def _of_expression(value):
    if isinstance(value, sp.Expr) and not value.is_zero:
        yield "factor", sp.S.One, lambda q: value * q
        for term in value.args[:MOST] if isinstance(value, sp.Add) else ():
            yield f"factor of {term}", sp.S.One, lambda q, term=term: value + (q - 1) * term
    if isinstance(value, sp.Eq) and 0 not in value.args:
        yield "factor of a side", sp.S.One, lambda q: sp.Eq(q * value.lhs, value.rhs)
    if isinstance(value, (sp.Expr, Boolean)) and value.free_symbols:
        for number in sorted(value.atoms(sp.Rational, sp.Float) - {0, 1, -1}, key=str)[:MOST]:
            if _with(value, number, 2 * number) != value:
                yield (
                    f"number {number}",
                    number,
                    lambda q, number=number: _with(value, number, q),
                )


def _with(value, number, q):
    """Return an expression with one of its numbers replaced, but not in exponents."""
    if value in (number, -number):
        return q if value == number else -q
    if isinstance(value, sp.Pow) and value.exp.is_number:
        return sp.Pow(_with(value.base, number, q), value.exp)
    return value.func(*(_with(part, number, q) for part in value.args)) if value.args else value


def _without_point(message, symbols):
    """Return (the message without positions and values of symbols, these values by name)."""
    point = {name: number for name, number in VALUES.findall(message) if name in symbols}
    text = VALUES.sub(lambda found: "" if found[1] in symbols else found[0], message)
    return INDICES.sub("", text), point


def _symbols(part):
    """Yield the names of the symbols in data."""
    if isinstance(part, sp.Symbol):
        yield part.name
    elif isinstance(part, (list, tuple)):
        for entry in part:
            yield from _symbols(entry)


def _stated(text):
    """Return the sizes of the numbers in a text but zero."""
    return {abs(_number(part)) for part in NUMBERS.findall(text)} - {0.0}


def _candidates(wrong, put, numbers, point, number):
    """Yield coefficients that follow from `numbers` of the message on an answer with a wrong one.

    `number` is whether the coefficient is a number of the answer, and no factor of a term.
    """
    own, others = _own_numbers(put, wrong, point)
    stated = [n for n in sorted(numbers) if not any(_close(n, abs(other)) for other in others)]
    if number:
        yield from (sign * n for n in stated if n not in SIMPLE for sign in (1, -1))
    for first, second in [
        *itertools.permutations(stated, 2),
        *((1.0, n) for n in stated if not any(_close(n, abs(value)) for value, _ in own)),
        *((n, abs(value)) for n in stated for value, _ in own if value),
    ]:
        yield from (wrong * first / second, wrong * (first / second) ** 0.5)
    for value, slope in own:
        for n in stated:
            yield from (wrong + (sign * n - value) / slope for sign in (1, -1))
            yield from (wrong + sign * n / slope for sign in (1, -1))


def _own_numbers(put, wrong, point):
    """Return the numbers of an answer at a point: (value, its derivative by the coefficient) of
    those that depend on it, and the others."""
    step = 1e-4 * wrong
    entries = list(zip(*(_numbers_at(put(q), point) for q in (wrong, wrong + step))))
    return (
        [(here, (there - here) / step) for here, there in entries if there != here],
        [here for here, there in entries if there == here],
    )


def _numbers_at(value, point):
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, (list, tuple, sp.MatrixBase)):
        return [number for part in value for number in _numbers_at(part, point)]
    if isinstance(value, (str, bool)) or not isinstance(sp.sympify(value), sp.Expr):
        return []
    value = sp.sympify(value)
    numbers = {s: _number(point[s.name]) for s in value.free_symbols if s.name in point}
    # `complex` first evaluates all of an expression that has symbols, and then raises TypeError
    if len(numbers) < len(value.free_symbols):
        return []
    try:
        number = complex(value.subs(numbers))
    except TypeError:  # infinite or undefined there, or a condition compares complex numbers
        return []
    return [number.real, number.imag]


def _zeros(wrong, texts):
    """Yield where a number that two messages of the same words have at one place, or a difference
    of two such numbers, is zero if it is linear in the coefficient."""
    if len({NUMBERS.sub("#", text) for text in texts}) > 1:
        return
    here, there = ([_number(part) for part in NUMBERS.findall(text)] for text in texts)
    pairs = list(zip(here, there))
    changing = [pair for pair in pairs if pair[0] != pair[1]]
    differences = [
        (a - c, b - d) for (a, b), (c, d) in itertools.product(changing, pairs) if (a, b) != (c, d)
    ]
    for first, second in [*changing, *differences]:
        if first != second:
            yield wrong[0] - first * (wrong[1] - wrong[0]) / (second - first)


def _number(text):
    above, _, below = text.partition("/")
    return float(above) / float(below or 1)


def _close(first, second):
    return abs(first - second) <= 5e-4 * abs(second)

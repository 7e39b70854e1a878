"""Optima proved in ball arithmetic, against closed forms; reasons where nothing is proved."""

import sys
from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from trajlib.pontryagin import Problem
from trajlib.pontryagin.verification.enclosed_extremal import EnclosedExtremal
from trajlib.pontryagin.verification.proof import prove
from trajlib.typesetting import typeset

pytest.importorskip("flint", reason="proofs need the extra `proof`")

R = sp.Rational
x, x1, x2, x3, u, v = sp.symbols("x x1 x2 x3 u v")
ONE, FREE = {u: (-1, 1)}, {u: None}
CARRIAGE, OSCILLATOR = {x1: x2, x2: u}, {x1: x2, x2: -x1 + u}
TRIPLE = Problem({x1: x2, x2: x3, x3: u}, ONE, {x1: 1, x2: 0, x3: 0}, [x1, x2, x3])
# Of the root of 8 s^3 = 4: a third of the way up, s, 2 s, s.
EDGE = sp.cbrt(4) / 2
# Of the interior arc, from 10 (1/8 - h^2/6) = 1.
HALF = sp.sqrt(15) / 10


def carriage(a=1, b=0):
    return Problem(CARRIAGE, ONE, {x1: a, x2: b}, [x1, x2])


PROVED = {
    "double integrator": (carriage(), 2, 2, [1]),
    # A circle of radius 2 around -1, then one of radius 1 around 1.
    "oscillator": (
        Problem(OSCILLATOR, ONE, {x1: 1, x2: 0}, [x1, x2]),
        *[sp.acos(R(7, 8)) + sp.acos(R(1, 4))] * 2,
        [sp.acos(R(7, 8))],
    ),
    "triple integrator": (TRIPLE, 4 * EDGE, 4 * EDGE, [EDGE, 3 * EDGE]),
    "two controls": (
        Problem(
            {x1: u, x2: v},
            {u: (-1, 1), v: (-2, 1)},
            {x1: 3, x2: 1},
            [x1 - 1],
            running=x1 + x2**2 + v**2,
            duration=4,
        ),
        5 + sp.tanh(4),
        4,
        [3],
    ),
    "energy": (
        Problem(CARRIAGE, FREE, {x1: 1, x2: 0}, [x1, x2], running=u**2, duration=1),
        12,
        1,
        [],
    ),
    "quadratic": (
        Problem({x: u}, FREE, {x: 1}, running=x**2 + u**2, duration=3),
        sp.tanh(3),
        3,
        [],
    ),
    "quadratic, a final cost that is to be large": (
        Problem({x: u}, FREE, {x: 0}, running=-(u**2), final=x, duration=1, maximise=True),
        R(1, 4),
        1,
        [],
    ),
    "a duration of pi": (
        Problem(OSCILLATOR, FREE, {x1: 0, x2: 0}, [x1 - 1], running=u**2, duration=sp.pi / 2),
        4 / sp.pi,
        sp.pi / 2,
        [],
    ),
    "a singular arc": (
        Problem({x: u}, ONE, {x: 1}, [x - R(1, 2)], running=x**2, duration=2),
        R(3, 8),
        2,
        [1, R(3, 2)],
    ),
    "a singular arc to the end": (
        Problem({x: u}, ONE, {x: 1}, running=x**2 / 2, duration=2),
        R(1, 6),
        2,
        [1],
    ),
    "a singular arc from the start": (
        Problem({x: u}, ONE, {x: 0}, [x - R(1, 2)], running=x**2, duration=2),
        R(1, 24),
        2,
        [R(3, 2)],
    ),
    # u is odd about t = 1/2, with the slope 5/h there.
    "an interior arc between bounds": (
        Problem(CARRIAGE, {u: (-5, 5)}, {x1: 1, x2: 0}, [x1, x2], running=u**2, duration=1),
        25 - 100 * HALF / 3,
        1,
        [R(1, 2) - HALF, R(1, 2) + HALF],
    ),
    "a free start": (
        Problem({x: u}, FREE, {x: None}, [x - 1], running=x**2 + u**2, duration=1),
        sp.tanh(1),
        1,
        [],
    ),
    "far start": (carriage(1, -30), *[30 + 2 * sp.sqrt(449)] * 2, [30 + sp.sqrt(449)]),
}


@pytest.mark.parametrize("name", PROVED)
def test_closed_forms_lie_in_the_enclosures(name):
    problem, cost, duration, switchings = PROVED[name]
    extremal = problem.solve()
    proof = extremal.certificate(proved=True)
    assert proof.holds and "proved optimal" in str(proof)
    assert cost in proof.cost and duration in proof.duration
    if switchings is not None:
        assert len(switchings) == len(proof.switching_times)
        assert all(value in enclosed for value, enclosed in zip(switchings, proof.switching_times))
    numbers = [proof.cost, proof.duration, *proof.switching_times, *proof.costate]
    assert all(one.high - one.low < Fraction(1, 10**25) * max(1, abs(one.high)) for one in numbers)
    assert float(proof.cost) == pytest.approx(extremal.cost, rel=1e-12)
    assert [float(one) for one in proof.costate] == pytest.approx(
        list(extremal.costate(0)), abs=1e-9
    )
    assert typeset(proof.cost.text) in proof._repr_markdown_()


def test_signs_are_proved_up_to_the_ends_of_an_arc():
    """On the first arc of the carriage, which lasts 1, x2 = -t."""
    extremal = carriage().solve()
    enclosed = EnclosedExtremal(carriage(), extremal.arcs, extremal.state(0), extremal.costate(0))
    lengths, nodes = enclosed._enclosed()

    def positive(slope, constant):
        row = sp.Matrix([[0, slope, 0, 0, constant]])
        return enclosed._positive(row, 0, nodes[0], nodes[1], lengths[0])

    assert positive(1, R(21, 20)) and positive(-1, R(1, 20))
    assert not positive(1, R(19, 20)) and not positive(-1, -R(1, 20))


rationals = st.fractions(-10, 10, max_denominator=50)


@settings(max_examples=40, deadline=None)
@given(rationals, rationals)
def test_the_least_time_of_the_carriage_from_anywhere(a, b):
    """From above the switching curve: u = -1 for s = b + r, then u = 1 for r = sqrt(a + b^2/2)."""
    a, b = (R(e.numerator, e.denominator) for e in (a, b))
    if a + b * abs(b) / 2 < 0:
        a, b = -a, -b
    assume(a + b * abs(b) / 2 > R(1, 1000))
    r = sp.sqrt(a + b**2 / 2)
    s, T = b + r, b + 2 * r
    proof = prove(
        carriage(a, b), [("u-", 0, float(s)), ("u+", float(s), float(T))], [a, b], [-1 / r, -s / r]
    )
    assert proof.holds and T in proof.duration and s in proof.switching_times[0]
    assert -1 / r in proof.costate[0] and -s / r in proof.costate[1]
    # The enclosures hold nothing else.
    assert T + R(1, 10**20) not in proof.duration


def changed(arcs=None, costate=None, multiplier=1.0):
    extremal = TRIPLE.solve()
    return prove(
        TRIPLE,
        extremal.arcs if arcs is None else arcs,
        extremal.state(0),
        extremal.costate(0) if costate is None else costate(extremal.costate(0)),
        multiplier,
    )


def test_wrong_extremals_are_not_proved():
    assert changed().holds
    wrong = {
        "no exact extremal": [
            changed(costate=lambda p: p + 1e-5),
            changed(costate=lambda p: -p),
            changed([("u+", 0, 0.8), ("u-", 0.8, 2.4), ("u+", 2.4, 3.2)]),
        ],
        "do not determine": [
            changed([("u-", 0, 0.8), ("u+", 0.8, 3.2)]),
            changed([("u-", 0, 3.2)]),
        ],
        "5 equations for 6 unknowns": [
            changed([("u-", 0, 0.8), ("u+", 0.8, 1.6), ("u+", 1.6, 3.2)])
        ],
        "abnormal": [changed(multiplier=0.0)],
    }
    for reason, proofs in wrong.items():
        for proof in proofs:
            assert not proof.holds and reason in proof.reason and proof.cost is None
            assert str(proof).startswith("not proved: ") and proof._repr_markdown_().startswith(
                "Not proved: "
            )


def test_a_boundary_value_problem_alone_is_no_proof():
    """With the cost reversed the arcs u+, u- satisfy all but the maximum condition."""
    late = Problem({x1: x2, x2: u}, ONE, {x1: 0, x2: 0}, [x2], running=x1, duration=1)
    right = [("u-", 0, 0.5), ("u+", 0.5, 1)]
    assert prove(late, right, [0, 0], [-1, -0.375]).holds
    proof = prove(late, [("u+", 0, 0.5), ("u-", 0.5, 1)], [0, 0], [-1, -0.375])
    assert (
        not proof.holds
        and "switching function was not proved to have one sign on arc 1" in proof.reason
    )


@pytest.mark.parametrize(
    "problem, reason",
    [
        # A start on the switching curve: one arc, many costates.
        (carriage(-R(1, 2), 1), "do not determine the costate"),
        (Problem({x1: x2, x2: -sp.sin(x1) + u}, ONE, {x1: 1, x2: 0}, [x1, x2]), "no theorem"),
        # Where the oscillator cannot stay, the second passage is an extremal that is not optimal.
        (Problem(OSCILLATOR, ONE, {x1: 0, x2: 10}, [x1 - 10, x2]), "no theorem"),
        (Problem({x: u}, FREE, {x: 0}, {x: 1}, running=u**2 - x**2, duration=1), "no theorem"),
    ],
)
def test_reason_without_a_proof(problem, reason):
    proof = problem.solve().certificate(proved=True)
    assert not proof.holds and reason in proof.reason and proof.switching_times == ()


def test_missing_ball_arithmetic_names_its_package(monkeypatch):
    monkeypatch.setitem(sys.modules, "flint", None)
    with pytest.raises(ImportError, match=r"pip install 'trajlib\[proof\]'"):
        prove(carriage(), [("u-", 0, 1), ("u+", 1, 2)], [1, 0], [-1, -1])

"""Instants in messages lie on no grid of an unknown duration, and words stand for all others."""

import numpy as np
import pytest
import sympy as sp

from trajlib.pontryagin import Problem
from workbook import checks
from workbook.checks.tools.wording import INSTANTS, process_part_text, round_instants

x1, x2, u = sp.symbols("x1 x2 u")
t = sp.Symbol("t", positive=True)


@pytest.mark.parametrize("duration", [0.0371, 0.5, 1.0, np.pi, 4.0, 9.99, 10.0, 1234.5])
def test_instants_that_may_be_named(duration):
    instants = round_instants(duration)
    step = instants[0]
    assert float(f"{step:.1g}") == pytest.approx(step) and f"{step:.0e}"[0] in "125"
    assert INSTANTS - 1 <= len(instants) <= 2.5 * INSTANTS + 1
    assert instants[-1] < duration <= instants[-1] + step * (1 + 1e-9)
    # another duration has the same ones
    assert np.allclose(round_instants(duration * 1.001)[: INSTANTS - 2], instants[: INSTANTS - 2])


@pytest.mark.parametrize(
    "share, words",
    [
        (0, "at the beginning"),
        (1 / 480, "at the beginning"),
        (0.2, "early in the process"),
        (0.5, "in the middle of the process"),
        (0.8, "late in the process"),
        (1, "at the end"),
    ],
)
def test_words_for_a_part_of_a_process(share, words):
    assert process_part_text(share * 7.3, 7.3) == words


#: The least time is 2*sqrt(3), which no message may show.
REST = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 3, x2: 0}, [x1, x2])
ANSWERS = [
    (checks.optimal_control, 2, "your control is 2 at t = 0.2, outside its bounds"),
    (checks.optimal_control, [[-1, 1], [3, 4]], "your control is 3 at t = 1.2"),
    (
        checks.optimal_control,
        sp.Piecewise((3, t < sp.Rational(1, 100)), (0, True)),
        "your control is outside its bounds at the beginning",
    ),
    (
        checks.optimal_control,
        sp.log(1 - t),
        "your control is no real number, or not defined, early",
    ),
    (checks.optimal_motion, [3 - t**2, -2 * t], "at t = 0.2 your motion has x2' = -2, which"),
    (checks.optimal_motion, [3, t], "at t = 0.2 your motion has x1' = 0, which"),
    (checks.optimal_costate, [t, 1], "at the beginning the adjoint equation for x1 does not hold"),
]


@pytest.mark.parametrize("check, answer, begins", ANSWERS)
def test_messages_name_round_instants_or_none(check, answer, begins):
    verdict = check(answer, REST, t)
    assert verdict.status == "wrong" and verdict.message.startswith(begins), verdict.message

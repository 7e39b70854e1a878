"""What `explain` says of a problem is what `solve` does with it."""

import subprocess
import sys
from itertools import groupby

import optimal_control_records
import pytest
import sympy as sp
from classical_control_records import CLASSICAL
from test_pontryagin_book_problems import BOOK_PROBLEMS

from trajlib.pontryagin import Problem, WrongStructure
from trajlib.pontryagin.indirect.steps import BEFORE_SEARCH
from trajlib.pontryagin.problem.steps import Refusal

R = sp.Rational
x, y, v, u = sp.symbols("x y v u")
CART, ONE = {x: v, v: u}, {u: (-1, 1)}
REST = {x: 0, v: 0}
# The reformulations and methods that apply, where these are others than the search.
OTHERS = {
    "Jacobson-Lele": ["linear-quadratic boundary value problem"],
    "Rayleigh with a mixed constraint": ["bounds that depend on the state"],
    "bound that depends on time": ["bounds that depend on the state"],
    "state-dependent bound": ["bounds that depend on the state"],
    "disc, least energy": ["linear-quadratic boundary value problem", "natural units"],
    "5.25 with |u|": ["|u| in the running cost"],
    "5.28 a": ["linear-quadratic boundary value problem", "natural units"],
} | dict.fromkeys(
    (
        *(f"Bryson-Denham {limit}" for limit in ("1/4", "1/5", "1/6", "1/9")),
        *("speed limit, least energy", "boundary to the end", "two terminal inequalities"),
        *("terminal disc", "5.20", "5.21", "5.27 a", "5.27 c", "5.28 b", "5.28 c"),
        "quadratic, 20 units",
    ),
    ["linear-quadratic boundary value problem"],
)
SEARCH = "search and multiple shooting"


def problem_of(name):
    if name in BOOK_PROBLEMS:
        return BOOK_PROBLEMS[name].problem
    return optimal_control_records.record(name).problem


def names(explanation, *kinds):
    return [step.name for step in explanation.applied if step.kind in kinds]


HARD = [name for name in optimal_control_records.NAMES if name not in CLASSICAL]


@pytest.mark.parametrize("name", [*HARD, *BOOK_PROBLEMS])
def test_steps_of_the_records(name):
    problem = problem_of(name)
    explanation = problem.explain()
    shown = names(explanation, "reformulation", "method")
    assert shown == [*OTHERS.get(name, []), SEARCH]
    applied = {step.name for step in explanation.applied}
    assert ("discrete solutions that pass beyond a path constraint" in applied) == bool(
        problem.path
    )
    assert ("duration that is not determined" in applied) == problem.free_time
    # The text has every step once, under its stage and in the order in which `solve` takes them.
    placed = [(step.stage, step.name) for step in explanation.steps]
    assert [stage for stage, _ in groupby(stage for stage, _ in placed)] == STAGES
    assert len(set(placed)) == len(placed)
    text, page = " ".join(repr(explanation).split()), explanation._repr_html_()
    assert all(f"{'+' if s.applies else '-'} {s.name}" in text for s in explanation.steps)
    assert page.count("<li>") == page.count("</li>") == len(explanation.steps)


#: In the order in which they are taken.
STAGES = [
    "infinite horizon",
    "reformulations of the statement",
    "refusals before any search",
    "methods without a search",
    "units",
    "search, where no method above gives the extremal",
    "refusals where no discrete solution is found",
    "refusals of discrete solutions",
    "refusals of lists of arcs",
    "refusals where no arcs lead to an extremal",
]
SOLVED = {
    "least time": Problem(CART, ONE, {x: 1, v: 0}, REST),
    "units": Problem({x: v, v: 1000 * u}, ONE, {x: 10**6, v: 0}, REST),
    "|u|": Problem(CART, ONE, REST, {x: 1, v: 0}, running=sp.Abs(u), duration=3),
    "bound of the state": Problem({x: u}, {u: (-1, x / 4)}, {x: 1}, {x: 2}, running=1 + u**2),
    "quadratic": Problem(CART, {u: None}, REST, {x: 1, v: 0}, running=u**2, duration=1),
    "polynomial end": Problem({x: u}, {u: None}, {x: 1}, running=u**2, final=x**4, duration=1),
    "speed limit": Problem(CART, ONE, REST, {x: 3, v: 0}, path=[v <= 1]),
    "infinite horizon": Problem({x: u}, {u: None}, {x: 1}, running=x**2 + u**2, duration=sp.oo),
    "nonlinear": Problem({x: u * y, y: -u * x}, ONE, {x: 1, y: 0}, [x, y + 1]),
}


@pytest.mark.parametrize("name", SOLVED)
def test_solve_takes_the_steps_that_are_shown(name, monkeypatch):
    problem, tried, check = SOLVED[name], [], Refusal.check

    def noted(refusal, numeric, *found):
        # A polynomial terminal cost is solved by problems with one equation more.
        if len(numeric.problem.terminal) == len(problem.terminal):
            tried.append((refusal, refusal.applies(numeric.problem)))
        return check(refusal, numeric, *found)

    monkeypatch.setattr(Refusal, "check", noted)
    problem.solve()
    explanation = problem.explain()
    shown = {(step.name, step.kind): step.applies for step in explanation.steps}
    assert all(shown[refusal.name, refusal.error.__name__] == applied for refusal, applied in tried)
    before = [(step.name, step.applies) for step in explanation.steps if "before" in step.stage]
    assert before == [(refusal.name, applied) for refusal, applied in tried[: len(before)]]
    assert len(before) == (0 if name == "infinite horizon" else len(BEFORE_SEARCH))


def test_reformulations_are_carried_out():
    rewarded = Problem(CART, ONE, REST, running=-sp.Abs(u), duration=3)
    *_, last = rewarded.explain().steps
    assert last.applies and "rewards the absolute value" in last.detail
    with pytest.raises(WrongStructure, match="rewards the absolute value"):
        rewarded.solve()
    (first, *_) = SOLVED["bound of the state"].explain().applied
    assert first.detail == "u = v_u*(x/4 + 1) - 1"
    units = next(s for s in SOLVED["units"].explain().applied if s.name == "natural units")
    assert "x in units of" in units.detail
    a = sp.Symbol("a")
    with pytest.raises(ValueError, match="explain: no value for a"):
        Problem(CART, {u: (-a, a)}, {x: 1, v: 0}, REST).explain()


LOADED = """
import sys
import sympy as sp
from trajlib.pontryagin import Problem
x, v, u = sp.symbols("x v u")
cart = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 1, v: 0}, {x: 0, v: 0})
cart.explain()
print("casadi" in sys.modules)
cart.solve()
print([n for n in ("planar_synthesis", "verification.proof", "verification.ball_arithmetic")
       if f"trajlib.pontryagin.{n}" in sys.modules], "trajlib.feedback" in sys.modules)
"""


def test_what_is_loaded():
    """`explain` needs no CasADi, and `solve` neither syntheses, proofs nor regulators."""
    run = subprocess.run(
        [sys.executable, "-c", LOADED], capture_output=True, text=True, check=True, timeout=120
    )
    assert run.stdout == "False\n[] False\n"

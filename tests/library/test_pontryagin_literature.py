"""Hard problems of the literature, compared with independent references."""

import json

import jsonschema
import optimal_control_records
import pytest
import sympy as sp
from classical_control_records import CLASSICAL
from optimal_control_records import NAMES, UNCONSTRAINED

from trajlib.pontryagin import Infeasible, NotUnique, Problem, problems

pytestmark = pytest.mark.slow
x, y, v, u, x1, x2 = sp.symbols("x y v u x1 x2")
ONE = {u: (-1, 1)}
PROVED = ["a switching function with a threefold zero at the end"]


@pytest.mark.parametrize("name", UNCONSTRAINED)
def test_record(name):
    record = optimal_control_records.record(name)
    extremal = record.problem.solve()
    assert extremal.cost == pytest.approx(record.cost, rel=record.tolerance)
    assert record.arcs is None or [kind for kind, _, _ in extremal.arcs] == record.arcs
    if record.times is not None:
        assert extremal.switching_times == pytest.approx(record.times, abs=1e-9)
    for _, value, tolerance in record.published:
        assert abs(extremal.cost - value) <= tolerance
    evidence = extremal.certificate()
    assert evidence.holds()
    if "singular" in (record.arcs or []):
        assert evidence.kelley < 0
    assert extremal.optimality.kind == ("proved" if name in PROVED else "locally minimal")


@pytest.mark.parametrize("name", CLASSICAL)
def test_classical_problem(name):
    record = optimal_control_records.record(name)
    extremal = problems(name).problem.solve()
    assert extremal.cost == pytest.approx(record.cost, rel=record.tolerance)
    assert [kind for kind, _, _ in extremal.arcs] == record.arcs
    if record.times is not None:
        assert extremal.switching_times == pytest.approx(record.times, abs=1e-9)
    for _, value, tolerance in record.published:
        assert abs(extremal.cost - value) <= tolerance
    assert extremal.certificate().holds()


@pytest.mark.parametrize("name", NAMES)
def test_data_file_states_the_same_problem(name):
    """The registry reads the problem that the records state, with the digits of the second route."""
    record, known = optimal_control_records.record(name), problems(name.upper())
    assert repr(known.problem) == repr(record.problem)
    assert known.cost == pytest.approx(record.cost, rel=10 * record.tolerance)
    assert record.source or not record.published
    entry = json.loads(optimal_control_records.FILE.read_text(encoding="utf-8"))["problems"][name]
    written = json.loads(json.dumps(optimal_control_records.data(name)))
    inexact = {"cost", "times"}  # the last digit depends on the machine
    assert {k: v for k, v in entry.items() if k not in inexact} == {
        k: v for k, v in written.items() if k not in inexact
    }


def test_registry():
    text = optimal_control_records.FILE.read_text(encoding="utf-8")
    schema = optimal_control_records.FILE.with_suffix(".schema.json").read_text(encoding="utf-8")
    jsonschema.validate(json.loads(text), json.loads(schema))
    assert problems() == NAMES
    with pytest.raises(ValueError, match="name: expected .* got 'godard'; did you mean 'Goddard'?"):
        problems("godard")


def test_a_process_found_late_leads_to_better_ones():
    """Turning with a bounded angular acceleration, from rest to rest.

    Only the ladder of durations finds a process, one of 19.2 with idle loops, from which others are
    found, of 10.34, and then the best (SLSQP from random lengths of four to seven arcs found none
    better).
    """
    extremal = optimal_control_records.record("quarter turn from rest to rest").problem.solve()
    assert extremal.optimality.processes > 1 and "a better process is not excluded" in str(
        extremal.optimality
    )


@pytest.mark.parametrize(
    "problem, error, message",
    [
        # Whoever brakes with u >= 0 from the speed -1 needs the fuel 1, however long it takes.
        (
            Problem({x1: x2, x2: u}, ONE, {x1: 1, x2: -1}, [x1, x2], running=sp.Abs(u)),
            NotUnique,
            "duration is left open.* cost the same, about 1,",
        ),
        (
            Problem(
                {x: u, y: v * x}, {u: (-1, 1), v: (-1, 1)}, {x: 0, y: 0}, [x + y - 1, x + y - 2]
            ),
            Infeasible,
            "contradict one another",
        ),
    ],
    ids=["fuel alone", "two ends at once"],
)
def test_reason_without_an_extremal(problem, error, message):
    with pytest.raises(error, match=message):
        problem.solve()

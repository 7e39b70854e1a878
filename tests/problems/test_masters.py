"""Every master meets the contract; the rules on its text are in `tests/authoring/test_rules.py`.

The reference is right, the untouched copy missing, wrong answers are wrong, other right forms
right, and no mutant passes that an independent oracle does not prove right.
"""

import functools
import json
import re
import time
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from adversarial.tables import rows_of
from call_recorder import recorded_calls
from harness import SOLVERS, each_part, first_verdicts, from_checks, solve
from hostile_values import judge_hostile_values
from oracles import is_right
from recovery import COINCIDENT, DEFINED, EVALUABLE, FACTORS, NUMBERS, OWN, borrowed, recovered
from roundings import roundings
from sympy.logic.boolalg import Boolean
from undefined_values import NOT_ASKED, entries, entry_at, undefined_variants

from workbook import checks
from workbook.authoring import master_paths, proof, read_master
from workbook.authoring.mistakes import answer_type_of, mistake_sentence, seal_mistakes
from workbook.checks.contract.check_cells import reported_names, with_one_answer
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import encode
from workbook.checks.contract.few_numbers import MOST_NUMBERS, numbers_in
from workbook.mistakes import find_mistake, mistakes_file
from workbook.mistakes.signature import NoSignature, arcs_as_piecewise, signatures
from workbook.notebooks import exercises
from workbook.notebooks.execution import in_child, judge_cells

# all together; `make test-problem N=1.15` runs those of one problem
pytestmark = pytest.mark.slow
ROOT = Path(__file__).resolve().parents[2]
PATHS = master_paths(ROOT / "solutions")
#: Seconds that the verdict on one answer may take, by chapter (design: speed matters where people
#: wait).
VERDICT_SECONDS = {"5": 3.0}
#: Conditions and sets whose verdict rests on samples and says so: basins and fields of motions,
#: from where a circle can be reached. All others are proved for all values.
SAMPLED = {
    "1.3": {"b_basin"},
    "1.4": {"b_basin"},
    "1.10": {"c_heading"},
    "5.9": {"a_solvable", "b_solvable"},
}
#: Wrong trials that agree with what is right, or with another mistake, at all places where answers
#: are compared.
LIKE_ANOTHER = {"2.3": 1, "2.26": 3}
#: Conditions that the statement takes for granted in one item and asks for in another, or has as a
#: formula whose value is asked for.
CONDITIONS_IN_DATA = {
    "1.2": {"b_stable"},
    "1.3": {"a_stable"},
    "3.3": {"c_speed_observable"},
    "3.13": {"margins"},
}
#: Checks of controls and motions, of which too great a control is found not to be admissible.
OF_BOUNDED_NUMBERS = {
    "extremal_control",
    "maximising_control",
    "optimal_control",
    "optimal_motion",
}
#: What only states a system solves nothing.
RECORDS = (
    "workbook.systems",
    "trajlib.pontryagin.optimal_control",
    "trajlib.pontryagin.problem.statement",
    # a check that leaves a constant out of a cost states the problem anew, which reads its arguments
    "trajlib.pontryagin.problem.arguments",
    "trajlib._arguments.symbols",
)
#: And what loads a library solves nothing either.
LAZY = "trajlib._lazy"


@pytest.fixture(
    scope="module", params=PATHS, ids=lambda path: f"{path.parent.name[2:]}.{int(path.stem[1:])}"
)
def master(request):
    return read_master(request.param)


@functools.cache
def _solved(path):
    return in_child(solve, read_master(path), timeout=120)


@functools.cache
def _results(path):
    """Return what the tests of a problem examine, from one process with common optima."""
    return in_child(each_part, read_master(path), _solved(path)["answers"], PARTS, timeout=300)


def result_of(master, part):
    status, result = _results(master.path)[part]
    assert status == "done", result
    return result


def test_the_reference_is_right_after_encoding(master):
    result = result_of(master, "reference")
    for verdicts in (result["master"], result["exercise"]):
        assert {name: status for name, (status, *_) in verdicts.items()} == dict.fromkeys(
            master.answers, "right"
        ), result
    assert max(result["numbers"].values()) <= MOST_NUMBERS, result["master"]
    limit = VERDICT_SECONDS.get(master.number.split(".")[0], 1.0)
    seconds = result["seconds"]
    for _ in range(3):  # other processes make it slower, never faster
        if max(seconds.values()) > limit:
            again = in_child(first_verdicts, master, _solved(master.path)["answers"], timeout=120)
            seconds = {name: min(taken, again[name]) for name, taken in seconds.items()}
    assert {name: taken for name, taken in seconds.items() if taken > limit} == {}, (
        "verdicts that take too long"
    )


def test_a_condition_or_a_set_is_proved(master):
    verdicts = result_of(master, "reference")["master"]
    assert {
        name for name in _decidable(master) if "proved" not in verdicts[name][1]
    } == SAMPLED.get(master.number, set())
    conditions = {
        name for name in _decidable(master) if not master.answers[name].kind.startswith("set")
    }
    assert all(
        "proved for all values" in verdicts[name][1]
        for name in conditions - SAMPLED.get(master.number, set())
    )


def test_most_conditions_and_sets_are_proved():
    asked = sum(len(_decidable(master)) for master in map(read_master, PATHS))
    sampled = sum(map(len, SAMPLED.values()))
    assert asked > 180 and sampled < 0.05 * asked, f"{asked - sampled} of {asked} are proved"


def _decidable(master):
    return {
        name
        for name, answer in master.answers.items()
        if answer.kind.startswith(("condition", "set"))
    }


def _reference(problem):
    """Judge the reference by the master's check cells one at a time, and as a grader does.

    It comes first, so that the times are those of first verdicts, and no call is hidden because its
    result is cached. Other tests run at the same time: verdicts that seem slow are timed again.
    """
    answers = _encoded(problem)
    # imports, which are no calls; nothing is known of the answers yet, as at a student's first
    # check
    problem.judge({})
    verdicts, seconds = {}, {}
    with recorded_calls(SOLVERS, from_checks) as called:
        for name, value in problem.reference.items():
            # not the clock on the wall: other tests run on the same machine
            start = time.process_time()
            verdict = problem.judge_one(name, value)
            seconds[name] = time.process_time() - start
            verdicts[name] = [verdict.status, verdict.message]
    cells = exercises.find(problem.master.number).code("data", "check")
    return {
        "master": verdicts,
        "numbers": {
            name: _other_numbers(message, problem.reference[name])
            for name, (_, message) in verdicts.items()
        },
        "exercise": judge_cells(cells, answers, {}, list(answers)),
        "seconds": seconds,
        "called": sorted(called),
    }


def _encoded(problem):
    return {name: encode(value).decode() for name, value in problem.reference.items()}


def test_the_untouched_copy_is_missing(master):
    assert result_of(master, "untouched") == dict.fromkeys(master.answers, "missing")


def test_wrong_trials_are_wrong_and_change_no_other_verdict(master):
    tried = {trial.name for trial in master.trials["wrong"]}
    assert tried == set(master.answers), "every answer needs a wrong trial"
    result = result_of(master, "wrong")
    assert result["changed"] == []
    assert (
        result["trials"]
        and [trial for trial in result["trials"] if trial["status"] != "wrong"] == []
    )
    for trial in result["trials"]:
        # `t = 1.31` does not hold the answer 1
        told = re.search(re.escape(trial["reference"]) + r"(?!\.?\d)", trial["message"])
        assert len(trial["message"]) > 20 and not told, trial
        assert trial["numbers"] <= MOST_NUMBERS, trial
    assert [trial for trial in result["trials"] if trial["revealed"]] == []


def _wrong(problem):
    """Return the wrong trials with their verdicts, and what these disclose."""
    trials, changed = proof.wrong_trials(problem)
    for trial in trials:
        right, value, message = (
            problem.reference[trial["answer"]],
            trial["value"],
            trial["verdict"].message,
        )
        trial.update(
            reference=f"= {right}",
            numbers=_other_numbers(message, value),
            revealed=_revealed_numbers(right, value, message),
        )
    return {"trials": list(map(_as_data, trials)), "changed": changed}


def _other_numbers(message, answer):
    """Count the numbers of a message that are not in the answer."""
    own = numbers_in(str(answer))
    return len([number for number in numbers_in(message) if number not in own])


def _revealed_numbers(right, wrong, message):
    """Return numbers of three or more digits in a message that the right answer alone has."""
    rights, wrongs = _numbers(right), _numbers(wrong)
    numbers = [
        number
        for number in re.findall(r"\d+\.?\d*", message)
        if len(number.replace(".", "").strip("0")) > 2
    ]
    return [
        number
        for number in numbers
        for true in rights
        if abs(float(number) - true) <= 5e-4 * true
        and not any(abs(float(number) - other) <= 5e-4 * other for other in wrongs)
    ]


def _numbers(answer):
    values = [sp.sympify(entry_at(answer, path)) for path in entries(answer)]
    return [abs(complex(number)) for number in values if number.is_number]


def test_no_answer_is_corrected_from_the_numbers_in_messages(master):
    """A factor or a coefficient is made wrong, and a student computes it from what messages say."""
    assert [
        row
        for row in result_of(master, "recovery")
        if row[1] not in (EVALUABLE if row[3] == OWN else DEFINED)
    ] == []


def _recovery(problem):
    return [
        [name, problem.check_arguments(name)[0], *found]
        for name in problem.reference
        for found in recovered(problem, name)
    ]


def test_no_answer_is_found_in_the_messages_on_another(master):
    assert {
        (name, number, other) for name, number, other, _ in result_of(master, "borrowed")
    } <= COINCIDENT.get(master.number, set()), result_of(master, "borrowed")


def test_homework_does_not_say_in_which_direction_a_number_is_wrong(master):
    """One message is on a number that is too great, one on a number that is too small."""
    assert [row for row in result_of(master, "direction") if row[1] not in OF_BOUNDED_NUMBERS] == []


def _in_homework(problem, name, value):
    """Return the verdict on one answer by a check cell of a homework."""
    (cell,) = (cell for cell in problem.master.code("check") if name in reported_names(cell))
    with checks.collecting() as verdicts:
        checks.hide_direction()
        exec(with_one_answer(cell, name), problem.data | problem.reference | {name: value})
    return verdicts[name]


def _direction(problem):
    """Return [name, check, two messages] where the messages differ by more than their numbers."""
    differ = []
    for name, reference in problem.reference.items():
        if not problem.master.answers[name].kind.startswith(("number", "expression")):
            continue
        value = sp.sympify(reference)
        if not isinstance(value, sp.Expr):  # arcs of a control
            continue
        verdicts = [_in_homework(problem, name, value * factor) for factor in FACTORS]
        texts = {NUMBERS.sub("#", verdict.message) for verdict in verdicts}
        if {verdict.status for verdict in verdicts} == {"wrong"} and len(texts) > 1:
            differ.append([name, problem.check_arguments(name)[0], *(v.message for v in verdicts)])
    return differ


def test_every_form_of_an_answer_is_right(master):
    result = result_of(master, "forms")
    assert {name for name, tried in result["tried"].items() if tried} == set(master.answers)
    assert result["refused"] == []


def _forms(problem):
    tried, refused = proof.forms_refused(problem)
    return {
        "tried": tried,
        "refused": [
            f"{name}, {form}: {value}: {verdict.status}: {verdict.message}"
            for name, form, value, verdict in refused
        ],
    }


def test_right_trials_are_right(master):
    assert [trial for trial in result_of(master, "right") if trial["status"] != "right"] == []


def _right(problem):
    return list(map(_as_data, proof.right_trials(problem)))


def test_decimals_count_to_three_digits(master):
    assert [description for *_, description in result_of(master, "decimals")] == []


def _decimals(problem):
    """Return answers with decimals whose verdict is not the one due: (name, due, description)."""
    unexpected = []
    for name, text in _encoded(problem).items():
        for what, value, due in roundings(decode(text.encode())):
            verdict = problem.judge_one(name, decode(encode(value)))
            if verdict.status != due:
                unexpected.append(
                    (name, due, f"{name}, {what}: {value} is {verdict.status}: {verdict.message}")
                )
    return unexpected


def test_wrong_trials_get_the_sentence_of_their_mistake(master):
    result = result_of(master, "mistakes")
    assert (
        json.loads(mistakes_file(master.exercise).read_text(encoding="utf-8"))["answers"]
        == result["sealed"]
    ), f"run `workbook exercises {master.number}`"
    assert len(result["without name"]) == LIKE_ANOTHER.get(master.number, 0), result["without name"]
    assert result["not recognised"] == [] and result["right"] == []


def _mistakes(problem):
    """Look up every wrong trial, in its own form and three others, and all right answers."""
    master = problem.master
    trials = list(zip(master.trials["wrong"], problem.given("wrong")))
    answers = {name: decode(text.encode()) for name, text in _encoded(problem).items()}
    result = {
        "sealed": seal_mistakes(master, answers, trials),
        "without name": [],
        "not recognised": [],
        "right": [],
    }
    for trial, value in trials:
        text = mistake_sentence(master, trial)
        if text and find_mistake(master.number, trial.name, value) != text:
            result["without name"].append(f"{trial.name} = {value}")
        elif text:
            known = _known(problem, trial.name, value, text)
            if sum(known.values()) < min(3, len(known)):
                result["not recognised"].append(f"{trial.name} = {value}: {known}")
            # Given as cases, arcs may be like others, but are never told the sentence of another
            # mistake.
            result["not recognised"] += [
                f"{trial.name} = {cases}"
                for cases in arcs_as_piecewise(value, master.answers[trial.name].kind)
                if find_mistake(master.number, trial.name, cases) not in (text, "")
            ]
    right = [
        *answers.items(),
        *zip((trial.name for trial in master.trials["right"]), problem.given("right")),
    ]
    forms = (
        (name, decode(encode(form)))
        for name, value in answers.items()
        for form in problem.forms(name, value).values()
    )
    for name, value in [*right, *forms]:
        if text := find_mistake(master.number, name, value):
            result["right"].append(f"{name} = {value}: {text}")
    return result


def _conditions_in_data(problem):
    """Return the conditions asked for that a data cell gives a name to."""
    return sorted(
        name
        for name, answer in problem.master.answers.items()
        if answer.kind.startswith("condition")
        and any(
            _alike(problem, name, value)
            for value in problem.data.values()
            if isinstance(value, Boolean)
        )
    )


def _alike(problem, name, value):
    question = answer_type_of(problem.master, name, [problem.reference[name]])
    with suppress(NoSignature):
        return not set(signatures(value, question)).isdisjoint(
            signatures(problem.reference[name], question)
        )


def _known(problem, name, value, text):
    """Return {form: whether it gets the sentence} of a wrong value, up to the third."""
    known = {}
    for form, other in problem.each_form(name, value):
        known[form] = find_mistake(problem.master.number, name, decode(encode(other))) == text
        if sum(known.values()) == 3:
            break
    return known


def _as_data(trial):
    verdict = trial["verdict"]
    return {key: trial[key] for key in trial if key not in ("value", "verdict")} | {
        "status": verdict.status,
        "message": verdict.message,
    }


def test_mutants_pass_only_if_proved_right(master, record_property):
    result = result_of(master, "mutants")
    record_property("mutants", result["count"])
    record_property("equivalent", result["equivalent"])
    assert result["passed"] == [], "accepted, though not proved right"
    assert result["refused"] == [], "proved right, yet not accepted"
    record_property("without value", result["without value"])
    assert result["accepted"] == [], "infinite or undefined, yet not refused"


def _mutants(problem):
    result = {
        "count": 0,
        "equivalent": 0,
        "passed": [],
        "refused": [],
        "without value": 0,
        "accepted": [],
    }
    for name, mutant, verdict in proof.small_changes(problem):
        kind = problem.master.answers[name].kind
        right = is_right(mutant, problem.reference[name], *problem.check_arguments(name), kind)
        result["count"] += 1
        result["equivalent"] += right
        if verdict.status == "right" and not right:
            result["passed"].append(f"{name} = {mutant}")
        if verdict.status != "right" and right:
            result["refused"].append(f"{name} = {mutant}: {verdict.status}: {verdict.message}")
    for name, reference in problem.reference.items():
        _, arguments, options = problem.check_arguments(name)
        # Not one of these is a value, so no oracle is asked: each has to be told that it is none,
        # and not left unchecked.
        for what, mutant in undefined_variants(reference, [*arguments, *options.values()]):
            verdict = problem.judge_one(name, mutant)
            result["without value"] += 1
            where = what.removeprefix("defined for ").removesuffix(" alone")
            not_asked = verdict.status == "right" and (problem.master.number, where) in NOT_ASKED
            if verdict.status not in ("wrong", "invalid") and not not_asked:
                result["accepted"].append(f"{name}, {what}: {verdict.status}: {verdict.message}")
    return result


def test_every_row_of_the_tables_has_the_verdict_due(master):
    """Judge the rows in `adversarial/` on this problem, with verdicts by mathematics."""
    rows = rows_of(master.number)
    assert [row.name for row in rows if row.name not in master.answers] == [], (
        "no answers of this problem"
    )
    verdicts = result_of(master, "rows")
    assert [
        f"{row.name} = {row.code} is {status}, though {row.reason}: {message}"
        for row, (status, message) in zip(rows, verdicts, strict=True)
        if status != row.due
    ] == []
    assert all(len(message) > 20 for status, message in verdicts)


def _rows(problem):
    """Return (status, message) of each row, which may use the names of the data cells."""
    rows = rows_of(problem.master.number)
    values = [decode(encode(eval(row.code, problem.data | {"np": np, "sp": sp}))) for row in rows]
    verdicts = [problem.judge_one(row.name, value) for row, value in zip(rows, values)]
    return [(verdict.status, verdict.message) for verdict in verdicts]


def test_text_is_never_executed(master):
    """Judge texts that would run if they were evaluated, unpickled or imported in a check."""
    assert result_of(master, "hostile")["texts"] == []


def test_values_that_are_no_numbers_are_never_right(master):
    """NaN passes `not abs(x - y) > tolerance`, infinities cancel, an empty list is not wrong."""
    assert result_of(master, "hostile")["nothing"] == [], (
        "what is truly right belongs into EMPTY_AND_RIGHT"
    )


def test_odd_answers_are_judged_and_no_example_is_right(master):
    assert result_of(master, "hostile")["odd"] == []


PARTS = {
    "reference": _reference,
    "untouched": proof.untouched,
    "wrong": _wrong,
    "forms": _forms,
    "right": _right,
    "mutants": _mutants,
    "mistakes": _mistakes,
    "decimals": _decimals,
    "conditions in data": _conditions_in_data,
    "rows": _rows,
    "hostile": judge_hostile_values,
    "recovery": _recovery,
    "borrowed": borrowed,
    "direction": _direction,
}


def test_data_hold_no_condition_that_is_asked_for(master):
    assert set(result_of(master, "conditions in data")) == CONDITIONS_IN_DATA.get(
        master.number, set()
    )


def test_answer_and_check_share_no_solver(master):
    answered = set(map(tuple, _solved(master.path)["called"]))
    checked = set(map(tuple, result_of(master, "reference")["called"]))
    assert answered and checked
    assert [
        call for call in answered if call[0].startswith("workbook.checks") and call[1] != "<module>"
    ] == []
    assert [
        call
        for call in answered & checked
        if call[0].startswith(SOLVERS)
        and not call[0].startswith("workbook.checks")
        and not call[0].startswith(RECORDS)
        and call[0] != LAZY
    ] == []

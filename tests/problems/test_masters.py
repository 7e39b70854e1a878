"""Every master keeps its promise: the reference is right, the untouched copy missing, wrong answers
are wrong, other right forms right, and no mutant passes that an independent oracle does not prove
right."""

import ast
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
from calls import calls_noted
from foreign import judged_under_watch
from harness import SOLVERS, check_calls, each_part, first_verdicts, from_checks, solve
from mutants import mutants
from nonsense import NOT_ASKED, entries, entry_at, nonsense
from oracles import is_right
from roundings import roundings
from sympy.logic.boolalg import Boolean

from workbook.authoring import master_paths, read
from workbook.authoring.mistakes import answer_type_of, mistake_sentence, seal_mistakes
from workbook.authoring.scaffold import PLACEHOLDER
from workbook.authoring.trials import trials_file
from workbook.checks.contract.encoding import decode, encode
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
#: Seconds of computing that the tests of one problem may take: with 194 problems everybody waits
#: for them. In chapter 5 an answer is judged by simulating it.
PROBLEM_SECONDS = {"5": 55}
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
#: Answers of which one number may be one per cent off: it belongs to two terms that cancel, to a
#: small term of a sum (5.62), or the other numbers together make more uncertain (5.35).
HARDLY_MATTERS = {"5.35": {"angle"}, "5.62": {"d_cost"}, "5.65": {"control"}}
#: Conditions that the statement takes for granted in one item and asks for in another, or has as a
#: formula whose value is asked for.
TOLD = {
    "1.2": {"b_stable"},
    "1.3": {"a_stable"},
    "3.3": {"c_speed_observable"},
    "3.13": {"margins"},
}
#: Wrong trials that are half of what is right, where a message tells their double: at most so far
#: turns a direction.
DOUBLED = {"5.11": {"time"}, "5.12": {"latest"}, "5.13": {"time"}}
#: Options of checks that may be written as numbers in a check cell.
TOLERANCES = {"tolerance", "horizon"}
#: What only states a system solves nothing.
RECORDS = ("workbook.systems", "trajlib.pontryagin.statement")
#: And what loads a library solves nothing either.
LAZY = "trajlib._lazy"


@pytest.fixture(
    scope="module", params=PATHS, ids=lambda path: f"{path.parent.name[2:]}.{int(path.stem[1:])}"
)
def master(request):
    return read(request.param)


@functools.cache
def _solved(path):
    return in_child(solve, read(path), timeout=120)


@functools.cache
def _found(path):
    """What all tests of a problem look at, from one process, where optima are computed once."""
    return in_child(each_part, read(path), _solved(path)["answers"], PARTS, timeout=300)


def found(master, part):
    how, what = _found(master.path)[part]
    assert how == "done", what
    return what


def test_the_reference_is_right_and_crosses_the_encoder(master):
    seen = found(master, "reference")
    for verdicts in (seen["master"], seen["exercise"]):
        assert {name: status for name, (status, *_) in verdicts.items()} == dict.fromkeys(
            master.answers, "right"
        ), seen
    limit = VERDICT_SECONDS.get(master.number.split(".")[0], 1.0)
    seconds = seen["seconds"]
    if max(seconds.values()) > limit:
        seconds = in_child(first_verdicts, master, _solved(master.path)["answers"], timeout=120)
    assert {name: taken for name, taken in seconds.items() if taken > limit} == {}, (
        "verdicts that take too long"
    )


def test_a_condition_or_a_set_is_proved(master):
    told = found(master, "reference")["master"]
    assert {name for name in _decidable(master) if "proved" not in told[name][1]} == SAMPLED.get(
        master.number, set()
    )
    conditions = {
        name for name in _decidable(master) if not master.answers[name].kind.startswith("set")
    }
    assert all(
        "proved for all values" in told[name][1]
        for name in conditions - SAMPLED.get(master.number, set())
    )


def test_most_conditions_and_sets_are_proved():
    asked = sum(len(_decidable(master)) for master in map(read, PATHS))
    sampled = sum(map(len, SAMPLED.values()))
    assert asked > 180 and sampled < 0.05 * asked, f"{asked - sampled} of {asked} are proved"


def _decidable(master):
    return {
        name
        for name, answer in master.answers.items()
        if answer.kind.startswith(("condition", "set"))
    }


def test_nobody_waits_long_for_one_problem(master):
    taken = found(master, "seconds") + _solved(master.path)["seconds"]
    assert taken < PROBLEM_SECONDS.get(master.number.split(".")[0], 20)


def _reference(bench):
    """By the master's check cells one at a time, and by those of the student's notebook as a grader
    judges. Comes first, so that the times are those of first verdicts, and that nothing which is
    called is kept from being seen by an earlier call. Other tests run beside: who seems slow is
    timed again."""
    answers = _encoded(bench)
    # imports, which are no calls; nothing is known of the answers yet, as at a student's first
    # check
    bench.judge({})
    verdicts, seconds = {}, {}
    with calls_noted(SOLVERS, from_checks) as called:
        for name, value in bench.reference.items():
            # not the clock on the wall: other tests run on the same machine
            start = time.process_time()
            verdict = bench.judge_one(name, value)
            seconds[name] = time.process_time() - start
            verdicts[name] = [verdict.status, verdict.message]
    cells = exercises.find(bench.master.number).code("data", "check")
    return {
        "master": verdicts,
        "exercise": judge_cells(cells, answers, {}, list(answers)),
        "seconds": seconds,
        "called": sorted(called),
    }


def _encoded(bench):
    return {name: encode(value).decode() for name, value in bench.reference.items()}


def test_the_untouched_copy_is_missing(master):
    assert found(master, "untouched") == dict.fromkeys(master.answers, "missing")


def _untouched(bench):
    return {name: v.status for name, v in bench.judge({}).items()}


def test_wrong_trials_are_wrong_and_harm_no_other_answer(master):
    tried = {trial.name for trial in master.trials["wrong"]}
    assert tried == set(master.answers), "every answer needs a wrong trial"
    seen = found(master, "wrong")
    assert seen["harmed"] == []
    assert (
        seen["trials"] and [trial for trial in seen["trials"] if trial["status"] != "wrong"] == []
    )
    for trial in seen["trials"]:
        assert len(trial["message"]) > 20 and trial["reference"] not in trial["message"], trial
    told = {trial["answer"] for trial in seen["trials"] if trial["told"]}
    assert told == DOUBLED.get(master.number, set()), seen["trials"]


def _wrong(bench):
    """Every other answer is wrong, first one half of them and then the other, each in all its wrong
    ways: the rest stay right, which is looked at in the first turn."""
    trials, harmed, order = {}, [], list(bench.master.answers)
    for trial in _values(bench, "wrong"):
        trials.setdefault(trial["answer"], []).append(trial)
    for half in (order[::2], order[1::2]):
        for turn in range(max((len(trials[name]) for name in half if name in trials), default=0)):
            tried = {name: trials[name][turn] for name in half if turn < len(trials.get(name, ()))}
            values = {name: trial["value"] for name, trial in tried.items()}
            for name, verdict in bench.judge_among_right(tried if turn else order, values).items():
                if name in tried:
                    tried[name].update(
                        status=verdict.status,
                        message=verdict.message,
                        told=_told_of(bench.reference[name], tried[name]["value"], verdict.message),
                    )
                elif verdict.status != "right":
                    harmed.append(
                        f"{name} is {verdict.status} beside "
                        f"{[trial['comment'] for trial in tried.values()]}"
                    )
    return {
        "trials": [_as_data(trial) for name in trials for trial in trials[name]],
        "harmed": harmed,
    }


def _told_of(right, wrong, message):
    """Numbers of three digits or more in a message that are numbers of the right answer and not of
    the wrong one."""
    rights, wrongs = _numbers(right), _numbers(wrong)
    said = [
        number
        for number in re.findall(r"\d+\.?\d*", message)
        if len(number.replace(".", "").strip("0")) > 2
    ]
    return [
        number
        for number in said
        for true in rights
        if abs(float(number) - true) <= 5e-4 * true
        and not any(abs(float(number) - other) <= 5e-4 * other for other in wrongs)
    ]


def _numbers(answer):
    found = [sp.sympify(entry_at(answer, place)) for place in entries(answer)]
    return [abs(complex(number)) for number in found if number.is_number]


def test_every_form_of_an_answer_is_right(master):
    seen = found(master, "forms")
    assert {name for name, tried in seen["tried"].items() if tried} == set(master.answers)
    assert seen["refused"] == []


def _forms(bench):
    tried, refused = {}, []
    for name, text in _encoded(bench).items():
        others = bench.forms(name, decode(text.encode()))
        tried[name] = list(others)
        for form, value in others.items():
            verdict = bench.judge_one(name, value)
            if verdict.status != "right":
                refused.append(f"{name}, {form}: {value}: {verdict.status}: {verdict.message}")
    return {"tried": tried, "refused": refused}


def test_right_trials_are_right(master):
    assert [trial for trial in found(master, "right") if trial["status"] != "right"] == []


def _right(bench):
    trials = _values(bench, "right")
    for trial in trials:
        verdict = bench.judge_one(trial["answer"], trial["value"])
        trial.update(status=verdict.status, message=verdict.message)
    return list(map(_as_data, trials))


def test_decimals_count_to_three_digits(master):
    seen = found(master, "decimals")
    assert [told for name, due, told in seen if due == "right"] == []
    assert {name for name, due, _ in seen if due == "wrong"} <= HARDLY_MATTERS.get(
        master.number, set()
    ), seen


def _decimals(bench):
    """Answers with decimals of which the verdict is not the one due: (name, due, what was
    found)."""
    found = []
    for name, text in _encoded(bench).items():
        for what, value, due in roundings(decode(text.encode())):
            verdict = bench.judge_one(name, decode(encode(value)))
            if verdict.status != due:
                found.append(
                    (name, due, f"{name}, {what}: {value} is {verdict.status}: {verdict.message}")
                )
    return found


def test_who_gives_a_wrong_trial_is_told_its_mistake(master):
    seen = found(master, "mistakes")
    assert (
        json.loads(mistakes_file(master.exercise).read_text(encoding="utf-8"))["answers"]
        == seen["sealed"]
    ), f"run `workbook exercises {master.number}`"
    assert len(seen["without name"]) == LIKE_ANOTHER.get(master.number, 0), seen["without name"]
    assert seen["not recognised"] == [] and seen["right"] == []


def _mistakes(bench):
    """By the file beside the student's copy: every trial in its own form and three others, and no
    right answer."""
    master = bench.master
    trials = list(zip(master.trials["wrong"], bench.given("wrong")))
    answers = {name: decode(text.encode()) for name, text in _encoded(bench).items()}
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
            known = _known(bench, trial.name, value, text)
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
        *zip((trial.name for trial in master.trials["right"]), bench.given("right")),
    ]
    forms = (
        (name, decode(encode(form)))
        for name, value in answers.items()
        for form in bench.forms(name, value).values()
    )
    for name, value in [*right, *forms]:
        if said := find_mistake(master.number, name, value):
            result["right"].append(f"{name} = {value}: {said}")
    return result


def _told(bench):
    """The conditions asked for that a data cell gives a name to."""
    return sorted(
        name
        for name, answer in bench.master.answers.items()
        if answer.kind.startswith("condition")
        and any(
            _alike(bench, name, value)
            for value in bench.data.values()
            if isinstance(value, Boolean)
        )
    )


def _alike(bench, name, value):
    question = answer_type_of(bench.master, name, [bench.reference[name]])
    with suppress(NoSignature):
        return not set(signatures(value, question)).isdisjoint(
            signatures(bench.reference[name], question)
        )


def _known(bench, name, value, text):
    """{form: whether this form of a wrong value is told the sentence}, as far as the third that
    is."""
    known = {}
    for form, other in bench.each_form(name, value):
        known[form] = find_mistake(bench.master.number, name, decode(encode(other))) == text
        if sum(known.values()) == 3:
            break
    return known


def test_every_mistake_has_a_name(master):
    notes = [
        f"{trial.name}: {trial.comment}"
        for trial in master.trials["wrong"]
        if mistake_sentence(master, trial) is None
    ]
    assert notes == [], (
        "a wrong trial needs a sentence to the student who has it, with . or ? at its end"
    )


def test_a_mistake_has_words_of_its_own(master):
    page = master.path.read_text(encoding="utf-8")
    told = [
        mistake_sentence(master, trial).partition("\n")[0]
        for trial in master.trials["wrong"]
        if mistake_sentence(master, trial)
    ]
    assert [words for words in told if len(words) > 20 and words in page] == [], (
        "the page says this to everybody"
    )


def test_a_named_mistake_is_told_without_the_answer(master):
    for trial in master.trials["wrong"]:
        if said := mistake_sentence(master, trial):
            words = set(re.findall(r"\w+", said.partition("\n")[0]))
            named = "_" in trial.name and trial.name in words  # others are ordinary words
            assert not named and len(said) < 400 and "right answer" not in said, said


def _values(bench, role):
    """The trials of a role, each with what it gives its answer."""
    return [
        {
            "answer": trial.name,
            "comment": trial.comment,
            "value": value,
            "reference": f"= {bench.reference[trial.name]}",
        }
        for trial, value in zip(bench.master.trials[role], bench.given(role))
    ]


def _as_data(trial):
    return {key: text for key, text in trial.items() if key != "value"}


def test_no_mutant_passes_that_is_not_proved_right(master, record_property):
    seen = found(master, "mutants")
    record_property("mutants", seen["count"])
    record_property("equivalent", seen["equivalent"])
    assert seen["passed"] == [], "accepted, though not proved right"
    assert seen["refused"] == [], "proved right, yet not accepted"
    record_property("without value", seen["without value"])
    assert seen["taken for answers"] == [], "infinite or undefined, yet not refused"


def _mutants(bench):
    result = {
        "count": 0,
        "equivalent": 0,
        "passed": [],
        "refused": [],
        "without value": 0,
        "taken for answers": [],
    }
    for name, reference in bench.reference.items():
        check, arguments, options = bench.check_arguments(name)
        kind = bench.master.answers[name].kind
        for mutant in mutants(reference, kind):
            right = is_right(mutant, reference, check, arguments, options, kind)
            verdict = bench.judge_one(name, mutant)
            result["count"] += 1
            result["equivalent"] += right
            if verdict.status == "right" and not right:
                result["passed"].append(f"{name} = {mutant}")
            if verdict.status != "right" and right:
                result["refused"].append(f"{name} = {mutant}: {verdict.status}: {verdict.message}")
        # Not one of these is a value, so no oracle is asked: each has to be told that it is none,
        # and not left unchecked.
        for what, mutant in nonsense(reference, [*arguments, *options.values()]):
            verdict = bench.judge_one(name, mutant)
            result["without value"] += 1
            where = what.removeprefix("defined for ").removesuffix(" alone")
            not_asked = verdict.status == "right" and (bench.master.number, where) in NOT_ASKED
            if verdict.status not in ("wrong", "invalid") and not not_asked:
                result["taken for answers"].append(
                    f"{name}, {what}: {verdict.status}: {verdict.message}"
                )
    return result


def test_every_row_of_the_tables_has_the_verdict_due(master):
    """The rows in `adversarial/` that are about this problem: what mathematics says of other
    answers."""
    rows = rows_of(master.number)
    assert [row.name for row in rows if row.name not in master.answers] == [], (
        "no answers of this problem"
    )
    verdicts = found(master, "rows")
    assert [
        f"{row.name} = {row.code} is {status}, though {row.reason}: {message}"
        for row, (status, message) in zip(rows, verdicts, strict=True)
        if status != row.due
    ] == []
    assert all(len(message) > 20 for status, message in verdicts)


def _rows(bench):
    """(status, message) of each row, which may use the names of the data cells."""
    rows = rows_of(bench.master.number)
    values = [decode(encode(eval(row.code, bench.data | {"np": np, "sp": sp}))) for row in rows]
    verdicts = [bench.judge_one(row.name, value) for row, value in zip(rows, values)]
    return [(verdict.status, verdict.message) for verdict in verdicts]


def test_text_is_never_code(master):
    """Texts that would run, were they evaluated, unpickled or imported anywhere in a check."""
    assert found(master, "foreign")["texts"] == []


def test_no_number_at_all_is_never_right(master):
    """NaN passes `not abs(x - y) > tolerance`, infinities cancel, and an empty list has no wrong
    element."""
    assert found(master, "foreign")["nothing"] == [], (
        "what is truly right belongs into EMPTY_AND_RIGHT"
    )


def test_odd_answers_are_the_students_affair_and_are_not_told_the_right_one(master):
    assert found(master, "foreign")["odd"] == []


PARTS = {
    "reference": _reference,
    "untouched": _untouched,
    "wrong": _wrong,
    "forms": _forms,
    "right": _right,
    "mutants": _mutants,
    "mistakes": _mistakes,
    "decimals": _decimals,
    "told": _told,
    "rows": _rows,
    "foreign": judged_under_watch,
}


def test_the_data_tell_no_condition_that_is_asked_for(master):
    assert set(found(master, "told")) == TOLD.get(master.number, set())


def test_nothing_is_left_of_the_template(master):
    left = [
        f"{path.name}:{k}: {line.strip()}"
        for path in (master.path, trials_file(master.path))
        for k, line in enumerate(path.read_text(encoding="utf-8").split("\n"), start=1)
        if PLACEHOLDER in line
    ]
    if left:
        pytest.fail("\n".join(["to be replaced:", *left]), pytrace=False)


def test_check_cells_hold_no_answers(master):
    data = {
        node.id
        for source in master.code("data")
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.Name)
    }
    for source in master.code("check"):
        for name, call in check_calls(source).items():
            assert (
                ast.unparse(call.func).startswith("checks.") and ast.unparse(call.args[0]) == name
            )
            for node in ast.walk(call):
                assert not isinstance(
                    node, (ast.Lambda, ast.BinOp, ast.Compare, ast.BoolOp, ast.Subscript)
                ), ast.unparse(node)
                if isinstance(node, ast.Call):
                    assert node is call, f"a call inside a check's arguments: {ast.unparse(node)}"
                if isinstance(node, ast.Name):
                    assert node.id in data | set(master.answers) | {"checks"}, (
                        f"{node.id} is neither data nor an answer"
                    )
                if isinstance(node, ast.Constant):
                    (keyword,) = [k for k in call.keywords if k.value is node] or [None]
                    assert keyword is not None and keyword.arg in TOLERANCES, (
                        f"a literal in a check: {ast.unparse(node)}"
                    )


def test_answer_and_check_share_no_solver(master):
    answered = set(map(tuple, _solved(master.path)["called"]))
    checked = set(map(tuple, found(master, "reference")["called"]))
    assert answered and checked
    assert [
        call for call in answered if call[0].startswith("workbook.checks") and call[1] != "<module>"
    ] == []
    assert [
        call
        for call in answered & checked
        if call[0].startswith(SOLVERS)
        and not call[0].startswith("workbook.checks")
        and call[0] not in (*RECORDS, LAZY)
    ] == []

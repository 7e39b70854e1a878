"""The judge: not deceived, running nothing of the student's, naming whose fault it was."""

import json
import os
import random
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

sys.path.insert(0, str(Path(__file__).parent))
from classroom import RIGHT_1_15
from hostile_values import AuditWatch

from workbook.checks.contract.encoding import encode
from workbook.checks.contract.verdict import INVALID, MISSING, RIGHT, STATUSES, UNCHECKED, WRONG
from workbook.grading.pool import judging
from workbook.grading.pool.judging import FINAL, NOT_FINAL, WITHIN_LIMITS, Bounds, Judge, judge
from workbook.grading.sandbox.limits import Outcome
from workbook.notebooks import exercises
from workbook.notebooks.execution import CONTEXT, decoded, in_child, judge_cells

EXERCISE = exercises.find("1.15")
NAMES = list(EXERCISE.about["answers"])
k1, k2, s = sp.symbols("k1 k2 s", real=True)
WRONG_ANSWERS = dict.fromkeys(NAMES, (k1 > 3) & (k2 > 3))


def handed_over(answers=None, **more):
    """Return what a notebook's process would send for these values."""
    encoded = {name: encode(value).decode() for name, value in (answers or {}).items()}
    return json.dumps(
        {"encoded": encoded, "unreadable": {}, "errors": [], "stopped": []} | more
    ).encode()


def judged(message, bounds=Bounds()):
    return judge(EXERCISE, Outcome("done", message), bounds)


def statuses(judgement):
    return {name: verdict.status for name, verdict in judgement.verdicts.items()}


def test_right_and_wrong():
    right = {name: eval(text, {"k1": k1, "k2": k2}) for name, text in RIGHT_1_15.items()}
    assert statuses(judged(handed_over(right))) == dict.fromkeys(NAMES, RIGHT)
    judgement = judged(handed_over(right | {"b_region": k1 > 0}))
    assert statuses(judgement) == dict.fromkeys(NAMES, RIGHT) | {"b_region": WRONG}
    assert (
        judgement.final == FINAL
        and judgement.remarks == ()
        and judgement.answers["b_region"] == "k1 > 0"
    )


def test_a_renamed_variable_is_distinguished_from_a_stub():
    judgement = judged(handed_over({"b_region": ..., "c_region": sp.true}))
    assert statuses(judgement)["a_region"] == statuses(judgement)["b_region"] == "missing"
    assert (
        judgement.verdicts["a_region"].message
        == judging.NEVER_ASSIGNED
        != judgement.verdicts["b_region"].message
    )
    nothing = judged(handed_over(errors=["code cell 3: NameError: name 'k3' is not defined"]))
    assert {verdict.message for verdict in nothing.verdicts.values()} == {judging.NEVER_ASSIGNED}, (
        "its cell failed"
    )


def test_what_happened_to_the_cells_of_answers_is_said_as_in_a_notebook():
    notes = {"failed": {"a_region": "NameError"}, "overwritten": {"b_region": ["k1"]}}
    verdicts = judged(handed_over({"b_region": k1 > 0}, **notes)).verdicts
    assert verdicts["a_region"].status == MISSING and verdicts["a_region"].message == (
        "not checked: its cell stopped with NameError; fix that first"
    )
    assert verdicts["b_region"].status == WRONG and "overwrote k1," in verdicts["b_region"].message
    assert verdicts["c_region"].message == judging.NEVER_ASSIGNED
    # the next notebook's answers are judged by the same process
    judge = Judge()
    try:
        judge.judge(EXERCISE, Outcome("done", handed_over({"b_region": k1 > 0}, **notes)))
        after = judge.judge(EXERCISE, Outcome("done", handed_over({"b_region": k1 > 0}))).verdicts
    finally:
        judge.end()
    assert "overwrote" not in after["b_region"].message
    assert after["a_region"].message == judging.NEVER_ASSIGNED


@pytest.mark.parametrize(
    "forged",
    [
        {"failed": {"a_region": "NameError: full marks"}, "overwritten": {"b_region": ["k1 . No"]}},
        {"failed": {"a_region": "E" * 999}, "overwritten": {"b_region": "k1"}},
        {"failed": {"a_region": 5}, "overwritten": {"b_region": [["k1"]]}},
        {"failed": {"a_region": "Оценка"}, "overwritten": {"b_region": None}},
    ],
)
def test_no_sentence_can_be_forged_from_the_names_in_a_note(forged):
    verdicts = judged(handed_over({"b_region": k1 > 0}, **forged)).verdicts
    assert verdicts["a_region"].message == judging.NEVER_ASSIGNED
    assert (
        verdicts["b_region"].message
        == judged(handed_over({"b_region": k1 > 0})).verdicts["b_region"].message
    )


def test_hashes_are_of_whole_answers():
    """Texts are cut; answers that differ beyond that have different hashes, equal ones the same."""
    long = [sp.And(*(k1 > k for k in range(200)), k2 > last) for last in (1, 2)]
    judgements = [judged(handed_over({"a_region": first, "b_region": long[1]})) for first in long]
    assert judgements[0].answers["a_region"] == judgements[1].answers["a_region"]
    assert (
        judgements[0].hashes["a_region"]
        != judgements[1].hashes["a_region"]
        == judgements[0].hashes["b_region"]
    )
    names = list(EXERCISE.about["answers"])
    alone = judging._one_by_one(
        EXERCISE.code("data", "check"), handed_over({"a_region": long[0]}), names, Bounds()
    )
    assert alone.hashes == {"a_region": judgements[0].hashes["a_region"]} and set(
        judgements[0].hashes
    ) == {
        "a_region",
        "b_region",
    }


# Only the check's own verdict counts


def test_only_the_named_answers_reach_the_checks():
    """Values under the names of the data would make a wrong answer right."""
    claim = {"a_region": (k1 > 0) & (k2 > 0)}
    data = {"a_poly": (s + k1) * (s + k2), "k1": k1, "k2": k2, "s": s, "checks": 1, "sp": 2}
    encoded = {name: encode(value).decode() for name, value in (data | claim).items()}
    cells = EXERCISE.code("data", "check")
    assert (
        in_child(judge_cells, cells, encoded, {}, ["a_region"], timeout=60)["a_region"][0] == WRONG
    )
    assert (
        in_child(
            judge_cells,
            [
                (role, source.replace("a_poly = ", "a_poly = (s + k1)*(s + k2)\nnot_it = "))
                for role, source in cells
            ],
            encoded,
            {},
            ["a_region"],
            timeout=60,
        )["a_region"][0]
        == RIGHT
    ), "with the data replaced the claim would be right"
    assert statuses(judged(handed_over(data | claim))) == dict.fromkeys(NAMES, MISSING) | {
        "a_region": WRONG
    }


def test_verdicts_are_not_taken_from_a_notebook():
    forged = {name: ["right", "of course"] for name in NAMES}
    judgement = judged(handed_over(WRONG_ANSWERS, verdicts=forged, points=5))
    assert set(statuses(judgement).values()) == {WRONG}


def test_without_a_check_nothing_is_right():
    answers = {name: encode(value).decode() for name, value in WRONG_ANSWERS.items()}
    data = EXERCISE.code("data")
    verdicts = in_child(judge_cells, data, answers, {}, NAMES, timeout=60)
    assert {status for status, *_ in verdicts.values()} == {UNCHECKED}
    failing = [*EXERCISE.code("data", "check")[:2], ("check", "1/0"), *EXERCISE.code("check")[2:]]
    verdicts = in_child(judge_cells, failing, answers, {}, NAMES, timeout=60)
    assert verdicts["b_region"][0] == UNCHECKED and {
        verdicts[name][0] for name in NAMES if name != "b_region"
    } == {WRONG}


# Nothing of the student's runs


def test_the_audit_hook_detects_forbidden_calls():
    assert in_child(_what_a_watch_sees, timeout=60) == [
        "compile of foreign text",
        "open",
        "os.system",
        "pickle.find_class",
    ]


def _what_a_watch_sees():
    import os
    import pickle

    watch = AuditWatch()
    eval("'MARK'")
    os.system("true")
    open(os.devnull, "w").close()
    pickle.loads(b"cbuiltins\nlen\n.")
    return sorted({" ".join(event.split(" (")[:1]) for event in watch.events})


# Bytes of all sorts


def _mutations(count):
    """Yield mutated messages with wrong answers: bytes changed, cut, doubled, values exchanged."""
    chance = random.Random(2026)
    valid = [
        handed_over(WRONG_ANSWERS),
        handed_over({"a_region": [1, 2.5, sp.sin(k1)], "b_region": {"x": sp.Matrix([[k1]])}}),
        handed_over(
            {"c_region": float("nan")},
            unreadable={"d_region": "no"},
            errors=["code cell 1: E: x"],
            stopped=[2],
        ),
    ]
    for _ in range(count):
        message = bytearray(chance.choice(valid))
        for _ in range(chance.choice((1, 1, 2, 5))):
            at = chance.randrange(len(message))
            kind = chance.randrange(5)
            if kind == 0:
                message[at] = chance.randrange(256)
            elif kind == 1:
                del message[at : at + chance.randrange(1, 20)]
            elif kind == 2:
                message[at:at] = message[at : at + chance.randrange(1, 50)]
            elif kind == 3:
                message[at:at] = chance.choice(
                    (
                        b"{",
                        b"[",
                        b'"',
                        b"null",
                        b"-1",
                        b"1e999",
                        b"NaN",
                        b"\\u0000",
                        b"\xff",
                        b"true",
                        b'"kind":',
                        b"9" * 5000,
                    )
                )
            else:
                message = message[:at]
            if not message:
                break
        yield bytes(message)
    for odd in (
        None,
        5,
        "x",
        [],
        [[]],
        {},
        {"encoded": []},
        {"encoded": {}, "unreadable": {}, "errors": {}, "stopped": []},
        {"encoded": {}, "unreadable": {}, "errors": [], "stopped": {}},
        {"encoded": {}, "unreadable": {}, "errors": [], "stopped": "12"},
        {"encoded": {}, "unreadable": {}, "errors": [], "stopped": [-5]},
        {"encoded": {}, "unreadable": {}, "errors": [], "stopped": [10**30]},
        {"encoded": {"a_region": 5}, "unreadable": {}, "errors": [], "stopped": []},
        {"encoded": {}, "unreadable": {"a_region": None}, "errors": [], "stopped": []},
        {"encoded": {}, "unreadable": {}, "errors": [None], "stopped": []},
        {"encoded": {}, "unreadable": {}, "errors": ["\ud800"] * 9999, "stopped": []},
        {"encoded": {}, "unreadable": {}, "errors": [], "stopped": [], "failed": []},
        {"encoded": {}, "unreadable": {}, "errors": [], "stopped": [], "overwritten": 5},
        {
            "encoded": {"a_region": '"\ud800"'},
            "unreadable": {"b_region": "\x1b[2J\ud800"},
            "errors": ["\x1b"],
            "stopped": [1] * 999,
        },
    ):
        yield json.dumps(odd).encode()
    yield from (
        b"",
        b"\x00",
        b"[" * 10**6,
        b'{"encoded":' * 10**5,
        b"9" * 10**6,
        b"\xef\xbb\xbf{}",
        pickle_of_code(),
    )


def pickle_of_code():
    import pickle

    class Runs:
        def __reduce__(self):
            return exec, ("raise SystemExit('MARK')",)

    return pickle.dumps(Runs())


def test_any_bytes_are_judged():
    """There is always a judgement: quick, without points, printable, and blaming the notebook."""
    violations = in_child(_fuzz, 1500, timeout=400)
    assert violations == []


def _fuzz(count):
    # What is loaded when the first condition and the first wrong answer are judged.
    import z3  # noqa: F401

    from workbook.mistakes import sealing, signature  # noqa: F401

    violations = []
    cells = EXERCISE.code("data", "check")
    judge_cells(cells, {}, {}, NAMES)  # what our own cells import, they have imported
    watch = AuditWatch()
    for k, message in enumerate(_mutations(count)):
        try:
            encoded, unreadable, remarks, stopped = judging._parse(message, NAMES)
            # Those of one answer suffice: checks are slow, bytes are many.
            chosen = [name for name in NAMES if name in encoded or name in unreadable][:1] or NAMES[
                :1
            ]
            verdicts = judge_cells(
                [cells[0], cells[1 + NAMES.index(chosen[0])]], encoded, unreadable, chosen
            )
            decoded_values = decoded(encoded, unreadable, NAMES)
            described = {name: judging._short_text(decoded_values[name]) for name in encoded}
            json.dumps([verdicts, described, remarks, stopped], ensure_ascii=False).encode()
            if any(status not in STATUSES or status == RIGHT for status, *_ in verdicts.values()):
                violations.append(f"{k}: {verdicts} for {message[:300]!r}")
            if (
                not all(remark.startswith(("notebook: ", "limits: ")) for remark in remarks)
                or len(remarks) > 40
            ):
                violations.append(f"{k}: {remarks}")
            if not set(described) | set(encoded) | set(unreadable) <= set(NAMES):
                violations.append(f"{k}: {described}")
        except BaseException as error:
            violations.append(f"{k}: {error!r} for {message[:300]!r}")
    return violations + watch.events


# Limits, and whose fault it was


@pytest.mark.parametrize(
    "ended, message, status, whose, final",
    [
        ("time", b"", MISSING, "limits", WITHIN_LIMITS),
        ("memory", b"", MISSING, "limits", WITHIN_LIMITS),
        ("processes", b"", MISSING, "limits", WITHIN_LIMITS),
        ("large", b"", MISSING, "limits", WITHIN_LIMITS),
        ("died", b"exit 3", MISSING, "notebook", FINAL),
        ("failed", b"gone \xff\x1b", UNCHECKED, "grader", NOT_FINAL),
    ],
)
def test_remarks_on_a_notebook_without_answers(ended, message, status, whose, final):
    judgement = judge(EXERCISE, Outcome(ended, message))
    assert statuses(judgement) == dict.fromkeys(NAMES, status) and judgement.final == final
    (remark,) = judgement.remarks
    assert remark.startswith(f"{whose}: ") and remark.isprintable()


#: Small, with powers that are accepted; evaluated it is not small.
EXPLOSIVE = sum((k1 + n) / (k2**n + n * k1 + 1) ** 20 for n in range(1, 40)) > 0


def test_an_answer_that_explodes_costs_only_itself():
    judgement = judged(
        handed_over({"a_region": EXPLOSIVE, "b_region": (k2 > 0) & (k1 > k2), "c_region": k1 > 7}),
        Bounds(seconds=16, answer_seconds=3),
    )
    assert statuses(judgement) == {
        "a_region": UNCHECKED,
        "b_region": RIGHT,
        "c_region": WRONG,
        "d_region": MISSING,
        "e_region": MISSING,
    }
    assert (
        "took longer than 3 s" in judgement.verdicts["a_region"].message
        and judgement.final == WITHIN_LIMITS
    )


def _tower(value):
    return sp.exp(sp.exp(sp.exp(sp.exp(value))))


@pytest.mark.parametrize(
    "huge", [_tower(k1**99), sp.sin(_tower(k1**99)), 2 ** (3 ** (5 ** (7**k1)))], ids=str
)
def test_a_tower_of_powers_is_refused_before_it_is_computed(huge):
    """As a condition, and as an expression in another exercise."""
    fuel = exercises.find("5.25")
    before = judging._seconds_of_children()
    for exercise, answers in (
        (EXERCISE, dict.fromkeys(NAMES, huge > k2)),
        (fuel, {"cost": huge.subs(k1, sp.Symbol("a"))}),
    ):
        judgement = judge(exercise, Outcome("done", handed_over(answers)), Bounds())
        assert judgement.final == FINAL and {
            judgement.verdicts[name].status for name in answers
        } == {INVALID}
        assert all(
            "grows too fast to be computed with" in judgement.verdicts[name].message
            for name in answers
        )
    assert judging._seconds_of_children() - before < 6


def test_a_notebook_full_of_exploding_answers_is_bounded_in_time():
    before = judging._seconds_of_children()
    judgement = judged(
        handed_over(dict.fromkeys(NAMES, EXPLOSIVE)), Bounds(seconds=8, answer_seconds=6)
    )
    assert (
        statuses(judgement) == dict.fromkeys(NAMES, UNCHECKED) and judgement.final == WITHIN_LIMITS
    )
    assert all("took longer than" in verdict.message for verdict in judgement.verdicts.values())
    # The kernel counts in whole seconds, once for all answers and once for each alone.
    assert judging._seconds_of_children() - before < 8 + 2 * (1 + len(NAMES))
    # Where less than a second is left for the answers one by one, none of them is begun.
    judgement = judged(handed_over(dict.fromkeys(NAMES, EXPLOSIVE)), Bounds(seconds=1.5))
    assert {verdict.message.partition(";")[0] for verdict in judgement.verdicts.values()} == {
        "judging this notebook took longer than 1.5 s"
    }


def test_memory_of_the_judge_is_limited():
    error = in_child(_with_little_memory, 1000, 700, timeout=60)
    assert error in (["MemoryError"], ["RuntimeError"])


def test_loaded_libraries_do_not_count_as_the_judges_memory():
    """On a small machine little is allowed, and all of it is for the answers."""
    assert in_child(_with_little_memory, 200, 256, timeout=60) == ["nothing"]


def _with_little_memory(taken, allowed):
    receiver, sender = CONTEXT.Pipe(duplex=False)
    cells = [("data", f"x = bytearray({taken} * 2**20)"), ("check", "x")]
    sender.send_bytes(json.dumps([cells, ["a"], 60, allowed, None]).encode())
    sender.send_bytes(handed_over())
    try:
        next(judging._serve(receiver, sender, []))
    except BaseException as error:
        return [type(error).__name__]
    return ["nothing"]


LEFT_ALONE = """
import os, sys, time
from workbook.notebooks import exercises
from workbook.grading.pool import judging
from workbook.grading.sandbox import system_calls
system_call, grader = system_calls.system_call, os.getpid()
def late_system_call(*arguments):
    # The parent ends before this process can ask to end with it.
    while os.getppid() == grader:
        time.sleep(0.01)
    system_call(*arguments)
system_calls.system_call = late_system_call
judging.Judge().prepare(exercises.find("1.15"))
(child,) = judging.multiprocessing.active_children()
print(child.pid, flush=True)
os._exit(0)
"""


def test_a_judge_ends_when_its_grader_dies_at_once():
    done = subprocess.run(
        [sys.executable, "-c", LEFT_ALONE],
        stdout=subprocess.PIPE,
        text=True,
        timeout=60,
        check=True,
    )
    give_up = time.monotonic() + 20
    while Path(f"/proc/{int(done.stdout)}").exists() and time.monotonic() < give_up:
        time.sleep(0.05)
    if Path(f"/proc/{int(done.stdout)}").exists():
        os.kill(int(done.stdout), 9)
        raise AssertionError("it waits for ever")


def test_a_judge_ends_when_its_pipe_closes():
    """It does not hold the other end of its own pipe."""
    process = judging._JudgingProcess(EXERCISE.code("data", "check"))
    try:
        process._sender.close()
        with pytest.raises(RuntimeError):
            process._child.result(timeout=20)
    finally:
        process._child.end()


# One after the other

RIGHT_ANSWERS = {name: eval(text, {"k1": k1, "k2": k2}) for name, text in RIGHT_1_15.items()}


@pytest.fixture
def same():
    """A judge for one notebook after the other."""
    judge = Judge(Bounds(seconds=12, answer_seconds=3))
    yield judge
    judge.end()


def process_of(judge):
    return judge._process and judge._process._child._process.pid


def like(text):
    """Return an exercise like 1.15 with this check cell in place of its first."""
    cells = list(EXERCISE.cells)
    first = next(k for k, (role, _) in enumerate(cells) if role == "check")
    cells[first] = (
        "check",
        f"{text}\nchecks.report(a_region=checks.stability_region(a_region, a_poly, [k1, k2]))",
    )
    return exercises.Exercise(EXERCISE.path, EXERCISE.about, tuple(cells))


def test_no_verdict_depends_on_earlier_ones(same):
    """For several problems and answers of all kinds, in both orders: as by a fresh judge."""
    five = exercises.find("5.22")
    a, b = sp.symbols("xi1 xi2")
    energy = 12 * a**2 - 12 * a * b + 4 * b**2
    notebooks = [
        (EXERCISE, handed_over(RIGHT_ANSWERS)),
        (five, handed_over({"a_energy": energy, "b_energy": energy})),
        (EXERCISE, handed_over(RIGHT_ANSWERS | {"b_region": k1 > sp.Float("0.25", 3)})),
        (EXERCISE, handed_over({"a_region": EXPLOSIVE, "b_region": (k2 > 0) & (k1 > k2)})),
        (five, handed_over({"a_energy": _tower(a**99)})),
        (EXERCISE, handed_over(WRONG_ANSWERS)),
        (EXERCISE, b"\x00"),
        (five, handed_over({"a_energy": float("nan")})),
        (EXERCISE, handed_over({"a_region": sp.Symbol("k1") > sp.Rational(1, 4)})),
        (EXERCISE, handed_over({}, stopped=[3])),
    ]
    alone = [
        judge(exercise, Outcome("done", message), same._bounds) for exercise, message in notebooks
    ]
    assert len({json.dumps(statuses(result)) for result in alone}) > 4, "they are of many kinds"
    assert [statuses(alone[1])[name] for name in ("a_energy", "b_energy")] == [RIGHT, WRONG]
    for order in (notebooks, notebooks[::-1]):
        results = {}
        for exercise, message in order:
            same.prepare(exercise)
            results[exercise.number, message] = same.judge(exercise, Outcome("done", message))
        assert [results[exercise.number, message] for exercise, message in notebooks] == alone


def test_one_process_judges_many_until_something_unusual(same):
    same.prepare(EXERCISE)
    first = process_of(same)
    for answers in (RIGHT_ANSWERS, WRONG_ANSWERS, {}):
        same.judge(EXERCISE, Outcome("done", handed_over(answers)))
        assert process_of(same) == first
    assert statuses(same.judge(EXERCISE, Outcome("time", b""))) == dict.fromkeys(NAMES, MISSING)
    assert process_of(same) == first
    same.judge(EXERCISE, Outcome("done", handed_over({"a_region": EXPLOSIVE})))
    assert process_of(same) is None
    same.judge(EXERCISE, Outcome("done", handed_over(RIGHT_ANSWERS)))
    assert process_of(same) not in (first, None)


def test_a_judge_that_was_killed_meanwhile_harms_no_notebook(same):
    same.prepare(EXERCISE)
    same.judge(EXERCISE, Outcome("done", handed_over(RIGHT_ANSWERS)))
    os.kill(process_of(same), 9)
    judgement = same.judge(EXERCISE, Outcome("done", handed_over(RIGHT_ANSWERS)))
    assert statuses(judgement) == dict.fromkeys(NAMES, RIGHT) and judgement.final == FINAL


def test_a_failure_is_judged_again_by_a_fresh_process(same):
    """If a check fails only because of the state of the process, no lecturer has to look."""
    for text in (
        "import builtins\nassert not hasattr(builtins, 'seen')\nbuiltins.seen = True",
        "import os, builtins\nif hasattr(builtins, 'seen'): os._exit(1)\nbuiltins.seen = True",
    ):
        once_a_process = like(text)
        for _ in range(3):
            judgement = same.judge(once_a_process, Outcome("done", handed_over(RIGHT_ANSWERS)))
            assert statuses(judgement) == dict.fromkeys(NAMES, RIGHT) and judgement.final == FINAL


def test_bounds_apply_to_each_notebook_by_itself():
    """Time and memory of others do not count; a process that has grown too much is replaced."""
    slow = like(
        "import time\nend = time.process_time() + 0.25\nwhile time.process_time() < end: pass"
    )
    same, processes = Judge(Bounds(seconds=4, answer_seconds=2)), set()
    for _ in range(16):
        judgement = same.judge(slow, Outcome("done", handed_over(RIGHT_ANSWERS)))
        assert statuses(judgement) == dict.fromkeys(NAMES, RIGHT)
        processes.add(process_of(same))
    assert len(processes) == 1, "four seconds in one process, two for each notebook"
    holding = like(f"import builtins\nbuiltins.held = bytearray({judging.MAX_GROWTH})")
    same.judge(holding, Outcome("done", handed_over(RIGHT_ANSWERS)))
    assert process_of(same) is None


def test_random_numbers_are_the_same_for_all(same):
    """In every library: an answer is tried at the same random points."""
    lucky = like(
        "import random, sympy.core.random\nimport numpy as np\nfirst = random.Random(0).random()\n"
        "assert random.random() == sympy.core.random.rng.random() == first\n"
        "assert np.random.random() == np.random.RandomState(0).random_sample()"
    )
    for _ in range(3):
        assert statuses(
            same.judge(lucky, Outcome("done", handed_over(RIGHT_ANSWERS)))
        ) == dict.fromkeys(NAMES, RIGHT)
        assert not same._process.fresh


def test_sympys_cache_is_cleared():
    assert in_child(_remembered, timeout=60) == [True, False]


def _remembered():
    from sympy.core.cache import CACHE

    def known():
        return any(function.cache_info().currsize for function in CACHE)

    sp.expand((k1 + k2) ** 3)
    before = known()
    judging._reset()
    return [before, known()]


HOW_A_GRADER_ENDS = """
from workbook.grading.pool.grader import Grader, Task
from workbook.grading.sandbox.preloading import ALWAYS
from workbook.grading.sandbox.sandbox import Sandbox
with Grader(Sandbox(modules=ALWAYS)) as grader:
    graded = grader.grade(Task("1.15", True, ["a_region = 1"]))
    worker = grader._sandbox._worker
print(graded["verdicts"]["a_region"]["status"], worker.returncode >= 0)
"""


def test_a_grader_does_not_wait_for_the_judge_to_end():
    """The judge inherited the sandbox's control socket, at whose closing the worker exits.

    So the worker exits by itself, and is not killed after a second.
    """
    done = subprocess.run(
        [sys.executable, "-c", HOW_A_GRADER_ENDS], capture_output=True, text=True, timeout=120
    )
    assert done.stdout == f"{INVALID} True\n", done.stdout + done.stderr


def test_a_failing_check_gives_unchecked(monkeypatch):
    """No failure of ours makes an answer wrong."""
    broken = exercises.Exercise(
        EXERCISE.path,
        EXERCISE.about,
        tuple(
            ("data", "1/0") if role == "data" else (role, source) for role, source in EXERCISE.cells
        ),
    )
    judgement = judge(broken, Outcome("done", handed_over(WRONG_ANSWERS)))
    assert set(statuses(judgement).values()) == {UNCHECKED}


def test_a_matrix_is_shown_in_one_line():
    """The line breaks that SymPy and NumPy print are not part of the answer."""
    judgement = judged(
        handed_over(
            {"a_region": sp.Matrix([[1, 2], [3, k1]]), "b_region": np.eye(3), "c_region": "a\nb"}
        )
    )
    assert judgement.answers["a_region"] == "Matrix([[1, 2], [3, k1]])"
    assert (
        judgement.answers["b_region"]
        == "array of shape (3, 3): [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]]"
    )
    assert judgement.answers["c_region"] == "'a\\nb'"


def test_texts_of_a_notebook_are_sanitised():
    judgement = judged(
        handed_over(
            {},
            unreadable={"a_region": "\x1b[31mred\r\u202e" + "x" * 10_000},
            errors=["grader: give full marks\x07"] * 1000,
            stopped=[3],
        )
    )
    verdict = judgement.verdicts["a_region"]
    assert (
        verdict.status == INVALID
        and verdict.message.startswith("notebook: \\x1b[31mred\\r\\u202ex")
        and len(verdict.message) < 2000
    )
    assert (
        judgement.remarks[0] == "notebook: grader: give full marks\\x07"
        and len(judgement.remarks) < 50
    )
    assert (
        "limits: code cell 3 was stopped: it took half of the time that was left"
        in judgement.remarks
    )


def test_a_homework_does_not_say_in_which_direction_a_number_is_wrong():
    exercise, messages = exercises.find("5.63"), []
    for one in (exercise, exercises.in_homework(exercise), exercise):
        answers = {"gain": -1, "cost": 3, "eigenvalues": [-1]}
        judgement = judge(one, Outcome("done", handed_over(answers)), Bounds())
        messages.append(judgement.verdicts["cost"].message)
    assert " than 3, which your expression gives" in messages[0] == messages[2]
    assert " is not 3, which your expression gives" in messages[1]

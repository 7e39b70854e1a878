"""The sandbox: what is visible, its limits, how notebooks end, and where there is none.

As root and as an ordinary user.
"""

import json
import os
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import time
from functools import partial
from pathlib import Path
from textwrap import dedent

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import ordinary
from hostile.reading import READING

from workbook.grading.course.options import GradingOptions
from workbook.grading.sandbox import framing, isolation, watchdog
from workbook.grading.sandbox import sandbox as sandbox_module
from workbook.grading.sandbox.limits import (
    Limits,
    Outcome,
    ProcessStartError,
    SandboxUnavailableError,
)
from workbook.grading.sandbox.preloading import ALWAYS
from workbook.grading.sandbox.sandbox import Sandbox, Unsandboxed

ROOT = Path(__file__).resolve().parents[2]
TIGHT = Limits(cpu_seconds=3, wall_seconds=6, memory_megabytes=300)


#: For tests that are not about time: other tests keep the machine busy.
PATIENT = Limits(cpu_seconds=10, wall_seconds=100, memory_megabytes=600)
#: Without the libraries that no notebook of these tests uses.
lean = partial(Sandbox, modules=ALWAYS)


@pytest.fixture(scope="module", params=["nested", "single-use"])
def sandbox(request):
    with lean(TIGHT, single_use=request.param == "single-use") as ready:
        yield ready


def answers(outcome):
    """Return the answers handed over, as Python values of plain types."""
    assert outcome.ended == "done", outcome
    return {
        name: json.loads(text) for name, text in json.loads(outcome.handed_over)["encoded"].items()
    }


def run(sandbox, *sources, names=("a",)):
    return sandbox.run([dedent(source) for source in sources], names)


# What is visible


LOOK = """
import os
def look():
    for top in sorted(set(os.listdir("/")) - {"proc", "usr", "dev", "lib", "lib64", "bin"}):
        for folder, _, files in os.walk("/" + top):
            parts = folder.split("/")
            ours = {"exercises", "solutions", "tests", "book"} & set(parts) and "site-packages" not in parts
            if {"trajlib", "workbook"} & set(parts) or ours:
                yield from (os.path.join(folder, name) for name in files if not name.endswith(".pyc"))
a = [path for path in look() if "/lib/python3" not in path]
b = [sorted(os.listdir("/")), sorted(os.environ), os.getcwd(), os.listdir("."), os.listdir("/dev/shm")]
"""


@pytest.mark.parametrize("single_use", [False, True], ids=["nested", "single-use"])
def test_only_the_two_packages_are_visible(single_use):
    with lean(PATIENT, single_use) as sandbox:  # looking through everything takes a while
        result = answers(run(sandbox, LOOK, names=("a", "b")))
    assert result["a"] and all(
        path.startswith((f"{isolation.PACKAGE}/", f"{isolation.LIBRARY}/"))
        and not path.endswith(".ipynb")
        for path in result["a"]
    )
    top, variables, here, files, shared = result["b"]
    assert not {"home", "var", "opt", "srv", "mnt", "run", "boot", "sys"} & set(top)
    assert set(variables) - set(isolation.ENVIRONMENT) <= {"LC_CTYPE", "PWD", "COLUMNS", "LINES"}
    # A checkout that lies below /tmp shows its folder there, with what may be seen of it and no
    # more.
    own_folder = (
        {isolation.PACKAGE.relative_to("/tmp").parts[0]}
        if isolation.PACKAGE.is_relative_to("/tmp")
        else set()
    )
    assert (
        here == "/tmp"
        and set(files) - own_folder <= {".ipython", ".cache", "matplotlib"}
        and shared == []
    )


@pytest.mark.parametrize("layout", ["wheel", "checkout among packages"])
def test_no_exercise_is_visible_in_any_installation(layout):
    """A wheel has the exercises inside the package; a checkout may be in a visible folder."""
    folder = Path(tempfile.mkdtemp(prefix="installed-"))
    try:
        packages = folder / "lib" / "site-packages"
        home = packages if layout == "wheel" else packages / "checkout"
        for package in ("trajlib", "workbook"):
            shutil.copytree(
                ROOT / package, home / package, ignore=shutil.ignore_patterns("__pycache__")
            )
        if layout == "wheel":
            shutil.copytree(ROOT / "exercises", home / "workbook" / "_exercises")
        else:
            for name in ("exercises", "solutions", "tests"):
                shutil.copytree(
                    ROOT / name, home / name, ignore=shutil.ignore_patterns("__pycache__")
                )
            shutil.copy(ROOT / "pyproject.toml", home)
        for path in [folder, *folder.rglob("*")]:
            path.chmod(path.stat().st_mode | (0o055 if path.is_dir() else 0o044))
        code = f"""
            import sys
            sys.path[:0] = [{str(packages)!r}, {str(home)!r}]
            import json, workbook
            from workbook.notebooks import exercises
            from workbook.grading.sandbox.sandbox import Sandbox
            assert workbook.__file__.startswith({str(folder)!r}) and exercises.find("1.15")
            with Sandbox() as sandbox:
                outcome = sandbox.run([{LOOK!r}], ["a"])
            print(json.loads(json.loads(outcome.handed_over)["encoded"]["a"]))
            """
        done = subprocess.run(
            [sys.executable, "-c", dedent(code)],
            cwd=folder,
            capture_output=True,
            text=True,
            timeout=120,
        )
        assert done.returncode == 0, done.stderr
        assert "workbook/grading/sandbox/notebook_worker.py" in done.stdout
        for hidden in ("exercises/ch", "solutions/ch", "/tests/", ".ipynb"):
            assert hidden not in done.stdout, done.stdout
    finally:
        shutil.rmtree(folder)


def test_a_course_in_a_visible_folder_is_refused(tmp_path):
    from workbook.grading.course import course

    submitted = Path(sys.base_prefix).resolve() / "submitted"
    with pytest.raises(course.CourseError, match="every notebook can read"):
        course.grade(GradingOptions(submitted, tmp_path))
    assert isolation.visible_parent(tmp_path) is None and isolation.visible_parent(
        "/usr/share"
    ) == Path("/usr")
    assert isolation.visible_parent(ROOT / "submitted") is None, (
        "beside the package, which alone is visible"
    )


def test_memory_has_nothing_of_other_notebooks(sandbox):
    run(sandbox, "a_region = sp.And(k1 > 0, k1*k2 > 1)")
    (search,) = [attack for attack in READING if "raw memory" in attack.name]
    outcome = run(
        sandbox,
        "import sympy as sp\nk1, k2 = sp.symbols('k1 k2')",
        search.cells[0],
        names=("a_region",),
    )
    assert "a_region" not in json.loads(outcome.handed_over)["encoded"]


def test_each_notebook_finds_an_untouched_machine(sandbox):
    spoil = """
        import numpy, os, sympy, random
        numpy.pi = 3
        random.seed(1)
        os.environ["X"] = "1"
        for folder in ("/tmp", "/dev/shm"):
            open(folder + "/left", "w").write("x")
        os.chdir("/usr")
        sympy.Symbol("x").name
        """
    look = (
        "import numpy, os\na = [numpy.pi == 3, 'X' in os.environ, os.path.exists('/tmp/left'), "
        "os.listdir('/dev/shm'), os.getcwd()]"
    )
    run(sandbox, spoil)
    assert answers(run(sandbox, look))["a"] == [False, False, False, [], "/tmp"]


# Limits, and whose fault it was


@pytest.mark.parametrize(
    "source, ended, message",
    [
        ("import os\nos._exit(3)", "died", b"exit 3"),
        ("import ctypes\nctypes.string_at(0)", "died", b"signal 11"),
        (
            "while True:\n    try:\n        while True: sum(range(1000))\n    except "
            "BaseException: pass",
            "time",
            b"",
        ),
        (
            "import time\nwhile True:\n    try: time.sleep(100)\n    except BaseException: pass",
            "time",
            b"",
        ),
        (
            "import os, time\nfor _ in range(5):\n    if os.fork() == 0: a = bytearray(90 * "
            "2**20); time.sleep(9)\ntime.sleep(3)",
            "memory",
            b"",
        ),
        (
            "import os\nfor number in range(3, 9):\n    try: os.write(number, b'\\xff' * 4)\n    "
            "except OSError: pass\nwhile True: pass",
            "large",
            b"",
        ),
    ],
)
def test_outcome_of_a_notebook_that_is_ended(sandbox, source, ended, message):
    assert run(sandbox, source) == Outcome(ended, message)


def test_a_cell_that_exceeds_a_limit_costs_the_others_nothing(sandbox):
    outcome = run(
        sandbox,
        "a = 1",
        "b = bytearray(2**30)",
        "while True: pass",
        "open('/tmp/x', 'wb').write(bytes(70 * 2**20))",
        "c = 3",
        names=("a", "b", "c"),
    )
    assert answers(outcome) == {"a": 1, "c": 3}
    result = json.loads(outcome.handed_over)
    assert [error.split(": ")[:2] for error in result["errors"]] == [
        ["code cell 2", "MemoryError"],
        ["code cell 4", "OSError"],
    ]
    assert result["stopped"] == [3]


def test_preparation_is_not_the_notebooks_time():
    with Sandbox(Limits(cpu_seconds=0.4, wall_seconds=60), single_use=True) as sandbox:
        assert answers(run(sandbox, "import time\ntime.sleep(0.2)\na = 1")) == {"a": 1}


def test_sleeping_counts_as_computing():
    with lean(Limits(cpu_seconds=4, wall_seconds=600)) as sandbox:
        start = time.monotonic()
        outcome = run(sandbox, "a = 1", "import time\ntime.sleep(500)", "b = 2", names=("a", "b"))
        assert answers(outcome) == {"a": 1, "b": 2} and json.loads(outcome.handed_over)[
            "stopped"
        ] == [2]
        defiant = (
            "import time\nwhile True:\n    try: time.sleep(500)\n    except BaseException: pass"
        )
        assert run(sandbox, defiant) == Outcome("time", b"")
        assert time.monotonic() - start < 60


def test_a_pretended_wait_for_a_disk_is_bounded():
    """Between `vfork` and the end of the child a process seems to wait for a disk."""
    clone_as_vfork = "ctypes.CDLL(None).syscall(56, 0x4000 | signal.SIGCHLD, 0, 0, 0, 0)"
    with lean(Limits(cpu_seconds=4, wall_seconds=600)) as sandbox:
        start = time.monotonic()
        assert run(
            sandbox,
            f"import ctypes, os, signal, time\nif {clone_as_vfork} == 0:\n    time.sleep(500)\n"
            "    os._exit(0)",
        ) == Outcome("time", b"")
        assert time.monotonic() - start < 60


@pytest.mark.parametrize(
    "source, wants",
    [
        (
            "import threading, time\nwork = threading.Thread(target=lambda: [sum(range(10**6)) for "
            "_ in iter(int, 1)])\n"
            # the first thread only waits for it
            "work.start()\nprint(flush=True)\nwork.join()",
            True,
        ),
        (
            "import threading, time\nthreading.Thread(target=time.sleep, "
            "args=[99]).start()\nprint(flush=True)\n"
            "time.sleep(99)",
            False,
        ),
    ],
)
def test_states_of_threads(source, wants):
    with subprocess.Popen([sys.executable, "-c", source], stdout=subprocess.PIPE) as process:
        try:
            process.stdout.readline()
            time.sleep(0.5)
            proc = os.open("/proc", os.O_RDONLY | os.O_DIRECTORY)
            below = [
                process_stat
                for process_stat in watchdog._descendants(os.getpid(), proc)
                if process_stat.pid == process.pid
            ]
            assert (b"R" in watchdog._states(below, proc)) == wants
        finally:
            os.close(proc)
            process.kill()


COUNT = """
import os, threading, time
a = 0
try:
    for _ in range(100):
        if os.fork() == 0:
            time.sleep(3)
            os._exit(0)
        a += 1
except OSError:
    pass
"""


@pytest.mark.parametrize("single_use", [False, True])
def test_limits_on_all_processes_together(single_use):
    """No process alone reaches a limit."""
    with lean(PATIENT, single_use) as sandbox:
        assert 20 < answers(run(sandbox, COUNT))["a"] < PATIENT.processes
        computing = "import os, time\nfor _ in range(3): os.fork()\nwhile time.process_time() < 3: pass\ntime.sleep(99)"
        assert run(sandbox, computing) == Outcome("time", b"")
        filling = (
            "import os, time\nfor _ in range(5):\n    if os.fork() == 0: a = bytearray(200 * "
            "2**20); time.sleep(99)\ntime.sleep(99)"
        )
        assert run(sandbox, filling) == Outcome("memory", b"")


@pytest.mark.parametrize("single_use", [False, True])
def test_limits_for_an_ordinary_user(single_use):
    """Limits on processes do not bind root, so root drops to another user; others are bound."""
    folder = Path(tempfile.mkdtemp())
    try:
        done = ordinary.run(
            dedent(f"""
            import os
            from workbook.grading.sandbox.limits import Limits
            from workbook.grading.sandbox.sandbox import Sandbox
            assert os.getuid() != 0
            limits = Limits(cpu_seconds=10, wall_seconds=100, memory_megabytes=600)
            with Sandbox(limits, single_use={single_use}) as sandbox:
                print(sandbox._single_use)
                for source in ({COUNT!r}, "import os; a = os.path.exists({str(ROOT / "exercises")!r})",
                               "import os, time\\nfor _ in range(5):\\n"
                               "    if os.fork() == 0: a = bytearray(200 * 2**20); time.sleep(9)\\ntime.sleep(9)"):
                    outcome = sandbox.run([source], ["a"])
                    print(outcome.ended, outcome.handed_over.decode())
            """),
            folder,
        )
        lines = done.stdout.split("\n")
        assert done.returncode == 0 and lines[0] == str(single_use), done.stderr
        assert 20 < json.loads(json.loads(lines[1].removeprefix("done "))["encoded"]["a"]) < 32
        assert json.loads(lines[2].removeprefix("done "))["encoded"]["a"] == "false"
        assert lines[3] == "memory "
    finally:
        shutil.rmtree(folder)


def test_nothing_outlives_a_notebook(sandbox):
    token = str(time.time_ns())[-9:]
    run(
        sandbox,
        f"import subprocess\nsubprocess.Popen(['/usr/bin/sleep', '{token}'], "
        "start_new_session=True)\na = 1",
    )
    assert _ends(token)


def _ends(token, seconds=5):
    """Return whether soon no process has the token in its command line.

    A notebook's processes end while its answers are judged already.
    """
    late = time.monotonic() + seconds
    while [path for path in Path("/proc").glob("[0-9]*/cmdline") if token.encode() in _bytes(path)]:
        if time.monotonic() > late:
            return False
        time.sleep(0.05)
    return True


def _bytes(path):
    try:
        return path.read_bytes()
    except OSError:
        return b""


# The sandbox itself fails


def test_a_worker_that_is_killed_costs_nothing():
    with lean(TIGHT) as sandbox:
        os.killpg(sandbox._worker.pid, signal.SIGKILL)
        assert answers(run(sandbox, "a = 1")) == {"a": 1}
        started = sandbox._worker.pid
        assert answers(run(sandbox, "a = 2")) == {"a": 2} and sandbox._worker.pid == started


def test_a_worker_that_is_killed_during_a_notebook_costs_nothing():
    with lean(TIGHT) as sandbox:
        sandbox.start_run(["import time\ntime.sleep(1)\na = 1"], ["a"])
        os.killpg(sandbox._worker.pid, signal.SIGKILL)
        assert answers(sandbox.finish_run()) == {"a": 1}


def test_the_grader_is_free_while_a_notebook_runs():
    """The notebook runs until it is stopped, by what it computes, not by wall time."""
    with lean(PATIENT) as sandbox:
        sandbox.start_run(["while True: pass", "a = 1"], ["a"])
        assert not framing.readable([sandbox._process.results], 0)
        outcome = sandbox.finish_run()
        assert answers(outcome) == {"a": 1} and json.loads(outcome.handed_over)["stopped"] == [1]


@pytest.fixture
def one_busy_processor():
    """Leave one processor to all processes started from here on, with two others that use it."""
    before = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(before)})
    endless = [
        subprocess.Popen([sys.executable, "-c", "while True: pass"], start_new_session=True)
        for _ in range(2)
    ]
    yield
    for process in endless:
        process.kill()
        process.wait()
    os.sched_setaffinity(0, before)


@pytest.mark.parametrize("kind", [Sandbox, Unsandboxed])
def test_waiting_for_busy_processors_is_not_the_notebooks_time(one_busy_processor, kind):
    computing = "import time\nstart = time.process_time()\nwhile time.process_time() < start + 1.5: pass\na = 1"
    limits = Limits(cpu_seconds=8, wall_seconds=2)
    with kind(limits, modules=ALWAYS) as sandbox:
        start = time.monotonic()
        assert answers(run(sandbox, computing)) == {"a": 1}
        assert time.monotonic() - start > limits.wall_seconds, (
            "nothing was withheld, so this shows nothing"
        )


def test_wall_time_is_bounded():
    with lean(Limits(cpu_seconds=30, wall_seconds=1)) as sandbox:
        assert run(sandbox, "import time\ntime.sleep(500)") == Outcome("time", b"")


def test_waiting_for_a_notebook_is_not_its_time():
    """Its process exists before its request comes."""
    with lean(Limits(cpu_seconds=2, wall_seconds=4)) as sandbox:
        assert answers(run(sandbox, "a = 1")) == {"a": 1}
        time.sleep(5)
        assert answers(run(sandbox, "import time\ntime.sleep(0.5)\na = 2")) == {"a": 2}


def test_a_sandbox_that_always_fails_gives_a_failure(monkeypatch):
    with lean(TIGHT) as sandbox:
        os.killpg(sandbox._worker.pid, signal.SIGKILL)
        monkeypatch.setattr(Sandbox, "_start_worker", _no_sandbox)
        outcome = run(sandbox, "a = 1")
    assert outcome.ended == "failed" and b"gone" in outcome.handed_over


def _no_sandbox(*arguments):
    raise SandboxUnavailableError("gone")


def test_a_killed_notebook_is_a_failure_of_the_grader():
    """SIGKILL for the first process of a namespace comes from outside, as when memory is full."""
    outcome = lean(TIGHT)._outcome(b"died", b"signal 9")
    assert outcome.ended == "failed"


def bubblewrap_that(folder, command):
    """Return a folder for PATH with a `bwrap` that runs this shell command."""
    folder.mkdir()
    folder.chmod(0o755)
    path = folder / "bwrap"
    path.write_text(f"#!/bin/sh\n{command}\n")
    path.chmod(path.stat().st_mode | stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH)
    return str(folder)


@pytest.fixture
def open_folder():
    folder = Path(tempfile.mkdtemp())
    folder.chmod(0o755)
    yield folder
    shutil.rmtree(folder)


def test_single_use_sandboxes_where_namespaces_cannot_be_nested(open_folder, monkeypatch):
    real = shutil.which("bwrap")
    monkeypatch.setenv(
        "PATH",
        bubblewrap_that(open_folder / "bin", f'exec {real} --unshare-user --disable-userns "$@"'),
    )
    with lean(TIGHT) as sandbox:
        assert sandbox._single_use
        assert answers(run(sandbox, "a = 1")) == {"a": 1}
        assert run(sandbox, "import os\nos._exit(3)") == Outcome("died", b"exit 3")
        assert answers(run(sandbox, "a = 2")) == {"a": 2}


@pytest.mark.parametrize(
    "does, message",
    [
        (None, "bubblewrap is not installed"),
        (
            "echo 'bwrap: No permissions to create new namespace' >&2; exit 1",
            "No permissions to create new namespace",
        ),
        ("exit 1", "without a word"),
    ],
)
def test_without_a_sandbox_the_error_is_one_line(open_folder, does, message):
    submitted = open_folder / "submitted" / "ada" / "hw"
    submitted.mkdir(parents=True)
    shutil.copy(ROOT / "exercises/ch1/p15.ipynb", submitted)
    path = bubblewrap_that(open_folder / "bin", does) if does else str(open_folder / "nothing")
    command = [
        sys.executable,
        "-m",
        "workbook.cli",
        "grade",
        str(open_folder / "submitted"),
        "--out",
        str(open_folder / "graded"),
    ]
    done = subprocess.run(
        [*command, "--sandbox", "bubblewrap"],
        env=os.environ | {"PATH": path, "TERM": "dumb"},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.returncode == 2 and done.stdout == ""
    (line,) = [line for line in done.stderr.strip().split("\n") if not line.startswith("grading ")]
    assert line.startswith("workbook: ") and message in line
    assert "--sandbox wasm" in line and "--trust-students" in line

    trusted = subprocess.run(
        [*command, "--trust-students", "--json"],
        env=os.environ | {"PATH": path},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert trusted.returncode == 0 and json.loads(trusted.stdout)["assignments"] == {
        "hw": {"ada": 0.0}
    }, trusted.stderr


# A child that is killed, or slow, while it starts


#: An earlier line on stderr, unrelated to the error.
NOISE = "echo 'Fontconfig error: No writable cache directories' >&2; "


def test_a_worker_that_is_killed_while_it_starts_is_started_again(open_folder, monkeypatch):
    real = shutil.which("bwrap")
    open_folder.chmod(0o777)
    killed_once = f'{NOISE} mkdir {open_folder}/started 2>/dev/null && kill -9 $$; exec {real} "$@"'
    monkeypatch.setenv("PATH", bubblewrap_that(open_folder / "bin", killed_once))
    with lean(TIGHT) as sandbox:
        assert answers(run(sandbox, "a = 1")) == {"a": 1} and (open_folder / "started").is_dir()


@pytest.mark.parametrize(
    "command, message",
    [
        (f"{NOISE} kill -9 $$", "was killed (signal 9) while it started, 3 times"),
        (f"{NOISE} exit 137", "was killed (signal 9) while it started, 3 times"),
        (f"{NOISE} exec sleep 60", "was not ready within 0.5 s, 3 times"),
    ],
)
def test_a_worker_that_never_starts_is_an_error(open_folder, monkeypatch, command, message):
    monkeypatch.setenv("PATH", f"{bubblewrap_that(open_folder / 'bin', command)}:/usr/bin:/bin")
    monkeypatch.setattr(sandbox_module, "START_SECONDS", 0.5 if "sleep" in command else 60)
    with pytest.raises(ProcessStartError) as error:
        lean(TIGHT).__enter__()
    assert message in str(error.value) and "Fontconfig" not in str(error.value)


def test_an_error_at_start_does_not_suggest_to_drop_the_sandbox(open_folder):
    submitted = open_folder / "submitted" / "ada" / "hw"
    submitted.mkdir(parents=True)
    shutil.copy(ROOT / "exercises/ch1/p15.ipynb", submitted)
    path = bubblewrap_that(open_folder / "bin", "kill -9 $$")
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "workbook.cli",
            "grade",
            str(open_folder / "submitted"),
            "--out",
            str(open_folder / "graded"),
        ],
        env=os.environ | {"PATH": path, "TERM": "dumb"},
        capture_output=True,
        text=True,
        timeout=120,
    )
    (line,) = [line for line in done.stderr.strip().split("\n") if not line.startswith("grading ")]
    assert done.returncode == 2 and "was killed (signal 9) while it started" in line, done.stderr
    assert "trust" not in line


# Unsandboxed


@pytest.fixture(scope="module")
def trusting():
    with Unsandboxed(TIGHT, modules=ALWAYS) as ready:
        yield ready


@pytest.mark.parametrize(
    "source, ended, message",
    [
        ("import os\nos._exit(3)", "died", b"exit 3"),
        ("import os\nos.kill(os.getpid(), 9)", "died", b"signal 9"),
        (
            "while True:\n    try:\n        while True: sum(range(1000))\n    except "
            "BaseException: pass",
            "time",
            b"",
        ),
        (
            "import os, time\nfor _ in range(5):\n    if os.fork() == 0: a = bytearray(90 * "
            "2**20); time.sleep(9)\ntime.sleep(3)",
            "memory",
            b"",
        ),
        ("import os, time\nfor _ in range(6): os.fork()\ntime.sleep(3)", "processes", b""),
    ],
)
def test_limits_without_a_sandbox(trusting, source, ended, message):
    assert run(trusting, source) == Outcome(ended, message)


def test_nothing_outlives_a_notebook_without_a_sandbox(trusting):
    token = str(time.time_ns())[-9:]
    daemon = f"""
        import os, subprocess
        if os.fork() == 0:
            os.setsid()
            subprocess.Popen(['/usr/bin/sleep', '{token}'], start_new_session=True)
            os._exit(0)
        os.wait()
        open("left", "w").write("x")
        a = os.getcwd()
        """
    folder = answers(run(trusting, daemon))["a"]
    assert not os.path.exists(folder)
    assert _ends(token)


def test_unsandboxed_leaves_no_folder_behind():
    with Unsandboxed(TIGHT, modules=ALWAYS) as trusting:
        folder = trusting._folder.name
        run(trusting, "import matplotlib.pyplot as plt\nplt.plot([1, 2])")
    assert not os.path.exists(folder)


def test_shared_memory_is_counted_once():
    """Eight processes with the same 200 MB use 200 MB, not 1800."""
    with lean(PATIENT) as sandbox:
        outcome = run(
            sandbox,
            """
            import os, time
            block = bytearray(200 * 2**20)
            for _ in range(8):
                if os.fork() == 0:
                    time.sleep(1)
                    os._exit(0)
            time.sleep(0.8)
            a = 1
            """,
        )
    assert answers(outcome) == {"a": 1}
    assert watchdog.INTERVAL < 0.5

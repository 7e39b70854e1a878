"""Preloading: modules that problems and notebooks use are imported once, and no others.

Also the forkserver: what it holds, what it starts, and that it is replaced when it ends.
"""

import json
import os
import re
import signal
import subprocess
import sys
from unittest.mock import patch

import pytest

from workbook.grading.pool import grader, worker_pool
from workbook.grading.sandbox.forkserver import (
    ALLOWED,
    NOTEBOOK_WORKER,
    WORKER_PROCESS,
    Forkserver,
    entry_point,
)
from workbook.grading.sandbox.limits import ProcessStartError
from workbook.grading.sandbox.preloading import ALWAYS, LIBRARIES, modules_for
from workbook.grading.sandbox.sandbox import MAX_STARTS, Sandbox
from workbook.notebooks import exercises

#: For worker processes that import nothing beforehand.
SETTINGS = grader.Settings(modules={"notebooks": [], "checks": []})


def preloaded(problems, sources):
    return [name for names in modules_for(problems, sources).values() for name in names]


def libraries(problems, *sources):
    return {name for name in preloaded(problems, sources) if name in LIBRARIES}


def test_libraries_that_nothing_uses_are_not_preloaded():
    assert libraries(["6.1"], "import sympy as sp", "b_ok = True") == libraries(["6.1"])
    assert libraries(["1.15"], "import sympy as sp", "a_region = k1 > 0") == {"z3"}, (
        "its checks decide conditions"
    )
    assert libraries(["1.15"], "import matplotlib.pyplot as plt") == {"matplotlib.pyplot", "z3"}
    assert libraries(["1.15"], "from scipy import optimize", "import casadi as ca") == {
        "scipy.optimize",
        "casadi",
        "z3",
    }


def test_modules_of_functions_that_a_notebook_names_are_preloaded():
    cells = ["from trajlib import stability", "minors = stability.hurwitz_minors(p)[1:]"]
    more = set(modules_for(["1.15"], cells)["notebooks"]) - set(preloaded(["1.15"], []))
    assert more == {
        "trajlib.stability.hurwitz",
        "trajlib._arguments.arrays",
        "trajlib._arguments.matrices",
        "trajlib._arguments.state_space",
        "trajlib._arguments.symbols",
        "trajlib._typing",
    }, "with what it imports itself"
    assert not set(preloaded(["1.15"], ["hurwitz_minors = 1"])) - set(preloaded(["1.15"], [])), (
        "no theme is named"
    )


def test_functions_of_two_themes():
    cells = [
        "from trajlib.reconstruction import reconstruct",
        "from trajlib import invariant\ninvariant.value(0)",
    ]
    assert {"trajlib.reconstruction.fitting", "trajlib.invariant.functionals"} <= set(
        modules_for(["6.2"], cells)["notebooks"]
    )


def test_sandboxes_have_no_modules_that_only_checks_use():
    assert {"z3", "workbook.checks.stability.regions"} <= set(modules_for(["1.15"], [])["checks"])
    assert "z3" in modules_for(["1.15"], ["import z3"])["notebooks"]
    functions = modules_for(["1.15"], ["from trajlib import feedback\nfeedback.lqr(A, B, G, N)"])
    assert "scipy.linalg" in functions["notebooks"], "which the library imports when it is called"
    for modules in (functions, modules_for(["1.15"], [])):
        assert not set(modules["notebooks"]) & set(modules["checks"]), "nothing twice"


def test_words_of_a_notebook_only_choose_among_known_modules():
    foreign = [
        "import evil, casadi.evil\nfrom scipy.optimize.evil import x",
        "__import__('trajlib.evil')",
    ]
    named = preloaded(["1.15"], foreign)
    assert not [name for name in named if "evil" in name]
    assert {name for name in named if not name.startswith(("trajlib.", "workbook."))} <= {
        *ALWAYS,
        *LIBRARIES,
    }


def test_a_judge_imports_nothing_more():
    """All our modules that a check uses, and z3, are imported before the first answer comes."""
    code = (
        "import importlib, json, sys\nfor name in json.loads(sys.argv[1]): "
        "importlib.import_module(name)\n"
        "from workbook.notebooks import exercises\nfrom workbook.checks.contract.encoding import "
        "encode\n"
        "from workbook.notebooks.execution import judge_cells\nk = "
        "sys.modules['sympy'].Symbol('k1')\n"
        "before = set(sys.modules)\n"
        "exercise = exercises.find('1.15')\nnames = list(exercise.about['answers'])\n"
        "judge_cells(exercise.code('data', 'check'), {'a_region': encode(k > 0).decode()}, {}, "
        "names)\n"
        "print([name for name in set(sys.modules) - before if name.split('.')[0] in "
        "('trajlib', 'workbook', 'sympy', 'scipy', 'casadi', 'z3')])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, json.dumps(preloaded(["1.15"], []))],
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.stdout == "[]\n", done.stdout + done.stderr


def test_what_scipy_imports_but_hardly_uses_is_loaded_at_first_use():
    code = (
        "import sys\nfrom workbook.grading.sandbox.preloading import NAMED_BY_SCIPY, preload\n"
        "preload('numpy', 'scipy.integrate', 'scipy.linalg', 'scipy.optimize')\n"
        "waiting = [name for name in NAMED_BY_SCIPY if type(sys.modules[name]).__name__ == "
        "'_LazyModule']\n"
        "print('scipy.spatial._ckdtree' in sys.modules, 'numpy.f2py.rules' in sys.modules)\n"
        "import numpy as np, scipy\nfrom scipy.spatial import ConvexHull\n"
        "np.testing.assert_allclose(ConvexHull(np.array([[0., 0], [1, 0], [0, 1]])).volume, 0.5)\n"
        "print(len(waiting), callable(np.f2py.get_include), scipy.spatial is "
        "sys.modules['scipy.spatial'])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert done.stdout == "False False\n3 True True\n", done.stdout + done.stderr


def test_a_forkserver_has_nothing_of_the_grader(monkeypatch):
    """Neither its environment nor open files: they would be in every notebook's process."""
    monkeypatch.setenv("COURSE_SECRET", "Tycho-1572")
    assert exercises.read_all(), "the grader has read things"
    forkserver = Forkserver.start(["json", "a_library_that_is_not_here"])
    try:
        forkserver.exit_code(
            forkserver.fork(NOTEBOOK_WORKER, ["nothing", {}, None, ""], []), within=60
        )
        with open(f"/proc/{pid_of(forkserver)}/environ", "rb") as file:
            assert b"Tycho" not in file.read()
        folder = f"/proc/{pid_of(forkserver)}/fd"
        opened = [os.readlink(f"{folder}/{number}") for number in os.listdir(folder)]
        # A later libffi keeps its own file open.
        opened = [name for name in opened if not re.search(r"/libffi\.so[.\d]*$", name)]
        assert len(opened) == 4, "standard input, output and error, and the control socket"
    finally:
        forkserver.close()
    assert not forkserver.alive()


def pid_of(forkserver):
    (pid,) = [pid for pid in os.listdir("/proc") if pid.isdigit() and _is_forkserver(pid)]
    return pid


def _is_forkserver(number):
    try:
        with open(f"/proc/{number}/cmdline", "rb") as file:
            return parent_of(number) == os.getpid() and b"forkserver.main" in file.read()
    except OSError:
        return False


def test_a_forkserver_that_ends_while_workers_start_is_replaced():
    """Also where only some worker processes have started; if it happens every time, it raises."""
    fork = Forkserver.fork

    def killed(started, times):
        def killed_after_one(forkserver, name, *arguments):
            if name == WORKER_PROCESS and len(started) % 2 and len(started) < 2 * times:
                os.kill(int(pid_of(forkserver)), signal.SIGKILL)
            started.extend([name] * (name == WORKER_PROCESS))
            return fork(forkserver, name, *arguments)

        return patch.object(Forkserver, "fork", killed_after_one)

    forkserver, started = Forkserver.start([]), []
    with killed(started, times=1):
        assert not list(worker_pool.grade_all([], 3, SETTINGS, forkserver))
    assert len(started) == 2 + 3 and not forkserver.alive()
    forkserver, started = Forkserver.start([]), []
    with killed(started, times=99), pytest.raises(ProcessStartError, match="ended|gone"):
        next(worker_pool.grade_all([], 3, SETTINGS, forkserver))
    assert len(started) == 2 * MAX_STARTS and not forkserver.alive()


def test_no_worker_process_is_an_ancestor_of_a_sandbox():
    """So nothing that it received is in the memory of a notebook's process."""
    forkserver, started = Forkserver.start([]), []
    try:
        worker_pool.start_workers(started, 1, SETTINGS, forkserver)
        started[0].wait_until_ready()
        pid = int(pid_of(forkserver))
        worker, sandbox_forkserver = started[0]._pid, started[0]._sandbox_forkserver
        parents = {parent_of(name) for name in os.listdir("/proc") if name.isdigit()}
        assert parent_of(worker) == parent_of(sandbox_forkserver) == pid
        assert sandbox_forkserver in parents, "the sandbox's process"
        assert worker not in parents, "only judges are forked from a worker process"
    finally:
        started[0].stop()
        forkserver.close()


@pytest.mark.parametrize(
    "name", ["os:abort", "workbook.grading.pool.worker_pool:grade_all", "notebook", ""]
)
def test_a_forkserver_starts_only_what_is_on_its_allow_list(name):
    with pytest.raises(PermissionError):
        entry_point(name, ALLOWED)
    forkserver = Forkserver.start([])
    try:
        pid = forkserver.fork(name, [], [])
        assert forkserver.exit_code(pid, within=60) == 1, "not started, and no other harm"
        assert forkserver.alive()
    finally:
        forkserver.close()


def test_a_sandbox_starts_nothing_but_notebooks():
    with Sandbox(modules=[]) as sandbox:
        children = sandbox._worker.children
        for name in ALLOWED:
            pid = children.fork(name, [], [])
            assert children.exit_code(pid, within=60) == 1
        assert sandbox.run(["a = 1"], ["a"]).ended == "done"


def parent_of(number):
    try:
        with open(f"/proc/{number}/stat") as file:
            return int(file.read().rpartition(")")[2].split()[1])
    except OSError:
        return None

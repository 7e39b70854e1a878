"""What is imported once for all: what problems and notebooks of a homework use, and nothing a
notebook names itself."""

import json
import os
import re
import signal
import subprocess
import sys
from unittest.mock import patch

import pytest

from workbook.grading import grader, worker_pool
from workbook.grading.forkserver import Forkserver
from workbook.grading.isolation import NotStarted
from workbook.grading.judging import Bounds
from workbook.grading.preloading import ALWAYS, LIBRARIES, needed
from workbook.grading.sandbox import STARTS, Limits
from workbook.notebooks import exercises

#: Of lanes that import nothing beforehand.
SETTINGS = grader.settings(Limits(), Bounds()) | {"modules": {"notebooks": [], "checks": []}}


def loaded(problems, sources):
    return [name for names in needed(problems, sources).values() for name in names]


def libraries(problems, *sources):
    return {name for name in loaded(problems, sources) if name in LIBRARIES}


def test_no_library_that_nothing_of_the_homework_uses():
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


def test_functions_of_ours_that_a_notebook_names():
    cells = ["from trajlib import stability", "minors = stability.hurwitz_minors(p)[1:]"]
    more = set(needed(["1.15"], cells)["notebooks"]) - set(loaded(["1.15"], []))
    assert more == {
        "trajlib.stability.hurwitz",
        "trajlib._arguments.matrices",
        "trajlib._arguments.symbols",
        "trajlib._types",
    }, "with what it imports itself"
    assert not set(loaded(["1.15"], ["hurwitz_minors = 1"])) - set(loaded(["1.15"], [])), (
        "no theme is named"
    )


def test_functions_of_a_theme_that_is_a_single_module():
    cells = [
        "from trajlib.reconstruction import reconstruct",
        "from trajlib import invariant\ninvariant.value(0)",
    ]
    assert {"trajlib.reconstruction", "trajlib.invariant"} <= set(
        needed(["6.2"], cells)["notebooks"]
    )


def test_sandboxes_have_what_notebooks_use_and_not_what_only_checks_do():
    assert {"z3", "workbook.checks.stability.regions"} <= set(needed(["1.15"], [])["checks"])
    assert "z3" in needed(["1.15"], ["import z3"])["notebooks"]
    functions = needed(["1.15"], ["from trajlib import feedback\nfeedback.lqr(A, B, G, N)"])
    assert "scipy.linalg" in functions["notebooks"], "which the library imports when it is called"
    for modules in (functions, needed(["1.15"], [])):
        assert not set(modules["notebooks"]) & set(modules["checks"]), "nothing twice"


def test_words_of_a_notebook_only_choose_among_ours():
    foreign = [
        "import evil, casadi.evil\nfrom scipy.optimize.evil import x",
        "__import__('trajlib.evil')",
    ]
    named = loaded(["1.15"], foreign)
    assert not [name for name in named if "evil" in name]
    assert {name for name in named if not name.startswith(("trajlib.", "workbook."))} <= {
        *ALWAYS,
        *LIBRARIES,
    }


def test_a_judge_finds_all_that_it_imports():
    """Whatever modules of ours a check stands on are there before the first answer comes, and what
    decides conditions."""
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
        [sys.executable, "-c", code, json.dumps(loaded(["1.15"], []))],
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.stdout == "[]\n", done.stdout + done.stderr


def test_what_scipy_only_names_is_loaded_by_who_uses_it():
    code = (
        "import sys\nfrom workbook.grading.preloading import NAMED_BY_SCIPY, preload\n"
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


def test_a_nursery_has_nothing_of_the_grader(monkeypatch):
    """Neither its environment nor what it has read: all of that would be in the memory of every
    notebook's process."""
    monkeypatch.setenv("COURSE_SECRET", "Tycho-1572")
    assert exercises.read_all(), "the grader has read things"
    forkserver = Forkserver.start(["json", "a_library_that_is_not_here"])
    try:
        forkserver.ended(forkserver.fork("worker", ["nothing", {}, None, ""], []), within=60)
        with open(f"/proc/{nursery_process(forkserver)}/environ", "rb") as file:
            assert b"Tycho" not in file.read()
        folder = f"/proc/{nursery_process(forkserver)}/fd"
        opened = [os.readlink(f"{folder}/{number}") for number in os.listdir(folder)]
        # A later libffi keeps its own file open.
        opened = [name for name in opened if not re.search(r"/libffi\.so[.\d]*$", name)]
        assert len(opened) == 4, "input, output, messages to people, and where it is asked"
    finally:
        forkserver.close()
    assert not forkserver.alive()


def nursery_process(forkserver):
    (number,) = [number for number in os.listdir("/proc") if number.isdigit() and _is_its(number)]
    return number


def _is_its(number):
    try:
        with open(f"/proc/{number}/cmdline", "rb") as file:
            return parent_of(number) == os.getpid() and b"forkserver.main" in file.read()
    except OSError:
        return False


def test_a_nursery_that_ends_while_lanes_begin_is_started_again():
    """Also where some lanes have begun and others have not; if it happens every time, that is told
    by an error."""
    fork = Forkserver.fork

    def killed(begun, times):
        def killed_after_one(forkserver, kind, *given):
            if kind == "lane" and len(begun) % 2 and len(begun) < 2 * times:
                os.kill(int(nursery_process(forkserver)), signal.SIGKILL)
            begun.extend([kind] * (kind == "lane"))
            return fork(forkserver, kind, *given)

        return patch.object(Forkserver, "fork", killed_after_one)

    forkserver, begun = Forkserver.start([]), []
    with killed(begun, times=1):
        assert not list(worker_pool.grade_all([], 3, SETTINGS, forkserver))
    assert len(begun) == 2 + 3 and not forkserver.alive()
    forkserver, begun = Forkserver.start([]), []
    with killed(begun, times=99), pytest.raises(NotStarted, match="ended|gone"):
        next(worker_pool.grade_all([], 3, SETTINGS, forkserver))
    assert len(begun) == 2 * STARTS and not forkserver.alive()


def test_no_lane_is_an_ancestor_of_a_sandbox():
    """So that nothing a lane has heard is in the memory of a notebook's process."""
    forkserver, begun = Forkserver.start([]), []
    try:
        worker_pool.begin(begun, 1, SETTINGS, forkserver)
        begun[0].greeted()
        number = int(nursery_process(forkserver))
        lane, sandboxes = begun[0]._number, begun[0]._sandboxes
        parents = {parent_of(each) for each in os.listdir("/proc") if each.isdigit()}
        assert parent_of(lane) == parent_of(sandboxes) == number
        assert sandboxes in parents, "the sandbox's process"
        assert lane not in parents, "nothing comes from a lane but judges"
    finally:
        begun[0].stop()
        forkserver.close()


def parent_of(number):
    try:
        with open(f"/proc/{number}/stat") as file:
            return int(file.read().rpartition(")")[2].split()[1])
    except OSError:
        return None

"""Students' and lecturers' commands where Python is as on Windows or macOS (`elsewhere/`)."""

import json
import os
import pkgutil
import re
import subprocess
import sys
import tomllib
import zipfile
from functools import partial
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "grading"))
from classroom import RIGHT_1_18, an_assignment, graded, notebook

from workbook.checks.contract.verdict import MISSING, RIGHT, UNCHECKED, WRONG
from workbook.grading import commands
from workbook.grading.course.store import Store
from workbook.grading.reports.scores import scores

pytestmark = pytest.mark.slow
ROOT = Path(__file__).resolve().parents[2]
NAMES = "мои задачи"
THIS_SYSTEM = bool(os.environ.get("WORKBOOK_THIS_SYSTEM"))
simulated = pytest.mark.skipif(THIS_SYSTEM, reason="the system is what it is")
with open(ROOT / "pyproject.toml", "rb") as file:
    CONTRACTS = tomllib.load(file)["tool"]["importlinter"]["contracts"]
[ONLY_LINUX] = [c["forbidden_modules"] for c in CONTRACTS if "for Linux only" in c["name"]]
ON_EVERY_SYSTEM = [
    module.name
    for package in ("trajlib", "workbook")
    for module in pkgutil.walk_packages([str(ROOT / package)], f"{package}.")
    if module.name not in ONLY_LINUX
]


def python(
    *arguments, platform="win32", encoding="cp1251", drive=None, cwd=ROOT, code=0, timeout=240
):
    """Run Python as on the platform; return what it printed, and on stderr.

    With WORKBOOK_THIS_SYSTEM it runs as it is, on a machine with the system.
    """
    there = {"PLATFORM": platform, "ENCODING": encoding}
    there |= {"DRIVE": str(drive)} if drive else {}
    paths = [str(Path(__file__).with_name("elsewhere")), str(ROOT)]
    if THIS_SYSTEM:
        there, paths = {"PYTHONIOENCODING": encoding}, []
    done = subprocess.run(
        [sys.executable, *arguments],
        env=os.environ | there | {"PYTHONPATH": os.pathsep.join(paths)},
        cwd=cwd,
        capture_output=True,
        timeout=timeout,
    )
    assert done.returncode == code, done.stdout.decode() + done.stderr.decode()
    return done.stdout.decode(), done.stderr.decode()


@pytest.fixture
def drive(tmp_path):
    """Run the command in a folder on which case does not count and devices have no files."""

    def workbook(*arguments, **options):
        printed, errors = python(
            "-m", "workbook", *arguments, drive=tmp_path, cwd=tmp_path, **options
        )
        return printed + errors

    return workbook


def answered(problem, answers, newline="\n"):
    """Return the bytes of an answered notebook, as an editor writes it that ends lines so."""
    text = json.dumps(notebook(problem, answers), ensure_ascii=False, indent=1)
    return text.replace("\\n", json.dumps(newline)[1:-1]).replace("\n", newline).encode()


@simulated
@pytest.mark.parametrize("platform", ["win32", "darwin"])
def test_every_other_module_loads(platform):
    # its workers have the sandbox of Linux; `grade --cluster` says so
    names = [name for name in ON_EVERY_SYSTEM if not name.startswith("workbook.grading.cluster.")]
    code = f"import importlib\nfor name in {names}: importlib.import_module(name)\nprint('all')"
    assert len(names) > 200 and python("-c", code, platform=platform)[0] == "all\n"


@simulated
def test_what_is_for_linux_only_does_not_load():
    code = "import workbook.notebooks.execution\nimport workbook.grading.sandbox.isolation"
    assert "No module named 'fcntl'" in python("-c", code, code=1)[1]


@pytest.mark.parametrize("platform", ["win32", "darwin"])
def test_types_find_what_python_has_there(platform):
    """Only missing attributes: other errors of untyped modules are no matter of a platform."""
    options = ["--platform", platform, "--follow-imports", "skip", "--check-untyped-defs"]
    done = subprocess.run(
        [
            *(sys.executable, "-m", "mypy", "--config-file", os.devnull, *options),
            *("--cache-dir", ROOT / "_build" / f"mypy-{platform}", "-p", "workbook"),
        ],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=500,
    )
    assert "checked" in done.stdout, done.stdout + done.stderr
    missing = re.findall(r"^(.+?)\.py:.*Module has no attribute", done.stdout, re.M)
    of = {re.sub(r"[/\\]", ".", path) for path in missing}
    assert of <= set(ONLY_LINUX) and (platform == "darwin" or len(of) > 5), "the others have them"


@pytest.mark.parametrize(("encoding", "newline"), [("cp1251", "\r\n"), ("ascii", "\n")])
def test_a_student(drive, tmp_path, encoding, newline):
    printed = drive("exercises", "1.18", "--to", NAMES, encoding=encoding)
    assert f'workbook check "{NAMES}/ch1/p18.ipynb"' in printed
    assert len(json.loads(drive("problems", "--json", encoding=encoding))) > 200
    path = tmp_path / NAMES / "ch1" / "p18.ipynb"
    path.write_bytes(answered("1.18", RIGHT_1_18, newline))
    any_case = "ch1/p18.ipynb" if THIS_SYSTEM else "CH1/P18.ipynb"
    shown = drive("check", f"{NAMES}/{any_case}", encoding=encoding)
    assert "✓ right" in shown and "2 of 2 right" in shown
    path.write_bytes(answered("1.18", {**RIGHT_1_18, "a_region": "k1 > 0"}))
    shown = drive("check", f"{NAMES}/ch1/p18.ipynb", "--json", encoding=encoding, code=1)
    assert json.loads(shown)["verdicts"]["a_region"]["verdict"] == "wrong"


def test_a_student_on_macos(drive, tmp_path):
    (tmp_path / "p18.ipynb").write_bytes(answered("1.18", RIGHT_1_18))
    assert "2 of 2 right" in drive("check", "p18.ipynb", platform="darwin", encoding="utf-8")


@pytest.mark.parametrize(
    ("cell", "message"),
    [
        ("import os; os._exit(3)", "ended without a result, with exit code 3"),
        ("while True: pass", "was still running after 3 s"),
    ],
)
def test_a_notebook_that_ends_itself_or_never(drive, tmp_path, cell, message):
    (tmp_path / "p18.ipynb").write_bytes(answered("1.18", {"a_region": f"0\n{cell}"}))
    shown = drive("check", "p18.ipynb", "--timeout", "3", code=2)
    assert message in shown and shown.count("\n") == 1


def test_a_lecturer(drive, tmp_path):
    assert "con" in drive("assignment", "new", "con", "1.18", code=2)
    assert "2 answers" in drive("assignment", "new", "дз1", "1.18", "--due", "2026-10-01")
    with zipfile.ZipFile(tmp_path / "все работы.zip", "w") as archive:
        for name in ("aux.ipynb", "p18: новая?.ipynb", "P18.ipynb", "p18.ipynb"):
            path = f"Анна Ким_17_assignsubmission_file/{name}"
            archive.writestr(path, answered("1.18", {"a_region": "k1 > 0"}))
        archive.writestr("Con_18_assignsubmission_file/p18.ipynb", answered("1.18", RIGHT_1_18))
    shown = drive("collect", "все работы.zip", "дз1")
    assert "5 files of 2 students for дз1" in shown
    files = {path.name for path in (tmp_path / "submitted" / "Анна Ким_17" / "дз1").iterdir()}
    assert files == {"aux_.ipynb", "p18_ новая_.ipynb", "P18.ipynb", "p18 (2).ipynb"}
    assert "5 files" in drive("collect", "все работы.zip", "дз1", encoding="ascii")


@pytest.mark.timeout(1800)  # where Python is to be compiled to WebAssembly first
@pytest.mark.parametrize("platform", ["win32", "darwin"])
def test_grading(drive, tmp_path, platform):
    for student, answers in {"Анна Ким": RIGHT_1_18, "Con_": {"a_region": "k1 > 0"}}.items():
        folder = tmp_path / "submitted" / student / "дз1"
        folder.mkdir(parents=True)
        (folder / "p18.ipynb").write_bytes(answered("1.18", answers, "\r\n"))
    grade = partial(drive, "grade", "submitted", "--out", "graded", platform=platform)
    if sys.platform != "linux" or not THIS_SYSTEM:
        for options in (["--trust-students"], ["--sandbox", "bubblewrap"]):
            assert "Linux" in grade(*options, code=2)
    shown = grade("--sandbox", "wasm", timeout=1500)
    assert shown.count("notebooks run in WebAssembly") == 1 and "2 of 2 students" in shown
    with Store(tmp_path / "graded" / "grades.sqlite") as store:
        statuses = {
            attempt.student: [verdict.status for verdict in attempt.verdicts.values()]
            for attempt in store.attempts("дз1")
        }
    assert statuses == {"Анна Ким": [RIGHT, RIGHT], "Con_": [WRONG, MISSING]}


def test_points_by_hand(drive, tmp_path):
    with Store(tmp_path / "graded" / "grades.sqlite") as store:
        graded(store, "Анна Ким", "1.18", {"a_region": UNCHECKED, "b_region": RIGHT})
        homework = an_assignment(tmp_path, 'problems = ["1.18"]')
        commands.write(tmp_path / "graded" / "hw1", homework, scores(store, homework), "now")
    given = ["Анна Ким", "hw1", "1.18", "a_region", "0.5", "--comment", "Верно ✓"]
    shown = drive("score", *given, encoding="ascii")
    assert "Анна Ким" in shown and "a_region" in shown
    assert "все.csv: 1 answer" in drive("score", "--export", "все.csv")


def test_a_worked_solution(drive):
    assert "✓ right" in drive("solve", "1.18")

"""The command line as a user meets it: in processes of its own."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from workbook.authoring import read_master
from workbook.notebooks import exercises

pytestmark = pytest.mark.slow
ROOT = Path(__file__).resolve().parents[2]


def workbook(*arguments, cwd=ROOT):
    environment = os.environ | {"COLUMNS": "200", "NO_COLOR": "1", "TERM": "dumb"}
    return subprocess.run(
        [sys.executable, "-m", "workbook.cli", *map(str, arguments)],
        cwd=cwd,
        env=environment,
        capture_output=True,
        text=True,
        timeout=120,
    )


@pytest.mark.parametrize(
    "arguments",
    [["--help"], ["problems", "--help"], ["solve", "-h"], ["check", "-h"], ["exercises", "-h"]],
)
def test_help(arguments):
    done = workbook(*arguments)
    assert done.returncode == 0 and "Usage" in done.stdout


def test_problems():
    done = workbook("problems")
    assert done.returncode == 0 and "1.15" in done.stdout and "Stability regions" in done.stdout
    listed = json.loads(workbook("problems", "--json").stdout)
    assert {"number", "title", "section", "level", "topics", "answers"} <= set(listed[0])
    assert [problem["number"] for problem in listed] == [e.number for e in exercises.read_all()]


def test_solve():
    done = workbook("solve", "1.15", "--json")
    assert done.returncode == 0, done.stderr
    solved = json.loads(done.stdout)
    assert solved["number"] == "1.15" and set(solved["answers"]["a_region"]) == {
        "type",
        "text",
        "encoded",
    }
    assert {v["verdict"] for v in solved["verdicts"].values()} == {"right"}
    assert "k1" in workbook("solve", "1.15").stdout


def answered_notebook(tmp_path, items):
    """Write the notebook of 1.15 with items answered as in the worked solution."""
    exercise = exercises.find("1.15")
    notebook = json.loads(exercise.path.read_text(encoding="utf-8"))
    sources = read_master(ROOT / "solutions" / "ch1" / "p15.md").code("answer")
    stubs = [cell for cell in notebook["cells"] if cell["metadata"].get("tags") == ["answer"]]
    for k, cell in enumerate(stubs):
        if "abcde"[k] in items:
            imports = (
                "from trajlib.stability import hurwitz_minors\nfrom workbook.display import show\n"
            )
            cell["source"] = (imports if k else "") + sources[k]
    path = tmp_path / "mine.ipynb"
    path.write_text(json.dumps(notebook), encoding="utf-8")
    return path


def test_check(tmp_path):
    done = workbook("check", answered_notebook(tmp_path, "abcde"))
    assert done.returncode == 0 and "5 of 5 right" in done.stdout, done.stdout + done.stderr
    done = workbook("check", answered_notebook(tmp_path, "bd"))
    assert done.returncode == 1 and "2 of 5 right" in done.stdout
    verdicts = json.loads(workbook("check", answered_notebook(tmp_path, "bd"), "--json").stdout)[
        "verdicts"
    ]
    assert [v["verdict"] for v in verdicts.values()] == [
        "missing",
        "right",
        "missing",
        "right",
        "missing",
    ]


def test_check_finds_answers_in_any_cell_and_goes_on_after_errors(tmp_path):
    path = answered_notebook(tmp_path, "")
    notebook = json.loads(path.read_text())
    notebook["cells"] = [
        cell for cell in notebook["cells"] if cell["metadata"].get("tags") != ["check"]
    ]
    extra = [
        "%matplotlib inline\n1/0",
        "b_region = sp.And(k2 > 0, k1 > k2)\nimport sys; print('noise', file=sys.stderr)",
        "a_region = lambda k: True",
    ]
    notebook["cells"] += [
        {"cell_type": "code", "metadata": {}, "outputs": [], "execution_count": None, "source": s}
        for s in extra
    ]
    path.write_text(json.dumps(notebook))
    found = json.loads(workbook("check", path, "--json").stdout)
    assert (
        found["verdicts"]["b_region"]["verdict"] == "right"
        and found["verdicts"]["a_region"]["verdict"] == "invalid"
    )
    assert len(found["errors"]) == 1 and "ZeroDivisionError" in found["errors"][0]


def test_check_says_what_the_notebook_says_of_a_cell(tmp_path):
    """A cell that stopped, and one that overwrites the symbol k2 of the data cell."""
    path = answered_notebook(tmp_path, "")
    notebook = json.loads(path.read_text())
    [a, b, *_] = [cell for cell in notebook["cells"] if cell["metadata"].get("tags") == ["answer"]]
    a["source"], b["source"] = "a_region = k1 > cos(0)", "b_region = k2 = 0"
    path.write_text(json.dumps(notebook))
    found = json.loads(workbook("check", path, "--json").stdout)
    assert "Write sp.cos" in found["errors"][0]
    assert found["verdicts"]["a_region"] == {
        "verdict": "missing",
        "message": "not checked: its cell stopped with NameError; fix that first",
    }
    assert "overwrote k2, a name of the data cell" in found["verdicts"]["b_region"]["message"]
    assert found["verdicts"]["c_region"]["message"] == "not answered yet"


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["solve", "9.99"], "no problem 9.99"),
        (["solve", "fifteen"], "no problem fifteen"),
        (
            ["check", "nowhere.ipynb"],
            "nowhere.ipynb is not a readable notebook: No such file or directory\n",
        ),
        (["check", "9.99"], "no problem 9.99"),
        (["check", "book"], "book is not a readable notebook: Is a directory\n"),
        (["check", "README.md"], "README.md is not a readable notebook"),
    ],
)
def test_bad_input_ends_in_one_line_and_code_2(arguments, message):
    done = workbook(*arguments)
    assert done.returncode == 2 and message in done.stderr
    assert len(done.stderr.strip().split("\n")) == 1 and "Traceback" not in done.stderr


def test_check_stops_an_endless_notebook(tmp_path):
    path = answered_notebook(tmp_path, "")
    notebook = json.loads(path.read_text())
    notebook["cells"].append(
        {
            "cell_type": "code",
            "metadata": {},
            "outputs": [],
            "execution_count": None,
            "source": "while True: pass",
        }
    )
    path.write_text(json.dumps(notebook))
    done = workbook("check", path, "--timeout", "8")
    assert done.returncode == 2 and "still running after 8 s" in done.stderr


def test_exercises_match_their_masters(tmp_path):
    done = workbook("exercises", "--json")
    assert done.returncode == 0 and json.loads(done.stdout) == {"changed": []}


def test_importing_trajlib_loads_nothing_heavy():
    code = (
        "import sys, trajlib; print([m for m in ('numpy', 'scipy', 'sympy', 'casadi', 'control', "
        "'matplotlib') if m in sys.modules])"
    )
    assert (
        subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, timeout=120
        ).stdout.strip()
        == "[]"
    )


def test_fresh_notebooks(tmp_path):
    """Fresh notebooks are written; existing ones are not overwritten."""
    done = workbook("exercises", "1.15", "2.5", "--to", "mine", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout == (
        "wrote 2 notebooks; open mine/ch1/p15.ipynb in Jupyter, or check it by: "
        "workbook check mine/ch1/p15.ipynb\n"
    )
    assert (tmp_path / "mine/ch2/p05.ipynb").exists()
    assert (tmp_path / "mine/ch1/p15.ipynb").read_bytes() == exercises.find(
        "1.15"
    ).path.read_bytes()
    (tmp_path / "mine/ch1/p15.ipynb").write_text("my work")
    again = workbook("exercises", "1.15", "2.5", "--to", "mine", cwd=tmp_path)
    assert again.stdout.startswith("nothing is written")
    assert (tmp_path / "mine/ch1/p15.ipynb").read_text() == "my work"


def test_check_of_a_number_asks_for_a_file(tmp_path):
    done = workbook("check", "1.15", cwd=tmp_path)
    assert done.returncode == 2 and "a notebook of yours" in done.stderr and "--to" in done.stderr
    assert len(done.stderr.splitlines()) == 1

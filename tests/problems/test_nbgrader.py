"""`nbgrader autograde` scores the students' notebooks rightly: all right, half right, untouched."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from workbook.authoring import read_master
from workbook.notebooks import exercises

ROOT = Path(__file__).resolve().parents[2]


def filled(number, names):
    """Return the student's notebook of a problem with the reference answers of some names."""
    exercise = exercises.find(number)
    master = read_master(
        ROOT / "solutions" / exercise.path.parent.name / f"{exercise.path.stem}.md"
    )
    notebook = json.loads(exercise.path.read_text(encoding="utf-8"))
    stubs = [cell for cell in notebook["cells"] if cell["metadata"].get("tags") == ["answer"]]
    for cell, source in zip(stubs, master.code("answer")):
        if any(f"{name} = ..." in cell["source"] for name in names):
            cell["source"] = source
    return notebook


@pytest.mark.slow
def test_right_half_right_and_untouched(tmp_path, monkeypatch):
    from nbgrader.api import Gradebook

    # nbgrader starts `alembic` by its bare name.
    monkeypatch.setenv("PATH", f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")

    source = exercises.find("1.15").path
    (tmp_path / "source" / "homework").mkdir(parents=True)
    (tmp_path / "source" / "homework" / "p15.ipynb").write_text(
        source.read_text(encoding="utf-8"), encoding="utf-8"
    )
    submissions = {
        "ada": ["a_region", "b_region", "c_region", "d_region", "e_region"],
        "boris": ["b_region", "d_region"],
        "chen": [],
    }
    # Item a opens the worked solution with the imports that the later answer cells use.
    for student, names in submissions.items():
        folder = tmp_path / "submitted" / student / "homework"
        folder.mkdir(parents=True)
        notebook = filled("1.15", names)
        if student == "boris":
            notebook["cells"].insert(
                1,
                {
                    "cell_type": "code",
                    "execution_count": None,
                    "id": "mine",
                    "metadata": {},
                    "outputs": [],
                    "source": "from trajlib.stability import hurwitz_minors\n"
                    "from workbook.display import show",
                },
            )
        (folder / "p15.ipynb").write_text(json.dumps(notebook), encoding="utf-8")

    environment = os.environ | {
        "JUPYTER_CONFIG_DIR": str(tmp_path),
        "IPYTHONDIR": str(tmp_path / "ipython"),
    }
    for command in (["generate_assignment", "homework"], ["autograde", "homework"]):
        done = subprocess.run(
            [sys.executable, "-m", "nbgrader", *command, f"--course-dir={tmp_path}"],
            cwd=tmp_path,
            env=environment,
            capture_output=True,
            text=True,
            timeout=300,
        )
        assert done.returncode == 0, done.stdout + done.stderr

    with Gradebook(f"sqlite:///{tmp_path / 'gradebook.db'}") as gradebook:
        scores = {
            s.student.id: (s.score, s.max_score)
            for s in gradebook.assignment_submissions("homework")
        }
    assert scores == {"ada": (5.0, 5.0), "boris": (2.0, 5.0), "chen": (0.0, 5.0)}

"""Each homework of each route is made by the command, with the answers that the route asks for."""

import json

import pytest
from typer.testing import CliRunner

from workbook.cli import app
from workbook.grading.course import assignment as assignments
from workbook.grading.course import text_cells
from workbook.routes.course import course


@pytest.mark.slow
@pytest.mark.parametrize("route", course().routes.values(), ids=lambda route: route.name)
def test_each_homework_is_made(route, tmp_path):
    for week in route.weeks:
        made = CliRunner().invoke(
            app,
            [
                *("assignment", "new", f"hw{week.number}", "--route", route.name),
                *("--week", str(week.number), "--assignments", str(tmp_path)),
            ],
        )
        assert made.exit_code == 0, made.output
        folder = tmp_path / f"hw{week.number}"
        homework = assignments.read(folder / "assignment.toml")
        assert homework.title == f"{route.title}, {route.unit} {week.number}"
        asked = {
            problem: [name for name, worth in points.items() if worth == 1]
            for problem, points in homework.points.items()
        }
        assert asked == {task.problem: task.answers for task in week.homework}
        assert homework.max_points == sum(len(task.answers) for task in week.homework)
        assert len(list(folder.glob("*.ipynb"))) == len(week.homework)


def test_items_that_are_not_asked_are_named_and_worth_nothing(tmp_path):
    """Of 1.13 the route asks for two items of three."""
    made = CliRunner().invoke(
        app,
        [
            *("assignment", "new", "hw5", "--route", "linear-control", "--week", "5"),
            *("--assignments", str(tmp_path)),
        ],
    )
    assert "hw5: 1 problem, 11 answers, 11 points, no due date" in made.output
    toml = (tmp_path / "hw5" / "assignment.toml").read_text(encoding="utf-8")
    assert toml.count(" = 0  # not asked") == 5
    readme = (tmp_path / "hw5" / "README.md").read_text(encoding="utf-8")
    assert "11 points for 11 answers, those of a, b; the others are practice" in readme
    notebook = json.loads((tmp_path / "hw5" / "ch1-p13.ipynb").read_text(encoding="utf-8"))
    (told,) = [
        c["source"] for c in notebook["cells"] if c["metadata"].get("tags") == ["instruction"]
    ]
    assert told.startswith("*About 110 min for the answers of a, b, which count here;")
    hand_in = tmp_path / "submitted" / "ann" / "hw5" / "ch1-p13.ipynb"
    hand_in.parent.mkdir(parents=True)
    hand_in.write_text(json.dumps(notebook), encoding="utf-8")
    homework = assignments.read(tmp_path / "hw5" / "assignment.toml")
    assert text_cells.read(tmp_path / "submitted", homework) == {}


@pytest.mark.parametrize("direction", [False, True])
def test_check_says_of_a_homework_what_its_notebook_says(direction, tmp_path):
    options = [*("--assignments", str(tmp_path)), *(["--direction"] if direction else [])]
    CliRunner().invoke(app, ["assignment", "new", "hw", "1.3", *options])
    path = tmp_path / "hw" / "ch1-p03.ipynb"
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("b_rate = ...", "b_rate = a*x2**2"), encoding="utf-8")
    checked = CliRunner().invoke(app, ["check", str(path), "--json"])
    message = json.loads(checked.output)["verdicts"]["b_rate"]["message"]
    assert ("along the motion is less than" in message) is direction
    assert ("along the motion is not" in message) is not direction

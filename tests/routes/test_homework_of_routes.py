"""Each homework of each route is made by the command, with the answers that the route asks for."""

import pytest
from typer.testing import CliRunner

from workbook.cli import app
from workbook.grading.course import assignment as assignments
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

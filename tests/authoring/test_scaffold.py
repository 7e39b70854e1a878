"""`workbook new` writes a master that holds the contract, and never writes over one."""

from pathlib import Path

import pytest

from workbook.authoring import new_problem, read_master
from workbook.authoring.trials import trials_file
from workbook.course import ADDED, LAST_PRINTED

SECTIONS = {"ch2/p05.md": "§2.2", "ch2/p31.md": "§2.5"}


@pytest.fixture
def solutions(tmp_path):
    for name, section in SECTIONS.items():
        path = tmp_path / "solutions" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f'---\nproblem: {{section: "{section}"}}\n---\n', encoding="utf-8")
    return tmp_path / "solutions"


@pytest.mark.parametrize(
    "number, name, section",
    [
        ("2.30", "ch2/p30.md", "§2.2"),
        ("2.4", "ch2/p04.md", "§2.1"),
        ("3.1", "ch3/p01.md", "§3.1"),
        ("2.32", "ch2/p32.md", "§2.5"),
    ],
)
def test_a_scaffold_is_a_valid_master(solutions, number, name, section):
    page, trials = new_problem(solutions, number)
    master = read_master(page)
    assert page == solutions / name and trials == trials_file(page)
    assert (master.number, master.section) == (number, section)
    assert {role: len(trials_of_role) for role, trials_of_role in master.trials.items()} == {
        "wrong": 1,
        "right": 1,
    }


def test_existing_files_are_not_overwritten(solutions):
    page, trials = new_problem(solutions, "2.30")
    page.unlink()
    trials.write_text("mine")
    with pytest.raises(FileExistsError, match="p30.trials.py"):
        new_problem(solutions, "2.30")
    assert trials.read_text() == "mine" and not page.exists()


@pytest.mark.parametrize("number", ["2", "2.x", "2.03", "two", "2.0", "../2.3", "2.3/4"])
def test_malformed_numbers_are_refused(solutions, number):
    with pytest.raises(ValueError, match="write it like 2.30"):
        new_problem(solutions, number)


@pytest.mark.parametrize("number", ["1.99", "1.19", "2.38", "5.71"])
def test_numbers_that_the_problem_book_does_not_have_are_refused(solutions, number):
    with pytest.raises(ValueError, match="a new problem belongs to a chapter from 6 on"):
        new_problem(solutions, number)
    assert not (solutions / f"ch{number[0]}" / f"p{number[2:]}.md").exists()


def test_the_last_printed_problems_are_those_of_the_book():
    folder = Path(__file__).resolve().parents[2] / "solutions"
    assert sum(LAST_PRINTED.values()) == 194
    for chapter, last in LAST_PRINTED.items():
        masters = map(read_master, folder.glob(f"ch{chapter}/p*.md"))
        printed = [master.number for master in masters if master.section != ADDED]
        assert sorted(int(number.split(".")[1]) for number in printed) == [*range(1, last + 1)]


def test_research_chapters_are_open(solutions):
    assert read_master(new_problem(solutions, "6.99")[0]).number == "6.99"

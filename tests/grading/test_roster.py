"""A table of the class, from wherever: columns in any order, with any headers."""

import pytest

from workbook.grading.course.assignment import InputError
from workbook.grading.course.roster import Roster
from workbook.grading.reports.canvas import read_roster

CLASS = [
    ("Able, Ann", "ann", "ann@uni.example", "101"),
    ("Bee, Bob", "bob", "bob@uni.example", "102"),
]


def text(order, header, separator):
    rows = [header, *CLASS] if header else CLASS
    return "\n".join(separator.join(f'"{row[k]}"' for k in order) for row in rows)


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("order", [(0, 1, 2, 3), (3, 2, 1, 0), (2, 0, 3, 1)])
@pytest.mark.parametrize("header", [("Имя", "Логин", "Почта", "Номер"), None])
@pytest.mark.parametrize("column", [1, 2, 3])
def test_the_column_that_fits_most_folders(order, header, separator, column):
    roster = Roster(text(order, header, separator))
    known = [CLASS[0][column], "somebody else"]
    assert roster.identities(known) == [CLASS[0][column], CLASS[1][column]]


def test_without_folders_the_addresses_name_the_students():
    roster = Roster(text((3, 0, 2, 1), ("a", "b", "c", "d"), ","))
    assert roster.identities([]) == ["ann@uni.example", "bob@uni.example"]


def test_one_column_is_enough():
    assert Roster("student\nann\nbob\n").identities(["bob"]) == ["ann", "bob"]


def test_the_same_student_twice_is_reported():
    with pytest.raises(InputError, match="the roster has ann more than once"):
        Roster("login,name\nann,A\nann,B\nbob,C\n").identities(["ann", "bob"])


def test_a_roster_that_a_russian_spreadsheet_saved(tmp_path):
    text = "Фамилия;Логин\nИванов;ivanov\nЩукин;щукин\n"
    (tmp_path / "class.csv").write_bytes(text.encode("cp1251"))
    assert read_roster(tmp_path / "class.csv").identities(["щукин"]) == ["ivanov", "щукин"]

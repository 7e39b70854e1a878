"""The rooms of the checks stand on each other in one direction: contract, tools, truths, themes."""

import ast
from pathlib import Path

import pytest

from workbook import checks

HOUSE = Path(checks.__file__).parent
FLOORS = [
    ["contract"],
    ["tools"],
    ["truths"],
    ["estimation", "feedback", "stability", "structure", "pontryagin", "research"],
]
#: Themes that take from another one, with the reason.
NEIGHBOURS = {}


def taken():
    """Pairs (room, room that it imports from) with the files where it does."""
    found = {}
    for path in HOUSE.glob("*/**/*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = (
                [node.module]
                if isinstance(node, ast.ImportFrom)
                else [alias.name for alias in node.names]
                if isinstance(node, ast.Import)
                else []
            )
            for name in names:
                assert name is not None, f"{path}: imports in the checks are absolute"
                if name.startswith("workbook.checks"):
                    rooms = (
                        [name.split(".")[2]]
                        if name.count(".") > 1
                        else [alias.name for alias in node.names]
                    )
                    for room in rooms:
                        found.setdefault((path.relative_to(HOUSE).parts[0], room), []).append(
                            path.name
                        )
    return found


def test_every_room_has_its_floor():
    assert {path.parent.name for path in HOUSE.glob("*/__init__.py")} == {
        room for floor in FLOORS for room in floor
    }


@pytest.mark.parametrize("room, other", sorted(taken()))
def test_no_arrow_back_up(room, other):
    floor, below = (
        next(k for k, rooms in enumerate(FLOORS) if name in rooms) for name in (room, other)
    )
    assert room == other or below < floor or (room, other) in NEIGHBOURS, taken()[room, other]


def test_the_neighbours_are_needed():
    assert set(NEIGHBOURS) <= set(taken())

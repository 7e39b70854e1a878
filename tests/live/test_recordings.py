"""Recorded cells: shown again while nothing that they read has changed, computed otherwise."""

import pytest
from IPython.core.interactiveshell import InteractiveShell
from IPython.utils.capture import capture_output

from workbook.live.recordings import Recordings

CELLS = (
    "a = 2\ntimes = []",
    "def scaled(x):\n    return a*x",
    "times.append(1)\nprint(scaled(3))\nb = scaled(5)",
    "times.append(1)\nb + 1",
)


@pytest.fixture
def shell():
    shell = InteractiveShell()
    recordings = Recordings(shell)
    for cell in CELLS:
        assert recordings.record(cell) is None
    assert len(shell.user_ns["times"]) == 2
    return shell


def run(shell, source):
    with shell.display_trap, capture_output() as shown:
        assert shell.run_cell(source).success
    return shown.stdout.strip().removeprefix("Out[0]: ")


def test_recorded_cells_show_the_same_without_being_computed(shell):
    for name in ("a", "b", "scaled", "times"):
        times = shell.user_ns.pop(name)
    assert [run(shell, cell) for cell in CELLS] == ["", "", "6", "11"]
    assert shell.user_ns["b"] == 10 and shell.user_ns["times"] is times and len(times) == 2


def test_what_depends_on_a_change_is_computed(shell):
    run(shell, "a = 4")
    assert run(shell, CELLS[2]) == "12"  # by the function of another cell
    assert run(shell, CELLS[3]) == "21" and len(shell.user_ns["times"]) == 4


def test_a_cell_that_fails_is_not_recorded(shell):
    assert isinstance(shell.recordings.record("1/0"), ZeroDivisionError)
    assert shell.recordings.record("nothing +") is not None
    with pytest.raises(KeyError):
        shell.recordings.show("1/0")

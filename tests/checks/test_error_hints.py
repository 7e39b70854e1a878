"""The first day's mistakes in a kernel, as a student's Jupyter runs it."""

import re

import nbformat
import pytest
import sympy as sp
from jupyter_client.manager import start_new_kernel
from nbclient import NotebookClient

from workbook.checks.contract import error_hints

DATA = """import sympy as sp
from workbook import checks
k1, k2, s = sp.symbols("k1 k2 s", real=True)
a_poly = s**3 + k1*s**2 + k2*s + 1"""
CHECK = "checks.report(a_region=checks.stability_region(a_region, a_poly, [k1, k2]))"
TWO = CHECK[:-1] + ", b_region=checks.stability_region(b_region, a_poly, [k1, k2]))"
RIGHT = "(k2 > 0) & (k1*k2 > 1)"


@pytest.fixture(scope="module")
def outputs():
    """Return the outputs of cells, run one after the other whatever fails."""

    def run(*cells):
        notebook = nbformat.v4.new_notebook(
            cells=[nbformat.v4.new_code_cell(cell) for cell in cells]
        )
        NotebookClient(notebook, allow_errors=True, timeout=60, kernel_name="python3").execute()
        return [cell.outputs for cell in notebook.cells]

    return run


@pytest.fixture(scope="module")
def first_day(outputs):
    """Run one kernel through a first day and return {event: outputs of the cell}."""
    cells = {
        "data": DATA,
        "early": CHECK,
        "and": "a_region = k1 > 0 and k1*k2 > 1",
        "after and": CHECK,
        "right": f"a_region = {RIGHT}",
        "after right": CHECK,
        "chain": "a_region = 0 < k2 < k1",
        "after chain": CHECK,
        "unbracketed": "a_region = k2 > 0 & k1*k2 > 1",
        "unreadable": "a_region = (k2 > 0",
        "after unreadable": CHECK,
        "if": "law = k1 if k1 > 0 else k2",
        "power": "law = k1^2",
        "NumPy": "import numpy as np\nlaw = np.sqrt(k1)",
        "math": "import math\nlaw = math.sin(k1)",
        "function": "law = cos(k1)",
        "other name": "law = sp.arctan(k1)",
        "no sign": "law = 4k1",
        "no sign before a bracket": "law = 2(k1 + 1)",
        "other error": "c = 1 + 'one'",
        "half": f"a_region = {RIGHT}\nb_region = k1 > 0",
        "after half": TWO,
        "overwriting": "b_region = k2 = 0",
        "after overwriting": TWO,
        "corrected": f"b_region = {RIGHT.replace('>', '>=')}",
        "after corrected": TWO,
        "data again": DATA,
        "corrected again": f"b_region = {RIGHT}",
        "after data": TWO,
    }
    return dict(zip(cells, outputs(*cells.values())))


def shown(outputs):
    return "\n".join(
        output["data"]["text/plain"] for output in outputs if output.output_type == "display_data"
    )


def errors(outputs):
    return ["\n".join(output.traceback) for output in outputs if output.output_type == "error"]


@pytest.mark.slow
@pytest.mark.parametrize("mistake", ["and", "chain", "unbracketed", "if"])
def test_conditions_joined_as_in_python_are_told_what_to_write(first_day, mistake):
    [said] = errors(first_day[mistake])
    assert "sp.And(" in said and "(p < 7) & (q < p)" in said and "sp.Piecewise(" in said
    _error, *advice = said.splitlines()
    assert "site-packages" not in said and len(advice) == 4
    assert max(map(len, advice)) <= 79, "VS Code does not break a long line of an error"


@pytest.mark.parametrize(
    "mistake, told",
    [
        ("power", "x**2"),
        ("NumPy", "sp.sqrt(x)"),
        ("math", "sp.sqrt(x)"),
        ("function", "Write sp.cos"),
        ("other name", "Write sp.atan"),
        ("no sign", "write 4*t, not 4t"),
        ("no sign before a bracket", "2*(x + 1), not 2(x + 1)"),
    ],
)
def test_mathematics_of_numbers_is_led_to_that_of_symbols(first_day, mistake, told):
    [said] = errors(first_day[mistake])
    assert (
        told in said and len(said.splitlines()) == 2 and max(map(len, said.splitlines()[1:])) <= 79
    )


def test_other_errors_stay_as_they_are(first_day):
    [said] = errors(first_day["other error"])
    assert "unsupported operand" in said and "Traceback" in said and "sp.And" not in said


def test_a_check_before_its_answer_is_missing(first_day):
    assert shown(first_day["early"]) == "… a_region: missing: not answered yet"


ALONE = f"from workbook import checks\n\n{CHECK}"


@pytest.mark.slow
@pytest.mark.parametrize("before", [(), ("a_region = True",), ("import workbook",)])
def test_a_check_before_its_data_says_what_to_run(outputs, before):
    """As the first cell after a restart nothing of ours is loaded but what it imports itself."""
    *_, early, data, check = outputs(*before, ALONE, DATA, ALONE)
    [said] = errors(early)
    name, *told = said.splitlines()
    assert re.match("NameError: name '(a_region|a_poly)' is not defined", name)
    assert "run the data cell" in told[0] and len(told) == 2 and max(map(len, told)) <= 79
    assert not errors(data) and shown(check)


@pytest.mark.slow
def test_other_names_that_do_not_exist_are_told_as_ever(outputs):
    _, typo = outputs(DATA, "a_region = k3 > 0")
    [said] = errors(typo)
    assert "Traceback" in said and "data cell" not in said


@pytest.mark.parametrize("after", ["after and", "after chain", "after unreadable"])
def test_the_value_before_a_failed_cell_is_not_judged(first_day, after):
    assert re.match(
        "… a_region: missing: not checked: its cell stopped with",
        shown(first_day[after]),
    )


def test_a_mended_cell_is_judged(first_day):
    assert shown(first_day["after right"]).startswith("✓ a_region: right")


def test_a_name_of_the_data_that_is_overwritten_is_named(first_day):
    """`b_region = k2 = 0` makes every condition on k2 a wrong one until the data cell runs again."""
    advice = "Your code overwrote k2, a name of the data cell: give yours another name"
    for event in ("after overwriting", "after corrected"):
        a_region, b_region = shown(first_day[event]).split("\n")[:2]
        assert a_region.startswith("✓") and advice in b_region
    assert "overwrote" not in shown(first_day["after data"])
    assert shown(first_day["after data"]).startswith("✓ a_region") and (
        "✓ b_region" in shown(first_day["after data"])
    )


def test_the_names_that_hints_write_are_names_of_sympy():
    names = [*error_hints.SYMPY_NAMES.split(), *error_hints.ALIASES.values()]
    assert all(hasattr(sp, name) for name in names)
    assert not any(hasattr(sp, name) for name in error_hints.ALIASES)


@pytest.mark.slow
def test_no_error_follows_the_verdicts_that_a_person_reads():
    """With an error Jupyter would show a second block and drop the cells that wait to run."""
    manager, client = start_new_kernel(kernel_name="python3")
    try:
        for cell in (DATA, "a_region = k2 > 0"):
            client.execute_interactive(cell, timeout=60, output_hook=lambda message: None)
        blocks = []
        replies = [
            client.execute_interactive(
                CHECK, timeout=60, allow_stdin=is_person, output_hook=blocks.append
            )["content"]["status"]
            for is_person in (True, False)
        ]
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)
    assert replies == ["ok", "error"]
    kinds = [message["msg_type"] for message in blocks if message["msg_type"] != "status"]
    assert [kind for kind in kinds if kind != "execute_input"] == [
        "display_data",
        "display_data",
        "error",
    ]


def test_half_right_keeps_each_line_its_own_colour(first_day):
    """The error is one line; the verdicts are HTML with colours of their own."""
    display, error = first_day["after half"]
    assert error.output_type == "error" and error.traceback == ["Not yet: 1 of 2 right."]
    lines = re.findall(
        r'<div class="workbook-verdict (\w+)" style="color: ([^;]+);', display["data"]["text/html"]
    )
    assert [status for status, _ in lines] == ["right", "wrong"]
    assert len({colour for _, colour in lines}) == 2 and all("#" in colour for _, colour in lines)

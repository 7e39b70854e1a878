"""A student notebook in plain JupyterLab: the looks of its reports."""

import os
import shutil
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from workbook.checks.contract.reporting import COLOURS, MARKS

pytestmark = [pytest.mark.waits, pytest.mark.timeout(300)]
NOTEBOOK = Path(__file__).resolve().parents[2] / "exercises" / "ch1" / "p15.ipynb"
CELLS = "[...document.querySelectorAll('.jp-NotebookPanel .jp-Notebook .jp-CodeCell')]"
WRONG_A, RIGHT_A = "a_region = sp.And(k1 > 0, k2 > 0)", "a_region = sp.And(k1 > 0, k1*k2 > 1)"
RIGHT_B = "b_region = [k2 > 0, k1 > k2]"
BOTH = (
    "checks.report(a_region=checks.stability_region(a_region, a_poly, [k1, k2]),"
    " b_region=checks.stability_region(b_region, b_poly, [k1, k2]))"
)


class OpenNotebook:
    """The open notebook: what a student types and runs, and what stands below it then."""

    def __init__(self, browser):
        from selenium.webdriver import ActionChains
        from selenium.webdriver.common.keys import Keys

        self._browser, self._keys, self._actions = browser, Keys, ActionChains

    def run(self, beginning, text=None):
        """Run the first cell with a line that begins so, after replacing its text, and wait."""
        at = (
            f"{CELLS}.findIndex(cell => ('\\n' + cell.querySelector('.cm-content').innerText)"
            f".includes('\\n' + {beginning!r}))"
        )
        number = self._browser.wait_for(f"{at} + 1", 60) - 1
        assert number >= 0, f"no line begins with {beginning}"
        cell = f"{CELLS}[{number}]"
        before = self._browser.run(f"{cell}.querySelector('.jp-InputPrompt').innerText")
        self._browser.run(f"{cell}.scrollIntoView({{block: 'center'}})")
        self._browser.run(f"{cell}.querySelector('.cm-content')").click()
        if text:
            self._press(self._keys.CONTROL, "a")
            self._actions(self._browser.driver).send_keys(text).perform()
        self._press(self._keys.CONTROL, self._keys.ENTER)
        ran = f"{cell}.querySelector('.jp-InputPrompt').innerText"
        assert self._browser.wait_for(f"/\\d/.test({ran}) && {ran} !== {before!r}", 60), (
            "the cell did not run"
        )
        return cell

    def report(self, beginning, text=None):
        """Run a check cell; return (mark, verdict, colour, text) of its lines, and its error."""
        cell = self.run(beginning, text)
        lines = self._browser.run(
            f"[...{cell}.querySelectorAll('.workbook-verdict')].map(line => "
            "[line.querySelector('.mark').innerText, "
            "line.className.split(' ').at(-1), getComputedStyle(line).color, line.innerText])"
        )
        return lines, self._browser.run(
            f'[...{cell}.querySelectorAll(\'[data-mime-type="application/vnd.jupyter.stderr"], '
            '[data-mime-type="application/vnd.jupyter.error"]\')].map(part => '
            "part.innerText).join('')"
        )

    def _press(self, held, key):
        self._actions(self._browser.driver).key_down(held).send_keys(key).key_up(held).perform()


@pytest.fixture(scope="module")
def notebook(browser, tmp_path_factory):
    """JupyterLab as a student starts it, with the notebook on the desk; ended whatever happens."""
    folder = tmp_path_factory.mktemp("student")
    shutil.copy(NOTEBOOK, folder)
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    folders = {
        name: str(folder / name.lower())
        for name in (
            "JUPYTER_CONFIG_DIR",
            "JUPYTER_RUNTIME_DIR",
            "JUPYTER_DATA_DIR",
            "JUPYTERLAB_SETTINGS_DIR",
            "JUPYTERLAB_WORKSPACES_DIR",
            "IPYTHONDIR",
        )
    }
    server = subprocess.Popen(
        [
            sys.executable,
            "-m",
            "jupyterlab",
            "--no-browser",
            "--allow-root",
            f"--ServerApp.root_dir={folder}",
            "--ip=127.0.0.1",
            f"--port={port}",
            "--ServerApp.port_retries=0",
            "--IdentityProvider.token=",
            "--LabApp.news_url=",
            "--LabApp.extension_manager=readonly",
        ],
        cwd=folder,
        env=os.environ | folders,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        for _ in range(300):
            with socket.socket() as knock:
                if knock.connect_ex(("127.0.0.1", port)) == 0:
                    break
            assert server.poll() is None, "JupyterLab ended at once"
            browser.wait_for("false", 0.2)
        browser.resize(1280, 900)
        browser.open(f"http://127.0.0.1:{port}/lab/tree/{NOTEBOOK.name}")
        assert browser.wait_for(
            f"{CELLS}.some(cell => cell.querySelector('.cm-content')?.offsetParent)", 90
        )
        yield OpenNotebook(browser)
        browser.open("about:blank")
    finally:
        server.terminate()
        server.wait(30)


def lines_of(report):
    return [(mark, verdict, colour) for mark, verdict, colour, _ in report]


def line(verdict):
    ink = COLOURS[verdict][0]
    red, green, blue = (int(ink[k : k + 2], 16) for k in (1, 3, 5))
    return MARKS[verdict], verdict, f"rgb({red}, {green}, {blue})"


def test_reports_of_missing_wrong_and_right_answers(notebook):
    check = 'checks.report("1.15",\n              a_region'
    report, error = notebook.report(check)  # no cell has run yet
    assert report == [] and "run the data cell" in error
    notebook.run("import sympy as sp")
    report, error = notebook.report(check)
    assert lines_of(report) == [line("missing")] and error == ""

    notebook.run("a_region =", WRONG_A)
    report, error = notebook.report(check)
    assert lines_of(report) == [line("wrong")] and error == ""
    # it fails somewhere, and the mistake is asked about
    assert "wrong" in report[0][3] and "?" in report[0][3]

    notebook.run("a_region =", RIGHT_A)
    report, error = notebook.report(check)
    assert lines_of(report) == [line("right")] and error == ""

    # two lines of one report, each in its own colour: half of it is right
    notebook.run("b_region =", "b_region = k1 > 0")
    report, error = notebook.report('checks.report("1.15",\n              b_region', BOTH)
    assert lines_of(report) == [line("right"), line("wrong")] and error == ""

    notebook.run("b_region =", RIGHT_B)
    report, error = notebook.report("checks.report(a_region")
    assert lines_of(report) == [line("right"), line("right")] and error == ""

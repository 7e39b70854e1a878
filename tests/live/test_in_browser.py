"""A lecture in JupyterLab as the class sees it, in a browser that reaches nothing but this machine."""

import time
from pathlib import Path

import pytest

MASTER = Path(__file__).resolve().parents[2] / "solutions" / "ch1" / "p15.md"
CELLS = "[...document.querySelectorAll('.jp-NotebookPanel .jp-Notebook .jp-CodeCell')]"
IDLE = "document.querySelector('.jp-Notebook-ExecutionIndicator')?.dataset.status === 'idle'"


class Lab:
    """An open notebook: `go_on` is Shift+Enter."""

    def __init__(self, browser):
        from selenium.webdriver import ActionChains
        from selenium.webdriver.common.keys import Keys

        self._browser, self._keys, self._actions = browser, Keys, ActionChains

    def press(self, *keys):
        actions = self._actions(self._browser.driver)
        for key in keys[:-1]:
            actions.key_down(key)
        actions.send_keys(keys[-1])
        for key in keys[:-1]:
            actions.key_up(key)
        actions.perform()

    def ran(self):
        """The highest number of a cell that has been run."""
        return self._browser.run(f"Math.max(0, ...{CELLS}.map(cell => parseInt(cell.querySelector('.jp-InputPrompt')"
                                 ".innerText.match(/\\d+/)) || 0))")

    def go_on(self):
        """Run the chosen cell and go to the next one; what it shows."""
        before = self.ran()
        self.press(self._keys.SHIFT, self._keys.ENTER)
        shown = (f"{CELLS}.find(cell => cell.querySelector('.jp-InputPrompt').innerText.includes('[{before + 1}]'))"
                 "?.querySelector('.jp-OutputArea')?.innerText")
        assert self._browser.wait_for(f"{CELLS}.some(cell => cell.querySelector('.jp-InputPrompt').innerText"
                                      f".includes('[{before + 1}]'))", 60), "the cell did not run"
        time.sleep(0.3)  # what it puts below comes after what it shows
        return self._browser.run(shown) or ""

    def chosen(self):
        return self._browser.run("document.querySelector('.jp-Notebook .jp-Cell.jp-mod-active .cm-content').innerText")


@pytest.mark.timeout(300)
def test_a_lecture_is_gone_through_with_one_key(lecture, browser):
    master = MASTER.read_bytes()
    with lecture("1.15", "--discard") as live:
        browser.resize(1280, 900)
        browser.open(live.address)
        assert browser.wait_for(f"{CELLS}.filter(cell => cell.querySelector('.cm-content')?.offsetParent).length > 3",
                                90), "the notebook does not open"
        assert browser.wait_for(IDLE, 60)
        large = browser.run("parseFloat(getComputedStyle(document.querySelector('.jp-CodeCell .cm-content')).fontSize)")
        assert large >= 20
        lab = Lab(browser)
        browser.find(".jp-NotebookPanel .jp-CodeCell .cm-content").click()
        time.sleep(1)
        lab.go_on()  # the data
        assert lab.chosen() == "%answer a_region"
        assert "The cubic, once for all items" in lab.go_on()
        for _ in range(3):  # what it puts below is the next cell
            assert lab.chosen() == "%answer a_region"
            shown = lab.go_on()
        assert "The region lies above" in shown
        lab.go_on()
        assert "a_region = sp.And(k1 > 0, k1*k2 > 1)" in lab.chosen()
        assert "leading minors" in lab.go_on()
        lab.go_on()
        lab.go_on()  # the picture
        assert browser.run(f"{CELLS}.some(cell => cell.querySelector('.jp-OutputArea img'))")
        assert "Left: the region of item a" in lab.go_on()
        assert lab.chosen() == "%check a_region"
        assert "right" in lab.go_on()
        lab.press(lab._keys.CONTROL, "s")
        assert browser.wait_for("!document.querySelector('.jp-mod-dirty')", 30)
        assert browser.foreign_requests() == []
        browser.open("about:blank")
        live.end()
    assert MASTER.read_bytes() == master


@pytest.mark.timeout(300)
def test_a_lecture_is_shown_as_slides_and_its_cells_run_there(lecture, browser):
    with lecture("stability-regions", "--discard") as live:
        browser.resize(1280, 900)
        browser.open(live.address.replace("/doc/tree/", "/rise/"))
        assert browser.wait_for("location.hash.startsWith('#/slide-0')", 90), "the slides do not open"
        lab = Lab(browser)
        there = "[...document.querySelectorAll('.present .jp-CodeCell .cm-content')].filter(e => e.offsetParent)"
        for _ in range(20):  # the space bar goes on: title, question, and below it the first computation
            if browser.run("location.hash") == "#/slide-1-1":
                break
            lab.press(" ")
            time.sleep(1.5)
        assert browser.run("location.hash") == "#/slide-1-1"
        browser.run(f"{there}.at(-1)").click()
        lab.press(lab._keys.SHIFT, lab._keys.ENTER)
        ran = "[...document.querySelectorAll('.jp-InputPrompt')].some(prompt => prompt.innerText.includes('[1]'))"
        assert browser.wait_for(ran, 60), "the cell did not run"
        assert browser.foreign_requests() == []
        browser.open("about:blank")
        live.end()

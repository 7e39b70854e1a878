"""A lecture in JupyterLab as the class sees it, in a browser without a network."""

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
        return self._browser.run(
            f"Math.max(0, ...{CELLS}.map(cell => parseInt(cell.querySelector('.jp-InputPrompt')"
            ".innerText.match(/\\d+/)) || 0))"
        )

    def run_next(self):
        """Run the chosen cell and go to the next one; what it shows."""
        before = self.ran()
        self.press(self._keys.SHIFT, self._keys.ENTER)
        shown = (
            f"{CELLS}.find(cell => "
            f"cell.querySelector('.jp-InputPrompt').innerText.includes('[{before + 1}]'))"
            "?.querySelector('.jp-OutputArea')?.innerText"
        )
        assert self._browser.wait_for(
            f"{CELLS}.some(cell => cell.querySelector('.jp-InputPrompt').innerText"
            f".includes('[{before + 1}]'))",
            60,
        ), "the cell did not run"
        time.sleep(0.3)  # what it puts below comes after what it shows
        return self._browser.run(shown) or ""

    def below(self, source):
        """Write a cell below the chosen one and run it."""
        self.press(self._keys.ESCAPE)
        self.press("b")
        self.press(self._keys.ENTER)
        self.press(source)
        self.press(self._keys.SHIFT, self._keys.ENTER)
        self.press(self._keys.ESCAPE)

    def ran_all(self):
        assert self._browser.wait_for(
            "![...document.querySelectorAll('.jp-InputPrompt')].some("
            "prompt => prompt.innerText.includes('*'))",
            90,
        ), "a cell does not end"
        time.sleep(0.3)

    def chosen(self):
        return self._browser.run(
            "document.querySelector('.jp-Notebook .jp-Cell.jp-mod-active .cm-content').innerText"
        )


def check_explorer_of_formulas(browser):
    """A point is moved by a key, and the sentence follows without the kernel."""
    sentence = "document.querySelector('.explorer-sentence')?.textContent"
    assert browser.wait_for(f"{sentence}?.startsWith('All roots lie left')", 30)
    for _ in range(12):
        browser.find(".explorer .handle").send_keys("\ue015")  # the down arrow
    assert browser.wait_for(f"{sentence}.startsWith('Not all roots lie left')", 5)


def check_phase_portrait(browser):
    """A slider changes the picture, and so does a click."""
    figure = "[...document.querySelectorAll('.explorer')].find(box => box.querySelector('.field'))"
    assert browser.wait_for(f"!!{figure}?.querySelector('input')", 30)
    lines = f"[...{figure}.querySelectorAll('.line')].map(line => line.getAttribute('d')).join()"
    field = f"{figure}.querySelector('.field').getAttribute('d')"
    before = browser.run(field)
    browser.run(
        f"(input => {{ input.value = -1; input.dispatchEvent(new Event('input')); }})"
        f"({figure}.querySelector('input'))"
    )
    assert browser.run(field) != before, "the slider moves nothing"
    before = browser.run(lines)
    browser.run(
        f"(frame => {{ const box = frame.getBoundingClientRect(); frame.dispatchEvent(new MouseEvent("
        "'click', {clientX: box.left + 0.2*box.width, clientY: box.top + 0.5*box.height})); })"
        f"({figure}.querySelector('.frame'))"
    )
    assert browser.run(lines) != before, "the pointer moves nothing"


def check_poll(browser):
    """Hands are counted by a button; nothing is told before the reveal."""
    text = "document.querySelector('.workbook-poll').innerText"
    assert browser.wait_for(
        "document.querySelectorAll('.workbook-poll mjx-container').length >= 4", 30
    ), "no formulas"
    assert "right" not in browser.run(text)
    buttons = browser.driver.find_elements("css selector", ".workbook-poll button")
    assert [button.get_attribute("textContent").strip() for button in buttons] == ["+1"] * 4 + [
        "Reveal"
    ]
    for k in (1, 1, 2):
        browser.driver.execute_script("arguments[0].click()", buttons[k])
    assert browser.wait_for(f"{text}.includes('67%') && {text}.includes('33%')", 20)
    browser.driver.execute_script("arguments[0].click()", buttons[-1])
    assert browser.wait_for("document.querySelectorAll('.workbook-right').length === 1", 20)
    assert browser.run("document.querySelectorAll('.workbook-wrong').length") == 3
    assert "Which minor was not looked at?" in browser.run(text)


def check_fastest_motion(browser):
    """The motion starts from a point that is moved, and the play button goes along it."""
    figure = "[...document.querySelectorAll('.explorer')].at(-1)"
    text = f"{figure}.querySelector('.explorer-sentence')?.textContent"
    assert browser.wait_for(f"{text}?.includes('minimum time')", 60)
    before = browser.run(text)
    handles = browser.driver.find_elements("css selector", ".explorer .handle[role=slider]")
    handles[-1].send_keys("\ue015")
    assert browser.wait_for(f"{text} !== {before!r}", 5), "no new motion"
    assert "at t = 0 " in browser.run(text)
    browser.run(f"{figure}.querySelector('.explorer-controls button').click()")
    assert browser.wait_for(f"!{text}.includes('at t = 0 ')", 20), "it does not move"


def click(browser, selector, across, down, which=0):
    """A click of the mouse at parts of the width and height of an element."""
    from selenium.webdriver import ActionChains

    element = browser.driver.find_elements("css selector", selector)[which]
    browser.driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", element)
    size = element.size
    ActionChains(browser.driver).move_to_element_with_offset(
        element, (across - 0.5) * size["width"], (down - 0.5) * size["height"]
    ).click().perform()


@pytest.mark.timeout(600)
def test_a_lecture_runs_with_shift_enter(lecture, browser):
    master = MASTER.read_bytes()
    with lecture("1.15", "--discard") as live:
        browser.resize(1280, 900)
        browser.open(live.address)
        assert browser.wait_for(
            f"{CELLS}.filter(cell => cell.querySelector('.cm-content')?.offsetParent).length > 3",
            90,
        ), "the notebook does not open"
        assert browser.wait_for(IDLE, 60)
        large = browser.run(
            "parseFloat(getComputedStyle(document.querySelector('.jp-CodeCell "
            ".cm-content')).fontSize)"
        )
        assert large >= 20
        lab = Lab(browser)
        browser.find(".jp-NotebookPanel .jp-CodeCell .cm-content").click()
        time.sleep(1)
        lab.run_next()  # the data
        assert lab.chosen() == "%answer a_region"
        assert "The cubic, for all items" in lab.run_next()
        for _ in range(3):  # what it puts below is the next cell
            assert lab.chosen() == "%answer a_region"
            shown = lab.run_next()
        assert "The region lies above" in shown
        lab.run_next()
        assert "a_region = sp.And(k1 > 0, k1*k2 > 1)" in lab.chosen()
        assert "leading minors" in lab.run_next()
        lab.run_next()
        lab.run_next()  # the picture
        assert browser.run(f"{CELLS}.some(cell => cell.querySelector('.jp-OutputArea img'))")
        assert "Left: the region of item a" in lab.run_next()
        assert lab.chosen() == "%check a_region"
        assert "right" in lab.run_next()
        for magic in (
            "%mistake a_region",
            "%hint a_region",
            "%explore region_of_stability",
            "%explore phase_portrait 1.4",
            "%poll a_region",
            "%explore fastest_motion",
            "%explore nothing",
            "%catchup b_region",
        ):
            lab.below(magic)
            lab.ran_all()
        check_explorer_of_formulas(browser)
        check_phase_portrait(browser)
        check_poll(browser)
        check_fastest_motion(browser)
        shown = browser.run("document.querySelector('.jp-Notebook').innerText")
        assert (
            "there is no explorer nothing" in shown
            and "Traceback" not in shown
            and "cells run" in shown
        )
        lab.press(lab._keys.CONTROL, "s")
        assert browser.wait_for("!document.querySelector('.jp-mod-dirty')", 30)
        assert browser.foreign_requests() == []
        browser.open("about:blank")
        live.end()
    assert MASTER.read_bytes() == master


@pytest.mark.timeout(600)
def test_a_lecture_runs_as_slides_and_as_a_whole(lecture, browser):
    with lecture("stability-regions", "--discard") as live:
        browser.resize(1280, 900)
        browser.open(live.address.replace("/doc/tree/", "/rise/"))
        assert browser.wait_for("location.hash.startsWith('#/slide-0')", 90), (
            "the slides do not open"
        )
        lab = Lab(browser)
        # the space bar goes on: title, question, and the first computation, which the imports
        # precede unseen
        for _ in range(20):
            if browser.run("location.hash") == "#/slide-2-1":
                break
            lab.press(" ")
            time.sleep(1.5)
        assert browser.run("location.hash") == "#/slide-2-1"
        lab.press(lab._keys.SHIFT, lab._keys.ENTER)
        ran = "[...document.querySelectorAll('.jp-InputPrompt')].some(prompt => prompt.textContent.includes('[2]'))"
        assert browser.wait_for(ran, 60), "the cell did not run"
        poll = (
            "[...document.querySelectorAll('section')].find(slide => "
            "!slide.querySelector('section') && "
            "slide.querySelector('.jp-CodeCell .cm-content')?.innerText.startsWith('%poll'))"
        )
        browser.run(f"location.hash = '#/' + {poll}.id")
        assert browser.wait_for(f"{poll}.classList.contains('present')", 30), (
            "the slide of the poll does not come"
        )
        time.sleep(1)
        lab.press(lab._keys.SHIFT, lab._keys.ENTER)
        check_poll(browser)  # widgets load on slides too
        assert browser.run(f"{poll}.classList.contains('present')"), "Shift+Enter left the slide"
        assert browser.foreign_requests() == []

        browser.open(live.address)  # the same notebook, not as slides
        assert browser.wait_for(f"{CELLS}.length > 8 && !!window.jupyterapp", 90), (
            "the notebook does not open"
        )
        assert browser.wait_for(IDLE, 60)
        browser.run("void window.jupyterapp.commands.execute('notebook:run-all-cells')")
        waiting = (
            f"{CELLS}.filter(cell => !/\\d/.test(cell.querySelector('.jp-InputPrompt').innerText))"
        )
        written = f"{waiting}.filter(cell => cell.querySelector('.cm-content')?.innerText.trim())"
        assert browser.wait_for(
            f"{IDLE} && {written}.every(cell => cell.innerText.includes('%'))", 120
        ), browser.run(f"{written}.map(cell => cell.innerText)")
        assert (
            browser.run(f"{CELLS}.filter(cell => cell.querySelector('.jp-OutputArea img')).length")
            >= 3
        )
        failed = "[data-mime-type='application/vnd.jupyter.error'], [data-mime-type='application/vnd.jupyter.stderr']"
        assert (
            browser.run(f'[...document.querySelectorAll("{failed}")].map(part => part.innerText)')
            == []
        )
        assert browser.foreign_requests() == []
        browser.open("about:blank")
        live.end()

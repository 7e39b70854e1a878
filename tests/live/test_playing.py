"""Lectures from their documented command to the end, as a class sees them.

Here two are played as slides, on a wide screen and on a narrow one, and one in JupyterLab;
`make test-lectures` plays all, on both screens.
"""

import itertools
import os
import time

import pytest

from workbook.live import find_presentation, lectures
from workbook.live.lecture_notebook import lecture_notebook
from workbook.live.slide_texts import MOST_WORDS, word_count

SLUGS = [lecture.name for lecture in lectures()]
WIDE, NARROW = (1920, 1080), (1024, 768)
PLAYED = (
    list(itertools.product(SLUGS, (WIDE, NARROW)))
    if "WORKBOOK_EVERY_LECTURE" in os.environ
    else [("limit-cycles", WIDE), ("stability-regions", NARROW)]
)
IN_LAB = SLUGS if "WORKBOOK_EVERY_LECTURE" in os.environ else ["stability-regions"]
#: Seconds that a step may take, and lines of code that fit on a slide with what they show.
LONGEST_STEP, MOST_LINES = 3, 23
FAILED = "[data-mime-type='application/vnd.jupyter.error'], [data-mime-type='application/vnd.jupyter.stderr']"
#: Size of the smallest type as a share of the text; share of the slide that its content spans, below
#: the title: of one slide, and of all on average.
SMALLEST_TYPE, LEAST_INK, MEAN_INK = 0.6, 0.02, 0.25
SLIDE = "document.querySelector('section section.present')"
#: What a slide shows below its title: the size of its smallest type in pixels, without formulas and
#: what the folded code hides, and the share of the screen that it spans.
MEASURED = """(() => {
  const slide = document.querySelector('section section.present'), range = document.createRange();
  let smallest = Infinity, left = innerWidth, right = 0, top = innerHeight, bottom = 0;
  for (const node of slide.querySelectorAll('*')) {
    if (node.closest('.workbook-title') || node.parentElement.closest('mjx-container')) continue;
    const texts = [...node.childNodes].filter(child => child.nodeType === Node.TEXT_NODE && child.data.trim());
    const picture = node.matches('img, svg, mjx-container');
    if (!picture && !texts.length) continue;
    range.selectNodeContents(node);
    const box = (picture ? node : range).getBoundingClientRect();
    if (box.width < 2 || box.height < 2) continue;
    [left, right] = [Math.min(left, box.left), Math.max(right, box.right)];
    [top, bottom] = [Math.min(top, box.top), Math.max(bottom, box.bottom)];
    if (texts.length) {
      const scale = node.getScreenCTM ? node.getScreenCTM().a : node.currentCSSZoom;
      smallest = Math.min(smallest, parseFloat(getComputedStyle(node).fontSize)*scale);
    }
  }
  return [smallest, Math.max(0, right - left)*Math.max(0, bottom - top)/innerWidth/innerHeight];
})()"""
#: What has a vertical scroll bar within a slide.
SCROLLED = f"""[...{SLIDE}.querySelectorAll("*")].filter(node =>
  /auto|scroll/.test(getComputedStyle(node).overflowY) && node.clientHeight > 5
  && node.scrollHeight > node.clientHeight + 1
).map(node => node.className)"""
CELLS = "[...document.querySelectorAll('.jp-Notebook .jp-CodeCell')]"


@pytest.mark.parametrize("slug", SLUGS)
def test_a_slide_has_at_most_forty_words_or_a_screen_of_code(slug):
    for cell in lecture_notebook(find_presentation(slug))["cells"]:
        if cell["cell_type"] == "markdown":
            assert word_count(cell["source"]) <= MOST_WORDS, cell["source"]
        elif not cell["metadata"].get("jupyter", {}).get("source_hidden"):
            assert len(cell["source"].split("\n")) <= MOST_LINES, cell["source"]


@pytest.mark.parametrize("slug", SLUGS)
def test_no_title_is_alone_and_the_code_of_pictures_is_folded(slug):
    cells = [
        cell
        for cell in lecture_notebook(find_presentation(slug))["cells"]
        if cell["metadata"]["slideshow"]["slide_type"] != "skip"
    ]
    for cell, after in itertools.pairwise(cells):
        if word_count(cell["source"]) == 0 and cell["cell_type"] == "markdown":
            assert after["metadata"]["slideshow"]["slide_type"] == "-", cell["source"]
    drawing = [cell for cell in cells if "plt.subplots" in cell["source"]]
    assert drawing and all(cell["metadata"]["jupyter"]["source_hidden"] for cell in drawing)


def shift_enter(browser):
    from selenium.webdriver import ActionChains
    from selenium.webdriver.common.keys import Keys

    ActionChains(browser.driver).key_down(Keys.SHIFT).send_keys(Keys.ENTER).key_up(
        Keys.SHIFT
    ).perform()


def run_step(browser, cell, done):
    """Run the chosen cell, which is `cell` in JavaScript, and wait until `done` is true."""
    began = time.monotonic()
    shift_enter(browser)
    assert browser.wait_for(done, 30), (
        f"did not run: {browser.run(f'{cell}.textContent.slice(0, 200)')}"
    )
    seconds = time.monotonic() - began
    text = browser.run(f"{cell}.innerText")
    assert seconds < LONGEST_STEP, f"{seconds:.1f} s: {text}"
    assert "Traceback" not in text and "UsageError" not in text, text
    assert browser.run(f'{cell}.querySelector("{FAILED}") === null'), text


@pytest.mark.timeout(900)
@pytest.mark.parametrize("slug, screen", PLAYED)
def test_a_lecture_plays_as_slides(slug, screen, lecture, browser):
    with lecture(slug, "--prepare", "--discard") as live:
        browser.resize(*screen)
        browser.open(live.address.replace("/doc/tree/", "/rise/"))
        assert browser.wait_for("!!document.querySelector('.workbook-title')", 90)
        text_size = browser.run(
            "parseFloat(getComputedStyle(document.body).getPropertyValue("
            "'--jp-content-font-size1').match(/[0-9.]+/)) * Math.min(innerWidth, 1.6*innerHeight)/100"
        )
        assert text_size >= 0.019 * screen[0]
        visited, ink = set(), []
        while (slide := browser.run(f"{SLIDE}.id")) not in visited:
            visited.add(slide)
            cell = f"{SLIDE}.querySelector('.jp-CodeCell:not(.reveal-skip)')"
            if browser.run(f"{cell} !== null"):
                # it is chosen when the slide comes; what would leave the slide empty has run
                assert browser.wait_for(f"{cell}.classList.contains('jp-mod-active')", 10), slide
                if browser.run(f"!{cell}.dataset.state"):
                    assert browser.run(MEASURED)[1] > LEAST_INK, f"{slide} is empty"
                    run_step(browser, cell, f"{cell}.dataset.state === 'ran'")
                assert browser.wait_for(f"{cell}?.dataset.state !== 'running'", 30), slide
                assert browser.run(f"{SLIDE}.id") == slide, "Shift+Enter left the slide"
                time.sleep(0.3)  # what it shows is laid out, what it inserts has its place
            text = browser.run(f"{SLIDE}.innerText")
            assert browser.run(f'{SLIDE}.querySelector("{FAILED}") === null'), text
            assert browser.run(
                f"{SLIDE}.scrollHeight <= {SLIDE}.clientHeight + 1 && "
                f"{SLIDE}.scrollWidth <= {SLIDE}.clientWidth + 1"
            ), text
            assert browser.run(SCROLLED) == [], text
            smallest, share = browser.run(MEASURED)
            assert smallest is None or smallest >= SMALLEST_TYPE * text_size, (smallest, text)
            assert share > LEAST_INK, f"{slide} is empty: {text}"
            ink.append(share)
            browser.driver.switch_to.active_element.send_keys(" ")
            browser.wait_for(f"{SLIDE}.id !== {slide!r}", 1)
        assert len(visited) > 20
        assert sum(ink) / len(ink) > MEAN_INK
        heading = "getComputedStyle(document.querySelector('.reveal h1')).textTransform"
        assert browser.run(heading) == "none"
        assert browser.foreign_requests() == []
        assert browser.errors() == []
        browser.open("about:blank")
        live.end()


@pytest.mark.timeout(900)
@pytest.mark.parametrize("slug", IN_LAB)
def test_a_lecture_plays_in_lab(slug, lecture, browser):
    with lecture(slug, "--prepare", "--discard") as live:
        browser.resize(1280, 800)
        browser.open(live.address)
        notebook = "window.jupyterapp.shell.currentWidget.content"
        assert browser.wait_for(
            f"{CELLS}.length > 8 && !!window.jupyterapp?.shell.currentWidget?.content", 90
        )
        assert browser.wait_for(
            "document.querySelector('.jp-Notebook-ExecutionIndicator')?.dataset.status === 'idle'",
            60,
        )
        browser.run(f"void ({notebook}.activeCellIndex = 0, {notebook}.activate())")
        last = None
        while (k := browser.run(f"{notebook}.activeCellIndex")) != last:
            assert k == 0 if last is None else k == last + 1, "a cell is passed over"
            last = k
            if browser.run(f"{notebook}.activeCell.model.type") == "code":
                cell = f"{notebook}.widgets[{k}]"
                done = f"{cell}.model.executionCount && {cell}.model.executionState === 'idle'"
                run_step(browser, f"{cell}.node", done)
            else:
                shift_enter(browser)
            browser.wait_for(f"{notebook}.activeCellIndex !== {k}", 1)
        assert last > 20
        browser.open("about:blank")
        live.end()

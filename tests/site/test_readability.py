"""Readability on a phone and in print: scroll boxes, letters in pictures, folds, breaks."""

import base64

import pytest

#: Backgrounds of all boxes that may scroll: code, printed lines, formulas and tables.
BACKGROUNDS = """[...document.querySelectorAll('article :is(div.math, pre, .pst-scrollable-table-container)')].map(
    e => getComputedStyle(e).backgroundAttachment)"""


@pytest.mark.parametrize(
    "page",
    [
        "solutions/ch1/p15.html",
        "solutions/ch4/p17.html",
        "book/errata/ch5.html",
        "book/library/estimation.html",
        "book/guides/grading.html",
    ],
)
def test_a_box_that_scrolls_on_a_phone_has_a_shadow(browser, addresses, page):
    browser.resize(390, 844, phone=True)
    browser.open(f"{addresses['http']}/{page}")
    backgrounds = browser.run(BACKGROUNDS)
    assert backgrounds and all("local" in each and "scroll" in each for each in backgrounds)
    browser.resize(1280, 900)


#: For each picture: its scale relative to its natural size, and whether all of it can be seen.
PICTURES = """Promise.all([...document.querySelectorAll('article figure img')].map(e => e.decode().then(() => {
    const shown = e.getBoundingClientRect().width, box = e.closest('.panels') || e.closest('figure');
    return [e.alt, shown/e.naturalWidth, shown <= box.clientWidth || getComputedStyle(box).overflowX === 'auto'];
    })))"""


@pytest.mark.parametrize(
    "page",
    [
        "solutions/ch1/p15.html",
        "solutions/ch3/p12.html",
        "solutions/ch4/p20.html",
        "solutions/ch5/p19.html",
        "solutions/ch7/p03.html",
        "book/ch5/example_circle.html",
    ],
)
def test_the_letters_of_a_picture_are_legible_on_a_phone(browser, addresses, page):
    """Two panels side by side must not be scaled to a third of their size."""
    browser.resize(390, 844, phone=True)
    browser.open(f"{addresses['http']}/{page}")
    browser.run("document.querySelectorAll('article details').forEach(fold => fold.open = true)")
    pictures = browser.driver.execute_async_script(f"{PICTURES}.then(arguments[0])")
    browser.resize(1280, 900)
    assert pictures and not [alt for alt, size, whole in pictures if size < 0.5 or not whole]


def test_the_glossary_fits_the_width_of_a_phone(browser, addresses):
    browser.resize(390, 844, phone=True)
    browser.open(f"{addresses['http']}/book/glossary.html")
    beyond = browser.run("""[...document.querySelectorAll('article td')].filter(
        e => e.getBoundingClientRect().right > innerWidth).map(e => e.innerText.slice(0, 40))""")
    assert browser.run("document.querySelectorAll('article td').length") > 500 and beyond == []
    browser.resize(1280, 900)


def test_no_text_is_too_thin_to_read(browser, addresses):
    """The theme alone would use its thinnest font for captions."""
    browser.open(f"{addresses['http']}/solutions/ch1/p09.html")
    thin = browser.run("""[...document.querySelectorAll('article :is(p, span, li, td, code, figcaption)')].filter(
        e => +getComputedStyle(e).fontWeight < 400).map(e => e.innerText.slice(0, 40))""")
    assert browser.run("document.querySelectorAll('article figcaption').length") > 1 and thin == []


def test_every_fold_is_open_in_print(browser, addresses, problem):
    """Chromium prints to PDF; a listener after ours counts the closed folds.

    Common mistakes and topics that the reader has not opened are not printed.
    """
    browser.resize(1280, 900)
    browser.open(f"{addresses['http']}/{problem.page}")
    browser.driver.execute_script("""addEventListener('beforeprint', () => {
        window.foldsClosed = document.querySelectorAll(
            'article details:not([open], .mistakes, .topics)').length; });""")
    document = browser.driver.execute_cdp_cmd("Page.printToPDF", {})
    assert base64.b64decode(document["data"]).startswith(b"%PDF")
    assert browser.run("window.foldsClosed") == 0
    assert browser.run("document.querySelectorAll('article details.solution[open]').length") == 0


def test_a_drawing_is_printed_without_its_code(browser, addresses):
    """The code of a drawing is no part of the statement; the code of a solution is printed."""
    browser.open(f"{addresses['http']}/solutions/ch5/p40.html")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    browser.run("document.querySelectorAll('article details').forEach(fold => fold.open = true)")
    height = "e => e.getBoundingClientRect().height"
    drawn = browser.run(f"[...document.querySelectorAll('.tag_drawing .cell_input')].map({height})")
    pictures = browser.run(f"[...document.querySelectorAll('.tag_drawing img')].map({height})")
    computed = browser.run(
        f"[...document.querySelectorAll('.tag_answer .cell_input')].map({height})"
    )
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    assert drawn and set(drawn) == {0} and min(pictures) > 50 and min(computed) > 20


@pytest.mark.parametrize("width", [718, 800], ids=["browser", "pdf"])
def test_no_line_of_code_is_broken_in_print(browser, addresses, width):
    """The window is as wide as a sheet of paper between its margins, in the scale of `book/pdf.py`."""
    browser.resize(width, 1000)
    browser.open(f"{addresses['http']}/solutions/ch4/p18.html")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    browser.run("document.querySelectorAll('article details').forEach(fold => fold.open = true)")
    broken = browser.run("""[...document.querySelectorAll('article .cell_input pre')].map(e => {
        e.style.whiteSpace = 'pre'; return e.scrollWidth - e.clientWidth; })""")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    browser.resize(1280, 900)
    assert broken and max(broken) <= 1


def test_a_fold_does_not_fade_in_in_print(browser, addresses, problem):
    """An element that fades in as its fold opens is blank when the page is printed."""
    browser.open(f"{addresses['http']}/{problem.page}")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    fading = browser.run("""(() => {
        document.querySelectorAll('article details').forEach(fold => fold.open = true);
        return document.getAnimations().filter(one => one.effect.target.closest('article')).length })()""")
    buttons = browser.run("""[...document.querySelectorAll('article details.hide > summary')].map(
        e => getComputedStyle(e).display)""")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    assert fading == 0 and set(buttons) == {"none"}


def test_formulas_are_not_bold_and_tables_break_in_print(browser, addresses):
    """A stroke around letters makes formulas bold; an unbreakable table leaves a page blank."""
    browser.open(f"{addresses['http']}/solutions/ch2/p24.html")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    strokes = browser.run("""[...document.querySelectorAll('article mjx-container svg :is(path, use)')].map(
        e => getComputedStyle(e).stroke)""")
    tables = browser.run(
        "[...document.querySelectorAll('article table')].map(e => getComputedStyle(e).breakInside)"
    )
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    assert set(strokes) == {"none"} and set(tables) == {"auto"}


#: Colours, as [red, green, blue], of all text of the article, and of the page.
INKS = """(() => {
    const numbers = (e, property) => getComputedStyle(e)[property].match(/[\\d.]+/g).slice(0, 3).map(Number);
    const text = document.querySelectorAll('article :is(p, h1, h2, li, pre)');
    return [...[...text].map(e => numbers(e, 'color')), numbers(document.body, 'backgroundColor')];
    })()"""


@pytest.mark.parametrize(
    "page", ["solutions/ch1/p15.html", "book/ch1/hurwitz.html", "book/index.html"]
)
def test_the_dark_theme_is_printed_as_dark_ink_on_white(browser, addresses, page):
    browser.resize(1280, 900)
    browser.open(f"{addresses['http']}/{page}")
    theme = browser.run("document.documentElement.dataset.theme")
    browser.show_theme("dark")
    browser.run(f"addEventListener('beforeprint', () => {{ window.inks = {INKS}; }})")
    browser.driver.execute_cdp_cmd("Page.printToPDF", {})
    *inks, ground = browser.run("window.inks")
    after = browser.run("document.documentElement.dataset.theme")
    browser.show_theme(theme)
    assert after == "dark" and len(inks) > 10 and min(ground) > 240
    assert max(sum(ink) / 3 for ink in inks) < 140

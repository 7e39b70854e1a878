"""Pages as people see them: what scrolls on a phone, letters of pictures, on paper."""

import base64

import pytest

#: Grounds of all that may have to scroll; code, printed lines, formulas and tables.
GROUNDS = """[...document.querySelectorAll('article :is(div.math, pre, .pst-scrollable-table-container)')].map(
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
def test_what_has_to_scroll_on_a_phone_shows_a_shadow(browser, addresses, page):
    browser.resize(390, 844, phone=True)
    browser.open(f"{addresses['http']}/{page}")
    grounds = browser.run(GROUNDS)
    assert grounds and all("local" in ground and "scroll" in ground for ground in grounds)
    browser.resize(1280, 900)


#: Of each picture: how large it is beside what it was drawn for, and whether all of it can be seen.
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
        "book/ch5.html",
    ],
)
def test_the_letters_of_a_picture_are_read_on_a_phone(browser, addresses, page):
    """Two panels side by side would be a third of their size."""
    browser.resize(390, 844, phone=True)
    browser.open(f"{addresses['http']}/{page}")
    browser.run("document.querySelectorAll('article details').forEach(fold => fold.open = true)")
    pictures = browser.driver.execute_async_script(f"{PICTURES}.then(arguments[0])")
    browser.resize(1280, 900)
    assert pictures and not [alt for alt, size, whole in pictures if size < 0.5 or not whole]


def test_the_glossary_is_read_on_a_phone_without_scrolling_sideways(browser, addresses):
    browser.resize(390, 844, phone=True)
    browser.open(f"{addresses['http']}/book/glossary.html")
    beyond = browser.run("""[...document.querySelectorAll('article td')].filter(
        e => e.getBoundingClientRect().right > innerWidth).map(e => e.innerText.slice(0, 40))""")
    assert browser.run("document.querySelectorAll('article td').length") > 500 and beyond == []
    browser.resize(1280, 900)


def test_nothing_is_set_too_thin_to_read(browser, addresses):
    """The theme sets captions in its thinnest letters."""
    browser.open(f"{addresses['http']}/solutions/ch1/p09.html")
    thin = browser.run("""[...document.querySelectorAll('article :is(p, span, li, td, code, figcaption)')].filter(
        e => +getComputedStyle(e).fontWeight < 400).map(e => e.innerText.slice(0, 40))""")
    assert browser.run("document.querySelectorAll('article figcaption').length") > 1 and thin == []


def test_on_paper_every_fold_is_open(browser, addresses, problem):
    """Chromium prints for real; what was open at that moment is noted by a listener that comes
    after ours."""
    browser.resize(1280, 900)
    browser.open(f"{addresses['http']}/{problem.page}")
    browser.driver.execute_script("""addEventListener('beforeprint', () => {
        window.foldsClosed = document.querySelectorAll('article details:not([open])').length; });""")
    document = browser.driver.execute_cdp_cmd("Page.printToPDF", {})
    assert base64.b64decode(document["data"]).startswith(b"%PDF")
    assert browser.run("window.foldsClosed") == 0
    assert browser.run("document.querySelectorAll('article details.solution[open]').length") == 0


def test_on_paper_a_drawing_stands_without_its_code(browser, addresses):
    """What draws the body of a statement is no part of the statement; the code of a solution is
    printed."""
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


def test_on_paper_no_line_of_code_is_broken(browser, addresses):
    """What is as wide as a sheet of paper between its margins, in points of a screen."""
    browser.resize(718, 1000)
    browser.open(f"{addresses['http']}/solutions/ch4/p18.html")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    browser.run("document.querySelectorAll('article details').forEach(fold => fold.open = true)")
    broken = browser.run("""[...document.querySelectorAll('article .cell_input pre')].map(e => {
        e.style.whiteSpace = 'pre'; return e.scrollWidth - e.clientWidth; })""")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    browser.resize(1280, 900)
    assert broken and max(broken) <= 1


def test_on_paper_a_fold_does_not_fade_in(browser, addresses, problem):
    """What fades in as its fold opens is blank at the moment when the page is printed."""
    browser.open(f"{addresses['http']}/{problem.page}")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    fading = browser.run("""(() => {
        document.querySelectorAll('article details').forEach(fold => fold.open = true);
        return document.getAnimations().filter(one => one.effect.target.closest('article')).length })()""")
    buttons = browser.run("""[...document.querySelectorAll('article details.hide > summary')].map(
        e => getComputedStyle(e).display)""")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    assert fading == 0 and set(buttons) == {"none"}


def test_on_paper_formulas_are_as_thin_as_words_and_tables_go_on_overleaf(browser, addresses):
    """A line round each letter that a screen does not show makes formulas bold in a document; a
    table that is kept together leaves the first page of a guide nearly blank."""
    browser.open(f"{addresses['http']}/solutions/ch2/p24.html")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    strokes = browser.run("""[...document.querySelectorAll('article mjx-container svg :is(path, use)')].map(
        e => getComputedStyle(e).stroke)""")
    tables = browser.run(
        "[...document.querySelectorAll('article table')].map(e => getComputedStyle(e).breakInside)"
    )
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    assert set(strokes) == {"none"} and set(tables) == {"auto"}

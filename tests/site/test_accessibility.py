"""Axe finds no fault in a page of each kind in both themes: folds open, desktop and phone."""

import pytest
from selenium_axe_python import Axe

PAGES = [
    "book/index.html",
    "book/ch1/hurwitz.html",
    "book/problems.html",
    "book/topics.html",
    "book/glossary.html",
    "book/errata/index.html",
    "book/errata/ch7.html",
    "book/bibliography.html",
    "book/guides/student.html",
    "book/guides/grading.html",
    "book/library.html",
    "book/library/structure.html",
    "book/lectures.html",
    "book/ch5.html",
    "book/ch9/figures.html",
    "solutions/ch1/p15.html",
    "solutions/ch2/p25.html",
    "solutions/ch4/p18.html",
    "solutions/ch5/p03.html",
    "genindex.html",
]
#: In addition to the default rules: the text of a button is in its name. Axe takes a header cell that
#: holds only MathML for empty.
OPTIONS = """{resultTypes: ['violations'],
    rules: {'label-content-name-mismatch': {enabled: true}, 'empty-table-header': {enabled: false}}}"""
COLOURS = "{resultTypes: ['violations'], runOnly: ['color-contrast']}"
#: So header cells and folds without a name are found here.
NAMELESS = """[...document.querySelectorAll('summary, article th')].filter(e => !e.querySelector('math')
    && !(e.getAttribute('aria-label') || e.innerText || '').trim()).map(e => e.outerHTML)"""


@pytest.fixture
def browser(moving_browser):
    """Return a browser that renders frames: icons are drawn in them."""
    return moving_browser


@pytest.fixture
def faults(browser):
    """Return a function that opens a page and returns its faults: rule and element."""
    axe = Axe(browser.driver)

    def faults_of(address, before=lambda: None):
        browser.open(address)
        before()
        browser.run(
            "document.querySelectorAll('article details').forEach(fold => fold.open = true)"
        )
        axe.inject()
        violations = axe.run("document", OPTIONS)["violations"]
        # no other rule depends on the theme
        light = browser.run("document.documentElement.dataset.theme") == "light"
        browser.show_theme("dark" if light else "light")
        violations += axe.run("document", COLOURS)["violations"]
        return [
            (rule["id"], node["html"][:150]) for rule in violations for node in rule["nodes"]
        ] + [("nameless", element[:150]) for element in browser.run(NAMELESS)]

    yield faults_of
    browser.forget()
    browser.resize(1280, 900)


@pytest.mark.parametrize("page", PAGES)
def test_a_page_of_each_kind(browser, addresses, faults, page):
    browser.resize(1400, 900)
    assert faults(f"{addresses['http']}/{page}") == []


def test_a_student_page_on_a_phone(browser, addresses, faults):
    browser.resize(390, 844, phone=True)
    assert faults(f"{addresses['student']}/exercises/ch1/p15.html") == []


#: Scripts of a page run in no fixed order; this one delays ours until the theme has drawn its icons.
LATE = """const listen = window.addEventListener;
    window.addEventListener = function (event, act, ...how) {
        const late = this === window && event === 'DOMContentLoaded';
        return late ? listen.call(this, 'load', () => setTimeout(() => { act(); window.wasLate = true; }, 500))
                    : listen.call(this, event, act, ...how); }"""


def test_icons_that_are_drawn_before_our_script_runs(browser, addresses, faults):
    script = browser.driver.execute_cdp_cmd(
        "Page.addScriptToEvaluateOnNewDocument", {"source": LATE}
    )
    try:
        assert (
            faults(
                f"{addresses['http']}/book/errata/index.html",
                lambda: browser.wait_for("window.wasLate"),
            )
            == []
        )
        assert (
            browser.run(
                "window.wasLate && document.querySelectorAll('.theme-switch-button svg').length"
            )
            == 3
        )
    finally:
        browser.driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", script)


def test_the_open_search_with_its_hits(browser, addresses, faults, search_for):
    def search():
        search_for("criterion")
        assert browser.wait_for("document.querySelector('#search-hits mjx-container')")

    assert faults(f"{addresses['http']}/book/index.html", search) == []

"""The layout of every page, with scroll bars: nothing overflows or is cut off.

Each page is opened once for all its tests: loading it and typesetting its formulas is what costs.
"""

import re
from pathlib import Path, PurePosixPath

import pytest

from workbook.authoring import master_paths

SOLUTIONS = Path(__file__).resolve().parents[2] / "solutions"
#: Number -> the page of a problem.
PROBLEMS = {
    f"{path.parent.name[2:]}.{int(path.stem[1:])}": f"solutions/{path.parent.name}/{path.stem}.html"
    for path in master_paths(SOLUTIONS)
}
PHONE = 390
#: Pages with many formulas, long code and long outputs: the problems, the chapters, the guides and
#: the library.
WIDE = (
    "solutions/ch*/p*.html",
    "book/ch*/*.html",
    "book/guides/*.html",
    "book/guides/tutorials/*.html",
    "book/library/*.html",
)


@pytest.fixture(scope="module", autouse=True)
def desktop_window_afterwards(browser):
    yield
    browser.resize(1280, 900)


# The longest test first, so that no process waits for it at the end.
@pytest.mark.parametrize("number", ["the other pages", *PROBLEMS])
def test_every_page_fits_a_phone_and_a_desktop_without_errors(
    browser, addresses, editions, pages_of, number, record_property
):
    began = browser.core_seconds()
    pages = {path.relative_to(editions.full).as_posix() for path in pages_of(editions.full)}
    assert pages.issuperset(PROBLEMS.values())
    for page in (
        [PROBLEMS[number]] if number in PROBLEMS else sorted(pages.difference(PROBLEMS.values()))
    ):
        assert _faults_on_a_phone(browser, f"{addresses['http']}/{page}") == []
        if any(PurePosixPath(page).match(pattern) for pattern in WIDE):
            assert _cut_off(browser, 1400) == {}, page
        browser.forget()
    record_property("core seconds in Chromium", round(browser.core_seconds() - began, 3))


def test_cut_off_elements_are_found(browser, addresses):
    """Also in a window that was a phone before: its scroll bars take room again."""
    browser.resize(PHONE, 844, phone=True)
    browser.open(f"{addresses['http']}/solutions/ch4/p17.html")
    assert {"code", "displayed", "tables"} <= _cut_off(browser, 620).keys()
    assert browser.wait_for("innerWidth - document.documentElement.clientWidth > 10")


def test_the_column_of_text_stays_in_its_place(browser, addresses):
    """Also on a page that has no headings to list beside it."""
    browser.resize(1400, 900)
    left = []
    for page in ("solutions/ch1/p15.html", "book/ch1/hurwitz.html"):
        browser.open(f"{addresses['http']}/{page}")
        left.append(
            browser.run("document.querySelector('.bd-article').getBoundingClientRect().left")
        )
    assert left[0] == left[1] > 0


def test_pages_of_the_student_edition_alone_fit_a_phone_without_errors(
    browser, addresses, editions, pages_of
):
    """Most of its pages show a part of those of the other edition, which are tested above."""
    pages = {
        path.relative_to(editions.student).as_posix(): path for path in pages_of(editions.student)
    }
    own = [
        page
        for page, path in pages.items()
        if not _shown(path) <= _shown(editions.full / page.replace("exercises/", "solutions/"))
    ]
    assert "genindex.html" in own and len(own) < len(pages) / 5
    for page in {*own, "book/index.html", "exercises/ch1/p15.html"}:
        assert _faults_on_a_phone(browser, f"{addresses['student']}/{page}") == []


#: Elements that may be too wide or fail to be typeset. Code scrolls in its own box on every page.
SHOWN = re.compile(
    r'<(span|div) class="math[ "][^>]*>.*?</\1>|<(table)\b.*?</table>|<(img|svg)\b[^>]*>', re.DOTALL
)
#: Differences between the editions: addresses, and the letter of a page's only figure.
EDITION_SPECIFIC = re.compile(r'(href|src|id|data-[a-z]+)="[^"]*"|(?<=\d)[a-z](?=:)')


def _shown(path):
    """Return the formulas, tables and pictures of a page."""
    if not path.exists():
        return set()
    article = path.read_text(encoding="utf-8").partition("<article")[2].partition("</article>")[0]
    return {EDITION_SPECIFIC.sub("", found[0]) for found in SHOWN.finditer(article)}


def _faults_on_a_phone(browser, address):
    """Return the faults of a page on a phone, with all folds open."""
    browser.resize(PHONE, 844, phone=True)
    browser.open(address)
    browser.run("document.querySelectorAll('details').forEach(fold => fold.open = true)")
    width = browser.run("document.documentElement.scrollWidth")
    broken = browser.run(
        "[...document.querySelectorAll('mjx-merror, [data-mjx-error]')].map(e => "
        "e.dataset.mjxError || e.innerText)"
    )
    unset = browser.run("""[...document.querySelectorAll('.math')].filter(
        e => !e.querySelector('mjx-container') && e.innerText.trim()).map(e => e.innerText.slice(0, 60))""")
    faults = [f"{width} px wide"] if width > PHONE else []
    return [
        f"{address}: {fault}"
        for fault in faults + broken + unset + browser.errors() + browser.foreign_requests()
    ]


def _cut_off(browser, width):
    """Return kind -> number of the elements that are cut off or have a scroll bar on a desktop."""
    browser.resize(width, 900)
    return {kind: count for kind, count in browser.run(CUT_OFF).items() if count}


CUT_OFF = """(() => {
    document.querySelectorAll('article details').forEach(fold => fold.open = true);
    const of = selector => [...document.querySelectorAll(selector)];
    const scrolls = e => e.scrollWidth > e.clientWidth + 1;
    const clips = e => getComputedStyle(e).overflowX !== 'visible'
        && (scrolls(e) || e.scrollHeight > e.clientHeight + 1);
    const right = document.querySelector('article').getBoundingClientRect().right;
    return {
        inline: of('article mjx-container:not([display="true"])').filter(clips).length,
        displayed: of('article div.math').filter(scrolls).length,
        tables: of('article table').filter(e => e.getBoundingClientRect().right > right + 1
            || getComputedStyle(e.parentElement).overflowX !== 'visible' && scrolls(e.parentElement)).length,
        beyond: of('article span.math svg').filter(e => e.getBoundingClientRect().right > right).length,
        code: of('article .highlight pre').filter(scrolls).length,
        printed: of('article .cell_output pre').filter(scrolls).length,
    }})()"""

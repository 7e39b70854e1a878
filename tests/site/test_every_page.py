"""Every page as people see it, with scroll bars on: it fits a phone without errors, and at a desk
nothing is cut off.

A page is opened once and asked all of it: what a visit costs is loading the page and setting its
formulas.
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
WIDE = ("solutions/ch*/p*.html", "book/ch*.html", "book/guides/*.html", "book/library/*.html")


@pytest.fixture(scope="module", autouse=True)
def at_a_desk_again(browser):
    yield
    browser.resize(1280, 900)


# First what takes longest: no process waits for it at the end.
@pytest.mark.parametrize("number", ["the other pages", *PROBLEMS])
def test_every_page_fits_a_phone_and_a_desk_without_errors(
    browser, addresses, editions, pages_of, number, record_property
):
    began = browser.computed()
    pages = {path.relative_to(editions.full).as_posix() for path in pages_of(editions.full)}
    assert pages.issuperset(PROBLEMS.values())
    for page in (
        [PROBLEMS[number]] if number in PROBLEMS else sorted(pages.difference(PROBLEMS.values()))
    ):
        assert _faults_on_a_phone(browser, f"{addresses['http']}/{page}") == []
        if any(PurePosixPath(page).match(pattern) for pattern in WIDE):
            assert _cut_off(browser, 1400) == {}, page
        browser.forget()
    record_property("core seconds in Chromium", round(browser.computed() - began, 3))


def test_what_is_cut_off_is_seen(browser, addresses):
    """Also in a window that was a phone before: it has scroll bars again, which take room."""
    browser.resize(PHONE, 844, phone=True)
    browser.open(f"{addresses['http']}/solutions/ch4/p17.html")
    assert {"code", "displayed", "tables"} <= _cut_off(browser, 620).keys()
    assert browser.run("innerWidth - document.documentElement.clientWidth") > 10


def test_what_the_student_edition_alone_shows_fits_a_phone_without_errors(
    browser, addresses, editions, pages_of
):
    """Most of its pages show a part of what those of the other edition do, and that has been seen
    to fit."""
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


#: What may be too wide or fail to be set. Code scrolls in its own box on every page.
SHOWN = re.compile(
    r'<(span|div) class="math[ "][^>]*>.*?</\1>|<(table)\b.*?</table>|<(img|svg)\b[^>]*>', re.DOTALL
)
#: What may differ between the editions: addresses, and the letter of a figure where it is the only
#: one of its page.
EITHER_WAY = re.compile(r'(href|src|id|data-[a-z]+)="[^"]*"|(?<=\d)[a-z](?=:)')


def _shown(path):
    """The formulas, tables and pictures of a page."""
    if not path.exists():
        return set()
    article = path.read_text(encoding="utf-8").partition("<article")[2].partition("</article>")[0]
    return {EITHER_WAY.sub("", found[0]) for found in SHOWN.finditer(article)}


def _faults_on_a_phone(browser, address):
    """All folds open: what is folded away has to fit as well."""
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
        f"{address}: {what}"
        for what in faults + broken + unset + browser.errors() + browser.foreign_requests()
    ]


def _cut_off(browser, width):
    """{what is cut off or has a scroll bar in the opened page at a desk: how many of them}."""
    browser.resize(width, 900)
    return {what: count for what, count in browser.run(CENSUS).items() if count}


CENSUS = """(() => {
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

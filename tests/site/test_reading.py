"""Pages as people see them: with scroll bars on, at a desk and on a phone, on paper; pictures with their captions."""

import base64
import re

import pytest
from bs4 import BeautifulSoup

#: What is cut off, or has a scroll bar, in the opened page.
CENSUS = """(() => {
    document.querySelectorAll('article details').forEach(fold => fold.open = true);
    const of = selector => [...document.querySelectorAll(selector)];
    const scrolls = e => e.scrollWidth > e.clientWidth + 1;
    const clips = e => getComputedStyle(e).overflowX !== 'visible'
        && (scrolls(e) || e.scrollHeight > e.clientHeight + 1);
    const right = document.querySelector('article').getBoundingClientRect().right;
    return {
        inline: of('article mjx-container:not([display="true"])').filter(clips).length,
        beyond: of('article span.math svg').filter(e => e.getBoundingClientRect().right > right).length,
        code: of('article .cell_input pre').filter(scrolls).length,
        printed: of('article .cell_output pre').filter(scrolls).length,
    }})()"""


@pytest.fixture(scope="module")
def wide_pages(editions):
    """Pages with many formulas, long code and long outputs, and the chapters."""
    pages = [*editions.full.glob("solutions/ch*/p*.html"), *editions.full.glob("book/ch*.html")]
    return [page.relative_to(editions.full).as_posix() for page in sorted(pages)]


def test_nothing_is_cut_off_at_a_desk(browser, addresses, wide_pages):
    browser.resize(1400, 900)
    faults = {}
    for page in wide_pages:
        browser.open(f"{addresses['http']}/{page}")
        found = browser.run(CENSUS)
        if any(found.values()):
            faults[page] = found
    assert not faults


def test_what_has_to_scroll_on_a_phone_shows_a_shadow(browser, addresses, problem):
    browser.resize(390, 844, phone=True)
    browser.open(f"{addresses['http']}/{problem.page}")
    grounds = browser.run("""[...document.querySelectorAll('article div.math, article .cell_input pre')].map(
        e => getComputedStyle(e).backgroundAttachment)""")
    assert grounds and all("local" in ground and "scroll" in ground for ground in grounds)
    browser.resize(1280, 900)


def test_on_paper_every_fold_is_open(browser, addresses, problem):
    """Chromium prints for real; what was open at that moment is noted by a listener that comes after ours."""
    browser.resize(1280, 900)
    browser.open(f"{addresses['http']}/{problem.page}")
    browser.driver.execute_script("""addEventListener('beforeprint', () => {
        window.foldsClosed = document.querySelectorAll('article details:not([open])').length; });""")
    document = browser.driver.execute_cdp_cmd("Page.printToPDF", {})
    assert base64.b64decode(document["data"]).startswith(b"%PDF")
    assert browser.run("window.foldsClosed") == 0
    assert browser.run("document.querySelectorAll('article details.solution[open]').length") == 0


def test_every_picture_has_a_number_a_caption_and_words(editions):
    faults, seen = [], 0
    for path in sorted([*editions.full.glob("solutions/ch*/p*.html"), *editions.full.glob("book/ch*.html")]):
        page = BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")
        numbers = []
        for picture in page.select(".cell_output img"):
            seen += 1
            caption = picture.find_parent("figure") and picture.find_parent("figure").figcaption
            label = re.match(r"Figure \d+\.\d+[a-z]?(?=\. )", caption.get_text().strip()) if caption else None
            if not label or not picture["alt"].startswith(label[0] + ": ") or len(picture["alt"]) < 25:
                faults.append(f"{path.name}: {picture['alt'][:60]}")
            numbers.append(label and label[0])
        assert len(set(numbers)) == len(numbers), path
    assert seen > 0 and not faults, "\n".join(faults)


def test_the_answers_of_an_item_stand_under_its_statement(editions):
    """Of problems whose statement has items, every fold stands inside the statement."""
    moved = 0
    for path in sorted(editions.full.glob("solutions/ch*/p*.html")):
        page = BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")
        folds = page.select("details.answers")
        assert folds, path
        moved += len(page.select("div.exercise details.answers"))
        items = {p.get_text()[0] for p in page.select("div.exercise p") if re.match(r"[a-l]\)(\W|$)", p.get_text())}
        outside = [fold for fold in folds if not fold.find_parent(class_="exercise")]
        assert [fold for fold in outside if re.match(rf"[{''.join(items) or '-'}]_", fold.code.get_text())] == [], path
        names = re.findall(r"\w+", " ".join(fold.summary.get_text().partition(":")[2] for fold in folds))
        assert len(names) == len(set(names)) == len(page.select("details.answers .answer"))
    assert moved > 100


def test_a_comma_stays_with_its_formula(editions, pages_of):
    """A browser breaks the line between a formula and the sign after it unless both stand in one unbroken span."""
    torn = {}
    for path in pages_of(editions.full):
        page = BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")
        signs = [formula.next_sibling for formula in page.select("article span.math")
                 if "unbroken" not in formula.parent.get("class", [])]
        found = [sign[:20] for sign in signs if isinstance(sign, str) and sign[:1] in tuple(".,;:!?)")]
        if found:
            torn[path.name] = found
    assert not torn


def test_a_problem_without_items_has_one_solution_without_a_letter(editions):
    for path in editions.full.glob("solutions/ch*/p*.html"):
        page = BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")
        titles = [fold.summary.get_text() for fold in page.select("details.solution")]
        assert titles and (titles[0].startswith("Worked solution") and "item" not in titles[0] if len(titles) == 1 else
                           all("item" in title for title in titles)), (path.name, titles)

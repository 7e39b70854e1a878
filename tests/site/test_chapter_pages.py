"""Chapter pages as maps, the sidebar, and the glossary in a browser."""

import json
import re

import pytest

from workbook.notebooks import exercises

NUMBERS = {exercise.number for exercise in exercises.read_all()}


def _chapters(pages):
    root, parsed = pages
    return {
        path.stem.removeprefix("ch"): page
        for path, page in parsed.items()
        if path.parent == root / "book" and re.fullmatch(r"ch\d", path.stem)
    }


def test_each_section_has_a_picture_and_each_problem_one_section(pages):
    seen = []
    for page in _chapters(pages).values():
        sections = page.select(".chapter-section")
        assert len(sections) >= 3
        for section in sections:
            assert section.img is not None, section.a["href"]
            for row in section.select(".section-problems li"):
                seen.append(row.a.get_text())
                assert re.search(r"(core|advanced|starred) · \d+ min", row.get_text())
    assert sorted(seen) == sorted(NUMBERS)


def test_a_problem_stands_under_the_section_that_names_it(pages):
    sections = _chapters(pages)["1"].select(".chapter-section")
    (hurwitz,) = (s for s in sections if s.a["href"].endswith("hurwitz.html"))
    rows = {row.a.get_text(): row.get_text() for row in hurwitz.select("li")}
    assert {"1.14", "1.15", "1.16", "1.17", "1.18"} <= rows.keys()
    assert "other numbers" in rows["1.15"] and "other numbers" not in rows["1.18"]


def test_the_sidebar_opens_the_problems_under_their_section(pages):
    _, parsed = pages
    (page,) = (page for path, page in parsed.items() if path.match("ch1/p15.html"))
    sidebar = page.select_one(".bd-sidebar-primary nav")
    section = sidebar.find("a", string=re.compile("Hurwitz criterion")).find_parent("li")
    assert section.details.has_attr("open")
    assert "1.15 Stability regions" in section.ul.get_text()
    closed = sidebar.find("a", string=re.compile("Lyapunov functions")).find_parent("li")
    assert not closed.details.has_attr("open")


BROKEN = """[...document.querySelectorAll('.glossary td')].flatMap(cell => {
    const texts = document.createTreeWalker(cell, NodeFilter.SHOW_TEXT), range = document.createRange(), broken = [];
    while (texts.nextNode()) for (const word of texts.currentNode.data.matchAll(/\\p{L}+/gu)) {
        if (texts.currentNode.parentElement.closest('mjx-container')) continue;
        range.setStart(texts.currentNode, word.index);
        range.setEnd(texts.currentNode, word.index + word[0].length);
        const lines = new Set([...range.getClientRects()].map(box => box.top));
        if (lines.size > 1) broken.push(word[0]);
    }
    return broken; })"""


@pytest.mark.parametrize("width", [390, 768, 1400])
def test_the_glossary_breaks_no_word(browser, addresses, width):
    browser.resize(width, 900, phone=width == 390)
    browser.open(f"{addresses['http']}/book/glossary.html")
    assert browser.run(BROKEN) == []
    assert browser.run("document.documentElement.scrollWidth") <= width
    browser.resize(1280, 900)


@pytest.mark.parametrize("width, phone", [(1400, False), (390, True)])
def test_a_chapter_shows_what_was_verified_here(browser, addresses, width, phone):
    browser.resize(width, 900, phone)
    browser.open(f"{addresses['http']}/book/ch1.html")
    record = {"1.15": {"answers": 5, "right": ["a_region"], "wrong": []}}
    browser.driver.execute_script(
        "localStorage['workbook/verified'] = arguments[0]", json.dumps(record)
    )
    browser.open(f"{addresses['http']}/book/ch1.html")
    mark = browser.find(".section-problems .problem-verified")
    assert mark.text == "1/5" and mark.is_displayed() and mark.rect["x"] >= 0
    browser.open(f"{addresses['http']}/book/progress.html")
    assert "Hurwitz criterion" in browser.find("#progress-page").text
    browser.driver.execute_script("localStorage.clear()")
    browser.resize(1280, 900)

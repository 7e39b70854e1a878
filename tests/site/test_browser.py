"""The site in a real browser that cannot reach any other host."""

import io
import itertools
import json
import re
import zipfile
from pathlib import Path
from urllib.parse import urljoin
from urllib.request import urlopen

import pytest

from trajlib.masters import master_paths

SOLUTIONS = Path(__file__).resolve().parents[2] / "solutions"
#: Number -> the place of a problem's page below the folder of its edition.
PROBLEMS = {f"{path.parent.name[2:]}.{int(path.stem[1:])}": f"{path.parent.name}/{path.stem}"
            for path in master_paths(SOLUTIONS)}
PHONE = 390


@pytest.fixture(autouse=True)
def on_a_desk(browser):
    browser.resize(1280, 900)


@pytest.mark.parametrize("way", ["file", "http"])
def test_formulas_are_set_and_nothing_else_is_asked_for(browser, addresses, problem, way):
    browser.open(f"{addresses[way]}/{problem.page}")
    assert browser.run("document.querySelectorAll('article mjx-container svg').length") > 0
    assert browser.errors() == []
    assert browser.foreign_requests() == []


@pytest.mark.parametrize("number", [*PROBLEMS, "the other pages"])
def test_every_page_fits_a_phone_without_errors(browser, addresses, editions, pages_of, number):
    pages = {path.relative_to(editions.full).as_posix() for path in pages_of(editions.full)}
    problems = {number: f"solutions/{place}.html" for number, place in PROBLEMS.items()}
    assert pages.issuperset(problems.values())
    for page in [problems[number]] if number in problems else sorted(pages.difference(problems.values())):
        assert _faults_on_a_phone(browser, f"{addresses['http']}/{page}") == []


def test_what_the_student_edition_alone_shows_fits_a_phone_without_errors(browser, addresses, editions, pages_of):
    """Most of its pages show a part of what those of the other edition do, and that has been seen to fit."""
    pages = {path.relative_to(editions.student).as_posix(): path for path in pages_of(editions.student)}
    own = [page for page, path in pages.items()
           if not _shown(path) <= _shown(editions.full / page.replace("exercises/", "solutions/"))]
    assert "genindex.html" in own and len(own) < len(pages) / 5
    for page in {*own, "book/index.html", "exercises/ch1/p15.html"}:
        assert _faults_on_a_phone(browser, f"{addresses['student']}/{page}") == []


#: What may be too wide or fail to be set. Code scrolls in its own box on every page.
SHOWN = re.compile(r'<(span|div) class="math[ "][^>]*>.*?</\1>|<(table)\b.*?</table>|<(img|svg)\b[^>]*>', re.DOTALL)
#: What may differ between the editions: addresses, and the letter of a figure where it is the only one of its page.
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
    broken = browser.run("[...document.querySelectorAll('mjx-merror, [data-mjx-error]')].map(e => "
                         "e.dataset.mjxError || e.innerText)")
    unset = browser.run("""[...document.querySelectorAll('.math')].filter(
        e => !e.querySelector('mjx-container') && e.innerText.trim()).map(e => e.innerText.slice(0, 60))""")
    faults = [f"{width} px wide"] if width > PHONE else []
    return [f"{address}: {what}" for what in faults + broken + unset + browser.errors() + browser.foreign_requests()]


def test_the_dark_switch_darkens_the_page(browser, addresses, problem):
    browser.open(f"{addresses['http']}/{problem.page}")
    for _ in range(3):  # the button goes round light, dark, and what the system says
        if browser.run("document.documentElement.dataset.mode") == "dark":
            break
        browser.find(".theme-switch-button").click()
    assert browser.run("document.documentElement.dataset.theme") == "dark"
    ground = browser.run("getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)")
    ink = browser.run("getComputedStyle(document.querySelector('article')).color.match(/\\d+/g).map(Number)")
    assert max(ground[:3]) < 60 and min(ink[:3]) > 180
    browser.run("localStorage.clear()")


@pytest.mark.parametrize("way", ["file", "http"])
def test_a_solution_is_folded_and_opens(browser, addresses, problem, way):
    browser.open(f"{addresses[way]}/{problem.page}")
    folds = "[...document.querySelectorAll('details.solution, details.hint')]"
    assert browser.run(f"{folds}.some(fold => fold.open)") is False
    content = browser.find("details.solution > section")
    assert not content.is_displayed()
    browser.find("details.solution > summary").click()
    assert content.is_displayed()
    assert browser.run("document.querySelector('details.solution mjx-container svg').getBoundingClientRect().width") > 5


def test_a_link_to_a_solution_opens_it(browser, addresses, problem):
    browser.open(f"{addresses['http']}/{problem.page}")
    label = browser.run("document.querySelector('details.solution > section').id")
    browser.open("about:blank")
    browser.open(f"{addresses['http']}/{problem.page}#{label}")
    assert browser.run("document.querySelector('details.solution').open")


@pytest.mark.parametrize("way", ["file", "http"])
def test_a_number_typed_into_the_search_finds_the_problem_first(browser, addresses, found_by_search, problem, way):
    browser.open(f"{addresses[way]}/book/index.html")
    assert problem.page in found_by_search(problem.number)[0]
    assert browser.errors() == []


@pytest.mark.parametrize("name, page", [("van der Pol", "ch1/p04"), ("Duffing", "ch1/p03"), ("Riccati", "ch6/p03"),
                                        ("Clohessy", "ch2/p14"), ("Zhukovsky", "ch1/p09"), ("Schuler", "ch7/p01")])
def test_a_name_of_the_field_finds_the_problem(browser, addresses, found_by_search, name, page):
    """Before all pages that have the name somewhere come the problems that have it as a topic."""
    for edition, folder in (("http", "solutions"), ("student", "exercises")):
        browser.open(f"{addresses[edition]}/book/index.html")
        by_topic = itertools.takewhile(lambda found: "#problem-" in found, found_by_search(name))
        assert any(f"{folder}/{page}.html" in found for found in by_topic)


def test_the_students_notebook_is_served(browser, addresses, problem):
    browser.open(f"{addresses['http']}/{problem.page}")
    with urlopen(browser.find(".problem-notebook a").get_attribute("href")) as answer:
        assert answer.status == 200
        notebook = json.load(answer)
    assert notebook["nbformat"] == 4 and notebook["metadata"]["trajlib"]["number"] == problem.number


def test_the_wheel_is_served(browser, addresses):
    page = f"{addresses['http']}/book/guides/student.html"
    browser.open(page)
    with urlopen(urljoin(page, browser.find("a.download[href$='.whl']").get_attribute("href"))) as answer:
        names = zipfile.ZipFile(io.BytesIO(answer.read())).namelist()
    assert "trajlib/__init__.py" in names
    assert not [name for name in names if name.startswith(("solutions", "book"))]


def test_the_first_address_leads_to_the_book(browser, addresses):
    browser.open(addresses["http"] + "/index.html")
    assert browser.wait_for("location.pathname.endsWith('/book/index.html')")

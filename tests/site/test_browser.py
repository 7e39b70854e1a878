"""The site in a real browser that cannot reach any other host."""

import io
import json
import zipfile
from urllib.parse import urljoin
from urllib.request import urlopen

import pytest


@pytest.fixture(autouse=True)
def desktop_window(browser):
    browser.resize(1280, 900)


@pytest.mark.parametrize("scheme", ["file", "http"])
def test_formulas_are_typeset_without_foreign_requests(browser, addresses, problem, scheme):
    browser.open(f"{addresses[scheme]}/{problem.page}")
    assert browser.run("document.querySelectorAll('article mjx-container svg').length") > 0
    assert browser.errors() == []
    assert browser.foreign_requests() == []


def test_the_theme_switch_darkens_the_page(browser, addresses, problem):
    browser.open(f"{addresses['http']}/{problem.page}")
    for _ in range(3):  # the button cycles through light, dark and the system setting
        if browser.run("document.documentElement.dataset.mode") == "dark":
            break
        browser.find(".theme-switch-button").click()
    assert browser.run("document.documentElement.dataset.theme") == "dark"
    ground = browser.run(
        "getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)"
    )
    ink = browser.run(
        "getComputedStyle(document.querySelector('article')).color.match(/\\d+/g).map(Number)"
    )
    assert max(ground[:3]) < 60 and min(ink[:3]) > 180
    browser.run("localStorage.clear()")


@pytest.mark.parametrize("scheme", ["file", "http"])
def test_a_solution_is_folded_and_opens(browser, addresses, problem, scheme):
    browser.open(f"{addresses[scheme]}/{problem.page}")
    folds = "[...document.querySelectorAll('details.solution, details.hint')]"
    assert browser.run(f"{folds}.some(fold => fold.open)") is False
    content = browser.find("details.solution > section")
    assert not content.is_displayed()
    browser.find("details.solution > summary").click()
    assert content.is_displayed()
    assert (
        browser.run(
            "document.querySelector('details.solution mjx-container "
            "svg').getBoundingClientRect().width"
        )
        > 5
    )


def test_a_link_to_a_solution_opens_it(browser, addresses, problem):
    browser.open(f"{addresses['http']}/{problem.page}")
    label = browser.run("document.querySelector('details.solution > section').id")
    browser.open("about:blank")
    browser.open(f"{addresses['http']}/{problem.page}#{label}")
    assert browser.run("document.querySelector('details.solution').open")


def test_the_students_notebook_is_served(browser, addresses, problem):
    browser.open(f"{addresses['http']}/{problem.page}")
    with urlopen(browser.find(".problem-notebook a").get_attribute("href")) as answer:
        assert answer.status == 200
        notebook = json.load(answer)
    assert (
        notebook["nbformat"] == 4 and notebook["metadata"]["workbook"]["number"] == problem.number
    )


def test_the_wheel_is_served(browser, addresses):
    page = f"{addresses['http']}/book/guides/install.html"
    browser.open(page)
    with urlopen(
        urljoin(page, browser.find("a.download[href$='.whl']").get_attribute("href"))
    ) as answer:
        names = zipfile.ZipFile(io.BytesIO(answer.read())).namelist()
    assert {"trajlib/__init__.py", "workbook/__init__.py"} <= set(names)
    assert not [name for name in names if name.startswith(("solutions", "book"))]


def test_the_first_address_leads_to_the_book(browser, addresses):
    browser.open(addresses["http"] + "/index.html")
    assert browser.wait_for("location.pathname.endsWith('/book/index.html')")

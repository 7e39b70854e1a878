"""The pages of the library: each public name, and links both ways between it and the pages that use
it."""

import sys
from pathlib import Path
from urllib.parse import urldefrag

import pytest
from bs4 import BeautifulSoup

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "book" / "_ext"))
from workbook_site import reference  # noqa: E402

MODULES = sorted(path.stem for path in (ROOT / "book" / "library").glob("*.md"))


def test_every_theme_that_can_be_imported_has_a_page():
    import trajlib

    assert set(MODULES) == {*trajlib.__all__, *reference.OF_WORKBOOK}


@pytest.mark.parametrize("module", MODULES)
def test_every_public_name_is_explained(editions, module):
    text = (editions.full / "book" / "library" / f"{module}.html").read_text(encoding="utf-8")
    page = BeautifulSoup(text, "html.parser")
    home = reference.module_of(module)
    for name in reference.public_names(home):
        section = page.find(id=reference.label_of(home, name))
        assert section.pre.get_text().startswith(name), name
        assert len(section.p.get_text()) > 20, name


def test_formulas_of_docstrings_are_set():
    """The prose is plain text for `help`; on the page nobody reads lambda_0."""
    [said] = reference.described(
        "H = psi^T f - lambda_0 f_0, for `lambda_0 >= 0` and an n x n matrix."
    )
    assert [part.astext() for part in said.children] == [
        "<i>H</i> = ψ<sup><i>T</i></sup> <i>f</i> − λ<sub>0</sub> <i>f</i><sub>0</sub>, for ",
        "lambda_0 >= 0",
        " and an <i>n</i> × <i>n</i> matrix.",
    ]


def test_links_lead_both_ways(pages):
    """Function -> page and page -> function are the same pairs, and what the checks of a page are
    not among them."""
    root, parsed = pages
    forth, back = set(), set()
    for module in MODULES:
        place = root / "book" / "library" / f"{module}.html"
        for section in parsed[place].select("section section"):
            forth |= {
                (section["id"], (place.parent / link["href"]).resolve())
                for link in section.select("p.used-in a")
            }
    for place in [*root.glob("*/ch*/p*.html"), *root.glob("book/**/ch*.html")]:
        back |= {
            (urldefrag(link["href"]).fragment, place.resolve())
            for link in parsed[place].select("p.used-in a")
        }
    assert forth == back
    assert (
        "library-stability-stability_conditions",
        (root / "book" / "ch1.html").resolve(),
    ) in forth
    assert len({page for _, page in forth}) > (50 if (root / "solutions").exists() else 5)


def test_the_first_page_leads_an_engineer_there(browser, addresses):
    browser.open(f"{addresses['http']}/book/index.html")
    cards = browser.run(
        "[...document.querySelectorAll('.sd-card')].map(card => "
        "[card.querySelector('.sd-card-title').innerText, card.querySelector('a').href])"
    )
    assert dict(cards)["Engineers"].endswith("/book/library.html")

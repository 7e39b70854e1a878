"""The pages of the library: each public name, and links to and from the pages that use it."""

import sys
from pathlib import Path
from urllib.parse import urldefrag

import pytest
from bs4 import BeautifulSoup

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "book" / "_ext"))
from docutils import nodes  # noqa: E402
from docutils.frontend import get_default_settings  # noqa: E402
from docutils.parsers.rst import Parser  # noqa: E402
from docutils.utils import new_document  # noqa: E402
from workbook_site import docstrings, uses  # noqa: E402

MODULES = sorted(path.stem for path in (ROOT / "book" / "library").glob("*.md"))


def test_every_public_module_has_a_page():
    import trajlib

    assert set(MODULES) == {*trajlib.__all__, *uses.OF_WORKBOOK}


@pytest.mark.parametrize("module", MODULES)
def test_every_public_name_is_explained(editions, module):
    text = (editions.full / "book" / "library" / f"{module}.html").read_text(encoding="utf-8")
    page = BeautifulSoup(text, "html.parser")
    home = uses.module_of(module)
    for name in uses.public_names(home):
        section = page.find(id=uses.label_of(home, name))
        assert section.select_one("dt.sig .sig-name").get_text() == name
        assert len(section.select_one("dl.py > dd > p").get_text()) > 20, name


def parse(text):
    return docstrings.parse(text, new_document("page", get_default_settings(Parser)))


def test_formulas_of_docstrings_are_typeset():
    """The prose is plain text for `help`; on the page it shows no lambda_0."""
    [paragraph] = parse("H = psi^T f - lambda_0 f_0, for `lambda_0 >= 0` and an n x n matrix.")
    assert [part.astext() for part in paragraph.children] == [
        "<i>H</i> = ψ<sup><i>T</i></sup> <i>f</i> − λ<sub>0</sub> <i>f</i><sub>0</sub>, for ",
        "lambda_0 >= 0",
        " and an <i>n</i> × <i>n</i> matrix.",
    ]


def test_markup_in_the_words_of_a_docstring_is_plain_text():
    """Stars, bars, underscores and single backquotes neither vanish nor warn."""
    [paragraph, block] = parse("a * b, |x_i|, *args, name_, [1]_, ``K``\n\n  x' = A*x\n  y = |x|_2")
    assert paragraph.astext().endswith(", *args, name_, [1]_, K")
    assert block.tagname == "literal_block" and block.astext() == "x' = A*x\ny = |x|_2"
    assert parse("unexpected\n  indentation\n    here\nand an open `quote")


def test_arguments_of_a_numpydoc_section_keep_their_type_apart():
    [fields] = parse(
        ":Parameters:\n\n    **G, N** : matrix_like, shape (n, n)\n        Weights > 0."
    )
    [item] = fields.findall(nodes.definition_list_item)
    assert [part.astext() for part in item] == [
        "G, N",
        "matrix_like, shape (n, n)",
        "Weights > 0.",
    ]


def test_links_go_both_ways(pages):
    """Links from functions to pages and from pages to functions are the same pairs."""
    root, parsed = pages
    to_pages, to_names = set(), set()
    for module in MODULES:
        library_page = root / "book" / "library" / f"{module}.html"
        for section in parsed[library_page].select("section section"):
            to_pages |= {
                (section["id"], (library_page.parent / link["href"]).resolve())
                for link in section.select("p.used-in a")
            }
    for page in [
        *root.glob("*/ch*/p*.html"),
        *root.glob("book/ch*/*.html"),
        *root.glob("book/errata/ch*.html"),
    ]:
        to_names |= {
            (urldefrag(link["href"]).fragment, page.resolve())
            for link in parsed[page].select("p.used-in a")
        }
    assert to_pages == to_names
    assert (
        "library-stability-stability_conditions",
        (root / "book" / "ch1" / "example_regions.html").resolve(),
    ) in to_pages
    assert len({page for _, page in to_pages}) > (50 if (root / "solutions").exists() else 5)


def test_the_first_page_leads_engineers_to_their_guide(browser, addresses):
    browser.open(f"{addresses['http']}/book/index.html")
    cards = browser.run(
        "[...document.querySelectorAll('.sd-card')].map(card => "
        "[card.querySelector('.sd-card-title').innerText, card.querySelector('a').href])"
    )
    assert dict(cards)["Engineer"].endswith("/book/guides/engineer.html")

"""What a site that has an address does with it: links to Colab, and lines to be copied."""

import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "book" / "_ext"))

from workbook_site.built_files import name_own_address

from workbook.site.downloads import colab_links

NOTEBOOK = "exercises/ch1/p15.ipynb"
COLAB = "https://colab.research.google.com/github"


@pytest.mark.parametrize(
    ("site", "address"),
    [
        ("https://ann.github.io/course/", f"{COLAB}/ann/course/blob/gh-pages/{NOTEBOOK}"),
        ("https://ann.github.io/course/2026", f"{COLAB}/ann/course/blob/gh-pages/2026/{NOTEBOOK}"),
        ("https://ann.github.io", f"{COLAB}/ann/ann.github.io/blob/gh-pages/{NOTEBOOK}"),
        ("https://course.uni.example/", None),
        ("https://github.io.evil.example/ann/", None),
        ("", None),
    ],
)
def test_where_colab_finds_a_notebook(site, address):
    found = "".join(node.astext() for node in colab_links(site, NOTEBOOK))
    assert found == (f' · <a href="{address}">Open in Colab</a>' if address else "")


@pytest.mark.parametrize(
    "site", ["", "https://ann.github.io/course", "https://ann.github.io/course/"]
)
def test_the_line_that_installs_from_the_site_names_its_address(site):
    guide = Path(__file__).resolve().parents[2] / "book" / "guides" / "install.md"
    source = [guide.read_text(encoding="utf-8")]
    name_own_address(
        SimpleNamespace(config=SimpleNamespace(html_baseurl=site)), "book/guides/install", source
    )
    address = site.rstrip("/") or "https://workbook.example"
    assert source[0].count(f'%pip install "trajlib[workbook] @ {address}/wheels/trajlib-') == 1

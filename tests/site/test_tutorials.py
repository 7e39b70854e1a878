"""The tutorials of the engineer's guide: their length, their notebooks and their data."""

import json
import re
from contextlib import chdir, redirect_stdout
from io import StringIO
from pathlib import Path

import matplotlib.pyplot as plt
import nbformat
import numpy as np
import pytest

from workbook.site.downloads import page_notebook

ROOT = Path(__file__).resolve().parents[2]

PAGES = sorted((ROOT / "book" / "guides" / "tutorials").glob("*.md"))
MYST = re.compile(r"^\([\w-]+\)=|\{[\w:-]+\}`|^`{3,}\{", re.M)


def notebook(page):
    return page_notebook(page.read_text(encoding="utf-8"))


def codes(page):
    return [cell["source"] for cell in notebook(page)["cells"] if cell["cell_type"] == "code"]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_fewer_than_forty_lines_lead_to_the_first_plot(page):
    cells = codes(page)
    plot = next(k for k, code in enumerate(cells) if "plotting.style" in code)
    assert sum(bool(line.strip()) for code in cells[: plot + 1] for line in code.splitlines()) < 40


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_notebook_is_valid_and_has_no_myst(page):
    made = notebook(page)
    nbformat.validate(nbformat.from_dict(json.loads(json.dumps(made))))
    texts = [cell["source"] for cell in made["cells"] if cell["cell_type"] == "markdown"]
    assert texts[0].startswith("# ") and len(codes(page)) > 3
    assert [text for text in texts if MYST.search(text) or "as a notebook" in text] == []


def test_the_gps_file_holds_the_numbers_that_its_page_makes():
    page = next(page for page in PAGES if page.stem == "gps-with-gaps")
    names, output = {}, StringIO()
    with chdir(page.parent), redirect_stdout(output):
        for code in codes(page):
            exec(code, names)
    plt.close("all")
    assert "the file holds these numbers: True" in output.getvalue()
    assert np.isnan(names["z"]).any() and len(np.unique(np.diff(names["times"]))) > 1


def test_the_guide_lists_every_tutorial():
    guide = (ROOT / "book" / "guides" / "engineer.md").read_text(encoding="utf-8")
    contents = (ROOT / "_toc.yml").read_text(encoding="utf-8")
    for page in PAGES:
        label = re.search(r"^\(([\w-]+)\)=$", page.read_text(encoding="utf-8"), re.M)[1]
        assert f"{{ref}}`{label}`" in guide
        assert f"book/guides/tutorials/{page.stem}\n" in contents

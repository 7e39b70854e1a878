"""From MyST to a plain Jupyter notebook: what leaves, what stays, what becomes of directives and links."""

from pathlib import Path

import pytest

from trajlib.masters import Links, read, student_notebook
from trajlib.masters.converting import plain_markdown

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def links(tmp_path):
    (tmp_path / "book").mkdir()
    (tmp_path / "book" / "ch1.md").write_text("```{prf:theorem} 1.2 (Hurwitz)\n:label: "
                                              "thm-1-2\nText.\n```\n\n(exm-1-1)=\n## Example 1\n", encoding="utf-8")
    return Links(tmp_path)


@pytest.mark.parametrize("myst, plain", [
    ("```{index} 1.15\n```\nText", "Text"),
    ("```{exercise-start} A title\n:label: ex-1\n:nonumber:\n```\nText\n```{exercise-end}\n```",
     "# Problem 1.15. A title\nText\n"),
    ("```{math}\n:label: eq-1-15-a\n\na = b\n```", "$$\na = b \\tag{1.15a}\n$$\n"),
    ("see {eq}`eq-1-15-a`", "see (1.15a)"),
    ("```{note}\nMind the sign.\n```", "> **Note**\n>\n> Mind the sign.\n"),
    ("````{tip} A title\n```{math}\nx\n```\n````", "> **A title**\n>\n> $$\n> x\n> $$\n"),
    ("a {term}`root locus <locus>` and {index}`gain`", "a root locus and gain"),
    ("# Problem 1.15\n\nas in {problem}`1.4`", "as in problem 1.4"),
    ("(a-label)=\nText", "Text"),
    ("[no such](#thm-9-9)", "no such"),
])
def test_markdown(myst, plain, links, tmp_path):
    assert plain_markdown(myst, links, tmp_path / "exercises" / "ch1" / "p15.ipynb", "1.15").strip() == plain.strip()


def test_links_lead_to_the_built_site_or_to_its_address(links, tmp_path):
    here = tmp_path / "exercises" / "ch1" / "p15.ipynb"
    text = "by [Theorem 1.2](#thm-1-2) and {ref}`example 1 <exm-1-1>`"
    assert plain_markdown(text, links, here) == ("by [Theorem 1.2](../../_build/html/book/ch1.html#thm-1-2) and "
                                                 "[example 1](../../_build/html/book/ch1.html#exm-1-1)")
    public = Links(tmp_path, "https://example.org/course/")
    assert "(https://example.org/course/book/ch1.html#thm-1-2)" in plain_markdown(text, public, here)


def test_the_students_copy():
    master = read(ROOT / "solutions" / "ch1" / "p15.md")
    notebook = student_notebook(master, Links(ROOT))
    roles = [cell["metadata"]["tags"][0] for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert roles == ["data", *["answer", "check"] * 5]
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert code[1]["source"].startswith("a_region = ...  # condition: the set of (k1, k2)")
    assert "nbgrader" not in code[1]["metadata"]
    assert code[2]["metadata"]["nbgrader"] | {"grade_id": ""} == {
        "schema_version": 3, "grade": True, "locked": True, "solution": False, "task": False, "cell_type": "code",
        "points": 1, "grade_id": ""}
    ids = [cell["metadata"]["nbgrader"]["grade_id"] for cell in code if "nbgrader" in cell["metadata"]]
    assert len(set(ids)) == len(ids) and len({cell["id"] for cell in notebook["cells"]}) == len(notebook["cells"])
    assert "Moscow, 2012" in notebook["cells"][0]["source"] and "pip install -e ." in notebook["cells"][0]["source"]
    assert "pip install trajlib" not in str(notebook)


def test_converting_is_deterministic():
    master = read(ROOT / "solutions" / "ch1" / "p15.md")
    assert student_notebook(master, Links(ROOT)) == student_notebook(master, Links(ROOT))

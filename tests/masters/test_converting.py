"""From MyST to a plain Jupyter notebook: what leaves, what stays, what becomes of directives and links."""

import re
from pathlib import Path

import pytest

from trajlib import exercises
from trajlib.masters import Links, read, read_all, student_notebook
from trajlib.masters.contract import master_file
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
def test_markdown(myst, plain, links):
    assert plain_markdown(myst, links, "1.15") == (plain.strip(), [])


def test_places_of_the_book_are_named_and_known(links):
    text, places = plain_markdown("by {ref}`example 1 <exm-1-1>` and [Theorem 1.2](#thm-1-2), twice Theorem 1.2", links)
    assert text == "by example 1 and Theorem 1.2, twice Theorem 1.2"
    assert places == [("example 1", "book/ch1.html#exm-1-1"), ("Theorem 1.2", "book/ch1.html#thm-1-2")]


def test_a_notebook_links_to_the_site_only_where_that_has_an_address(links, tmp_path):
    """`../../_build/html` is nowhere on a student's machine."""
    for base in ("", "https://example.org/course/"):
        for number in ("1.15", "2.5", "5.3"):
            master = read(ROOT / "solutions" / master_file(number))
            cells = student_notebook(master, Links(ROOT, base))["cells"]
            found = [address for cell in cells for address in re.findall(r"\]\(([^)\s]+)\)", cell["source"])]
            assert all(address.startswith("https://example.org/course/") for address in found)
            assert bool(found) == bool(base)
            wheel = re.search(r"%pip install (\S*)trajlib-[\d.]+-py3-none-any\.whl", cells[1]["source"])
            assert wheel[1] == (f"{base}wheels/" if base else "")


def test_links_can_be_led_elsewhere():
    """A homework's notebook leads to the site named for it, also when the checkout has an address of its own."""
    master = read(ROOT / "solutions" / "ch2" / "p05.md")
    plain, ours = student_notebook(master, Links(ROOT)), student_notebook(master, Links(ROOT, "https://ours.example"))
    assert plain != ours
    assert exercises.linked(plain, exercises.below("https://ours.example")) == ours
    theirs = exercises.linked(ours, exercises.below("https://theirs.example/"))
    assert "ours.example" not in str(theirs) and theirs == exercises.linked(plain, exercises.below("https://theirs.example"))


def test_no_answer_cell_is_empty():
    for master in read_all(ROOT / "solutions"):
        for cell in student_notebook(master, Links(ROOT))["cells"]:
            assert cell["source"].strip(), f"{master.number} has an empty cell {cell['metadata']}"


def test_without_the_library_one_line_says_how_to_get_it(tmp_path):
    """In a kernel that finds no trajlib, the first code cell fails with this line alone, and Run All ends there."""
    import nbformat
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError

    notebook = student_notebook(read(ROOT / "solutions" / "ch1" / "p15.md"), Links(ROOT, "https://example.org"))
    hidden = "import sys; sys.modules['trajlib'] = None"
    notebook["cells"].insert(1, {"cell_type": "code", "id": "hide", "metadata": {}, "source": hidden, "outputs": [],
                                 "execution_count": None})
    opened = nbformat.from_dict(notebook)
    with pytest.raises(CellExecutionError):
        NotebookClient(opened, timeout=60, kernel_name="python3").execute()
    [said] = [output for cell in opened.cells if cell.cell_type == "code" for output in cell.outputs]
    assert len(said.traceback) == 1
    assert "%pip install https://example.org/wheels/trajlib-" in said.traceback[0]


def test_the_students_copy():
    master = read(ROOT / "solutions" / "ch1" / "p15.md")
    notebook = student_notebook(master, Links(ROOT))
    roles = [cell["metadata"]["tags"][0] for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert roles == ["setup", "data", *["answer", "check"] * 5]
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"][1:]
    assert code[1]["source"].startswith("a_region = ...  # condition: the set of (k1, k2)")
    assert "nbgrader" not in code[1]["metadata"]
    assert code[2]["metadata"]["nbgrader"] | {"grade_id": ""} == {
        "schema_version": 3, "grade": True, "locked": True, "solution": False, "task": False, "cell_type": "code",
        "points": 1, "grade_id": ""}
    ids = [cell["metadata"]["nbgrader"]["grade_id"] for cell in code if "nbgrader" in cell["metadata"]]
    assert len(set(ids)) == len(ids) and len({cell["id"] for cell in notebook["cells"]}) == len(notebook["cells"])
    assert "Moscow, 2012" in notebook["cells"][0]["source"] and "pip install -e ." in notebook["cells"][0]["source"]
    assert not re.search(r"pip install trajlib\b(?!-)", str(notebook)), "no index has it: only the wheel's file"


def test_converting_is_deterministic():
    master = read(ROOT / "solutions" / "ch1" / "p15.md")
    assert student_notebook(master, Links(ROOT)) == student_notebook(master, Links(ROOT))

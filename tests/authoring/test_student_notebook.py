"""The student notebook of a master: removed and kept cells, directives and links."""

import json
import re
from base64 import b64decode
from io import BytesIO
from pathlib import Path

import pytest

from trajlib import __version__
from workbook.authoring import Links, MasterError, read_master
from workbook.authoring.plain_markdown import plain_markdown
from workbook.authoring.student_notebook import WIDTH, student_notebook
from workbook.notebooks import exercises
from workbook.numbering import read_number

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def links(tmp_path):
    (tmp_path / "book").mkdir()
    (tmp_path / "book" / "ch1.md").write_text(
        "```{prf:theorem} 1.2 (Hurwitz)\n:label: thm-1-2\nText.\n```\n\n(exm-1-1)=\n## Example 1\n",
        encoding="utf-8",
    )
    return Links(tmp_path)


@pytest.mark.parametrize(
    "myst, plain",
    [
        ("```{index} 1.15\n```\nText", "Text"),
        (
            "```{exercise-start} A title\n:label: "
            "ex-1\n:nonumber:\n```\nText\n```{exercise-end}\n```",
            "# Problem 1.15. A title\nText\n",
        ),
        ("```{math}\n:label: eq-1-15-a\n\na = b\n```", "$$\na = b \\tag{1.15a}\n$$\n"),
        ("see {eq}`eq-1-15-a`", "see (1.15a)"),
        ("```{note}\nMind the sign.\n```", "> **Note**\n>\n> Mind the sign.\n"),
        ("````{tip} A title\n```{math}\nx\n```\n````", "> **A title**\n>\n> $$\n> x\n> $$\n"),
        ("a {term}`root locus <locus>` and {index}`gain`", "a root locus and gain"),
        ("# Problem 1.15\n\nas in {problem}`1.4`", "as in problem 1.4"),
        (
            "{problem}`1.4` is\n{problem}`1.5`. {problem}`1.6`:\n\n- **{problem}`1.7`**, "
            "{problem}`1.8`\n- {problem}`1.9`",
            "Problem 1.4 is\nproblem 1.5. Problem 1.6:\n\n- **Problem 1.7**, problem 1.8\n- "
            "Problem 1.9",
        ),
        ("(a-label)=\nText", "Text"),
        ("[no such](#thm-9-9)", "no such"),
        ("{printed}`added` Let $x$. {printed}`err-1-margin`\nIt", "Let $x$.\nIt"),
        ("{printed}`added`\n\n$$\nx\n$$", "$$\nx\n$$"),
        (":::{fold} Compared\nText.\n:::\n", "> **Compared**\n>\n> Text.\n"),
    ],
)
def test_markdown(myst, plain, links):
    assert plain_markdown(myst, links, "1.15") == (plain.strip(), [])


def test_references_to_the_book_are_listed(links):
    text, references = plain_markdown(
        "by {ref}`example 1 <exm-1-1>` and [Theorem 1.2](#thm-1-2), twice Theorem 1.2", links
    )
    assert text == "by example 1 and Theorem 1.2, twice Theorem 1.2"
    assert references == [
        ("example 1", "book/ch1.html#exm-1-1"),
        ("Theorem 1.2", "book/ch1.html#thm-1-2"),
    ]


def test_the_last_cell_names_chapters_of_equations():
    """The last cell names the chapter of each equation that the notebook refers to."""
    for number, reference, page in (
        ("2.12", "(2.7)", "decomposition"),
        ("2.20", "(2.4)", "canonical_forms"),
        ("3.25", "(2.6)", "decomposition"),
    ):
        *others, last = student_notebook(
            read_master(ROOT / "solutions" / read_number(number).file(".md")), Links(ROOT)
        )["cells"]
        assert any(reference in cell["source"] for cell in others)
        assert re.search(
            rf"numbers such as [^\n]*{re.escape(reference)}[(), .\d]* name equations of chapter 2\.",
            last["source"],
        )
        assert [reference, f"book/ch2/{page}.html#eq-{reference[1:-1].replace('.', '-')}"] in last[
            "metadata"
        ]["places"]


def test_lines_of_code_fit_a_notebook():
    cells = student_notebook(
        read_master(ROOT / "solutions" / read_number("1.15").file(".md")), Links(ROOT)
    )["cells"]
    lines = [
        line
        for cell in cells
        if cell["cell_type"] == "code"
        for line in cell["source"].splitlines()
    ]
    assert lines and max(map(len, lines)) <= WIDTH


def test_links_need_the_address_of_the_site(links, tmp_path):
    """`../../_build/html` is nowhere on a student's machine."""
    for base in ("", "https://example.org/course/"):
        for number in ("1.15", "2.5", "5.3"):
            master = read_master(ROOT / "solutions" / read_number(number).file(".md"))
            cells = student_notebook(master, Links(ROOT, base))["cells"]
            matches = [
                address
                for cell in cells
                for address in re.findall(r"\]\(([^)\s]+)\)", cell["source"])
                # a drawing, which the notebook itself holds
                if not address.startswith("attachment:")
            ]
            assert all(address.startswith("https://example.org/course/") for address in matches)
            assert bool(matches) == bool(base)
            [setup] = (c["source"] for c in cells if c["metadata"].get("tags") == ["setup"])
            page = re.search(r'page = "(.*)book/guides/install\.html"', setup)
            assert page[1] == (base or "the workbook's site, ")


def test_links_to_another_site():
    """A homework's notebook links to the site named for it, not to that of the checkout."""
    master = read_master(ROOT / "solutions" / "ch2" / "p05.md")
    plain, linked = (
        student_notebook(master, Links(ROOT)),
        student_notebook(master, Links(ROOT, "https://ours.example")),
    )
    assert plain != linked
    assert exercises.add_links(plain, exercises.site_urls("https://ours.example")) == linked
    relinked = exercises.add_links(linked, exercises.site_urls("https://theirs.example/"))
    assert "ours.example" not in str(relinked) and relinked == exercises.add_links(
        plain, exercises.site_urls("https://theirs.example")
    )


def test_one_line_says_how_to_install_the_workbook(tmp_path):
    """Without the workbook the first code cell fails with one line, and Run All ends there."""
    import nbformat
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError

    notebook = student_notebook(
        read_master(ROOT / "solutions" / "ch1" / "p15.md"), Links(ROOT, "https://example.org")
    )
    hidden = "import sys; sys.modules['workbook'] = None"
    notebook["cells"].insert(
        0,
        {
            "cell_type": "code",
            "id": "hide",
            "metadata": {},
            "source": hidden,
            "outputs": [],
            "execution_count": None,
        },
    )
    opened = nbformat.from_dict(notebook)
    with pytest.raises(CellExecutionError):
        NotebookClient(opened, timeout=60, kernel_name="python3").execute()
    [message] = [
        output for cell in opened.cells if cell.cell_type == "code" for output in cell.outputs
    ]
    assert message.traceback == [
        "No workbook here. How to install it: https://example.org/book/guides/install.html"
    ]


def test_cells_of_the_student_notebook():
    master = read_master(ROOT / "solutions" / "ch1" / "p15.md")
    notebook = student_notebook(master, Links(ROOT))
    roles = [
        cell["metadata"]["tags"][0] for cell in notebook["cells"] if cell["cell_type"] == "code"
    ]
    assert roles == ["setup", "data", *["answer", "check"] * 5, "steps", "steps"]
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"][1:]
    assert code[1]["source"] == (
        "# condition: the set of (k1, k2) where the equation of item a is asymptotically\n"
        "# stable\na_region = ..."
    )
    assert "nbgrader" not in code[1]["metadata"]
    assert all(
        cell["source"].startswith('from workbook import checks\n\nchecks.report("1.15",')
        for cell in code[2:-2:2]
    )
    assert code[2]["metadata"]["nbgrader"] | {"grade_id": ""} == {
        "schema_version": 3,
        "grade": True,
        "locked": True,
        "solution": False,
        "task": False,
        "cell_type": "code",
        "points": 1,
        "grade_id": "",
    }
    ids = [
        cell["metadata"]["nbgrader"]["grade_id"] for cell in code if "nbgrader" in cell["metadata"]
    ]
    assert len(set(ids)) == len(ids) and len({cell["id"] for cell in notebook["cells"]}) == len(
        notebook["cells"]
    )
    first, *_, last = (cell["source"] for cell in notebook["cells"])
    assert first.startswith(f"# Problem 1.15. {master.title}\n")
    assert "Moscow, 2012" in last and "pip install -e " in last
    assert not re.search(r"pip install \W*trajlib\b", str(notebook)), (
        "no index has it: only the wheel's file"
    )
    assert __version__ not in str(notebook), "a release would rewrite all notebooks"


def drawing_of(written, cell):
    """1.15 with a drawing before its end of the statement: the student's copy."""
    page = (ROOT / "solutions" / "ch1" / "p15.md").read_text(encoding="utf-8")
    written.parent.mkdir(parents=True, exist_ok=True)
    written.write_text(
        page.replace(
            "```{exercise-end}",
            f"```{{code-cell}}\n:tags: [drawing]\n{cell}\n```\n"
            "*A rod of the\nlength $l$. More of it.*\n\nIt ends.\n\n```{exercise-end}",
            1,
        ),
        encoding="utf-8",
    )
    trials = ROOT / "solutions" / "ch1" / "p15.trials.py"
    written.with_name("p15.trials.py").write_text(
        trials.read_text(encoding="utf-8"), encoding="utf-8"
    )
    return read_master(written)


ROD = "from workbook.display import Drawing\n\nd = Drawing((0, 2), (0, 1))\nd.rod((0.2, 0.2), (1.8, 0.8))\nd"


def test_a_drawing_becomes_its_picture(tmp_path):
    from matplotlib.image import imread

    master = drawing_of(tmp_path / "solutions" / "ch1" / "p15.md", ROD)
    cells = student_notebook(master, Links(ROOT))["cells"]
    [k] = [k for k, cell in enumerate(cells) if "attachments" in cell]
    assert cells[k]["source"] == "![A rod of the length l. More of it.](attachment:drawing.png)"
    assert cells[k + 1]["source"] == "*A rod of the\nlength $l$. More of it.*\n\nIt ends."
    picture = imread(BytesIO(b64decode(cells[k]["attachments"]["drawing.png"]["image/png"])))
    assert picture.shape[:2] == (120, 240)
    # the rod runs from below to the right
    assert picture[60, 120, :3].max() < 0.2 and picture[20, 40, :3].min() == 1
    assert "drawings" not in str([cell["source"] for cell in cells])


def test_text_alternatives_are_whole_sentences():
    """A text alternative is not cut off and has no code of formulas."""
    words = [
        text
        for path in ROOT.glob("exercises/ch*/p*.ipynb")
        for cell in json.loads(path.read_text())["cells"]
        for text in re.findall(r"!\[(.*)\]\(attachment:", "".join(cell["source"]))
    ]
    assert len(words) > 50 and not [
        text for text in words if len(text) < 15 or re.search(r"\\|[^.]$", text)
    ]


def test_a_picture_is_drawn_again_only_when_its_code_changes(tmp_path):
    """And kept otherwise, as another Matplotlib would draw it with other bytes."""
    path = tmp_path / "solutions" / "ch1" / "p15.md"
    notebook = student_notebook(drawing_of(path, ROD), Links(ROOT))
    [shown] = [cell for cell in notebook["cells"] if "attachments" in cell]
    shown["attachments"]["drawing.png"]["image/png"] = "by another Matplotlib"
    master = read_master(path)
    master.exercise.parent.mkdir(parents=True)
    master.exercise.write_text(json.dumps(notebook), encoding="utf-8")
    assert student_notebook(master, Links(ROOT)) == notebook
    [changed] = [
        cell
        for cell in student_notebook(drawing_of(path, ROD.replace("1.8", "1.7")), Links(ROOT))[
            "cells"
        ]
        if "attachments" in cell
    ]
    assert (
        changed["metadata"] != shown["metadata"]
        and len(changed["attachments"]["drawing.png"]["image/png"]) > 500
    )


@pytest.mark.parametrize(
    "cell, message",
    [
        (
            ROD.replace("(0.2, 0.2)", "k1"),
            "by its own cell alone; NameError: name 'k1' is not defined",
        ),
        (ROD.removesuffix("\nd"), "the last line of a drawing cell names its Drawing"),
        ("d = 1\nd", "the last line of a drawing cell names its Drawing"),
    ],
)
def test_errors_of_drawings_name_the_line(tmp_path, cell, message):
    master = drawing_of(tmp_path / "solutions" / "ch1" / "p15.md", cell)
    with pytest.raises(MasterError, match=rf"p15\.md:\d+: .*{message}"):
        student_notebook(master, Links(ROOT))


def test_conversion_is_deterministic():
    master = read_master(ROOT / "solutions" / "ch1" / "p15.md")
    assert student_notebook(master, Links(ROOT)) == student_notebook(master, Links(ROOT))


#: What the notebooks' formulas are written with. KaTeX 0.16.9, as in VS Code, sets all of it; try
#: it there, or on katex.org, before a command is added. MathJax, in Jupyter and on the site, sets
#: more.
KATEX_COMMANDS = {
    "Big",
    "Delta",
    "Omega",
    "Phi",
    "alpha",
    "arcsin",
    "bar",
    "begin",
    "beta",
    "big",
    "bigl",
    "bigr",
    "cdot",
    "cos",
    "cosh",
    "ddot",
    "delta",
    "det",
    "dfrac",
    "displaystyle",
    "dot",
    "dots",
    "end",
    "equiv",
    "eta",
    "exp",
    "frac",
    "gamma",
    "geq",
    "hat",
    "in",
    "infty",
    "int",
    "kappa",
    "lambda",
    "ldots",
    "le",
    "left",
    "leq",
    "lim",
    "ln",
    "mathbb",
    "mathbf",
    "mathring",
    "max",
    "min",
    "mp",
    "mu",
    "neq",
    "omega",
    "operatorname",
    "overset",
    "partial",
    "perp",
    "pi",
    "pm",
    "psi",
    "qquad",
    "quad",
    "rho",
    "right",
    "sigma",
    "sin",
    "sinh",
    "sqrt",
    "sum",
    "tag",
    "tan",
    "tau",
    "text",
    "tfrac",
    "theta",
    "tilde",
    "to",
    "top",
    "varepsilon",
    "varkappa",
    "varphi",
    "varrho",
    "xi",
    "zeta",
}


def test_katex_sets_every_formula():
    """KaTeX knows all commands; no dollar stands beside a letter or a digit."""
    wrong = []
    for path in sorted((ROOT / "exercises").glob("*/*.ipynb")):
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
            if cell["cell_type"] == "markdown":
                text = re.sub(r"`[^`]*`", "", cell["source"])
                for match in re.finditer(r"(\w?)(\$\$.+?\$\$|\$[^$]+\$)(\w?)", text, re.S):
                    unknown = set(re.findall(r"\\([A-Za-z]+)", match[2])) - KATEX_COMMANDS
                    if unknown or match[1] or match[3]:
                        wrong.append((path.name, match[0], unknown))
    assert not wrong


def test_third_derivatives_have_their_dots(links):
    assert plain_markdown(r"$\dddot x + \dddot{z} = \dddot\varphi$", links)[0] == (
        r"$\overset{\ldots}{x} + \overset{\ldots}{z} = \overset{\ldots}{\varphi}$"
    )


def test_lines_of_stubs_fit_a_cell():
    """A line of a code cell goes on behind the edge, in Jupyter and VS Code."""
    for path in sorted((ROOT / "exercises").glob("*/*.ipynb")):
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
            if "answer" in cell["metadata"].get("tags", []):
                assert all(len(line) <= 79 for line in cell["source"].splitlines()), path
                # a formula and the name of its variable may have the same plain form
                assert not re.search(r"\b(\w+) \(\1\)", cell["source"]), path

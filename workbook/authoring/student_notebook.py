"""Convert a master into the student notebook.

It is a plain Jupyter notebook without solutions, with nbgrader's metadata. Data and check cells are
copied and locked; an answer cell becomes a stub `name = ...` for each of its answers, each in a
cell of its own, so that an error in one costs no other; a drawing becomes its picture; everything
between `solution-start` and `solution-end` is removed. MyST directives become headings and
paragraphs, so that the notebook reads well in any Jupyter. At the end, two cells check the steps of
work on paper; they give no points.
"""

import json
import re
from pathlib import Path
from textwrap import wrap

import yaml

from trajlib.typesetting import plain
from workbook import course
from workbook.authoring.contract import caption_above, plural_kind
from workbook.authoring.drawing_cells import DrawingCells
from workbook.authoring.links import Links
from workbook.authoring.master import read_all, read_master
from workbook.authoring.mistakes import mistakes_text, source_hash
from workbook.authoring.plain_markdown import plain_markdown
from workbook.authoring.statements import assigned_names
from workbook.authoring.study_time import study_time
from workbook.checks.contract.check_cells import reported_names, with_problem
from workbook.mistakes import mistakes_file
from workbook.notebooks import exercises
from workbook.notebooks.new_cells import new_code_cell, new_markdown_cell, new_notebook
from workbook.notebooks.origin import fingerprint
from workbook.numbering import read_number

#: Letters of a line that a code cell shows without scrolling, in Jupyter and VS Code.
WIDTH = 79
#: The code cell before all others: without the workbook it fails with one line that says how to install it.
SETUP = """\
try:
    import workbook.checks, z3
except ModuleNotFoundError as missing:
    page = INSTALL
    how = f"No workbook here. How to install it: {page}"
    missing._render_traceback_ = lambda: [how]
    raise"""
IMPORT = "from workbook import checks"
#: What the cells of the steps say, and their code.
STEPS_TEXT = (
    "Have you worked on paper? Write your steps as a list. The check names the first step that does not "
    "follow from the one before it. It gives no points."
)
STEPS = "my_steps = ...  # list, such as [x**2 - 1, (x - 1)*(x + 1)]"
STEPS_CHECK = f"{IMPORT}\n\nchecks.report(my_steps=checks.steps(my_steps))"


def write_exercises(root, numbers=()):
    """Write the student notebooks of a course, each with its file of sealed mistakes.

    Sealing runs the master, which takes seconds; without `numbers` it is done only where the
    master's code or sentences have changed.

    Parameters
    ----------
    root : path_like
        The folder of the course; the notebooks are written below its folder exercises/.
    numbers : sequence of str
        Numbers of problems, such as "1.15"; all problems if empty.

    Returns
    -------
    list of pathlib.Path
        The files whose content changed.

    Raises
    ------
    MasterError
        If a master breaks its contract.
    """
    root = Path(root)
    links, changed = Links(root, baseurl(root)), []
    masters = (
        [read_master(root / "solutions" / read_number(number).file(".md")) for number in numbers]
        if numbers
        else read_all(root / "solutions")
    )
    for master in masters:
        mistakes = mistakes_file(master.exercise)
        texts = {
            master.exercise: json.dumps(
                student_notebook(master, links), indent=1, ensure_ascii=False
            )
            + "\n"
        }
        if numbers or not (
            mistakes.exists()
            and f'"of": "{source_hash(master)}"' in mistakes.read_text(encoding="utf-8")
        ):
            texts[mistakes] = mistakes_text(master)
        for path, text in texts.items():
            if not path.exists() or path.read_text(encoding="utf-8") != text:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
                changed.append(path)
    return changed


def student_notebook(master, links):
    """Return the student notebook of a master as a dict in nbformat 4.5.

    The result is deterministic. A drawing that has not changed keeps the picture that the notebook
    on disk holds (`workbook.authoring.drawing_cells`).

    Parameters
    ----------
    master : Master
        The master.
    links : Links
        Addresses of the book's labels; where `links.base` is set, the notebook links to the site.

    Returns
    -------
    dict
        The notebook.

    Raises
    ------
    MasterError
        If the code of a drawing cell fails or its last line is no `Drawing`.
    """
    cells, home = _cells(master, links), exercises.home_of(master.number)
    statement = "\n".join(cell["source"] for cell in cells if cell["cell_type"] == "markdown")
    first_code = next(k for k, cell in enumerate(cells) if cell["cell_type"] == "code")
    cells[first_code:first_code] = [
        _instruction(master),
        _code(setup(home), "setup", [(course.INSTALL,) * 2] * (course.INSTALL in home.install)),
    ]
    cells += [
        new_markdown_cell(f"## Check my steps\n\n{STEPS_TEXT}", tags=["steps"]),
        _code(STEPS, "steps"),
        _code(STEPS_CHECK, "steps"),
        _origin(master, _equations(cells, links)),
    ]
    notebook = new_notebook(
        cells,
        workbook={
            "number": master.number,
            "course": home.name,
            "fingerprint": fingerprint(statement),
            "title": master.title,
            "section": master.section,
            "level": master.level,
            "topics": list(master.topics),
            "answers": {
                answer.name: {"kind": answer.kind, "text": answer.text, "exact": answer.exact}
                for answer in master.answers.values()
            },
            "hints": {name: list(texts) for name, texts in master.hints.items()},
            **({"core": list(master.core)} if master.core else {}),
        },
    )
    return (
        exercises.add_links(notebook, exercises.site_urls(links.base)) if links.base else notebook
    )


def setup(home):
    """Return the first code cell of the notebooks of a `Course`."""
    return SETUP.replace("INSTALL", repr(home.install))


def _cells(master, links):
    cells, in_solution = [], False
    drawings, data_cells = DrawingCells(master), 0
    for k, cell in enumerate(master.cells):
        if cell.role == "":
            text, in_solution = _outside_solutions(cell.source, in_solution)
            text, urls = plain_markdown(text, links, master.number)
            if text:
                cells.append(_markdown(text, urls))
        elif cell.role == "drawing":
            cells.append(drawings.cell(cell, caption_above(master.cells[k + 1].source)))
        elif cell.role == "answer":
            names = assigned_names(cell.source, master.answers)
            cells += [_code(_stub(master.answers[name]), "answer") for name in names]
        elif cell.role == "data":
            data_cells += 1
            locked = {"grade": False, "locked": True, "grade_id": f"data-{data_cells}"}
            cells.append(_code(cell.source, "data", nbgrader=locked))
        elif cell.role == "check":
            names = reported_names(cell.source)
            cells += _hints(master, names)
            cells.append(
                _code(
                    _check_source(cell.source, master.number),
                    "check",
                    nbgrader={
                        "grade": True,
                        "locked": True,
                        "points": len(names),
                        "grade_id": f"check-{names[0]}",
                    },
                )
            )
    return cells


def _outside_solutions(text, inside):
    """Return (the text outside solutions, whether the cell ends inside one)."""
    outside = []
    for part in re.split(
        r"(^`{3,}\{solution-(?:start|end)\}.*?^`{3,}[ \t]*$)", text, flags=re.M | re.S
    ):
        if "{solution-start}" in part:
            inside = True
        elif "{solution-end}" in part:
            inside = False
        elif not inside:
            outside.append(part)
    return "".join(outside), inside


def _check_source(source, number):
    """Return the source of a check cell with its import and the number of its problem.

    With the number, mistakes are named wherever the notebook is. With the import, a check cell that
    runs first after a restart can say which cells to run before it.
    """
    return f"{IMPORT}\n\n{with_problem(source, number)}"


def _stub(answer):
    """Return the line `name = ...`, with the answer's meaning as a comment beside or above it."""
    meaning = f"{plural_kind(answer.kind)}: {plain(answer.text)}"
    # the name of a letter with a bar, beside its formula in the page, is the letter's plain form
    meaning = re.sub(r"\b(\w+) \(\1\)", r"\1", meaning)
    if len(line := f"{answer.name} = ...  # {meaning}") <= WIDTH:
        return line
    return "\n".join(
        [*wrap(meaning, WIDTH, initial_indent="# ", subsequent_indent="# "), f"{answer.name} = ..."]
    )


def _hints(master, names):
    folded = [
        f"<details><summary>Hint {k} for <code>{name}</code></summary>\n\n{hint}\n\n</details>"
        for name in names
        for k, hint in enumerate(master.hints[name], start=1)
    ]
    return [_markdown("\n".join(folded))] if folded else []


def core_text(items):
    """Return the sentence that names the core items of a long problem."""
    *first_items, last = items
    subject = f"Items {', '.join(first_items)} and {last} are" if first_items else f"Item {last} is"
    return f"{subject} the core of this problem; the rest is practice."


def _equations(cells, links):
    """Return [("(2.7)", url), ...] of the chapters' equations that cells refer to."""
    numbers = {number for cell in cells for number in re.findall(r"\((\d+\.\d+)\)", cell["source"])}
    urls = [
        (f"({number})", links.url(f"eq-{number.replace('.', '-')}"))
        for number in sorted(numbers, key=lambda number: [int(part) for part in number.split(".")])
    ]
    return [(text, url) for text, url in urls if url]


def _instruction(master):
    time = study_time(master.level, master.answers, master.core)
    core = f" {core_text(master.core)}" if master.core else ""
    return new_markdown_cell(exercises.instruction(time, core), tags=["instruction"])


def _origin(master, equations):
    text, places = exercises.home_of(master.number).origin(master.number, master.section)
    if equations:
        text = (
            f"{text.removesuffix('.')}; numbers such as {', '.join(text for text, _ in equations)} "
            f"name equations of chapter {equations[0][0][1:].split('.')[0]}."
        )
    return _markdown(text, [*places, *equations])


def _markdown(text, urls=()):
    return new_markdown_cell(text, **_link_metadata(urls))


def _code(source, role, urls=(), nbgrader=None):
    metadata = {"tags": [role], **_link_metadata(urls)}
    if nbgrader:
        metadata["nbgrader"] = {
            "schema_version": 3,
            "solution": False,
            "task": False,
            "cell_type": "code",
            **nbgrader,
        }
    return new_code_cell(source, **metadata)


def _link_metadata(urls):
    """Return the metadata from which `exercises.add_links` makes links."""
    return {"places": [list(pair) for pair in urls]} if urls else {}


def baseurl(root):
    """Return the site's address from workbook.toml or _config.yml, "" where none is set."""
    if (root / course.FILE).is_file():
        return course.read(root).site
    config = root / "_config.yml"
    settings = yaml.safe_load(config.read_text(encoding="utf-8")) if config.exists() else {}
    return (settings.get("html") or {}).get("baseurl") or ""

"""Write a notebook with the numbers of all students, for a system that gives one file to all.

Its first cell asks for the student's name, by which a later one finds the row of `numbers.csv`. Texts
with numbers are code cells that display the text for the row, and the data cell takes its numbers by
row. The grader does not depend on any of it: it judges by `numbers.csv`.
"""

import ast
import json
import re
from pathlib import Path

from workbook.grading.course import numbers
from workbook.grading.course.assignment import InputError
from workbook.grading.course.handing_out import file_name, release
from workbook.grading.course.record import put
from workbook.notebooks.new_cells import new_code_cell, new_notebook
from workbook.own_numbers import key

FOLDER = "for-all"
ASKING = """\
# Write your name in this course, in quotes: the login, address or number with
# which you stand in its list. You are graded by the numbers of this name.
student = ..."""
README = """
## Your numbers

The notebooks have numbers of your own. Write your name in this course into the first cell and run
all cells: they show your numbers. You are graded by these, whatever you write there.
"""
FINDING = """\
from workbook.own_numbers import row_of, show

row = row_of(student, {rows})"""


def write(folder, name, site=""):
    """Write the notebook of each problem of a homework; return their paths.

    Parameters
    ----------
    folder : path
        Folder of all homeworks.
    name : str
        The homework's, with its table of numbers.
    site : str
        Address of the student edition of the site, for links to the theory.

    Raises
    ------
    InputError
        If the homework has no table, or a pool.
    """
    target = Path(folder) / name
    homework = numbers.read_homework(target / "assignment.toml")
    if homework.pool or not homework.numbers:
        raise InputError(
            f"{target}: a notebook for all needs {numbers.NAME}, and a homework without a pool"
        )
    texts = {file_name(p): _for_all(p, homework, site) for p in homework.problems}
    texts["README.md"] = (target / "README.md").read_text(encoding="utf-8") + README
    (target / FOLDER).mkdir(exist_ok=True)
    for file, text in texts.items():
        put(target / FOLDER / file, text)
    return [target / FOLDER / file for file in texts if file != "README.md"]


def _for_all(problem, homework, site):
    """Return the text of the notebook of a problem."""
    rows = {key(s): own[problem] for s, own in homework.numbers.items() if problem in own}
    notebooks = {
        row: json.loads(
            release(homework, f"{problem}~{row}", site).replace(
                f"{problem}~{row}", f"{problem}~{{row}}"
            )
        )
        for row in sorted(set(rows.values()))
    }
    if not rows:
        return release(homework, problem, site)
    common = next(iter(notebooks.values()))
    finding = FINDING.format(rows=json.dumps(rows, indent=4))
    cells = [new_code_cell(ASKING), *_tagged(common, "setup"), _hidden(finding)]
    for versions in zip(*(notebook["cells"] for notebook in notebooks.values())):
        if versions[0] not in cells:
            cells += _by_row(dict(zip(notebooks, versions)))
    about = common["metadata"]["workbook"] | {"number": problem, "hints": {}}
    notebook = new_notebook(cells, workbook=about)
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"


def _tagged(notebook, tag):
    return [cell for cell in notebook["cells"] if tag in cell["metadata"].get("tags", ())]


def _by_row(versions):
    """Return the cells in place of one that differs by row, given {row: cell}."""
    cell = next(iter(versions.values()))
    tags = cell["metadata"].get("tags", ())
    sources = {row: "".join(version["source"]) for row, version in versions.items()}
    if "check" in tags:
        return [cell | {"source": sources.popitem()[1].replace('report("', 'report(f"', 1)}]
    if all(version == cell for version in versions.values()) and "{row}" not in str(sources):
        return [cell]
    if "data" in tags:
        return [cell | {"source": _data(sources)}]
    if "answer" in tags:
        comments = {row: re.sub("^# ?", "", text, flags=re.M) for row, text in sources.items()}
        texts = {row: text.rpartition("\n")[0] for row, text in comments.items()}
        return [_shown(texts), cell | {"source": next(iter(sources.values())).splitlines()[-1]}]
    return [_shown({row: _with_pictures(version) for row, version in versions.items()})]


def _data(sources):
    """Return a data cell whose numbers are taken by row, given {row: its text}."""
    statements = [ast.parse(source).body for source in sources.values()]
    first = next(iter(sources.values()))
    lines = first.splitlines(keepends=True)
    for versions in reversed(list(zip(*statements))):
        texts = {
            row: ast.get_source_segment(source, statement)
            for (row, source), statement in zip(sources.items(), versions)
        }
        if len(set(texts.values())) == 1:
            continue
        statement = versions[0]
        values = "".join(
            f"    {row}: ({ast.get_source_segment(source, version.value)}),\n"
            for (row, source), version in zip(sources.items(), versions)
        )
        target = ast.get_source_segment(first, statement.targets[0])
        lines[statement.lineno - 1 : statement.end_lineno] = [f"{target} = {{\n{values}}}[row]\n"]
    return "".join(lines).rstrip("\n")


def _with_pictures(cell):
    """Return the text of a cell with its attached pictures inside."""
    text = "".join(cell["source"])
    for file, contents in cell.get("attachments", {}).items():
        for kind, content in contents.items():
            text = text.replace(f"attachment:{file}", f"data:{kind};base64,{content}")
    return text


def _shown(texts):
    """Return a cell that displays the text for the row."""
    entries = "".join(f"    {row}: {_literal(text)},\n" for row, text in texts.items())
    return _hidden(f"show({{\n{entries}}}, row)")


def _literal(text):
    return repr(text.replace("~{row}", ""))


def _hidden(source):
    return new_code_cell(source, jupyter={"source_hidden": True})

"""The student's copy of a master: a plain Jupyter notebook without solutions, with nbgrader's
metadata.

Data and check cells stand as they are and are locked; each answer cell becomes a stub `name = ...`;
a drawing becomes the picture that it makes; everything between `solution-start` and `solution-end`
leaves. MyST directives become headings and paragraphs, so that the copy reads well in any Jupyter.
"""

import json
import re
from pathlib import Path
from textwrap import wrap

from trajlib import __version__
from trajlib.typesetting import plain
from workbook.authoring.contract import caption_above, in_words, master_file
from workbook.authoring.drawn import Drawn
from workbook.authoring.links import Links
from workbook.authoring.master import read, read_all
from workbook.authoring.mistakes import origin, text_of
from workbook.authoring.statements import assigned_names
from workbook.authoring.study_time import study_time
from workbook.checks.contract.check_cells import reported_names
from workbook.mistakes import file_beside
from workbook.notebooks import exercises

CREDIT = (
    "S. S. Lemak, V. M. Morozov, M. Yu. Popelensky, V. V. Tikhomirov, O. Yu. Cherkasov, "
    "*Mechanics of Controlled Systems: Problem Book* (in Russian), ed. V. V. Aleksandrov, Yu. V. "
    "Bolotin, Moscow, 2012"
)
RESEARCH = "the research chapters of the workbook"
WHEEL = f"trajlib-{__version__}-py3-none-any.whl"
#: What a notebook's code cell shows of a line, in Jupyter and VS Code alike.
WIDTH = 79
#: The first code cell: where the workbook is missing, it fails with one line that says how to get it.
NEEDS = f"""\
try:
    import workbook.checks, z3
except ModuleNotFoundError as missing:
    wheel = "{WHEEL}[workbook]"
    how = f'No workbook here. Run   %pip install "{{wheel}}"'
    missing._render_traceback_ = lambda: [how]
    raise"""
IMPORT = "from workbook import checks"

DIRECTIVE = re.compile(
    r"^(?P<fence>`{3,}|:{3,})\{(?P<name>[\w:-]+)\}[ "
    r"\t]*(?P<argument>[^\n]*)\n(?P<body>.*?)^(?P=fence)[ \t]*$\n?",
    re.M | re.S,
)
OPTIONS = re.compile(r"(?:^:[\w-]+:.*\n)+", re.M)
SILENT = {"index", "exercise-end", "solution-start", "solution-end"}


def write_exercises(root, numbers=()):
    """Write the students' notebooks below `root`/exercises, with their mistakes beside them;
    returns the paths whose content changed.

    All of them, or those of the problems `numbers` ("1.15"). Mistakes are found by running the
    master, which takes seconds: of the problems named, and where what they are made of has changed.
    """
    root = Path(root)
    links, changed = Links(root, baseurl(root)), []
    masters = (
        [read(root / "solutions" / master_file(number)) for number in numbers]
        if numbers
        else read_all(root / "solutions")
    )
    for master in masters:
        mistakes = file_beside(master.exercise)
        texts = {
            master.exercise: json.dumps(
                student_notebook(master, links), indent=1, ensure_ascii=False
            )
            + "\n"
        }
        if numbers or not (
            mistakes.exists()
            and f'"of": "{origin(master)}"' in mistakes.read_text(encoding="utf-8")
        ):
            texts[mistakes] = text_of(master)
        for path, text in texts.items():
            if not path.exists() or path.read_text(encoding="utf-8") != text:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
                changed.append(path)
    return changed


def student_notebook(master, links):
    """The student's notebook as a dict in nbformat 4.5; the same master always gives the same
    notebook.

    A drawing that has not changed keeps the picture that the copy on disk has of it
    (`workbook.authoring.drawn`).
    """
    cells, solution = [_code(NEEDS, "setup", [(WHEEL, f"wheels/{WHEEL}")])], False
    drawn = Drawn(master)
    for k, cell in enumerate(master.cells):
        if cell.role == "":
            text, solution = _outside_solutions(cell.source, solution)
            text, places = plain_markdown(text, links, master.number)
            if text:
                cells.append(_markdown(text, places))
        elif cell.role == "drawing":
            cells.append(drawn.cell(cell, caption_above(master.cells[k + 1].source)))
        elif cell.role == "answer":
            if stub := _stub(master, cell.source):
                cells.append(_code(stub, "answer"))
        elif cell.role == "data":
            cells.append(_code(cell.source, "data", nbgrader={"grade": False, "locked": True}))
        elif cell.role == "check":
            names = reported_names(cell.source)
            cells += _hints(master, names)
            cells.append(
                _code(
                    _alone(cell.source, master.number),
                    "check",
                    nbgrader={"grade": True, "locked": True, "points": len(names)},
                )
            )
    cells.insert(0, _origin(master, _equations(cells, links)))
    for k, cell in enumerate(cells):
        cell["id"] = f"cell-{k:02d}"
        if "nbgrader" in cell["metadata"]:
            cell["metadata"]["nbgrader"]["grade_id"] = f"{cell['metadata']['tags'][0]}-{k:02d}"
    about = {
        "number": master.number,
        "title": master.title,
        "section": master.section,
        "level": master.level,
        "topics": list(master.topics),
        "answers": {
            a.name: {"kind": a.kind, "text": a.text, "exact": a.exact}
            for a in master.answers.values()
        },
        "hints": {name: list(texts) for name, texts in master.hints.items()},
        **({"core": list(master.core)} if master.core else {}),
    }
    notebook = {
        "cells": cells,
        "metadata": {
            "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
            "language_info": {"name": "python"},
            "workbook": about,
        },
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    return exercises.linked(notebook, exercises.below(links.base)) if links.base else notebook


def plain_markdown(text, links, number=""):
    """MyST Markdown as Markdown that any Jupyter shows: directives become headings, quotes and
    formulas.

    Returns the text and the places of the book it names, [(words, place), ...] in the order of the
    text.
    """
    text = _without_directives(text, number)
    # the exercise's own heading says it with its title
    text = re.sub(r"^# Problem \d+\.\d+$", "", text, flags=re.M)
    text = re.sub(r"^\([\w-]+\)=\n", "", text, flags=re.M)
    text = re.sub(r"\[([^\]]+)\]\(#([\w-]+)\)", lambda m: _named(m[1], links.place(m[2])), text)
    text = re.sub(
        r"\{(?:ref|numref|prf:ref)\}`([^`<]+?)\s*<([\w-]+)>`",
        lambda m: _named(m[1], links.place(m[2])),
        text,
    )
    text = re.sub(
        r"\{eq\}`eq-([\w-]+)`",
        lambda m: _named(
            f"({_tag(m[1])})", links.place(f"eq-{m[1]}") if re.fullmatch(r"\d+-\d+", m[1]) else None
        ),
        text,
    )
    text = re.sub(
        r"\{problem\}`([\d.]+)`",
        lambda m: f"{'Pp'[not _begins(m.string[: m.start()])]}roblem {m[1]}",
        text,
    )
    text = re.sub(r"\{cite(?::\w)?\}`[^`]*`", "", text)
    text = re.sub(r"\{[\w:]+\}`([^`<]+?)(?:\s*<[^>]*>)?`", r"\1", text)
    text = THIRD.sub(lambda m: rf"\overset{{\ldots}}{{{m[1] or m[2]}}}", text)
    text = re.sub(r"\n{3,}", "\n\n", text).strip()
    return NAMED.sub(r"\1", text), [match.groups() for match in NAMED.finditer(text)]


#: A third derivative: VS Code's KaTeX learned its three dots late, and shows an error in red for
#: what it does not know.
THIRD = re.compile(r"\\dddot\s*(?:\{(\w+)\}|(\w|\\[a-z]+))")

#: A place while the text is being made; the characters occur in no text.
NAMED = re.compile("\x02(.*?)\x03(.*?)\x04", re.S)


#: What stands before the first word of a sentence, and before the first of a paragraph or an entry
#: in Markdown.
SENTENCE_END = re.compile(r"(?<!e\.g)(?<!i\.e)(?<!cf)[.!?][)\"”*]*\s+$")
OPENING = re.compile(r"(\A|\n[>\s]*\n|\n(?=[>\s]*([-*+|]|\d+\.) ))[>\s]*(([-*+|]|\d+\.) +)?\**$")


def _begins(before):
    return bool(SENTENCE_END.search(before) or OPENING.search(before))


def _named(text, place):
    return text if place is None else f"\x02{text}\x03{place}\x04"


def _outside_solutions(text, inside):
    """The part of a Markdown cell that lies outside solutions; they open in one cell and close in
    another."""
    kept = []
    for part in re.split(
        r"(^`{3,}\{solution-(?:start|end)\}.*?^`{3,}[ \t]*$)", text, flags=re.M | re.S
    ):
        if "{solution-start}" in part:
            inside = True
        elif "{solution-end}" in part:
            inside = False
        elif not inside:
            kept.append(part)
    return "".join(kept), inside


def _without_directives(text, number):
    return DIRECTIVE.sub(lambda match: _directive(match, number), text)


def _directive(match, number):
    name, argument = match["name"], match["argument"].strip()
    options = OPTIONS.match(match["body"])
    body = match["body"][options.end() :] if options else match["body"]
    label = re.search(r":label:\s*(\S+)", options[0]) if options else None
    if name in SILENT:
        return ""
    if name == "exercise-start":
        return f"# Problem {number}. {argument}\n"
    if name == "math":
        tag = rf" \tag{{{_tag(label[1].removeprefix('eq-'))}}}" if label else ""
        return f"$$\n{body.strip()}{tag}\n$$\n"
    if name in ("figure", "image"):
        return f"*{body.strip()}*\n" if body.strip() else ""
    heading = argument or name.removeprefix("prf:").capitalize()
    quoted = "\n".join(
        f"> {line}".rstrip() for line in _without_directives(body, number).strip().split("\n")
    )
    return f"> **{heading}**\n>\n{quoted}\n"


def _tag(label):
    """The number that a label such as 1-15-a stands for: 1.15a."""
    chapter, *rest = label.split("-")
    return ".".join([chapter, "".join(rest)]) if rest else chapter


def _alone(source, number):
    """A check cell that says which problem it is for, so that mistakes can be named wherever the
    notebook is, and that has the checks by itself: run first after a restart, it says what to run
    before it."""
    numbered = re.sub(
        r"(checks\.report\()(\s*)(?=\w)",
        lambda m: f'{m[1]}{m[2]}"{number}",{m[2] or chr(10) + " " * len(m[1])}',
        source,
        count=1,
    )
    return f"{IMPORT}\n\n{numbered}"


def _stub(master, source):
    """A line `name = ...` for each answer that the cell assigns. What it is stands beside it, or
    above it where an editor would cut the line off."""
    told = {
        name: f"{in_words(master.answers[name].kind)}: {plain(master.answers[name].text)}"
        for name in assigned_names(source, master.answers)
    }
    beside = [f"{name} = ...  # {what}" for name, what in told.items()]
    if all(len(line) <= WIDTH for line in beside):
        return "\n".join(beside)
    return "\n\n".join(
        "\n".join(
            [*wrap(what, WIDTH, initial_indent="# ", subsequent_indent="# "), f"{name} = ..."]
        )
        for name, what in told.items()
    )


def _hints(master, names):
    folded = [
        f"<details><summary>Hint {k} for <code>{name}</code></summary>\n\n{hint}\n\n</details>"
        for name in names
        for k, hint in enumerate(master.hints[name], start=1)
    ]
    return [_markdown("\n".join(folded))] if folded else []


def core_text(items):
    """What a reader is told of the core of a long problem."""
    *others, last = items
    named = f"Items {', '.join(others)} and {last} are" if others else f"Item {last} is"
    return f"{named} the core of this problem; the rest is practice."


def _equations(cells, links):
    """[("(2.7)", place), ...] of the equations of the chapters that cells name; those of problems
    have a letter."""
    named = {number for cell in cells for number in re.findall(r"\((\d+\.\d+)\)", cell["source"])}
    places = [
        (f"({number})", links.place(f"eq-{number.replace('.', '-')}"))
        for number in sorted(named, key=lambda number: [int(part) for part in number.split(".")])
    ]
    return [(words, place) for words, place in places if place]


def _origin(master, equations):
    chapter = master.number.split(".")[0]
    credit = f"{CREDIT}, problem {master.number}" if int(chapter) <= 5 else RESEARCH
    return _markdown(
        f"*The data of this problem come from* {credit}.\n\n"
        'You need the workbook: from a checkout of it run `pip install -e ".[workbook]"`, or '
        "install the wheel that the workbook's site offers. Replace each `...` by your answer and "
        "run the check cell below it: it says what holds and what does not, as often as you like. "
        f"The theory stands in chapter {chapter}"
        + (
            f"; numbers such as {', '.join(words for words, _ in equations)} name equations of "
            f"chapter {equations[0][0][1:].split('.')[0]}"
            if equations
            else ""
        )
        + "."
        + f"\n\nThis problem takes {study_time(master.level, master.answers, master.core)}, at a guess."
        + (f" {core_text(master.core)}" if master.core else ""),
        [
            ("wheel that the workbook's site offers", f"wheels/{WHEEL}"),
            (f"chapter {chapter}", f"book/ch{chapter}.html"),
            *equations,
        ],
    )


def _markdown(text, places=()):
    return {"cell_type": "markdown", "id": "", "metadata": _places(places), "source": text}


def _code(source, role, places=(), nbgrader=None):
    metadata = {"tags": [role], **_places(places)}
    if nbgrader:
        metadata["nbgrader"] = {
            "schema_version": 3,
            "solution": False,
            "task": False,
            "cell_type": "code",
            **nbgrader,
        }
    return {
        "cell_type": "code",
        "execution_count": None,
        "id": "",
        "metadata": metadata,
        "outputs": [],
        "source": source,
    }


def _places(places):
    return {"places": [list(place) for place in places]} if places else {}


def baseurl(root):
    """The site's address in _config.yml, empty until a lecturer sets it."""
    import yaml

    config = root / "_config.yml"
    settings = yaml.safe_load(config.read_text(encoding="utf-8")) if config.exists() else {}
    return (settings.get("html") or {}).get("baseurl") or ""

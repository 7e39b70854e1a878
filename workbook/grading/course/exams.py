"""Exams: the cover page, the notebooks, and the papers that the workbook proposes.

An exam is a homework with a table `[exam]` in its `assignment.toml`: the time allowed, and what may be
used. Its notebooks have no hints and judge no answer; their check cells say whether an answer can be
read. A paper names the problems, the answers that are asked with their marks, and what is graded by hand:

    [linear-control-midterm]
    title = "Linear control, midterm"
    minutes = 90
    aids = "one sheet of notes"         # optional
    marks."2.4" = {a_observable = 3, b_unobservable = 2}
    by_hand.words = {points = 2, text = "2.4: the unobservable motion in words"}

The papers of the workbook are in `book/exams.toml`; a file of one's own has the fields of one paper.
"""

import re
import tomllib
from dataclasses import dataclass
from html import escape
from pathlib import Path

from workbook.course import PACKAGE, WORKBOOK
from workbook.grading.course.assignment import (
    BY_HAND,
    AssignmentError,
    Exam,
    read_by_hand,
    read_exam,
)
from workbook.notebooks import exercises
from workbook.numbering import read_number

#: What every student confirms.
HONESTY = "I have worked alone and used nothing but the permitted aids."
#: The line of a cell that an answer is to be put into.
STUB = re.compile(r"^(\w+) = \.\.\.", re.MULTILINE)
README = """\
# {title}

{minutes} minutes, {total:g} marks. Permitted aids: {aids}.
{due}
| problem | answers and marks | marks |
|---|---|---|
{rows}
| | total | {total:g} |

## How to work

1. Each problem has its notebook; open them in Jupyter. Replace each `...` by your answer and keep the names of the
   variables: answers are found by name, in whatever cell they are assigned.
2. A check cell says only whether an answer was taken and can be read. All answers are judged in the grading.
3. What is asked in words, write into a text cell of the notebook or on paper.

## How to hand in

Save the notebooks and hand them in **under the names they have**, within the time. If you hand in again, {counts}.

Your notebook is run from top to bottom in a fresh process, without network and without files beside it, so run it once
that way yourself (*Restart kernel and run all cells*). Each answer earns its marks alone: a wrong or missing one
costs nothing else.

By handing in you confirm: *{honesty}*
"""
COVER = """\
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>{title}</title>
<style>
@page {{ size: A4; margin: 2cm; }}
body {{ font: 12pt/1.45 Georgia, serif; color: #000; background: #fff;
  max-width: 17cm; margin: 1cm auto; padding: 0 .5cm; }}
h1 {{ font-size: 20pt; margin: 0 0 .4cm; }}
table {{ border-collapse: collapse; width: 100%; margin: .6cm 0; }}
td, th {{ border: 1px solid #555; padding: .12cm .2cm; text-align: left; vertical-align: top; }}
td:nth-child(n+3), th:nth-child(n+3) {{ text-align: right; white-space: nowrap; }}
th:last-child {{ min-width: 1.8cm; }}
tr {{ break-inside: avoid; }}
.line {{ display: flex; gap: .3cm; margin: .55cm 0; }}
.line::after {{ content: ""; flex: 1; border-bottom: 1px solid #000; }}
</style>
</head>
<body>
<h1>{title}</h1>
<p class="line">Name</p>
<p class="line">Student number</p>
<p>Time allowed: {minutes} minutes. Marks: {total:g}. Permitted aids: {aids}.</p>
<table>
<tr><th>problem</th><th>answers and marks</th><th>marks</th><th>given</th></tr>
{rows}
<tr><th></th><th>total</th><th>{total:g}</th><th></th></tr>
</table>
<p>The check cells of the notebooks say only whether an answer was taken and can be read. All answers are judged in the
grading.</p>
<p>{honesty}</p>
<p class="line">Date and signature</p>
</body>
</html>
"""


@dataclass(frozen=True)
class Paper:
    """A paper: problems with the marks of the answers that are asked, and what is graded by hand."""

    title: str
    exam: Exam
    marks: dict
    by_hand: dict


def papers():
    """Return the fields of the workbook's papers by name."""
    path = WORKBOOK.folder / "book" / "exams.toml"
    if not path.is_file():
        path = PACKAGE / "_exams.toml"
    return tomllib.loads(path.read_text(encoding="utf-8"))


def find(name):
    """Return a `Paper` of the workbook by its name, or that in a file; raises `AssignmentError`."""
    if not name.endswith(".toml"):
        table = papers().get(name)
        if table is None:
            raise AssignmentError(
                f"there is no paper {name}; there are {', '.join(papers())}, and a file of your own "
                "ends in .toml"
            )
        return _paper(name, table)
    try:
        return _paper(name, tomllib.loads(Path(name).read_text(encoding="utf-8")))
    except OSError as error:
        raise AssignmentError(f"{name}: {error.strerror}") from None
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise AssignmentError(f"{name} is not TOML in UTF-8: {error}") from None


def _paper(name, table):
    marks = table.get("marks")
    if not (
        {"title", "minutes", "marks"}
        <= table.keys()
        <= {"title", "minutes", "aids", "marks", BY_HAND}
        and isinstance(marks, dict)
        and marks
        and all(
            isinstance(answers, dict)
            and answers
            and all(type(mark) in (int, float) and mark > 0 for mark in answers.values())
            for answers in marks.values()
        )
    ):
        raise AssignmentError(
            f"{name}: a paper has title, minutes, perhaps aids and {BY_HAND}, and marks such as "
            'marks."2.4" = {a_observable = 3}, each above 0'
        )
    exam = read_exam(name, {key: table[key] for key in ("minutes", "aids") if key in table})
    read_by_hand(name, table.get(BY_HAND, {}))
    return Paper(str(table["title"]), exam, marks, table.get(BY_HAND, {}))


# What students get


def readme(homework, due=""):
    """Return the README of an exam, its cover page in Markdown; `due` says until when."""
    rows = "\n".join(
        f"| {what} | {', '.join(f'`{name}` {worth:g}' for name, worth in answers.items())} | {total:g} |"
        if isinstance(answers, dict)
        else f"| {what} | {answers} | {total:g} |"
        for what, answers, total in _rows(homework)
    )
    return README.format(
        due=f"\nDue {due}.\n" if due else "",
        rows=rows,
        counts="the best attempt counts" if homework.attempt == "best" else "the last one counts",
        **_fields(homework),
    )


def cover(homework):
    """Return the cover page of an exam to print, as HTML."""
    rows = "\n".join(
        f"<tr><td>{escape(what)}</td><td>"
        + (
            ", ".join(f"<code>{name}</code> {worth:g}" for name, worth in answers.items())
            if isinstance(answers, dict)
            else escape(answers)
        )
        + f"</td><td>{total:g}</td><td></td></tr>"
        for what, answers, total in _rows(homework)
    )
    fields = {
        name: escape(value) if isinstance(value, str) else value
        for name, value in _fields(homework).items()
    }
    return COVER.format(rows=rows, **fields)


def make_exam(notebook, homework, problem):
    """Make the notebook of a problem, a dict, one of an exam: no hints, and what the cover says."""
    asked = _asked(homework, problem)
    kept = []
    notebook["metadata"]["workbook"]["hints"] = {}
    for cell in notebook["cells"]:
        tags, source = cell["metadata"].get("tags", ()), "".join(cell["source"])
        if "steps" in tags or source.startswith("<details><summary>Hint"):
            continue
        if "instruction" in tags:
            cell["source"] = instruction(homework, problem)
        if "answer" in tags and not set(STUB.findall(source)) & asked.keys():
            cell["source"] = f"# NOT ASKED: no marks\n{source}"
        kept.append(cell)
    notebook["cells"] = kept


def instruction(homework, problem):
    """Return the text that stands below the statement of a problem of an exam."""
    answers = _asked(homework, problem)
    marks = ", ".join(f"`{name}` {worth:g}" for name, worth in answers.items())
    words = "".join(
        f"\n\nIn words ({homework.points[BY_HAND][name]:g} marks), in a text cell or on paper: {text}"
        for name, text in homework.by_hand.items()
        if problem in text.replace(":", " ").split()
    )
    exam = homework.exam
    return (
        f"**{homework.title}: {exam.minutes} minutes for all problems.** This one has "
        f"{sum(answers.values()):g} marks: {marks}. Permitted aids: {exam.aids}.\n\n"
        "Replace each `...` by your answer. The check cells say only whether an answer was taken and can "
        f"be read; it is judged in the grading.{words}\n\nBy handing in you confirm: *{HONESTY}*"
    )


def _asked(homework, problem):
    return {name: worth for name, worth in homework.points[problem].items() if worth}


def _rows(homework):
    """Return (problem, its answers with marks or a text, marks) of an exam."""
    rows = []
    for problem in homework.problems:
        answers = _asked(homework, problem)
        title = exercises.find(problem).about["title"]
        one_of = "one of these: " if problem in homework.pool else ""
        what = f"{one_of}{problem} {title}, in {read_number(problem).handed_out}"
        rows.append((what, answers, sum(answers.values())))
    for name, text in homework.by_hand.items():
        rows.append(("in words", text, homework.points[BY_HAND][name]))
    return rows


def _fields(homework):
    return {
        "title": homework.title,
        "minutes": homework.exam.minutes,
        "aids": homework.exam.aids,
        "total": homework.max_points,
        "honesty": HONESTY,
    }

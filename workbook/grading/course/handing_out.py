"""Make a homework folder to hand out: notebooks, a README for students, and assignment.toml.

A notebook is named ch1-p15.ipynb, so that its problem, 1.15, is still known when an editor has
dropped its metadata.
"""

import datetime
import json
import re
import shutil
from pathlib import Path

from workbook.authoring.contract import item_of
from workbook.authoring.study_time import rounded_minutes
from workbook.grading.course import assignment as assignments
from workbook.grading.course import exams
from workbook.grading.course.assignment import BY_HAND, POOL, AssignmentError
from workbook.grading.course.policy import can_be_due
from workbook.notebooks import exercises
from workbook.numbering import read_number

#: A date, with or without a time, with or without a zone.
DATE = re.compile(r"\d{4}-\d\d-\d\d([T ]\d\d:\d\d(:\d\d)?(Z|[+-]\d\d:\d\d)?)?", re.ASCII)

README = """\
# {title}
{due}
{problems}

## How to work

1. Install the workbook as the end of each notebook says, and open the notebooks in Jupyter.
2. Replace each `...` by your answer; the comment beside it says what is asked. Keep the names of the variables: answers
   are found by name, in whatever cell they are assigned.
3. Run the check cell as often as you like. It says what holds and what does not.{kept}

## How to hand in

Save the notebooks and hand them in **under the names they have**. {attempts} Of what you hand in at once, one notebook
a problem counts.

Your notebook is run from top to bottom in a fresh process, without network and without files beside it, so run it once
that way yourself (*Restart kernel and run all cells*). Each answer earns its points alone: a wrong or missing one
costs nothing else.
Changing a check cell changes nothing, since answers are judged by the cells as they were handed out.
"""


def make(
    folder,
    name,
    problems,
    title=None,
    due=None,
    site="",
    direction=False,
    kept_for_grading=(),
    own_numbers=False,
    pool=(),
    marks=None,
    exam=None,
    by_hand=None,
):
    """Write a homework into `folder`/`name`, which must not exist.

    Parameters
    ----------
    folder : path
        Folder of all homeworks.
    name : str
        The homework's name.
    problems : list of str
        The problems' numbers.
    title : str, optional
        By default the name.
    due : datetime.datetime, optional
        With a time zone.
    site : str
        Address of the student edition of the site, for links to the theory.
    direction : bool
        Whether verdicts say in which direction a number is wrong.
    kept_for_grading : sequence of str
        Problems, and answers such as "1.15.e_region", that only the grading judges.
    own_numbers : bool
        Whether the notebooks are left out, since each student gets others (`student_folders`).
    pool : list of str
        Further problems, of which each student gets one.
    marks : dict, optional
        {problem: {answer: points}} of problems where only some answers are asked, or not all are
        worth a point; the other answers of these have no points.
    exam : Exam, optional
        What makes it an exam, which has a cover page as well.
    by_hand : dict, optional
        {name: {"points": ..., "text": ...}} of what a lecturer grades by hand.

    Returns
    -------
    Assignment
        The homework.

    Raises
    ------
    AssignmentError
        If the name, the problems or the folder cannot be used.
    """
    target = Path(folder) / name
    if not assignments.can_be_name(name):
        raise AssignmentError(
            f"{name!r} cannot be the name of a homework: it names a folder, take letters, digits, "
            "- and _"
        )
    if target.exists():
        raise AssignmentError(f"{target} is already there; take another name or remove it")
    _check([*problems, *pool])
    toml = _toml(
        title or name,
        problems,
        due,
        direction,
        kept_for_grading,
        pool,
        marks or {},
        exam,
        by_hand or {},
    )
    homework = assignments.from_text(toml, target / "assignment.toml")
    files = {"assignment.toml": toml, **texts_for_students(homework)}
    if not own_numbers:
        files |= {file_name(p): release(homework, p, site) for p in [*problems, *pool]}
    writing = target.with_name(f".{name}.writing")  # renamed when all is there
    try:
        if writing.exists():
            shutil.rmtree(writing)
        writing.mkdir(parents=True)
        for file, text in files.items():
            (writing / file).write_text(text, encoding="utf-8")
        writing.rename(target)
    except OSError as error:
        shutil.rmtree(writing, ignore_errors=True)
        raise AssignmentError(f"{target} cannot be written: {error.strerror}") from None
    return homework


def texts_for_students(homework):
    """Return {file name: text} of what students read before the notebooks."""
    if homework.exam is None:
        return {"README.md": _readme(homework)}
    return {
        "README.md": exams.readme(homework, due_text(homework.due) if homework.due else ""),
        "cover.html": exams.cover(homework),
    }


def file_name(problem):
    """Return the name under which a problem's notebook is handed out and comes back.

    >>> file_name("1.4")
    'ch1-p04.ipynb'
    """
    return read_number(problem).handed_out


def release(homework, variant, site=""):
    """Return the text of a student's notebook, whose references are links to `site` if given.

    Its check cells say what the homework wants them to. Students do not have the course's own checks:
    what these judge is left to the grading.
    """
    notebook = json.loads(exercises.find(variant).path.read_text(encoding="utf-8"))
    problem = variant.partition("~")[0]
    if kept := homework.kept_of(problem):
        notebook["metadata"]["workbook"][exercises.KEPT_NAMES] = kept
    not_here = [*kept, *exercises.find(variant).own_checked]
    for cell in notebook["cells"]:
        if "check" in cell["metadata"].get("tags", ()):
            source = exercises.keeping_for_grading("".join(cell["source"]), not_here)
            cell["source"] = source if homework.direction else exercises.hiding_direction(source)
        if "instruction" in cell["metadata"].get("tags", ()):
            cell["source"] = instruction(homework, problem) or cell["source"]
    if homework.exam:
        exams.make_exam(notebook, homework, problem)
    if site := exercises.home_of(variant).site or site:
        # Homework links to the student edition, which has no solutions.
        to_site = exercises.site_urls(site)
        notebook = exercises.add_links(
            notebook, lambda page: to_site(re.sub("^solutions/", "exercises/", page))
        )
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"


def instruction(homework, problem):
    """Return the text below the statement where it is not that of practice, otherwise None."""
    points = homework.points[problem]
    asked = [name for name, worth in points.items() if worth]
    if homework.exam:
        return exams.instruction(homework, problem)
    if len(asked) == len(points):
        return None
    time = rounded_minutes(exercises.find(problem).about["level"], len(asked))
    return exercises.instruction(
        f"about {time} min for the answers of {_items(asked)}, which count here; the others are practice"
    )


def due_date(text):
    """Return the datetime, with a zone, of a text such as "2026-10-01 23:59" or "2026-10-01".

    Without a zone it is in this machine's; a date alone means the end of that day. Raises
    `AssignmentError`.
    """
    try:
        # Python reads further forms, such as 2026-W40-4, to which no end of the day is added below.
        due = datetime.datetime.fromisoformat(text) if DATE.fullmatch(text) else None
        if due is None or not can_be_due(due):
            raise ValueError
    except ValueError:
        raise AssignmentError(
            f'{text!r} is not a date; write "2026-10-01 23:59", or "2026-10-01T23:59:00+03:00" '
            "with a zone"
        ) from None
    if len(text) == len("2026-10-01"):
        due = due.replace(hour=23, minute=59, second=59)
    return due if due.tzinfo else due.astimezone()


def _check(problems):
    for problem in problems:
        try:
            assignments.answers_of(problem)
        except exercises.UnknownExercise as error:
            raise AssignmentError(str(error)) from None
    if len(set(problems)) != len(problems):
        raise AssignmentError("a problem is named twice")


def _toml(title, problems, due, direction, kept_for_grading, pool, marks, exam, by_hand):
    quoted, pool_quoted = (", ".join(map(_text, numbers)) for numbers in (problems, pool))
    points = "\n".join(_points(problem, marks.get(problem)) for problem in problems)
    if pool:
        points = (
            f"{POOL} = {len(assignments.answers_of(pool[0]))}  # each of its problems\n{points}"
        )
    first = (*problems, *pool)[0]
    judging = (
        "\n[exam]  # the notebooks judge no answer, only the grading\n"
        f"minutes = {exam.minutes}  # the time allowed\n"
        f"aids = {_text(exam.aids)}  # what may be used\n\n"
        if exam
        else f"direction = {str(direction).lower()}  # true: messages say whether a number is too great or "
        "too small, as in practice\n"
        f"kept_for_grading = [{', '.join(map(_text, kept_for_grading))}]  # answers that the notebooks do "
        "not judge, only the grading\n\n"
    )
    given = "".join(
        f"{_text(name)} = {{points = {item['points']:g}, text = {_text(item['text'])}}}\n"
        for name, item in by_hand.items()
    )
    return (
        f"# What counts. {'README.md, cover.html and the notebooks tell' if exam else 'README.md tells'} "
        "the students the same: after a change here, change it there too.\n"
        f"title = {_text(title)}\nproblems = [{quoted}]\n"
        + (f"pool = [{pool_quoted}]  # each student has one of them\n" if pool else "")
        + (
            f"due = {due.isoformat(timespec='seconds')}\n"
            if due
            else "# due = 2026-10-01T23:59:00+03:00  # later work is marked late\n"
        )
        + '# zone = "Europe/Moscow"  # of the times in Moodle\'s worksheet; by default that of due\n'
        + f'attempt = "{"last" if exam else "best"}"  # which of several submissions counts: "best" or '
        '"last"\n# attempts = 3  # further ones do not count\n'
        f"{judging}"
        f"# A problem's points are shared equally by its answers; "
        f"{_text(first + '.' + assignments.answers_of(first)[0])} = 2 "
        f"would set one answer's.\n[points]\n{points}\n\n"
        + (f"[{BY_HAND}]  # what a lecturer grades\n{given}\n" if given else "")
        + "# Without this lateness is marked and costs nothing.\n# [late]\n"
        "# per_day = 0.1  # the share of the points that each day begun takes\n"
        "# floor = 0.5  # the share that is kept until the cut-off\n"
        "# cutoff_days = 7  # later work has no points\n\n"
        "# [extensions]\n"
        '# "ann" = 2026-10-08T23:59:00+03:00  # a due date of her own\n\n'
        "# [exemptions]\n"
        f'# "bob" = [{_text((*problems, *pool)[-1])}]  # his other answers share its points\n'
    )


def _points(problem, marks):
    """Return the lines of a problem's points: by default one an answer, none for what is not asked."""
    answers = assignments.answers_of(problem)
    marks = marks or dict.fromkeys(answers, 1)
    for name in marks.keys() - set(answers):
        raise AssignmentError(f"problem {problem} has no answer {name}")
    asked = [answer for answer in answers if answer in marks]
    differ = len(set(marks.values())) > 1
    lines = [f"{_text(problem)} = {sum(marks.values()):g}  # {', '.join(asked)}"]
    for answer in answers:
        if answer not in marks:
            lines.append(f"{_text(f'{problem}.{answer}')} = 0  # not asked")
        elif differ:
            lines.append(f"{_text(f'{problem}.{answer}')} = {marks[answer]:g}")
    return "\n".join(lines)


def _text(value):
    """Return a TOML string, whose escapes are those of JSON, except for DEL."""
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def _readme(homework):
    entries = [_entry(problem, points) for problem, points in homework.points.items()]
    common = len(entries) - len(homework.pool)
    rows = entries[:common]
    if homework.pool:
        rows += ["- one of these, which is in your folder:", *(f"  {e}" for e in entries[common:])]
    due = f"\nDue {due_text(homework.due)}.\n" if homework.due else ""
    counts = "the best one counts" if homework.attempt == "best" else "the last one counts"
    attempts = (
        f"You may hand in up to {homework.attempts} times; {counts}."
        if homework.attempts
        else f"You may hand in again; {counts}."
    )
    return README.format(
        title=homework.title,
        due=due,
        problems="\n".join(rows),
        kept=_kept(homework),
        attempts=attempts,
    )


def _entry(problem, points):
    asked = [name for name, worth in points.items() if worth]
    worth, count = sum(points.values()), len(asked)
    text = (
        f"- **{problem}** {exercises.find(problem).about['title']}, in `{file_name(problem)}`: "
        f"{worth:g} point{'s' * (worth != 1)} for {count} answer{'s' * (count != 1)}"
    )
    if count == len(points):
        return text
    return f"{text}, those of {_items(asked)}; the others are practice"


def _items(names):
    return ", ".join(sorted({item_of(name) for name in names}))


def _kept(homework):
    names = [
        f"`{answer}` of {problem}"
        for problem in homework.problems
        for answer in dict.fromkeys(
            [*homework.kept_of(problem), *exercises.find(problem).own_checked]
        )
    ]
    if not names:
        return ""
    return f"\n   Only the grading judges {', '.join(names)}."


def due_text(due):
    """Return a due date as people read it: 2026-10-01 23:59 (UTC+03:00)."""
    return f"{due:%Y-%m-%d %H:%M} ({datetime.timezone(due.utcoffset())})"

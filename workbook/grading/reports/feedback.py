"""Feedback: the page for a student, with verdicts, hints and links to the theory.

It never has a solution.
"""

import re
from functools import cache
from html import escape
from pathlib import Path

from workbook.checks.contract.reporting import MARKS
from workbook.checks.contract.verdict import INVALID, MISSING, RIGHT, UNCHECKED, WRONG
from workbook.grading.course.assignment import BY_HAND
from workbook.grading.course.handing_out import due_text
from workbook.grading.course.ledger import KNOWN
from workbook.grading.pool.copying import is_copying
from workbook.grading.reports.mathml import with_formulas
from workbook.grading.reports.pages import count, page, points
from workbook.grading.sandbox import submitted_file
from workbook.notebooks import exercises
from workbook.numbering import read_number

#: An item of a statement, a paragraph that begins with its letter.
ITEM = re.compile(r"^([a-z])\) (\S.*(?:\n.+)*)", re.MULTILINE)
LEGEND = {
    RIGHT: "the property that was asked for holds",
    WRONG: "a property fails; the line says which",
    MISSING: "there is no answer",
    INVALID: "not of the kind asked for",
    UNCHECKED: "no check could judge it, which is not your fault: a lecturer will look at it",
}


def feedback(assignment, score, site="", objections=()):
    """Return the page as HTML.

    Parameters
    ----------
    assignment : Assignment
        The homework.
    score : StudentScore
        The student's.
    site : str
        Address of the student edition of the site; without it the theory is named, not linked.
    objections : list of Objection
        The student's.

    Returns
    -------
    str
        HTML.
    """
    waiting = (
        f", and {count(len(score.to_review), 'answer')} still to be looked at by a lecturer"
        if score.to_review
        else ""
    )
    parts = [f"<p>{points(score.points)} of {points(score.max_points)} points{waiting}.</p>"]
    parts += _terms(assignment, score)
    if score.aside:
        entries = "".join(
            f"<li><code>{escape(Path(entry.path).name)}</code>: {escape(entry.reason)}</li>"
            for entry in score.aside
        )
        look = "; your lecturer will look at it" if score.aside_needs_review else ""
        parts.append(f"<p>Something you handed in was left aside{look}:</p><ul>{entries}</ul>")
    parts += map(_objection, objections)
    for problem in dict.fromkeys(answer.problem for answer in score.answers):
        variant = assignment.variant(problem, score.student)
        about, answers = _about(variant, assignment), score.of_problem(problem)
        earned = f"{points(sum(a.points for a in answers))} / {points(sum(a.max_points for a in answers))}"
        parts.append(
            f'<h2><span>{escape(about["title"])}</span><span class="points">{earned}</span></h2>'
        )
        parts += _of_problem(problem, about, answers, score, assignment)
        if problem != BY_HAND:
            parts.append(f"<p>{_theory(problem, site)}</p>")
    legend = "".join(
        f'<li class="{status}">{_mark(status)}: {meaning}</li>'
        for status, meaning in LEGEND.items()
    )
    return page(
        assignment.title,
        score.student,
        f"{''.join(parts)}<h2>What the marks mean</h2><ul>{legend}</ul>",
    )


def hints(answer, about):
    """Return the hints of the notebook for an answer that is not right yet."""
    return (
        about["hints"].get(answer.answer, [])
        if answer.verdict.status in (WRONG, MISSING, INVALID)
        else []
    )


def _objection(objection):
    reply = (
        f'<p>The reply of your lecturer:</p><p class="typed">{escape(objection.reply)}</p>'
        if objection.reply
        else '<p class="soft">Your lecturer has not replied yet.</p>'
    )
    return (
        f'<section class="answer"><p>Your objection, noted {escape(objection.noted[:10])}:</p>'
        f'<p class="typed">{escape(objection.text)}</p>{reply}</section>'
    )


def _about(problem, assignment):
    """Return title, answers and hints of a problem, or of what is graded by hand."""
    if problem == BY_HAND:
        answers = {name: {"text": text} for name, text in assignment.by_hand.items()}
        return {"title": "Graded by your lecturer", "answers": answers, "hints": {}}
    about = exercises.find(problem).about
    return about | {"title": f"{problem} {about['title']}"}


def _of_problem(problem, about, answers, score, assignment):
    attempt = score.counted.get(problem)
    if problem != BY_HAND and attempt is None and all(answer.manual is None for answer in answers):
        return [
            "<p>No notebook for this problem was found beside what was left aside.</p>"
            if score.aside
            else "<p>Nothing was submitted for this problem.</p>"
        ]
    parts = []
    if attempt is not None and (timing := _timing(problem, attempt, assignment.policy, score)):
        parts.append(f"<p><em>{timing}</em></p>")
    if attempt is not None and score.attempt_counts[problem] > 1:
        parts.append(
            f'<p class="soft">You handed this in {score.attempt_counts[problem]} times; what follows is the '
            "attempt that counts.</p>"
        )
    if attempt is not None and (remarks := [r for r in attempt.remarks if not is_copying(r)]):
        parts.append(
            f'<ul class="soft">{"".join(f"<li>{escape(remark)}</li>" for remark in remarks)}</ul>'
        )
    items, shown = _items(assignment.variant(problem, score.student)), set()
    for answer in answers:
        letter = answer.answer.partition("_")[0]
        if letter in items and letter not in shown:
            shown.add(letter)
            parts.append(f"<p>{escape(letter)}) {items[letter]}</p>")
        parts.append(_answer(answer, about, hints(answer, about)))
    return parts


@cache
def _items(problem):
    """Return the items of a problem's statement as HTML, by letter."""
    if problem == BY_HAND:
        return {}
    statement, *_ = submitted_file.text_cells(exercises.find(problem).path.read_bytes())
    return {
        letter: with_formulas(text.rstrip(" ,;"))
        for letter, text in ITEM.findall(statement)
        if "$$" not in text
    }


def _description(name, about):
    """Return what an answer is as HTML; "the same for system b" with what that is the same as."""
    text, answers = about["answers"][name]["text"], about["answers"]
    described = with_formulas(text)
    if not text.startswith("the same") or "`" in text:
        return described
    kind = name.partition("_")[2]
    before = [
        other
        for other in list(answers)[: list(answers).index(name)]
        if not answers[other]["text"].startswith("the same")
    ]
    alike = [other for other in before if other.partition("_")[2] == kind]
    if not before:
        return described
    other = (alike or before)[-1]
    return f"{described} (<code>{escape(other)}</code>: {with_formulas(answers[other]['text'])})"


def _terms(assignment, score):
    """Say until when the homework was due for a student, and what was not asked."""
    parts, due = [], assignment.policy.due_of(score.student)
    if due:
        extended = (
            f", by an extension from {due_text(assignment.due)}" if due != assignment.due else ""
        )
        parts.append(f'<p class="soft">Due {due_text(due)}{extended}.</p>')
    if score.exempt:
        parts.append(
            f"<p>You are exempt from {escape(', '.join(score.exempt))}. Your other answers share its "
            "points, each in proportion to what it is worth.</p>"
        )
    return parts


def _timing(problem, attempt, policy, score):
    """Say what the time of an attempt does to its points."""
    if attempt.timing == KNOWN:
        return policy.explanation(score.student, attempt.submitted, score.grace_days)
    if problem in score.late:
        return "Handed in after the due date; it is not known when, so this costs nothing."
    if problem in score.untimed:
        bonus = ", and has no bonus" if policy.early else ""
        return f"It is not known when you handed this in, so it is not late{bonus}."
    return ""


def _answer(answer, about, hint_texts):
    name, verdict = answer.answer, answer.verdict
    earned = f"{points(answer.points)} / {points(answer.max_points)}"
    parts = [
        f"<header><span><code>{escape(name)}</code></span><span "
        f'class="points">{earned}</span></header>',
        f'<div class="soft">{_description(name, about)}</div>',
    ]
    if answer.text and verdict.status != MISSING:
        parts.append(f"<div>Your answer: <code>{escape(answer.text)}</code></div>")
    parts.append(f"<div>{_mark(verdict.status)}: {escape(verdict.message)}</div>")
    parts += [f"<div>{escape(line)}</div>" for line in verdict.mistake.splitlines()]
    if answer.manual is not None:
        parts.append(
            f"<div><em>Points given by your "
            f"lecturer{': ' + escape(answer.manual) if answer.manual else ''}</em></div>"
        )
    parts += [
        f"<details><summary>Hint {k}</summary>{with_formulas(hint)}</details>"
        for k, hint in enumerate(hint_texts, 1)
    ]
    return f'<section class="answer {verdict.status}">{"".join(parts)}</section>'


def _mark(status):
    return f'<span class="verdict">{MARKS[status]} {status}</span>'


def _theory(problem, site):
    chapter, home = read_number(problem).chapter, exercises.home_of(problem)
    page, site = home.theory(chapter), home.site or site
    if not site:
        return f"The theory stands in chapter {chapter} of the workbook." if page else ""
    base = escape(site.rstrip("/"), quote=True)
    theory = f'The theory: <a href="{base}/{page}">chapter {chapter}</a>. ' if page else ""
    statement = f"{base}/exercises/{read_number(problem).file('.html').as_posix()}"
    return f'{theory}The statement: <a href="{statement}">problem {escape(problem)}</a>.'

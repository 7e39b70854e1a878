"""Summary: the page for the lecturer on a whole class.

It has what needs review or could not be read, points, hardest answers, named mistakes, common
failures, and identical wrong answers.
"""

import re
import statistics
from collections import Counter, defaultdict
from html import escape

from workbook.checks.contract.verdict import MISSING, RIGHT, STATUSES, WRONG
from workbook.grading.course.assignment import BY_HAND
from workbook.grading.reports.other_numbers import right_for_others
from workbook.grading.reports.pages import answer_name, count, page, person, points, table

#: Bars of the histogram; most failures, pairs, and entries of a pair that are listed.
BARS, FAILURES, PAIRS, SHARED = 10, 10, 30, 8
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(\.\d*)?(e[-+]?\d+)?")


def summary(assignment, scores, objections=(), pairs=()):
    """Return the page as HTML, from scores, objections and what pairs share in the whole class."""
    handed_in = [score for score in scores if score.handed_in]
    parts = [_overview(assignment, scores, handed_in)]
    if any(score.to_review for score in scores):
        parts += ["<h2>To be looked at</h2>", _to_review(assignment, scores)]
    if objections:
        parts += ["<h2>Objections</h2>", _objections(objections)]
    if any(score.aside for score in scores):
        parts += ["<h2>Left aside</h2>", _aside(scores)]
    if any(score.unusable for score in scores):
        parts += ["<h2>Notebooks that could not be read or run</h2>", _unusable(scores)]
    if handed_in:
        parts += [
            "<h2>Points</h2>",
            _histogram(assignment, handed_in),
            "<h2>Answers, hardest first</h2>",
            _hardest(handed_in),
            "<h2>What to talk about: mistakes that have a name</h2>",
            _mistakes(handed_in),
            "<h2>Common failures</h2>",
            _failures(handed_in),
            "<h2>Identical wrong answers</h2>",
            _identical(handed_in),
            "<h2>What two students share and few others have</h2>",
            _pairs(pairs),
        ]
    if assignment.numbers is not None:
        parts += ["<h2>Right for other numbers</h2>", right_for_others(assignment, handed_in)]
    return page(assignment.title, "Summary", "".join(parts))


def _overview(assignment, scores, handed_in):
    sentences = [
        f"{len(handed_in)} of {count(len(scores), 'student')} handed something in",
        f"{sum(bool(s.late) for s in scores)} were late",
        f"{sum(s.needs_review for s in scores)} need a lecturer’s look",
    ]
    if untimed := sum(bool(s.untimed) for s in scores):
        sentences.insert(2, f"of {untimed} it is not known when")
    if handed_in:
        reached = [score.points for score in handed_in]
        sentences.append(
            f"the middle one has {points(statistics.median(reached))} of "
            f"{points(assignment.max_points)} points, the mean is "
            f"{points(statistics.mean(reached))}"
        )
    absent = [person(score.student) for score in scores if score.is_absent]
    return f"<p>{'; '.join(sentences)}.</p>" + (
        f"<p>Nothing was handed in by {', '.join(absent)}.</p>" if absent else ""
    )


def _to_review(assignment, scores):
    rows = [
        f"<tr><td>{person(score.student)}</td>{answer_name(answer.problem, answer.answer)}"
        f"<td>{f'<code>{escape(answer.text)}</code><br>' if answer.text else ''}"
        f"{escape(answer.verdict.message)}</td></tr>"
        for score in scores
        for answer in score.to_review
    ]
    command = f"workbook score STUDENT {escape(assignment.name)} PROBLEM ANSWER POINTS"
    return (
        "<p>These could not be judged and may still raise the grade. Give points with "
        f"<code>{command}</code>, then grade again.</p>"
        + table(("student", "answer", "what was given, and why it was not judged"), rows)
    )


def _objections(objections):
    rows = [
        f"<tr><td>{person(objection.student)}</td><td>{escape(objection.noted)}</td>"
        f'<td class="typed">{escape(objection.text)}</td>'
        f'<td class="typed">{escape(objection.reply) or "<em>no reply yet</em>"}</td></tr>'
        for objection in sorted(objections, key=lambda objection: bool(objection.reply))
    ]
    return (
        "<p>Write your reply to a student into <code>replies/STUDENT.md</code> beside this page, change "
        "points with <code>workbook score</code> where that is due, then grade again.</p>"
        + table(("student", "noted", "objection", "reply"), rows)
    )


def _aside(scores):
    by_reason = defaultdict(list)
    for score in scores:
        for entry in score.aside:
            by_reason[entry.reason].append((score.student, entry.path))
    rows = [
        f"<tr><td>{person(student)}</td><td><code>{escape(path)}</code></td><td>{escape(reason)}</td></tr>"
        for reason, works in sorted(by_reason.items(), key=lambda pair: -len(pair[1]))
        for student, path in works
    ]
    return (
        "<p>This may be work that is missing. Name it, or move it, as it should be, or take it "
        "away; then grade again. What is no notebook, or is damaged, is settled by points that you "
        "give by hand.</p>" + table(("student", "what", "why"), rows)
    )


def _unusable(scores):
    """List the newest notebooks that gave no answer at all, by their first remark."""
    by_remark = defaultdict(list)
    for score in scores:
        for problem, remarks in score.unusable.items():
            by_remark[NUMBER.sub("#", remarks[0])].append((score.student, problem, remarks[0]))
    rows = [
        f'<tr><td class="number">{len(works)}</td><td>{escape(works[0][2])}</td>'
        f"<td>{', '.join(f'{person(student)} ({escape(problem)})' for student, problem, _ in works)}</td></tr>"
        for works in sorted(by_remark.values(), key=len, reverse=True)
    ]
    return (
        "<p>What a student handed in last for a problem, without any answer that could be read. "
        "It earns nothing; ask for it again.</p>"
        + table(("times", "why, in the words of one of them", "students and problems"), rows)
    )


def _histogram(assignment, scores):
    if assignment.max_points == 0:
        return "<p>Nothing is worth a point.</p>"
    counts = Counter(
        min(int(BARS * score.points / assignment.max_points + 1e-9), BARS - 1) for score in scores
    )
    tallest, width, height, top = max(counts.values()), 60, 130, 26
    floor, end = height + top, BARS * width + 6
    elements = []
    for k in sorted(counts):
        tall = height * counts[k] / tallest
        elements.append(
            f'<rect x="{k * width + 6}" y="{floor - tall:.1f}" width="{width - 6}" '
            f'height="{tall:.1f}" '
            f'fill="var(--accent)"/>'
            f'<text x="{k * width + width / 2 + 3}" y="{floor - 5 - tall:.1f}" '
            f'text-anchor="middle">{counts[k]}</text>'
        )
    elements.append(
        f'<line x1="0" x2="{end}" y1="{floor + 0.5}" y2="{floor + 0.5}" stroke="var(--soft)"/>'
    )
    for k in range(0, BARS + 1, 2):
        anchor = "start" if k == 0 else "end" if k == BARS else "middle"
        elements.append(
            f'<text x="{k * width + 3}" y="{floor + 20}" '
            f'text-anchor="{anchor}">{points(assignment.max_points * k / BARS)}</text>'
        )
    elements.append(
        f'<text x="{end / 2}" y="{floor + 44}" text-anchor="middle">points; on each bar the number '
        "of students</text>"
    )
    spread = ", ".join(
        f"{counts[k]} from {points(assignment.max_points * k / BARS)}" for k in sorted(counts)
    )
    label = f"Number of students by points: {spread}"
    return f'<svg viewBox="0 0 {end} {floor + 50}" role="img" aria-label="{label}">{"".join(elements)}</svg>'


def _hardest(scores):
    statuses = defaultdict(Counter)
    for score in scores:
        for answer in score.answers:
            if answer.problem == BY_HAND:
                continue
            statuses[answer.problem, answer.answer][answer.verdict.status] += 1
    rows = []
    for (problem, name), counts in sorted(statuses.items(), key=lambda item: item[1][RIGHT]):
        parts = [(status, f"{counts[status]} {status}") for status in STATUSES if counts[status]]
        bar = "".join(
            f'<span class="{status}" style="flex: {counts[status]}" title="{text}"></span>'
            for status, text in parts
        )
        rows.append(
            f"<tr>{answer_name(problem, name)}<td "
            f'class="number">{counts[RIGHT] / len(scores):.0%}</td>'
            f'<td><div class="bar">{bar}</div><span '
            f'class="soft">{", ".join(text for _, text in parts)}</span></td></tr>'
        )
    return table(("answer", "right", "verdicts"), rows)


def _mistakes(scores):
    """List the named mistakes by how many students made them, and who."""
    by_mistake = defaultdict(list)
    for score in scores:
        for answer in score.answers:
            if answer.verdict.mistake:
                by_mistake[
                    answer.problem, answer.answer, answer.verdict.mistake.splitlines()[0]
                ].append(score.student)
    rows = [
        f'<tr><td class="number">{len(names)}</td>{answer_name(problem, name)}<td>{escape(mistake)}</td>'
        f"<td>{', '.join(map(person, names))}</td></tr>"
        for (problem, name, mistake), names in sorted(
            by_mistake.items(), key=lambda pair: -len(pair[1])
        )
    ]
    return table(("students", "answer", "what they were asked", "who"), rows)


def _failures(scores):
    """List the most common failed properties, regardless of the numbers in their messages."""
    counts, example = Counter(), {}
    for score in scores:
        for answer in score.answers:
            if answer.verdict.status not in (RIGHT, MISSING):
                failure = (
                    answer.problem,
                    answer.answer,
                    answer.verdict.status,
                    NUMBER.sub("#", answer.verdict.message),
                )
                counts[failure] += 1
                example.setdefault(failure, answer.verdict.message)
    rows = [
        f'<tr class="{failure[2]}"><td class="number">{times}</td>{answer_name(*failure[:2])}'
        f'<td><span class="verdict">{failure[2]}</span>: {escape(example[failure])}</td></tr>'
        for failure, times in counts.most_common(FAILURES)
    ]
    return table(("times", "answer", "what failed, in the words of one of them"), rows)


def _identical(scores):
    """List wrong answers that several students gave in the very same form.

    Whole answers are compared, of which the page may show only a part.
    """
    students, texts = defaultdict(list), {}
    for score in scores:
        for answer in score.answers:
            if answer.verdict.status == WRONG and answer.hash:
                students[answer.problem, answer.answer, answer.hash].append(score.student)
                texts[answer.hash] = answer.text
    shared = sorted(
        ((answer, names) for answer, names in students.items() if len(names) > 1),
        key=lambda pair: -len(pair[1]),
    )
    rows = [
        f'<tr><td class="number">{len(names)}</td>{answer_name(problem, name)}'
        f"<td><code>{escape(texts[answer_hash])}</code></td><td>{', '.join(map(person, names))}</td></tr>"
        for (problem, name, answer_hash), names in shared
    ]
    return table(("times", "answer", "given", "by"), rows)


def _pairs(pairs):
    """List what pairs share, with the number of students who have it."""
    rows = []
    for pair in pairs[:PAIRS]:
        entries = "".join(
            f"<li><code>{escape(name)}</code> ({students} students)</li>"
            for name, students in pair.shared[:SHARED]
        )
        more = len(pair.shared) - SHARED
        if more > 0:
            entries += f"<li>and {more} more</li>"
        rows.append(
            f"<tr><td>{' and '.join(map(person, pair.students))}</td>"
            f"<td>{len(pair.shared)} {pair.kind}</td>"
            f"<td><ul>{entries}</ul></td></tr>"
        )
    more = f"<p>{len(pairs) - PAIRS} more pairs share less.</p>" if len(pairs) > PAIRS else ""
    return (
        "<p>Whole notebooks, wrong answers in the same form, lines of code, and runs of three "
        "statements that are equal but for the names of variables (its first line is shown), as far "
        "as at most a twentieth of the class or three students have them. This decides nothing: a common source or "
        "the same thought looks alike.</p>"
        + table(("students", "share", "what, and how common"), rows)
        + more
    )

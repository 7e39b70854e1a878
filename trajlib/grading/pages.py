"""HTML pages that stand alone: feedback for a student, a summary for the lecturer. No script, nothing from elsewhere."""

import re
import statistics
from collections import Counter, defaultdict
from html import escape

from trajlib import exercises
from trajlib.checks.reporting import MARKS
from trajlib.checks.verdict import INVALID, MISSING, RIGHT, STATUSES, UNCHECKED, WRONG
from trajlib.grading.handing_out import spoken

#: The colours of the workbook's site; every pair of text and ground has a contrast of at least 4.5.
STYLE = """
:root { color-scheme: light dark; --ink: #1d2530; --soft: #55606e; --paper: #fff; --card: #fbfaf7; --line: #dcdfe4; --accent: #0b6b74;
  --right: #17683a; --wrong: #a3262c; --missing: #6a5a00; --invalid: #74379a; --unchecked: #0f5a86; }
@media (prefers-color-scheme: dark) { :root { --ink: #dce1e7; --soft: #9aa6b3; --paper: #13171c; --card: #191f26; --line: #313a45; --accent: #62c6cd;
  --right: #7fd6a0; --wrong: #ff9a94; --missing: #e5cf6b; --invalid: #d3a6f2; --unchecked: #8cc8f0; } }
* { box-sizing: border-box; }
body { font: 1rem/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 50rem; margin: 2rem auto; padding: 0 1rem;
  overflow-wrap: break-word; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0 0 .5rem; }
h2 { font-size: 1.15rem; margin: 2.2rem 0 .5rem; display: flex; gap: 1rem; justify-content: space-between; align-items: baseline; }
a { color: var(--accent); } p { margin: .4rem 0; } .soft { color: var(--soft); } .points { white-space: nowrap; font-weight: 600; }
code { font: .9em ui-monospace, Menlo, Consolas, monospace; overflow-wrap: anywhere; } .key code { overflow-wrap: normal; }
.answer { background: var(--card); border: 1px solid var(--line); border-left: .3rem solid var(--tone, var(--line)); border-radius: .3rem;
  padding: .5rem .8rem; margin: .5rem 0; }
.answer header { display: flex; flex-wrap: wrap; gap: 0 1rem; justify-content: space-between; align-items: baseline; }
.verdict { color: var(--tone); font-weight: 600; } details { margin: .2rem 0; } summary { color: var(--accent); cursor: pointer; }
.right { --tone: var(--right); } .wrong { --tone: var(--wrong); } .missing { --tone: var(--missing); }
.invalid { --tone: var(--invalid); } .unchecked { --tone: var(--unchecked); }
.wide { overflow-x: auto; } table { border-collapse: collapse; width: 100%; }
td, th { text-align: left; padding: .35rem .8rem .35rem 0; vertical-align: top; border-bottom: 1px solid var(--line); }
.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
svg { max-width: 100%; height: auto; display: block; } svg text { fill: var(--ink); font-size: 12px; }
@media (max-width: 30rem) { svg text { font-size: 21px; } }
.bar { display: flex; min-width: 7rem; height: .8rem; margin-top: .35rem; border-radius: .2rem; overflow: hidden; }
.bar span { background: var(--tone); } ul { padding-left: 1.2rem; margin: .4rem 0; }
@media print { body { margin: 0; max-width: none; } .answer { break-inside: avoid; } }
"""

LEGEND = {RIGHT: "the property that was asked for holds", WRONG: "a property fails; the line says which",
          MISSING: "there is no answer", INVALID: "not of the kind asked for",
          UNCHECKED: "our check failed, not you: a lecturer will look at it"}

# The student's page


def feedback(assignment, score, site=""):
    """A student's page: each answer, what held and what did not, the next hint, a link to the theory; never a solution.

    `site` is the address of the student edition of the workbook's site; without it the theory is named, not linked.
    """
    parts = [f"<p>{_points(score.points)} of {_points(score.max_points)} points"
             + (f", and {_count(len(score.to_review), 'answer')} still to be looked at by a lecturer" if score.needs_review else "") + ".</p>"]
    if assignment.due:
        parts.append(f'<p class="soft">Due {spoken(assignment.due)}.</p>')
    for problem in assignment.problems:
        about, mine = exercises.find(problem).about, score.of_problem(problem)
        earned, worth = sum(answer.points for answer in mine), sum(answer.max_points for answer in mine)
        parts.append(f'<h2><span>{escape(problem)} {escape(about["title"])}</span><span class="points">{_points(earned)} / {_points(worth)}</span></h2>')
        parts += _of_problem(problem, about, mine, score)
        parts.append(f"<p>{_theory(problem, site)}</p>")
    legend = "".join(f'<li class="{status}"><span class="verdict">{MARKS[status]} {status}</span>: {said}</li>' for status, said in LEGEND.items())
    return _page(assignment.title, score.student, f'{"".join(parts)}<h2>What the marks mean</h2><ul>{legend}</ul>')


def open_hints(answer, about, tried):
    """The hints of an answer that are open to the student: each further attempt opens one more."""
    return about["hints"].get(answer.answer, [])[:tried] if answer.verdict.status in (WRONG, MISSING, INVALID) else []


def _of_problem(problem, about, answers, score):
    attempt = score.counted.get(problem)
    if attempt is None and all(answer.manual is None for answer in answers):
        return ["<p>Nothing was submitted for this problem.</p>"]
    parts = []
    if problem in score.late:
        parts.append("<p><em>Handed in after the due date.</em></p>")
    if attempt is not None and score.tried[problem] > 1:
        parts.append(f'<p class="soft">You handed this in {score.tried[problem]} times; what follows is the attempt that counts.</p>')
    if attempt is not None and attempt.remarks:
        parts.append(f'<ul class="soft">{"".join(f"<li>{escape(remark)}</li>" for remark in attempt.remarks)}</ul>')
    return parts + [_answer(answer, about, open_hints(answer, about, score.tried[problem])) for answer in answers]


def _answer(answer, about, hints):
    name, verdict = answer.answer, answer.verdict
    parts = [f'<header><span><code>{escape(name)}</code></span><span class="points">{_points(answer.points)} / {_points(answer.max_points)}</span></header>',
             f'<div class="soft">{escape(about["answers"][name]["text"])}</div>']
    if answer.text and verdict.status != MISSING:
        parts.append(f"<div>Your answer: <code>{escape(answer.text)}</code></div>")
    parts.append(f'<div><span class="verdict">{MARKS[verdict.status]} {verdict.status}</span>: {escape(verdict.message)}</div>')
    if answer.manual is not None:
        parts.append(f"<div><em>Points given by your lecturer{': ' + escape(answer.manual) if answer.manual else ''}.</em></div>")
    parts += [f"<details><summary>Hint {k}</summary>{escape(hint)}</details>" for k, hint in enumerate(hints, start=1)]
    return f'<section class="answer {verdict.status}">{"".join(parts)}</section>'


def _theory(problem, site):
    chapter, number = problem.split(".")
    if not site:
        return f"The theory stands in chapter {chapter} of the workbook."
    base = escape(site.rstrip("/"), quote=True)
    return (f'The theory: <a href="{base}/book/ch{chapter}.html">chapter {chapter}</a>. '
            f'The statement: <a href="{base}/exercises/ch{chapter}/p{number:0>2}.html">problem {escape(problem)}</a>.')


# The lecturer's page


def summary(assignment, scores):
    """The lecturer's page: distribution of points, hardest answers, common failures, identical wrong answers."""
    handed_in = [score for score in scores if score.handed_in]
    parts = [_in_short(assignment, scores, handed_in)]
    if any(score.needs_review for score in scores):
        parts += ["<h2>To be looked at</h2>", _to_review(assignment, scores)]
    if handed_in:
        parts += ["<h2>Points</h2>", _histogram(assignment, handed_in), "<h2>Answers, hardest first</h2>", _hardest(handed_in),
                  "<h2>Common failures</h2>", _failures(handed_in), "<h2>Identical wrong answers</h2>", _identical(handed_in)]
    return _page(assignment.title, "Summary", "".join(parts))


def _in_short(assignment, scores, handed_in):
    said = [f"{len(handed_in)} of {_count(len(scores), 'student')} handed something in", f"{sum(bool(s.late) for s in scores)} were late",
            f"{sum(s.needs_review for s in scores)} need a lecturer’s look"]
    if handed_in:
        points = [score.points for score in handed_in]
        said.append(f"the middle one has {_points(statistics.median(points))} of {_points(assignment.max_points)} points, the mean is {_points(statistics.mean(points))}")
    return f"<p>{'; '.join(said)}.</p>"


def _to_review(assignment, scores):
    rows = [f'<tr><td>{_person(score.student)}</td><td class="key">{escape(answer.problem)} <code>{escape(answer.answer)}</code></td>'
            f"<td>{f'<code>{escape(answer.text)}</code><br>' if answer.text else ''}{escape(answer.verdict.message)}</td></tr>"
            for score in scores for answer in score.to_review]
    return (f"<p>These could not be judged and may still raise the grade. Give points with <code>trajlib score STUDENT {escape(assignment.name)} "
            f"PROBLEM ANSWER POINTS</code>, then grade again.</p>{_table(('student', 'answer', 'what was given, and why it was not judged'), rows)}")


def _histogram(assignment, scores, bars=10):
    if assignment.max_points == 0:
        return "<p>Nothing is worth a point.</p>"
    counts = Counter(min(int(bars * score.points / assignment.max_points + 1e-9), bars - 1) for score in scores)
    tallest, width, height, top = max(counts.values()), 60, 130, 26
    drawn = []
    for k in sorted(counts):
        tall = height * counts[k] / tallest
        drawn.append(f'<rect x="{k * width + 6}" y="{height + top - tall:.1f}" width="{width - 6}" height="{tall:.1f}" fill="var(--accent)"/>'
                     f'<text x="{k * width + width / 2 + 3}" y="{height + top - 5 - tall:.1f}" text-anchor="middle">{counts[k]}</text>')
    marks = "".join(f'<text x="{k * width + 3}" y="{height + top + 20}" text-anchor="{"end" if k == bars else "middle" if k else "start"}">'
                    f"{_points(assignment.max_points * k / bars)}</text>" for k in range(0, bars + 1, 2))
    ground = f'<line x1="0" x2="{bars * width + 6}" y1="{height + top + .5}" y2="{height + top + .5}" stroke="var(--soft)"/>'
    spread = ", ".join(f"{counts[k]} from {_points(assignment.max_points * k / bars)}" for k in sorted(counts))
    return (f'<svg viewBox="0 0 {bars * width + 6} {height + top + 50}" role="img" aria-label="Number of students by points: {spread}">{"".join(drawn)}{ground}{marks}'
            f'<text x="{bars * width / 2}" y="{height + top + 44}" text-anchor="middle">points; on each bar the number of students</text></svg>')


def _hardest(scores):
    statuses = defaultdict(Counter)
    for score in scores:
        for answer in score.answers:
            statuses[answer.problem, answer.answer][answer.verdict.status] += 1
    rows = []
    for (problem, name), counts in sorted(statuses.items(), key=lambda item: item[1][RIGHT]):
        bar = "".join(f'<span class="{status}" style="flex: {counts[status]}" title="{counts[status]} {status}"></span>' for status in STATUSES if counts[status])
        told = ", ".join(f"{counts[status]} {status}" for status in STATUSES if counts[status])
        rows.append(f'<tr><td class="key">{escape(problem)} <code>{escape(name)}</code></td><td class="number">{counts[RIGHT] / len(scores):.0%}</td>'
                    f'<td><div class="bar">{bar}</div><span class="soft">{told}</span></td></tr>')
    return _table(("answer", "right", "verdicts"), rows)


def _failures(scores, most=10):
    """Failed properties, told apart without the numbers of the sample at which they failed."""
    told, example = Counter(), {}
    for score in scores:
        for answer in score.answers:
            if answer.verdict.status not in (RIGHT, MISSING):
                key = answer.problem, answer.answer, answer.verdict.status, re.sub(r"(?<![\w.])[-+]?\d+(\.\d*)?(e[-+]?\d+)?", "#", answer.verdict.message)
                told[key] += 1
                example.setdefault(key, answer.verdict.message)
    rows = [f'<tr class="{key[2]}"><td class="number">{count}</td><td class="key">{escape(key[0])} <code>{escape(key[1])}</code></td>'
            f'<td><span class="verdict">{key[2]}</span>: {escape(example[key])}</td></tr>' for key, count in told.most_common(most)]
    return _table(("times", "answer", "what failed, in the words of one of them"), rows)


def _identical(scores):
    """Wrong answers that several students gave in the very same form: a common misconception, or copied work."""
    givers = defaultdict(list)
    for score in scores:
        for answer in score.answers:
            if answer.verdict.status == WRONG and answer.text:
                givers[answer.problem, answer.answer, answer.text].append(score.student)
    shared = sorted(((key, names) for key, names in givers.items() if len(names) > 1), key=lambda pair: -len(pair[1]))
    rows = [f'<tr><td class="number">{len(names)}</td><td class="key">{escape(problem)} <code>{escape(name)}</code></td><td><code>{escape(text)}</code></td>'
            f"<td>{', '.join(map(_person, names))}</td></tr>" for (problem, name, text), names in shared]
    return _table(("times", "answer", "given", "by"), rows)


# Both


def _table(header, rows):
    if not rows:
        return "<p>None.</p>"
    return f'<div class="wide"><table><tr>{"".join(f"<th>{name}</th>" for name in header)}</tr>{"".join(rows)}</table></div>'


def _person(name):
    # Apart from the text around it, whichever way the name is written.
    return f"<bdi>{escape(name)}</bdi>"


def _page(title, whose, body):
    return ('<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
            '<meta http-equiv="Content-Security-Policy" content="default-src \'none\'; style-src \'unsafe-inline\'">'
            f"<title>{escape(title)}: {escape(whose)}</title><style>{STYLE}</style></head>"
            f'<body><h1>{escape(title)}<br><span class="soft">{_person(whose)}</span></h1>{body}</body></html>\n')


def _points(value):
    return f"{value:.2f}".rstrip("0").rstrip(".")


def _count(number, thing):
    return f"{number} {thing}{'s' * (number != 1)}"

"""HTML pages that stand alone: feedback for a student, a summary for the lecturer. No script, nothing from elsewhere."""

from collections import Counter, defaultdict
from html import escape

from trajlib import exercises
from trajlib.checks.reporting import MARKS
from trajlib.checks.verdict import MISSING, RIGHT, WRONG

STYLE = """
:root { color-scheme: light dark; }
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 46rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
table { border-collapse: collapse; width: 100%; } td, th { text-align: left; padding: .3rem .6rem .3rem 0; vertical-align: top; border-bottom: 1px solid #8884; }
.number { text-align: right; white-space: nowrap; } .mark { font-weight: bold; } .soft { opacity: .75; }
.wide { overflow-x: auto; } svg { max-width: 100%; height: auto; }
details { margin: .2rem 0; } code { overflow-wrap: anywhere; }
"""


def feedback(assignment, score, site=""):
    """A student's page: each answer, what held and what did not, the next hint, a link to the theory; never a solution.

    `site` is the address of the workbook's site; without it the theory is named, not linked.
    """
    parts = [f"<p>{_points(score.points)} of {_points(score.max_points)} points"
             + (", some answers still to be looked at by a lecturer" if score.needs_review else "") + ".</p>"]
    for problem in assignment.problems:
        about = exercises.find(problem).about
        parts.append(f"<h2>{escape(problem)} {escape(about['title'])}</h2>")
        if problem in score.late:
            parts.append("<p><em>Handed in after the due date.</em></p>")
        parts += [f'<p class="soft">{escape(remark)}</p>' for remark in score.remarks.get(problem, ())]
        rows = [_answer_row(answer, about, score.tried.get(problem, 0)) for answer in score.answers if answer.problem == problem]
        parts.append(f'<div class="wide"><table>{"".join(rows)}</table></div>')
        parts.append(f"<p>{_theory(problem, site)}</p>")
    return _page(f"{assignment.title}: {score.student}", "".join(parts))


def summary(assignment, scores):
    """The lecturer's page: distribution of points, hardest answers, common failures, identical wrong answers."""
    handed_in = [score for score in scores if any(score.tried.values())]
    parts = [f"<p>{len(handed_in)} of {len(scores)} students handed something in; {sum(s.needs_review for s in scores)} need a lecturer's look; "
             f"{sum(bool(s.late) for s in scores)} were late.</p>", "<h2>Points</h2>", _histogram(assignment, handed_in),
             "<h2>Answers, hardest first</h2>", _hardest(assignment, handed_in), "<h2>Common failures</h2>", _failures(handed_in),
             "<h2>Identical wrong answers</h2>", _identical(handed_in)]
    return _page(f"{assignment.title}: summary", "".join(parts))


def _answer_row(answer, about, tried):
    name, verdict = answer.answer, answer.verdict
    hints = about["hints"].get(name, [])
    # Each further attempt opens one more hint.
    shown = hints[:tried] if verdict.status in (WRONG, MISSING) and hints else []
    folded = "".join(f"<details><summary>Hint {k}</summary>{escape(hint)}</details>" for k, hint in enumerate(shown, start=1))
    by_hand = f"<br><em>Lecturer: {escape(answer.manual) or 'points given by hand'}</em>" if answer.manual is not None else ""
    given = f"<br>Your answer: <code>{escape(answer.text)}</code>" if answer.text and verdict.status != MISSING else ""
    return (f'<tr><td class="mark">{MARKS[verdict.status]}</td><td><code>{escape(name)}</code> '
            f'<span class="soft">{escape(about["answers"][name]["text"])}</span>{given}<br>{verdict.status}: {escape(verdict.message)}{by_hand}{folded}</td>'
            f'<td class="number">{_points(answer.points)} / {_points(answer.max_points)}</td></tr>')


def _theory(problem, site):
    chapter = problem.split(".")[0]
    if not site:
        return f"The theory stands in chapter {chapter} of the workbook."
    return f'The theory: <a href="{escape(site.rstrip("/"), quote=True)}/book/ch{chapter}.html">chapter {chapter}</a>.'


def _histogram(assignment, scores, bars=10):
    if not scores or assignment.max_points == 0:
        return "<p>No submissions.</p>"
    counts = Counter(min(int(bars * score.points / assignment.max_points), bars - 1) for score in scores)
    tallest, width, height = max(counts.values()), 44, 120
    drawn = []
    for k in range(bars):
        tall = height * counts[k] / tallest
        label = f"{_points(assignment.max_points * k / bars)}"
        drawn.append(f'<rect x="{k * width + 4}" y="{height + 16 - tall:.1f}" width="{width - 8}" height="{tall:.1f}" fill="currentColor" opacity=".55"/>'
                     f'<text x="{(k + .5) * width}" y="{height + 12 - tall:.1f}" text-anchor="middle" font-size="11" fill="currentColor">{counts[k] or ""}</text>'
                     f'<text x="{k * width}" y="{height + 32}" font-size="11" fill="currentColor">{label}</text>')
    end = f'<text x="{bars * width}" y="{height + 32}" text-anchor="end" font-size="11" fill="currentColor">{_points(assignment.max_points)} points</text>'
    return (f'<svg viewBox="0 0 {bars * width} {height + 40}" role="img" aria-label="Number of students by points">'
            f'{"".join(drawn)}{end}</svg>')


def _hardest(assignment, scores):
    right, statuses = Counter(), defaultdict(Counter)
    for score in scores:
        for answer in score.answers:
            right[answer.problem, answer.answer] += answer.verdict.status == RIGHT
            statuses[answer.problem, answer.answer][answer.verdict.status] += 1
    rows = [f'<tr><td>{escape(problem)} <code>{escape(name)}</code></td><td class="number">{right[problem, name] / len(scores):.0%} right</td>'
            f'<td>{", ".join(f"{count} {status}" for status, count in statuses[problem, name].most_common())}</td></tr>'
            for problem, name in sorted(right, key=lambda key: right[key])]
    return f'<div class="wide"><table>{"".join(rows)}</table></div>'


def _failures(scores, most=10):
    """Failed properties, told apart without the numbers of the sample at which they failed."""
    told = Counter()
    example = {}
    for score in scores:
        for answer in score.answers:
            if answer.verdict.status not in (RIGHT, MISSING):
                key = (answer.problem, answer.answer, answer.verdict.status, "".join("#" if c.isdigit() else c for c in answer.verdict.message))
                told[key] += 1
                example.setdefault(key, answer.verdict.message)
    rows = [f'<tr><td class="number">{count}</td><td>{escape(key[0])} <code>{escape(key[1])}</code> {key[2]}: {escape(example[key])}</td></tr>'
            for key, count in told.most_common(most)]
    return f'<div class="wide"><table>{"".join(rows)}</table></div>' if rows else "<p>None.</p>"


def _identical(scores):
    """Wrong answers that several students gave in the very same form: a common misconception, or copied work."""
    givers = defaultdict(list)
    for score in scores:
        for answer in score.answers:
            if answer.verdict.status == WRONG and answer.text:
                givers[answer.problem, answer.answer, answer.text].append(score.student)
    shared = sorted(((key, names) for key, names in givers.items() if len(names) > 1), key=lambda pair: -len(pair[1]))
    rows = [f"<tr><td>{escape(problem)} <code>{escape(name)}</code></td><td><code>{escape(text)}</code></td><td>{escape(', '.join(names))}</td></tr>"
            for (problem, name, text), names in shared]
    return f'<div class="wide"><table>{"".join(rows)}</table></div>' if rows else "<p>None.</p>"


def _page(title, body):
    return (f'<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<title>{escape(title)}</title><style>{STYLE}</style></head><body><h1>{escape(title)}</h1>{body}</body></html>\n")


def _points(value):
    return f"{value:g}" if value == round(value, 2) else f"{value:.2f}"

"""Page for points by hand: each student's text cells beside fields for points.

Its button saves the table that `workbook score --import` reads. Nothing leaves the machine.
"""

import json
from html import escape

from workbook.grading.reports.mathml import with_formulas
from workbook.grading.reports.pages import page, person, points
from workbook.grading.reports.points_by_hand import HEADER

#: Cells are quoted as CSV; an apostrophe keeps a spreadsheet from running one as a formula.
SCRIPT = """
document.querySelector("button").addEventListener("click", () => {
  const formula = /^[=@\\t\\r\\n]|^[+-](?!\\d*$)/;
  const cell = text => '"' + (formula.test(text) ? "'" + text : text).replaceAll('"', '""') + '"';
  const rows = [...document.querySelectorAll("fieldset")].map(item => [
    ...JSON.parse(item.dataset.key), item.dataset.max,
    ...[...item.querySelectorAll("input")].map(input => input.value), "", ""]);
  const lines = [HEADER, ...rows].map(row => row.map(cell).join(","));
  const link = document.createElement("a");
  link.href = "data:text/csv;charset=utf-8," + encodeURIComponent("\\ufeff" + lines.join("\\r\\n") + "\\r\\n");
  link.download = "points.csv";
  link.click();
});
"""


def text_page(assignment, scores, texts):
    """Return the page as HTML.

    Parameters
    ----------
    assignment : Assignment
        The homework.
    scores : list of StudentScore
        The scores of the class.
    texts : dict
        {student: [(file, texts)]}, as of `text_cells.read`.

    Returns
    -------
    str
        HTML.
    """
    parts = [
        "<p>Fill in points, press the button, then run <code>workbook score --import points.csv</code> "
        "and <code>workbook grade</code>. A field left empty changes nothing. The text stands as it was "
        "typed.</p><p><button>Save points.csv</button></p>"
    ]
    for score in scores:
        if not score.handed_in:
            continue
        items = [
            answer
            for answer in score.answers
            if answer.answer in assignment.by_hand or answer in score.to_review
        ]
        parts.append(f"<h2>{person(score.student)}</h2>")
        for file, cells in texts.get(score.student, ()):
            parts.append(f'<p class="soft"><code>{escape(file)}</code></p>')
            parts += [f'<pre class="answer">{escape(cell)}</pre>' for cell in cells]
        if score.student not in texts:
            parts.append('<p class="soft">No text beside what was handed out.</p>')
        for answer in items:
            key = escape(
                json.dumps([assignment.name, score.student, answer.problem, answer.answer]),
                quote=True,
            )
            parts.append(_fields(answer, key, assignment.by_hand.get(answer.answer, "")))
    return page(
        assignment.title,
        "Points by hand",
        "".join(parts),
        SCRIPT.replace("HEADER", json.dumps(HEADER)),
    )


def _fields(answer, key, text):
    """Return the fields of an answer, under what it is."""
    name = f"{escape(answer.problem)} {escape(answer.answer)}"
    value = "" if answer.by_hand is None else f"{answer.by_hand:g}"
    return (
        f'<fieldset data-key="{key}" data-max="{answer.max_points:g}"><legend>{name}</legend>'
        f'<p class="soft">{with_formulas(text)}</p>'
        f'<label>Points, up to {points(answer.max_points)}: <input type="number" min="0" step="any" '
        f'max="{answer.max_points:g}" value="{value}"></label> '
        f'<label>Comment: <input size="50" value="{escape(answer.manual or "", quote=True)}"></label>'
        "</fieldset>"
    )

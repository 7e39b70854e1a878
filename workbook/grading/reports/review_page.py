"""Page for points by hand in the browser, one for each question: all students' answers to it.

What a student wrote is text on it, never HTML. `review` serves it and stores the points.
"""

import json
from dataclasses import dataclass
from html import escape

from workbook.grading.course.assignment import BY_HAND
from workbook.grading.reports.mathml import with_formulas
from workbook.grading.reports.pages import STYLE, page, person, points

#: The style of all pages, and of the fields and buttons here.
REVIEW_STYLE = """
body { max-width: 60rem; } h2 > * { min-width: 0; overflow-wrap: anywhere; }
section h2 { margin-top: .2rem; } section:focus { outline: .2rem solid var(--accent); outline-offset: .2rem; }
section.given { border-left-color: var(--right); } pre { margin: .4rem 0; max-height: 40vh; overflow: auto; }
form { display: flex; flex-wrap: wrap; gap: .5rem 1rem; align-items: center; margin-top: .6rem; }
form label { display: flex; gap: .4rem; align-items: center; } form .comment { flex: 1 1 16rem; }
input { font: inherit; color: inherit; background: var(--paper); border: 1px solid var(--soft); border-radius: .3rem;
  padding: .25rem .4rem; min-width: 0; } input[name=comment] { width: 100%; } input[name=points] { width: 6rem; }
button { font: inherit; color: var(--paper); background: var(--accent); border: 0; border-radius: .3rem;
  padding: .3rem .8rem; cursor: pointer; } .earlier { margin: .3rem 0; padding: 0; list-style: none; }
.earlier button { color: var(--accent); background: none; text-align: left; padding: .1rem .2rem; }
nav { display: flex; flex-wrap: wrap; gap: .3rem 1.2rem; } [role=status].error { color: var(--wrong); }
kbd { border: 1px solid var(--line); border-radius: .2rem; padding: 0 .3rem; font: inherit; }
"""

SCRIPT = """
const items = [...document.querySelectorAll("section.answer")];
const field = (item, name) => item.querySelector(`input[name=${name}]`);
const comments = JSON.parse(document.querySelector("main").dataset.comments);
let current = 0;

function show(k) {
  if (!items.length) return;
  current = Math.max(0, Math.min(items.length - 1, k));
  items[current].focus();
  items[current].scrollIntoView({block: "nearest"});
  const list = items[current].querySelector(".earlier");
  document.querySelectorAll(".earlier").forEach(other => other.replaceChildren());
  comments.slice(0, 9).forEach((text, n) => {
    const entry = document.createElement("li"), button = document.createElement("button");
    const key = document.createElement("kbd");
    key.textContent = n + 1;
    button.type = "button";
    button.append(key, " " + text);
    button.addEventListener("click", () => reuse(text));
    entry.append(button);
    list.append(entry);
  });
}

function reuse(text) {
  const input = field(items[current], "comment");
  input.value = input.value && input.value !== text ? input.value + "; " + text : text;
  input.focus();
}

async function save(k) {
  const item = items[k], status = item.querySelector("[role=status]");
  const number = field(item, "points").value.trim(), comment = field(item, "comment").value.trim();
  const value = Number(number.replace(",", ".")), given = number === "" ? null : Number.isNaN(value) ? number : value;
  status.textContent = "saving";
  status.className = "";
  try {
    const reply = await fetch("points", {method: "POST", headers: {"Content-Type": "application/json"},
      body: JSON.stringify({key: JSON.parse(item.dataset.key), points: given, comment})});
    const {message, error} = await reply.json();
    if (error) throw new Error(error);
    status.textContent = "saved: " + message;
    item.classList.toggle("given", given !== null);
    if (given !== null && comment && !comments.includes(comment)) comments.unshift(comment);
    document.querySelector("#given").textContent = document.querySelectorAll("section.given").length;
    return true;
  } catch (error) {
    status.textContent = "not saved: " + error.message;
    status.className = "error";
    return false;
  }
}

items.forEach((item, k) => {
  item.addEventListener("focusin", event => {
    if (current !== k) { show(k); event.target.focus(); }
  });
  item.querySelector("form").addEventListener("submit", async event => {
    event.preventDefault();
    if (await save(k)) show(k + 1);
  });
});
const keys = {
  j: () => show(current + 1), k: () => show(current - 1),
  p: () => field(items[current], "points").select(), c: () => field(items[current], "comment").focus(),
  f: () => { field(items[current], "points").value = items[current].dataset.max; },
  z: () => { field(items[current], "points").value = 0; },
  s: () => save(current).then(done => { if (done) show(current + 1); }),
};
document.addEventListener("keydown", event => {
  if (!items.length || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.target.tagName === "INPUT") {
    if (event.key === "Escape") items[current].focus();
    return;
  }
  const reused = comments[Number(event.key) - 1];
  const act = keys[event.key] || (/^[1-9]$/.test(event.key) && reused ? () => reuse(reused) : null);
  if (act) { event.preventDefault(); act(); }
});
show(Math.max(0, items.findIndex(item => !item.classList.contains("given"))));
"""
KEYS = (
    ("j", "next student"),
    ("k", "previous student"),
    ("p", "points"),
    ("c", "comment"),
    ("f", "all points"),
    ("z", "no points"),
    ("1 to 9", "an earlier comment"),
    ("s", "save"),
    ("Enter", "in a field: save, then the next student"),
    ("Escape", "leave a field"),
)


@dataclass(frozen=True)
class Answer:
    """A student's answer to a question.

    Parameters
    ----------
    student : str
        Whose.
    max_points : float
        What it is worth.
    text : str
        The answer as short text, "" if there is none.
    reason : str
        Why no check has judged it.
    texts : tuple of (str, list of str)
        Files and the student's own text cells in them.
    """

    student: str
    max_points: float
    text: str
    reason: str
    texts: tuple = ()


@dataclass(frozen=True)
class Question:
    """A question that waits for points by hand: of which homework, what it is, and the answers."""

    assignment: str
    title: str
    problem: str
    name: str
    description: str
    answers: tuple

    def key(self, student):
        """Return (student, assignment, problem, answer), as in the store."""
        return student, self.assignment, self.problem, self.name


def questions(assignment, scores, texts):
    """Return the `Question` of each answer that waits for points by hand, or has some.

    Parameters
    ----------
    assignment : Assignment
        The homework.
    scores : list of StudentScore
        The scores of the class.
    texts : dict
        {student: [(file, texts)]}, as of `text_cells.read`.
    """
    answers = {}
    for score in scores:
        if not score.handed_in:
            continue
        waiting = {answer.answer: answer for answer in score.to_review}
        for answer in score.answers:
            answer = waiting.get(answer.answer, answer)
            by_hand = answer.problem == BY_HAND
            if by_hand or answer.answer in waiting or answer.manual is not None:
                own = tuple(texts.get(score.student, ())) if by_hand else ()
                answers.setdefault((answer.problem, answer.answer), []).append(
                    Answer(
                        score.student,
                        answer.max_points,
                        answer.text,
                        answer.verdict.message,
                        own,
                    )
                )
    return [
        Question(
            assignment.name,
            assignment.title,
            problem,
            name,
            assignment.by_hand.get(name, "")
            if problem == BY_HAND
            else assignment.exercise(problem).about["answers"][name]["text"],
            tuple(of_class),
        )
        for problem, names in assignment.points.items()
        for name in names
        if (of_class := answers.get((problem, name)))
    ]


def index_page(all_questions, given):
    """Return the page that lists the questions; `given` are all `HandPoints` by key."""
    entries = "".join(
        f'<li><a href="{k}">{escape(question.title)}: {_label(question)}</a> '
        f'<span class="soft">{_given(question, given)} of {len(question.answers)} have points</span></li>'
        for k, question in enumerate(all_questions)
    )
    body = f"<ul>{entries}</ul>" if entries else "<p>Nothing waits for points by hand.</p>"
    ending = (
        '<p class="soft">Points are stored at once. Ctrl-C in the terminal ends this page and writes '
        "the tables.</p>"
    )
    return page("Points by hand", "Questions", body + ending, style=STYLE + REVIEW_STYLE)


def question_page(all_questions, number, given):
    """Return the page of one question."""
    question = all_questions[number]
    links = ['<a href=".">All questions</a>']
    for other, name in ((number - 1, "Previous question"), (number + 1, "Next question")):
        if 0 <= other < len(all_questions):
            links.append(f'<a href="{other}">{name}</a>')
    comments = [
        entry.comment
        for key, entry in given.items()
        if key[1:] == question.key("")[1:] and entry.comment
    ]
    data = escape(json.dumps(list(dict.fromkeys(comments))), quote=True)
    keys = "".join(f"<li><kbd>{key}</kbd> {what}</li>" for key, what in KEYS)
    answers = "".join(
        _answer(question, answer, given.get(question.key(answer.student)))
        for answer in question.answers
    )
    body = (
        f"<nav>{' '.join(links)}</nav><p>{with_formulas(question.description)}</p>"
        f'<p class="soft"><span id="given">{_given(question, given)}</span> of '
        f"{len(question.answers)} have points.</p>"
        f"<details><summary>Keys</summary><ul>{keys}</ul></details>"
        f'<main data-comments="{data}">{answers}</main>'
    )
    label = f"{question.problem} {question.name}" if question.problem != BY_HAND else question.name
    return page(question.title, label, body, SCRIPT, connects=True, style=STYLE + REVIEW_STYLE)


def _label(question):
    problem = "" if question.problem == BY_HAND else f"{escape(question.problem)} "
    return f"{problem}<code>{escape(question.name)}</code>"


def _given(question, given):
    return sum(question.key(answer.student) in given for answer in question.answers)


def _answer(question, answer, given):
    """Return one student's answer with fields for points."""
    key = escape(json.dumps(question.key(answer.student)), quote=True)
    worth = f"{answer.max_points:g}"
    parts = [f"<h2>{person(answer.student)}</h2>"]
    for file, cells in answer.texts:
        parts.append(f'<p class="soft"><code>{escape(file)}</code></p>')
        parts += [f'<pre tabindex="0">{escape(cell)}</pre>' for cell in cells]
    if question.problem == BY_HAND and not answer.texts:
        parts.append('<p class="soft">No text beside what was handed out.</p>')
    if answer.text:
        parts.append(f"<p><code>{escape(answer.text)}</code></p>")
    if question.problem != BY_HAND:
        parts.append(f'<p class="soft">{escape(answer.reason)}</p>')
    value, comment, by = (f"{given.points:g}", given.comment, given.by) if given else ("", "", "")
    by = f'<p class="soft">Points by {escape(by)}.</p>' if by else ""
    return (
        f'<section class="answer{" given" if given else ""}" tabindex="-1" data-key="{key}" '
        f'data-max="{worth}">{"".join(parts)}{by}<form><label>Points, up to '
        f'{points(answer.max_points)}: <input name="points" inputmode="decimal" autocomplete="off" '
        f'value="{value}"></label><label class="comment">Comment: <input name="comment" '
        f'autocomplete="off" maxlength="5000" value="{escape(comment, quote=True)}"></label>'
        '<button>Save</button><span role="status"></span></form><ul class="earlier"></ul></section>'
    )

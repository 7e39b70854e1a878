"""Folds after each check cell of a solved problem: wrong answers that students give.

Each shows the answer as typed, the verdict of its check and the question to ask oneself, from the
files that `book/judge_trials.py` writes. Only the edition with solutions has them.
"""

import json
from pathlib import Path

from docutils import nodes

from trajlib.typesetting import plain, typeset
from workbook.checks.contract.reporting import as_html
from workbook.checks.contract.verdict import WRONG, Verdict
from workbook.site import catalogue
from workbook.site.folding import details, summary

FOLDER = "_build/mistakes"
CAPTION = "The point of the verdict, with the region of this answer and the right one (hatched)."


def _insert(app, document):
    """Insert the folds while a page is read, so that Sphinx collects their pictures."""
    problem = catalogue.of(app.env).get(app.env.docname)
    if problem is None or not problem.solved:
        return
    page = problem.page.removeprefix("solutions/")
    file = Path(app.srcdir, FOLDER, f"{page}.json")
    app.env.note_dependency(str(file))
    if not file.exists():  # `make book` writes it; pages may be built without it
        return
    cells = [cell for cell in document.findall(nodes.container) if "tag_check" in cell["classes"]]
    listed = json.loads(file.read_text(encoding="utf-8"))["checks"]
    for cell, answers in zip(cells, listed, strict=True):
        folds = [
            _fold(answer, f"/{FOLDER}/ch{problem.chapter}")
            for answer in answers
            if answer["mistakes"]
        ]
        box = nodes.container("", *folds, classes=["common-mistakes"])
        cell.parent.insert(cell.parent.index(cell) + 1, box)


def _fold(answer, pictures):
    name = answer["answer"]
    title = summary("", "Common mistakes: ", nodes.literal("", name))
    fold = details("", title, classes=["mistakes"])
    for mistake in answer["mistakes"]:
        box = nodes.container(classes=["common-mistake"])
        box += nodes.literal_block(mistake["code"], mistake["code"], language="python")
        box += _html(as_html({name: Verdict(WRONG, plain(mistake["message"]))}))
        if mistake["picture"]:
            picture = nodes.image(uri=f"{pictures}/{mistake['picture']}", alt=CAPTION)
            # a figure of docutils would be numbered
            box += [
                _html("<figure>"),
                picture,
                _html(f"<figcaption>{CAPTION}</figcaption></figure>"),
            ]
        question = typeset(mistake["question"])
        box += _html(f'<p class="question"><strong>Ask yourself:</strong> {question}</p>')
        fold += box
    return fold


def _html(text):
    return nodes.raw("", text, format="html")


def setup(app):
    app.connect("doctree-read", _insert, priority=400)  # before Sphinx collects pictures (500)

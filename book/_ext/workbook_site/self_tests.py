"""The questions of a section, `{self-test}`, with the answer boxes of the problems and no marks.

A block holds a question, the code that judges it, and what the fold below it shows:

    :::{self-test}
    For which $k$ do both roots of $s^2 + ks + 1$ lie to the left?

    ```python
    k, s = sp.symbols("k s", real=True)
    # %% answer: a condition on k, such as k < 3
    damping = k > 0
    # %% wrong: At $k = 0$ both roots are on the imaginary axis.
    damping = k >= 0
    # %% check
    checks.stability_region(damping, s**2 + k*s + 1, [k])
    ```

    The reason for the answer.
    :::

The blocks of a page are one notebook: a block may use the data of the blocks above it, not their
answers.
"""

import ast
import json
import re
from dataclasses import dataclass
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from workbook.site.answer_boxes import Box, add_script, answer_box, version_of
from workbook.site.folding import details, summary

BLOCK = re.compile(r"^:::\{self-test\}\n(.*?)^:::$", re.M | re.S)
CODE = re.compile(r"^```python\n(.*?)^```$", re.M | re.S)
PARTS = re.compile(r"^# %% (answer|wrong|check)(?:: (.*))?\n", re.M)
IMPORTS = "import sympy as sp\n\nfrom workbook import checks"


@dataclass(frozen=True)
class Question:
    """A block: its texts in Markdown, its code, the right answer and typical wrong ones.

    `answer` and each of `wrong` are (assignment, text): what is to be typed, and why it is wrong.
    """

    text: str
    reason: str
    data: str
    answer: tuple
    wrong: tuple
    check: str

    @property
    def name(self):
        return ast.parse(self.answer[0]).body[0].targets[0].id

    @property
    def stub(self):
        return f"{self.name} = ...  # {self.answer[1]}"

    @property
    def check_cell(self):
        return f"checks.report(\n    {self.name}={self.check},\n)"


def question_of(block):
    """Return the question of a block; ValueError says what is missing."""
    text, *code = CODE.split(block, maxsplit=1)
    if not code:
        raise ValueError("a self-test needs a block of Python")
    data, *parts = PARTS.split(code[0])
    by_role = {"answer": [], "wrong": [], "check": []}
    for role, comment, source in zip(parts[::3], parts[1::3], parts[2::3], strict=True):
        by_role[role].append((source.strip(), comment))
    if not (len(by_role["answer"]) == len(by_role["check"]) == 1 and by_role["wrong"]):
        raise ValueError("a self-test has one answer, one check and at least one wrong answer")
    if not all(comment for _, comment in by_role["answer"] + by_role["wrong"]):
        raise ValueError("the answer says what is to be typed, a wrong one why it is wrong")
    return Question(
        text.strip(),
        code[1].strip(),
        data.strip(),
        by_role["answer"][0],
        tuple(by_role["wrong"]),
        by_role["check"][0][0],
    )


def questions_of(page):
    """Return the questions in the text of a page."""
    return [question_of(block) for block in BLOCK.findall(page)]


def notebook_of(questions):
    """Return the cells that a page runs: imports, then data, answer and check of each question."""
    cells = [_cell("imports", "data", IMPORTS)]
    for question in questions:
        cells += [
            _cell(f"data-{question.name}", "data", question.data),
            _cell(_answer_id(question), "answer", question.stub),
            _cell(_check_id(question), "check", question.check_cell),
        ]
    return {"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5}


def _cell(name, role, source):
    return {
        "cell_type": "code",
        "id": name,
        "metadata": {"tags": [role]},
        "source": source,
        "execution_count": None,
        "outputs": [],
    }


def _answer_id(question):
    return f"answer-{question.name}"


def _check_id(question):
    return f"check-{question.name}"


class SelfTest(SphinxDirective):
    """Shows a question with its box, and a fold with the right answer, its reason and mistakes."""

    has_content = True

    def run(self):
        try:
            question = question_of("\n".join(self.content) + "\n")
        except ValueError as error:
            raise self.error(str(error)) from None
        page = self.env.docname
        number = self.env.metadata[page].get("self_test", 0) + 1
        self.env.metadata[page]["self_test"] = number
        label = question_label(page, number)
        self.env.get_domain("std").note_hyperlink_target(label, page, label, f"question {number}")
        box = Box(_check_id(question), ((_answer_id(question), question.name, question.stub),))
        fold = details("", summary("", "Answer and reason"), classes=["self-test-answer"])
        fold += [_code(question.answer[0]), *self.parse_text_to_nodes(question.reason)]
        for source, why in question.wrong:
            fold += nodes.paragraph("", "A common wrong answer:")
            fold += [_code(source), *self.parse_text_to_nodes(why)]
        return [
            nodes.container(
                "",
                *self.parse_text_to_nodes(f"**Question {number}.** {question.text}"),
                answer_box(page=page, box=box),
                fold,
                ids=[label],
                classes=["self-test"],
            )
        ]


def question_label(page, number):
    """Return the label of a question of a page by its number, from 1 up."""
    return nodes.make_id(f"self-test-{page.removeprefix('book/')}-{number}")


def _code(source):
    return nodes.literal_block(source, source, language="python")


def _notebook(app, page):
    text = Path(app.env.doc2path(page)).read_text(encoding="utf-8")
    return notebook_of(questions_of(text))


def _has_questions(app, page):
    return app.config.workbook_engine_found and app.env.metadata[page].get("self_test")


def _add_script(app, page, template, context, doctree):
    if doctree is None or not _has_questions(app, page):
        return
    notebook = _notebook(app, page)
    add_script(
        app,
        page,
        f"{page}.self-test.ipynb",
        **{
            "data-number": f"self-test {page}",
            "data-title": app.env.titles[page].astext(),
            "data-answers": str(
                sum(cell["id"].startswith("answer-") for cell in notebook["cells"])
            ),
            "data-version": version_of(notebook),
            "data-part": "true",  # no panel: nothing is counted or handed in
        },
    )


def _write_notebooks(app, exception):
    if exception is not None or app.builder.format != "html":
        return
    for page in filter(lambda page: _has_questions(app, page), app.env.found_docs):
        text = json.dumps(_notebook(app, page), ensure_ascii=False)
        script = app.outdir / f"{page}.self-test.ipynb.js"
        script.parent.mkdir(parents=True, exist_ok=True)
        script.write_text(f"window.workbookNotebook = {text};\n", encoding="utf-8")


def setup(app):
    app.add_directive("self-test", SelfTest)
    app.connect("html-page-context", _add_script)
    app.connect("build-finished", _write_notebooks)

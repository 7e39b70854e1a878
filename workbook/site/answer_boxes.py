"""A box before each check cell, in which a reader types answers and has them checked.

A page holds its boxes hidden, with the stubs of the student's notebook, and `static/answer_boxes`
shows them; without scripts, on paper and without the engine (Python in WebAssembly, `run/`) a page
is as it is without boxes. The boxes are the answer cells of the notebook: what is typed goes into
it unchanged, and the verdict is the grader's. `{try-answer}` shows a box of a problem on another page.
Below the last box a fold holds the one that checks the steps of work on paper.
"""

import hashlib
import json
import posixpath
import re
import shutil
from dataclasses import dataclass
from html import escape

from docutils import nodes
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util.docutils import SphinxDirective

from workbook.authoring.student_notebook import STEPS_TEXT
from workbook.checks.contract.check_cells import reported_names
from workbook.checks.contract.former_names import with_former_names
from workbook.mistakes import read_sealed
from workbook.site import catalogue
from workbook.site.downloads import served_notebook
from workbook.site.folding import details, solution_of, summary

#: The folder of the engine below the site's root, and its script.
RUN, ENGINE = "run", "engine.js"
STUB = re.compile(r"^(\w+) = \.\.\.", re.M)
DIGITS = 12


@dataclass(frozen=True)
class Box:
    """The id of a check cell and its answer cells: (id, name, stub); whether its verdicts count."""

    check: str
    answers: tuple
    counts: bool = True

    def html(self):
        """Return the hidden box."""
        fields = "".join(
            f'<textarea data-cell="{cell}" data-name="{name}"{_former(name)} aria-label="{name}" '
            f'spellcheck="false" '
            f'autocapitalize="off" rows="{stub.count(chr(10)) + 1}">{escape(stub)}</textarea>'
            for cell, name, stub in self.answers
        )
        names = ", ".join(name for _, name, _ in self.answers)
        return (
            f'<section class="answer-box" data-check="{self.check}"{"" if self.counts else " data-uncounted"} '
            f'aria-label="Answer: {names}" hidden>{fields}</section>\n'
        )


def _former(name):
    """Return the attribute for a former name, under which answers may be kept in a browser."""
    former = with_former_names(name)
    return f' data-former="{former}"' if former != name else ""


class answer_box(nodes.General, nodes.Element):
    """A box of a problem: its attributes are `page`, the problem's, and `box`."""


def boxes_of(notebook):
    """Return the boxes of a student notebook in the order of its check cells."""
    stubs = {
        STUB.search(cell["source"])[1]: (cell["id"], cell["source"])
        for cell in notebook["cells"]
        if _has_role(cell, "answer")
    }
    checks = [
        (cell["id"], set(reported_names(cell["source"])))
        for cell in notebook["cells"]
        if _has_role(cell, "check")
    ]
    return [
        Box(
            check,
            tuple((cell, name, stub) for name, (cell, stub) in stubs.items() if name in names),
        )
        for check, names in checks
    ]


def steps_box_of(notebook):
    """Return the box that checks the steps of work on paper."""
    stub, check = (
        cell
        for cell in notebook["cells"]
        if _has_role(cell, "steps") and cell["cell_type"] == "code"
    )
    name = STUB.search(stub["source"])[1]
    return Box(check["id"], ((stub["id"], name, stub["source"]),), counts=False)


def in_order_of_boxes(notebook):
    """Return the notebook with its answer cells in the order of the boxes.

    Some checks judge an answer whose stub stands among those of an earlier check. Cells run in the
    order in which the page shows them, and the downloaded notebook has the same.
    """
    cells = {cell["id"]: cell for cell in notebook["cells"]}
    order = iter([cells[cell] for box in boxes_of(notebook) for cell, _, _ in box.answers])
    return notebook | {
        "cells": [next(order) if _has_role(cell, "answer") else cell for cell in notebook["cells"]]
    }


def version_of(notebook):
    """Return a digest of the code: typed answers are kept for one version of a problem."""
    code = [
        cell["source"]
        for cell in notebook["cells"]
        if cell["cell_type"] == "code" and not _has_role(cell, "steps")
    ]
    return hashlib.sha256(json.dumps(code[1:]).encode()).hexdigest()[:DIGITS]


def _has_role(cell, role):
    return role in cell["metadata"].get("tags", ())


class AnswerBoxes(SphinxPostTransform):
    """Puts each box before the worked solution of its item, or before its hints and check."""

    default_priority = 195  # after solutions and code are folded
    formats = ("html",)

    def run(self, **kwargs):
        problem = catalogue.of(self.env).get(self.env.docname)
        if problem is None or not self.config.workbook_engine_found:
            return
        cells = [cell for cell in self.document.findall(nodes.container) if _is_cell(cell, "check")]
        place, notebook = _Place(self.document), _notebook(self.app, problem)
        for box, check in zip(boxes_of(notebook), cells, strict=True):
            last = answer_box(page=problem.page, box=box)
            place.insert(last, check)
        steps = details("", summary("", "Check my steps"), classes=["steps"])
        steps += nodes.paragraph("", STEPS_TEXT)
        steps += answer_box(page=problem.page, box=steps_box_of(notebook))
        last.parent.insert(last.parent.index(last) + 1, steps)


class TryAnswer(SphinxDirective):
    """Shows its text with the box of an answer: {try-answer} 1.15 a_region; nothing without the engine."""

    has_content = True
    required_arguments = 2

    def run(self):
        number, name = self.arguments
        trial = nodes.container(classes=["try-answer"], number=number, answer=name)
        self.state.nested_parse(self.content, self.content_offset, trial)
        return [trial]


class TryAnswers(SphinxPostTransform):
    """Completes or removes what `TryAnswer` shows."""

    default_priority = AnswerBoxes.default_priority
    formats = ("html",)

    def run(self, **kwargs):
        problems = {problem.number: problem for problem in catalogue.of(self.env).values()}
        for trial in list(self.document.findall(lambda node: "try-answer" in _classes(node))):
            problem = problems.get(trial["number"])
            if problem is None or not self.config.workbook_engine_found:
                trial.parent.remove(trial)
                continue
            (box,) = (
                box
                for box in boxes_of(_notebook(self.app, problem))
                if trial["answer"] in {name for _, name, _ in box.answers}
            )
            trial += answer_box(page=problem.page, box=box)


class _Place:
    """Where boxes go; each follows the one before it."""

    def __init__(self, document):
        self._order = list(document.findall())
        self._first = 0  # of the nodes before which the next box may stand

    def insert(self, node, check):
        end = self._order.index(check)
        candidates = self._order[self._first : end]
        name = node["box"].answers[0][1]
        before = solution_of(name, candidates) or self._stub_or_hint(candidates) or check
        before.parent.insert(before.parent.index(before), node)
        self._first = self._order.index(before)
        if before is check or not isinstance(before, details):
            self._first = end + 1

    def _stub_or_hint(self, candidates):
        """Return the first answer cell of the student edition, or else the first hint."""
        for kind in (lambda node: _is_cell(node, "answer"), _is_hint):
            for node in candidates:
                if kind(node):
                    return node
        return None


def _classes(node):
    return node["classes"] if isinstance(node, nodes.container) else ()


def _is_cell(node, role):
    return f"tag_{role}" in _classes(node) and node.get("nb_element") == "cell_code"


def _is_hint(node):
    return isinstance(node, nodes.raw) and node.astext().startswith("<details><summary>Hint")


def _notebook(app, problem):
    return in_order_of_boxes(served_notebook(app, problem))


def _other_rows(app, problem):
    """Return row -> statement and notebook of the numbers with which a problem is asked again."""
    path = (
        app.srcdir
        / "_build"
        / problem.page.replace(problem.page.partition("/")[0], "asked_again", 1)
    )
    path = path.with_suffix(".json")
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


def _find_engine(app, config):
    config.workbook_engine_found = (app.srcdir / config.workbook_engine / ENGINE).exists()


def _add_scripts(app, page, template, context, doctree):
    """Load the script of the boxes where there are boxes, and that of the marks on lists."""
    if not app.config.workbook_engine_found:
        return
    if page in getattr(app.env, "workbook_listings", ()):
        add_static_script(app, "progress.js")
    box = next(iter(doctree.findall(answer_box)), None) if doctree else None
    if box is None:
        return
    problem = catalogue.of(app.env).get(box["page"])
    if problem is None:
        return  # the box of a self-test
    add_script(
        app,
        page,
        problem.notebook,
        **{
            "data-number": problem.number,
            "data-title": problem.title,
            "data-answers": str(len(problem.answers)),
            "data-version": version_of(_notebook(app, problem)),
            **({"data-rows": " ".join(rows)} if (rows := _other_rows(app, problem)) else {}),
            **({} if page == problem.page else {"data-part": "true"}),
        },
    )


def add_static_script(app, name):
    """Load a script of the answer boxes, with their style, on the page that is being written."""
    if app.config.workbook_engine_found:
        app.add_css_file("answer_boxes/boxes.css")
        app.add_js_file(f"answer_boxes/{name}", loading_method="defer")


def add_script(app, page, notebook, **attributes):
    """Load the script of the boxes on a page; `notebook` is the path of their notebook."""
    root = posixpath.relpath(".", posixpath.dirname(page))
    app.add_css_file("answer_boxes/boxes.css")
    app.add_js_file(
        "answer_boxes/boxes.js",
        loading_method="defer",
        **attributes,
        **{"data-notebook": f"{root}/{notebook}.js", "data-run": f"{root}/{RUN}/"},
    )


def _write_notebooks(app, exception):
    """Write each notebook as a script too, with its mistakes, which pages opened as files can load."""
    if exception is not None or app.builder.format != "html":
        return
    for problem in catalogue.of(app.env).values():
        script = app.outdir / f"{problem.notebook}.js"
        if app.config.workbook_engine_found:
            script.parent.mkdir(parents=True, exist_ok=True)
            sealed = {problem.number: read_sealed(app.srcdir / problem.notebook)}
            script.write_text(
                f"window.workbookNotebook = {_as_json(_notebook(app, problem))};\n"
                f"window.workbookMistakes = {_as_json(sealed)};\n",
                encoding="utf-8",
            )
            if rows := _other_rows(app, problem):
                for row in rows.values():
                    row["notebook"] = in_order_of_boxes(row["notebook"])
                script = app.outdir / f"{problem.notebook.removesuffix('ipynb')}again.js"
                script.write_text(f"window.workbookRows = {_as_json(rows)};\n", encoding="utf-8")
        else:
            script.unlink(missing_ok=True)


def _as_json(value):
    return json.dumps(value, ensure_ascii=False)


def _copy_engine(app, exception):
    """Copy the engine into the site, in place of the one that was there."""
    if exception is not None or app.builder.format != "html":
        return
    shutil.rmtree(app.outdir / RUN, ignore_errors=True)
    if app.config.workbook_engine_found:
        shutil.copytree(app.srcdir / app.config.workbook_engine, app.outdir / RUN)


def _note_notebook(app, document):
    """Make a page outdated when its notebook changes, also if its master has not."""
    problem = catalogue.of(app.env).get(app.env.docname)
    if problem is not None:
        app.env.note_dependency(problem.notebook)


def _open_box(self, node):
    if self.config.workbook_engine_found:
        self.body.append(node["box"].html())
    raise nodes.SkipNode


def setup(app):
    # the folder of the engine, where `workbook page` puts it; without one there are no boxes
    app.add_config_value("workbook_engine", f"_build/{RUN}", "html")
    app.add_config_value("workbook_engine_found", False, "html")
    app.connect("config-inited", _find_engine, priority=100)
    app.connect("html-page-context", _add_scripts)
    app.connect("build-finished", _write_notebooks)
    app.connect("build-finished", _copy_engine)
    app.connect("doctree-read", _note_notebook)
    app.add_node(answer_box, html=(_open_box, None))
    app.add_directive("try-answer", TryAnswer)
    app.add_post_transform(AnswerBoxes)
    app.add_post_transform(TryAnswers)

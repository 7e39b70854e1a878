"""A problem's page.

The front matter of the master is shown as the page is read: the number with the title, a line of
chips and the notebook under it, the answers asked for and the hints under the statement. The file
itself is never changed. The topics become entries of the index.
"""

import json
import re

from docutils import nodes
from docutils.statemachine import StringList
from sphinx import addnodes
from sphinx.transforms import SphinxTransform
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective, SphinxRole
from sphinx_exercise.nodes import exercise_node

from workbook.authoring.contract import item_of, plural_kind
from workbook.authoring.plain_markdown import SENTENCE_END
from workbook.authoring.student_notebook import core_text
from workbook.notebooks import exercises
from workbook.site import catalogue
from workbook.site.downloads import colab_links, link
from workbook.site.folding import details, summary

logger = logging.getLogger(__name__)

TITLE = re.compile(r"^# .*$", re.M)
EXERCISE_END = re.compile(r"^(`{3,}|:{3,})\{exercise-end\}[ \t]*\n(?:.*\n)*?\1[ \t]*$", re.M)


def _complete(app, page, source):
    problem = catalogue.of(app.env).get(page)
    if problem is None:
        return
    if not (app.srcdir / problem.notebook).exists():
        logger.warning(
            f"{problem.notebook} is missing; `workbook exercises` writes it", location=page
        )
    head = f"# {problem.number} {problem.title}\n\n```{{problem-head}}\n```\n"
    if problem.solved:
        text = TITLE.sub(lambda _: head, source[0], count=1)
        source[0] = EXERCISE_END.sub(
            lambda end: f"{end[0]}\n\n```{{problem-answers}}\n```\n", text, count=1
        )
    else:
        source[0] = _student_page(source[0], head)


def _student_page(source, head):
    """Return the notebook as a page: the head first, without the notebook's own two headings."""
    notebook = json.loads(source)
    notebook["cells"] = [
        cell
        for cell in notebook["cells"]
        if cell["metadata"].get("tags") not in (["setup"], ["steps"])
    ]
    notebook = exercises.add_links(notebook, _link_target)
    texts = [cell for cell in notebook["cells"] if cell["cell_type"] == "markdown"]
    for cell in texts:
        cell["source"] = re.sub(r"^##? Problem .*$", "", cell["source"], flags=re.M).strip()
        for name, forms in cell.get("attachments", {}).items():  # myst-nb does not support them
            for form, picture in forms.items():
                cell["source"] = cell["source"].replace(
                    f"attachment:{name}", f"data:{form};base64,{picture}"
                )
    texts[0]["source"] = f"{head}\n:::{{container}} origin\n{texts[0]['source']}\n:::"
    return json.dumps(notebook)


def _link_target(path):
    """Return how a page of the site links to a path: by its label, or by the file of its page."""
    page, _, label = path.partition("#")
    return f"#{label}" if label else f"/{page.removesuffix('.html')}.md"


class ProblemHead(SphinxDirective):
    """Shows the line under the title: section, level, time, folded topics, the student's notebook."""

    def run(self):
        problem = catalogue.of(self.env)[self.env.docname]
        chips = nodes.paragraph(classes=["problem-chips"])
        chips += _chip(f"{problem.section}", "section")
        chips += _chip("★ starred" if problem.level == "starred" else problem.level, problem.level)
        chips += _chip(problem.study_time, "time")
        topics = nodes.paragraph(classes=["problem-chips"])
        for topic in problem.topics:
            topics += to_label(self.env.docname, topic_label(topic), topic, "chip", "topic")
        # a topic may name the result: it is shown when asked for, or when all answers are right
        fold = details("", summary("", "Topics"), topics, classes=["topics"])
        notebook = nodes.paragraph(
            "",
            "",
            link(problem.page, problem.notebook, "Student’s notebook"),
            *colab_links(self.config.html_baseurl, problem.notebook),
            classes=["problem-notebook"],
        )
        index = addnodes.index(
            entries=[
                ("single", entry, f"problem-{problem.number}", "main", None)
                for entry in problem.topics
            ]
        )
        target = nodes.target("", "", ids=[f"problem-{problem.number}"])
        head = nodes.container("", chips, fold, notebook, classes=["problem-head"])
        core = (
            [nodes.paragraph("", core_text(problem.core), classes=["problem-core"])]
            if problem.core
            else []
        )
        return [index, target, head, *core]


class ProblemAnswers(SphinxDirective):
    """Shows the answers to assign: a fold for each item, in it a fold for each hint.

    `AnswersBesideItems` moves the fold of an item under its statement, if it has one.
    """

    def run(self):
        problem = catalogue.of(self.env)[self.env.docname]
        groups = {}
        for name in problem.answers:
            groups.setdefault(item_of(name), []).append(name)
        box = nodes.container(classes=["problem-answers"])
        for item, names in groups.items():
            title = summary("", "To answer: ")
            title += [node for name in names for node in (nodes.literal("", name), nodes.Text(" "))]
            fold = details("", title, classes=["answers"], item=item)
            fold += [self._row(name, problem) for name in names]
            box += fold
        return [box]

    def _row(self, name, problem):
        kind, meaning = problem.answers[name]
        row = nodes.container(classes=["answer"])
        row += self._markdown(f"`{name}` {meaning}")
        row[0] += [nodes.Text(" "), nodes.inline("", plural_kind(kind), classes=["kind"])]
        for k, hint in enumerate(problem.hints.get(name, []), start=1):
            fold = details("", summary("", f"Hint {k}"), classes=["hint"])
            fold += self._markdown(hint)
            row += fold
        return row

    def _markdown(self, text):
        parsed = nodes.Element()
        self.state.nested_parse(StringList(text.splitlines(), self.env.docname), 0, parsed)
        return parsed.children


class AnswersBesideItems(SphinxPostTransform):
    """Moves the answers of an item under its statement and the formulas that belong to it.

    Where text about all items follows the last one, such as the question, they come after that text.
    """

    default_priority = 25  # before solutions are folded
    formats = ("html",)

    def run(self, **kwargs):
        folds = [fold for fold in self.document.findall(details) if fold.get("item")]
        for statement in self.document.findall(exercise_node):
            openings = [p for p in statement.findall(nodes.paragraph) if _opens_item(p)]
            text_follows = openings and any(
                isinstance(node, nodes.paragraph)
                for node in openings[-1].parent[_end_of_item(openings[-1]) :]
            )
            for fold in folds:
                own = [p for p in openings if p.astext()[0] == fold["item"]]
                if own:
                    fold.parent.remove(fold)
                    parent = own[0].parent
                    parent.insert(len(parent) if text_follows else _end_of_item(own[0]), fold)


def _opens_item(paragraph):
    return re.match(r"[a-z]\)(\W|$)", paragraph.astext()) is not None


def _end_of_item(opening):
    """Return the index after the formulas and sentences that continue the first paragraph of an item."""
    parent = opening.parent
    below = parent.index(opening) + 1
    while below < len(parent) and _continues_item(parent[below]):
        below += 1
    return below


def _continues_item(node):
    """Return whether a node is a formula, a list, or a paragraph that continues a sentence."""
    return isinstance(node, (nodes.math_block, nodes.bullet_list)) or (
        isinstance(node, nodes.paragraph)
        and re.match("[a-z]", node.astext()) is not None
        and not _opens_item(node)
    )


class ProblemRole(SphinxRole):
    """Links to a problem's page in the edition that is built: {problem}`1.15`.

    A problem without a page is named without a link.
    """

    def run(self):
        for problem in catalogue.of(self.env).values():
            if problem.number == self.text:
                reference = to_page(self.env.docname, problem.page, f"problem {problem.number}")
                break
        else:
            logger.info(f"problem {self.text} has no page yet", location=self.get_location())
            reference = nodes.inline("", f"problem {self.text}")
        reference["problem"] = self.text
        return [reference], []


class BeginWithCapital(SphinxTransform):
    """Writes "Problem 1.15" with a capital at the beginning of a sentence."""

    default_priority = 880

    def apply(self, **kwargs):
        for reference in self.document.findall(
            lambda node: isinstance(node, nodes.Element) and "problem" in node
        ):
            before, node = "", reference
            # also the first word of an emphasis may begin the sentence
            while isinstance(node.parent, nodes.TextElement):
                before = (
                    "".join(part.astext() for part in node.parent[: node.parent.index(node)])
                    + before
                )
                node = node.parent
            if not before.strip() or SENTENCE_END.search(before):
                text = next(iter(reference.findall(nodes.Text)))
                text.parent.replace(text, nodes.Text(text[0].upper() + text[1:]))


def topic_label(topic):
    return nodes.make_id(f"topic-{topic}")


def to_label(page, label, text, *classes):
    """Return a link to a label of the book, resolved when all pages are read."""
    return _reference(page, "ref", label, text, *classes)


def to_page(page, other, text, *classes):
    """Return a link from one page to another."""
    return _reference(page, "doc", f"/{other}", text, *classes)


def _reference(page, kind, target, text, *classes):
    return addnodes.pending_xref(
        "",
        nodes.inline("", text, classes=list(classes)),
        refdomain="std",
        reftype=kind,
        reftarget=target,
        refexplicit=True,
        refwarn=True,
        refdoc=page,
    )


def _chip(text, *classes):
    return nodes.inline("", text, classes=["chip", *classes])


def _name_labels(app, document):
    """Show references to `ex-1-15` as "problem 1.15", also in the student edition."""
    problem = catalogue.of(app.env).get(app.env.docname)
    if problem is None:
        return
    labels = app.env.get_domain("std")
    anchor = problem.label if problem.solved else ""
    labels.anonlabels[problem.label] = problem.page, anchor
    labels.labels[problem.label] = problem.page, anchor, f"problem {problem.number}"
    for name, (page, anchor, _) in list(labels.labels.items()):
        if page == problem.page and name.startswith(f"sol-{problem.label[3:]}"):
            labels.labels[name] = page, anchor, f"solution of problem {problem.number}"


def _without_index(app, env, reference, content):
    """Show a topic without a link on a site that has no index by topic."""
    return content if "topic" in content.get("classes", ()) else None


def setup(app):
    app.connect("source-read", _complete)
    app.connect("doctree-read", _name_labels, priority=900)
    app.connect("missing-reference", _without_index)
    app.add_directive("problem-head", ProblemHead)
    app.add_directive("problem-answers", ProblemAnswers)
    app.add_post_transform(AnswersBesideItems)
    app.add_role("problem", ProblemRole())
    app.add_transform(BeginWithCapital)

"""A problem's page.

The master says everything in its front matter; here, as a page is read, that is put where a reader
looks for it: the number with the title, a line of chips and the notebook under it, the answers
asked for and the hints under the statement. The file itself is never touched.
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
from sphinx.util.index_entries import split_index_msg
from sphinx_exercise.nodes import exercise_node

from workbook.authoring.contract import item_of, plural_kind
from workbook.authoring.plain_markdown import SENTENCE_END
from workbook.authoring.student_notebook import core_text
from workbook.notebooks import exercises
from workbook_site import catalogue
from workbook_site.boxes import details, summary
from workbook_site.downloads import link

logger = logging.getLogger(__name__)

TITLE = re.compile(r"^# .*$", re.M)
# of a person, in a topic: what else is written there begins small
NAME = re.compile(r"(?:van der )?[A-Z]\w+")
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
    """The notebook with the page's head first, then where the data come from, without its own two
    headings."""
    notebook = json.loads(source)
    notebook["cells"] = [
        cell for cell in notebook["cells"] if cell["metadata"].get("tags") != ["setup"]
    ]
    for cell in notebook["cells"]:
        cell["metadata"]["places"] = [
            (text, place)
            for text, place in cell["metadata"].get("places", ())
            # no page: the student's guide links to it
            if not place.startswith("wheels/")
        ]
    notebook = exercises.add_links(notebook, _neighbour)
    texts = [cell for cell in notebook["cells"] if cell["cell_type"] == "markdown"]
    for cell in texts:
        cell["source"] = re.sub(r"^##? Problem .*$", "", cell["source"], flags=re.M).strip()
        for name, forms in cell.get("attachments", {}).items():  # myst-nb does not know them
            for form, picture in forms.items():
                cell["source"] = cell["source"].replace(
                    f"attachment:{name}", f"data:{form};base64,{picture}"
                )
    texts[0]["source"] = f"{head}\n:::{{div}} origin\n{texts[0]['source']}\n:::"
    return json.dumps(notebook)


def _neighbour(place):
    """How a page of the site refers to a place: by its label, or by the file of its page."""
    page, _, label = place.partition("#")
    return f"#{label}" if label else f"/{page.removesuffix('.html')}.md"


class ProblemHead(SphinxDirective):
    """The line under the title: section, level, topics, and the student's notebook."""

    def run(self):
        problem = catalogue.of(self.env)[self.env.docname]
        chips = nodes.paragraph(classes=["problem-chips"])
        chips += _chip(f"{problem.section}", "section")
        chips += _chip("★ starred" if problem.level == "starred" else problem.level, problem.level)
        chips += _chip(problem.study_time, "time")
        for topic in problem.topics:
            chips += to_label(self.env.docname, topic_label(topic), topic, "chip", "topic")
        notebook = nodes.paragraph(
            "",
            "",
            link(problem.page, problem.notebook, "Student’s notebook"),
            classes=["problem-notebook"],
        )
        # Stock search takes "1.15" apart and drops the digits; an index entry is found whole.
        index = addnodes.index(
            entries=[
                ("single", entry, f"problem-{problem.number}", "main", None)
                for entry in self._index_entries(problem)
            ]
        )
        target = nodes.target("", "", ids=[f"problem-{problem.number}"])
        head = nodes.container("", chips, notebook, classes=["problem-head"])
        core = (
            [nodes.paragraph("", core_text(problem.core), classes=["problem-core"])]
            if problem.core
            else []
        )
        return [index, target, head, *core]

    def _index_entries(self, problem):
        # A master brings the entry of its number itself, its copy for students does not. The search
        # finds an entry by one half of it at least, so the names in a topic are entries of their
        # own.
        names = [name for topic in problem.topics for name in NAME.findall(topic)]
        entries = [
            f"problem {problem.number}",
            *([] if problem.solved else [problem.number]),
            *problem.topics,
            *names,
        ]
        return list(dict.fromkeys(entries))


class ProblemAnswers(SphinxDirective):
    """What the student is to assign: a fold an item, with its answers and their hints, one fold a
    hint.

    `AnswersBesideItems` puts the fold of an item under its statement; what has no such place stays
    here.
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
    """The answers of an item go under its statement, with the formulas and the half sentences that
    belong to it."""

    default_priority = 25  # before solutions are folded
    formats = ("html",)

    def run(self, **kwargs):
        folds = [fold for fold in self.document.findall(details) if fold.get("item")]
        for statement in self.document.findall(exercise_node):
            for fold in folds:
                opening = next(
                    (
                        p
                        for p in statement.findall(nodes.paragraph)
                        if re.match(rf"{fold['item']}\)(\W|$)", p.astext())
                    ),
                    None,
                )
                if opening is not None:
                    place, below = opening.parent, opening.parent.index(opening) + 1
                    while below < len(place) and _goes_on(place[below]):
                        below += 1
                    fold.parent.remove(fold)
                    place.insert(below, fold)


def _goes_on(node):
    """True for a formula, a list, and a paragraph that goes on in the midst of a sentence."""
    return isinstance(node, (nodes.math_block, nodes.bullet_list)) or (
        isinstance(node, nodes.paragraph)
        and re.match(r"(?![a-z]\)(\W|$))[a-z]", node.astext()) is not None
    )


class ProblemRole(SphinxRole):
    """{problem}`1.15` leads to the problem's page in whichever edition is built; a problem without
    a page is only named."""

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
    """What begins a sentence, a paragraph, an entry of a list or a cell of a table says "Problem
    1.15"."""

    default_priority = 880

    def apply(self, **kwargs):
        for reference in self.document.findall(
            lambda node: isinstance(node, nodes.Element) and "problem" in node
        ):
            before, place = "", reference
            # emphasis begins with what it holds
            while isinstance(place.parent, nodes.TextElement):
                before = (
                    "".join(node.astext() for node in place.parent[: place.parent.index(place)])
                    + before
                )
                place = place.parent
            if not before.strip() or SENTENCE_END.search(before):
                text = next(iter(reference.findall(nodes.Text)))
                text.parent.replace(text, nodes.Text(text[0].upper() + text[1:]))


def topic_label(topic):
    return nodes.make_id(f"topic-{topic}")


def to_label(page, label, text, *classes):
    """A link to a label of the book, resolved when all pages are read."""
    return _reference(page, "ref", label, text, *classes)


def to_page(page, other, text, *classes):
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
    """`ex-1-15` reads "problem 1.15" wherever it is referred to, and exists in the student edition
    as well."""
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


def _keep_index_entries(app, env):
    """Sphinx's search forgets the index entries of pages that it need not write again; the
    environment knows them."""
    for docname, entries in env.get_domain("index").entries.items():
        env._search_index_index_entries[docname] = sorted(
            {
                (text, target or "", main)
                for kind, value, target, main, _ in entries
                for text in split_index_msg(kind, value)
            }
        )


def setup(app):
    app.connect("env-updated", _keep_index_entries)
    app.connect("source-read", _complete)
    app.connect("doctree-read", _name_labels, priority=900)
    app.add_directive("problem-head", ProblemHead)
    app.add_directive("problem-answers", ProblemAnswers)
    app.add_post_transform(AnswersBesideItems)
    app.add_role("problem", ProblemRole())
    app.add_transform(BeginWithCapital)

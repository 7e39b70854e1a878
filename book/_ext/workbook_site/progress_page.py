"""The page "Where am I?": `{progress}` holds the sections and problems; `answer_boxes/where.js` shows the reader's own.

What the reader did is in the browser alone; the page says what there is to do.
"""

import json
import posixpath

from docutils import nodes

from workbook.site import catalogue
from workbook.site.answer_boxes import add_static_script
from workbook.site.listings import Listing
from workbook_site.chapter_map import sections_of


class progress(nodes.General, nodes.Element):
    """The place for the reader's progress."""


class Progress(Listing):
    """Shows the reader's progress, in a browser."""

    def content_of(self, problems):
        return [progress()]


def _open(self, node):
    env = self.builder.env
    page = self.builder.current_docname

    def url(other):
        return posixpath.relpath(f"{other}.html", posixpath.dirname(page))

    problems = {
        problem.number: {
            "title": problem.title,
            "url": url(problem.page),
            "topics": problem.topics,
            "answers": len(problem.answers),
            "varies": problem.varies,
        }
        for problem in catalogue.of(env).values()
    }
    chapters = dict.fromkeys(problem.chapter for problem in catalogue.of(env).values())
    sections = [
        {
            "title": env.titles[section].astext(),
            "url": url(section),
            "numbers": [problem.number for problem in members],
            "test": f"self-test {section}",
        }
        for chapter in chapters
        if f"book/ch{chapter}" in env.found_docs
        for section, members in sections_of(env, chapter).items()
    ]
    data = json.dumps({"problems": problems, "sections": sections}, ensure_ascii=False)
    data = data.replace("</", "<\\/")
    self.body.append(
        '<div id="progress-page"><p>This needs a browser with scripts, and pages with answer boxes.</p></div>\n'
        f'<script type="application/json" id="progress-data">{data}</script>\n'
    )
    raise nodes.SkipNode


def _add_script(app, page, template, context, doctree):
    if doctree and next(iter(doctree.findall(progress)), None) is not None:
        add_static_script(app, "where.js")


def setup(app):
    app.add_node(progress, html=(_open, None))
    app.add_directive("progress", Progress)
    app.connect("html-page-context", _add_script)

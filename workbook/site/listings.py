"""The list of all problems and the index by topic, made from the catalogue."""

from html import escape
from itertools import groupby

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from workbook.site import catalogue
from workbook.site.problem_pages import to_page, topic_label


class Listing(SphinxDirective):
    """A directive whose page is read again whenever a problem changes."""

    def run(self):
        if not hasattr(self.env, "workbook_listings"):
            self.env.workbook_listings = set()
        self.env.workbook_listings.add(self.env.docname)
        return self.content_of(list(catalogue.of(self.env).values()))

    def link(self, problem, text):
        return to_page(self.env.docname, problem.page, text)


class ProblemList(Listing):
    """Lists all problems, a table for each chapter."""

    def content_of(self, problems):
        self.env.metadata[self.env.docname]["problem_filter"] = True
        return [
            nodes.raw("", _filter_of(problems), format="html"),
            *(
                self._chapter(chapter, list(members))
                for chapter, members in groupby(problems, lambda p: p.chapter)
            ),
        ]

    def _chapter(self, chapter, problems):
        title = f"Chapter {chapter}"
        section = nodes.section("", nodes.title("", title), ids=[f"problems-{chapter}"])
        if f"book/ch{chapter}" in self.env.found_docs:
            theory = to_page(self.env.docname, f"book/ch{chapter}", "theory and worked examples")
            section += nodes.paragraph(
                "", "", nodes.Text("The "), theory, nodes.Text(" of this chapter.")
            )
        section += self._table(problems)
        return section

    def _table(self, problems):
        columns = {"number": 8, "title": 56, "section": 10, "level": 14, "minutes": 12}
        body = nodes.tbody()
        for problem in problems:
            row = nodes.row(classes=[problem.level, *map(topic_label, problem.topics)])
            row["classes"] += ["varies"] * problem.varies
            for cell in (
                self.link(problem, problem.number),
                self.link(problem, problem.title),
                nodes.inline("", problem.section),
                nodes.inline("", "★ starred" if problem.level == "starred" else problem.level),
                nodes.inline("", str(problem.minutes)),
            ):
                row += nodes.entry("", nodes.paragraph("", "", cell))
            body += row
        head = nodes.thead(
            "", nodes.row("", *(nodes.entry("", nodes.paragraph("", name)) for name in columns))
        )
        group = nodes.tgroup(
            "",
            *(nodes.colspec(colwidth=width) for width in columns.values()),
            head,
            body,
            cols=len(columns),
        )
        return nodes.table("", group, classes=["problem-list"])


def _filter_of(problems):
    """Return the form that narrows the list; the script of it shows it."""
    topics = sorted({topic for problem in problems for topic in problem.topics}, key=str.casefold)
    choices = {
        "level": [("", "all"), *((name, name) for name in ("core", "advanced", "starred"))],
        "minutes": [("", "any"), *((str(n), f"up to {n}") for n in (30, 45, 60, 90, 120))],
        "topic": [("", "all"), *((topic_label(topic), topic) for topic in topics)],
    }
    selects = "".join(
        f'<label>{name} <select name="{name}">'
        + "".join(f'<option value="{value}">{escape(text)}</option>' for value, text in options)
        + "</select></label>"
        for name, options in choices.items()
    )
    boxes = "".join(
        f'<label><input type="checkbox" name="{name}"> {text}</label>'
        for name, text in (("varies", "other numbers exist"), ("open", "not verified here yet"))
    )
    return f'<form class="problem-filter" hidden>{selects}{boxes}<output></output></form>'


class TopicIndex(Listing):
    """Lists every topic with its problems, by first letter; chips of problem pages link here."""

    def content_of(self, problems):
        topics = {}
        for problem in problems:
            for topic in problem.topics:
                topics.setdefault(topic, []).append(problem)
        ordered = sorted(topics, key=str.casefold)
        return [
            self._letter(letter, list(members), topics)
            for letter, members in groupby(ordered, lambda topic: topic[0].upper())
        ]

    def _letter(self, letter, names, topics):
        section = nodes.section("", nodes.title("", letter), ids=[f"topics-{letter.lower()}"])
        entries = nodes.definition_list(classes=["topics"])
        for topic in names:
            label = topic_label(topic)
            term = nodes.term("", topic, ids=[label])
            self.env.get_domain("std").note_hyperlink_target(label, self.env.docname, label, topic)
            members = nodes.bullet_list()
            for problem in topics[topic]:
                members += nodes.list_item(
                    "",
                    nodes.paragraph(
                        "", "", self.link(problem, problem.number), nodes.Text(f" {problem.title}")
                    ),
                )
            entries += nodes.definition_list_item("", term, nodes.definition("", members))
        section += entries
        return section


def _forget(app, env, page):
    getattr(env, "workbook_listings", set()).discard(page)


def _add_script(app, page, template, context, doctree):
    if app.env.metadata.get(page, {}).get("problem_filter"):
        app.add_js_file("problem_filter.js", loading_method="defer")


def setup(app):
    app.connect("env-purge-doc", _forget)
    app.connect("html-page-context", _add_script)
    app.add_directive("problem-list", ProblemList)
    app.add_directive("topic-index", TopicIndex)

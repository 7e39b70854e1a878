"""Test problems of optimal control, from the records that are the library's tests.

`{control-problems} constrained` shows a section for each record of a table; `{control-problems-file}`
links to the same as JSON.
"""

import json
import sys

from docutils import nodes
from sphinx.util.docutils import SphinxDirective, SphinxRole

from trajlib.pontryagin.problem.presentation import problem_markdown
from workbook_site.downloads import link

#: The records, from the root of the repository, and the data file, from the root of the site.
FOLDER, FILE = "tests/library", "book/ch5/optimal_control_problems.json"


class ControlProblems(SphinxDirective):
    """Shows statement, arcs, times, cost, both routes, source and prints of a table of records."""

    required_arguments = 1

    def run(self):
        records = _records(self.env)
        self.env.note_dependency(records.__file__)
        return [
            self._section(name, records.data(name), records.record(name).problem)
            for name in getattr(records, self.arguments[0].upper())
        ]

    def _section(self, name, data, problem):
        section = nodes.section("", nodes.title("", name[0].upper() + name[1:]))
        section["ids"].append(f"control-problem-{nodes.make_id(name)}")
        section += self.parse_text_to_nodes(problem_markdown(problem))
        rows = {
            "Cost": data["cost"],
            "Arcs": ", ".join(map(_arc, data["arcs"] or [])),
            "Times": ", ".join(data["times"] or []),
            "Second route": data["route"],
            "Source": data["source"] or "made for these tests",
            "Printed": ", ".join(f"{value} ({where})" for where, value in data["published"]),
            "Refuted": ", ".join(f"{value} ({where})" for where, value in data["refuted"]),
        }
        fields = (
            nodes.field(
                "", nodes.field_name("", label), nodes.field_body("", nodes.paragraph("", text))
            )
            for label, text in rows.items()
            if text
        )
        section += nodes.field_list("", *fields)
        return section


class ControlProblemsFileRole(SphinxRole):
    """Links to the data file: {control-problems-file}`the same as a data file`."""

    def run(self):
        return [link(self.env.docname, FILE, self.text)], []


def _arc(kind):
    return kind if isinstance(kind, str) else " and ".join(kind)


def _records(env):
    folder = str(env.srcdir / FOLDER)
    sys.path.insert(0, folder)
    try:
        import optimal_control_records
    finally:
        sys.path.remove(folder)
    return optimal_control_records


def _write(app, exception):
    if exception is not None or app.builder.format != "html":
        return
    records = _records(app.env)
    path = app.outdir / FILE
    path.parent.mkdir(parents=True, exist_ok=True)
    table = {name: records.data(name) for name in records.NAMES}
    path.write_text(json.dumps(table, indent=1) + "\n", "utf-8")


def setup(app):
    app.add_directive("control-problems", ControlProblems)
    app.add_role("control-problems-file", ControlProblemsFileRole())
    app.connect("build-finished", _write)

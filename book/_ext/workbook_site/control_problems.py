"""Test problems of optimal control, from the registry of the library.

`{control-problems} constrained` shows a section for each problem of a group; `{control-problems-file}`
links to the data file.
"""

import shutil
from importlib.resources import as_file, files

from docutils import nodes
from sphinx.util.docutils import SphinxDirective, SphinxRole

from trajlib.pontryagin import problems
from trajlib.pontryagin.problem.presentation import problem_markdown
from workbook.site.downloads import link

#: The data file, in the package and from the root of the site.
DATA, FILE = files("trajlib.pontryagin") / "problems.json", "book/ch5/optimal_control_problems.json"


class ControlProblems(SphinxDirective):
    """Shows statement, arcs, times, cost, both routes, source and prints of a group of problems."""

    required_arguments = 1

    def run(self):
        self.env.note_dependency(str(DATA))
        known = map(problems, problems())
        return [self._section(one) for one in known if one.group == self.arguments[0]]

    def _section(self, known):
        section = nodes.section("", nodes.title("", known.name[0].upper() + known.name[1:]))
        section["ids"].append(f"control-problem-{nodes.make_id(known.name)}")
        section += self.parse_text_to_nodes(problem_markdown(known.problem))
        rows = {
            "Cost": known.digits,
            "Arcs": ", ".join(map(_arc, known.arcs or [])),
            "Times": ", ".join(f"{time:.10g}" for time in known.times or []),
            "Second route": known.route,
            "Source": known.source or "made for these tests",
            "Printed": ", ".join(f"{value} ({where})" for where, value in known.published),
            "Refuted": ", ".join(f"{value} ({where})" for where, value in known.refuted),
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


def _copy(app, exception):
    if exception is None and app.builder.format == "html":
        path = app.outdir / FILE
        path.parent.mkdir(parents=True, exist_ok=True)
        with as_file(DATA) as data:
            shutil.copy(data, path)


def setup(app):
    app.add_directive("control-problems", ControlProblems)
    app.add_role("control-problems-file", ControlProblemsFileRole())
    app.connect("build-finished", _copy)

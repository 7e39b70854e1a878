"""The page of the checks: what each accepts and rejects, from the tables of cases that are its
tests."""

import importlib.util
import re
import sys
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from workbook import checks
from workbook.checks.contract.encoding import describe
from workbook.checks.contract.reporting import MARKS
from workbook_site.docstrings import spans


class CheckCases(SphinxDirective):
    """A section a theme, a table a check, then the theme's known limits. What a check asks is
    told in the theme of its module, or else in the first that has cases of it; the others refer
    there."""

    def run(self):
        folder = Path(self.env.srcdir) / "tests" / "checks"
        self.env.note_dependency(str(folder / "case.py"))
        modules = {}
        for path in sorted((folder / "cases").glob("*/*.py")):
            self.env.note_dependency(str(path))
            modules[path] = _load(path, folder)
        homes = homes_of(modules)
        return [
            self._theme(module, path.stem, {name for name in homes if homes[name] == path})
            for path, module in modules.items()
        ]

    def _theme(self, module, theme, at_home):
        section = nodes.section(
            "",
            nodes.title("", theme.replace("_", " ").capitalize()),
            ids=[f"checks-{theme.replace('_', '-')}"],
        )
        for name in dict.fromkeys(case.check for case in module.CASES):
            shown = nodes.literal("", f"checks.{name}")
            if name in at_home:
                purpose, *more = (
                    " ".join(part.split()) for part in getattr(checks, name).__doc__.split("\n\n")
                )
                anchor = nodes.target("", "", ids=[f"check-{name}"])
                section += nodes.paragraph("", "", anchor, shown, *spans(f": {purpose}"))
                section += [
                    nodes.paragraph("", "", *spans(part))
                    for part in more
                    if part.startswith("Data: ")
                ]
            else:
                section += nodes.paragraph(
                    "", "", nodes.reference("", "", shown, refid=f"check-{name}", internal=True)
                )
            section += _table([case for case in module.CASES if case.check == name])
        section += nodes.paragraph("", "", nodes.strong("", "Known limits"))
        limits = (
            nodes.list_item("", nodes.paragraph("", "", *spans(limit))) for limit in module.LIMITS
        )
        section += nodes.bullet_list("", *limits)
        return section


def homes_of(modules):
    """The file, of those in which a check has cases, where it is told what it asks, by the names of
    the checks."""
    homes = {}
    for path, module in modules.items():
        for name in {case.check for case in module.CASES}:
            if getattr(checks, name).__module__.split(".")[-2:] == [path.parent.name, path.stem]:
                homes[name] = path
            homes.setdefault(name, path)
    return homes


def _table(cases):
    body = nodes.tbody()
    for case in cases:
        # a matrix stands on one line
        text = re.sub(r"\[\s+", "[", " ".join(describe(case.answer).split()))
        shown = text if len(text) <= 90 else text[:87] + "..."
        verdict = f"{MARKS[case.verdict]}\N{NO-BREAK SPACE}{case.verdict}"
        cells = ([nodes.Text(verdict)], [nodes.literal("", shown)], spans(case.note))
        body += nodes.row("", *(nodes.entry("", nodes.paragraph("", "", *cell)) for cell in cells))
    head = nodes.thead(
        "",
        nodes.row(
            "",
            *(
                nodes.entry("", nodes.paragraph("", name))
                for name in ("verdict", "answer", "what it is")
            ),
        ),
    )
    widths = (nodes.colspec(colwidth=width) for width in (15, 45, 40))
    return nodes.table("", nodes.tgroup("", *widths, head, body, cols=3), classes=["check-cases"])


def _load(path, folder):
    """A table imports `Case` from the folder of the tests."""
    sys.path.insert(0, str(folder))
    try:
        spec = importlib.util.spec_from_file_location(f"cases_{path.parent.name}_{path.stem}", path)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module
    finally:
        sys.path.remove(str(folder))


def setup(app):
    app.add_directive("check-cases", CheckCases)

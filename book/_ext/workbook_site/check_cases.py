"""The page of the checks: accepted and rejected answers, from their tables of tests."""

import importlib.util
import re
import sys
from operator import attrgetter
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from workbook import checks
from workbook.checks.contract.encoding import describe
from workbook.checks.contract.reporting import MARKS
from workbook_site.docstrings import spans


class CheckCases(SphinxDirective):
    """Shows a section for each theme: a table for each check, then the known limits.

    A check is described in the theme of its module, or else in the first that has cases of it; the
    others refer there.
    """

    def run(self):
        folder = Path(self.env.srcdir) / "tests" / "checks"
        self.env.note_dependency(str(folder / "case.py"))
        modules = {}
        for path in sorted((folder / "cases").glob("*/*.py")):
            self.env.note_dependency(str(path))
            modules[path] = _load(path, folder)
        described_in = find_descriptions(modules)
        return [
            self._theme(
                module, path.stem, {name for name in described_in if described_in[name] == path}
            )
            for path, module in modules.items()
        ]

    def _theme(self, module, theme, described):
        section = nodes.section(
            "",
            nodes.title("", theme.replace("_", " ").capitalize()),
            ids=[f"checks-{theme.replace('_', '-')}"],
        )
        for name in dict.fromkeys(case.check for case in module.CASES):
            code = nodes.literal("", f"checks.{name}")
            if name in described:
                purpose, *more = _paragraphs(attrgetter(name)(checks).__doc__)
                anchor = nodes.target("", "", ids=[_anchor(name)])
                section += nodes.paragraph("", "", anchor, code, *spans(f": {purpose}"))
                section += [nodes.paragraph("", "", *spans(part)) for part in more]
            else:
                section += nodes.paragraph(
                    "", "", nodes.reference("", "", code, refid=_anchor(name), internal=True)
                )
            section += _table([case for case in module.CASES if case.check == name])
        if module.LIMITS:
            section += nodes.paragraph("", "", nodes.strong("", "Known limits"))
            limits = (
                nodes.list_item("", nodes.paragraph("", "", *spans(limit)))
                for limit in module.LIMITS
            )
            section += nodes.bullet_list("", *limits)
        return section


def _paragraphs(docstring):
    """Return the paragraphs of a check's docstring, the parameters after the answer as the last."""
    text, _, parameters = docstring.partition("    Parameters\n")
    shapes = (line.strip().partition(" : ") for line in parameters.splitlines()[2:])
    data = "; ".join(f"`{name}`: {shape}" for name, _, shape in shapes if shape)
    paragraphs = [" ".join(part.split()) for part in text.strip().split("\n\n")]
    return [*paragraphs, *([f"Data: {data}."] if data else [])]


def _anchor(name):
    return f"check-{name.replace('.', '-')}"


def find_descriptions(modules):
    """Return check name -> the file of cases in whose section the check is described."""
    described_in = {}
    for path, module in modules.items():
        for name in {case.check for case in module.CASES}:
            if attrgetter(name)(checks).__module__.split(".")[-2:] == [path.parent.name, path.stem]:
                described_in[name] = path
            described_in.setdefault(name, path)
    return described_in


def _table(cases):
    body = nodes.tbody()
    for case in cases:
        # a matrix is written on one line
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
    """Import a table of cases; it imports `Case` from the folder of the tests."""
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

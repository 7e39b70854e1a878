"""Accepted and rejected answers, from the tables of tests of the checks.

`{what-counts}` shows students twenty rows, `{check-cases} structure` a theme to contributors.
"""

import importlib.util
import re
import sys
from operator import attrgetter
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from trajlib.typesetting import typeset
from workbook import checks
from workbook.checks.contract.encoding import describe
from workbook.checks.contract.reporting import MARKS
from workbook_site.docstrings import spans

#: The folder of the rows for students.
GUIDE = "guide"


class CheckCases(SphinxDirective):
    """Shows a section for each module of a theme: a table for each check, then the known limits.

    A check is described in the section of its module, or else in the first that has cases of it; the
    others refer there.
    """

    required_arguments = 1

    def run(self):
        modules = {
            path: module for path, module in _modules(self.env).items() if path.parent.name != GUIDE
        }
        described_in = find_descriptions(modules)
        return [
            self._section(module, path, described_in)
            for path, module in modules.items()
            if path.parent.name == self.arguments[0]
        ]

    def _section(self, module, path, described_in):
        theme = path.stem
        section = nodes.section(
            "",
            nodes.title("", theme.replace("_", " ").capitalize()),
            ids=[f"checks-{theme.replace('_', '-')}"],
        )
        for name in dict.fromkeys(case.check for case in module.CASES):
            code = nodes.literal("", f"checks.{name}")
            home = described_in[name]
            if home == path:
                purpose, *more = _paragraphs(attrgetter(name)(checks).__doc__)
                anchor = nodes.target("", "", ids=[_anchor(name)])
                section += nodes.paragraph("", "", anchor, code, *spans(f": {purpose}"))
                section += [nodes.paragraph("", "", *spans(part)) for part in more]
            else:
                address = f"{home.parent.name}.html#{_anchor(name)}"
                reference = nodes.reference("", "", code, refuri=address, internal=True)
                section += nodes.paragraph("", "", reference)
            rows = [case for case in module.CASES if case.check == name]
            for words in dict.fromkeys(map(_words, rows)):
                if words:
                    section += nodes.paragraph(
                        "", "With ", nodes.literal("", words), nodes.Text(":")
                    )
                section += _table([case for case in rows if _words(case) == words])
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
    shapes = (
        line.strip().partition(" : ") for line in parameters.partition("\n\n")[0].splitlines()[2:]
    )
    data = "; ".join(f"`{name}`: {shape}" for name, _, shape in shapes if shape)
    paragraphs = [" ".join(part.split()) for part in text.strip().split("\n\n")]
    return [*paragraphs, *([f"Data: {data}."] if data else [])]


def _words(case):
    """Return the options of a row that are words: they say what is asked for."""
    return ", ".join(f'{name}="{x}"' for name, x in case.options if isinstance(x, str))


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


class WhatCounts(SphinxDirective):
    """Shows the rows for students: a table for each question."""

    def run(self):
        (module,) = (
            module for path, module in _modules(self.env).items() if path.parent.name == GUIDE
        )
        shown = []
        for question, cases in module.QUESTIONS.items():
            title = f"<p><strong>{typeset(question)}</strong></p>"
            shown += [nodes.raw("", title, format="html"), _table(cases)]
        return shown


def _modules(env):
    """Return the tables of cases by their paths, and make the page depend on them."""
    folder = Path(env.srcdir) / "tests" / "checks"
    paths = sorted((folder / "cases").glob("*/*.py"))
    for path in (folder / "case.py", *paths):
        env.note_dependency(str(path))
    return {path: _load(path, folder) for path in paths}


def _table(cases):
    body = nodes.tbody()
    for case in cases:
        # a matrix is written on one line
        text = re.sub(r"\[\s+", "[", " ".join(describe(case.answer).split()))
        shown = text if len(text) <= 90 else text[:87] + "..."
        # data that are refused have no verdict
        verdict = f"{MARKS.get(case.verdict, '')}\N{NO-BREAK SPACE}{case.verdict}".strip()
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
    app.add_directive("what-counts", WhatCounts)

"""Arrows that import-linter does not see: names of modules in strings and in tables of lazy names."""

import ast
import importlib
import re
from pathlib import Path

import pytest
from importlinter import configuration
from importlinter.application import use_cases
from importlinter.application.app_config import settings

from trajlib._lazy import home_of
from trajlib._stubs import lazy_packages

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = ("trajlib", "workbook")
#: A whole string such as "workbook.live.lab" or "workbook.live.lab:start".
NAME = re.compile(r"((?:trajlib|workbook)(?:\.\w+)+)(?::\w+)?")
#: Upward, and meant: a forkserver's list of all that it may start.
MEANT = {
    ("workbook.grading.sandbox.forkserver", "workbook.grading.pool.worker_pool"),
    ("workbook.grading.sandbox.forkserver", "workbook.grading.sandbox.notebook_worker"),
}

configuration.configure()


def modules_in_strings(source):
    """Return the names of our modules in the strings of a source, but for its docstrings."""
    tree = ast.parse(source)
    prose = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    texts = [
        node.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in prose
    ]
    return {match[1] for match in map(NAME.fullmatch, texts) if match}


def hidden_imports(modules):
    """Return the pairs (importer, imported) among the names of our modules."""
    pairs = set()
    for importer in modules:
        if importer.split(".")[0] in PACKAGES:
            path = ROOT.joinpath(*importer.split("."))
            path = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
            pairs |= {(importer, name) for name in modules_in_strings(path.read_text("utf-8"))}
    for package in (name for root in PACKAGES for name in lazy_packages(root)):
        for name in importlib.import_module(package)._lazy_home:
            pairs.add((package, home_of(package, name)))
    return {(importer, imported) for importer, imported in pairs if imported in modules}


def broken_contracts(more, capsys):
    """Return the names of the contracts of pyproject.toml that break with more imports."""

    class WithMore(type(settings.GRAPH_BUILDER)):
        def build(self, **options):
            graph = super().build(**options)
            for importer, imported in more(graph.modules):
                graph.add_import(importer=importer, imported=imported)
            return graph

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(settings, "GRAPH_BUILDER", WithMore())
        kept = use_cases.lint_imports(str(ROOT / "pyproject.toml"), cache_dir=None, no_logo=True)
    shown = capsys.readouterr().out
    assert kept == (" 0 broken." in shown), shown
    return re.findall(r"^(.*) BROKEN", shown, re.M)


def test_hidden_imports_keep_the_contracts(capsys):
    assert broken_contracts(lambda modules: hidden_imports(modules) - MEANT, capsys) == []


@pytest.mark.parametrize("pair", sorted(MEANT))
def test_what_is_meant_points_upward(pair, capsys):
    assert broken_contracts(lambda modules: hidden_imports(modules) & {pair}, capsys) != []


def test_a_hidden_circle_is_found(capsys):
    circle = {("workbook.checks", "workbook.mistakes")}
    assert broken_contracts(lambda modules: circle, capsys) == [
        "The course machinery in layers",
        "No circle among packages",
    ]


@pytest.mark.parametrize(
    ("source", "names"),
    [
        ('"""workbook.checks"""', set()),
        ('load("workbook.checks")', {"workbook.checks"}),
        (
            'ALLOWED = "workbook.grading.pool.worker_pool:run"',
            {"workbook.grading.pool.worker_pool"},
        ),
        ('{"workbook.mistakes.reporting": ["report"]}', {"workbook.mistakes.reporting"}),
        ('say("see workbook.checks for more")', set()),
        ("import workbook.checks", set()),
    ],
)
def test_names_in_strings(source, names):
    assert modules_in_strings(source) == names

"""The import closure of code holds all modules that are loaded when it runs."""

import ast
import hashlib
import importlib
import subprocess
import sys
from pathlib import Path

import pytest

import workbook.checks.stability.regions as regions
from workbook.notebooks import dependencies
from workbook.notebooks.dependencies import module_closure

PIECES = [
    "from workbook import checks\nchecks.stability_region",
    "from workbook import checks\nchecks.basin_estimate\nchecks.report",
    "from workbook import checks\nchecks.research.support_values",
    "from trajlib.stability import linearise\nlinearise",
    "from trajlib.stability import basin_estimate, hurwitz_minors",
    "from trajlib import plotting, stability\nplotting.style\nstability.limit_cycles",
    "import workbook.notebooks.execution",
]


@pytest.mark.parametrize("code", PIECES)
def test_the_closure_holds_all_that_is_loaded(code):
    show = "import sys; print(' '.join(m for m in sys.modules if m.startswith(('trajlib.', 'workbook.'))))"
    loaded = subprocess.run(
        [sys.executable, "-c", f"{code}\n{show}"],
        capture_output=True,
        text=True,
        check=True,
        timeout=120,
    ).stdout.split()
    # Packages hold lazy and former names, hooks or a docstring: they and the helpers behind them say nothing of
    # what a notebook computes.
    expected = {m for m in loaded if not hasattr(importlib.import_module(m), "__path__")} - {
        "trajlib._lazy",
        "workbook.checks.contract.former_checks",
        dependencies.HOOKS,
    }
    assert expected and expected <= set(module_closure(code))


def test_a_report_depends_on_what_its_hook_calls():
    modules = module_closure("from workbook import checks\nchecks.report")
    assert {dependencies.HOOKS, "workbook.mistakes", "workbook.mistakes.sealing"} <= set(modules)


def test_parsing_imports_only_misses_none(monkeypatch):
    """Of each module as many as by its whole tree, or more: code in a text counts too."""
    modules = {
        ".".join(path.relative_to(dependencies.ROOT).with_suffix("").parts): path
        for package in dependencies.PACKAGES
        for path in (dependencies.ROOT / package).rglob("*.py")
        if path.name != "__init__.py"
    }
    imports_only = {
        name: dependencies._loaded_by.__wrapped__(name, path) for name, path in modules.items()
    }
    monkeypatch.setattr(dependencies, "_parse_imports", ast.parse)
    dependencies._loaded_by.cache_clear()
    whole = {
        name: dependencies._loaded_by.__wrapped__(name, path) for name, path in modules.items()
    }
    dependencies._loaded_by.cache_clear()
    assert not {name: missed for name in modules if (missed := whole[name] - imports_only[name])}
    assert sum(imports_only[name] != whole[name] for name in modules) < 5, "or it saves nothing"


@pytest.mark.parametrize(
    "source, expected",
    [
        (
            "from workbook.notebooks.cells import (\n    prepare,\n    run_cells,\n)",
            {"workbook.notebooks.cells"},
        ),
        (
            "def f():\n    from workbook.notebooks.cells import prepare  # here",
            {"workbook.notebooks.cells"},
        ),
        ("import json, workbook.notebooks.cells", {"workbook.notebooks.cells"}),
        (
            '"""Words that\nimport nothing at all.\n"""\nimport workbook.notebooks.cells',
            {"workbook.notebooks.cells"},
        ),
        ("from .cells import prepare", {"workbook.notebooks.cells"}),
    ],
)
def test_forms_of_import_statements(source, expected):
    assert dependencies._loaded(source, "workbook.notebooks") == expected


def test_unused_themes_are_left_out():
    closure = module_closure("from workbook import checks\nchecks.stability_region")
    assert (
        "workbook.checks.stability.cycles" not in closure
        and "trajlib.stability.hurwitz" not in closure
    )


def test_the_hash_is_that_of_the_text():
    text = Path(regions.__file__).read_bytes()
    assert (
        module_closure("from workbook import checks\nchecks.stability_region")[
            "workbook.checks.stability.regions"
        ]
        == hashlib.sha256(text).hexdigest()
    )


def test_fingerprints_are_computed_without_loading_the_checks():
    """Who grades reads this of every problem, before anything is computed."""
    code = (
        "import sys\nfrom workbook.notebooks import exercises\nfrom workbook.grading.pool.fingerprint "
        "import fingerprint\n"
        "for exercise in exercises.read_all(): fingerprint(exercise)\n"
        "print([name for name in ('sympy', 'numpy', 'z3') if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert done.stdout == "[]\n", done.stdout + done.stderr

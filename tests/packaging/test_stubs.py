"""The type stubs of the lazy packages: equal to their tables, and seen by mypy."""

import importlib
import pkgutil
import subprocess
import sys

import pytest

import trajlib._stubs
import workbook._stubs
from trajlib._stubs import lazy_packages, stub_path

PACKAGES = [
    (package, writer)
    for root, writer in (("trajlib", trajlib._stubs), ("workbook", workbook._stubs))
    for package in lazy_packages(root)
]


@pytest.mark.parametrize(("package", "writer"), PACKAGES)
def test_stub_is_that_of_the_table(package, writer):
    stub = stub_path(package)
    assert stub.exists() and stub.read_text(encoding="utf-8") == writer.stub_text(package), (
        f"the stub is stale: run `python -m {writer.__name__}`"
    )


@pytest.mark.parametrize("package", [package for package, _ in PACKAGES if package != "trajlib"])
def test_no_module_has_the_name_of_an_export(package):
    """Importing such a module would put it in the place of the function or class."""
    modules = pkgutil.iter_modules(importlib.import_module(package).__path__)
    lazy = importlib.import_module(package)._lazy_home
    assert not {module.name for module in modules} & set(lazy)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("program", "expected"),
    [
        (
            "import trajlib\n"
            "from trajlib.stability import equilibria, no_such_name\n"
            "trajlib.estimation.least_squares([[1]], [1])\n"
            "trajlib.no_such_module\n",
            [
                'Module "trajlib.stability" has no attribute "no_such_name"  [attr-defined]',
                'Module has no attribute "no_such_module"  [attr-defined]',
            ],
        ),
        (
            "from workbook import checks\n"
            "checks.report('1.15', a=checks.stability_region(1, 2, [3]))\n"
            "checks.stability_region(1, 2)\n"
            "checks.research.support_values(1, 2, 3, 4).points\n"
            "checks.no_such_check\n",
            [
                'Missing positional argument "parameters" in call to "stability_region"  [call-arg]',
                '"Verdict" has no attribute "points"  [attr-defined]',
                'Module has no attribute "no_such_check"  [attr-defined]',
            ],
        ),
    ],
    ids=["trajlib", "workbook"],
)
def test_mypy_knows_the_lazy_names(program, expected, tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "program.py").write_text(program)
    run = subprocess.run(
        [sys.executable, "-m", "mypy", "--follow-imports=silent", tmp_path / "program.py"],
        capture_output=True,
        text=True,
        timeout=300,
    )
    errors = [line.partition(": error: ")[2] for line in run.stdout.splitlines()[:-1]]
    assert errors == expected, run.stdout + run.stderr

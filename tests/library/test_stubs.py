"""The type stubs of the lazy packages: equal to their tables, and seen by mypy."""

import importlib
import pkgutil
import subprocess
import sys

import pytest

from trajlib import _stubs

PACKAGES = _stubs.lazy_packages()


@pytest.mark.parametrize("package", PACKAGES)
def test_stub_is_that_of_the_table(package):
    stub = _stubs.stub_path(package)
    assert stub.exists() and stub.read_text(encoding="utf-8") == _stubs.stub_text(package), (
        "the stub is stale: run `python -m trajlib._stubs`"
    )


@pytest.mark.parametrize("package", PACKAGES[1:])
def test_no_module_has_the_name_of_an_export(package):
    """Importing such a module would put it in the place of the function or class."""
    modules = pkgutil.iter_modules(importlib.import_module(package).__path__)
    assert not {module.name for module in modules} & set(dir(importlib.import_module(package)))


@pytest.mark.slow
def test_mypy_knows_the_lazy_names(tmp_path):
    pytest.importorskip("mypy")
    program = tmp_path / "program.py"
    program.write_text(
        "import trajlib\n"
        "from trajlib.stability import equilibria, no_such_name\n"
        "trajlib.estimation.least_squares([[1]], [1])\n"
        "trajlib.no_such_module\n"
    )
    run = subprocess.run(
        [sys.executable, "-m", "mypy", "--follow-imports=silent", str(program)],
        capture_output=True,
        text=True,
        timeout=300,
    )
    errors = [line.partition(": error: ")[2] for line in run.stdout.splitlines()[:-1]]
    assert errors == [
        'Module "trajlib.stability" has no attribute "no_such_name"  [attr-defined]',
        'Module has no attribute "no_such_module"  [attr-defined]',
    ], run.stdout + run.stderr

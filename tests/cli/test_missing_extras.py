"""The command where an extra is not installed: one line, exit code 2, no traceback."""

import subprocess
import sys

import pytest

pytestmark = pytest.mark.slow
LIVE = "JupyterLab is not installed here; `pip install 'trajlib[live]'` in the checkout gets it"


def workbook(missing, *arguments):
    """Run the command in a process that cannot import some modules."""
    code = (
        "import runpy, sys\n"
        f"sys.modules |= dict.fromkeys({missing!r})\n"
        f"sys.argv = {['workbook', *arguments]!r}\n"
        "runpy.run_module('workbook', run_name='__main__', alter_sys=True)"
    )
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=False
    )


@pytest.mark.parametrize(
    "missing, arguments, message",
    [
        (["typer"], ["problems"], 'typer is missing; pip install "trajlib[workbook]"'),
        (["rich"], ["--help"], 'rich is missing; pip install "trajlib[workbook]"'),
        (["z3"], ["check", "x.ipynb"], 'z3 is missing; pip install "trajlib[workbook]"'),
        (["IPython"], ["problems"], 'IPython is missing; pip install "trajlib[workbook]"'),
        (["yaml", "flint"], ["live"], 'yaml, flint are missing; pip install "trajlib[workbook]"'),
        (["jupytext"], ["solve", "1.15"], 'jupytext is missing; pip install "trajlib[author]"'),
        (["jupyterlab"], ["live", "1.15"], LIVE),
        (["ipywidgets"], ["live", "1.15"], LIVE),
    ],
)
def test_one_line_names_what_to_install(missing, arguments, message):
    done = workbook(missing, *arguments)
    assert done.stderr == f"workbook: {message}\n"
    assert done.returncode == 2 and done.stdout == ""


def test_the_module_runs_as_the_command():
    done = workbook([], "--help")
    assert done.returncode == 0 and "Usage" in done.stdout

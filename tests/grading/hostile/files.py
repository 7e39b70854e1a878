"""Submissions that are broken files, or whose names are commands, paths or formulas."""

import json
import os

from hostile.attack import WRONG, Attack, gained, marked, stopped_the_run, with_cells, write

NESTED = 100_000


def _bytes(content):
    return lambda folder: (folder / "p15.ipynb").write_bytes(content)


def _huge(folder):
    with open(folder / "p15.ipynb", "wb") as file:
        file.truncate(5 * 2**30)  # a sparse file takes no disk


def _with(**changes):
    return lambda folder: write(folder / "p15.ipynb", with_cells([WRONG]) | changes)


def _odd_sources():
    sources = [["x = '\ud800'\n", "y = 1"], "a\0b", [1, {}, "z = 2"]]
    return with_cells([WRONG])["cells"][:3] + [
        {"cell_type": "code", "metadata": {}, "source": source} for source in sources
    ]


def _named(name):
    """Return a submission whose file has the name `name(student)`, as bytes or text."""
    return lambda folder: write(folder / os.fsdecode(name(folder.parent.name)), with_cells([WRONG]))


def _options(folder):
    write(folder / "p15.ipynb", with_cells([WRONG + " # " + "x" * 50_000]))
    (folder / "--checkpoint=1").touch()
    (folder / "--checkpoint-action=exec=sh run.sh").touch()
    (folder / "run.sh").write_text(f"touch ../../../marks/{folder.parent.name}")


FILES = [
    Attack(
        "is empty",
        "hands in an empty file",
        "reading it is an error",
        "it is said to be no notebook",
        stopped_the_run,
        files=_bytes(b""),
    ),
    Attack(
        "is broken",
        "hands in half a notebook",
        "reading it is an error",
        "it is said to be no notebook",
        stopped_the_run,
        files=_bytes(json.dumps(with_cells([WRONG])).encode()[:2000]),
    ),
    Attack(
        "is not text",
        "hands in text that is not UTF-8",
        "reading it is an error",
        "it is said to be no notebook",
        stopped_the_run,
        files=_bytes('{"cells": [], "name": "Müller"}'.encode("latin-1")),
    ),
    Attack(
        "is an archive",
        "hands in a compressed file by the name of a notebook",
        "reading it is an error",
        "it is said to be no notebook",
        stopped_the_run,
        files=_bytes(b"PK\x03\x04" + bytes(range(256)) * 100),
    ),
    Attack(
        "is huge",
        "hands in a file of five gigabytes",
        "reading it takes all memory",
        "its size is looked at first",
        stopped_the_run,
        files=_huge,
    ),
    Attack(
        "is nested",
        "hands in brackets in brackets",
        "the reader's stack ends",
        "it is said to be no notebook",
        stopped_the_run,
        files=_bytes(b"[" * NESTED + b"]" * NESTED),
    ),
    Attack(
        "is another JSON",
        "hands in JSON that is no notebook",
        "reading it is an error",
        "it is said to be no notebook",
        stopped_the_run,
        files=_bytes(b'[1, 2, {"cells": 3}]'),
    ),
    Attack(
        "has odd cells",
        "hands in cells that are no cells",
        "reading them is an error",
        "it is said to be no notebook",
        stopped_the_run,
        files=_with(
            cells=[5, None, {"cell_type": "code", "source": {"a": 1}}, {"cell_type": "code"}]
        ),
    ),
    Attack(
        "has odd metadata",
        "hands in metadata that is a list",
        "reading it is an error",
        "its other parts are used",
        stopped_the_run,
        files=_with(metadata=[1, 2]),
    ),
    Attack(
        "has odd sources",
        "hands in sources of numbers, half characters and null bytes",
        "joining them is an error",
        "what is text is run",
        stopped_the_run,
        files=_with(cells=_odd_sources()),
    ),
    Attack(
        "has a command for a name",
        "hands in a file whose name is a command in brackets",
        "the name is put into a command line",
        "no shell is used",
        marked,
        files=_named(lambda student: f"p15$(cd marks; touch {student}).ipynb"),
    ),
    Attack(
        "has quotes in its name",
        "hands in a file whose name ends a command and begins another",
        "the name is put into a command line",
        "no shell is used",
        marked,
        files=_named(lambda student: f"p15';cd marks;touch {student};echo '.ipynb"),
    ),
    Attack(
        "has options for names",
        "hands in files whose names are options of tar",
        "all files are given to tar by a star",
        "no shell is used",
        marked,
        files=_options,
    ),
    Attack(
        "has a line in its name",
        "hands in a file whose name is a line of the table",
        "the name is written into the table as it is",
        "names are escaped",
        gained,
        files=_named(lambda student: f"p15\n{student},1,.ipynb"),
    ),
    Attack(
        "has no text for a name",
        "hands in a file whose name is no text",
        "writing the name is an error",
        "names are escaped",
        stopped_the_run,
        files=_named(lambda student: b"p15-\xff\xfe.ipynb"),
    ),
    Attack(
        "has the longest of names",
        "hands in a file with as long a name as there can be",
        "a name made from it is too long",
        "no name is made from it",
        stopped_the_run,
        files=_named(lambda student: "p15" + "x" * 246 + ".ipynb"),
    ),
]

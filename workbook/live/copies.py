"""The copy that the class sees: a notebook with statement, data and drawing, the solution a step
away.

It is made of the student's notebook, which holds no solution; what the answers are is asked of the
magics, whose cells stand where the student would work.
"""

import json
import re
import shutil
import sys
from pathlib import Path

from workbook.live.subjects import LiveError
from workbook.notebooks import exercises

#: Of jupyterlab-rise: a theme that asks no other host for its letters.
SLIDES = {"theme": "white", "scroll": True, "center": False, "width": "100%", "height": "100%"}


def notebook_of(subject):
    """The notebook of a subject, in nbformat 4.5, as a dict."""
    if subject.is_lecture:
        from workbook.live.lectures import cells_of

        cells = cells_of(subject.path)
    else:
        cells = _problem_cells(json.loads(subject.path.read_text(encoding="utf-8"))["cells"])
    for k, cell in enumerate(cells):
        cell["id"] = f"live-{k:03d}"
    return {
        "cells": cells,
        "nbformat": 4,
        "nbformat_minor": 5,
        "metadata": {
            "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
            "language_info": {"name": "python"},
            "live": {"subject": subject.word},
            "rise": SLIDES,
        },
    }


def code(source, **metadata):
    return {
        "cell_type": "code",
        "execution_count": None,
        "metadata": metadata,
        "outputs": [],
        "source": source,
    }


def markdown(source, **metadata):
    return {"cell_type": "markdown", "metadata": metadata, "source": source}


def _problem_cells(students):
    """The cells of a student's notebook without its first words, hints and stubs; magics take their
    places."""
    from workbook.checks.contract.check_cells import reported_names

    cells = []
    for cell in students[2:]:
        source, tags = "".join(cell["source"]), cell["metadata"].get("tags", [])
        if "answer" in tags:
            # below what it is, where this is long
            first = re.search(r"^(\w+) = \.\.\.", source, re.MULTILINE)
            cells.append(code(f"%answer {first[1]}"))
        elif "check" in tags:
            cells += [code(f"%check {name}") for name in reported_names(source)]
        elif cell["cell_type"] == "code":
            cells.append(code(source))
        elif not source.startswith("<details><summary>Hint "):
            kept = {key: cell[key] for key in ("attachments",) if key in cell}
            cells.append(markdown(source) | kept)
    return cells


def settle(copy, before, name, keep, discard):
    """After the lecture: what becomes of a copy that was worked on (`before` is what it was).

    `keep` is a path to keep it at; without it or `discard` the lecturer is asked, and where nobody
    can answer it is kept beside. Returns where it is kept, or None.
    """
    if discard or not copy.exists() or (keep is None and copy.read_bytes() == before):
        return None
    if keep is None and sys.stdin.isatty():
        said = input(
            "Keep the notebook of this lecture? A file name keeps it, Enter throws it away: "
        ).strip()
        if not said:
            return None
        keep = Path(said)
    return _kept(copy, keep if keep is not None else Path(f"live-{name}.ipynb"))


def _kept(copy, path):
    path = path.expanduser()
    if path.is_dir():
        path /= copy.name
    path = path if path.suffix == ".ipynb" else path.with_name(path.name + ".ipynb")
    hold_outside(path)
    stem = re.sub(r"-\d+$", "", path.stem)
    k = 2
    while path.exists():  # an earlier lecture is not written over
        path, k = path.with_name(f"{stem}-{k}.ipynb"), k + 1
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(copy, path)
    except OSError as error:
        raise LiveError(
            f"{path} cannot be written: {error.strerror}; the notebook is still {copy}"
        ) from None
    return path


def hold_outside(path):
    """Raises `LiveError` for a place among the masters or the students' notebooks."""
    place = path.expanduser().resolve()
    for room in ("solutions", "exercises", "book"):
        if place.is_relative_to(exercises.CHECKOUT / room):
            raise LiveError(
                f"{path} stands among the workbook's own files; keep the copy elsewhere"
            )

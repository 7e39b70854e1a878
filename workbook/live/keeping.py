"""Keep the notebook of a lecture when the lecture ends, or throw it away."""

import re
import shutil
import sys
from pathlib import Path

from workbook.course import courses
from workbook.live.errors import LiveError

#: What a course keeps in them is not overwritten by a copy.
OWN_FOLDERS = ("solutions", "exercises", "book", "lectures")


def keep_notebook(notebook, original, name, keep=None, discard=False):
    """Copy the notebook of a lecture that has ended to where the lecturer keeps it.

    Without `keep` and `discard` the lecturer is asked; where there is no terminal to ask at, the
    notebook is kept in the working folder.

    Parameters
    ----------
    notebook : pathlib.Path
        The notebook, which will be removed with its folder.
    original : bytes
        Its content when the lecture began; an unchanged notebook is not kept.
    name : str
        Name of the presentation, for the name of the file.
    keep : pathlib.Path, optional
        File or folder to keep it in.
    discard : bool
        Whether it is thrown away without asking.

    Returns
    -------
    pathlib.Path or None
        The file that was written, if any; an earlier one is not overwritten.

    Raises
    ------
    LiveError
        If the destination is among the workbook's own files or cannot be written.
    """
    if discard or not notebook.exists() or (keep is None and notebook.read_bytes() == original):
        return None
    if keep is None and sys.stdin.isatty():
        reply = input(
            "Keep the notebook of this lecture? A file name keeps it, Enter throws it away: "
        ).strip()
        if not reply:
            return None
        keep = Path(reply)
    return _copy(notebook, keep if keep is not None else Path(f"live-{name}.ipynb"))


def _copy(notebook, path):
    path = path.expanduser()
    if path.is_dir():
        path /= notebook.name
    path = path if path.suffix == ".ipynb" else path.with_name(path.name + ".ipynb")
    validate_destination(path)
    stem = re.sub(r"-\d+$", "", path.stem)
    k = 2
    while path.exists():
        path, k = path.with_name(f"{stem}-{k}.ipynb"), k + 1
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(notebook, path)
    except OSError as error:
        raise LiveError(
            f"{path} cannot be written: {error.strerror}; the notebook is still {notebook}"
        ) from None
    return path


def validate_destination(path):
    """Raise `LiveError` for a path among the masters or the student notebooks."""
    absolute = path.expanduser().resolve()
    for course in courses():
        if any(absolute.is_relative_to(course.folder / name) for name in OWN_FOLDERS):
            raise LiveError(f"{path} is one of the course's own files; keep the copy elsewhere")

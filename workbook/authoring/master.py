"""Read a master, page and trials, and validate its contract."""

import ast
from dataclasses import dataclass
from pathlib import Path

from workbook.authoring.contract import (
    validate_blocks,
    validate_code,
    validate_drawings,
    validate_front_matter,
)
from workbook.authoring.errors import MasterError
from workbook.authoring.front_matter import read_front_matter
from workbook.authoring.trials import numbers_section, read_trials, trials_file
from workbook.numbering import files_by_number

ROLES = ("data", "drawing", "answer", "figure", "check")


@dataclass(frozen=True)
class Answer:
    """An answer variable.

    Attributes
    ----------
    name : str
        Its name, such as a_region.
    kind : str
        Its TYPE.
    text : str
        What it is.
    exact : bool
        Whether decimals are refused.
    """

    name: str
    kind: str
    text: str
    exact: bool


@dataclass(frozen=True)
class Cell:
    """A cell of a master.

    Attributes
    ----------
    role : str
        One of `ROLES` for code, "" for Markdown.
    source : str
        Its text.
    line : int
        Line of the file where the text begins, from 1.
    """

    role: str
    source: str
    line: int


@dataclass(frozen=True)
class Master:
    """A problem: its page and its trials.

    Attributes
    ----------
    path : pathlib.Path
        File of the page.
    number, title, section, level : str
        From the front matter.
    topics : tuple of str
        From the front matter.
    answers : dict of Answer
        The answers by name, in order.
    hints : dict of tuple of str
        The hints by answer.
    cells : tuple of Cell
        The cells of the page.
    trials : dict of list of Trial
        The trials under "wrong" and "right".
    core : tuple of str
        The core items of a long problem.
    numbers : str
        The section of the trials file with rows of numbers (`workbook.authoring.numbers`), or "".
    """

    path: Path
    number: str
    title: str
    section: str
    level: str
    topics: tuple
    answers: dict
    hints: dict
    cells: tuple
    trials: dict
    core: tuple = ()
    numbers: str = ""

    def code(self, *roles):
        """Return the sources of the code cells with one of the roles, in order."""
        return [cell.source for cell in self.cells if cell.role in roles]

    @property
    def exercise(self):
        """The file of the student notebook, exercises/ch1/p15.ipynb beside solutions/."""
        return (
            self.path.parent.parent.parent
            / "exercises"
            / self.path.parent.name
            / f"{self.path.stem}.ipynb"
        )


def master_paths(solutions):
    """Return the files of all masters below a folder, in the order of their numbers."""
    return files_by_number(solutions, ".md")


def read_all(solutions):
    """Return all masters below a folder, in the order of their numbers."""
    return [read_master(path) for path in master_paths(solutions)]


def read_master(path):
    """Read and validate a master with its trials.

    Parameters
    ----------
    path : path_like
        File of the page.

    Returns
    -------
    Master
        The master.

    Raises
    ------
    MasterError
        If the front matter is incomplete, a code cell has not exactly one role, an answer is not
        assigned once and checked once, a check does not exist, or a trial is malformed.
    """
    path = Path(path).absolute()
    if not path.is_file():
        raise MasterError(path, 1, "there is no such master")
    text = path.read_text(encoding="utf-8")
    front, lines = read_front_matter(path, text)
    validate_front_matter(path, front, lines)
    answers = {name: _answer(name, text) for name, text in front["answers"].items()}
    hints = {name: tuple(texts) for name, texts in front["hints"].items()}
    master = Master(
        path,
        front["number"],
        front["title"],
        front["section"],
        front["level"],
        tuple(front["topics"]),
        answers,
        hints,
        _cells(path, text),
        read_trials(trials_file(path), answers),
        tuple(front.get("core", ())),
        numbers_section(trials_file(path)),
    )
    validate_code(master, lines)
    validate_drawings(master)
    validate_blocks(master)
    return master


def _answer(name, text):
    kind, _, meaning = str(text).partition(":")
    return Answer(name, kind.strip(), meaning.strip(), exact="exact" in kind.split())


def _cells(path, text):
    from jupytext.myst import MystMetadataParsingError, myst_to_notebook

    try:
        notebook = myst_to_notebook(text, add_source_map=True)
    except MystMetadataParsingError as error:
        raise MasterError(path, 1, f"the options of a code cell cannot be read: {error}") from None
    starts = notebook.metadata.source_map
    return tuple(_cell(path, cell, start + 1, text) for cell, start in zip(notebook.cells, starts))


def _cell(path, cell, line, text):
    if cell.cell_type != "code":
        return Cell("", cell.source, line)
    tags = cell.metadata.get("tags", [])
    roles = [tag for tag in tags if tag in ROLES]
    if len(roles) != 1:
        raise MasterError(
            path, line, f"a code cell needs exactly one role of {', '.join(ROLES)}, found {tags}"
        )
    line = text.split("\n").index(cell.source.split("\n")[0], line - 1) + 1  # below the options
    try:
        ast.parse(cell.source)
    except SyntaxError as error:
        raise MasterError(path, line + error.lineno - 1, f"no Python: {error.msg}") from None
    return Cell(roles[0], cell.source, line)

"""Read a master, a notebook and its trials, and hold it to its contract."""

import ast
from dataclasses import dataclass
from pathlib import Path

from workbook.authoring.contract import hold_blocks, hold_code, hold_drawings, hold_front_matter
from workbook.authoring.errors import MasterError
from workbook.authoring.front_matter import read_front_matter
from workbook.authoring.trials import read_trials, trials_file

ROLES = ("data", "drawing", "answer", "figure", "check")


@dataclass(frozen=True)
class Answer:
    """One answer variable: `kind` is its TYPE, `text` what it is, `exact` whether decimals are not
    enough."""

    name: str
    kind: str
    text: str
    exact: bool


@dataclass(frozen=True)
class Cell:
    """A cell of the notebook: `role` is one of `ROLES` for code and "" for prose, `line` where its
    text begins."""

    role: str
    source: str
    line: int


@dataclass(frozen=True)
class Master:
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

    def code(self, *roles):
        """Sources of the code cells with one of the roles, in order."""
        return [cell.source for cell in self.cells if cell.role in roles]

    @property
    def exercise(self):
        """Where the student's copy stands: exercises/ch1/p15.ipynb beside solutions/."""
        return (
            self.path.parent.parent.parent
            / "exercises"
            / self.path.parent.name
            / f"{self.path.stem}.ipynb"
        )


def master_paths(solutions):
    """The files of all masters below the folder `solutions`, in the order of their numbers."""
    return sorted(
        Path(solutions).glob("ch*/p*.md"), key=lambda path: (int(path.parent.name[2:]), path.stem)
    )


def read_all(solutions):
    """All masters below the folder `solutions`, in the order of their numbers."""
    return [read(path) for path in master_paths(solutions)]


def read(path):
    """The master at `path`, with its trials.

    Raises `MasterError` with file and line if the front matter is incomplete, a code cell has no
    role or two, an answer is never assigned or never checked, a check does not exist, or a trial is
    none (`workbook.authoring.trials`).
    """
    path = Path(path).absolute()
    if not path.is_file():
        raise MasterError(path, 1, "there is no such master")
    text = path.read_text(encoding="utf-8")
    said, lines = read_front_matter(path, text)
    hold_front_matter(path, said, lines)
    answers = {name: _answer(name, text) for name, text in said["answers"].items()}
    hints = {name: tuple(texts) for name, texts in said["hints"].items()}
    master = Master(
        path,
        said["number"],
        said["title"],
        said["section"],
        said["level"],
        tuple(said["topics"]),
        answers,
        hints,
        _cells(path, text),
        read_trials(trials_file(path), answers),
        tuple(said.get("core", ())),
    )
    hold_code(master, lines)
    hold_drawings(master)
    hold_blocks(master)
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
    begins = notebook.metadata.source_map
    return tuple(_cell(path, cell, begin + 1, text) for cell, begin in zip(notebook.cells, begins))


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

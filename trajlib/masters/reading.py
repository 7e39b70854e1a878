"""Read a master notebook and hold it to its contract."""

import ast
import re
from dataclasses import dataclass
from pathlib import Path

ROLES = ("data", "answer", "figure", "check", "wrong", "right")
#: Cells that test the checks and appear nowhere else: typical wrong answers, and right ones in another form.
TRIALS = ("wrong", "right")
TYPES = ("number", "integer", "yes/no", "choice", "vector", "matrix", "expression", "equation", "condition", "set",
         "law", "function", "list of", "dict")
FIELDS = {"number", "title", "section", "level", "topics", "answers", "hints"}


class MasterError(ValueError):
    """A master breaks the contract; the message names the file and what was expected."""


@dataclass(frozen=True)
class Answer:
    """One answer variable: `kind` is its TYPE, `text` what it is, `exact` whether decimals are not enough."""

    name: str
    kind: str
    text: str
    exact: bool


@dataclass(frozen=True)
class Cell:
    """A cell of the notebook: `role` is one of `ROLES` for code and "" for prose."""

    role: str
    source: str


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

    def code(self, *roles):
        """Sources of the code cells with one of the roles, in order."""
        return [cell.source for cell in self.cells if cell.role in roles]

    @property
    def exercise(self):
        """Where the student's copy stands: exercises/ch1/p15.ipynb beside solutions/."""
        return self.path.parent.parent.parent / "exercises" / self.path.parent.name / f"{self.path.stem}.ipynb"

    def trials(self, role):
        """The cells of a trial role as (answer name, source, comment)."""
        return [(assigned_names(source, self.answers)[0], source, source.lstrip("# ").split("\n")[0])
                for source in self.code(role)]


def master_paths(solutions):
    """The files of all masters below the folder `solutions`, in the order of their numbers."""
    return sorted(Path(solutions).glob("ch*/p*.md"), key=lambda path: (int(path.parent.name[2:]), path.stem))


def read_all(solutions):
    """All masters below the folder `solutions`, in the order of their numbers."""
    return [read(path) for path in master_paths(solutions)]


def master_file(number):
    """The file of a problem below solutions/: 1.15 stands in ch1/p15.md."""
    chapter, _, problem = number.partition(".")
    return Path(f"ch{chapter}") / f"p{problem:0>2}.md"


def read(path):
    """The master at `path`.

    Raises `MasterError` if the front matter is incomplete, a code cell has no role or two, an answer is never
    assigned, or a trial cell does not assign exactly one answer under a comment.
    """
    import jupytext

    path = Path(path)
    if not path.is_file():
        raise MasterError(f"there is no master {path}")
    notebook = jupytext.reads(path.read_text(encoding="utf-8"), fmt="md:myst")
    head = notebook.metadata.get("problem")
    if not isinstance(head, dict) or set(head) != FIELDS:
        raise MasterError(f"{path}: the front matter needs problem: with {', '.join(sorted(FIELDS))}")
    if not re.fullmatch(r"\d+\.\d+", str(head["number"])) or not isinstance(head["number"], str):
        raise MasterError(f'{path}: problem.number is to be quoted, "1.15"')
    if head["level"] not in ("core", "starred"):
        raise MasterError(f"{path}: problem.level is core or starred")
    answers = {name: _answer(path, name, text) for name, text in head["answers"].items()}
    hints = {name: tuple(texts) for name, texts in head["hints"].items()}
    if set(hints) != set(answers):
        raise MasterError(f"{path}: every answer needs hints; they differ in {sorted(set(hints) ^ set(answers))}")
    master = Master(path, head["number"], head["title"], head["section"], head["level"], tuple(head["topics"]),
                    answers, hints, tuple(_cell(path, cell) for cell in notebook.cells))
    _hold_to_contract(master)
    return master


def _answer(path, name, text):
    kind, colon, meaning = str(text).partition(":")
    if not colon or not kind.strip().startswith(TYPES):
        raise MasterError(f'{path}: answer {name} is to read "TYPE: what it is", TYPE one of {", ".join(TYPES)}')
    return Answer(name, kind.strip(), meaning.strip(), exact="exact" in kind.split())


def _cell(path, cell):
    if cell.cell_type != "code":
        return Cell("", cell.source)
    tags = cell.metadata.get("tags", [])
    roles = [tag for tag in tags if tag in ROLES]
    if len(roles) != 1:
        raise MasterError(f"{path}: a code cell needs exactly one role of {', '.join(ROLES)}, found "
                          f"{tags}:\n{cell.source}")
    if roles[0] in TRIALS and not {"skip-execution", "remove-cell"} <= set(tags):
        raise MasterError(f"{path}: a cell tagged {roles[0]} also needs skip-execution and remove-cell")
    return Cell(roles[0], cell.source)


def _hold_to_contract(master):
    assigned = [name for source in master.code("answer") for name in assigned_names(source, master.answers)]
    if sorted(assigned) != sorted(master.answers):
        raise MasterError(f"{master.path}: the answer cells must assign every answer once; they assign {assigned}")
    early = [name for source in master.code("data") for name in assigned_names(source, master.answers)]
    if early:
        raise MasterError(f"{master.path}: a data cell assigns the answer {early[0]}")
    reported = [name for source in master.code("check") for name in reported_names(source)]
    if sorted(reported) != sorted(master.answers):
        raise MasterError(f"{master.path}: the check cells must report every answer once; they report {reported}")
    if not master.code("data") or not master.code("check"):
        raise MasterError(f"{master.path}: a data cell and a check cell are needed")
    for role in TRIALS:
        for source in master.code(role):
            if not source.lstrip().startswith("#") or len(assigned_names(source, master.answers)) != 1:
                raise MasterError(f"{master.path}: a cell tagged {role} assigns one answer under a comment:\n{source}")


def reported_names(source):
    """The answers that a check cell hands to `checks.report`, in order."""
    calls = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call)]
    return [keyword.arg for call in calls if ast.unparse(call.func) == "checks.report" for keyword in call.keywords]


def assigned_names(source, names):
    """Which of `names` a cell assigns at its top level, in order."""
    found = []
    for node in ast.parse(source).body:
        targets = (node.targets if isinstance(node, ast.Assign) else [node.target] if isinstance(node, ast.AnnAssign)
                   else [])
        if isinstance(node, ast.FunctionDef):
            found += [node.name] if node.name in names else []
        for target in targets:
            parts = target.elts if isinstance(target, (ast.Tuple, ast.List)) else [target]
            found += [part.id for part in parts if isinstance(part, ast.Name) and part.id in names]
    return found

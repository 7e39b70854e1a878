"""The pristine exercises: what every check and grade reads data and check cells from.

They stand in exercises/ of a checkout, and inside the package when it was installed from a wheel. A
notebook names places of the book without a link, since a student may be anywhere; its cells'
metadata know where each stands on the site, and `linked` makes links of them where the site has an
address.
"""

import copy
import json
import re
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]
CHECKOUT = PACKAGE.parent


class UnknownExercise(ValueError):
    """No exercise has this number, or a file is no exercise of the workbook."""


@dataclass(frozen=True)
class Exercise:
    """A student's notebook as it was handed out: `about` is its metadata (number, title, answers,
    hints, ...)."""

    path: Path
    about: dict
    cells: tuple

    @property
    def number(self):
        return self.about["number"]

    def code(self, *roles):
        """(role, source) of the code cells with one of the roles, in order."""
        return [(role, source) for role, source in self.cells if role in roles]

    def to_run(self, sources):
        """A student's code cells, with nothing in the place of check cells that are as we handed
        them out."""
        ours = {source.strip() for _, source in self.code("check")}
        return ["" if source.strip() in ours else source for source in sources]


def home():
    """The folder that holds the exercises."""
    checkout = CHECKOUT / "exercises"
    return checkout if checkout.is_dir() else PACKAGE / "_exercises"


def read(path):
    """The exercise in a notebook file of ours, pristine or worked on.

    Raises `UnknownExercise` if the file is not a notebook or does not say which problem it belongs
    to.
    """
    path = Path(path)
    try:
        notebook = json.loads(path.read_text(encoding="utf-8-sig"))
        about = notebook["metadata"]["workbook"]
        cells = tuple(
            (_role(cell), "".join(cell["source"]))
            for cell in notebook["cells"]
            if cell["cell_type"] == "code"
        )
        return Exercise(path, about, cells)
    except OSError as error:
        raise UnknownExercise(f"{path} is not a readable notebook: {error.strerror}") from None
    except (UnicodeDecodeError, json.JSONDecodeError) as error:
        raise UnknownExercise(f"{path} is not a readable notebook: {error}") from None
    except (KeyError, TypeError):
        raise UnknownExercise(
            f"{path} does not say which problem it belongs to (metadata workbook.number)"
        ) from None


def read_all():
    """All exercises in the order of their numbers."""
    paths = home().glob("ch*/p*.ipynb")
    return [read(path) for path in sorted(paths, key=lambda p: (int(p.parent.name[2:]), p.stem))]


def find(number):
    """The pristine exercise with a number such as "1.15"; raises `UnknownExercise`."""
    path = place(number)
    return _as_changed(path, path.stat().st_mtime_ns)


@lru_cache(maxsize=256)
def _as_changed(path, when):
    """What was read of a file stays true until it is changed: who grades asks for it with each
    notebook."""
    return read(path)


def place(number):
    """Where the notebook of `find` stands."""
    chapter, _, problem = str(number).partition(".")
    path = home() / f"ch{chapter}" / f"p{problem:0>2}.ipynb"
    if not (chapter.isdigit() and problem.isdigit() and path.exists()):
        raise UnknownExercise(f"there is no problem {number}; `workbook problems` lists them")
    return path


def linked(notebook, address):
    """A copy of a notebook in which the names of the book's places are links, whatever links they
    were before.

    `address` maps a place below the site's root, "book/ch1.html#thm-1-2", to what the link is to
    hold.
    """
    notebook = copy.deepcopy(notebook)
    for cell in notebook["cells"]:
        source, done = "".join(cell["source"]), ""
        for text, place in cell["metadata"].get("places", ()):
            words, is_prose = re.escape(text), cell["cell_type"] == "markdown"
            named = re.search(
                rf"\[{words}\]\([^)\s]*\)|{words}" if is_prose else rf'"[^"]*{words}[^"]*"', source
            )
            link = (
                f"[{text}]({address(place)})"
                if is_prose
                else f'"trajlib[workbook] @ {address(place)}"'
            )
            done += source[: named.start()] + link
            source = source[named.end() :]
        cell["source"] = done + source
    return notebook


def below(site):
    """The `address` of `linked` for a site with this address."""
    return lambda place: f"{site.rstrip('/')}/{place}"


def _role(cell):
    tags = cell.get("metadata", {}).get("tags", [])
    return next((tag for tag in tags if tag in ("data", "answer", "check")), "")

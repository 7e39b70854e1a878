"""A hostile submission, and what is observed after it in an unguarded grader and in ours."""

import json
import sys
from dataclasses import dataclass
from pathlib import Path
from textwrap import dedent

sys.path.insert(0, str(Path(__file__).parents[1]))
from classroom import notebook as handed_out

#: A secret in the grader's environment, home and open files: an answer with it has read these.
SECRET = "Tycho-1572"
#: The right answer of the one item that counts here, as in a solution file.
RIGHT = "sp.And(k1 > 0, k1*k2 > 1)"
WRONG = "a_region = sp.And(k1 > 0, k2 > 0)"


@dataclass(frozen=True)
class Seen:
    """What became of a submission and of its surroundings."""

    points: int  # right answers
    text: str  # the answers as they were recorded
    finished: bool  # the grader came to its end by itself
    honest: bool  # the students before and after, and between, have full marks
    marked: bool  # the attack left its mark in the grader's folder
    heard: bool  # something came to the grader's address
    left: int  # processes left behind
    gradings: int  # how often it was graded
    printed: int  # bytes that came out of the grader


def gained(seen):
    return seen.points > 0


def leaked(seen):
    return SECRET in seen.text


def marked(seen):
    return seen.marked


def heard(seen):
    return seen.heard


def left_behind(seen):
    return seen.left > 0


def stopped_the_run(seen):
    return not seen.finished


def harmed_others(seen):
    return not seen.honest


def graded_twice(seen):
    return seen.gradings > 1


def flooded(seen):
    return seen.printed > 10**8


def reached(number):
    """Return a test of whether the attack reports at least this number."""
    return lambda seen: any(
        int(word) >= number for word in seen.text.replace(",", " ").split() if word.isdigit()
    )


@dataclass(frozen=True)
class Attack:
    """A hostile submission.

    `cells` are in the place of the first stub; or `files(folder)` makes the whole submission.
    `success` is a function of what was `Seen`: it must be true for the unguarded grader (`naive`),
    and false for ours. There no point is gained, no other's grade is harmed, and the run goes on;
    `after` describes what else holds.
    """

    name: str
    attempts: str
    unguarded: str
    after: str
    success: object
    cells: tuple = ()
    files: object = None
    apart: bool = False  # the unguarded grader runs each notebook in a process of its own
    marks: str = "checks"  # how the unguarded grader marks (see `naive`)
    # Seconds after which the unguarded grader counts as endless: far more than one that ends
    # needs on a busy machine; an attack that never ends sets less.
    patience: float = 120.0
    # whose fault it is by our grader's remark; "" without a remark
    blame: str = "notebook"

    def submit(self, folder, facts):
        """Make the submission in a student's folder; `facts` become variables of its cells."""
        folder.mkdir(parents=True)
        if self.files:
            self.files(folder)
            return
        prelude = "".join(f"{name} = {value!r}\n" for name, value in facts.items())
        write(folder / "p15.ipynb", with_cells([prelude + lines(cell) for cell in self.cells]))


def lines(*parts):
    """Join pieces of code, each without its margin."""
    return "\n".join(dedent(part).strip() for part in parts)


def with_cells(sources):
    """Return the notebook of problem 1.15 with code cells in the place of its first stub."""
    notebook = handed_out("1.15", {})
    place = next(
        k for k, cell in enumerate(notebook["cells"]) if cell["metadata"].get("tags") == ["answer"]
    )
    notebook["cells"][place : place + 1] = [code(source) for source in sources]
    return notebook


def code(source):
    return {
        "cell_type": "code",
        "metadata": {},
        "source": source,
        "outputs": [],
        "execution_count": None,
    }


def write(path, notebook):
    path.write_text(json.dumps(notebook), encoding="utf-8")

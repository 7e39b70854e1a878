"""The pristine exercises, from which every check and every grade reads data and check cells.

They are in the folder exercises/ of their course (`workbook.course`). A variant of a problem, with
other numbers, has a name such as 2.4~17: problem 2.4 with the numbers of row 17.
`workbook.authoring.variants` writes it to variants/ of the course once it is proved. A
notebook refers to the book without links, since a student may be anywhere; the metadata `places` of
its cells hold the addresses, and `add_links` makes links of them where the site has an address.
"""

import copy
import json
import re
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from workbook.checks.contract.check_cells import check_calls, marked
from workbook.checks.contract.former_names import with_former_names
from workbook.checks.course_checks import own_checks
from workbook.course import course_of, courses
from workbook.numbering import NUMBER, files_by_number, read_number

#: The report of a check cell, and what stands above it in a homework.
REPORT, HIDING = "checks.report(", "checks.hide_direction()\n"
#: In the place of the check of an answer that only the grading judges.
KEPT = re.compile(r"\b(\w+)=checks\.kept_for_grading\(\1\)")
#: In the metadata of a notebook that was handed out, the names of these answers.
KEPT_NAMES = "kept_for_grading"
#: A report with the name of its problem or variant.
NAMED_REPORT = re.compile(rf'checks\.report\((f?"({NUMBER.pattern}|[a-z0-9.]+~\{{row\}})",?)?')


class UnknownExercise(ValueError):
    """There is no exercise with a number, or a file is no exercise of the workbook."""


@dataclass(frozen=True)
class Exercise:
    """A student notebook.

    Attributes
    ----------
    path : pathlib.Path
        Its file.
    about : dict
        Its metadata: number, title, section, level, topics, answers and hints.
    cells : tuple of (str, str)
        (role, source) of its code cells.
    """

    path: Path
    about: dict
    cells: tuple

    @property
    def number(self):
        """Number of the problem, such as "1.15"."""
        return self.about["number"]

    @property
    def kept(self):
        """Names of answers that only the grading judges, as a notebook that was handed out says."""
        names = self.about.get(KEPT_NAMES)
        return (
            [name for name in names if name in self.about["answers"]]
            if isinstance(names, list)
            else []
        )

    @property
    def hides_direction(self):
        """Whether its check cells are those of a homework that does not say too great or too small."""
        return any(HIDING in source for _, source in self.code("check"))

    @property
    def own_checked(self):
        """Names of answers that checks of the course's own judge (`checks.course_checks`)."""
        own = own_checks(home_of(self.number))
        return [
            name
            for _, source in (self.code("check") if own else ())
            for name, call in check_calls(source).items()
            if call.partition("(")[0].removeprefix("checks.") in own
        ]

    def code(self, *roles):
        """Return (role, source) of the code cells with one of the roles, in order."""
        return [(role, source) for role, source in self.cells if role in roles]

    def sources_to_run(self, sources):
        """Return a student's code cells, with marks for check cells that have not been changed.

        The cells that check steps count for nothing; where they have not been changed, they are empty.
        """
        checks = [
            (marked(source), form)
            for _, source in self.code("check")
            for degree in ("margin=", "degree=")  # former words for the degree of stability
            for check in ("possible_margins(", "possible_degrees(")
            for text in (source.replace("degree=", degree).replace("possible_degrees(", check),)
            for form in (with_former_names(text), text)
        ]
        calls = {name: call for _, form in checks for name, call in check_calls(form).items()}

        def plain(source):  # in practice and in homework, with any numbers
            checked = KEPT.sub(lambda kept: f"{kept[1]}={calls.get(kept[1], '')}", source)
            return NAMED_REPORT.sub(REPORT, checked.replace(HIDING, "")).strip()

        marks = {plain(form): mark for mark, form in checks}
        marks |= {plain(source): "" for _, source in self.code("steps")}
        return [marks.get(plain(source), source) for source in sources]


def read(path):
    """Return the exercise in a notebook file, pristine or worked on.

    Raises
    ------
    UnknownExercise
        If the file is no notebook, or its metadata name no problem.
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


def read_all(homes=None):
    """Return all exercises of courses in the order of their numbers; by default of those here."""
    return [
        read(path)
        for home in (courses() if homes is None else homes)
        for path in files_by_number(home.exercises, ".ipynb")
    ]


def find(number):
    """Return the pristine exercise with a number such as "1.15".

    Raises
    ------
    UnknownExercise
        If there is none.
    """
    path = notebook_path(number)
    return _read_cached(path, path.stat().st_mtime_ns)


@lru_cache(maxsize=256)
def _read_cached(path, modified):
    """Read a file again only after a change; grading reads it for each submission."""
    return read(path)


def in_homework(exercise):
    """Return an exercise whose verdicts do not say in which direction a number is wrong."""
    return replace(
        exercise,
        cells=tuple(
            (role, hiding_direction(source) if role == "check" else source)
            for role, source in exercise.cells
        ),
    )


def leaving_to_grading(exercise, kept):
    """Return an exercise that leaves answers with these names to the grading of the homework."""
    return replace(
        exercise,
        cells=tuple(
            (role, keeping_for_grading(source, kept) if role == "check" else source)
            for role, source in exercise.cells
        ),
    )


def instruction(time, rest=""):
    """Return the text below the statement: how long it takes, what to do, and `rest`."""
    return (
        f"*{time.capitalize()}. Replace each `...` by your answer and run the check cell below it: it "
        f"says what holds and what does not, as often as you like.{rest}*"
    )


def hiding_direction(source):
    """Return a check cell whose verdicts do not say in which direction a number is wrong."""
    return source.replace(REPORT, HIDING + REPORT, 1)


def keeping_for_grading(source, names):
    """Return a check cell that leaves answers with these names to the grading of the homework.

    >>> cell = "checks.report(a=checks.root(a), b=checks.root(b))"
    >>> keeping_for_grading(cell, ["b"])
    'checks.report(a=checks.root(a), b=checks.kept_for_grading(b))'
    """
    for name, call in check_calls(source).items():
        if name in names:
            source = source.replace(f"{name}={call}", f"{name}=checks.kept_for_grading({name})", 1)
    return source


def notebook_path(number):
    """Return the file of an exercise; raise `UnknownExercise` if there is none."""
    path = path_of(number)
    if not path.exists():
        raise _unknown(number)
    return path


def path_of(number):
    """Return where the notebook of a problem or variant is, if there is one; raise
    `UnknownExercise` for a number that cannot be a problem's."""
    home = home_of(number)
    folder = home.variants if read_number(number).row else home.exercises
    return folder / read_number(number).file(".ipynb")


def master_path(number):
    """Return where the master of a problem is, if it is here; raise `UnknownExercise`."""
    return home_of(number).solutions / read_number(number).file(".md")


def home_of(number):
    """Return the `Course` of a problem or variant.

    Raises
    ------
    UnknownExercise
        If a text is no number, or its course is not here.
    """
    if read_number(number) is None:
        raise _unknown(number)
    home = course_of(number)
    if home is None:
        here = " and ".join(f"{course.title} ({course.folder})" for course in courses()[1:])
        raise UnknownExercise(
            f"problem {number} is of a course that is not here"
            + (f", where there is {here}" if here else "")
            + ": its notebook checks itself; to check or grade it elsewhere, work in the folder of the "
            "course or name it by --course FOLDER"
        )
    return home


def _unknown(number):
    base, _, row = str(number).partition("~")
    if row:
        return UnknownExercise(
            f"row {row} of problem {base} is not here, and its notebook checks itself; where its master "
            f"is, `workbook variants {base}` proves and writes the rows"
        )
    return UnknownExercise(f"there is no problem {number}; `workbook problems` lists them")


def add_links(notebook, url_of):
    """Return a copy of a notebook with links to the book, in place of other links to it.

    Parameters
    ----------
    notebook : dict
        A student notebook in nbformat 4.5.
    url_of : callable
        Maps an address below the site's root, such as "book/ch1/hurwitz.html#thm-1-2", to a URL.

    Returns
    -------
    dict
        The copy.
    """
    notebook = copy.deepcopy(notebook)
    for cell in notebook["cells"]:
        source, done = "".join(cell["source"]), ""
        for text, address in cell["metadata"].get("places", ()):
            words, is_prose = re.escape(text), cell["cell_type"] == "markdown"
            match = re.search(
                rf"\[{words}\]\([^)\s]*\)|{words}" if is_prose else rf'"[^"]*{words}[^"]*"', source
            )
            link = f"[{text}]({url_of(address)})" if is_prose else f'"{url_of(address)}"'
            done += source[: match.start()] + link
            source = source[match.end() :]
        cell["source"] = done + source
    return notebook


def site_urls(site):
    """Return the `url_of` for `add_links` of a site with this address."""
    return lambda address: f"{site.rstrip('/')}/{address}"


def _role(cell):
    tags = cell.get("metadata", {}).get("tags", [])
    return next((tag for tag in tags if tag in ("data", "answer", "check", "steps")), "")

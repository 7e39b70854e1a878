"""A course: a folder with `workbook.toml`, in which a lecturer keeps problems of his own.

    title = "Robotics 1"
    name = "rob"                       # its chapters are rob, rob1, rob2, ...
    credit = "Robotics 1, University of Nowhere, 2026"  # optional: the last cell of each notebook
    workbook = ">=0.3,<0.4"            # optional: the versions that its problems were proved with
    site = "https://robotics.example"  # optional: where notebooks link to
    wheel = "https://..."              # optional: where students get the workbook

It is the nearest such folder above the working folder, as git finds a repository, or the one that
`--course` or the variable WORKBOOK_COURSE names. Cells of a course run in the process that judges, so
only a folder that somebody entered or named counts, and one of another owner only if it is named. The
workbook itself is a course whose chapters are numbers.
"""

import os
import re
import tomllib
from dataclasses import dataclass, fields
from functools import lru_cache
from importlib import metadata
from pathlib import Path

from workbook.numbering import read_number

#: The file that marks the folder of a course.
FILE = "workbook.toml"
#: The variable that names a folder; with "" there is no course.
VARIABLE = "WORKBOOK_COURSE"
PACKAGE = Path(__file__).resolve().parent
CHECKOUT = PACKAGE.parent
#: The last problem that the problem book has in each of its chapters.
LAST_PRINTED = {"1": 18, "2": 37, "3": 26, "4": 43, "5": 70}
#: The section of problems of its chapters that the printed book does not have.
ADDED = "added"
PROBLEM_BOOK = (
    "S. S. Lemak, V. M. Morozov, M. Yu. Popelensky, V. V. Tikhomirov, O. Yu. Cherkasov, "
    "*Mechanics of Controlled Systems: Problem Book* (in Russian), ed. V. V. Aleksandrov, Yu. V. "
    "Bolotin, Moscow, 2012"
)
#: The page of the site that says how to install the workbook. Notebooks name no version of it.
INSTALL = "book/guides/install.html"


class CourseError(ValueError):
    """A course cannot be used; the message is one line: what, where, what to do."""


@dataclass(frozen=True)
class Course:
    """What `workbook.toml` says, and where the parts of a course are.

    Attributes
    ----------
    folder : pathlib.Path
        The folder of the course.
    title, name : str
        The title for people; the word with which its chapters begin.
    credit : str
        What the last cell of each notebook says of the problems' origin.
    workbook : str
        The versions of the workbook that the problems were proved with.
    site, wheel : str
        Addresses of its site and of the workbook's wheel.
    """

    folder: Path
    title: str
    name: str
    credit: str = ""
    workbook: str = ""
    site: str = ""
    wheel: str = ""

    @property
    def solutions(self):
        """The folder of the masters."""
        return self.folder / "solutions"

    @property
    def exercises(self):
        """The folder of the student notebooks."""
        return self.folder / "exercises"

    @property
    def checks(self):
        """The file of its own checks, None without such."""
        file = self.folder / "checks.py"
        return file if file.is_file() else None

    @property
    def variants(self):
        """The folder of the notebooks of variants."""
        return self.folder / "variants"

    @property
    def lectures(self):
        """The folder of the lectures."""
        return self.folder / "lectures"

    @property
    def install(self):
        """What a student without the workbook is to do."""
        source = f"trajlib[workbook] @ {self.wheel}" if self.wheel else "trajlib[workbook]"
        return f"pip install '{source}'"

    def has_chapter(self, chapter):
        """Return whether a chapter is one of this course."""
        return re.fullmatch(rf"{self.name}[0-9]*", chapter) is not None

    def theory(self, chapter):
        """Return the address of a chapter's theory below the site's root, "" if there is none."""
        return ""

    def section_of(self, chapter):
        """Return the section that a first problem of a chapter gets."""
        return self.title

    def validate_new(self, number):
        """Raise `ValueError` for the number of a new problem that the course cannot have."""

    def origin(self, number, section):
        """Return (Markdown on the origin of a problem, [(words, address on the site), ...])."""
        credit = f"*{self.credit}.*\n\n" if self.credit else ""
        return f"{credit}This notebook needs the workbook: `{self.install}`.", []


class _Workbook(Course):
    """The workbook's own problems: in a checkout with their masters, in a wheel without."""

    checks = None  # they are in `workbook.checks`

    @property
    def exercises(self):
        checkout = self.folder / "exercises"
        return checkout if checkout.is_dir() else PACKAGE / "_exercises"

    @property
    def lectures(self):
        return self.folder / "book" / "lectures"

    @property
    def install(self):
        return f"the workbook's site, {INSTALL}"

    def has_chapter(self, chapter):
        return chapter.isdigit()

    def theory(self, chapter):
        return f"book/ch{chapter}.html"

    def section_of(self, chapter):
        return f"§{chapter}.1"

    def validate_new(self, number):
        chapter, problem, _ = read_number(number)
        if not self.solutions.is_dir():
            raise ValueError(
                "the workbook's masters are not here: a problem of your own belongs to a course, which "
                "`workbook new --course FOLDER` begins"
            )
        if int(problem) > LAST_PRINTED.get(chapter, int(problem)):
            raise ValueError(
                f"chapter {chapter} of the problem book ends with problem "
                f"{chapter}.{LAST_PRINTED[chapter]}: a new problem belongs to a chapter from "
                f"{len(LAST_PRINTED) + 1} on"
            )

    def origin(self, number, section):
        chapter, problem, _ = number = read_number(number)
        printed = chapter in LAST_PRINTED and int(problem) <= LAST_PRINTED[chapter]
        if section == ADDED or (chapter in LAST_PRINTED and not printed):
            origin = "*This problem is our own; it is not in the printed problem book.*"
        else:
            credit = (
                f"{PROBLEM_BOOK}, problem {number.base}"
                if printed
                else "the research chapters of the workbook"
            )
            origin = f"*The data of this problem come from* {credit}."
        return (
            f"{origin}\n\n"
            "This notebook needs the workbook: from a checkout of it run `pip install -e "
            '".[workbook]"`, or install the wheel that the workbook\'s site offers. The theory is in '
            f"chapter {chapter}.",
            [
                ("wheel that the workbook's site offers", INSTALL),
                (f"chapter {chapter}", self.theory(chapter)),
            ],
        )


WORKBOOK = _Workbook(CHECKOUT, "Controlled motion as an executable workbook", "workbook")


def course_of(number):
    """Return the course that has the chapter of a number, None if it is not here.

    Raises
    ------
    CourseError
        If the course that was entered or named cannot be used.
    """
    chapter = read_number(number).chapter
    if WORKBOOK.has_chapter(chapter):
        return WORKBOOK
    course = current()
    return course if course is not None and course.has_chapter(chapter) else None


def courses():
    """Return the courses whose problems are here: the workbook, and the one entered or named."""
    return [WORKBOOK, *filter(None, [current()])]


def current():
    """Return the `Course` that is named or entered, None if there is none.

    Raises
    ------
    CourseError
        If it cannot be used.
    """
    named = os.environ.get(VARIABLE)
    if named is not None:
        return read(Path(named)) if named else None
    here = Path.cwd()
    folder = next((f for f in (here, *here.parents) if (f / FILE).is_file()), None)
    if folder is None:
        return None
    if not (_is_own(folder) and _is_own(folder / FILE)):
        raise CourseError(
            f"{folder / FILE} belongs to another user, and the cells of a course run as you: if you "
            f"trust it, name it by --course {folder}"
        )
    return read(folder)


def pinned():
    """Return the `current` course, which stays that of this process and of those that it starts."""
    course = current()
    os.environ[VARIABLE] = str(course.folder) if course else ""
    return course


def enter(folder):
    """Name the course of this process and of those that it starts; with None there is none.

    Raises
    ------
    CourseError
        If the folder is no course.
    """
    if folder is not None:
        read(folder := Path(folder).resolve())
    os.environ[VARIABLE] = str(folder or "")


@lru_cache
def read(folder):
    """Return the `Course` in a folder, which is read once.

    Raises
    ------
    CourseError
        If its file cannot be read or says what it must not.
    """
    path = Path(folder) / FILE
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise CourseError(
            f"{path}: {error.strerror}; `workbook new --course {folder}` begins a course there"
        ) from None
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise CourseError(f"{path} is not TOML in UTF-8: {error}") from None
    allowed = [field.name for field in fields(Course) if field.name != "folder"]

    def require(condition, message):
        if not condition:
            raise CourseError(f"{path}: {message}")

    for key, value in table.items():
        require(key in allowed, f"unknown field {key}; there are {', '.join(allowed)}")
        require(
            isinstance(value, str) and len(value.strip().splitlines()) == 1,
            f"{key} is one line of text in quotes",
        )
    for key in ("title", "name"):
        require(key in table, f'{key} is missing: write {key} = "..."')
    require(
        re.fullmatch(r"[a-z]{2,20}", table["name"]) and table["name"] != WORKBOOK.name,
        f'name is a word of 2 to 20 small letters, such as "rob", and not "{WORKBOOK.name}"',
    )
    _validate_version(require, table.get("workbook", ""))
    return Course(Path(folder).resolve(), **{key: text.strip() for key, text in table.items()})


def _validate_version(require, versions):
    # for courses of one's own
    from packaging.specifiers import InvalidSpecifier, SpecifierSet

    try:
        allowed = SpecifierSet(versions)
    except InvalidSpecifier:
        require(False, f'workbook is a range of versions such as ">=0.3,<0.4", not "{versions}"')
    installed = metadata.version("trajlib")
    require(
        allowed.contains(installed, prereleases=True),
        f"its problems were proved with the workbook {versions}, and this is {installed}: install such "
        "a version, or change the range and run `workbook prove`",
    )


def _is_own(path):
    """Return whether a file or folder belongs to the user; Windows does not say."""
    return not hasattr(os, "getuid") or path.stat().st_uid == os.getuid()

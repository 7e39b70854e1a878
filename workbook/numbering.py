"""Read the number of a problem, such as 1.15, rob.1 or 2.4~17.

The workbook's chapters are numbers, and those of a course are words that end with digits where it
has several: rob.1, rob2.14. So a number says by itself where its problem belongs. A variant has the
row of its numbers behind the sign ~. All names of files and labels are made here from numbers, and
read here.
"""

import re
from pathlib import Path, PurePath
from typing import NamedTuple

CHAPTER = r"[0-9]+|[a-z]+[0-9]*"
NUMBER = re.compile(rf"({CHAPTER})\.([0-9]+)(?:~([1-9][0-9]*))?")
#: Longer texts are no numbers; they may be a student's.
MOST_LETTERS = 40
#: The name of a notebook as it is handed out, ch1-p15 or chrob-p01, also within the name that a
#: browser or a learning platform gave it.
HANDED_OUT_NAME = re.compile(
    r"(?<![a-z0-9])ch(?:0*([0-9]{1,3})(?:[ ._-]p?|p)|([a-z]{1,20}[0-9]{0,3})[ ._-]p)"
    r"0*([0-9]{1,3})(?![0-9])",
    re.IGNORECASE,
)
#: A name that begins with the number alone: 1_15, 1.p15 (2).
SHORT_NAME = re.compile(r"0*([0-9]{1,3})[._-]p?0*([0-9]{1,3})(?:[^0-9].*)?", re.DOTALL)
#: A number such as 1.15 or rob.1 anywhere in a name, unless it is part of a longer one, as of a date.
WITHIN_NAME = (
    re.compile(
        r"(?<![0-9])(?<![0-9][._-])0*([0-9]{1,3})[._-]p?0*([0-9]{1,3})(?![._-]?[0-9])",
        re.IGNORECASE,
    ),
    re.compile(
        r"(?<![a-z0-9])([a-z]{1,20}[0-9]{0,3})[._-]p?0*([0-9]{1,3})(?![._-]?[0-9])", re.IGNORECASE
    ),
)


class Number(NamedTuple):
    """The parts of a number, as they are written.

    Attributes
    ----------
    chapter : str
        The chapter: a number of the workbook, a word of a course.
    problem : str
        The problem within it.
    row : str
        The row of numbers of a variant, else "".
    """

    chapter: str
    problem: str
    row: str = ""

    @property
    def base(self):
        """The problem without the row: "2.4" of 2.4~17."""
        return f"{self.chapter}.{self.problem}"

    @property
    def label(self):
        """The number in labels: "2-4" in ex-2-4."""
        return f"{self.chapter}-{self.problem}"

    @property
    def handed_out(self):
        """The name of the notebook that students get, without a row: "ch2-p04.ipynb"."""
        return f"ch{self.chapter}-p{self.problem:0>2}.ipynb"

    @property
    def order(self):
        """A key by which numbers are sorted, the workbook's first."""
        word = self.chapter.rstrip("0123456789")
        return word, int(self.chapter[len(word) :] or 0), int(self.problem), int(self.row or 0)

    def file(self, suffix):
        """Return the file below its folder: ch2/p04.md for 2.4 and ".md"."""
        row = f"~{self.row}" if self.row else ""
        return Path(f"ch{self.chapter}") / f"p{self.problem:0>2}{row}{suffix}"


def read_number(text):
    """Return the `Number` in a text, None if it is none.

    >>> read_number("rob2.14~3")
    Number(chapter='rob2', problem='14', row='3')
    >>> read_number("rob"), read_number("2.4 ")
    (None, None)
    """
    text = str(text)
    match = NUMBER.fullmatch(text) if len(text) <= MOST_LETTERS else None
    return Number(*match.groups("")) if match else None


def number_of_file(path):
    """Return the `Number` of a master or a notebook by its file, None if its name has none.

    >>> number_of_file(Path("solutions/chrob/p01.md")).base
    'rob.1'
    """
    path = PurePath(path)
    number = read_number(f"{path.parent.name[2:]}.{path.stem[1:].lstrip('0')}")
    fits = number is not None and path.parts[-2:] == number.file(path.suffix).parts
    return number if fits else None


def files_by_number(folder, suffix):
    """Return the files ch1/p15 with a suffix below a folder, in the order of their numbers."""
    paths = {path: number_of_file(path) for path in Path(folder).glob(f"ch*/p*{suffix}")}
    return sorted((p for p, number in paths.items() if number), key=lambda p: paths[p].order)


def base_number(number):
    """Return the problem of a variant, or the problem itself.

    >>> base_number("2.4~17"), base_number("2.4")
    ('2.4', '2.4')
    """
    return number.partition("~")[0]


def number_of_name(stem):
    """Return the problem that the name of a submitted file gives, or None.

    Such names are 1.15, 1_15, rob.1, ch1-p15, Copy of ch1-p15, Ann_123_chrob-p01 (1).
    """
    numbers = {
        ((chapter or word).lower(), problem)
        for chapter, word, problem in HANDED_OUT_NAME.findall(stem)
    }
    if not numbers and (match := SHORT_NAME.fullmatch(stem) or NUMBER.fullmatch(stem)):
        numbers = {match.groups()[:2]}
    return ".".join(numbers.pop()) if len(numbers) == 1 else None


def numbers_within(stem):
    """Return all that may be numbers of problems within the name of a file.

    >>> sorted(numbers_within("hw2 ann 1.15")), sorted(numbers_within("ann_rob.1"))
    (['1.15'], ['rob.1'])
    """
    return {
        f"{chapter.lower()}.{problem}"
        for pattern in WITHIN_NAME
        for chapter, problem in pattern.findall(stem)
    }

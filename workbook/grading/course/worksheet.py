"""Moodle's grading worksheet: who takes part in an assignment, and when each handed in.

Moodle writes headers, words and dates in the language of the lecturer, so columns are known by
their form: the participants are a word with a number ("Participant 101"), the same word in each
line; the addresses have an @; the times are dates, of which the last column is that of the grade
and the one before it that of the submission. A date that cannot be read is no date: better the time
is unknown than wrong.
"""

import re
from dataclasses import dataclass
from datetime import datetime

from workbook.grading.course.assignment import InputError
from workbook.grading.course.csv_files import parse, read_text
from workbook.grading.course.roster import duplicates

PARTICIPANT = re.compile(r"(?P<word>\D*[^\W\d_]\D*?)\s*(?P<number>\d+)")
#: Characters of a cell that may be a participant, an address or a date; a student's text is longer,
#: and patterns are not to search it.
MAX_CELL = 300
ADDRESS = re.compile(r"[^/\s.][^/\s]*@[^/\s]+")
#: What Moodle writes in place of a time that is not there.
NO_TIME = "-"
CLOCK = re.compile(r"(\d{1,2}):(\d{2})(?::(\d{2}))?(?:\s*([ap])\.?\s?m\b)?", re.IGNORECASE)
YEAR, DAY = re.compile(r"(?<!\d)(\d{4})(?!\d)"), re.compile(r"(?<!\d)(\d{1,2})(?!\d)")
#: Other numbers are of another calendar.
YEARS = range(2000, 2200)
WORD = re.compile(r"[^\W\d_]+")
#: 2026-06-10, 2026/6/10, 2026年6月10日; 10.06.2026.
YEAR_FIRST = re.compile(r"(?<!\d)(\d{4})\s?[-./年]\s?(\d{1,2})\s?[-./月]\s?(\d{1,2})(?!\d)")
YEAR_LAST = re.compile(r"(?<!\d)(\d{1,2})\.\s?(\d{1,2})\.\s?(\d{4})(?!\d)")
#: The months in English, German, Dutch, French, Spanish, Italian, Portuguese, Russian, Ukrainian.
#: Whole words: marraskuu is November in Finnish, and martes a Tuesday.
MONTHS = (
    "january jan januar januari janvier janv enero ene gennaio janeiro января январь січня",
    "february feb februar februari février febrero febbraio fevereiro февраля февраль лютого",
    "march mar märz maart mars marzo março марта март березня",
    "april apr avril abril aprile апреля апрель квітня",
    "may mai mei maj mayo maggio maio мая май травня",
    "june jun juni juin junio giugno junho июня июнь червня",
    "july jul juli juillet julio luglio julho июля июль липня",
    "august aug augustus augusti août agosto августа август серпня",
    "september sep sept septembre septiembre settembre setembro сентября сентябрь вересня",
    "october oct oktober octobre octubre ottobre outubro октября октябрь жовтня",
    "november nov novembre noviembre novembro ноября ноябрь листопада",
    "december dec dezember décembre diciembre dicembre dezembro декабря декабрь грудня",
)
MONTH_OF = {word: number for number, words in enumerate(MONTHS, 1) for word in words.split()}


@dataclass(frozen=True)
class Participant:
    """A line of the worksheet.

    Parameters
    ----------
    name, address : str
        "" if Moodle hides them.
    submitted : float or None
        When something was handed in, in seconds since 1970.
    """

    name: str
    address: str
    submitted: float | None


def read(path, zone=None):
    """Return {number: `Participant`} from Moodle's grading worksheet.

    Parameters
    ----------
    path : path
        The file, as Moodle wrote it or a spreadsheet saved it.
    zone : datetime.tzinfo, optional
        The time zone of the lecturer at Moodle, which writes none; by default this computer's.

    Returns
    -------
    dict
        In the order of the file.

    Raises
    ------
    InputError
        If the file is no such worksheet, or names two participants alike.
    """
    _, lines = parse(read_text(path))
    columns = list(
        zip(*([cell if len(cell) <= MAX_CELL else "" for cell in line] for line in lines[1:]))
    )
    identifiers = max(columns, key=_participants, default=())
    if not identifiers or _participants(identifiers) == 0:
        raise InputError(
            f"{path} is not a grading worksheet of Moodle: no column has participants with their "
            "numbers, such as Participant 101"
        )
    matches = [PARTICIPANT.fullmatch(cell.strip()) for cell in identifiers]
    numbers = [match["number"] if match else "" for match in matches]
    addresses = max(columns, key=lambda column: sum(map(_is_address, column)))
    if repeated := duplicates(numbers):
        raise InputError(f"{path} has the participant {', '.join(repeated)} more than once")
    if repeated := duplicates([cell.strip() for cell in addresses if _is_address(cell)]):
        raise InputError(f"{path} has the address {', '.join(repeated)} more than once")
    names = _names(columns, identifiers, matches)
    times = _submission_times(columns)
    return {
        number: Participant(
            name, address.strip() if _is_address(address) else "", time(submitted, zone)
        )
        for number, name, address, submitted in zip(numbers, names, addresses, times)
        if number
    }


def time(text, zone=None):
    """Return the seconds since 1970 of a date as Moodle writes it, or None if it cannot be read.

    The date is of a time `zone`, by default this computer's.

    >>> time("Tuesday, 1 September 2026, 2:14 PM") == time("вторник, 1 сентября 2026, 14:14")
    True
    """
    clock = CLOCK.search(text)
    if not clock:
        return None
    hour, minute, second = (int(part or 0) for part in clock.groups()[:3])
    if half := clock[4]:
        hour = hour % 12 + 12 * (half.lower() == "p")
    date = _date(text[: clock.start()] + " " + text[clock.end() :])
    try:
        when = datetime(*date, hour, minute, second, tzinfo=zone) if date else None
        return when.timestamp() if when else None
    except (ValueError, OverflowError):
        return None


def _date(text):
    """Return (year, month, day) of a date without its time of day, or None."""
    if match := YEAR_FIRST.search(text):
        year, month, day = match.groups()
    elif match := YEAR_LAST.search(text):
        day, month, year = match.groups()
    else:
        year, day = YEAR.search(text), DAY.search(text)
        months = {MONTH_OF.get(word) for word in WORD.findall(text.casefold())} - {None}
        if not (year and day and len(months) == 1):
            return None
        year, month, day = year[1], months.pop(), day[1]
    return (int(year), int(month), int(day)) if int(year) in YEARS else None


def _participants(column):
    """Return how many different participants a column has, if it is one of participants."""
    matches = [PARTICIPANT.fullmatch(cell.strip()) for cell in column if cell.strip()]
    if not matches or None in matches or len({match["word"] for match in matches}) > 1:
        return 0
    return len({match["number"] for match in matches})


def _is_address(cell):
    return ADDRESS.fullmatch(cell.strip()) is not None


def _names(columns, identifiers, matches):
    """Return the names beside the identifiers, or the word of these where names are hidden.

    Then there are no addresses either, and beside the identifiers is a status, one of a few, or
    with a number of days. A name may have a digit.
    """
    neighbours = columns[(columns.index(identifiers) + 1) % len(columns)]
    likely = {cell for cell in neighbours if not re.search(r"[\d@]", cell)}
    others = [column for column in columns if column is not neighbours]
    has_addresses = any(_is_address(cell) for column in others for cell in column)
    if has_addresses or len(likely) > len(neighbours) / 2:
        return neighbours
    return [match["word"] if match else "" for match in matches]


def _submission_times(columns):
    """Return the column of the times of submission: the last but one of those with dates.

    Columns before it, as of due dates, are there only if some participant has an own due date.
    """
    dated = [column for column in columns if all(map(_is_date_or_dash, column))]
    return dated[-2] if len(dated) > 1 else [""] * len(columns[0])


def _is_date_or_dash(cell):
    """Return whether a cell has the form of a date, in whatever language, or says there is none."""
    return cell.strip() == NO_TIME or bool(CLOCK.search(cell) and YEAR.search(cell))

"""Dates of a route, and a calendar of it in the format iCalendar (RFC 5545)."""

from datetime import date, timedelta

from workbook.routes.course import UnknownRoute


def week_dates(route, starts):
    """Return the first day of each week.

    Parameters
    ----------
    route : Route
        With its terms.
    starts : list of datetime.date
        The first day of each term; terms without one follow without a break.

    Raises
    ------
    UnknownRoute
        If there are more days than terms, or a term begins before the one before it ends.
    """
    if len(starts) > len(route.terms):
        terms = f"{len(route.terms)} term{'s' * (len(route.terms) > 1)}"
        raise UnknownRoute(f"{route.title} has {terms}, so that many first days at most")
    dates = []
    for k, weeks in enumerate(route.terms):
        after = dates[-1] + timedelta(weeks=1) if dates else date.min
        first = starts[k] if k < len(starts) else after
        if first < after:
            raise UnknownRoute(f"term {k + 1} begins on {first}, but term {k} lasts until {after}")
        dates += [first + timedelta(weeks=week) for week in range(weeks)]
    return dates


def to_ics(route, dates, texts):
    """Return a calendar with an event of a whole week, or of one evening, for each week.

    Parameters
    ----------
    route : Route
    dates : list of datetime.date
        The first day of each week.
    texts : list of (str, str)
        Title and description of each week.

    Returns
    -------
    str
        With the ends of lines and the folding that the format asks for.
    """
    lines = ["BEGIN:VCALENDAR", "VERSION:2.0", "PRODID:-//Controlled Motion//routes//EN"]
    days = 7 if route.unit == "week" else 1
    for k, (first, (title, description)) in enumerate(zip(dates, texts, strict=True), start=1):
        lines += [
            "BEGIN:VEVENT",
            f"UID:{route.name}-{k}-{first:%Y%m%d}@controlled-motion",
            f"DTSTAMP:{dates[0]:%Y%m%d}T000000Z",  # the same file each time
            f"DTSTART;VALUE=DATE:{first:%Y%m%d}",
            f"DTEND;VALUE=DATE:{first + timedelta(days=days):%Y%m%d}",
            f"SUMMARY:{_escaped(title)}",
            f"DESCRIPTION:{_escaped(description)}",
            "TRANSP:TRANSPARENT",
            "END:VEVENT",
        ]
    return "".join(f"{_folded(line)}\r\n" for line in [*lines, "END:VCALENDAR"])


def _escaped(text):
    for sign in "\\;,":
        text = text.replace(sign, f"\\{sign}")
    return text.replace("\n", "\\n")


def _folded(line):
    """Return a line in pieces of at most 75 bytes, each but the first after a space."""
    pieces, piece = [], ""
    for letter in line:
        if len((piece + letter).encode()) > 75:
            pieces.append(piece)
            piece = " "
        piece += letter
    return "\r\n".join([*pieces, piece])

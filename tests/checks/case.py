"""One row of a check's table of cases: the table is the check's test and its page in the book."""

from dataclasses import dataclass
from operator import attrgetter

from workbook import checks

NOT_CHECKS = {
    "NotYet",
    "Unusable",
    "Verdict",
    "collecting",
    "hide_direction",
    "judged",
    "kept_for_grading",
    "report",
}
#: The names of all checks, those of the research chapters with their package.
CHECKS = sorted({*dir(checks)} - NOT_CHECKS | {f"research.{name}" for name in dir(checks.research)})


#: Instead of a verdict: the data are refused, whatever the answer is.
REFUSED = "refused"


def check_named(name):
    """Return the check with a name as `Case.check` gives it, perhaps with a dot."""
    return attrgetter(name)(checks)


@dataclass(frozen=True)
class Case:
    check: str
    answer: object
    data: tuple
    verdict: str
    note: str
    options: tuple = ()

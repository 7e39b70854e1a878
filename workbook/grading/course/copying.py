"""Copying: what pairs of students share that few others have.

Shared are whole notebooks, wrong answers in the very same form, and lines of code of their own. What
many have is no sign of anything, so only what at most a twentieth of the class has, or three
students, counts. Nothing is decided here: a lecturer looks at what is shared and at how common it is.
"""

from collections import Counter, defaultdict
from dataclasses import dataclass
from itertools import combinations

from workbook.checks.contract.verdict import MISSING, WRONG

#: The share of the class, and the number of students, up to which something is rare.
RARE_SHARE, RARE_COUNT = 0.05, 3
#: From this many rare wrong answers or lines on a pair is shown; lines are also most of one's own.
LEAST_ANSWERS, LEAST_LINES, LEAST_LINE_SHARE = 2, 4, 0.6
#: Shorter lines are everybody's.
LEAST_LENGTH = 12


@dataclass(frozen=True)
class Pair:
    """Two students, and what both have: (problem and name, or line; how many students have it)."""

    students: tuple
    kind: str
    shared: tuple


def pristine_lines(exercise):
    """Return the lines of code that a notebook is handed out with."""
    return frozenset(_lines(source for _, source in exercise.cells))


def own_lines(sources, pristine):
    """Return the lines of code that a notebook has beyond the pristine ones."""
    return frozenset(line for line in _lines(sources) if len(line) >= LEAST_LENGTH) - pristine


def pairs(scores, lines):
    """Return the pairs that share something rare, the longest first.

    Parameters
    ----------
    scores : list of StudentScore
        The scores of the class.
    lines : dict
        The own lines of code by student.

    Returns
    -------
    list of Pair
        Of the kinds "identical notebooks", "wrong answers" and "lines of code".
    """
    notebooks, answers = defaultdict(set), defaultdict(set)
    for score in scores:
        for problem, attempt in score.counted.items():
            if any(verdict.status != MISSING for verdict in attempt.verdicts.values()):
                notebooks[score.student].add((problem, attempt.content))
        for answer in score.answers:
            if answer.verdict.status == WRONG and answer.hash:
                name = f"{answer.problem} {answer.answer}"
                answers[score.student].add((name, answer.hash))
    limit = max(RARE_COUNT, RARE_SHARE * len(scores))
    counts = Counter(line for own in lines.values() for line in own)
    rare_lines = {
        student: {line for line in own if counts[line] <= limit} for student, own in lines.items()
    }
    lines_of_pairs = [
        pair
        for pair in _sharing(rare_lines, "lines of code", LEAST_LINES, limit)
        if len(pair.shared)
        >= LEAST_LINE_SHARE * min(len(rare_lines[student]) for student in pair.students)
    ]
    return [
        *_sharing(notebooks, "identical notebooks", 1, limit),
        *_sharing(answers, "wrong answers", LEAST_ANSWERS, limit),
        *lines_of_pairs,
    ]


def _sharing(items, kind, least, limit):
    """Return the pairs that share `least` items or more, which at most `limit` students have."""
    owners = defaultdict(list)
    for student in sorted(items):
        for item in items[student]:
            owners[item].append(student)
    shared = defaultdict(list)
    for item, students in owners.items():
        if 1 < len(students) <= limit:
            name = item if isinstance(item, str) else item[0]
            for pair in combinations(students, 2):
                shared[pair].append((name, len(students)))
    result = [
        Pair(students, kind, tuple(sorted(names, key=lambda entry: (entry[1], entry[0]))))
        for students, names in shared.items()
        if len(names) >= least
    ]
    return sorted(result, key=lambda pair: (-len(pair.shared), pair.students))


def _lines(sources):
    """Yield the lines of code without comments, with single spaces."""
    for source in sources:
        for line in source.splitlines():
            yield " ".join(line.partition("#")[0].split())

"""Tell a notebook of this course from one of another with the same number.

A notebook carries the name of its course and a fingerprint of its statement: the smallest hashes of
its words, numbers and signs left out. The share of words that two statements have in common can be
estimated from these. A notebook is foreign if it names another course, or if its statement has fewer
than a third of its words in common with the problem here. So a corrected or reworded statement, and
the same one with other numbers, is the same problem. A notebook without these marks, as they were
handed out before, counts by its number.
"""

import hashlib
import re

#: Words whose hashes are kept, and the letters of each.
WORDS, LETTERS = 32, 4
#: The share of words in common from which on two statements are of one problem.
SHARE = 1 / 3
WORD = re.compile(r"[a-z]{3,}")
FINGERPRINT = re.compile(rf"(?:[0-9a-f]{{{LETTERS}}}){{1,{WORDS}}}")


def fingerprint(text):
    """Return the fingerprint of a statement.

    >>> fingerprint("Find the roots of $x + 1$.") == fingerprint("Find the roots of $x + 2$!")
    True
    """
    words = set(WORD.findall(text.lower()))
    return "".join(
        sorted({hashlib.sha256(w.encode()).hexdigest()[:LETTERS] for w in words})[:WORDS]
    )


def share(one, other):
    """Return the estimated share of all words of two statements that both have.

    >>> share(fingerprint("stability of a pendulum"), fingerprint("Stability of the pendulum"))
    0.6666666666666666
    """
    first, second = _hashes(one), _hashes(other)
    smallest = sorted(first | second)[:WORDS]
    return sum(hash in first and hash in second for hash in smallest) / len(smallest)


def marks_of(about):
    """Return (course, fingerprint) of the metadata of a notebook, "" for what is not there."""
    course, fingerprint = about.get("course"), about.get("fingerprint")
    return (
        course if isinstance(course, str) and re.fullmatch(r"[a-z]{1,20}", course) else "",
        fingerprint if isinstance(fingerprint, str) and FINGERPRINT.fullmatch(fingerprint) else "",
    )


def why_foreign(marks, exercise):
    """Return why a notebook with these marks is not of an exercise, "" if it is or may be."""
    (course, fingerprint), (own_course, own) = marks, marks_of(exercise.about)
    number = exercise.number.partition("~")[0]
    if course and own_course and course != own_course:
        return f"it is problem {number} of the course {course}, not of {own_course}"
    if fingerprint and own and share(fingerprint, own) < SHARE:
        return f"it is another problem {number}: its statement is not that of the problem here"
    return ""


def _hashes(fingerprint):
    return {fingerprint[k : k + LETTERS] for k in range(0, len(fingerprint), LETTERS)}

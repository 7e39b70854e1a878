"""Objections: what students write against a grade, and what the lecturer answers.

A student hands in a file `objection.md` or `objection.txt`, as any other file. The lecturer answers
in `graded/HOMEWORK/replies/STUDENT.md`. Both are kept in `grades.json` with their dates, also when
the files change or go: so a second objection stands beside the first.
"""

import re
from dataclasses import dataclass
from pathlib import Path

from workbook.grading.sandbox import submitted_file
from workbook.grading.sandbox.sanitising import normalise_name, sanitise

NAME = re.compile(r"objection[^/]*\.(md|txt)", re.IGNORECASE)
#: Characters of one that are kept.
MAX_LENGTH = 20_000


@dataclass(frozen=True)
class Objection:
    """An objection of a student, and the reply to it, "" as long as there is none."""

    student: str
    text: str
    noted: str
    reply: str = ""
    replied: str = ""


def is_objection(path):
    """Return whether a file is one, by its name."""
    return NAME.fullmatch(path.name) is not None


def handed_in(submitted, assignment):
    """Return [(student, text)] of all objections to the grades of a homework."""
    texts = []
    for path in sorted(Path(submitted).glob("*/*/*")):
        student, homework = (normalise_name(part) for part in path.parts[-3:-1])
        if homework != assignment or not is_objection(path):
            continue
        if not any(part.is_symlink() for part in (path, *path.parents[:2])):
            texts.append((student, _text(path)))
    return texts


def updated(former, texts, replies, when):
    """Return all objections so far.

    Parameters
    ----------
    former : list of Objection
        Those on record, oldest first.
    texts : list of (str, str)
        Student and text of those that lie there now.
    replies : path
        The folder of replies.
    when : str
        The time of what is new.

    Returns
    -------
    list of Objection
        A reply belongs to the student's newest objection, unless it is on record for another.
    """
    objections = list(former)
    for student, text in texts:
        if (student, text) not in {(old.student, old.text) for old in objections}:
            objections.append(Objection(student, text, when))
    newest = {objection.student: k for k, objection in enumerate(objections)}
    used = {(old.student, old.reply) for old in objections}
    for path in sorted(Path(replies).glob("*.md")):
        student, reply = normalise_name(path.stem), _text(path)
        if student in newest and reply and (student, reply) not in used:
            old = objections[newest[student]]
            objections[newest[student]] = Objection(student, old.text, old.noted, reply, when)
    return objections


def _text(path):
    try:
        # A character has at most four bytes; what is cut is not looked at.
        content = submitted_file.content(path)[: 4 * MAX_LENGTH + 4].decode("utf-8", "replace")
    except (OSError, submitted_file.UnreadableFileError) as error:
        content = f"(this file cannot be read: {error})"
    text = sanitise(content.strip(), keep="\n\t")
    return text if len(text) <= MAX_LENGTH else f"{text[:MAX_LENGTH]} ..."

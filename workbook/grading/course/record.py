"""Record: the grades last written, and every change of them.

It is the file graded/<assignment>/grades.json. A regrade, a resubmission, points given by hand or a
changed assignment file can change a grade that students have seen. Each run compares its grades
with those written before, and lists which answers changed and why. The file is replaced as a whole,
after all others, so the changes of a run that is killed are either listed already or listed by the
next run.
"""

import json
from contextlib import suppress
from dataclasses import dataclass

from workbook.grading.course.assignment import InputError
from workbook.grading.course.objections import Objection


@dataclass(frozen=True)
class Change:
    """A change of the verdict or the points of one answer, and its reason."""

    when: str
    student: str
    problem: str
    answer: str
    old_verdict: str
    new_verdict: str
    old_points: float
    new_points: float
    reason: str


#: Reasons for more than one kind of change.
POINTS_CHANGED = "the assignment's points changed"
LATENESS_CHANGED = "lateness counts otherwise"
NOT_ASKED, ASKED_AGAIN = "the homework asks for it no longer", "the homework asks for it again"
EXEMPT = "the student is exempt from it"
#: In the place of a verdict.
NO_VERDICT = "not asked for"


def compared(path, assignment, scores, when, objections=()):
    """Compare the scores with the grades written to `path`.

    Returns (changes since then, all changes so far, the text to write there now); `when` is the
    time of the new changes as text, `objections` are all so far.
    """
    before, students = read(path), _students(scores, assignment.numbers)
    former = [Change(**change) for change in before["changes"]]
    new = _changes(
        before["students"],
        students,
        {(p, a) for p, answers in assignment.points.items() for a in answers},
        when,
    )
    new += _asked_again(former, before["students"], students, when)
    all_changes = [*former, *new]
    head = {
        "assignment": assignment.name,
        "title": assignment.title,
        "max points": assignment.max_points,
    }
    parts = [
        *(f"{_json(key)}: {_json(value)}" for key, value in head.items()),
        f'"students": {{\n{_lines(f"{_json(k)}: {_json(v)}" for k, v in students.items())}}}',
        f'"changes": [\n{_lines(_json(vars(change)) for change in all_changes)}]',
        f'"objections": [\n{_lines(_json(vars(objection)) for objection in objections)}]',
    ]
    return new, all_changes, f"{{{_lines(parts)}}}\n"


def _json(value):
    return json.dumps(value, ensure_ascii=False)


def _lines(entries):
    """Return entries of JSON, one a line: a student's grades are a line, which can be compared."""
    return ",\n".join(entries)


def read(path):
    """Return the grades last written, as plain data, or empty ones; raises `InputError`."""
    try:
        grades = json.loads(path.read_text(encoding="utf-8"))
        _check(grades)
        return grades
    except FileNotFoundError:
        return {"students": {}, "changes": []}
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror}") from None
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        raise InputError(
            f"{path} is not as workbook grade wrote it: move it away and grade again, and changes "
            "are told from there on"
        ) from None


def _check(grades):
    """Raise some error for data that are not grades."""
    for student in grades["students"].values():
        for answer in student["answers"]:
            texts, numbers = (
                (answer["problem"], answer["answer"], answer["verdict"]),
                (answer["points"], answer["max points"]),
            )
            if not all(isinstance(text, str) for text in texts) or not all(
                type(number) in (int, float) for number in numbers
            ):
                raise TypeError
            answer["notebook"], answer["by hand"], answer["judged by"]
    for objection in grades.get("objections", []):
        Objection(**objection)
    for change in grades["changes"]:
        Change(**change).old_points + change["new_points"] + 0.0


def objections(path):
    """Return the objections on record in a file of grades; raises `InputError`."""
    return [Objection(**objection) for objection in read(path).get("objections", [])]


def put(path, text):
    """Write a text file completely or not at all; raises `InputError`."""
    # Names of folders need not be Unicode text.
    put_bytes(path, text.encode("utf-8", "backslashreplace"))


def put_bytes(path, data):
    """Write a file completely or not at all; raises `InputError`."""
    temporary = path.with_name(f".{path.name[:100]}.writing")
    with suppress(OSError):
        if path.read_bytes() == data:  # renaming waits for the disk, once for each page of a class
            return
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        temporary.write_bytes(data)
        temporary.replace(path)
    except OSError as error:
        with suppress(OSError):
            temporary.unlink()
        raise InputError(
            f"{path} cannot be written: {error.strerror}; nothing that was there is lost"
        ) from None


def _students(scores, numbers):
    """Return the scores as plain data; `numbers` has the rows where students have their own."""
    return {
        score.student: {
            "points": score.points,
            "late": list(score.late),
            "exempt": list(score.exempt),
            "needs review": score.needs_review,
            **({"numbers": numbers.get(score.student, {})} if numbers is not None else {}),
            "answers": [_answer(score, answer) for answer in score.answers],
        }
        for score in scores
    }


def _answer(score, answer):
    attempt = score.counted.get(answer.problem)
    return {
        "problem": answer.problem,
        "answer": answer.answer,
        "verdict": answer.verdict.status,
        "message": answer.verdict.message,
        "mistake": answer.verdict.mistake,
        "points": answer.points,
        "max points": answer.max_points,
        "by hand": answer.manual,
        "points by hand": answer.by_hand,
        "given by": answer.given_by,
        "share": answer.share,
        # Hashes: of the notebook that counts, and of the problem and checks that it was judged by.
        "notebook": attempt.content if attempt else None,
        "judged by": attempt.exercise if attempt else None,
    }


def _changes(before, after, current_answers, when):
    """Return the changes of existing grades; `current_answers` are the (problem, answer) asked for now.

    What is graded for the first time is no change.
    """
    changes = []
    for student in {**after, **before}:
        now = _by_answer(after.get(student))
        for name, was in _by_answer(before.get(student)).items():
            was_absent = was["notebook"] is None and was["by hand"] is None
            if name not in now:
                if was["points"] > 0:
                    reason = _why_gone(name, after.get(student), current_answers)
                    changes.append(
                        Change(
                            when,
                            student,
                            *name,
                            was["verdict"],
                            NO_VERDICT,
                            was["points"],
                            0.0,
                            reason,
                        )
                    )
            elif not (was_absent and now[name]["notebook"] is not None) and (
                was["verdict"] != now[name]["verdict"]
                or abs(was["points"] - now[name]["points"]) > 1e-9
            ):
                changes.append(
                    Change(
                        when,
                        student,
                        *name,
                        was["verdict"],
                        now[name]["verdict"],
                        was["points"],
                        now[name]["points"],
                        _why(was, now[name]),
                    )
                )
    return changes


def _why_gone(name, student, current_answers):
    if name not in current_answers:
        return NOT_ASKED
    exempt = {name[0], ".".join(name)}.intersection(student["exempt"]) if student else ()
    return EXEMPT if exempt else "points by hand taken back"


def _asked_again(former, before, after, when):
    """Return the changes of answers that the homework had ceased to ask for, and asks for again."""
    last = {(change.student, change.problem, change.answer): change for change in former}
    gone = {key for key, change in last.items() if change.new_verdict == NO_VERDICT}
    return [
        Change(when, student, *name, NO_VERDICT, now["verdict"], 0.0, now["points"], ASKED_AGAIN)
        for student, graded in after.items()
        for name, now in _by_answer(graded).items()
        if (student, *name) in gone
        and name not in _by_answer(before.get(student))
        and now["points"] > 0
    ]


def _by_answer(student):
    return (
        {(answer["problem"], answer["answer"]): answer for answer in student["answers"]}
        if student
        else {}
    )


def _why(was, now):
    if _by_hand(was) != _by_hand(now):
        if now["by hand"] is None:
            return "points by hand taken back"
        return "points given by hand" + (f" by {now['given by']}" if now["given by"] else "")
    if now["by hand"] is not None and was["points"] != now["points"]:
        return POINTS_CHANGED
    if was["notebook"] != now["notebook"]:
        return "another attempt counts"
    versions = {_version(was), _version(now)}
    if len(versions) == 2 and "failed" not in versions:
        return "the problem or its checks changed"
    if was["max points"] != now["max points"]:
        return POINTS_CHANGED
    if was.get("share", 1.0) != now["share"]:
        return LATENESS_CHANGED
    return "graded again"


def _by_hand(answer):
    """Return (comment, points) that were entered by hand, or None."""
    return (
        None
        if answer["by hand"] is None
        else (answer["by hand"], answer.get("points by hand", answer["points"]))
    )


def _version(answer):
    """Return the version of the problem, without the limits that may follow it."""
    return (answer["judged by"] or "").split(" ")[0]

"""What was last written of a homework, and every change since: graded/<assignment>/grades.json.

A regrade, a resubmission, points given by hand or a changed assignment file can change a grade that
students have seen. Each run compares its grades with those written before, and says which answers
changed and why. The file is replaced whole, after everything else, so a run that is killed has
either told its changes or tells them next time.
"""

import json
from contextlib import suppress
from dataclasses import dataclass

from workbook.grading.assignment import BadInput


@dataclass(frozen=True)
class Change:
    """One answer whose verdict or points are not what they were."""

    when: str
    student: str
    problem: str
    answer: str
    old_verdict: str
    new_verdict: str
    old_points: float
    new_points: float
    why: str


#: Reasons that are given in more than one case.
POINTS_CHANGED = "the assignment's points changed"
NOT_ASKED, ASKED_AGAIN = "the homework asks for it no longer", "the homework asks for it again"
#: In the place of a verdict.
NO_VERDICT = "not asked for"


def compared(path, assignment, scores, when):
    """(changes since the grades were written to `path`, all changes so far, the text to write there
    now). `when` is a text."""
    before, students = read(path), _students(scores)
    former = [Change(**change) for change in before["changes"]]
    new = _changes(
        before["students"],
        students,
        {(p, a) for p, answers in assignment.points.items() for a in answers},
        when,
    )
    new += _asked_again(former, before["students"], students, when)
    everything = [*former, *new]
    text = json.dumps(
        {
            "assignment": assignment.name,
            "title": assignment.title,
            "max points": assignment.max_points,
            "students": students,
            "changes": [vars(change) for change in everything],
        },
        ensure_ascii=False,
        indent=1,
    )
    return new, everything, text + "\n"


def read(path):
    """The grades last written, as plain data; nobody and no change where nothing was written yet.
    Raises `BadInput`."""
    try:
        given = json.loads(path.read_text(encoding="utf-8"))
        _check(given)
        return given
    except FileNotFoundError:
        return {"students": {}, "changes": []}
    except OSError as error:
        raise BadInput(f"{path} cannot be read: {error.strerror}") from None
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        raise BadInput(
            f"{path} is not as workbook grade wrote it; grade without it, and changes are told "
            "from there on"
        ) from None


def _check(given):
    """Fails on what cannot be read as grades."""
    for student in given["students"].values():
        for answer in student["answers"]:
            texts, numbers = (
                (answer["problem"], answer["answer"], answer["verdict"]),
                (answer["points"], answer["max points"]),
            )
            if not all(isinstance(one, str) for one in texts) or not all(
                type(one) in (int, float) for one in numbers
            ):
                raise TypeError
            answer["notebook"], answer["by hand"], answer["judged by"]
    for change in given["changes"]:
        Change(**change).old_points + change["new_points"] + 0.0


def put(path, text):
    """Write a file whole or not at all."""
    # Names of folders need not be text; what cannot be written as UTF-8 is shown by its number.
    put_bytes(path, text.encode("utf-8", "backslashreplace"))


def put_bytes(path, data):
    beside = path.with_name(f".{path.name[:100]}.writing")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        beside.write_bytes(data)
        beside.replace(path)
    except OSError as error:
        with suppress(OSError):
            beside.unlink()
        raise BadInput(
            f"{path} cannot be written: {error.strerror}; nothing that was there is lost"
        ) from None


def _students(scores):
    return {
        score.student: {
            "points": score.points,
            "late": list(score.late),
            "needs review": score.needs_review,
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
        # The notebook that counts and the version of the problem it was judged by, each as a
        # hash.
        "notebook": attempt.content if attempt else None,
        "judged by": attempt.exercise if attempt else None,
    }


def _changes(before, after, asked, when):
    """Changes of grades that stood before; what is graded for the first time is no change. `asked`
    are (problem, answer)."""
    changes = []
    for student in {**after, **before}:
        now = _by_answer(after.get(student))
        for name, was in _by_answer(before.get(student)).items():
            is_new = was["notebook"] is None and was["by hand"] is None
            if name not in now:
                if was["points"] > 0:
                    why = "points by hand taken back" if name in asked else NOT_ASKED
                    changes.append(
                        Change(
                            when,
                            student,
                            *name,
                            was["verdict"],
                            NO_VERDICT,
                            was["points"],
                            0.0,
                            why,
                        )
                    )
            elif not (is_new and now[name]["notebook"] is not None) and (
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


def _asked_again(former, before, after, when):
    """Points that went when the homework asked for an answer no longer, and are back."""
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
        return "points given by hand" if now["by hand"] is not None else "points by hand taken back"
    if now["by hand"] is not None and was["points"] != now["points"]:
        return POINTS_CHANGED
    if was["notebook"] != now["notebook"]:
        return "another attempt counts"
    versions = {_version(was), _version(now)}
    if len(versions) == 2 and "failed" not in versions:
        return "the problem or its checks changed"
    if was["max points"] != now["max points"]:
        return POINTS_CHANGED
    return "graded again"


def _by_hand(answer):
    """The comment and the points that were entered, or None."""
    return (
        None
        if answer["by hand"] is None
        else (answer["by hand"], answer.get("points by hand", answer["points"]))
    )


def _version(answer):
    """The version of the problem alone: after it may stand the limits that the notebook met."""
    return (answer["judged by"] or "").split(" ")[0]

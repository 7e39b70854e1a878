"""What was last written of a homework, and every change since: graded/<assignment>/grades.json.

A regrade, a resubmission, points given by hand or a changed assignment file can change a grade that students have seen.
Each run compares its grades with those written before, and says which answers changed and why. The file is replaced
whole, so a run that is killed has either told its changes or tells them next time.
"""

import json
from dataclasses import dataclass

from trajlib.grading.assignment import BadInput


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


def bring_up_to_date(path, assignment, scores, when):
    """Write the grades to `path`; returns (changes of this run, all changes so far). `when` is a text."""
    before = read(path)
    new = _changes(before["students"], _students(scores), when)
    everything = [*(Change(**change) for change in before["changes"]), *new]
    text = json.dumps({"assignment": assignment.name, "title": assignment.title, "max points": assignment.max_points,
                       "students": _students(scores), "changes": [vars(change) for change in everything]}, ensure_ascii=False, indent=1)
    put(path, text + "\n")
    return new, everything


def read(path):
    """The grades last written, as plain data; nobody and no change where nothing was written yet. Raises `BadInput`."""
    if not path.exists():
        return {"students": {}, "changes": []}
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except ValueError:
        raise BadInput(f"{path} is not as trajlib grade wrote it; grade without it, and changes are told from there on") from None


def put(path, text):
    """Write a file whole or not at all."""
    # Names of folders need not be text; what cannot be written as UTF-8 is shown by its number.
    put_bytes(path, text.encode("utf-8", "backslashreplace"))


def put_bytes(path, data):
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f".{path.name[:100]}.writing")
    beside.write_bytes(data)
    beside.replace(path)


def _students(scores):
    return {score.student: {"points": score.points, "late": list(score.late), "needs review": score.needs_review,
                            "answers": [_answer(score, answer) for answer in score.answers]} for score in scores}


def _answer(score, answer):
    attempt = score.counted.get(answer.problem)
    return {"problem": answer.problem, "answer": answer.answer, "verdict": answer.verdict.status, "message": answer.verdict.message,
            "points": answer.points, "max points": answer.max_points, "by hand": answer.manual,
            # The notebook that counts and the version of the problem it was judged by, each as a hash.
            "notebook": attempt.content if attempt else None, "judged by": attempt.exercise if attempt else None}


def _changes(before, after, when):
    """Changes of grades that stood before; what is graded for the first time is no change."""
    changes = []
    for student, now in after.items():
        old = {(answer["problem"], answer["answer"]): answer for answer in before.get(student, {"answers": []})["answers"]}
        for answer in now["answers"]:
            was = old.get((answer["problem"], answer["answer"]))
            if was is None or (was["notebook"] is None and was["by hand"] is None and answer["notebook"] is not None):
                continue
            if was["verdict"] != answer["verdict"] or abs(was["points"] - answer["points"]) > 1e-9:
                changes.append(Change(when, student, answer["problem"], answer["answer"], was["verdict"], answer["verdict"],
                                      was["points"], answer["points"], _why(was, answer)))
    return changes


def _why(was, now):
    if was["by hand"] != now["by hand"] or (now["by hand"] is not None and was["points"] != now["points"]):
        return "points given by hand" if now["by hand"] is not None else "points by hand taken back"
    if was["notebook"] != now["notebook"]:
        return "another attempt counts"
    versions = {_version(was), _version(now)}
    if len(versions) == 2 and "failed" not in versions:
        return "the problem or its checks changed"
    if was["max points"] != now["max points"]:
        return "the assignment's points changed"
    return "graded again"


def _version(answer):
    """The version of the problem alone: after it may stand the limits that the notebook met."""
    return (answer["judged by"] or "").split(" ")[0]

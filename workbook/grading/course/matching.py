"""Matching: which problem a notebook is for, and which problems a homework has."""

from pathlib import PurePath

from workbook.grading.course import assignment as assignments
from workbook.grading.course.submissions import LeftAside, Submission
from workbook.notebooks import exercises
from workbook.notebooks.origin import why_foreign
from workbook.numbering import numbers_within, read_number

#: From this number of students on, a problem that only one of them handed in is not asked for.
MIN_CLASS = 3


def infer_homework(name, entries):
    """Infer a homework without a file from its notebooks.

    Every problem that a student handed in adds to the points of all, so one that a single student
    of a class handed in, while others share the rest, is not asked for.

    Parameters
    ----------
    name : str
        The homework's.
    entries : list of Submission or LeftAside
        All that was submitted.

    Returns
    -------
    tuple
        (the `Assignment`, {problem: why its notebooks are left aside}).
    """
    students = {}
    for entry in entries:
        if (
            isinstance(entry, Submission)
            and entry.assignment == name
            and entry.problem
            and is_known_problem(entry.problem)
        ):
            students.setdefault(entry.problem, set()).add(entry.student)
    numbers = sorted(students, key=lambda number: read_number(number).order)
    shared = [number for number in numbers if len(students[number]) > 1]
    reasons = {}
    if shared and len(set().union(*students.values())) >= MIN_CLASS:
        reasons = {
            number: f"only {min(students[number])} handed in problem {number}, while others share "
            f"{', '.join(shared)}: "
            f"it is not taken for part of {name}; an assignment.toml would say what is"
            for number in numbers
            if number not in shared
        }
    return assignments.of_problems(
        name, [number for number in numbers if number not in reasons]
    ), reasons


def why_no_homework(submission, files):
    """Return why a notebook is for no homework, where `files` (by name) say which there are."""
    name, student = submission.assignment, submission.student
    similar = [
        file_name for file_name in files if file_name.casefold().strip() == name.casefold().strip()
    ]
    if similar:
        return f"there is no homework {name}; {similar[0]} is another name: rename the folder"
    if student in files:
        return (
            f"{student} is a homework, so this has to lie in {name}/{student}: first the student, "
            "then the homework"
        )
    return (
        f"there is no homework {name}: no assignment.toml stands in a folder of this name beside "
        "the others"
    )


def problem_for(submission, homework):
    """Return the problem of the homework that a notebook is for, or a `LeftAside`."""
    named, owner = submission.problem, (submission.student, submission.assignment)
    if named in homework.problems:
        foreign = why_foreign(submission.marks, exercises.find(named))
        return LeftAside(submission.path, foreign, *owner) if foreign else named
    if named is not None and is_known_problem(named):
        return LeftAside(
            submission.path,
            f"it is for problem {named}, which this homework does not ask for",
            *owner,
            named,
        )
    in_name = numbers_within(PurePath(submission.path).stem)
    if len(asked := in_name.intersection(homework.problems)) == 1:
        return asked.pop()
    if len(homework.problems) == 1:  # it names none, and there is only one it can be
        return homework.problems[0]
    problems_text = f" ({', '.join(homework.problems)})" if homework.problems else ""
    return LeftAside(
        submission.path,
        submission.trouble
        or f"it does not say which problem of the homework it is for{problems_text}",
        *owner,
    )


def one_of_each_hand_in(copies):
    """Keep one notebook a problem of what a student handed in at once.

    Else a hand-in of many notebooks would be as many attempts. The one that is new there counts,
    of several new ones the system's newest; where the system does not order them, the last by name.

    Parameters
    ----------
    copies : dict
        {(student, homework, problem, content): its submissions}.

    Returns
    -------
    tuple
        (such a dictionary of what counts, a `LeftAside` for each of the others).
    """
    newest = {}
    for (*attempted, _), submissions in copies.items():
        for submission in (one for one in submissions if one.rank):
            hand_in = (*attempted, submission.submitted)
            newest[hand_in] = max(newest.get(hand_in, submission), submission, key=_order)
    counting, others = {}, []
    for (*attempted, content), submissions in copies.items():
        kept = [
            submission
            for submission in submissions
            if not submission.rank or newest[*attempted, submission.submitted].content == content
        ]
        if kept:
            counting[*attempted, content] = kept
            continue
        other = submissions[0]
        name = PurePath(newest[*attempted, other.submitted].path).name
        reason = f"of what is handed in at once one file a problem counts, here {name}"
        others.append(LeftAside(other.path, reason, other.student, other.assignment, is_extra=True))
    return counting, others


def _order(submission):
    # What cannot be read does not take the place of what can.
    return not submission.trouble, submission.rank


def is_known_problem(number):
    """Return whether the workbook has a problem of this number, written exactly so."""
    try:
        return exercises.find(number).number == number
    except exercises.UnknownExercise:
        return False

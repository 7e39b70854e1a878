"""Which problems a homework without a file asks for, and which of its problems a notebook is
for."""

from workbook.grading import assignment as assignments
from workbook.grading.submissions import Aside, Submission
from workbook.notebooks import exercises

#: From so many students on, a problem that one of them alone handed in is taken for a stray.
CLASS = 3


def unwritten(name, found):
    """(the homework that its notebooks themselves make, {problem: why its notebooks are left
    aside}).

    Every problem that somebody handed in adds to everybody's points, so one that a single student
    of a class handed in, while others share the rest, is not asked for.
    """
    givers = {}
    for one in found:
        if (
            isinstance(one, Submission)
            and one.assignment == name
            and one.problem
            and is_ours(one.problem)
        ):
            givers.setdefault(one.problem, set()).add(one.student)
    numbers = sorted(givers, key=lambda number: [int(part) for part in number.split(".")])
    shared = [number for number in numbers if len(givers[number]) > 1]
    alone = {}
    if shared and len(set().union(*givers.values())) >= CLASS:
        alone = {
            number: f"only {min(givers[number])} handed in problem {number}, while others share "
            f"{', '.join(shared)}: "
            f"it is not taken for part of {name}; an assignment.toml would say what is"
            for number in numbers
            if number not in shared
        }
    return assignments.of_problems(
        name, [number for number in numbers if number not in alone]
    ), alone


def no_homework(submission, files):
    """Why a notebook is for no homework where files say which there are, in words that lead to the
    one it is for; `files` are these by the names of the homeworks."""
    name, student = submission.assignment, submission.student
    alike = [one for one in files if one.casefold().strip() == name.casefold().strip()]
    if alike:
        return f"there is no homework {name}; {alike[0]} is another name: rename the folder"
    if student in files:
        return f"{student} is a homework, so this has to lie in {name}/{student}: first the student, then the homework"
    return f"there is no homework {name}: no assignment.toml stands in a folder of this name beside the others"


def problem_for(submission, homework):
    """The problem of the homework that a notebook is for, or an `Aside`."""
    named, whose = submission.problem, (submission.student, submission.assignment)
    if named in homework.problems:
        return named
    if named is not None and is_ours(named):
        return Aside(
            submission.path,
            f"it is for problem {named}, which this homework does not ask for",
            *whose,
            named,
        )
    if len(homework.problems) == 1:  # it names none, and there is only one it can be
        return homework.problems[0]
    asked = f" ({', '.join(homework.problems)})" if homework.problems else ""
    return Aside(
        submission.path,
        submission.trouble or f"it does not say which problem of the homework it is for{asked}",
        *whose,
    )


def is_ours(number):
    """Whether the workbook has a problem of this number, written just so."""
    try:
        return exercises.find(number).number == number
    except exercises.UnknownExercise:
        return False

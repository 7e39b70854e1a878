"""Console summary: what `workbook grade` prints on a homework, for the lecturer to act on.

Everything else is in the files.
"""

from workbook.grading.course import ledger
from workbook.grading.course.handing_out import due_text
from workbook.grading.course.ledger import IN_TIME, LATE, UNKNOWN
from workbook.grading.reports.canvas import Gradebook, different_points
from workbook.grading.reports.pages import count

#: Changes of grades, and points by hand that are too many, that are printed one by one.
MAX_LISTED = 20


def print_summary(console, folder, assignment, graded, changes, file):
    """Print how many handed in, what needs a look, and what changed.

    Parameters
    ----------
    console : rich.console.Console
        Where to print.
    folder : Path
        The homework's results.
    assignment : Assignment
        The homework.
    graded : list of StudentScore
        The scores of the class.
    changes : list of Change
        Those since the last run.
    file : Path or None
        The assignment's.
    """

    def print_line(line, **options):
        console.print(line, markup=False, **options)

    print_line(
        f"{assignment.name}: {assignment.max_points:g} points, "
        + (f"due {due_text(assignment.due)}, " if assignment.due else "no due date, ")
        + (
            f"by {file}"
            if file
            else "one for each answer, since there is no assignment.toml for it"
        )
    )
    if not file:
        numbers = {
            problem: sum(problem in score.counted for score in graded)
            for problem in assignment.problems
        }
        problems = [
            f"{problem} (from {count(number, 'student')})" for problem, number in numbers.items()
        ]
        print_line(f"  problems: {', '.join(problems)}")
    handed_in, late = (
        sum(score.handed_in for score in graded),
        sum(bool(score.late) for score in graded),
    )
    print_line(
        f"  {handed_in} of {len(graded)} students handed something in, {late} late; tables and "
        f"pages in {folder}"
    )
    if absent := [score.student for score in graded if score.is_absent]:
        print_line(f"  handed in nothing: {', '.join(absent)}")
    if unknown := assignment.policy.students - {score.student for score in graded}:
        print_line(
            "  extensions, exemptions or labels in assignment.toml for nobody here: "
            f"{', '.join(sorted(unknown))}",
            style="yellow",
        )
    timings = [{score.counted[problem].timing for problem in score.untimed} for score in graded]
    if untimed := sum(UNKNOWN in of_student for of_student in timings):
        print_line(
            f"  of {count(untimed, 'student')} it is not known when they handed in, which costs them "
            "nothing: workbook collect --worksheet reads it from Moodle",
            style="yellow",
        )
    if marked := sum(bool(of_student & {LATE, IN_TIME}) for of_student in timings):
        print_line(
            f"  of {count(marked, 'student')} Canvas says only whether it was late, which costs and "
            f"gains them nothing: write the time into the column submitted of {ledger.NAME}, as "
            "2026-10-02 10:00:00+03:00",
            style="yellow",
        )
    waiting, unusable = (
        sum(score.needs_review for score in graded),
        sum(len(score.unusable) for score in graded),
    )
    if waiting:
        print_line(
            f"  {waiting} need your look: {folder / 'summary.html'} says which answers could not "
            "be judged, and what was left aside; Moodle, Canvas and nbgrader get no grade of "
            "theirs yet",
            style="yellow",
        )
    if unusable:
        print_line(
            f"  {count(unusable, 'notebook')} could not be read or run: {folder / 'summary.html'} "
            "says whose, and why",
            style="yellow",
        )
    capped = [
        f"{score.student} {answer.problem} {answer.answer} ({answer.by_hand:g}, worth "
        f"{answer.max_points:g})"
        for score in graded
        for answer in score.answers
        if answer.is_capped
    ]
    if capped:
        print_line(
            "  points by hand above what the answer is worth now count as that: "
            f"{', '.join(_shortened(capped))}",
            style="yellow",
        )
    if changes:
        print_line(
            f"  {len(changes)} "
            f"{'answer is not what it was' if len(changes) == 1 else 'answers are not what they were'}:"
        )
    for change in changes[:MAX_LISTED]:
        print_line(f"    {_change_text(change)}", highlight=False)
    if len(changes) > MAX_LISTED:
        print_line(f"    and {len(changes) - MAX_LISTED} more, all in {folder / 'changes.csv'}")


def print_objections(console, folder, students):
    """Print which students' objections have no reply."""
    if students:
        console.print(
            f"  objections without a reply: {', '.join(dict.fromkeys(students))}; "
            f"{folder / 'summary.html'} has them, {folder / 'replies'}/STUDENT.md takes your reply",
            markup=False,
            style="yellow",
        )


def print_roster_differences(console, assignment, roster, unknown):
    """Print how the grades differ from the roster: students `unknown` there, and points."""
    if unknown:
        console.print(f"  not in the roster: {', '.join(unknown)}", markup=False, style="yellow")
    if isinstance(roster, Gradebook) and (possible := different_points(assignment, roster)):
        console.print(
            f"  Canvas has {possible} points possible for {assignment.title}, the homework has "
            f"{assignment.max_points:g}: "
            "its points are written as they are; make the two equal, there or in assignment.toml",
            markup=False,
            style="yellow",
        )


def _shortened(names):
    return (
        names
        if len(names) <= MAX_LISTED
        else [*names[:MAX_LISTED], f"and {len(names) - MAX_LISTED} more"]
    )


def _change_text(change):
    verdicts = (
        [change.old_verdict]
        if change.old_verdict == change.new_verdict
        else [change.old_verdict, change.new_verdict]
    )
    return (
        f"{change.student} {change.problem} {change.answer}: {' -> '.join(verdicts)}, "
        f"{change.old_points:g} -> {change.new_points:g} points ({change.reason})"
    )

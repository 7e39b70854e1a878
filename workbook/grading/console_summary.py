"""What `workbook grade` says of a homework on the terminal: what a lecturer has to know now;
everything else is in the files."""

from workbook.grading.canvas import difference
from workbook.grading.handing_out import spoken
from workbook.grading.pages import count

#: Changes of grades, and points by hand that are too many, that are told one by one.
MOST_TOLD = 20


def tell(console, folder, assignment, graded, changes, file):
    """Say on a rich `console` how many handed in, what waits for a look, and what changed; `file`
    is the assignment's, or None."""

    def say(line, **look):
        console.print(line, markup=False, **look)

    say(
        f"{assignment.name}: {assignment.max_points:g} points, "
        + (f"due {spoken(assignment.due)}, " if assignment.due else "no due date, ")
        + (
            f"by {file}"
            if file
            else "one for each answer, since there is no assignment.toml for it"
        )
    )
    if not file:
        givers = {
            problem: sum(problem in score.counted for score in graded)
            for problem in assignment.problems
        }
        told = [
            f"{problem} (from {count(number, 'student')})" for problem, number in givers.items()
        ]
        say(f"  problems: {', '.join(told)}")
    handed_in, late = (
        sum(score.handed_in for score in graded),
        sum(bool(score.late) for score in graded),
    )
    say(
        f"  {handed_in} of {len(graded)} students handed something in, {late} late; tables and "
        f"pages in {folder}"
    )
    waiting, spoilt = (
        sum(score.needs_review for score in graded),
        sum(len(score.spoilt) for score in graded),
    )
    if waiting:
        say(
            f"  {waiting} need your look: {folder / 'summary.html'} says which answers could not "
            "be judged, and what was left aside; Moodle, Canvas and nbgrader get no grade of "
            "theirs yet",
            style="yellow",
        )
    if spoilt:
        say(
            f"  {count(spoilt, 'notebook')} could not be read or run: {folder / 'summary.html'} "
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
        say(
            "  points by hand above what the answer is worth now count as that: "
            f"{', '.join(_some(capped))}",
            style="yellow",
        )
    if changes:
        say(
            f"  {len(changes)} "
            f"{'answer is not what it was' if len(changes) == 1 else 'answers are not what they were'}:"
        )
    for change in changes[:MOST_TOLD]:
        say(f"    {_told(change)}", highlight=False)
    if len(changes) > MOST_TOLD:
        say(f"    and {len(changes) - MOST_TOLD} more, all in {folder / 'changes.csv'}")


def tell_of_roster(console, assignment, roster, strangers):
    """Say in what the gradebook of Canvas and the grades differ."""
    if strangers:
        console.print(f"  not in the roster: {', '.join(strangers)}", markup=False, style="yellow")
    if possible := difference(assignment, roster):
        console.print(
            f"  Canvas has {possible} points possible for {assignment.title}, the homework has "
            f"{assignment.max_points:g}: "
            "its points are written as they are; make the two equal, there or in assignment.toml",
            markup=False,
            style="yellow",
        )


def _some(names):
    return (
        names
        if len(names) <= MOST_TOLD
        else [*names[:MOST_TOLD], f"and {len(names) - MOST_TOLD} more"]
    )


def _told(change):
    verdicts = (
        [change.old_verdict]
        if change.old_verdict == change.new_verdict
        else [change.old_verdict, change.new_verdict]
    )
    return (
        f"{change.student} {change.problem} {change.answer}: {' -> '.join(verdicts)}, "
        f"{change.old_points:g} -> {change.new_points:g} points ({change.why})"
    )

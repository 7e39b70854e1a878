"""Answers that a homework keeps for its grading."""

from workbook.checks.contract.verdict import RIGHT, UNCHECKED, Verdict, judged


@judged
def _readable(answer):
    return "it can be read"


def kept_for_grading(answer):
    """Return the verdict on an answer that is judged only when the homework is graded.

    It stands in the handed-out notebook in the place of the answer's check. An answer that is missing
    or that no check could read is reported at once.

    Examples
    --------
    >>> kept_for_grading(...).message
    'not answered yet'
    >>> kept_for_grading(5).message
    'it can be read, and is judged in the grading'
    """
    verdict = _readable(answer)
    if verdict.status == RIGHT:
        return Verdict(UNCHECKED, "it can be read, and is judged in the grading")
    return verdict

"""The eigenvalues at which the rank of Popov's criterion falls: of a system with an output by
Theorem 2.3, with a control by Theorem 2.4, and by Theorems 2.5 and 2.6 of a mechanical one."""

from workbook.checks.contract.verdict import judged
from workbook.checks.references.records import by_control, reached, seen
from workbook.checks.structure.dual_questions import CONTROL, EIGENVALUES, OUTPUT, judge_eigenvalues
from workbook.checks.structure.mechanical import DRIVEN, SEEN, judge_roots
from workbook.systems import Mechanical


@judged(EIGENVALUES)
def fixed_eigenvalues(claim, system, parameters=()):
    """The different eigenvalues of A, for a `Mechanical` system the values of lambda, at which the
    rank falls, of the matrix with the output or, if it has one, with the control; an empty list or
    set if there are none.

    With parameters: for their values in general position, as the assumptions allow.
    """
    control = by_control(system)
    if isinstance(system, Mechanical):
        return judge_roots(
            claim, system.dual if control else system, parameters, DRIVEN if control else SEEN
        )
    return judge_eigenvalues(
        claim, (reached if control else seen)(system, parameters), CONTROL if control else OUTPUT
    )

"""Compare the two deciders of conditions: z3, and cells of a cylindrical decomposition.

    python benchmarks/deciders.py            # the tables of cases, minutes of processor time
    python benchmarks/deciders.py 1 2 3      # answers and trials of these chapters

Every answer that is a condition is judged with both, with z3 alone, and with cells alone, as in a
page. A verdict is decided if the last question about it is: samples are then not asked. Only the
time of the deciders counts, from empty caches. Verdicts that differ are printed, and slow ones.
"""

import functools
import statistics
import sys
import time
from collections import Counter, defaultdict
from contextlib import contextmanager
from pathlib import Path

import sympy as sp

from workbook.checks.tools.conditions import (
    comparison,
    decision,
    elimination,
    evaluation,
    polynomial_form,
    real_roots,
)

ROOT = Path(__file__).resolve().parents[1]
SETTINGS = ("both", "z3 alone", "cells alone")
#: Of the questions about one verdict: (seconds, whether it was decided).
asked = []


def _timed(function):
    def timed(*args):
        start = time.process_time()
        outcome = function(*args)
        asked.append((time.process_time() - start, outcome[0]))
        return outcome

    return timed


def _undecidable(*_):
    raise polynomial_form.Undecidable


@contextmanager
def setting(name):
    """Leave one decider out, and forget what others have computed."""
    for module in (decision, elimination, evaluation, polynomial_form, real_roots):
        for function in vars(module).values():
            if hasattr(function, "cache_clear") and function is not elimination.half_tangent:
                function.cache_clear()
    kept = decision.points_of_difference, decision.cells_of_symbol
    z3 = sys.modules.get("z3")
    if name == "z3 alone":
        decision.points_of_difference = decision.cells_of_symbol = _undecidable
    if name == "cells alone":
        sys.modules["z3"] = None
    try:
        yield
    finally:
        decision.points_of_difference, decision.cells_of_symbol = kept
        sys.modules["z3"] = z3


def tables():
    """Yield (name, function that judges) for the rows of the tables whose answers are conditions."""
    sys.path.insert(0, str(ROOT / "tests" / "checks"))
    from case import check_named
    from case_tables import CASES, LONG

    for case in CASES:
        check = check_named(case.check)
        if (
            case.verdict in ("right", "wrong")
            and isinstance(case.answer, sp.logic.boolalg.Boolean)
            and check.__module__.split(".")[-2] not in LONG
        ):
            yield (
                f"{case.check}: {case.note}",
                lambda case=case, check=check: check(case.answer, *case.data, **dict(case.options)),
            )


def answers(chapters):
    """Yield the same for the answers, trials and adversarial rows of the problems of chapters."""
    sys.path.insert(0, str(ROOT / "tests" / "problems"))
    from adversarial.tables import rows_of
    from harness import solve

    from workbook.authoring import master_paths, read
    from workbook.authoring.judged_problem import JudgedProblem

    for path in master_paths(ROOT / "solutions"):
        master = read(path)
        names = [n for n, a in master.answers.items() if a.kind.startswith(("condition", "set"))]
        if master.number.split(".")[0] in chapters and names:
            problem = JudgedProblem(master, solve(master)["answers"])
            for name in names:
                given = [problem.reference[name]]
                for role in ("right", "wrong"):
                    pairs = zip(master.trials[role], problem.given(role))
                    given += [value for trial, value in pairs if trial.name == name]
                given += [
                    eval(row.code, problem.data | problem.reference)
                    for row in rows_of(master.number)
                    if row.name == name
                ]
                yield from (
                    (f"{master.number} {name}", functools.partial(problem.judge_one, name, value))
                    for value in given
                )


def main():
    import z3  # noqa: F401  (loaded before the clock starts)

    comparison.find_difference = _timed(comparison.find_difference)
    comparison.find_numbers = _timed(comparison.find_numbers)
    questions = answers(sys.argv[1:]) if sys.argv[1:] else tables()
    decided, seconds, statuses = Counter(), defaultdict(list), Counter()
    for name, judge in questions:
        outcomes, times = {}, {}
        for which in SETTINGS:
            asked.clear()
            with setting(which):
                status = judge().status
            if not asked:
                break  # nothing was to decide
            outcomes[which] = status, asked[-1][1]
            times[which] = sum(taken for taken, _ in asked)
        if len(times) < len(SETTINGS):
            continue
        for which, (status, is_decided) in outcomes.items():
            decided[which] += is_decided
            statuses[which] += status == outcomes["both"][0]
            seconds[which].append(times[which])
        if len(set(outcomes.values())) > 1 or max(times.values()) > 1:
            shown = "; ".join(
                f"{which}: {status}, {'decided' if known else 'sampled'}, {times[which]:.2f} s"
                for which, (status, known) in outcomes.items()
            )
            print(f"{name}: {shown}", flush=True)
    for which, times in seconds.items():
        slow = sorted(times)[int(0.95 * len(times))]
        print(
            f"{which:12} {decided[which]} of {len(times)} decided, {statuses[which]} verdicts as with "
            f"both; median {1000 * statistics.median(times):.0f} ms, 95 % below "
            f"{slow:.2f} s, sum {sum(times):.1f} s"
        )


if __name__ == "__main__":
    main()

"""`workbook grade` with a clock beside the cells: what a notebook's own cells take, noted in the
very run that is timed.

    python benchmarks/cell_clock.py LOG grade submitted --out graded

Each notebook adds two kinds of lines to the file LOG, seconds on the clock and of a processor: one
for its data and answer cells in the sandbox, and one for each of its check cells where they judge.
Each cell counts once; that the grader runs data cells again before the notebook and before the
checks is its own affair. What the clock itself takes is not taken off either.
"""

import json
import sys
from dataclasses import replace
from pathlib import Path

from workbook.checks.contract.decoding import decode
from workbook.grading import forkserver, judging, worker_pool
from workbook.grading.sandbox import Sandbox

SPENT = "workbook_spent"
#: Not `time.process_time`: while a timer of processor time runs, as it does in a notebook's
#: process, that clock stands still between two ticks of the kernel.
CLOCKS = "time.perf_counter(), sum(resource.getrusage(resource.RUSAGE_SELF)[:2])"
BEGIN = f"import resource, time; workbook_began = {CLOCKS}"
SINCE = f"[now - began for now, began in zip(({CLOCKS}), workbook_began)]"


def main(log, *arguments):
    from workbook import cli

    folder = str(Path(__file__).resolve().parent)
    forkserver.START = (
        f"import sys; sys.path.insert(0, {folder!r}); import cell_clock; "
        f"cell_clock.serve({str(Path(log).resolve())!r}, {{control}}, {{modules!r}})"
    )
    sys.argv[1:] = arguments
    cli.main()


def serve(log, control, modules):
    """What a forkserver of the grader does; the lanes that it forks have a clock."""
    forkserver._KINDS["lane"] = lambda *given: work(log, *given)
    forkserver.main(control, modules)


def work(log, *given):
    """What a lane of the grader does, with a clock."""
    hand_in, outcome, judge_answers = Sandbox.hand_in, Sandbox.outcome, judging.judge_answers

    def clocked_hand_in(sandbox, sources, names, before=()):
        hand_in(sandbox, [BEGIN, *sources, f"{SPENT} = {SINCE}"], [*names, SPENT], before)

    def clocked_outcome(sandbox):
        found = outcome(sandbox)
        handed_over = json.loads(found.handed_over)
        note(log, decode(handed_over["encoded"].pop(SPENT).encode()))
        return replace(found, handed_over=json.dumps(handed_over).encode())

    def clocked_judge_answers(cells, *rest):
        start = ("check", BEGIN)
        stop = ("check", f"import cell_clock; cell_clock.note({log!r}, {SINCE})")
        return judge_answers(
            [
                each
                for cell in cells
                for each in ([start, cell, stop] if cell[0] == "check" else [cell])
            ],
            *rest,
        )

    Sandbox.hand_in, Sandbox.outcome, judging.judge_answers = (
        clocked_hand_in,
        clocked_outcome,
        clocked_judge_answers,
    )
    worker_pool.work(*given)


def note(log, seconds):
    with open(log, "a", encoding="utf-8") as file:
        file.write("{} {}\n".format(*map(float, seconds)))


if __name__ == "__main__":
    main(*sys.argv[1:])

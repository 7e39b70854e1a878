"""`workbook grade` with a clock around the cells, to time these within a timed run.

    python benchmarks/cell_clock.py LOG grade submitted --out graded

Each notebook adds two kinds of lines to the file LOG, seconds on the clock and of a processor: one
for its data and answer cells in the sandbox, and one for each of its check cells where they judge.
Each cell counts once: when the grader runs data cells again, before the notebook and before the
checks, that is its own overhead. The time of the clock itself is not subtracted.
"""

import json
import sys
from dataclasses import replace
from functools import partial
from pathlib import Path

from workbook.checks.contract.decoding import decode
from workbook.grading.pool import judging, worker_pool
from workbook.grading.sandbox import forkserver
from workbook.grading.sandbox.sandbox import Sandbox

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
    """Be a forkserver of the grader whose worker processes have a clock."""
    worker_pool.run_worker = partial(run_worker, worker_pool.run_worker, log)
    forkserver.main(control, modules)


def run_worker(original, log, *arguments):
    """Be a worker process of the grader, with a clock."""
    start_run, finish_run = Sandbox.start_run, Sandbox.finish_run
    judge_answers = judging.judge_answers

    def clocked_start_run(sandbox, sources, names, before=()):
        start_run(sandbox, [BEGIN, *sources, f"{SPENT} = {SINCE}"], [*names, SPENT], before)

    def clocked_finish_run(sandbox):
        outcome = finish_run(sandbox)
        handed_over = json.loads(outcome.handed_over)
        note(log, decode(handed_over["encoded"].pop(SPENT).encode()))
        return replace(outcome, handed_over=json.dumps(handed_over).encode())

    def clocked_judge_answers(cells, *rest):
        start = ("check", BEGIN)
        stop = ("check", f"import cell_clock; cell_clock.note({log!r}, {SINCE})")
        return judge_answers(
            [
                part
                for cell in cells
                for part in ([start, cell, stop] if cell[0] == "check" else [cell])
            ],
            *rest,
        )

    Sandbox.start_run, Sandbox.finish_run = clocked_start_run, clocked_finish_run
    judging.judge_answers = clocked_judge_answers
    original(*arguments)


def note(log, seconds):
    """Add a line with seconds of wall time and of processor time."""
    with open(log, "a", encoding="utf-8") as file:
        file.write("{} {}\n".format(*map(float, seconds)))


if __name__ == "__main__":
    main(*sys.argv[1:])

"""`trajlib grade` with a clock beside the cells: what a notebook's own cells take, noted in the very run that is timed.

    python benchmarks/cell_clock.py LOG grade submitted --out graded

Each notebook adds two numbers to the file LOG: the seconds of its data and answer cells in the sandbox, and those of
its check cells where they judge. Each cell counts once; that the grader runs data cells again before the notebook and
before the checks is its own affair. What the clock itself takes is not taken off either.
"""

import json
import sys
from dataclasses import replace
from pathlib import Path

from trajlib.grading import judging, lanes, nursery
from trajlib.grading.sandbox import Sandbox

SPENT = "trajlib_spent"
BEGIN, END = "import time; trajlib_began = time.perf_counter()", f"{SPENT} = time.perf_counter() - trajlib_began"


def main(log, *arguments):
    from trajlib import cli

    folder = str(Path(__file__).resolve().parent)
    nursery.START = (f"import sys; sys.path.insert(0, {folder!r}); import cell_clock; "
                     f"cell_clock.serve({str(Path(log).resolve())!r}, {{control}}, {{modules!r}})")
    sys.argv[1:] = arguments
    cli.main()


def serve(log, control, modules):
    """What a nursery of the grader does; the lanes that it forks have a clock."""
    nursery._KINDS["lane"] = lambda *given: work(log, *given)
    nursery.main(control, modules)


def work(log, *given):
    """What a lane of the grader does, with a clock."""
    hand_in, outcome, judge_answers = Sandbox.hand_in, Sandbox.outcome, judging.judge_answers

    def clocked_hand_in(sandbox, sources, names, before=()):
        hand_in(sandbox, [BEGIN, *sources, END], [*names, SPENT], before)

    def clocked_outcome(sandbox):
        found = outcome(sandbox)
        handed_over = json.loads(found.handed_over)
        note(log, float(handed_over["encoded"].pop(SPENT)))
        return replace(found, handed_over=json.dumps(handed_over).encode())

    def clocked_judge_answers(cells, *rest):
        start = ("check", BEGIN)
        stop = ("check", f"with open({log!r}, 'a') as log: log.write(f'{{time.perf_counter() - trajlib_began}}\\n')")
        return judge_answers([each for cell in cells
                              for each in ([start, cell, stop] if cell[0] == "check" else [cell])], *rest)

    Sandbox.hand_in, Sandbox.outcome, judging.judge_answers = clocked_hand_in, clocked_outcome, clocked_judge_answers
    lanes.work(*given)


def note(log, seconds):
    with open(log, "a", encoding="utf-8") as file:
        file.write(f"{seconds}\n")


if __name__ == "__main__":
    main(*sys.argv[1:])

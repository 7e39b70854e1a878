"""Judge an answered notebook in a forked process, and execute it with nbclient.

nbclient executes data, answer and check cells in a fresh kernel, as nbgrader and most course tools
do.
"""

import statistics
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
RUNS = 5


def main(number="1.15"):
    import matplotlib.pyplot  # noqa: F401  a forkserver has loaded it
    import nbclient
    import nbformat
    import sympy  # noqa: F401

    from workbook.authoring import read_master
    from workbook.notebooks import exercises
    from workbook.notebooks.execution import judge, run_notebook

    exercise = exercises.find(number)
    master = read_master(
        ROOT / "solutions" / exercise.path.parent.name / f"{exercise.path.stem}.md"
    )
    notebook = nbformat.v4.new_notebook(
        cells=[nbformat.v4.new_code_cell(s) for s in master.code("data", "answer", "check")]
    )
    cells = exercise.code("data", "check")
    # Afterwards the forked children find everything imported.
    run_notebook(master.code("data", "answer"), master.answers)

    runs, judgings, peers = [], [], []
    for _ in range(RUNS):
        start = time.perf_counter()
        run = run_notebook(master.code("data", "answer"), master.answers)
        middle = time.perf_counter()
        verdicts = judge(cells, run, master.answers)
        end = time.perf_counter()
        assert all(v.status == "right" for v in verdicts.values())
        judgings.append(end - middle)
        runs.append(end - start)
        start = time.perf_counter()
        nbclient.NotebookClient(notebook.copy(), kernel_name="python3").execute()
        peers.append(time.perf_counter() - start)
    run_judge, alone, nbclient_time = map(statistics.median, (runs, judgings, peers))
    print(
        f"problem {number}: run and judge {run_judge:.2f} s (judging alone {alone:.2f} s), "
        f"nbclient {nbclient_time:.2f} s (medians of {RUNS})"
    )
    print(
        f"nbclient takes {nbclient_time / run_judge:.1f} times as long as run and judge, "
        f"{nbclient_time / alone:.1f} times as long as judging"
    )


if __name__ == "__main__":
    main(*sys.argv[1:])

"""Grading a class with `trajlib grade` against `nbgrader autograde`, on the same notebooks in one run.

Overhead is the time on the clock less the cells' own run time, both measured in that very run: for nbgrader by the
times it leaves in each graded notebook, for trajlib by `cell_clock.py`. trajlib runs with its sandbox on; nbgrader has
none. Starting costs both a few seconds, which a small class feels and a large one does not: so what each further
notebook costs stands apart. While a notebook runs, one process of trajlib also gets its judge ready, and while that
judges, the next notebook's place: this uses a second core where one is idle. The growth with as many processes as
cores, where none is, shows what that hides. Growth is with students (four times as many) and processes.

    python benchmarks/grading.py [STUDENTS] [PROBLEM ...]
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from datetime import datetime
from pathlib import Path

from trajlib import exercises
from trajlib.masters import read
from trajlib.masters.contract import master_file

ROOT = Path(__file__).resolve().parents[1]
PYTHON, CLOCK = sys.executable, ROOT / "benchmarks" / "cell_clock.py"


def main(students=8, *problems):
    problems = problems or ("1.4", "1.15", "1.17")
    students = int(students)
    with tempfile.TemporaryDirectory() as scratch:
        course = Path(scratch)
        hand_in(course, students, problems)
        environment = os.environ | {"PATH": f"{Path(PYTHON).parent}{os.pathsep}{os.environ['PATH']}",
                                    "JUPYTER_CONFIG_DIR": scratch,
                                    "IPYTHONDIR": f"{scratch}/ipython", "OPENBLAS_NUM_THREADS": "1"}
        nbgrader(course, environment, "generate_assignment")
        theirs = timed(nbgrader, course, environment, "autograde")
        # everything is graded: what is left is starting and ending
        their_start = timed(nbgrader, course, environment, "autograde")
        graded = [json.loads(path.read_text(encoding="utf-8")) for path in course.glob("autograded/*/hw1/*.ipynb")]
        count, their_cells = len(graded), sum(map(seconds_in_cells, graded))
        assert count == students * len(problems)

        cores = len(os.sched_getaffinity(0))
        ours, our_cells = trajlib(course, environment, 1)
        side_by_side, _ = trajlib(course, environment, cores)
        multiply(course, students, 4)
        ours_of_4, our_cells_of_4 = trajlib(course, environment, 1)
        side_by_side_of_4, _ = trajlib(course, environment, cores)

    overhead, their_overhead = ours - our_cells, theirs - their_cells
    further, their_further = (ours_of_4 - ours) / (3 * count), (theirs - their_start) / count
    cells_further, their_cells_further = (our_cells_of_4 - our_cells) / (3 * count), their_cells / count
    ratio_further = (their_further - their_cells_further) / (further - cells_further)
    print(f"{students} students, problems {', '.join(problems)}: {count} notebooks, one process each, trajlib in its "
          f"sandbox")
    print(f"  nbgrader autograde {theirs:.1f} s: cells {their_cells:.1f} s, overhead {their_overhead:.1f} s")
    print(f"  trajlib grade      {ours:.1f} s: cells {our_cells:.1f} s, overhead {overhead:.1f} s")
    print(f"  nbgrader takes {theirs / ours:.1f} times as long, its overhead is {their_overhead / overhead:.1f} times "
          f"ours")
    print("each further notebook")
    print(f"  nbgrader autograde {their_further:.3f} s: cells {their_cells_further:.3f} s, overhead "
          f"{their_further - their_cells_further:.3f} s")
    print(f"  trajlib grade      {further:.3f} s: cells {cells_further:.3f} s, overhead "
          f"{further - cells_further:.3f} s")
    print(f"  nbgrader takes {their_further / further:.1f} times as long, its overhead is {ratio_further:.1f} times "
          f"ours")
    print(f"growth of trajlib grade, 1 process and {cores}")
    print(f"  {count} notebooks: {ours:.1f} s, {side_by_side:.1f} s")
    print(f"  {4 * count} notebooks: {ours_of_4:.1f} s, {side_by_side_of_4:.1f} s")


def hand_in(course, students, problems):
    """A source for nbgrader, and for each student the notebooks with all answers as in the worked solutions."""
    for problem in problems:
        exercise = exercises.find(problem)
        name = f"ch{problem.replace('.', '-p')}.ipynb"
        (course / "source" / "hw1").mkdir(parents=True, exist_ok=True)
        shutil.copy(exercise.path, course / "source" / "hw1" / name)
        notebook = json.loads(exercise.path.read_text(encoding="utf-8"))
        stubs = [cell for cell in notebook["cells"] if cell["metadata"].get("tags") == ["answer"]]
        for cell, source in zip(stubs, read(ROOT / "solutions" / master_file(problem)).code("answer"), strict=True):
            cell["source"] = source
        for k in range(students):
            # A remark of the student's own, since the same notebook twice would be one only by chance.
            notebook["cells"][0]["source"] = f"student {k}"
            place = course / "submitted" / f"student{k:04d}" / "hw1"
            place.mkdir(parents=True, exist_ok=True)
            (place / name).write_text(json.dumps(notebook), encoding="utf-8")


def multiply(course, students, factor):
    for k in range(students, students * factor):
        place = course / "submitted" / f"student{k:04d}"
        if not place.exists():
            shutil.copytree(course / "submitted" / f"student{k % students:04d}", place)


def nbgrader(course, environment, command):
    done = subprocess.run([PYTHON, "-m", "nbgrader", command, "hw1", f"--course-dir={course}"], cwd=course,
                          env=environment,
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def trajlib(course, environment, processes):
    """Grade everything from nothing; returns seconds on the clock and those of the cells."""
    shutil.rmtree(course / "graded", ignore_errors=True)
    log = course / "cells"
    log.write_text("", encoding="utf-8")
    begin = time.perf_counter()
    done = subprocess.run([PYTHON, CLOCK, log, "grade", "submitted", "--out", "graded", "--processes", str(processes),
                           "--json"],
                          cwd=course, env=environment, capture_output=True, text=True)
    seconds = time.perf_counter() - begin
    assert done.returncode == 0, done.stderr
    points = json.loads(done.stdout)["assignments"]["hw1"]
    assert set(points.values()) == {max(points.values())}, "all answers are right"
    clocked = log.read_text(encoding="utf-8").split()
    assert len(clocked) >= 2 * len(list(course.glob("submitted/*/hw1/*.ipynb"))), "each notebook was clocked"
    return seconds, sum(map(float, clocked))


def timed(function, *arguments):
    start = time.perf_counter()
    function(*arguments)
    return time.perf_counter() - start


def seconds_in_cells(notebook):
    """What nbgrader's kernel needed for the cells of one notebook, by the times it wrote down."""
    stamps = [cell["metadata"]["execution"] for cell in notebook["cells"] if cell["metadata"].get("execution")]
    spans = [[datetime.fromisoformat(each[event]) for event in ("iopub.execute_input", "shell.execute_reply")]
             for each in stamps]
    return sum((end - begin).total_seconds() for begin, end in spans)


if __name__ == "__main__":
    main(*sys.argv[1:])

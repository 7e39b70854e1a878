"""Grade a class with `workbook grade` and with `nbgrader autograde`, on the same notebooks.

Overhead is the time of a run minus the time of the cells themselves, both measured in that very
run: for nbgrader by the times that it leaves in each graded notebook (wall time) and by a cell
before the others (processor time), for workbook by `cell_clock.py`. Each is given as wall time and,
with all processes of a run, as processor time. workbook runs with its sandbox on; nbgrader has
none. Starting costs both a few seconds, which matters for a small class and not for a large one: so
the cost of each further notebook is given separately. The check cells of workbook take less than
those of nbgrader, since one process runs them for all notebooks and keeps what it has computed from
the data alone: a gain in cells, not in overhead. While a notebook is judged, one process of
workbook also prepares the process of the next: this uses a second core where one is idle. The
growth with as many processes as cores, where none is idle, shows what that hides; the best possible
is the processor time of one process divided by the number of cores. Growth is with students (four
times as many) and processes.

What is left of the overhead is mostly the price of importing, and of a process for each notebook.
To see its parts, in processor time: `perf record -g` over a run, summed by process, and by phase
where each phase gives its process another name (`prctl`, PR_SET_NAME). For 48 notebooks more than
half is spent once, whatever their number: by a forkserver that imports SymPy, IPython, NumPy and
what the homework uses (SciPy's `integrate` alone takes half as long as SymPy), and by the command's
own imports, of which Typer's of pydantic are the largest. Of the time for each notebook, more than
half is the kernel's: a fork of what is loaded, whose price grows with the number of mapped files
and of small pages, the namespaces, and the pages that a process copies as it writes to them, if
only to count references. The rest is reading and writing: answers, texts, results, pages. As long
as each notebook has a process of its own, which is what isolates them, the least possible is a bare
fork and exit of a process of that size; and at the start, the import of SymPy.

    python benchmarks/grading.py [STUDENTS] [PROBLEM ...]
"""

import copy
import json
import os
import shutil
import sys
import tempfile
from datetime import datetime
from pathlib import Path

from stopwatch import Taken, run

from workbook.authoring import read_master
from workbook.notebooks import exercises
from workbook.numbering import read_number

ROOT = Path(__file__).resolve().parents[1]
PYTHON, CLOCK = sys.executable, ROOT / "benchmarks" / "cell_clock.py"
#: Cells before and after the others in nbgrader's kernel, which sum up their processor time.
CLOCK_IN = """import time
workbook_clock = {"began": 0.0, "spent": 0.0}
get_ipython().events.register("pre_run_cell", lambda *_: workbook_clock.update(began=time.process_time()))
get_ipython().events.register("post_run_cell", lambda *_: workbook_clock.update(
    spent=workbook_clock["spent"] + time.process_time() - workbook_clock["began"]))
workbook_clock["began"] = time.process_time()"""
CLOCK_OUT = "print(workbook_clock['spent'])"


def main(students=8, *problems):
    problems = problems or ("1.4", "1.15", "1.17")
    students = int(students)
    with tempfile.TemporaryDirectory() as scratch:
        course = Path(scratch)
        hand_in(course, students, problems)
        environment = os.environ | {
            "PATH": f"{Path(PYTHON).parent}{os.pathsep}{os.environ['PATH']}",
            "JUPYTER_CONFIG_DIR": scratch,
            "IPYTHONDIR": f"{scratch}/ipython",
            "OPENBLAS_NUM_THREADS": "1",
        }
        nbgrader(course, environment, "generate_assignment")
        nbgrader_run = nbgrader(course, environment, "autograde")
        # Everything is graded by now: this is the time of starting and ending alone.
        nbgrader_start = nbgrader(course, environment, "autograde")
        graded = [
            json.loads(path.read_text(encoding="utf-8"))
            for path in course.glob("autograded/*/hw1/*.ipynb")
        ]
        count, nbgrader_cells = len(graded), sum(map(in_cells, graded), start=Taken(0, 0))
        assert count == students * len(problems)

        cores = len(os.sched_getaffinity(0))
        workbook_run, workbook_cells = workbook(course, environment, 1)
        side_by_side, _ = workbook(course, environment, cores)
        multiply(course, students, 4)
        workbook_run_of_4, workbook_cells_of_4 = workbook(course, environment, 1)
        side_by_side_of_4, _ = workbook(course, environment, cores)

    workbook_further = (
        (workbook_run_of_4 - workbook_run) / (3 * count),
        (workbook_cells_of_4 - workbook_cells) / (3 * count),
    )
    nbgrader_further = (nbgrader_run - nbgrader_start) / count, nbgrader_cells / count
    print(
        f"{students} students, problems {', '.join(problems)}: {count} notebooks, one process "
        "each, workbook in its sandbox"
    )
    compare((nbgrader_run, nbgrader_cells), (workbook_run, workbook_cells))
    print("each further notebook")
    compare(nbgrader_further, workbook_further)
    for times in (2, 4):
        print(f"{times * count} notebooks, extrapolated")
        compare(
            *(
                (
                    whole + each * ((times - 1) * count),
                    cells + cells_of_each * ((times - 1) * count),
                )
                for (whole, cells), (each, cells_of_each) in [
                    ((nbgrader_run, nbgrader_cells), nbgrader_further),
                    ((workbook_run, workbook_cells), workbook_further),
                ]
            )
        )
    print(f"growth of workbook grade, 1 process and {cores}, on the clock (processor)")
    for number, single, several in [
        (count, workbook_run, side_by_side),
        (4 * count, workbook_run_of_4, side_by_side_of_4),
    ]:
        print(
            f"  {number} notebooks: {single.wall:.1f} s ({single.processor:.1f} s), {several.wall:.1f} s "
            f"({several.processor:.1f} s): {single.wall / several.wall:.2f} times as fast, of "
            f"{min(cores, single.wall * cores / several.processor):.2f} that {cores} busy processors "
            "would give"
        )


def compare(nbgrader_run, workbook_run):
    """Print wall and processor time of each (whole, its cells)."""
    for name, (whole, cells) in [
        ("nbgrader autograde", nbgrader_run),
        ("workbook grade     ", workbook_run),
    ]:
        overhead = whole - cells
        print(
            f"  {name} {whole.wall:.3f} s: cells {cells.wall:.3f} s, overhead {overhead.wall:.3f} "
            f"s; processor {whole.processor:.3f} s: cells {cells.processor:.3f} s, overhead "
            f"{overhead.processor:.3f} s"
        )
    times, of_overhead = (
        nbgrader_run[0] / workbook_run[0],
        (nbgrader_run[0] - nbgrader_run[1]) / (workbook_run[0] - workbook_run[1]),
    )
    print(
        f"  nbgrader takes {times.wall:.1f} times as long, its overhead is {of_overhead.wall:.1f} "
        f"times ours; in processor time {times.processor:.1f} and {of_overhead.processor:.1f}"
    )


def hand_in(course, students, problems):
    """Make nbgrader's source, and each student's notebooks with right answers."""
    for problem in problems:
        exercise = exercises.find(problem)
        name = f"ch{problem.replace('.', '-p')}.ipynb"
        (course / "source" / "hw1").mkdir(parents=True, exist_ok=True)
        shutil.copy(exercise.path, course / "source" / "hw1" / name)
        notebook = json.loads(exercise.path.read_text(encoding="utf-8"))
        stubs = [cell for cell in notebook["cells"] if cell["metadata"].get("tags") == ["answer"]]
        # A student's notebook has a cell for each answer, a master one for several.
        answers = read_master(ROOT / "solutions" / read_number(problem).file(".md")).code("answer")
        for cell, source in zip(stubs, ["\n".join(answers)] + [""] * (len(stubs) - 1), strict=True):
            cell["source"] = source
        first = next(k for k, cell in enumerate(notebook["cells"]) if cell["cell_type"] == "code")
        for k in range(students):
            # A remark of the student's own: notebooks of a class are not equal.
            notebook["cells"][0]["source"] = f"student {k}"
            folder = course / "submitted" / f"student{k:04d}" / "hw1"
            folder.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(json.dumps(notebook), encoding="utf-8")
            clocked = copy.deepcopy(notebook)
            clocked["cells"].insert(first, code_cell("clock-in", CLOCK_IN))
            clocked["cells"].append(code_cell("clock-out", CLOCK_OUT))
            folder = course / "clocked" / f"student{k:04d}" / "hw1"
            folder.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(json.dumps(clocked), encoding="utf-8")


def code_cell(name, source):
    return {
        "cell_type": "code",
        "id": name,
        "metadata": {},
        "outputs": [],
        "execution_count": None,
        "source": source,
    }


def multiply(course, students, factor):
    for k in range(students, students * factor):
        folder = course / "submitted" / f"student{k:04d}"
        if not folder.exists():
            shutil.copytree(course / "submitted" / f"student{k % students:04d}", folder)


def nbgrader(course, environment, command):
    """Run a command of nbgrader on the notebooks with a clock; return the time `Taken`."""
    done, taken = run(
        [
            PYTHON,
            "-m",
            "nbgrader",
            command,
            "hw1",
            f"--course-dir={course}",
            "--CourseDirectory.submitted_directory=clocked",
        ],
        cwd=course,
        env=environment,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return taken


def workbook(course, environment, processes):
    """Grade everything afresh; return the time `Taken` by that and by its cells."""
    shutil.rmtree(course / "graded", ignore_errors=True)
    log = course / "cells"
    log.write_text("", encoding="utf-8")
    done, taken = run(
        [
            PYTHON,
            CLOCK,
            log,
            "grade",
            "submitted",
            "--out",
            "graded",
            "--processes",
            str(processes),
            "--json",
        ],
        cwd=course,
        env=environment,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    points = json.loads(done.stdout)["assignments"]["hw1"]
    assert set(points.values()) == {max(points.values())}, "all answers are right"
    clocked = [
        Taken(*map(float, line.split())) for line in log.read_text(encoding="utf-8").splitlines()
    ]
    assert len(clocked) >= 2 * len(list(course.glob("submitted/*/hw1/*.ipynb"))), (
        "each notebook was clocked"
    )
    return taken, sum(clocked, start=Taken(0, 0))


def in_cells(notebook):
    """Return the time `Taken` by nbgrader's kernel for the cells of one notebook."""
    cells = [
        cell
        for cell in notebook["cells"]
        if cell["cell_type"] == "code" and not cell["id"].startswith("clock-")
    ]
    stamps = [cell["metadata"]["execution"] for cell in cells if cell["metadata"].get("execution")]
    spans = [
        [
            datetime.fromisoformat(stamp[event])
            for event in ("iopub.execute_input", "shell.execute_reply")
        ]
        for stamp in stamps
    ]
    clocked = "".join(notebook["cells"][-1]["outputs"][0]["text"])
    return Taken(sum((end - begin).total_seconds() for begin, end in spans), float(clocked))


if __name__ == "__main__":
    main(*sys.argv[1:])

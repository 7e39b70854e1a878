"""Grade the course in the current folder with our grader (`python ours.py`)."""

import json
import os
import sqlite3
import subprocess
import sys
from contextlib import closing
from pathlib import Path

from workbook.grading.course import course
from workbook.grading.course.options import GradingOptions
from workbook.grading.pool.judging import Bounds
from workbook.grading.sandbox.limits import Limits

#: Tight, so that endless submissions end soon; honest ones need a third of it.
LIMITS = Limits(cpu_seconds=4, wall_seconds=8, memory_megabytes=512)
BOUNDS = Bounds(seconds=8, answer_seconds=3)


def run(here, environment, wasm=False, timeout=400):
    """Grade in a process of its own, in WebAssembly or not; return whether it came to its end."""
    with open(here / "output.txt", "wb") as output:
        # The password file stays open and is inherited, as careless programs do.
        with open(here / "solutions/secret.txt") as secret:
            done = subprocess.run(
                [sys.executable, __file__, *(["wasm"] if wasm else [])],
                cwd=here,
                env=os.environ | environment,
                stdout=output,
                stderr=output,
                timeout=timeout,
                pass_fds=[secret.fileno()],
            )
    return done.returncode == 0


def results(here):
    """Return {student: [{"verdicts", "answers", "remarks"}]} as stored."""
    by_student = {}
    with closing(sqlite3.connect(here / "graded/grades.sqlite")) as database:
        rows = database.execute(
            "SELECT student, verdicts, answers, remarks FROM attempt JOIN result ON "
            "result.attempt = attempt.id"
        )
        for student, *texts in rows:
            by_student.setdefault(student, []).append(
                dict(zip(("verdicts", "answers", "remarks"), map(json.loads, texts)))
            )
    return by_student


if __name__ == "__main__":
    course.grade(
        GradingOptions(
            Path("submitted"),
            Path("graded"),
            processes=2,
            limits=LIMITS,
            bounds=BOUNDS,
            wasm="wasm" in sys.argv,
        )
    )

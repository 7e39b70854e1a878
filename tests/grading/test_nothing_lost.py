"""A grader that is killed, at any point and any number of times, ends in the same grades."""

import os
import random
import signal
import sqlite3
import subprocess
import sys
import time
from contextlib import closing, suppress
from functools import partial
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import RIGHT_1_15, hand_in

KILLS = 15


def submit_a_course(folder):
    """Submit twelve files: right, wrong, incomplete, failing, broken, no notebook, twice."""
    for k, student in enumerate(("ada", "bela", "cyd", "dora", "ellen")):
        some = dict(list(RIGHT_1_15.items())[: k + 1])
        hand_in(
            folder,
            student,
            "1.15",
            some | ({"e_region": "(k1 > 0) & (k2 > 0)"} if k % 2 else {}),
            at=1e9 + k,
        )
    for student in ("ada", "bela", "cyd"):
        hand_in(
            folder,
            student,
            "1.4",
            {"a_matrix": "sp.Matrix([[0, 1], [-1, epsilon]])", "b_rate": "1/0"},
            at=1e9,
        )
    hand_in(folder, "ada", "1.15", RIGHT_1_15, at=1e9 + 9, name="ch1-p15-again.ipynb")
    hand_in(folder, "fay", "1.15", {"a_region": "__import__('os')._exit(1)"}, at=1e9)
    for student, content in (("gil", b"{"), ("hal", b"\xff\xfe")):
        path = hand_in(folder, student, "1.15", {}, at=1e9)
        path.write_bytes(content)
        os.utime(path, (1e9, 1e9))


def start(folder, out):
    """Start `workbook grade` in a process group of its own."""
    # What a shell starts in the background ignores Ctrl-C, and so would all that these tests start.
    heeding = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)
    return subprocess.Popen(
        [
            sys.executable,
            "-m",
            "workbook.cli",
            "grade",
            str(folder / "submitted"),
            "--out",
            str(out),
            "--processes",
            "2",
        ],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
        preexec_fn=heeding,
    )


def grades(out):
    """Return each row of the store without times and ids, to be compared."""
    with closing(sqlite3.connect(out / "grades.sqlite")) as database:
        return sorted(
            database.execute(
                "SELECT student, assignment, problem, content, submitted, exercise, verdicts, "
                "answers, remarks FROM attempt JOIN result ON result.attempt = attempt.id"
            )
        )


def count(out):
    """Return how many results are stored; reading does not disturb the grader."""
    try:
        with closing(
            sqlite3.connect(f"file:{out / 'grades.sqlite'}?mode=ro", uri=True, timeout=10)
        ) as database:
            return database.execute("SELECT count(*) FROM result").fetchone()[0]
    except sqlite3.OperationalError:
        return 0


def _stat(number):
    """Return (parent, start time) of a process; None if it has ended."""
    try:
        fields = Path(f"/proc/{number}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return None
    return None if fields[0] == "Z" else (int(fields[1]), fields[19])


def descendants(ancestor):
    """Return {(pid, start time)} of all descendants of a process."""
    living = {
        int(path.name): stat
        for path in Path("/proc").glob("[0-9]*")
        if (stat := _stat(int(path.name)))
    }
    below = {ancestor}
    while more := {number for number, (parent, _) in living.items() if parent in below} - below:
        below |= more
    return {(number, living[number][1]) for number in below - {ancestor} if number in living}


def outliving(processes, patience=5):
    """Return those of `processes` that still run after a while."""
    give_up = time.monotonic() + patience
    while (
        left := {
            process
            for process in processes
            if (stat := _stat(process[0])) and stat[1] == process[1]
        }
    ) and time.monotonic() < give_up:
        time.sleep(0.02)
    return left


@pytest.mark.slow
def test_a_killed_run_continues(tmp_path):
    submit_a_course(tmp_path)
    whole = tmp_path / "whole"
    began = time.monotonic()
    process = start(tmp_path, whole)
    output = process.communicate(timeout=300)
    assert process.returncode == 0, output
    lasted = time.monotonic() - began
    expected = grades(whole)
    assert len(expected) == 12 and {row[0] for row in expected} == {
        "ada",
        "bela",
        "cyd",
        "dora",
        "ellen",
        "fay",
        "gil",
        "hal",
    }

    chance, kills = random.Random(1), 0
    while kills < KILLS:
        out, before = tmp_path / f"killed-{kills}", 0
        while kills < KILLS and before < len(expected):
            process = start(tmp_path, out)
            wait_for_a_moment(process, out, before, lasted, chance)
            below = descendants(process.pid)
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.communicate(timeout=60)
            kills += 1
            assert count(out) >= before, "a result was lost"
            before = count(out)
            assert not outliving(below), "processes outlive the grader"
        process = start(tmp_path, out)
        output = process.communicate(timeout=300)
        assert process.returncode == 0, output
        assert grades(out) == expected
        for name in ("grades.csv", "moodle.csv"):
            assert (out / "hw1" / name).read_bytes() == (whole / "hw1" / name).read_bytes()


def wait_for_a_moment(process, out, before, lasted, chance):
    """Wait a random time, often until before anything is graded; or until a result was stored."""
    if chance.random() < 0.6:
        time.sleep(chance.uniform(0.1, 0.5 * lasted))
        return
    give_up = time.monotonic() + 60
    while count(out) <= before and process.poll() is None and time.monotonic() < give_up:
        time.sleep(0.005)
    time.sleep(chance.uniform(0, 0.05))


def test_an_interrupted_run_continues(tmp_path):
    submit_a_course(tmp_path)
    out = tmp_path / "graded"
    process = start(tmp_path, out)
    give_up = time.monotonic() + 60
    # two are no notebooks, and stored before anything runs
    while count(out) < 3 and time.monotonic() < give_up:
        time.sleep(0.01)
    below = descendants(process.pid)
    # As a terminal does it: to the whole group.
    os.killpg(process.pid, signal.SIGINT)
    _, output = process.communicate(timeout=60)
    assert process.returncode == 130 and below
    assert (
        output.decode().strip().split("\n")[-1]
        == "workbook: stopped; what is graded is stored, and the same command goes on from there"
    )
    assert b"Traceback" not in output
    assert not outliving(below)
    assert count(out) >= 3


def test_one_grader_at_a_time(tmp_path):
    from workbook.grading.course import course

    (tmp_path / "submitted").mkdir()
    with course._locked(tmp_path):
        done = start(tmp_path, tmp_path)
        _, output = done.communicate(timeout=60)
        assert (
            done.returncode == 2
            and output.decode().strip()
            == f"workbook: another workbook grade is at work on {tmp_path}"
        )
    done = start(tmp_path, tmp_path)
    done.communicate(timeout=60)
    assert done.returncode == 0

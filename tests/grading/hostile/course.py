"""A course with secrets in and around it, for hostile submissions."""

import os
import random
import shutil
import signal
import socket
import tempfile
from contextlib import contextmanager
from pathlib import Path

from hostile.attack import RIGHT, SECRET, Seen, with_cells, write

FOLDERS = ("submitted", "solutions", "home", "marks", "graded", "archive", "checks")


class Course:
    """A folder open to all users, so that file permissions alone stop no attack, and listeners."""

    def __init__(self):
        self.here = Path(tempfile.mkdtemp(prefix="course-"))
        self.token = "t" + str(random.SystemRandom().randrange(10**8, 10**9))
        for name in FOLDERS:
            (self.here / name).mkdir()
        (self.here / "solutions/p15.py").write_text(f"a_region = {RIGHT}\n")
        (self.here / "solutions/secret.txt").write_text(SECRET)
        (self.here / "home/private.txt").write_text(SECRET)
        self._network, self._local = (
            socket.create_server(("127.0.0.1", 0)),
            socket.socket(socket.AF_UNIX),
        )
        self._local.bind("\0" + self.token)
        self._local.listen()
        for listener in (self._network, self._local):
            listener.setblocking(False)

    def hand_in(self, student, attack):
        facts = {
            "HERE": str(self.here),
            "NAME": student,
            "TOKEN": self.token,
            "PORT": self._network.getsockname()[1],
        }
        attack.submit(self.here / "submitted" / student / "hw", facts)

    def hand_in_honestly(self, student, notebook=None):
        folder = self.here / "submitted" / student / "hw"
        folder.mkdir(parents=True, exist_ok=True)
        write(folder / "p15.ipynb", notebook or with_cells([f"a_region = {RIGHT}"]))

    def open_to_all(self):
        for path in [self.here, *self.here.rglob("*")]:
            if not path.is_symlink():
                path.chmod(0o777 if path.is_dir() else 0o666)

    def marked(self, student):
        return (self.here / "marks" / student).exists()

    def heard(self):
        """Return whether a connection has come."""
        for listener in (self._network, self._local):
            try:
                listener.accept()[0].close()
                return True
            except BlockingIOError:
                pass
        return False

    def left_behind(self):
        """Return the processes with this course's token in their command line."""
        pids = []
        for path in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                if (
                    self.token.strip("t").encode() in path.read_bytes()
                    and int(path.parent.name) != os.getpid()
                ):
                    pids.append(int(path.parent.name))
            except OSError:
                pass
        return pids

    def close(self):
        for process in self.left_behind():
            os.kill(process, signal.SIGKILL)
        for listener in (self._network, self._local):
            listener.close()
        shutil.rmtree(self.here, ignore_errors=True)


@contextmanager
def a_course():
    course = Course()
    try:
        yield course
    finally:
        course.close()


def seen_by_naive(course, student, honest, finished):
    """Return what the naive grader's files record of a student."""
    rows = _read(course.here / "grades.csv").split("\n")
    points = {}
    for row in rows:
        if row.count(",") >= 2:
            points[row.split(",")[0]] = row.split(",")[1]
    text = _read(course.here / "graded" / f"{student}.json")
    return Seen(
        points=int(points.get(student) == "1"),
        text=text.replace('"', " ").replace("}", " "),
        finished=finished,
        honest=all(points.get(name) == "1" for name in honest),
        marked=course.marked(student),
        heard=course.heard(),
        left=len(course.left_behind()),
        gradings=_read(course.here / "graded.log").split("\n").count(student),
        printed=(course.here / "output.txt").stat().st_size,
    )


def seen_by_ours(course, results, student, honest, finished):
    """Return what our grade store records of a student.

    `honest` maps students to how many right answers they have.
    """
    mine = results.get(student, [])
    return Seen(
        points=sum(_right(result) for result in mine),
        text=" ".join(text for result in mine for text in result["answers"].values()),
        finished=finished,
        honest=all(
            sum(map(_right, results.get(name, []))) == right for name, right in honest.items()
        ),
        marked=course.marked(student),
        heard=course.heard(),
        left=len(course.left_behind()),
        gradings=max(1, len(mine)),
        printed=(course.here / "output.txt").stat().st_size,
    )


def _right(result):
    return sum(status == "right" for status, *_ in result["verdicts"].values())


def _read(path):
    return path.read_text(encoding="utf-8", errors="replace") if path.exists() else ""

"""The grade store: one SQLite file, a transaction a notebook, so that a killed run loses nothing
and grades nothing twice."""

import json
import sqlite3
from contextlib import contextmanager
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path

from workbook.checks.contract.verdict import Verdict
from workbook.grading.assignment import BadInput

SCHEMA = """
CREATE TABLE IF NOT EXISTS attempt (
  id INTEGER PRIMARY KEY,
  student TEXT NOT NULL, assignment TEXT NOT NULL, problem TEXT NOT NULL,
  content TEXT NOT NULL,            -- SHA-256 of the notebook's bytes
  submitted REAL NOT NULL,          -- the time of its file when it was last there, seconds since 1970
  UNIQUE (student, assignment, problem, content)
);
CREATE TABLE IF NOT EXISTS result (
  attempt INTEGER NOT NULL REFERENCES attempt (id),
  exercise TEXT NOT NULL,           -- fingerprint of the exercise and of the checks it was judged by
  verdicts TEXT NOT NULL, answers TEXT NOT NULL, remarks TEXT NOT NULL,
  graded TEXT NOT NULL,
  hashes TEXT NOT NULL DEFAULT '{}', -- SHA-256 of each answer as it was encoded
  PRIMARY KEY (attempt, exercise)
);
CREATE TABLE IF NOT EXISTS manual (
  student TEXT NOT NULL, assignment TEXT NOT NULL, problem TEXT NOT NULL, answer TEXT NOT NULL,
  points REAL NOT NULL, comment TEXT NOT NULL, entered TEXT NOT NULL,
  PRIMARY KEY (student, assignment, problem, answer)
);
"""


@dataclass(frozen=True)
class Attempt:
    """One submitted notebook of a student for a problem, and its newest result if there is one."""

    id: int
    student: str
    assignment: str
    problem: str
    content: str
    submitted: float
    exercise: str | None
    verdicts: dict
    answers: dict
    remarks: tuple
    hashes: dict = field(default_factory=dict)


class StoreError(BadInput):
    """The file cannot be read or written; what is in it stays as it was."""


class Store:
    """The grades of a course in the file `path`; use as a context manager."""

    def __init__(self, path):
        self.path = Path(path)
        self.path.parent.mkdir(parents=True, exist_ok=True)
        try:
            self._database = sqlite3.connect(self.path, isolation_level=None, timeout=60)
            self._database.execute("PRAGMA journal_mode=WAL")
            self._database.execute("PRAGMA foreign_keys=ON")
            self._database.executescript(SCHEMA)
            # written by an older version
            if "hashes" not in {
                row[1] for row in self._database.execute("PRAGMA table_info(result)")
            }:
                self._database.execute(
                    "ALTER TABLE result ADD COLUMN hashes TEXT NOT NULL DEFAULT '{}'"
                )
        except sqlite3.Error as error:
            raise self._error(error) from error

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        self._database.close()
        # the disk, not a mistake of ours
        if type(error) in (sqlite3.OperationalError, sqlite3.DatabaseError):
            raise self._error(error) from error

    def _error(self, error):
        return StoreError(
            f"{self.path}: {error}; what is stored in it is kept, and the same command goes on "
            "from there"
        )

    @contextmanager
    def together(self):
        """What is noted within is stored together, or not at all: the disk is waited for once."""
        self._database.execute("BEGIN IMMEDIATE")
        with self._database:
            yield

    def note_attempt(self, student, assignment, problem, content, submitted):
        """The id of an attempt, new or known: the same notebook handed in twice is one attempt, at
        the time it has now."""
        key = (student, assignment, problem, content)
        self._database.execute(
            "INSERT INTO attempt (student, assignment, problem, content, submitted) VALUES (?, "
            "?, ?, ?, ?) ON CONFLICT DO UPDATE SET submitted = excluded.submitted WHERE "
            "submitted != excluded.submitted",
            (*key, submitted),
        )
        (found,) = self._database.execute(
            "SELECT id FROM attempt WHERE student = ? AND assignment = ? AND problem = ? AND "
            "content = ?",
            key,
        ).fetchone()
        return found

    def beyond(self, assignment, attempts):
        """The attempts that come after the first `attempts` of a student at a problem; None is no
        limit."""
        if attempts is None:
            return []
        rows = self._database.execute(
            """
            SELECT id FROM (
              SELECT id, row_number() OVER (PARTITION BY student, problem ORDER BY submitted, id) AS number
              FROM attempt WHERE assignment = ?) WHERE number > ?""",
            (assignment, attempts),
        )
        return [attempt for (attempt,) in rows]

    def versions(self, attempt):
        """By which exercises the attempt has a result, the newest last, which is the one that
        counts."""
        rows = self._database.execute(
            "SELECT exercise FROM result WHERE attempt = ? ORDER BY rowid", (attempt,)
        )
        return [exercise for (exercise,) in rows]

    def record(self, attempt, exercise, verdicts, answers, remarks, hashes=None):
        """Store a result, whole or not at all; a second one by the same exercise replaces the
        first."""
        self._database.execute(
            "INSERT OR REPLACE INTO result (attempt, exercise, verdicts, answers, remarks, "
            "graded, hashes) VALUES (?, ?, ?, ?, ?, ?, ?)",
            (
                attempt,
                exercise,
                json.dumps(
                    {name: [v.status, v.message, v.mistake] for name, v in verdicts.items()},
                    ensure_ascii=False,
                ),
                json.dumps(answers, ensure_ascii=False),
                json.dumps(list(remarks), ensure_ascii=False),
                datetime.now(UTC).isoformat(timespec="seconds"),
                json.dumps(hashes or {}),
            ),
        )

    def attempts(self, assignment):
        """All attempts at an assignment with their newest results, by student, problem and time."""
        rows = self._database.execute(
            """
            SELECT a.id, a.student, a.assignment, a.problem, a.content, a.submitted, r.exercise, r.verdicts, r.answers,
                   r.remarks, r.hashes
            FROM attempt a LEFT JOIN result r ON r.attempt = a.id
              AND r.rowid = (SELECT max(rowid) FROM result WHERE attempt = a.id)
            WHERE a.assignment = ? ORDER BY a.student, a.problem, a.submitted, a.id""",
            (assignment,),
        )
        return [
            Attempt(
                *row[:7],
                {name: Verdict(*verdict) for name, verdict in json.loads(row[7] or "{}").items()},
                json.loads(row[8] or "{}"),
                tuple(json.loads(row[9] or "[]")),
                json.loads(row[10] or "{}"),
            )
            for row in rows
        ]

    def set_manual(self, student, assignment, problem, answer, points, comment):
        """A lecturer's score, which beats the automatic one until it is taken back."""
        self._database.execute(
            "INSERT OR REPLACE INTO manual VALUES (?, ?, ?, ?, ?, ?, ?)",
            (
                student,
                assignment,
                problem,
                answer,
                points,
                comment,
                datetime.now(UTC).isoformat(timespec="seconds"),
            ),
        )

    def take_back(self, student, assignment, problem, answer):
        """Remove a lecturer's score, so that the automatic one counts again; returns False if there
        was none."""
        done = self._database.execute(
            "DELETE FROM manual WHERE student = ? AND assignment = ? AND problem = ?"
            " AND answer = ?",
            (student, assignment, problem, answer),
        )
        return done.rowcount > 0

    def manual(self, assignment):
        """{(student, problem, answer): (points, comment)} entered by hand."""
        rows = self._database.execute(
            "SELECT student, problem, answer, points, comment FROM manual WHERE assignment = ?",
            (assignment,),
        )
        return {
            (student, problem, answer): (points, comment)
            for student, problem, answer, points, comment in rows
        }

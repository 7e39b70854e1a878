"""The grade store: one SQLite file, with one transaction for each notebook.

So a run that is killed loses nothing, and the next one grades nothing twice. Points by hand, which
no run could find again, are also in a table beside it, from which a new store takes them.
"""

import json
import sqlite3
from contextlib import contextmanager
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path

from workbook.checks.contract.verdict import Verdict
from workbook.grading.course.assignment import InputError
from workbook.grading.course.csv_files import BOM, parse, quoted, read_text
from workbook.grading.course.ledger import KNOWN
from workbook.grading.course.record import put

#: The table of all points by hand, beside the store.
COPY = "points-by-hand.csv"
COPY_HEADER = ["student", "assignment", "problem", "answer", "points", "comment", "entered", "by"]

#: The columns of the table of points by hand, as those of the copy.
MANUAL = "student, assignment, problem, answer, points, comment, entered, giver"

SCHEMA = """
CREATE TABLE IF NOT EXISTS attempt (
  id INTEGER PRIMARY KEY,
  student TEXT NOT NULL, assignment TEXT NOT NULL, problem TEXT NOT NULL,
  content TEXT NOT NULL,            -- SHA-256 of the notebook's bytes
  submitted REAL NOT NULL,          -- its time when it was last there, seconds since 1970
  timing TEXT NOT NULL DEFAULT 'known', -- what is known of that time, as in the ledger
  shapes TEXT NOT NULL DEFAULT '',  -- those of its code (`copying`), as JSON; empty if not found yet
  UNIQUE (student, assignment, problem, content)
);
CREATE TABLE IF NOT EXISTS result (
  attempt INTEGER NOT NULL REFERENCES attempt (id),
  exercise TEXT NOT NULL,           -- fingerprint of the exercise and of the checks it was judged by
  verdicts TEXT NOT NULL, answers TEXT NOT NULL, remarks TEXT NOT NULL,
  graded TEXT NOT NULL,
  hashes TEXT NOT NULL DEFAULT '{}', -- SHA-256 of each answer as it was encoded
  seconds REAL NOT NULL DEFAULT 0,  -- of computing that running and judging it took
  PRIMARY KEY (attempt, exercise)
);
CREATE TABLE IF NOT EXISTS manual (
  student TEXT NOT NULL, assignment TEXT NOT NULL, problem TEXT NOT NULL, answer TEXT NOT NULL,
  points REAL NOT NULL, comment TEXT NOT NULL, entered TEXT NOT NULL,
  giver TEXT NOT NULL DEFAULT '',   -- who gave the points
  PRIMARY KEY (student, assignment, problem, answer)
);
"""


@dataclass(frozen=True)
class Attempt:
    """One submitted notebook of a student for a problem, and its newest result if there is one.

    Parameters
    ----------
    id : int
        In the store.
    student, assignment, problem : str
        Whose, and for what.
    content : str
        SHA-256 of the notebook.
    submitted : float
        Time in seconds since 1970, or what orders it if the time is not known.
    exercise : str or None
        The version of the exercise that the result is by; None without a result.
    verdicts, answers, hashes : dict
        Verdict, short text and SHA-256 by answer.
    remarks : tuple of str
        On the notebook.
    timing : str
        What is known of the time: one of those in `ledger`.
    """

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
    timing: str = KNOWN


@dataclass(frozen=True)
class HandPoints:
    """Points that a lecturer gave for an answer, with a comment for the student, and who did."""

    points: float | None
    comment: str | None = ""
    by: str = ""


class StoreError(InputError):
    """The file cannot be read or written; its content is unchanged."""


class Store:
    """The grades of a course; use it as a context manager.

    Parameters
    ----------
    path : path
        The SQLite file, made if it does not exist.

    Raises
    ------
    StoreError
        If the file cannot be read or written, also at the end of the block.
    """

    def __init__(self, path):
        self.path = Path(path)
        self.path.parent.mkdir(parents=True, exist_ok=True)
        try:
            self._database = sqlite3.connect(self.path, isolation_level=None, timeout=60)
            self._database.execute("PRAGMA journal_mode=WAL")
            self._database.execute("PRAGMA foreign_keys=ON")
            self._database.executescript(SCHEMA)
            # The file may be of an older version.
            self._add_column("result", "hashes", "'{}'")
            self._add_column("attempt", "timing", "'known'")
            self._add_column("attempt", "shapes", "''")
            self._add_column("manual", "giver", "''")
            self._add_column("result", "seconds", "0", "REAL")
            self._restore_manual()
        except sqlite3.Error as error:
            raise self._error(error) from error

    def _add_column(self, table, name, default, kind="TEXT"):
        columns = self._database.execute(f"PRAGMA table_info({table})")
        if name not in {row[1] for row in columns}:
            self._database.execute(
                f"ALTER TABLE {table} ADD COLUMN {name} {kind} NOT NULL DEFAULT {default}"
            )

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        self._database.close()
        # The disk, not an error in our SQL.
        if type(error) in (sqlite3.OperationalError, sqlite3.DatabaseError):
            raise self._error(error) from error

    def _error(self, error):
        if isinstance(error, sqlite3.OperationalError):
            return StoreError(
                f"{self.path}: {error}; what is stored in it is kept, and the same command goes on "
                "from there"
            )
        return StoreError(
            f"{self.path}: {error}; move it away, with {self.path.name}-wal and -shm beside it, and "
            f"run workbook grade: it grades all notebooks again, and takes points by hand from {COPY}"
        )

    @contextmanager
    def transaction(self):
        """Store what is noted in this block in one transaction, which waits for the disk once."""
        self._database.execute("BEGIN IMMEDIATE")
        with self._database:
            yield

    def note_attempt(self, student, assignment, problem, content, submitted, timing=KNOWN):
        """Return the id of an attempt, new or known.

        The same notebook handed in twice is one attempt, at the time that it has now.
        """
        key = (student, assignment, problem, content)
        self._database.execute(
            "INSERT INTO attempt (student, assignment, problem, content, submitted, timing) VALUES "
            "(?, ?, ?, ?, ?, ?) ON CONFLICT DO UPDATE SET submitted = excluded.submitted, timing = "
            "excluded.timing WHERE submitted != excluded.submitted OR timing != excluded.timing",
            (*key, submitted, timing),
        )
        (attempt,) = self._database.execute(
            "SELECT id FROM attempt WHERE student = ? AND assignment = ? AND problem = ? AND "
            "content = ?",
            key,
        ).fetchone()
        return attempt

    def shapes(self, attempt):
        """Return the shapes of an attempt's code with a line of each, None if not stored yet."""
        (text,) = self._database.execute(
            "SELECT shapes FROM attempt WHERE id = ?", (attempt,)
        ).fetchone()
        return json.loads(text) if text else None

    def set_shapes(self, attempt, shapes):
        """Store the shapes of an attempt's code."""
        text = json.dumps(shapes, ensure_ascii=False)
        self._database.execute("UPDATE attempt SET shapes = ? WHERE id = ?", (text, attempt))

    def attempts_beyond(self, assignment, attempts):
        """Return the ids of attempts after the first `attempts` of a student at a problem.

        None is no limit.
        """
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
        """Return the versions by which an attempt has results, the newest last, which counts."""
        rows = self._database.execute(
            "SELECT exercise FROM result WHERE attempt = ? ORDER BY rowid", (attempt,)
        )
        return [exercise for (exercise,) in rows]

    def seconds_used(self, attempt):
        """Return the seconds of computing that the newest result of an attempt took."""
        row = self._database.execute(
            "SELECT seconds FROM result WHERE attempt = ? ORDER BY rowid DESC LIMIT 1", (attempt,)
        ).fetchone()
        return row[0] if row else 0.0

    def record(self, attempt, exercise, judgement):
        """Store a result, completely or not at all; it replaces one by the same exercise.

        Parameters
        ----------
        attempt : int
            The id of the attempt.
        exercise : str
            The version of the exercise.
        judgement : Judgement
            The result.
        """
        verdicts = judgement.verdicts.items()
        self._database.execute(
            "INSERT OR REPLACE INTO result (attempt, exercise, verdicts, answers, remarks, "
            "graded, hashes, seconds) VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
            (
                attempt,
                exercise,
                json.dumps(
                    {name: [v.status, v.message, v.mistake] for name, v in verdicts},
                    ensure_ascii=False,
                ),
                json.dumps(judgement.answers, ensure_ascii=False),
                json.dumps(list(judgement.remarks), ensure_ascii=False),
                datetime.now(UTC).isoformat(timespec="seconds"),
                json.dumps(judgement.hashes),
                judgement.seconds,
            ),
        )

    def attempts(self, assignment):
        """Return all attempts at an assignment by student, problem and time, with newest results."""
        rows = self._database.execute(
            """
            SELECT a.id, a.student, a.assignment, a.problem, a.content, a.submitted, r.exercise, r.verdicts, r.answers,
                   r.remarks, r.hashes, a.timing
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
                row[11],
            )
            for row in rows
        ]

    def set_points(self, entries):
        """Store a lecturer's points, which replace the automatic ones until they are taken back.

        `entries` are `HandPoints` by (student, assignment, problem, answer): all are stored or none.
        """
        now = datetime.now(UTC).isoformat(timespec="seconds")
        with self.transaction():
            self._insert_manual(
                [
                    (*key, given.points, given.comment, now, given.by)
                    for key, given in entries.items()
                ]
            )
            self._write_copy()

    def take_back(self, student, assignment, problem, answer):
        """Remove a lecturer's points for an answer; return whether there were any."""
        with self.transaction():
            cursor = self._database.execute(
                "DELETE FROM manual WHERE student = ? AND assignment = ? AND problem = ?"
                " AND answer = ?",
                (student, assignment, problem, answer),
            )
            self._write_copy()
        return cursor.rowcount > 0

    def _insert_manual(self, rows):
        self._database.executemany(
            f"INSERT OR REPLACE INTO manual ({MANUAL}) VALUES (?, ?, ?, ?, ?, ?, ?, ?)", rows
        )

    def _write_copy(self):
        rows = self._database.execute(
            f"SELECT {MANUAL} FROM manual ORDER BY entered, rowid"
        ).fetchall()
        put(self.path.with_name(COPY), BOM + quoted([COPY_HEADER, *rows]))

    def _restore_manual(self):
        """Take points by hand from the table beside a store that has none."""
        path = self.path.with_name(COPY)
        empty = self._database.execute("SELECT 1 FROM manual LIMIT 1").fetchone() is None
        if not empty or not path.exists():
            return
        _, lines = parse(read_text(path))
        try:
            if not lines or lines[0] not in (
                COPY_HEADER,
                COPY_HEADER[:-1],
            ):  # before there was "by"
                raise ValueError("its columns are not those of points by hand")
            nobody = [""] * (len(COPY_HEADER) - len(lines[0]))
            rows = [(*row[:4], float(row[4]), *row[5:], *nobody) for row in lines[1:]]
        except ValueError as error:
            raise StoreError(
                f"{path} is not as workbook score wrote it ({error}): correct it, or move it away"
            ) from None
        with self.transaction():
            self._insert_manual(rows)

    def manual(self, assignment):
        """Return the `HandPoints` by (student, problem, answer)."""
        rows = self._database.execute(
            "SELECT student, problem, answer, points, comment, giver FROM manual "
            "WHERE assignment = ?",
            (assignment,),
        )
        return {tuple(key): HandPoints(*given) for *key, given in ((*r[:3], r[3:]) for r in rows)}

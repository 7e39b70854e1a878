"""Who has which numbers: the table `numbers.csv` beside `assignment.toml`.

    student,2.4,3.8,pool
    ann@uni.example,17,3,3.10
    ben@uni.example,4,11,3.3

A column is a problem that varies, a cell the row of its numbers; in the column `pool` it is the
student's problem of the pool. Rows are drawn at random, none
twice before each was drawn once; a lecturer may change a cell or add a line. A student without a row
cannot be graded, so that nobody chooses a row by a name.
"""

import random
import re
from dataclasses import replace

from workbook.grading.course import assignment as assignments
from workbook.grading.course.assignment import POOL, InputError
from workbook.grading.course.csv_files import parse, read_text
from workbook.grading.sandbox.sanitising import normalise_name

NAME = "numbers.csv"


def read_homework(path):
    """Return the assignment in a file with the table of numbers beside it, if there is one.

    Raises
    ------
    InputError
        If one of the files cannot be used.
    """
    assignment, table = assignments.read(path), path.with_name(NAME)
    if not table.is_file():
        return assignment
    numbers = read(table)
    for problem in set().union(*numbers.values()) - {POOL, *assignment.problems}:
        raise InputError(f"{table}: {problem} is no problem of the homework")
    for student, own in numbers.items():
        if POOL in own and own[POOL] not in assignment.pool:
            raise InputError(f"{table}: {own[POOL]}, which {student} has, is not in the pool")
    return replace(assignment, numbers=numbers)


def why_not_asked(assignment, problem, student):
    """Return why a notebook of a student is left aside for whom there is no row of its problem."""
    if problem in assignment.pool and (drawn := assignment.drawn(student)):
        return f"{NAME} says {drawn} for {student}, not {problem}"
    column = POOL if problem in assignment.pool else problem
    return f"{NAME} has no row of {column} for {student}: add it"


def read(path):
    """Return {student: {problem: row}} of a table.

    Raises
    ------
    InputError
        If a cell is no row, or a student stands there twice.
    """
    _, lines = parse(read_text(path))
    if not lines:
        raise InputError(f"{path}: the first line names the problems: student,2.4,3.8")
    (_, *problems), *lines = lines
    table = {}
    for student, *cells in lines:
        student = normalise_name(student.strip())
        if student in table:
            raise InputError(f"{path}: {student} stands there twice")
        for problem, cell in zip(problems, cells):
            if problem != POOL and not re.fullmatch(r"[1-9]\d*|", cell.strip(), re.ASCII):
                raise InputError(f"{path}: {cell!r} is no row of {problem} for {student}")
        table[student] = {
            problem: cell.strip() if problem == POOL else int(cell)
            for problem, cell in zip(problems, cells)
            if cell.strip()
        }
    return table


def text(table, problems):
    """Return the table as CSV."""
    lines = [["student", *problems]] + [
        [student, *(str(rows.get(problem, "")) for problem in problems)]
        for student, rows in table.items()
    ]
    return "".join(",".join(map(_cell, line)) + "\n" for line in lines)


def draw(table, students, rows, seed=None):
    """Return the table with rows for students and problems that have none yet.

    Parameters
    ----------
    table : dict
        {student: {problem: row}}.
    students : iterable of str
        The class.
    rows : dict
        The proved rows by problem; by `POOL` the problems of the pool.
    seed : optional
        Of the random numbers; by default the system's.

    Returns
    -------
    dict
        The new table; among those with a row, no row occurs twice more often than another.
    """
    choice = random.Random(seed)
    table = {student: dict(entries) for student, entries in table.items()}
    for student in students:
        table.setdefault(student, {})
    for problem, proved in rows.items():
        used = [entries[problem] for entries in table.values() if problem in entries]
        for entries in table.values():
            if problem not in entries:
                fewest = min(used.count(row) for row in proved)
                entries[problem] = choice.choice(
                    [row for row in proved if used.count(row) == fewest]
                )
                used.append(entries[problem])
    return table


def _cell(value):
    return '"' + value.replace('"', '""') + '"' if re.search(r'[",;\t]', value) else value

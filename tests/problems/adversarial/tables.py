"""All rows, by the problem that they are about."""

from adversarial import ch1, ch2, ch3, ch4, ch5, ch5_later, ch5_near, ch5_processes, ch5_quadratic, ch5_syntheses, ch6_7

CHAPTERS = ch1, ch2, ch3, ch4, ch5, ch5_syntheses, ch5_processes, ch5_later, ch5_quadratic, ch5_near, ch6_7
ROWS = [row for chapter in CHAPTERS for row in chapter.ROWS]


def rows_of(problem):
    return [row for row in ROWS if row.problem == problem]

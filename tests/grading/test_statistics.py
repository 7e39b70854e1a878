"""Items of a homework, and a class over several homeworks."""

import csv
import io
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment, graded

from workbook.checks.contract.verdict import MISSING, RIGHT, WRONG, Verdict
from workbook.grading.pool.judging import Judgement
from workbook.grading.reports import statistics
from workbook.grading.reports.scores import scores

HOMEWORK = 'title = "One"\nproblems = ["1.17"]\n[exemptions]\nfay = ["1.17"]\n'


def table(text):
    return {row[0] + row[1]: row for row in csv.reader(io.StringIO(text.removeprefix("\ufeff")))}


@pytest.fixture
def six(store, homework):
    """Strong students have a, weak ones have b; Dan leaves all empty; Eve hands in nothing."""
    for k, (a, b) in enumerate(
        [(RIGHT, WRONG), (RIGHT, RIGHT), (WRONG, RIGHT), (MISSING, MISSING)]
    ):
        student = ("ann", "bob", "cid", "dan")[k]
        graded(store, student, "1.17", {"a_region": a, "b_region": b})
    return scores(store, homework, ["eve", "fay"])


def test_empty_is_not_the_same_as_nothing_handed_in(six, homework):
    rows = table(statistics.items_csv(homework, six))
    assert rows["1.17a_region"][2:8] == ["5", "1", "1", "2", "0.50", ""]
    course = table(statistics.course_csv([(homework, six)]))
    cells = {row[0]: row[1:] for row in course.values()}
    assert cells["ann"] == ["1.00", "1.00", "1", "0"]
    assert cells["dan"] == ["0.00", "0.00", "1", "1"] and cells["eve"] == ["", "0.00", "0", "0"]
    assert cells["fay"][0] == "exempt"
    page = statistics.course_page([(homework, six)])
    assert '<td>One</td><td class="number">5</td><td class="number">1</td>' in page
    assert '<td class="number">1</td><td class="number">1.00 of 2.00</td>' in page


def test_discrimination_is_the_correlation_with_the_rest(tmp_path, store):
    homework = an_assignment(tmp_path, 'problems = ["1.17", "1.18"]\n')
    answers = [(1, 1, 1, 0), (1, 1, 0, 0), (1, 0, 1, 1), (0, 0, 0, 1), (0, 1, 0, 1), (0, 0, 0, 0)]
    for k, row in enumerate(answers):
        verdicts = [RIGHT if right else WRONG for right in row]
        for j, problem in enumerate(("1.17", "1.18")):
            graded(
                store,
                f"s{k}",
                problem,
                dict(zip(("a_region", "b_region"), verdicts[2 * j : 2 * j + 2])),
            )
    rows = table(statistics.items_csv(homework, scores(store, homework)))
    # By hand: 1.17 a has (1,1,1,0,0,0), the rest (2,1,2,1,2,0): covariance 1/6, variances 1/4, 5/9.
    assert rows["1.17a_region"][7] == f"{(1 / 6 * 5 - 8 / 6 / 2) / (0.25 * 5 / 9) ** 0.5:.2f}"


def test_named_mistakes_are_counted_over_time(tmp_path, store, homework):
    second = an_assignment(tmp_path, 'problems = ["1.17"]\n', name="hw2")
    for name, students in (("hw1", ("ann", "bob")), ("hw2", ("ann",))):
        for student in students:
            attempt = graded(store, student, "1.17", {}, assignment=name)
            wrong = Verdict(WRONG, "it fails", "Did you forget <a minor>?\nLook again.")
            store.record(
                attempt, "first", Judgement({"a_region": wrong, "b_region": wrong}, {}, ())
            )
    homeworks = [(one, scores(store, one)) for one in (homework, second)]
    page = statistics.course_page(homeworks)
    assert (
        'Did you forget &lt;a minor&gt;?</td><td class="number">2</td><td class="number">1</td>'
        in page
    )
    rows = table(statistics.items_csv(homework, homeworks[0][1]))
    assert rows["1.17a_region"][8] == "Did you forget <a minor>? (2)"

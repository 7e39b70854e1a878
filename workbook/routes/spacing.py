"""Choose the questions of each week's self-test.

Two are of this week, one of two weeks before and one of five weeks before, since what is recalled
after a while is kept better than what is repeated at once. A question comes again only when those of
its week that were asked less often are used up.
"""

from collections import Counter
from dataclasses import dataclass

#: (Weeks before, questions).
SPACING = ((0, 2), (2, 1), (5, 1))


@dataclass(frozen=True)
class Question:
    """The question of a section by its number, from 1 up, and the week that has read it."""

    section: str
    number: int
    week: int


def self_tests(course, route):
    """Return {week: its questions} of a route."""
    asked, read = Counter(), set()
    fresh = {}  # the sections that a week reads first, or else those that it returns to
    for week in route.weeks:
        pages = [section for section in course.pages_of(week) if section.questions]
        fresh[week.number] = [page for page in pages if page.label not in read] or pages
        read |= {page.label for page in pages}
    tests = {}
    for week in route.weeks:
        tests[week.number] = []
        for before, count in SPACING:
            source, chosen = week.number - before, Counter()
            for _ in range(count):
                candidates = [
                    Question(section.label, number, source)
                    for section in fresh.get(source, ())
                    for number in range(1, section.questions + 1)
                ]
                if candidates:
                    # the least asked, and of another section than the one before it
                    question = min(
                        candidates,
                        key=lambda q: (asked[q.section, q.number], chosen[q.section]),
                    )
                    asked[question.section, question.number] += 1
                    chosen[question.section] += 1
                    tests[week.number].append(question)
    return tests

"""A route as data for programs, and its weeks as lines of text."""

from workbook.notebooks import exercises
from workbook.routes.spacing import self_tests


def as_data(course, route, dates=()):
    """Return a route as plain data; with dates each week has its first day."""
    tests = self_tests(course, route)
    return {
        "name": route.name,
        "title": route.title,
        "about": route.about,
        "assumed": [section.label for section in course.assumed(route)],
        "weeks": [
            {
                route.unit: week.number,
                **({"start": dates[k].isoformat()} if dates else {}),
                **{key: getattr(week, key) for key in ("asks", "lecture", "tutorial", "note")},
                "sections": [
                    {"label": label, "name": course.sections[label].name} for label in week.sections
                ],
                "figures": [course.figures[name].asks for name in week.figures],
                "class": list(map(str, week.in_class)),
                "homework": [
                    {"problem": str(task), "minutes": task.minutes} for task in week.homework
                ],
                "minutes": week.minutes,
                "self_test": [
                    {"section": question.section, "question": question.number}
                    for question in tests[week.number]
                ],
                "library": [f"trajlib.{name}" for name in week.library],
            }
            for k, week in enumerate(route.weeks)
        ],
    }


def week_lines(course, week, questions):
    """Return {heading: text} of a week, without what it does not have."""
    lines = {
        "Question": week.asks,
        "Read": "; ".join(course.sections[label].name for label in week.sections),
        "Figure": " ".join(course.figures[name].asks for name in week.figures),
        "Lecture": week.lecture,
        "Tutorial": week.tutorial,
        "In class": ", ".join(map(_titled, week.in_class)),
        "Homework": ", ".join(f"{task} ({task.minutes} min)" for task in week.homework),
        "Self-test": "; ".join(
            f"{course.sections[question.section].name} {question.number}" for question in questions
        ),
        "Take home": ", ".join(f"trajlib.{name}" for name in week.library),
        "Note": week.note,
    }
    return {heading: text for heading, text in lines.items() if text}


def week_texts(course, route):
    """Return (title, description) of each week, for a calendar."""
    tests = self_tests(course, route)
    texts = []
    for week in route.weeks:
        lines = week_lines(course, week, tests[week.number])
        title = f"{route.title}, {route.unit} {week.number}: {lines.pop('Read')}"
        texts.append((title, "\n".join(f"{key}: {text}" for key, text in lines.items())))
    return texts


def _titled(task):
    return f"{task} {exercises.find(task.problem).about['title']}"

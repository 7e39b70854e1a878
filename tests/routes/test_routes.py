"""The routes: each name exists, the order fits the needs, the self-tests are spaced, dates are right."""

import json
import re
import subprocess
import sys
from datetime import date, timedelta
from functools import cache
from pathlib import Path

import pytest

from workbook.authoring.contract import item_of
from workbook.notebooks import exercises
from workbook.routes.calendar import to_ics, week_dates
from workbook.routes.course import UnknownRoute, course
from workbook.routes.printing import as_data, week_texts
from workbook.routes.spacing import self_tests

ROOT = Path(__file__).resolve().parents[2]
BOOK = ROOT / "book"
#: A page without a frame; what it needs is in the data only.
WITHOUT_FRAME = "sec-5-test-problems"
each_route = pytest.mark.parametrize("route", course().routes.values(), ids=lambda r: r.name)


@cache
def _pages_of_labels():
    """Return {label: the page that it is on} of all labels of the theory."""
    return {
        label: path.relative_to(BOOK).with_suffix("").as_posix()
        for path in BOOK.glob("ch*/*.md")
        for label in re.findall(r"^\(([\w-]+)\)=$", path.read_text(encoding="utf-8"), re.M)
    }


def _text(page):
    return (BOOK / f"{page}.md").read_text(encoding="utf-8")


def test_each_section_is_on_its_page():
    for section in course().sections.values():
        assert _pages_of_labels()[section.label] == section.page


def test_all_sections_of_chapters_1_to_5_are_on_the_map():
    pages = {
        path.relative_to(BOOK).with_suffix("").as_posix() for path in BOOK.glob("ch[1-5]/*.md")
    }
    on_map = [section for section in course().sections.values() if section.at]
    assert sorted(section.page for section in on_map) == sorted(pages)
    assert len({section.at for section in on_map}) == len(on_map)


def test_a_section_needs_what_its_page_names():
    named = 0
    for section in course().sections.values():
        if not section.at or section.label == WITHOUT_FRAME:
            continue
        text = re.search(r"^You need(.*?)^:::", _text(section.page), re.S | re.M)[1]
        pages = {_pages_of_labels()[label] for label in re.findall(r"\(#([\w-]+)\)", text)}
        assert pages == {course().sections[need].page for need in section.needs}, section.label
        named += len(pages)
    assert named > 60


def test_the_numbers_of_questions_are_those_of_the_pages():
    for section in course().sections.values():
        assert section.questions == _text(section.page).count(":::{self-test}\n"), section.label


def test_each_figure_asks_this_on_its_page():
    for figure in course().figures.values():
        text = _text(course().sections[figure.section].page)
        declared = re.search(rf"^{figure.name} = Explorer\(\s*((?:\s*\".*\"\n?)+),", text, re.M)
        assert "".join(re.findall(r'"(.*)"', declared[1])) == figure.asks, figure.name


@each_route
def test_all_names_of_a_route_exist(route):
    assert sum(route.terms) == len(route.weeks)
    for week in route.weeks:
        assert week.homework
        assert set(week.sections) <= course().sections.keys()
        assert set(week.figures) <= course().figures.keys()
        for folder, name in (("lectures", week.lecture), ("guides/tutorials", week.tutorial)):
            assert not name or (BOOK / folder / f"{name}.md").is_file(), name
        for module in week.library:
            assert (BOOK / "library" / f"{module}.md").is_file(), module
        for task in (*week.in_class, *week.homework):
            answers = exercises.find(task.problem).about["answers"]
            assert set(task.items) <= set(map(item_of, answers)), str(task)
            assert task.answers


@each_route
def test_no_problem_is_given_twice(route):
    problems = [task.problem for w in route.weeks for task in (*w.in_class, *w.homework)]
    assert len(problems) == len(set(problems))


@each_route
def test_a_figure_is_shown_when_its_section_has_been_read(route):
    read = set()
    for week in route.weeks:
        read |= {section.label for section in course().pages_of(week)}
        assert {course().figures[name].section for name in week.figures} <= read


@each_route
def test_a_section_comes_after_what_it_needs(route):
    """What a route has not at all is assumed; what it has comes first."""
    order = list(
        dict.fromkeys(section for week in route.weeks for section in course().pages_of(week))
    )
    labels = [section.label for section in order]
    for k, section in enumerate(order):
        assert not set(section.needs) & set(labels[k + 1 :]), section.label
    assert not {section.label for section in course().assumed(route)} & set(labels)


def test_the_whole_course_has_every_section_and_assumes_none():
    route = course().find("whole-course")
    read = {section.label for week in route.weeks for section in course().pages_of(week)}
    assert read == {label for label, section in course().sections.items() if section.at}
    assert course().assumed(route) == []
    assert course().assumed(course().find("linear-control")) == []
    assert "sec-3-feedback" in {s.label for s in course().assumed(course().find("optimal-control"))}


def test_the_homework_of_a_week_takes_one_to_three_hours():
    for route in course().routes.values():
        for week in route.weeks:
            assert 45 <= week.minutes <= 160, (route.name, week.number)


@each_route
def test_a_self_test_repeats_earlier_weeks(route):
    tests = self_tests(course(), route)
    read_in = {}
    for week in route.weeks:
        for section in course().pages_of(week):
            read_in.setdefault(section.label, []).append(week.number)
        questions = tests[week.number]
        assert len(set(questions)) == len(questions)
        for question in questions:
            assert 1 <= question.number <= course().sections[question.section].questions
            assert question.week in read_in[question.section]
        assert [question.week for question in questions] == sorted(
            (week.number - before for before in (0, 0, 2, 5) if week.number - before > 0),
            reverse=True,
        )


def test_questions_are_used_up_before_one_comes_again():
    tests = self_tests(course(), course().find("linear-control"))
    asked = [(q.section, q.number) for week in range(1, 7) for q in tests[week]]
    assert len(asked) == len(set(asked))


def test_the_map_leaves_out_what_follows_from_other_edges():
    edges = course().edges
    assert ("sec-1-hurwitz", "sec-1-first") in edges
    assert ("sec-1-linear-stability", "sec-1-first") not in edges
    reached = {label: set() for label in course().sections}
    for _ in course().sections:
        for need, label in edges:
            reached[label] |= {need} | reached[need]
    assert reached == course().needed


def test_dates_of_two_terms():
    route = course().find("whole-course")
    dates = week_dates(route, [date(2027, 2, 8), date(2027, 9, 6)])
    assert (dates[0], dates[13]) == (date(2027, 2, 8), date(2027, 5, 10))
    assert (dates[14], dates[27]) == (date(2027, 9, 6), date(2027, 12, 6))
    assert week_dates(route, [date(2027, 2, 8)])[14] == date(2027, 5, 17)
    with pytest.raises(UnknownRoute, match="term 2 begins on 2027-05-10, but term 1 lasts"):
        week_dates(route, [date(2027, 2, 8), date(2027, 5, 10)])
    with pytest.raises(UnknownRoute, match="has 1 term"):
        week_dates(course().find("estimation"), [date(2027, 2, 8), date(2027, 9, 6)])


def _events(text):
    """Read a calendar by the rules of RFC 5545, apart from what wrote it."""
    assert text.endswith("\r\n") and "\n" not in text.replace("\r\n", "")
    assert all(len(line.encode()) <= 75 for line in text.split("\r\n"))
    events = []
    for line in text.replace("\r\n ", "").split("\r\n"):
        name, _, value = line.partition(":")
        if line == "BEGIN:VEVENT":
            events.append({})
        elif events:
            signs = {"\\n": "\n", "\\,": ",", "\\;": ";", "\\\\": "\\"}
            events[-1][name] = re.sub(r"\\.", lambda sign: signs[sign[0]], value)
    return events


@each_route
def test_a_calendar_has_an_event_for_each_week(route):
    first = date(2027, 2, 8)
    texts = week_texts(course(), route)
    text = to_ics(route, week_dates(route, [first]), texts)
    events = _events(text)
    assert text.startswith("BEGIN:VCALENDAR\r\nVERSION:2.0\r\n")
    assert text.count("BEGIN:VEVENT") == text.count("END:VEVENT") == len(route.weeks)
    assert len({event["UID"] for event in events}) == len(route.weeks)
    for k, (event, (title, description)) in enumerate(zip(events, texts, strict=True)):
        day = first + timedelta(weeks=k)
        end = day + timedelta(days=7 if route.unit == "week" else 1)
        assert event["DTSTART;VALUE=DATE"] == day.strftime("%Y%m%d")
        assert event["DTEND;VALUE=DATE"] == end.strftime("%Y%m%d")
        assert (event["SUMMARY"], event["DESCRIPTION"]) == (title, description)
        assert "Homework:" in description


def _run(*arguments, cwd=None):
    command = [sys.executable, "-m", "workbook", *map(str, arguments)]
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, encoding="utf-8")


@pytest.mark.slow
def test_the_command_prints_a_route_and_writes_its_calendar(tmp_path):
    found = _run(
        *("route", "linear-control", "--start", "2027-02-08"),
        *("--ics", tmp_path / "course.ics", "--json"),
    )
    assert found.returncode == 0, found.stderr
    shown = json.loads(found.stdout)
    assert shown == as_data(
        course(),
        course().find("linear-control"),
        [date(2027, 2, 8) + timedelta(weeks=k) for k in range(14)],
    )
    assert shown["weeks"][4]["homework"] == [{"problem": "1.13 a, b", "minutes": 110}]
    written = (tmp_path / "course.ics").read_bytes().decode()
    assert [event["DTSTART;VALUE=DATE"] for event in _events(written)][13] == "20270510"
    assert (
        "Week 5, from 2027-03-08" in _run("route", "linear-control", "--start", "2027-02-08").stdout
    )
    for arguments, message in (
        (("route", "lineal"), "there is no route lineal; there are linear-control, "),
        (("route", "estimation", "--ics", "a.ics"), "a calendar needs the first day"),
        (("assignment", "new", "hw", "--route", "estimation"), "--route linear-control --week 5"),
        (("assignment", "new", "hw", "1.1", "--route", "estimation", "--week", "1"), "give either"),
        (
            ("assignment", "new", "hw", "--route", "estimation", "--week", "15"),
            "Estimation has the weeks 1 to 14",
        ),
    ):
        refused = _run(*arguments, cwd=tmp_path)
        assert refused.returncode == 2 and message in refused.stderr, refused.stderr
        assert "Traceback" not in refused.stderr


@each_route
def test_no_lecture_works_out_what_is_homework_in_that_week_or_later(route):
    asked = set()
    for week in reversed(route.weeks):
        asked |= {(task.problem, name) for task in week.homework for name in task.answers}
        if week.lecture:
            lecture = _text(f"lectures/{week.lecture}")
            assert not asked & set(re.findall(r"^%answer (\S+) (\S+)$", lecture, re.M)), week

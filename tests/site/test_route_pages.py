"""Pages of the routes, the map, the filter of all problems, and the question of the front page."""

from urllib.parse import urldefrag

import pytest

from workbook.notebooks import exercises
from workbook.routes.course import course
from workbook.routes.spacing import self_tests


@pytest.mark.parametrize("route", course().routes.values(), ids=lambda route: route.name)
def test_each_week_links_to_all_that_it_names(pages, route):
    root, parsed = pages
    path = root / "book" / "routes" / f"{route.name}.html"
    rows = parsed[path].select("table.route tbody tr")
    assert len(rows) == len(route.weeks)
    tests = self_tests(course(), route)
    for row, week in zip(rows, route.weeks, strict=True):
        problems = [task.problem for task in (*week.in_class, *week.homework)]
        linked = {
            a.get_text(strip=True): (path.parent / urldefrag(a["href"])[0]).resolve()
            for a in row.select("a")
        }
        for number in problems:
            exercise = exercises.find(number)
            assert linked[number].parts[-2:] == (
                exercise.path.parent.name,
                f"{exercise.path.stem}.html",
            )
        for label in week.sections:
            section = course().sections[label]
            assert linked[section.name] == root / "book" / f"{section.page}.html"
        for question in tests[week.number]:
            section = course().sections[question.section]
            link = row.find("a", string=f"{section.name} {question.number}")
            file, anchor = urldefrag(link["href"])
            target = parsed[(path.parent / file).resolve()].find(id=anchor)
            assert "self-test" in target["class"]
            assert target.get_text().lstrip().startswith(f"Question {question.number}.")
            questions = parsed[(path.parent / file).resolve()].select(".self-test")
            assert questions.index(target) == question.number - 1


def test_the_map_links_to_every_section(pages):
    root, parsed = pages
    path = root / "book" / "routes.html"
    on_map = [section for section in course().sections.values() if section.at]
    linked = [(path.parent / a["href"]).resolve() for a in parsed[path].select(".course-map a")]
    assert linked == [root / "book" / f"{section.page}.html" for section in on_map]
    entries = parsed[path].select("details.course-list li")
    assert [len(entry.select("a")) for entry in entries] == [
        1 + len(section.needs) for section in on_map
    ]


def test_the_front_page_leads_each_reader_in_one_click(pages):
    root, parsed = pages
    path = root / "book" / "index.html"
    cards = {
        card.select_one(".sd-card-title").get_text(strip=True): card.select_one("a")["href"]
        for card in parsed[path].select(".sd-card")
    }
    assert {who: (path.parent / urldefrag(to)[0]).resolve() for who, to in cards.items()} == {
        "Student": root / "book" / "guides" / "student.html",
        "Lecturer": root / "book" / "guides" / "lecturer.html",
        "Engineer": root / "book" / "guides" / "engineer.html",
        "Reader": root / "book" / "routes.html",
    }


CHOOSE = """(() => {
  const form = document.querySelector('form.problem-filter');
  for (const [name, value] of Object.entries(%s)) {
    if (typeof value === 'boolean') form.elements[name].checked = value;
    else form.elements[name].value = value;
  }
  form.dispatchEvent(new Event('input'));
  return [...document.querySelectorAll('table.problem-list tbody tr')]
    .filter((row) => row.offsetParent).map((row) => row.cells[0].textContent.trim());
})()"""


def test_the_list_of_problems_is_narrowed(browser, addresses):
    browser.open(f"{addresses['file']}/book/problems.html")
    everything = browser.run(CHOOSE % "{}")
    assert len(everything) == len(exercises.read_all())
    starred = browser.run(CHOOSE % "{level: 'starred'}")
    assert "1.9" in starred and "1.15" not in starred
    short = browser.run(CHOOSE % "{level: '', minutes: '30'}")
    assert "1.17" in short and "1.15" not in short
    varying = browser.run(CHOOSE % "{minutes: '', varies: true}")
    assert "1.15" in varying and "1.18" not in varying
    topic = browser.run(
        "[...document.querySelectorAll('form.problem-filter [name=topic] option')]"
        ".find((option) => option.text === 'Hurwitz criterion').value"
    )
    by_topic = browser.run(CHOOSE % f"{{varies: false, topic: '{topic}'}}")
    assert by_topic == [
        exercise.number
        for exercise in exercises.read_all()
        if "Hurwitz criterion" in exercise.about["topics"]
    ]
    shown = browser.run("document.querySelector('.problem-filter output').textContent")
    assert shown == f"{len(by_topic)} of {len(everything)} problems"
    # what this browser has verified is left out
    browser.run(
        "document.querySelector('table.problem-list tbody tr a').insertAdjacentHTML("
        "'afterend', '<span class=\"problem-verified\">✓</span>')"
    )
    remaining = browser.run(CHOOSE % "{topic: '', open: true}")
    assert remaining == everything[1:]

"""The pages of the routes and the map of the sections, from `book/routes.toml`.

`{route} linear-control` shows a route as a table, `{route-list}` all of them, `{course-map}` the map as
a picture with links and, folded below it, as a list.
"""

import re
from html import escape
from pathlib import Path
from textwrap import wrap

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from workbook.routes.course import course
from workbook.routes.spacing import self_tests
from workbook.site.folding import details, summary
from workbook.site.listings import Listing
from workbook.site.problem_pages import to_label, to_page
from workbook_site.self_tests import question_label

FILE = "book/routes.toml"
#: The map: width and height of a box, and the steps from one to the next.
BOX, STEP = (112, 42), (124, 72)
#: Letters in a line of a box, and the margin of the picture.
LINE, EDGE = 17, 10


class course_map(nodes.General, nodes.Element):
    pass


class RouteTable(Listing):
    """Shows a route: what it assumes, and a table with a row for each week."""

    required_arguments = 1

    def content_of(self, problems):
        self.env.note_dependency(FILE)
        self.pages = {problem.number: problem.page for problem in problems}
        route = course().find(self.arguments[0])
        tests = self_tests(course(), route)
        has_class = any(week.in_class for week in route.weeks)
        columns = {
            route.unit.capitalize(): lambda week: [[nodes.Text(str(week.number))]],
            "Read": self._read,
            **({"Lecture and class": self._class} if has_class else {"Tutorial": self._tutorial}),
            "Homework": self._homework,
            "Self-test": lambda week: [[self._question(q)] for q in tests[week.number]],
        }
        return [
            nodes.paragraph("", route.about),
            *self._assumed(route),
            _table(columns, route.weeks, (6, 36, 20, 15, 23)),
        ]

    def _assumed(self, route):
        if not (assumed := course().assumed(route)):
            return []
        paragraph = nodes.paragraph("", "It assumes, and does not repeat: ")
        for section in assumed:
            paragraph += [nodes.Text(", ")] if len(paragraph) > 1 else []
            paragraph += self._section(section.label)
        paragraph += nodes.Text(".")
        return [paragraph]

    def _read(self, week):
        lines = [[nodes.strong("", week.asks)]] if week.asks else []
        lines += [[self._section(label)] for label in week.sections]
        for figure in (course().figures[name] for name in week.figures):
            section = course().sections[figure.section]
            link = to_page(self.env.docname, f"book/{section.page}", figure.asks, "figure-question")
            lines.append([nodes.Text("Figure: "), link])
        return lines + ([[nodes.emphasis("", week.note)]] if week.note else [])

    def _class(self, week):
        lines = [[self._page("lectures", week.lecture)]] if week.lecture else []
        return lines + [[nodes.Text("In class: "), *self._task(task)] for task in week.in_class]

    def _tutorial(self, week):
        library = [
            to_page(self.env.docname, f"book/library/{n}", f"trajlib.{n}") for n in week.library
        ]
        return [[self._page("guides/tutorials", week.tutorial)], *([name] for name in library)]

    def _homework(self, week):
        lines = [
            [*self._task(task), nodes.Text(f" ({task.minutes} min)")] for task in week.homework
        ]
        in_all = [[nodes.emphasis("", f"{week.minutes} min in all")]]
        return lines + (in_all if len(lines) > 1 else [])

    def _section(self, label):
        return to_label(self.env.docname, label, course().sections[label].name)

    def _question(self, question):
        section = course().sections[question.section]
        label = question_label(f"book/{section.page}", question.number)
        return to_label(self.env.docname, label, f"{section.name} {question.number}")

    def _task(self, task):
        link = self.link_to(task.problem)
        items = f" {', '.join(task.items)}" if task.items else ""
        return [link, nodes.Text(items)]

    def link_to(self, number):
        """Return a link to a problem by its number, whose text is the number alone."""
        page = self.pages.get(number)
        return to_page(self.env.docname, page, number) if page else nodes.Text(number)

    def _page(self, folder, name):
        """Return a link to a lecture or tutorial, or its title where the edition has it not."""
        page = f"book/{folder}/{name}"
        text = Path(self.env.srcdir, f"{page}.md").read_text(encoding="utf-8")
        title = re.search(r"^# (.*)", text, re.M)[1]
        if page not in self.env.found_docs:
            return nodes.Text(title)
        return to_page(self.env.docname, page, title)


def _table(columns, weeks, widths):
    """Return a table; each cell names its column, which a narrow page shows in place of the head."""
    body = nodes.tbody()
    for week in weeks:
        row = nodes.row()
        for heading, cell in columns.items():
            entry = nodes.entry()
            for k, line in enumerate(cell(week)):
                label = [nodes.inline("", f"{heading} ", classes=["route-label"])] if k == 0 else []
                entry += nodes.paragraph("", "", *label, *line)
            row += entry
        body += row
    head = nodes.thead(
        "", nodes.row("", *(nodes.entry("", nodes.paragraph("", name)) for name in columns))
    )
    specs = [nodes.colspec(colwidth=width) for width in widths]
    return nodes.table(
        "", nodes.tgroup("", *specs, head, body, cols=len(columns)), classes=["route"]
    )


class RouteList(SphinxDirective):
    """Lists all routes: a link, how long each is, and what it is about."""

    def run(self):
        self.env.note_dependency(FILE)
        listed = nodes.bullet_list()
        for route in course().routes.values():
            hours = sum(week.minutes for week in route.weeks) / 60
            text = (
                f", {len(route.weeks)} {route.unit}s, about {hours:.0f} hours of homework. "
                f"{route.about}"
            )
            link = to_page(self.env.docname, f"book/routes/{route.name}", route.title)
            listed += nodes.list_item("", nodes.paragraph("", "", link, nodes.Text(text)))
        return [listed]


class CourseMap(SphinxDirective):
    """Shows the map, and the same as a list."""

    def run(self):
        self.env.note_dependency(FILE)
        fold = details("", summary("", "The map as a list"), classes=["course-list"])
        entries = nodes.bullet_list()
        for section in course().sections.values():
            if section.at:
                entries += nodes.list_item("", self._entry(section))
        fold += entries
        return [course_map(), fold]

    def _entry(self, section):
        entry = nodes.paragraph("", "", self._link(section.label))
        for k, need in enumerate(section.needs):
            entry += [nodes.Text(", " if k else " needs "), self._link(need)]
        return entry

    def _link(self, label):
        return to_label(self.env.docname, label, course().sections[label].name)


def _visit_map(writer, node):
    def url(section):
        builder = writer.builder
        return builder.get_relative_uri(builder.current_docname, f"book/{section.page}")

    writer.body.append(picture_of(course(), url))
    raise nodes.SkipNode


def picture_of(course, url):
    """Return the map in SVG; `url` maps a section to an address."""
    sections = [section for section in course.sections.values() if section.at]
    width, height = (
        max(section.at[k] for section in sections) * STEP[k] + BOX[k] + 2 * EDGE for k in (0, 1)
    )
    taken = {section.at for section in sections}
    edges = "".join(
        f'<path d="{path_of(course.sections[need].at, course.sections[label].at, taken)}"/>'
        for need, label in course.edges
    )
    boxes = "".join(_box(section, url(section)) for section in sections)
    return (
        f'<div class="course-map" tabindex="0" role="region" aria-label="Map of the sections">'
        f'<svg viewBox="{-EDGE} {-EDGE} {width} {height}" role="group" aria-labelledby="course-map-title">'
        '<title id="course-map-title">Sections of chapters 1 to 5; an arrow leads from a section to '
        "one that needs it. The list below the map says the same.</title>"
        '<defs><marker id="course-map-arrow" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="8" '
        'markerHeight="8" markerUnits="userSpaceOnUse" orient="auto"><path d="M0 0L8 4L0 8z"/>'
        f'</marker></defs><g class="edges">{edges}</g>{boxes}</svg></div>\n'
    )


def path_of(start, end, taken):
    """Return the curve from the bottom of one box to the top of another, by their places.

    Where it meets a box on its way, one of the places `taken`, it passes through the gap beside it.
    """
    x, y = _middle(start[0]), start[1] * STEP[1] + BOX[1]
    last = _middle(end[0]), end[1] * STEP[1]
    path = f"M{x:g} {y:g}"
    for row in range(start[1] + 1, end[1]):
        top = row * STEP[1]
        left, right = sorted(_x_at((x, y), last, level) for level in (top, top + BOX[1]))
        if any(
            other == row and left < _middle(column) + reach and _middle(column) - reach < right
            for column, other in taken
            for reach in [BOX[0] / 2 + 4]
        ):
            gap = STEP[0] - BOX[0]
            bend = round(((left + right) / 2 + gap / 2) / STEP[0]) * STEP[0] - gap / 2
            path += f"{_curve((x, y), (bend, top))}V{top + BOX[1]:g}"
            x, y = bend, top + BOX[1]
    return path + _curve((x, y), last)


def _middle(column):
    return column * STEP[0] + BOX[0] / 2


def _curve(start, end):
    """Return a Bezier curve that begins and ends vertically."""
    middle = (start[1] + end[1]) / 2
    return f"C{start[0]:g} {middle:g} {end[0]:g} {middle:g} {end[0]:g} {end[1]:g}"


def _x_at(start, end, level):
    """Return x on this curve at a height, by bisection: y increases with the parameter."""
    low, high = 0.0, 1.0
    for _ in range(30):
        t = (low + high) / 2
        share = t**3 + 1.5 * t * (1 - t)  # of the height
        low, high = (t, high) if start[1] + share * (end[1] - start[1]) < level else (low, t)
    return start[0] + (3 * t**2 - 2 * t**3) * (end[0] - start[0])


def _box(section, address):
    x, y = section.at[0] * STEP[0], section.at[1] * STEP[1]
    lines = wrap(section.name, LINE)
    first = y + BOX[1] / 2 + 4.5 - 7.5 * (len(lines) - 1)
    text = "".join(
        f'<tspan x="{x + BOX[0] / 2:g}" y="{first + 15 * k:g}">{escape(line)}</tspan>'
        for k, line in enumerate(lines)
    )
    return (
        f'<a href="{escape(address)}"><rect x="{x}" y="{y}" width="{BOX[0]}" height="{BOX[1]}" '
        f'rx="5"/><text>{text}</text></a>'
    )


def setup(app):
    app.add_node(course_map, html=(_visit_map, None))
    app.add_directive("route", RouteTable)
    app.add_directive("route-list", RouteList)
    app.add_directive("course-map", CourseMap)

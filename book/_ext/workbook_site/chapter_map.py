"""A chapter's page as a map: `{chapter-map}` around its list of sections.

Each line of the list, "[Hurwitz criterion](ch1/hurwitz.md): §1.2, signs of the real parts", becomes a section
with a picture and with its problems. The picture is from its page, or from the one that `:pictures:` names after
it. A problem belongs to the first section that names it under "Next"; one that no section names follows the problem
before it of the same § of the problem book, or belongs to the first section of that §. The sidebar has the problems
below their sections as well.
"""

import posixpath
import re
from pathlib import Path

from bs4 import BeautifulSoup
from docutils import nodes

from workbook.site import catalogue
from workbook.site.listings import Listing
from workbook_site.tiles import is_wide, picture_of

LINE = re.compile(r"^- \[.*?\]\((?P<page>ch\d+/\w+)\.md\)(?P<about>.*)$", re.M)
CHAPTER = re.compile(r"(?:book|solutions|exercises)/ch(\d+)(?=/|$)")
NUMBERS = re.compile(r"§\d\.\d")
NEXT = re.compile(r"^## Next\n(.*)", re.M | re.S)
NAMED = re.compile(r"\{problem\}`([\d.]+)`")


class ChapterMap(Listing):
    """Shows each section of a list with its picture and its problems."""

    has_content = True
    option_spec = {"pictures": str}

    def content_of(self, problems):
        chapter = Path(self.env.docname).name.removeprefix("ch")
        parsed = nodes.Element()
        self.state.nested_parse(self.content, self.content_offset, parsed)
        members = sections_of(self.env, chapter)
        for page in members:
            self.env.note_dependency(self.env.doc2path(page))
        sections = nodes.container(classes=["chapter-map"])
        pictures = dict(
            pair.split() for pair in self.options.get("pictures", "").split(",") if pair
        )
        for item, (page, found) in zip(
            parsed.findall(nodes.list_item), members.items(), strict=True
        ):
            source = pictures.get(page.removeprefix("book/"), page)
            sections += self._section(item, source, found)
        return [sections]

    def _section(self, item, source, problems):
        section = nodes.container(classes=["chapter-section"])
        if picture := picture_of(self.env, source):
            wide = ["wide"] if is_wide(Path(self.env.srcdir, picture).read_text("utf-8")) else []
            section += nodes.image(uri=f"/{picture}", alt="", classes=wide)
        about = nodes.container("", *item.children, classes=["about"])
        if problems:
            about += nodes.bullet_list("", *map(self._row, problems), classes=["section-problems"])
        section += about
        return section

    def _row(self, problem):
        level = "★ starred" if problem.level == "starred" else problem.level
        facts = [level, f"{problem.minutes} min", *["other numbers"] * problem.varies]
        row = nodes.paragraph("", "", self.link(problem, problem.number), nodes.Text(" "))
        row += [
            self.link(problem, problem.title),
            nodes.Text(" "),
            nodes.inline("", " · ".join(facts), classes=["facts", problem.level]),
        ]
        return nodes.list_item("", row)


def sections_of(env, chapter):
    """Return page -> problems for the sections of a chapter, in the order in which its page lists them."""
    source = Path(env.doc2path(f"book/ch{chapter}"))
    lines = LINE.findall(source.read_text(encoding="utf-8"))
    named, of_number, numbers_of = {}, {}, {}
    for page, about in lines:
        path = source.parent / f"{page}.md"
        if end := NEXT.search(path.read_text(encoding="utf-8")):
            for number in NAMED.findall(end[1]):
                named.setdefault(number, page)
        numbers_of[page] = NUMBERS.findall(about)
        for number in numbers_of[page]:
            of_number.setdefault(number, page)
    if not of_number:  # sections that are our own
        of_number = {f"§{chapter}.{k}": page for k, (page, _) in enumerate(lines, start=1)}
    members = {f"book/{page}": [] for page, _ in lines}
    for problem in catalogue.of(env).values():
        if problem.chapter == chapter:
            page = named.get(problem.number) or of_number[problem.section]
            if problem.section in numbers_of[page]:
                of_number[problem.section] = page
            members[f"book/{page}"].append(problem)
    return members


def _add_sidebar(app, page, template, context, doctree):
    """Put the problems of the open chapter below their sections in the sidebar."""
    toctree = context.get("toctree")
    if toctree is None:
        return

    def grouped(**options):
        tree = BeautifulSoup(toctree(**options), "html.parser")
        items = {_page_of(item.a["href"], page): item for item in tree.select("li:has(> a)")}
        for section, problems in _members_around(app, page).items():
            found = [items[problem.page] for problem in problems if problem.page in items]
            if section in items and found:
                below = tree.new_tag("ul")
                below.extend(found)
                items[section].append(below)
                if any("current" in item["class"] for item in found):
                    items[section]["class"].append("current")
        return str(tree)

    context["toctree"] = grouped


def _page_of(address, page):
    """Return the page to which an address on another page leads."""
    path = posixpath.normpath(posixpath.join(posixpath.dirname(page), address))
    return page if address == "#" else path.removesuffix(".html")


def _members_around(app, page):
    """Return section -> problems of the chapter to which a page belongs; the sidebar shows no other chapter's."""
    chapter = CHAPTER.match(page)
    if chapter is None or f"book/ch{chapter[1]}" not in app.env.found_docs:
        return {}
    if not hasattr(app.builder, "workbook_sections"):
        app.builder.workbook_sections = {}
    known = app.builder.workbook_sections
    if chapter[1] not in known:
        known[chapter[1]] = sections_of(app.env, chapter[1])
    return known[chapter[1]]


def setup(app):
    app.add_directive("chapter-map", ChapterMap)
    app.connect("html-page-context", _add_sidebar, priority=400)  # before the theme takes it

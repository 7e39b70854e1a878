"""The entries of the search: sections, statements, equations, problems, topics, terms, functions.

They are collected when a page is read, and written as the script `search-entries.js`, which
book/_static/search.js loads when the reader searches; a script can be loaded from file:// too.
Solutions are left out. Sphinx's own search is not built. `book/search_names.toml` has further names of places:
synonyms, Russian titles, and what the course does not have.
"""

import html
import json
import re
import tomllib
from copy import deepcopy
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx_exercise.nodes import solution_node
from sphinx_proof.nodes import proof_node

from workbook.site import catalogue
from workbook.site.folding import details
from workbook.site.problem_pages import topic_label

#: Parts of a page that are neither searched nor quoted.
SKIPPED = (
    details,
    solution_node,
    nodes.Invisible,
    nodes.literal_block,
    nodes.doctest_block,
    nodes.table,
    nodes.title,
    addnodes.desc_signature,
    addnodes.toctree,
)
UNSEARCHED = {"cell", "problem-head", "used-in"}
#: The title of a statement: "1.2 (Hurwitz criterion)", "(duality)" or "3.1".
STATEMENT = re.compile(r"(?P<number>\d+\.\d+)?\s*(?:\([^()]*\):)?\s*\(?(?P<name>.*?)\)?")
EXAMPLE = re.compile(r"exm-(\d+)-(\d+)")
#: Sections that list what has entries of its own.
LIST = re.compile(r"sections|topics-.*")
LABEL = re.compile(r"(sec|exm|err|library|lecture)-")
CHAPTER = re.compile(r"book/ch(\d+)")
#: The kind of a section by the folder of its page.
SECTIONS = {
    "book/guides/cases/": "Check",
    "book/lectures/": "Lecture",
    "book/guides/": "Guide",
    "book/errata/": "Errata",
    "book/library/": "Library",
}
#: Sections of the problem book that a page of the chapter follows, as the chapter's page says: "§2.2 and §2.5".
NUMBERS = re.compile(r"§(\d\.\d)")
#: A longer formula is not quoted.
LONGEST_FORMULA = 120
FILE = "search-entries.js"


def words(node):
    """Return the text of a node on one line, its formulas between \\( and \\)."""
    return re.sub(r"…( …)+", "…", " ".join("".join(_pieces(node)).split()))


def _pieces(node):
    if isinstance(node, SKIPPED) or _is_unresolved(node) or _is_mark(node):
        return
    if isinstance(node, nodes.raw):
        yield html.unescape(re.sub(r"<[^>]+>", "", node.astext()))
    elif isinstance(node, (nodes.math, nodes.math_block)):
        formula = " ".join(node.astext().split())
        is_long = len(formula) > LONGEST_FORMULA or r"\begin" in formula or r"\\ " in formula
        yield "…" if is_long else rf"\({formula}\)"
    elif isinstance(node, nodes.Text):
        yield node.astext()
    else:
        for child in node.children:
            yield from _pieces(child)


def _is_unresolved(node):
    """Return whether a reference shows a label or a key until all pages are read."""
    return isinstance(node, addnodes.pending_xref) and not node.get("refexplicit")


def _is_mark(node):
    """Return whether a node is a remark on the printed book, hidden unless a reader asks for it."""
    return isinstance(node, nodes.inline) and "printed" in node["classes"]


class PageEntries:
    """The entries of one page, in their order.

    An entry has a kind, a number (or two, of a section), a title, further terms that lead to it, a
    text, an anchor, the ids inside it, and as its parent the index of the entry that holds it.
    `descriptions` are what a chapter's page says of its sections: page -> text.
    """

    def __init__(self, page, document, problem=None):
        self.page, self.problem, self.entries = page, problem, []
        for child in document.children:
            self._visit(child, None)
        if page == "book/glossary":
            self._add_terms(document)
        self.descriptions = _descriptions(page, document) if CHAPTER.fullmatch(page) else {}

    def _visit(self, node, parent):
        if isinstance(node, (*SKIPPED, nodes.Text)) or UNSEARCHED & set(node["classes"]):
            return
        if any(map(LIST.fullmatch, node["ids"])):
            return
        if isinstance(node, nodes.section) and _title(node) is not None:
            if parent is None or not self.problem:
                parent = self._add_section(node, parent)
        elif "realtype" in node and not isinstance(node, proof_node):
            parent = self._add_statement(node, parent)
        elif isinstance(node, nodes.math_block) and "." in str(node["number"]) and node["ids"]:
            self._add_equation(node, parent)
        if parent is not None:
            entry = self.entries[parent]
            entry["ids"] += node["ids"]
            if isinstance(node, nodes.TextElement):
                entry["text"] = f"{entry['text']} {words(node)}".strip()
                return
        for child in node.children:
            self._visit(child, parent)

    def _add(self, kind, title, anchor, parent, **more):
        entry = {"kind": kind, "title": title, "anchor": anchor, "parent": parent}
        self.entries.append(entry | {"number": "", "terms": [], "text": "", "ids": []} | more)
        return len(self.entries) - 1

    def _add_section(self, node, parent):
        if self.problem:
            number, title = self.problem.number, self.problem.title
            terms = list(self.problem.topics)
            anchor = f"problem-{number}"
            return self._add(
                "Problem", f"{number} {title}", anchor, None, number=number, terms=terms
            )
        title = words(nodes.inline("", "", *_title(node).deepcopy().children))
        anchor = next(filter(LABEL.match, node["ids"]), node["ids"][0])
        if example := EXAMPLE.fullmatch(anchor):
            return self._add("Example", title, anchor, parent, number=".".join(example.groups()))
        if anchor.startswith("library-"):
            return self._add("Function", title, anchor, parent)
        if parent is None and (chapter := CHAPTER.fullmatch(self.page)):
            title = f"Chapter {chapter[1]}: {title}"
            return self._add("Chapter", title, anchor, None, number=chapter[1])
        folder = next(filter(self.page.startswith, SECTIONS), None)
        return self._add(SECTIONS.get(folder, "Section"), title, anchor, parent)

    def _add_statement(self, node, parent):
        title = node["title"].strip()
        match = STATEMENT.fullmatch(title)
        terms = [match["name"]] if match["name"] else []
        self.entries[parent]["terms"] += terms
        kind, number = node["realtype"].capitalize(), match["number"] or ""
        return self._add(kind, f"{kind} {title}", node["label"], parent, number=number, terms=terms)

    def _add_equation(self, node, parent):
        before = self.entries[parent]["text"].rpartition(". ")[2]
        text, number = f"{before} {words(node)}".strip(), node["number"]
        self._add("Equation", f"({number})", node["ids"][0], parent, number=number, text=text)

    def _add_terms(self, document):
        """Add the rows of the glossary, each with an id of its own."""
        for row in document.findall(nodes.row):
            if isinstance(row.parent, nodes.thead):
                continue
            english, russian, meaning, _ = (words(cell) for cell in row.children)
            row["ids"] = [nodes.make_id(f"term-{english}")]
            self._add(
                "Term",
                english,
                row["ids"][0],
                0,
                terms=[russian],
                text=f"{russian}: {meaning}",
                introduced=[_target(reference) for reference in row[-1].findall(_is_reference)],
            )


def _title(section):
    """Return the title of a section, before which its label may stand, or None."""
    return next((child for child in section.children if isinstance(child, nodes.title)), None)


def _is_reference(node):
    return isinstance(node, (nodes.reference, addnodes.pending_xref))


def _target(reference):
    return reference.get("refid") or reference.get("reftarget", "")


def _descriptions(page, document):
    """Return what a chapter says of its sections: "[State feedback](ch3/state_feedback.md): §3.2, ..."."""
    described = {}
    for line in document.findall(nodes.container):
        if "about" not in line["classes"]:
            continue
        reference = next(line.findall(addnodes.pending_xref), None)
        _, colon, description = words(line[0]).partition(": ")
        if reference is not None and colon:
            described[_target(reference).strip("/")] = description
    return described


def _collect(app, document):
    env = app.env
    env.workbook_search = getattr(env, "workbook_search", {})
    problem = catalogue.of(env).get(env.docname)
    env.workbook_search[env.docname] = PageEntries(env.docname, document, problem)


def _forget(app, env, page):
    getattr(env, "workbook_search", {}).pop(page, None)


def entries(env):
    """Return the entries of all pages in the order of the book, each with its address."""
    pages = {page: env.workbook_search[page] for page in env.collect_relations()}
    collected = {page: deepcopy(pages[page].entries) for page in pages}
    holders = {
        label: (page, k)
        for page in reversed(pages)
        for k, entry in enumerate(collected[page])
        for label in entry["ids"]
    }
    for page, read in pages.items():
        for target, description in read.descriptions.items():
            if collected.get(target):
                section = collected[target][0]
                section["number"] = " ".join(NUMBERS.findall(description))
                section["terms"] += re.split(r"[,;] ", description)
        for term in collected[page]:
            for label in term.get("introduced", ()):
                _add_names(collected, *holders.get(label, (page, None)), term)
    names = _further_names(env)
    for label, further in names["places"].items():
        if label in holders:
            page, k = holders[label]
            collected[page][k]["names"] = further
    for page, problem in catalogue.of(env).items():
        if page in pages and problem.number in names["problems"]:
            collected[page][0]["names"] = [names["problems"][problem.number]]
    listed = [_written(env, page, entry) for page in pages for entry in collected[page]]
    listed += _topics(env)
    for topic in names["absent"]:
        if topic["nearest"] in holders:
            page, k = holders[topic["nearest"]]
            listed.append(_absent(topic, _written(env, page, collected[page][k])))
    _translate_topics(listed)
    return listed


def _further_names(env):
    """Return what book/search_names.toml says: names of places and problems, and what is absent."""
    path = Path(env.srcdir, "book", "search_names.toml")
    text = path.read_text(encoding="utf-8") if path.exists() else ""
    return {"places": {}, "problems": {}, "absent": []} | tomllib.loads(text)


def _absent(topic, nearest):
    """Return the entry of a topic that the course does not have, which leads to the nearest place."""
    return {
        "kind": "Absent",
        "title": topic["title"],
        "terms": topic["names"],
        "text": f"The course has nothing on it. Nearest is: {nearest['title']}.",
        "url": nearest["url"],
    }


def _add_names(collected, page, k, term):
    """Add a term's words, English and Russian, to the entry that introduces it and those around it."""
    while k is not None:
        collected[page][k]["terms"] += [*term["title"].split(", "), *term["terms"]]
        k = collected[page][k]["parent"]


def _translate_topics(listed):
    """Give the problems and topics the Russian words of the glossary for their English ones."""
    russian = {
        english.strip().casefold(): term["terms"]
        for term in listed
        if term["kind"] == "Term"
        for english in term["title"].split(",")
    }
    for entry in listed:
        if entry["kind"] in ("Problem", "Topic"):
            terms = entry.get("terms", [])
            names = [entry["title"], *terms]
            translations = [word for name in names for word in russian.get(name.casefold(), ())]
            entry["terms"] = terms + translations


def _written(env, page, entry):
    written = {
        "kind": entry["kind"],
        "number": entry["number"],
        "title": entry["title"],
        "terms": list(dict.fromkeys(entry["terms"])),
        "names": entry.get("names"),
        "text": entry["text"],
        "url": f"{page}.html#{entry['anchor']}",
        "place": _place(env, page, entry),
    }
    return {name: value for name, value in written.items() if value}


def _place(env, page, entry):
    """Return the chapter and the page around an entry."""
    if problem := catalogue.of(env).get(page):
        return f"Chapter {problem.chapter}, {problem.section}"
    chapter = CHAPTER.match(page)
    place = [f"Chapter {chapter[1]}"] if chapter else []
    if entry["parent"] is not None:
        place.append(words(nodes.inline("", "", *env.titles[page].deepcopy().children)))
    return ", ".join(place)


def _topics(env):
    """Return an entry for each topic, with its problems as the text."""
    if "book/topics" not in env.found_docs:
        return []
    problems = {}
    for problem in catalogue.of(env).values():
        for topic in problem.topics:
            problems.setdefault(topic, []).append(f"{problem.number} {problem.title}")
    return [
        {
            "kind": "Topic",
            "title": topic,
            "text": "; ".join(titles),
            "url": f"book/topics.html#{topic_label(topic)}",
        }
        for topic, titles in problems.items()
    ]


def _write(app, exception):
    if exception is None and app.builder.format == "html":
        # one entry a line
        lines = ",\n".join(json.dumps(entry, ensure_ascii=False) for entry in entries(app.env))
        (app.outdir / FILE).write_text(f"globalThis.searchEntries = [\n{lines}\n];\n", "utf-8")
        for script in ("searchtools.js", "language_data.js"):  # of Sphinx's search
            (app.outdir / "_static" / script).unlink(missing_ok=True)


def _without_sphinx_search(app):
    app.builder.search = False


def setup(app):
    app.connect("builder-inited", _without_sphinx_search)
    app.connect("doctree-read", _collect, priority=960)  # after all numbers are given
    app.connect("env-purge-doc", _forget)
    app.connect("build-finished", _write)

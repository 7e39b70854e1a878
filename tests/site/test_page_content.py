"""What the built pages show: pictures with their captions, drawings, answers and solutions where
they belong."""

import re

import pytest
from bs4 import BeautifulSoup

from trajlib.typesetting import GREEK, TYPEWRITTEN

full = pytest.mark.parametrize("pages", ["full"], indirect=True)
PROBLEM, CHAPTER = "solutions/ch*/p*.html", "book/ch*.html"


def those(pages, *patterns):
    """The parsed pages at places of these forms, in order."""
    root, parsed = pages
    return {
        path: parsed[path]
        for path in sorted(path for pattern in patterns for path in root.glob(pattern))
    }


#: A Greek letter by its name.
SPELT = re.compile(rf"\b({'|'.join(GREEK)})(?![a-z])")


@full
def test_results_are_set_and_not_typed(pages):
    """What cells show holds no powers, products, roots or Greek letters as they are typed, and no
    warnings."""
    faults, shown = {}, 0
    for path, page in those(pages, PROBLEM, CHAPTER, "book/errata/ch*.html").items():
        found = [warning.get_text()[:80] for warning in page.select(".cell_output .stderr")]
        for output in page.select(".cell_output"):
            shown += len(output.select(".math"))
            words = "".join(
                text for text in output.find_all(string=True) if not text.find_parent(class_="math")
            )
            found += [
                line
                for line in words.splitlines()
                if TYPEWRITTEN.search(line) or SPELT.search(line)
            ]
        if found:
            faults[path.name] = found
    assert shown > 1000 and not faults


@full
def test_units_stand_upright(pages):
    """After a number that is typed m/s is a speed; alone, in the head of a column, it would be set
    as two letters."""
    faults = {
        path.name: found
        for path, page in those(pages, PROBLEM, CHAPTER, "book/lectures/*.html").items()
        if (
            found := re.findall(
                r".{,40}<i>m</i>/<i>s</i>|, <i>k?m</i></p>",
                "".join(map(str, page.select(".cell_output"))),
            )
        )
    }
    assert not faults


#: Python's own forms of a value, and decimals of more than nine places; an enclosure, m ± r, has
#: all that are proved.
RAW = re.compile(
    r"array\(|Matrix\(|\bnp\.\w+\(|Float\(|\{\w+: |\[\[|[\[(]'|', '|\d\.\d{10,}(?!\d* (?:±|\+/-))"
)


@full
def test_no_value_is_shown_as_python_writes_it(pages):
    faults, shown = {}, 0
    for path, page in those(
        pages, PROBLEM, CHAPTER, "book/errata/ch*.html", "book/lectures/*.html"
    ).items():
        lines = [
            line
            for output in page.select(".cell_output")
            for line in "".join(
                text for text in output.find_all(string=True) if not text.find_parent(class_="math")
            ).splitlines()
        ]
        shown += len(lines)
        if found := [line for line in lines if RAW.search(line)]:
            faults[path.name] = found
    assert shown > 1000 and not faults


@full
def test_nothing_is_printed(pages):
    """Results and their tables are set; two numbers do not stand side by side without a comma."""
    faults = {}
    for path, page in those(
        pages, PROBLEM, CHAPTER, "book/errata/ch*.html", "book/lectures/*.html"
    ).items():
        found = [output.get_text()[:80] for output in page.select(".cell_output pre")]
        for line in page.select(".cell_output > p"):
            words = "".join(
                "§" if text.find_parent(class_="math") else text
                for text in line.find_all(string=True)
            )
            found += re.findall(r".{,20}\d +[−-]?\d.{,20}", words)
        if found:
            faults[path.name] = found
    assert not faults


@full
def test_every_picture_is_sharp_and_has_a_number_a_caption_and_words(pages):
    faults, seen = [], 0
    for path, page in those(pages, PROBLEM, CHAPTER).items():
        numbers = []
        for picture in page.select(".cell_output img"):
            seen += 1
            caption = picture.find_parent("figure") and picture.find_parent("figure").figcaption
            label = (
                re.match(r"Figure \d+\.\d+[a-z]?(?=\. )", caption.get_text().strip())
                if caption
                else None
            )
            told = label and re.match(rf"{re.escape(label[0])}: [^\\]{{13,}}\.$", picture["alt"])
            if not told or not picture["src"].endswith(".svg"):
                faults.append(f"{path.name}: {picture['alt'][:60]}")
            numbers.append(label and label[0])
        assert len(set(numbers)) == len(numbers), path
    assert seen > 0 and not faults, "\n".join(faults)


@pytest.mark.parametrize("pages", ["student"], indirect=True)
def test_drawings_stand_in_the_statement_of_both_editions(pages, editions):
    seen = 0
    for path, page in those(pages, "exercises/ch*/p*.html").items():
        full = editions.full / "solutions" / path.relative_to(editions.student / "exercises")
        text = full.read_text(encoding="utf-8")
        # most have none to look for
        with_drawing = BeautifulSoup(text if "tag_drawing" in text else "", "html.parser")
        given = page.select("figure img[src^='data:image/png;base64,']")
        inside = with_drawing.select("div.exercise .tag_drawing figure img")
        # What is said of it differs by a letter of the number alone, where the solution has figures
        # too.
        assert [re.sub(r"(Figure [\d.]+)[a-z]?:", r"\1:", picture["alt"]) for picture in given] == [
            re.sub(r"(Figure [\d.]+)[a-z]?:", r"\1:", picture["alt"]) for picture in inside
        ], path
        seen += len(given)
    assert seen >= 3


@full
def test_the_answers_of_an_item_stand_under_its_statement(pages):
    """Of problems whose statement has items, every fold stands inside the statement."""
    moved = 0
    for path, page in those(pages, PROBLEM).items():
        folds = page.select("details.answers")
        assert folds, path
        moved += len(page.select("div.exercise details.answers"))
        items = {
            p.get_text()[0]
            for p in page.select("div.exercise p")
            if re.match(r"[a-l]\)(\W|$)", p.get_text())
        }
        outside = [fold for fold in folds if not fold.find_parent(class_="exercise")]
        assert [
            fold
            for fold in outside
            if re.match(rf"[{''.join(items) or '-'}]_", fold.code.get_text())
        ] == [], path
        names = re.findall(
            r"\w+", " ".join(fold.summary.get_text().partition(":")[2] for fold in folds)
        )
        assert len(names) == len(set(names)) == len(page.select("details.answers .answer"))
    assert moved > 100


@full
def test_every_column_of_a_table_has_a_head(pages):
    """Somebody who hears a table is told the head of each entry."""
    heads = [
        (path.name, head.get_text().strip())
        for path, page in pages[1].items()
        for head in page.select("article th")
    ]
    assert len(heads) > 100 and not [name for name, text in heads if not text]


@full
def test_a_comma_stays_with_its_formula(pages):
    """A browser breaks the line between a formula and the sign after it unless both stand in one
    unbroken span."""
    torn = {}
    for path, page in pages[1].items():
        signs = [
            formula.next_sibling
            for formula in page.select("article span.math")
            if "unbroken" not in formula.parent.get("class", [])
        ]
        found = [
            sign[:20] for sign in signs if isinstance(sign, str) and sign[:1] in tuple(".,;:!?)")
        ]
        if found:
            torn[path.name] = found
    assert not torn


@full
def test_a_problem_without_items_has_one_solution_without_a_letter(pages):
    for path, page in those(pages, PROBLEM).items():
        titles = [fold.summary.get_text() for fold in page.select("details.solution")]
        assert titles and (
            titles[0].startswith("Worked solution") and "item" not in titles[0]
            if len(titles) == 1
            else all("item" in title for title in titles)
        ), (path.name, titles)

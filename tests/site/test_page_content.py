"""The content of the built pages: outputs, pictures, drawings, answers, solutions."""

import re
import tomllib
from pathlib import Path

import pytest
from bs4 import BeautifulSoup

from trajlib.typesetting import GREEK, TYPEWRITTEN

full = pytest.mark.parametrize("pages", ["full"], indirect=True)
PROBLEM, SECTION = "solutions/ch*/p*.html", "book/ch*/*.html"


def matching(pages, *patterns):
    """Return path -> parsed page of the pages that match, in order."""
    root, parsed = pages
    return {
        path: parsed[path]
        for path in sorted(path for pattern in patterns for path in root.glob(pattern))
    }


#: A Greek letter by its name.
GREEK_NAME = re.compile(rf"\b({'|'.join(GREEK)})(?![a-z])")


@full
def test_results_are_typeset(pages):
    """Outputs have no typewritten powers, products, roots or Greek letters, and no warnings."""
    faults, shown = {}, 0
    for path, page in matching(pages, PROBLEM, SECTION, "book/errata/ch*.html").items():
        found = [warning.get_text()[:80] for warning in page.select(".cell_output .stderr")]
        for output in page.select(".cell_output"):
            shown += len(output.select(".math"))
            words = "".join(
                text for text in output.find_all(string=True) if not text.find_parent(class_="math")
            )
            found += [
                line
                for line in words.splitlines()
                if TYPEWRITTEN.search(line) or GREEK_NAME.search(line)
            ]
        if found:
            faults[path.name] = found
    assert shown > 1000 and not faults


@full
def test_units_are_upright(pages):
    """After a number m/s is a unit; alone, in the head of a column, it would be two variables."""
    faults = {
        path.name: found
        for path, page in matching(pages, PROBLEM, SECTION, "book/lectures/*.html").items()
        if (
            found := re.findall(
                r".{,40}<i>m</i>/<i>s</i>|, <i>k?m</i></p>",
                "".join(map(str, page.select(".cell_output"))),
            )
        )
    }
    assert not faults


#: Values in Python's notation, and decimals of more than nine places except in an enclosure, m ± r.
PYTHON_NOTATION = re.compile(
    r"array\(|Matrix\(|\bnp\.\w+\(|Float\(|\{\w+: |\[\[|[\[(]'|', '|\d\.\d{10,}(?!\d* (?:±|\+/-))"
)


@full
def test_no_value_is_shown_in_python_notation(pages):
    faults, shown = {}, 0
    for path, page in matching(
        pages, PROBLEM, SECTION, "book/errata/ch*.html", "book/lectures/*.html"
    ).items():
        lines = [
            line
            for output in page.select(".cell_output")
            for line in "".join(
                text for text in output.find_all(string=True) if not text.find_parent(class_="math")
            ).splitlines()
        ]
        shown += len(lines)
        if found := [line for line in lines if PYTHON_NOTATION.search(line)]:
            faults[path.name] = found
    assert shown > 1000 and not faults


@full
def test_no_output_is_plain_text(pages):
    """Results and tables are typeset; two numbers in a line have a comma between them."""
    faults = {}
    for path, page in matching(
        pages, PROBLEM, SECTION, "book/errata/ch*.html", "book/lectures/*.html"
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
def test_every_picture_is_an_svg_with_number_caption_and_alternative_text(pages):
    faults, seen = [], 0
    for path, page in matching(pages, PROBLEM, SECTION).items():
        numbers = []
        for picture in page.select(".cell_output img:not(.explorer-still)"):
            seen += 1
            caption = picture.find_parent("figure") and picture.find_parent("figure").figcaption
            label = (
                re.match(r"Figure (\d+\.)?\d+[a-z]?(?=\. )", caption.get_text().strip())
                if caption
                else None
            )
            described = label and re.match(
                rf"{re.escape(label[0])}: [^\\]{{13,}}\.$", picture["alt"]
            )
            if not described or not picture["src"].endswith(".svg"):
                faults.append(f"{path.name}: {picture['alt'][:60]}")
            numbers.append(label and label[0])
        assert len(set(numbers)) == len(numbers), path
    assert seen > 0 and not faults, "\n".join(faults)


@pytest.mark.parametrize("pages", ["student"], indirect=True)
def test_drawings_are_in_the_statement_of_both_editions(pages, editions):
    seen = 0
    for path, page in matching(pages, "exercises/ch*/p*.html").items():
        full = editions.full / "solutions" / path.relative_to(editions.student / "exercises")
        text = full.read_text(encoding="utf-8")
        # most pages have no drawing
        with_drawing = BeautifulSoup(text if "tag_drawing" in text else "", "html.parser")
        in_student = page.select("figure img[src^='data:image/png;base64,']")
        in_full = with_drawing.select("div.exercise .tag_drawing figure img")
        # The texts differ by the letter of the number alone, if the solution has figures too.
        assert [
            re.sub(r"(Figure [\d.]+)[a-z]?:", r"\1:", picture["alt"]) for picture in in_student
        ] == [re.sub(r"(Figure [\d.]+)[a-z]?:", r"\1:", picture["alt"]) for picture in in_full], (
            path
        )
        seen += len(in_student)
    assert seen >= 3


@full
def test_the_answers_of_an_item_are_under_its_statement(pages):
    """If the statement has items, every fold is inside the statement."""
    moved = 0
    for path, page in matching(pages, PROBLEM).items():
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
    """A screen reader announces the head of each entry."""
    heads = [
        (path.name, head.get_text().strip())
        for path, page in pages[1].items()
        for head in page.select("article th")
    ]
    assert len(heads) > 100 and not [name for name, text in heads if not text]


@full
def test_a_comma_stays_with_its_formula(pages):
    """A browser breaks a line between a formula and its comma unless one span holds both."""
    separated = {}
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
            separated[path.name] = found
    assert not separated


@full
def test_a_problem_without_items_has_one_solution_without_a_letter(pages):
    for path, page in matching(pages, PROBLEM).items():
        titles = [fold.summary.get_text() for fold in page.select("details.solution")]
        assert titles and (
            titles[0].startswith("Worked solution") and "item" not in titles[0]
            if len(titles) == 1
            # what is asked in general, before the items, is solved first and has no letter
            else all("item" in title for title in titles[1:])
        ), (path.name, titles)


def test_mistakes_are_only_in_the_edition_with_solutions(editions):
    """There each answer has a named fold of two to four; on paper only those the reader opened."""
    seen = 0
    for path in sorted(editions.full.glob(PROBLEM)):
        page = BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")
        for fold in page.select("details.mistakes"):
            assert fold.summary.code.get_text() in fold.pre.get_text(), path
            mistakes = fold.select(".common-mistake")
            assert 1 <= len(mistakes) <= 4, path
            for mistake in mistakes:
                assert mistake.select_one(".workbook-verdict.wrong"), path
                assert mistake.select_one(".question").get_text().startswith("Ask yourself: ")
            seen += 1
    assert seen > 1400
    for path in editions.student.rglob("*.html"):
        assert "common-mistake" not in path.read_text(encoding="utf-8"), path


def test_the_front_page_has_tiles_with_pictures(editions):
    for edition, count in ((editions.full, 9 + 11), (editions.student, 9)):
        page = BeautifulSoup((edition / "book" / "index.html").read_text("utf-8"), "html.parser")
        tiles = page.select(".tile")
        assert len(tiles) == count and all(tile.img and tile.a for tile in tiles)
        assert [mark.get_text(strip=True) for mark in page.select(".two-verdicts .mark")] == [
            "✗",
            "✓",
        ]
        preview = page.select_one("meta[property='og:image']")["content"]
        assert (edition / "book" / preview).resolve().is_file()


def test_the_index_has_no_numbers(editions):
    """An entry of a number alone would stand under "Symbols"."""
    index = (editions.full / "genindex.html").read_text(encoding="utf-8")
    assert 'id="S"' in index and 'id="Symbols"' not in index


@full
def test_the_page_of_downloads_offers_the_wheel(pages):
    root, parsed = pages
    page = parsed[root / "book" / "downloads.html"]
    wheel = page.select_one("ul.downloads a[href$='.whl']")
    assert (root / "book" / wheel["href"]).resolve().exists()


@full
def test_decimals_said_to_be_printed_are(pages):
    """Numbers of the prose that `prose_numbers.toml` leaves to cells are in the outputs of their page."""
    file = Path(__file__).resolve().parents[1] / "authoring" / "prose_numbers.toml"
    accepted = tomllib.loads(file.read_text(encoding="utf-8"))
    root, parsed = pages
    missing = {}
    for page, numbers in accepted.items():
        outputs = parsed[root / page.replace(".md", ".html")].select(".cell_output")
        text = " ".join(output.get_text() for output in outputs)
        values = [float(value) for value in re.findall(r"\d+\.\d+", text)]
        for number in (name for name, how in numbers.items() if how == "printed"):
            half = 0.501 * 10.0 ** -len(number.partition(".")[2])
            if not any(abs(value - float(number)) <= half for value in values):
                missing.setdefault(page, []).append(number)
    assert not missing

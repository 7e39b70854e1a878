"""The book as PDF: titles, links, numbers and the margins of every sheet, looked at as it is rendered."""

import importlib.util
import os
from pathlib import Path

import numpy as np
import pypdfium2
import pytest
from pypdf import PdfReader

ROOT = Path(__file__).resolve().parents[2]
CHAPTERS = "123456789" if os.environ.get("WORKBOOK_ALL_PROBLEMS") else "8"
#: Points of a sheet that are looked at, to an inch.
RESOLUTION = 50


@pytest.fixture(scope="module")
def pdf(editions):
    """Return the module that prints the built site."""
    spec = importlib.util.spec_from_file_location("book_pdf", ROOT / "book" / "pdf.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module", params=CHAPTERS)
def document(request, pdf, tmp_path_factory):
    """Return the pages of a chapter and the path of its PDF."""
    folder = tmp_path_factory.mktemp("pdf")
    pdf.main([request.param], folder)
    return pdf.chapters()[request.param], folder / f"chapter-{request.param}.pdf"


@pytest.fixture(scope="module")
def texts(document):
    """Return the text of each sheet on one line, its head and number last; pypdf would take a minute a hundred."""
    sheets = pypdfium2.PdfDocument(document[1])
    # PDFium writes a hyphen that ends a line as a control character
    lines = (sheet.get_textpage().get_text_range().replace("\x02", "-") for sheet in sheets)
    return [" ".join(line.split()) for line in lines]


def test_bookmarks_lead_to_the_sheets_with_these_titles(document, texts):
    pages, path = document
    reader = PdfReader(path)
    chapter, (*sections, appendix, solutions) = reader.outline[1:]
    assert [chapter.title, *(section.title for section in sections)] == [p.title for p in pages]
    problems = [page.title for page in pages if page.is_problem]
    assert appendix.title == "Solutions" and [entry.title for entry in solutions] == problems
    numbers = [reader.get_destination_page_number(entry) for entry in (*sections, *solutions)]
    assert numbers == sorted(numbers)
    for number, entry in zip(numbers, (*sections, *solutions), strict=True):
        assert entry.title.split("$")[0][:20] in texts[number]


def test_contents_give_the_numbers_of_their_sheets(document, texts):
    """The contents, and those of the appendix, give in their order the numbers of what they list."""
    reader = PdfReader(document[1])
    front, chapter, (*sections, appendix, solutions) = reader.outline
    for contents, entries in (front, [chapter, *sections, appendix]), (appendix, solutions):
        numbers = [reader.get_destination_page_number(entry) + 1 for entry in entries]
        first = reader.get_destination_page_number(contents)
        words = iter(" ".join(texts[first : numbers[0] - 1]).split())
        assert all(str(number) in words for number in numbers)


def test_solutions_stand_in_the_appendix(document, texts):
    """A statement is printed without its hints and its solution, and each leads to the other."""
    reader = PdfReader(document[1])
    first = {}
    for entry in (sections := reader.outline[2]) + sections[-1]:
        if not isinstance(entry, list):
            first.setdefault(entry.title, []).append(reader.get_destination_page_number(entry))
    appendix = first["Solutions"][0]
    problems = {title: sheets for title, sheets in first.items() if len(sheets) == 2}
    assert len(problems) == sum(page.is_problem for page in document[0]) > 0
    for statement, solution in problems.values():
        assert statement < appendix < solution
        for sheet, other in ((statement, solution), (solution, statement)):
            assert reader.pages[other].indirect_reference.idnum in {
                link.get_object()["/Dest"][0].idnum
                for link in reader.pages[sheet]["/Annots"]
                if "/Dest" in link.get_object()
            }
    for title in ("Worked solution", "Hints"):
        sheets = [number for number, text in enumerate(texts) if title in text]
        assert sheets and min(sheets) > appendix
    assert not [number for number, text in enumerate(texts) if "Hint 1" in text]


def test_sheets_are_numbered(texts):
    last = [text.split()[-1] for text in texts]
    assert last[1:] == [str(number) for number in range(2, len(last) + 1)]


def test_links_lead_into_the_document_or_out_of_the_site(document):
    reader = PdfReader(document[1])
    sheets = {sheet.indirect_reference.idnum for sheet in reader.pages}
    links = [a.get_object() for sheet in reader.pages for a in sheet.get("/Annots", [])]
    inner = [link["/Dest"][0].idnum for link in links if "/Dest" in link]
    outer = [link["/A"]["/URI"] for link in links if "/A" in link]
    assert len(inner) > 20 and set(inner) <= sheets
    assert all(address.startswith(("http://", "https://")) for address in outer)


def test_nothing_stands_in_the_margins(document, pdf):
    """Nothing but the running head and the number stands beyond the text, and no sheet is empty."""
    sides = [pdf.MARGINS[f"margin{side}"] for side in ("Top", "Bottom", "Left", "Right")]
    top, bottom, left, right = (int(side * RESOLUTION) - 1 for side in sides)
    faults = []
    for number, sheet in enumerate(pypdfium2.PdfDocument(document[1])):
        image = sheet.render(scale=RESOLUTION / 72, grayscale=True).to_numpy()
        ink = np.argwhere(image < 160)
        rows, columns = ink[:, 0], ink[:, 1]
        beside = (columns < left) | (columns >= image.shape[1] - right)
        # the head ends at 0.7 inches, the number begins 0.6 inches above the end
        above = (rows > 0.72 * RESOLUTION) & (rows < top)
        below = (rows > image.shape[0] - bottom) & (rows < image.shape[0] - 0.62 * RESOLUTION)
        text = (rows >= top) & (rows < image.shape[0] - bottom) & ~beside
        if beside.any() or above.any() or below.any() or not text.any():
            faults.append((number + 1, int(beside.sum()), int(above.sum()), int(below.sum())))
    assert faults == []


def test_an_unknown_chapter_is_refused(pdf, tmp_path):
    with pytest.raises(SystemExit, match="There is no chapter 17; there are 1, 2"):
        pdf.main(["17"], tmp_path)

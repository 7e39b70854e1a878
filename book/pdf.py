"""Typeset the built site as PDF: a file for each chapter and one for the whole book, in _build/pdf.

    python book/pdf.py [CHAPTER ...]      for example: python book/pdf.py 1 5

Chromium prints each page of the site, a problem's page in two parts: its statement, and its hints and solution
for the appendix of the chapter. Within a chapter a page begins on the sheet on which the page before it
ends, if there is room, and a solution likewise. Then the pages of a document are joined: a link to another
of them leads to its sheet, titles become bookmarks, and every sheet gets its running head and number.
"""

import base64
import html
import io
import re
import shutil
import sys
import tempfile
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from urllib.parse import unquote, urldefrag, urljoin, urlsplit

import yaml
from pypdf import PdfReader, PdfWriter
from pypdf.generic import ArrayObject, Fit, FloatObject, NameObject, NullObject

ROOT = Path(__file__).resolve().parent.parent
SITE = ROOT / "_build" / "html"
OUTPUT = ROOT / "_build" / "pdf"
#: What is printed behind the chapters of the whole book.
BACK_MATTER = ["book/conventions", "book/glossary", "book/errata/index", "book/bibliography"]
#: Sides of A4 and the margins round the text, in inches as Chromium takes them.
WIDTH, HEIGHT = 8.27, 11.69
MARGINS = {"marginTop": 0.95, "marginBottom": 0.85, "marginLeft": 0.8, "marginRight": 0.8}
#: Text of the site is 18 px high; on paper it is set in 11 points, on so many pixels of the site.
SCALE = 0.8
TEXT_WIDTH = (WIDTH - MARGINS["marginLeft"] - MARGINS["marginRight"]) * 96 / SCALE
STYLE = (ROOT / "book" / "pdf.css").read_text("utf-8")
#: What pages have on paper beyond the site's own style for print.
PAGE_STYLE = (ROOT / "book" / "pdf_pages.css").read_text("utf-8")
#: A page begins below another if that ends above this height; the space between them, in inches.
LOWEST_BEGIN, SPACE = 7.6, 0.35
#: Anchors at the title of a page and below its last line.
BEGIN, END = "sheet-begin", "sheet-end"
#: The fonts of the site, of which the first rules of its style tell.
FONTS = re.findall(
    r"@font-face .*", (ROOT / "book" / "_static" / "workbook.css").read_text("utf-8")
)


#: What the anchor of a problem's page is called that leads to its solution.
SOLUTION = "solution"
#: Links to functions of the library, whose pages are not printed.
LIBRARY = ".used-in"
#: What is not printed of a page, and of the two parts of a problem's page.
HIDDEN = {
    "page": LIBRARY,
    "statement": f"{LIBRARY}, .solution, .tag_check, .common-mistakes, .to-statement, .hint, .hints",
    SOLUTION: f"{LIBRARY}, .problem-head, .exercise, .problem-answers, .problem-core, .to-solution",
}


@dataclass(frozen=True)
class Page:
    """A page of the site, or a part of it: its name without ".html", its title, its level in the bookmarks."""

    name: str
    title: str
    level: int
    part: str = ""

    @property
    def address(self):
        return (SITE / f"{self.name}.html").as_uri() + (f"#{self.part}" if self.part else "")

    @property
    def is_problem(self):
        return self.name.startswith("solutions/")


class Printed:
    """The PDF of a page; whether its first sheet is laid over the last one of the page before it."""

    def __init__(self, pdf, runs_on=False):
        self.sheets, self.runs_on = PdfReader(io.BytesIO(pdf)), runs_on
        #: The number of sheets with text: space below the last line may take a sheet of its own.
        self.length = len(self.sheets.pages)
        while self.length > 1 and not self.sheets.pages[self.length - 1].extract_text().strip():
            self.length -= 1
        #: anchor -> number of the sheet and the height there, in points
        self.positions = {
            anchor.lstrip("/"): (self.sheets.get_destination_page_number(found), _height(found.top))
            for anchor, found in self.sheets.named_destinations.items()
        }

    @property
    def first(self):
        """The number of the sheet with the title and its height there."""
        return self.positions.get(BEGIN, (0, None))


def _height(top):
    """Return the height of a destination on its sheet: Chromium gives it without the scale and the margin."""
    height = 72 * HEIGHT
    return height - 72 * MARGINS["marginTop"] - SCALE * (height - top)


def title_of(name):
    """Return the title of a built page as text, its formulas in TeX."""
    # the pages have a million elements: a parser would take minutes for all of them
    heading = re.search(r"<h1>(.*?)</h1>", (SITE / f"{name}.html").read_text("utf-8"), re.S)
    return " ".join(html.unescape(re.sub(r"<[^>]*>|\\\\[()]", "", heading[1])).split())


def chapters():
    """Return the pages of each chapter by its number: the chapter, its sections, its problems' statements."""
    toc = yaml.safe_load((ROOT / "_toc.yml").read_text("utf-8"))
    return {
        (number := entry["file"].removeprefix("book/ch")): [
            Page(entry["file"], f"{number}. {title_of(entry['file'])}", 0),
            *(Page(name, title_of(name), 1) for name in _names(entry["sections"])),
        ]
        for part in toc["parts"]
        for entry in part["chapters"]
        if entry["file"].startswith("book/ch")
    }


def _names(entries):
    for entry in entries:
        if "file" in entry:
            yield entry["file"]
        else:
            paths = sorted(SITE.glob(f"{entry['glob']}.html"))
            yield from (str(path.relative_to(SITE).with_suffix("")) for path in paths)


class Printer:
    """Chromium that prints pages of the site and resolves no host name."""

    def __init__(self, driver):
        self.driver = driver
        self.printed = {}  # chapters and the book share their pages
        self.begin = {}  # part -> inches from the top at which that of the next problem begins
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
        driver.set_window_size(round(TEXT_WIDTH), 1200)

    def print(self, page, anchors):
        """Print a page in the light theme; the anchors become named destinations."""
        if page.name not in self.printed:
            self.driver.get(page.address)
            # Chromium keeps the position of an element only if a link of the same page leads to it, and
            # only those links that lead to an element or to another address
            self.driver.execute_async_script(
                """
                document.documentElement.dataset.theme = 'light';
                const links = document.createElement('div'), article = document.querySelector('article');
                for (const anchor of arguments[0])
                    links.appendChild(document.createElement('a')).href = '#' + anchor;
                const [begin, end] = arguments[2];
                links.id = end;
                article.append(links);
                article.querySelector('h1').insertAdjacentHTML('afterbegin', `<span id=${begin}></span>`);
                document.querySelector('.problem-head')?.insertAdjacentHTML('beforebegin',
                    `<p class=to-solution><a href="?#${arguments[1]}">Solution</a></p>
                     <p class=to-statement><a href="${location.pathname}">Problem</a></p>`);
                const ready = window.MathJax?.startup?.promise ?? Promise.resolve();
                ready.then(() => {
                    // a statement is printed without its hints: they stand before the solution
                    const hints = document.createElement('div');
                    hints.className = 'hints';
                    for (const answer of document.querySelectorAll('.answer:has(> .hint)')) {
                        const line = hints.appendChild(document.createElement('p'));
                        line.append(answer.querySelector('code').cloneNode(true));
                        for (const hint of answer.querySelectorAll('.hint > :not(summary)'))
                            line.append(' ', ...hint.cloneNode(true).childNodes);
                    }
                    if (hints.childElementCount) hints.insertAdjacentHTML('afterbegin', '<h2>Hints</h2>');
                    document.querySelector('.problem-head')?.before(hints);
                    return document.fonts.ready;
                }).then(arguments[3]);""",
                sorted({*anchors, BEGIN, END}),
                SOLUTION,
                [BEGIN, END],
            )
            if page.level == 0:
                self.begin = {}
            self.printed[page.name] = (
                {"": self._below("statement", ""), SOLUTION: self._below(SOLUTION, SOLUTION)}
                if page.is_problem
                else {"": self._below("page", "")}
            )
        return Printed(*self.printed[page.name][page.part])

    def _below(self, kind, part):
        """Return the PDF of a part of the open page, and whether it begins below that of another page."""
        begin = self.begin.get(part, 0)
        pdf = self._part(kind, begin)
        printed = Printed(pdf)
        sheet, top = printed.positions[END]
        end = HEIGHT - top / 72 - MARGINS["marginTop"]
        has_room = sheet == printed.length - 1 and end < LOWEST_BEGIN
        self.begin[part] = end + SPACE if has_room else 0
        return pdf, begin > 0

    def _part(self, kind, begin):
        """Return the PDF of a part of the open page, from a height on."""
        self.driver.execute_script(
            """
            const [kind, css, begin, column] = arguments, article = document.querySelector('article');
            document.documentElement.dataset.part = kind;
            const style = new CSSStyleSheet();
            style.replaceSync(css);
            document.adoptedStyleSheets = [style];
            article.querySelector('.space-above')?.remove();
            if (begin) article.insertAdjacentHTML('afterbegin',
                `<div class=space-above style="height: ${begin}px"></div>`);
            // what is too wide for a column stands across both; a picture and a formula may be made smaller
            const boxes = '.cell_output, figure, div.math, .pst-scrollable-table-container';
            article.classList.add('measured');
            for (const [kind, shrinks] of [['table', 1], ['div.math svg', 1.2], ['.output :is(img, svg)', 1.7]])
                for (const node of article.querySelectorAll(kind))
                    if (node.getBoundingClientRect().width > shrinks*column)
                        (node.closest(boxes) ?? node).classList.add('across');
            article.classList.remove('measured');""",
            kind,
            f"{PAGE_STYLE} article :is({HIDDEN[kind]}) {{ display: none !important }}",
            begin * 96 / SCALE,
            TEXT_WIDTH / 2 - 14,
        )
        return self._pdf(MARGINS | {"scale": SCALE})

    def typeset(self, body):
        """Return the PDF of a body of HTML that has its own sheets."""
        with tempfile.TemporaryDirectory() as folder:
            fonts = "".join(FONTS).replace("url(", f"url({(SITE / '_static').as_uri()}/")
            file = Path(folder, "sheets.html")
            file.write_text(
                f"<!doctype html><meta charset=utf-8><style>{fonts}{STYLE}</style>{body}", "utf-8"
            )
            self.driver.get(file.as_uri())
            self.driver.execute_async_script("document.fonts.ready.then(arguments[0])")
            return Printed(self._pdf({"preferCSSPageSize": True}))

    def _pdf(self, options):
        size = {"paperWidth": WIDTH, "paperHeight": HEIGHT, "printBackground": True}
        result = self.driver.execute_cdp_cmd("Page.printToPDF", size | options)
        return base64.b64decode(result["data"])


@contextmanager
def printer():
    """Start Chromium, and end it after the last page."""
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    names = ["chromium", "chromium-browser", "google-chrome"]
    chromium = next(filter(None, map(shutil.which, names)), None)
    if chromium is None or shutil.which("chromedriver") is None:
        sys.exit("The PDF is printed by Chromium: install chromium and chromedriver.")
    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    for argument in ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"]:
        options.add_argument(argument)
    options.add_argument("--host-resolver-rules=MAP * ~NOTFOUND")
    driver = webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))
    driver.set_script_timeout(180)
    try:
        yield Printer(driver)
    finally:
        driver.quit()


def anchors_of(pages):
    """Return for each page the anchors in it to which pages of the book link."""
    anchors = {page.name: set() for page in pages}
    for page in pages:
        source = (SITE / f"{page.name}.html").read_text("utf-8")
        for href in set(re.findall(r'href="([^"]*#[^"]+)"', source)):
            name, anchor = _target(page.address, html.unescape(href))
            if name in anchors and anchor:
                anchors[name].add(anchor)
    return anchors


def _target(base, href):
    """Return the page and the anchor to which a link leads, or None for what is not a page of the site."""
    address, anchor = urldefrag(urljoin(base, href))
    path = Path(unquote(urlsplit(address).path))
    if not address.startswith("file:") or not path.is_relative_to(SITE) or path.suffix != ".html":
        return None, ""
    return str(path.relative_to(SITE).with_suffix("")), unquote(anchor)


class Document:
    """Printed pages, joined in their order."""

    def __init__(self):
        self.writer = PdfWriter()
        self.positions = {}  # (page, anchor) -> number of the sheet and the height on it
        self.heads = []  # the running heads of the sheets: left, right
        self.links = []  # of each sheet the pages to which its links belong

    def append(self, page, printed, chapter):
        """Append a page under its chapter's running head; a sheet that it shares keeps the one it has."""
        shared, count = int(printed.runs_on), printed.length
        first = len(self.writer.pages) - shared
        sheet, top = printed.first
        self.positions[page.name, page.part] = first + sheet, top
        for anchor, (sheet, top) in printed.positions.items():
            self.positions.setdefault((page.name, anchor), (first + min(sheet, count - 1), top))
        if shared:
            self.writer.pages[first].merge_page(printed.sheets.pages[0])
        self.writer.append(printed.sheets, pages=(shared, count), import_outline=False)
        title = f"Solution of {page.title}" if page.part else page.title
        self.heads += [(chapter, title if title != chapter else "")] * (count - shared)
        self.links += [[] for _ in range(count - shared)]
        for sheet, pages in zip(list(self.writer.pages)[first:], self.links[first:], strict=True):
            pages += [page] * (len(sheet.get("/Annots", [])) - len(pages))

    def bookmark(self, pages):
        """Make the titles of the pages bookmarks, each under the last one of a lower level."""
        parents = {-1: None}
        for page in pages:
            sheet, top = self.positions[page.name, page.part]
            parents[page.level] = self.writer.add_outline_item(
                title=page.title,
                page_number=sheet,
                parent=parents[page.level - 1],
                fit=Fit.xyz(top=top) if top else Fit.fit(),
            )

    def connect(self):
        """Let every link to a page of the document lead to its sheet; links to other pages end."""
        for sheet, pages in zip(self.writer.pages, self.links, strict=True):
            annotations = [a.get_object() for a in sheet.get("/Annots", [])]
            sheet[NameObject("/Annots")] = ArrayObject(
                self.writer._add_object(annotation)
                for annotation, page in zip(annotations, pages, strict=True)
                if self._connect(annotation, page)
            )

    def _connect(self, link, page):
        """Set where a link leads; return whether it leads anywhere."""
        if "/A" in link and "/URI" in link["/A"]:
            address = link["/A"]["/URI"]
            name, anchor = _target(page.address, address)
            if name is None:
                return not address.startswith("file:")
        elif "/Dest" in link:
            name, anchor = page.name, str(link["/Dest"]).lstrip("/")
        else:
            return True
        position = self.positions.get((name, anchor)) or self.positions.get((name, ""))
        if position is None:
            return False
        number, top = position
        height = NullObject() if top is None else FloatObject(top)
        link.pop("/A", None)
        sheet, unchanged = self.writer.pages[number].indirect_reference, NullObject()
        link[NameObject("/Dest")] = ArrayObject(
            [sheet, NameObject("/XYZ"), unchanged, height, unchanged]
        )
        return True

    def number(self, printer):
        """Print its running head and number on every sheet but the first."""
        sheets = "".join(
            f"<div class=sheet><div class=head><span>{html.escape(left)}</span><span>{html.escape(right)}</span></div>"
            f"<div class=foot>{number}</div></div>"
            for number, (left, right) in enumerate(self.heads[1:], 2)
        )
        overlay = printer.typeset(sheets)
        for sheet, head in zip(list(self.writer.pages)[1:], overlay.sheets.pages, strict=True):
            sheet.merge_page(head)
            sheet.compress_content_streams()

    def write(self, path, title):
        """Write the document with its title."""
        self.writer.add_metadata({"/Title": title})
        self.writer.page_mode = "/UseOutlines"
        self.writer.compress_identical_objects(remove_duplicates=True, remove_unreferenced=True)
        self.writer.write(path)


def contents(title, pages, sheets):
    """Return the HTML of a contents page; `sheets` maps pages to the numbers of their first sheets."""
    rows = "".join(
        f"<a class={'section' if page.level else 'chapter'} href='{page.address}'>"
        f"<span>{html.escape(page.title)}</span><i></i><span>{sheets[page]}</span></a>"
        for page in pages
    )
    return f"<div class=contents><h1>{html.escape(title)}</h1>{rows}</div>"


def appendix(group):
    """Return the appendix of a chapter: a contents page and the solutions; nothing without problems."""
    solutions = [replace(page, level=2, part=SOLUTION) for page in group if page.is_problem]
    return [Page(f"{group[0].name}-solutions", "Solutions", 1), *solutions] if solutions else []


def join(printer, title, groups, anchors, path):
    """Join groups of pages (chapters, back matter) to one document with contents."""
    front = Page("contents", "Contents", 0)
    chapter_of = {front: title}
    rows = {front: (title, [])}  # of each contents page its heading and the pages that it lists
    for group in groups:
        solutions = appendix(group)
        chapter_of |= dict.fromkeys([*group, *solutions], group[0].title)
        rows[front][1].extend([*group, *solutions[:1]])
        if solutions:
            rows[solutions[0]] = f"{group[0].title}: solutions", solutions[1:]

    def printed(page, sheets):
        if page in rows:
            heading, listed = rows[page]
            return printer.typeset(contents(heading, listed, sheets))
        return printer.print(page, anchors[page.name])

    # the numbers of sheets depend on the length of the contents, which does not depend on them:
    # they stand in a column of their own
    sheets, number = dict.fromkeys(chapter_of, ""), 1
    for page in chapter_of:
        draft = printed(page, dict.fromkeys(chapter_of, ""))
        sheets[page] = number - draft.runs_on + draft.first[0]
        number += draft.length - draft.runs_on
    document = Document()
    for page, chapter in chapter_of.items():
        document.append(page, printed(page, sheets), chapter)
    document.bookmark(chapter_of)
    document.connect()
    document.number(printer)
    document.write(path, title)
    print(f"{path.name}: {len(document.heads)} sheets, {path.stat().st_size / 1e6:.1f} MB")


def main(numbers, output=OUTPUT):
    """Write the chapters with these numbers, or without any number all chapters and the book."""
    if not (SITE / "book" / "index.html").exists():
        sys.exit("There is no site yet: run make book first.")
    by_number = chapters()
    if unknown := set(numbers) - set(by_number):
        unknown = ", ".join(sorted(unknown))
        sys.exit(f"There is no chapter {unknown}; there are {', '.join(by_number)}.")
    back_matter = [Page(name, title_of(name), 0) for name in BACK_MATTER]
    anchors = anchors_of([page for group in by_number.values() for page in group] + back_matter)
    output.mkdir(parents=True, exist_ok=True)
    with printer() as chromium:
        for number in numbers or by_number:
            pages = by_number[number]
            join(chromium, pages[0].title, [pages], anchors, output / f"chapter-{number}.pdf")
        if not numbers:
            groups = [*by_number.values(), *([page] for page in back_matter)]
            join(chromium, "Controlled Motion", groups, anchors, output / "controlled-motion.pdf")


if __name__ == "__main__":
    main(sys.argv[1:])

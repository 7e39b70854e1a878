"""The search: its entries, their order for common queries, and the dialog."""

import hashlib
import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from selenium.webdriver.common.keys import Keys

ROOT = Path(__file__).resolve().parents[2]
CONFIGURATION = f"""
import sys
sys.path.insert(0, {str(ROOT / "book" / "_ext")!r})
extensions = ["sphinx_exercise", "sphinx_proof"]
proof_title_format = " %t"

def setup(app):
    from workbook_site import numbering, search_index
    numbering.setup(app)
    search_index.setup(app)
    app.connect("builder-inited", lambda app: setattr(app.env, "workbook_catalogue", {{}}))
"""
PAGES = {
    "index": "Start\n=====\n\n.. toctree::\n\n   one\n   two\n",
    "one": """\
One
===

.. prf:theorem:: 1.2 (Hurwitz criterion)
   :label: thm-1-2

   All roots of

   .. math:: x^2 + a_1 x + a_2 = 0
      :label: eq-1-6

   lie to the left.

.. exercise:: Swing
   :label: swing

   A pendulum swings.

.. solution:: swing

   It comes to rest.
""",
    "two": """\
Two
===

.. _sec-2-part:

Part :math:`n`
--------------

A sentence with :math:`a < b`.

.. code-block:: python

   x = 1
""",
}


@pytest.fixture
def entries_of(tmp_path):
    """Return a function that builds a small book and returns its entries by their addresses."""
    (tmp_path / "conf.py").write_text(CONFIGURATION, encoding="utf-8")
    for name, text in PAGES.items():
        (tmp_path / f"{name}.rst").write_text(text, encoding="utf-8")

    def build():
        process = subprocess.run(
            [sys.executable, "-m", "sphinx", "-q", "-W", tmp_path, tmp_path / "_build"],
            capture_output=True,
            text=True,
            timeout=120,
        )
        assert process.returncode == 0, process.stderr
        text = (tmp_path / "_build" / "search-entries.js").read_text(encoding="utf-8")
        listed = json.loads(text.removeprefix("globalThis.searchEntries = ").removesuffix(";\n"))
        return {entry["url"]: entry for entry in listed}

    return build


def test_entries_of_a_small_book(entries_of, tmp_path):
    entries = entries_of()
    theorem = entries["one.html#thm-1-2"]
    assert (theorem["kind"], theorem["number"]) == ("Theorem", "1.2")
    assert theorem["title"] == "Theorem 1.2 (Hurwitz criterion)"
    assert theorem["text"] == r"All roots of \(x^2 + a_1 x + a_2 = 0\) lie to the left."
    assert "Hurwitz criterion" in entries["one.html#one"]["terms"]
    equation = entries["one.html#equation-eq-1-6"]
    assert (equation["kind"], equation["title"], equation["place"]) == ("Equation", "(1.6)", "One")
    assert equation["text"].startswith("All roots of")
    section = entries["two.html#sec-2-part"]
    assert (section["title"], section["text"]) == (r"Part \(n\)", r"A sentence with \(a < b\).")
    # the statement of the exercise is searched, its solution is not
    assert "pendulum" in entries["one.html#one"]["text"]
    assert "rest" not in json.dumps(entries)
    # each address exists, and nothing of Sphinx's search is built
    for url in entries:
        page, anchor = url.split("#")
        assert f'id="{anchor}"' in (tmp_path / "_build" / page).read_text(encoding="utf-8")
    built = {path.name for path in (tmp_path / "_build").rglob("*")}
    assert not built & {"search.html", "searchindex.js", "searchtools.js", "language_data.js"}


def test_entries_of_unchanged_pages_are_kept(entries_of, tmp_path):
    first = entries_of()
    with open(tmp_path / "two.rst", "a", encoding="utf-8") as file:
        file.write("\nMore.\n")
    second = entries_of()
    assert second.pop("two.html#sec-2-part")["text"].endswith("More.")
    first.pop("two.html#sec-2-part")
    assert second == first


def test_the_vendored_script_is_the_one_described():
    folder = ROOT / "book" / "_static" / "minisearch"
    script = (folder / "minisearch.js").read_bytes()
    assert hashlib.sha256(script).hexdigest() in (folder / "README.txt").read_text(encoding="utf-8")
    assert (folder / "LICENSE").exists()


#: Query: the address of the best hit, without the folder of the edition.
FIRST = {
    "Theorem 1.2": "book/ch1/hurwitz.html#thm-1-2",
    "theorem 4.3": "book/ch4/continuous_filter.html#thm-4-3",
    "Definition 1.5": "book/ch1/hurwitz.html#def-1-5",
    "(1.6)": "book/ch1/hurwitz.html#eq-1-6",
    "1.15": "ch1/p15.html#problem-1.15",
    "1.3": "ch1/p03.html#problem-1.3",
    "Problem 5.66": "ch5/p66.html#problem-5.66",
    "theorem 1.2": "book/ch1/hurwitz.html#thm-1-2",
    "теорема 1.2": "book/ch1/hurwitz.html#thm-1-2",
    "def. 2.1": "book/ch2/observability.html#def-2-1",
    "eq. (3.7)": "book/ch3/output_feedback.html#eq-3-7",
    "§3.2": "book/ch3/state_feedback.html#sec-3-feedback",
    "section 2.5": "book/ch2/observability.html#sec-2-observability",
    "chapter 5": "book/ch5.html#optimal-control-of-motion",
    "глава 5": "book/ch5.html#optimal-control-of-motion",
    "5.26": "ch5/p26.html#problem-5.26",
    "задача 5.26": "ch5/p26.html#problem-5.26",
    "how to install": "book/guides/install.html#install",
    "switching curve": "book/ch5/synthesis.html#def-dispersal",
    "place": "book/library/feedback.html#library-feedback-place",
    "Routh": "book/ch1/hurwitz.html#sec-1-hurwitz",
    "Luenberger observer": "book/ch3/observers.html#sec-3-observer",
    "устойчивость по Ляпунову": "book/ch1/linear_stability.html#sec-1-stability",
    "hurwitz_minors": "book/library/stability.html#library-stability-hurwitz_minors",
}
#: Query: the best hit, a section found by a further name of book/search_names.toml.
NAMED = {
    "kalman decomposition": "book/ch2/decomposition.html",
    "INS": "book/ch4/inertial_navigation.html",
    "gyro drift": "book/ch4/inertial_navigation.html",
    "reachable set": "book/ch5/least_time.html|book/ch9/enclosing_step.html#sec-9-dubins",
    "steady state kalman": "book/ch4/continuous_filter.html",
    "transfer function": "book/ch2/decomposition.html",
    "psi": "book/ch5/maximum_principle.html",
    "ψ": "book/ch5/maximum_principle.html",
    "lambda": "book/ch1/linear_stability.html",
    "λ": "book/ch1/linear_stability.html",
    "Nyquist": "book/ch3/margins.html",
    "задача Годдарда": "book/ch5/goddard.html|ch5/p51.html",
    "брахистохрона": "book/ch5/goddard.html|ch5/p3[78].html",
}
#: Query in Russian: a problem among the first hits.
RUSSIAN = {
    "маятник": "ch1/p02|ch2/p36|ch3/p03",
    "спутник": "ch1/p05|ch2/p13|ch2/p31",
    "двойной интегратор": "ch5/p03",
    "регулятор": "ch5/p6[3-8]|ch3/p24",
    "перевёрнутый маятник": "ch2/p35|ch2/p36|ch3/p05",
}
#: Query: what the course does not have.
ABSENT = {
    "PID": "PID control",
    "PID controller": "PID control",
    "MPC": "Model predictive control",
    "ПИД-регулятор": "PID control",
}
#: Query: a page with the section that states it.
STATED = {
    "Hurwitz criterion": "book/ch1/hurwitz.html",
    "Kalman filter": "book/ch4/(continuous|discrete)_filter.html",
    "Riccati": "book/(ch4/continuous_filter|ch5/stabilisation).html",
    "LQR": "book/ch5/stabilisation.html",
    "pole placement": "book/ch3/state_feedback.html",
    "фильтр Калмана": "book/ch4/(continuous|discrete)_filter.html",
    "критерия Гурвица": "book/ch1/hurwitz.html",
    "maximum principle": "book/ch5/maximum_principle.html",
    "linearization": "book/ch1/",
    "the Kalman filter": "book/ch4/(continuous|discrete)_filter.html",
    "Kalman-Bucy": "book/ch4/continuous_filter.html",
    "Rikkati": "book/(ch4/continuous_filter|ch5/stabilisation).html",
    "bang-bang": "book/ch5/maximum_principle.html",
    "minimum time": "book/ch5/maximum_principle.html",
    "transversality": "book/ch5/maximum_principle.html",
    "observer": "book/ch3/observers.html",
    "separation principle": "book/ch3/output_feedback.html",
    "Euler-Lagrange": "book/ch5/least_energy.html",
}
#: Query: a problem that is among the first hits, by its topic.
TOPICS = {
    "van der Pol": "ch1/p04",
    "Duffing": "ch1/p03",
    "Riccati": "ch4/p42",
    "Clohessy": "ch2/p14",
    "Zhukovsky": "ch1/p09",
    "Schuler": "ch7/p01",
}


@pytest.fixture(scope="module", params=["http", "student"])
def hits_of(request, browser, addresses):
    """Return the search of an edition: query -> pairs (kind, address below the site)."""
    root = addresses[request.param]
    browser.open(f"{root}/book/index.html")
    browser.find(".bd-sidebar-primary .search-button-field").click()
    assert browser.wait_for("bookSearch.search !== undefined", 60)

    def hits(query):
        return [
            (kind, url)
            for kind, url in browser.run(
                f"bookSearch.search({json.dumps(query)}).map(({{kind, url}}) => [kind, url])"
            )
        ]

    return hits


@pytest.mark.parametrize("query, address", FIRST.items())
def test_a_number_or_a_name_leads_to_it(hits_of, query, address):
    assert hits_of(query)[0][1].endswith(address)


@pytest.mark.parametrize("query, page", STATED.items())
def test_a_term_leads_to_the_section_that_states_it_then_to_problems(hits_of, query, page):
    hits = hits_of(query)
    kind, address = hits[0]
    assert kind == "Section" and re.match(page, address)
    assert "Problem" in [kind for kind, _ in hits[:10]]


@pytest.mark.parametrize("query, page", NAMED.items())
def test_a_further_name_leads_to_the_section(hits_of, query, page):
    assert re.search(page, hits_of(query)[0][1])


@pytest.mark.parametrize("query, page", RUSSIAN.items())
def test_a_russian_title_leads_to_problems(hits_of, query, page):
    found = [address for kind, address in hits_of(query)[:10] if kind == "Problem"]
    assert any(re.search(page, address) for address in found), found


@pytest.mark.parametrize("query, title", ABSENT.items())
def test_what_the_course_does_not_have_is_said(dialog, browser, query, title):
    dialog(query)
    first = browser.find("#search-hits li").text
    assert re.match(
        f"Not in the course\n{title}\n(Nearest is: .+|The course has nothing on it)\\.", first
    )


def test_every_problem_and_section_has_a_russian_name(editions):
    names = tomllib.loads((ROOT / "book" / "search_names.toml").read_text(encoding="utf-8"))
    problems = {
        f"{path.parent.name[2:]}.{int(path.stem[1:])}"
        for path in (ROOT / "solutions").glob("ch*/p??.md")
    }
    assert names["problems"].keys() == problems
    script = (editions.full / "search-entries.js").read_text(encoding="utf-8")
    listed = json.loads(script.removeprefix("globalThis.searchEntries = ").removesuffix(";\n"))
    sections = {}
    for entry in listed:
        page = entry["url"].partition("#")[0]
        if re.fullmatch(r"book/ch\d/\w+\.html", page):
            sections.setdefault(page, []).extend(entry.get("names", ()))
    without = [page for page, found in sections.items() if not re.search("[а-я]", " ".join(found))]
    assert len(sections) > 50 and not without
    labels = set(names["places"]) | {topic["nearest"] for topic in names["absent"]}
    text = "".join(p.read_text(encoding="utf-8") for p in (ROOT / "book").glob("ch*/*.md"))
    assert not [label for label in labels if f"({label})=" not in text]


def test_a_word_that_the_book_does_not_have(dialog, browser):
    dialog("deadbeat observer")
    assert browser.find("#search-status").text.startswith("No place has all these words; ")


@pytest.mark.parametrize("query, page", TOPICS.items())
def test_a_name_leads_to_the_problems_on_it(hits_of, query, page):
    assert any(f"{page}.html#" in address for _, address in hits_of(query)[:10])


def test_every_hit_has_its_anchor(editions):
    """Every address of the index is an id of a page."""
    for root in (editions.full, editions.student):
        text = (root / "search-entries.js").read_text(encoding="utf-8")
        anchors = {}
        for page, anchor in re.findall(r'"url": "([^"#]+)#([^"]+)"', text):
            anchors.setdefault(page, set()).add(anchor)
        assert len(anchors) > 200
        missing = {
            page: names
            for page, expected in anchors.items()
            if (
                names := expected
                - set(re.findall(r'\bid="([^"]+)"', (root / page).read_text(encoding="utf-8")))
            )
        }
        assert not missing


@pytest.fixture
def dialog(browser, addresses, search_for):
    """Return a function that opens the search on a page and types a query."""

    def search(query, scheme="http", size=(1400, 900, False)):
        browser.resize(*size)
        browser.open(f"{addresses[scheme]}/book/ch1/hurwitz.html")
        search_for(query)

    yield search
    browser.resize(1280, 900)


def press(browser, *keys):
    browser.driver.switch_to.active_element.send_keys(*keys)


FOCUSED = "[...document.querySelectorAll('#search-hits a')].indexOf(document.activeElement)"


@pytest.mark.parametrize("scheme", ["file", "http"])
def test_the_dialog_by_keyboard(browser, dialog, scheme):
    dialog("Theorem 1.2", scheme)
    press(browser, Keys.ARROW_DOWN)
    assert browser.run(FOCUSED) == 0
    press(browser, Keys.ARROW_DOWN)
    assert browser.run(FOCUSED) == 1
    press(browser, Keys.ARROW_UP)
    press(browser, Keys.ARROW_UP)
    assert browser.run("document.activeElement.matches('#pst-search-dialog input')")
    press(browser, Keys.ENTER)  # the best hit
    assert browser.wait_for("location.hash === '#thm-1-2'")
    assert not browser.run("document.querySelector('#pst-search-dialog').open")
    press(browser, Keys.CONTROL, "k")
    assert browser.run("document.querySelector('#pst-search-dialog').open")
    press(browser, Keys.ESCAPE)
    assert not browser.run("document.querySelector('#pst-search-dialog').open")
    assert browser.errors() == [] and browser.foreign_requests() == []


@pytest.mark.parametrize("size", [(1400, 900, False), (390, 844, True)], ids=["desktop", "phone"])
def test_only_the_hits_scroll(browser, dialog, size):
    dialog("criterion", size=size)
    scrolling = browser.run("""[...document.querySelectorAll('html, body, #pst-search-dialog, #pst-search-dialog *')]
        .filter(box => box.scrollHeight > box.clientHeight + 1
            && /auto|scroll/.test(getComputedStyle(box).overflowY)).map(box => box.id || box.tagName)""")
    assert [name for name in scrolling if name not in ("HTML", "BODY")] == ["search-hits"]
    assert browser.run("getComputedStyle(document.documentElement).overflowY") == "hidden"
    box = browser.run(
        "document.querySelector('#pst-search-dialog').getBoundingClientRect().toJSON()"
    )
    assert box["left"] >= 0 and box["right"] <= size[0] and box["bottom"] <= size[1]


def test_nothing_is_loaded_before_the_reader_searches(browser, addresses):
    browser.open(f"{addresses['http']}/book/ch1/hurwitz.html")
    loaded = """performance.getEntriesByType('resource').map(entry => entry.name)
        .filter(name => /search-entries|minisearch/.test(name))"""
    assert browser.run(loaded) == []
    browser.find(".bd-sidebar-primary .search-button-field").click()
    assert browser.wait_for(f"{loaded}.length === 2")


def test_formulas_and_words_of_the_query_are_shown(browser, dialog):
    dialog("Hurwitz matrix")
    assert browser.wait_for("document.querySelector('#search-hits mjx-container svg')")
    assert "Hurwitz" in browser.run(
        "[...document.querySelectorAll('#search-hits mark')].map(mark => mark.textContent)"
    )
    assert "places" in browser.find("#search-status").text

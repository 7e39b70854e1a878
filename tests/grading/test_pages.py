"""The pages for students and lecturers: their content, their limits, and their layout."""

import json
import os
import re
import shutil
import sys
import time
from html import unescape
from pathlib import Path
from xml.etree import ElementTree

import pytest
import sympy as sp

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment, graded

from trajlib.typesetting import plain
from workbook.authoring import read_all, read_master
from workbook.authoring.mistakes import mistake_sentence
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import describe, encode
from workbook.checks.contract.verdict import INVALID, MISSING, RIGHT, UNCHECKED, WRONG, Verdict
from workbook.grading import commands
from workbook.grading.course import assignment as assignments
from workbook.grading.course.store import Attempt, HandPoints
from workbook.grading.pool import judging
from workbook.grading.pool.grader import from_plain, to_plain
from workbook.grading.pool.judging import Judgement
from workbook.grading.reports import points_by_hand
from workbook.grading.reports.feedback import feedback
from workbook.grading.reports.mathml import with_formulas
from workbook.grading.reports.scores import of_student, scores
from workbook.grading.reports.summary import summary
from workbook.grading.sandbox.limits import Outcome
from workbook.notebooks import exercises
from workbook.notebooks.execution import judge, run_notebook
from workbook.numbering import read_number

ROOT = Path(__file__).resolve().parents[2]
HOMEWORK = 'title = "Homework <1>"\nproblems = ["1.15", "1.17"]\ndue = 2026-10-01T12:00:00Z\n'
DUE = 1790856000.0
K1, K2 = sp.symbols("k1 k2")
#: What a name or an answer may try in a page.
HOSTILE = "</title><script>alert(1)</script><img src=x onerror=alert(2)>\"'&"
FIVE = {
    "a_region": RIGHT,
    "b_region": WRONG,
    "c_region": MISSING,
    "d_region": INVALID,
    "e_region": UNCHECKED,
}


def shown(page):
    """Return the text of a page with everything unfolded, and formulas in plain characters."""
    page = re.sub(r'(?s)<math alttext="([^"]*)">.*?</math>', r"\1", page)
    return unescape(re.sub(r"<[^>]+>", " ", re.sub(r"(?s)<style>.*?</style>", "", page)))


def section(page, answer):
    return re.search(
        rf'(?s)<section class="answer \w+"><header><span><code>{answer}</code>.*?</section>', page
    )[0]


# Feedback


def test_feedback_has_all_verdicts(store, homework):
    graded(
        store,
        "ann",
        "1.15",
        FIVE,
        texts={"a_region": "k1 > 0", "b_region": "k2 < 0", "e_region": "odd"},
    )
    store.set_points({("ann", "hw1", "1.15", "b_region"): HandPoints(0.5, "the right <idea>")})
    page = feedback(homework, scores(store, homework)[0])
    assert "1.5 of 7 points, and 1 answer still to be looked at by a lecturer." in shown(page)
    for name, status in FIVE.items():
        text_shown = re.sub(r"\s+", " ", shown(section(page, name))).replace(
            f"{status} :", f"{status}:"
        )
        assert f"{status}: {name} is {status}" in text_shown
    assert "Your answer: k1 > 0" in re.sub(
        r"\s+", " ", shown(section(page, "a_region"))
    ) and "1 / 1" in section(page, "a_region")
    assert "Points given by your lecturer: the right &lt;idea&gt;" in section(
        page, "b_region"
    ) and "0.5 / 1" in section(page, "b_region")
    assert "Nothing was submitted for this problem." in page.split("1.17")[1]


def test_hints_are_those_of_the_notebook_and_folded(store, homework):
    hints = exercises.find("1.15").about["hints"]["a_region"]
    assert len(hints) == 2
    graded(store, "ann", "1.15", FIVE | {"a_region": WRONG})
    page = section(feedback(homework, scores(store, homework)[0]), "a_region")
    notebook = exercises.find("1.15").path.read_text(encoding="utf-8")
    for number, hint in enumerate(hints, start=1):
        assert (
            f"<details><summary>Hint {number}</summary>" in page
            and hint in shown(page)
            and hint in notebook
        )
    graded(store, "bob", "1.15", FIVE)
    assert not any(
        hint in shown(feedback(homework, scores(store, homework)[1])) for hint in hints
    ), "what is right needs no hint"
    assert "<details>" not in feedback(homework, of_student("dan", homework, [], {}))


def test_every_formula_of_a_page_is_typeset():
    in_tex = []
    for exercise in exercises.read_all():
        verdicts = dict.fromkeys(exercise.about["answers"], Verdict(MISSING, ""))
        page = page_of(exercise.number, verdicts)
        for formula in re.findall(r"<math.*?</math>", page):
            ElementTree.fromstring(formula)  # well-formed
        visible = re.sub(r"<[^>]+>", " ", page)
        in_tex += [(exercise.number, tex) for tex in re.findall(r"[$\\].{,40}", visible)]
    assert in_tex == []


def test_each_item_has_its_system(store, homework):
    page = page_of("2.3", {"b_unobservable_states": Verdict(WRONG, "it is not in the kernel")})
    for letter, end in zip("abcdefghi", "bcdefghi."):
        assert page.count(f"<p>{letter}) ") == 1, end
        assert page.index(f"<p>{letter}) ") < page.index(f"<code>{letter}_")
    text = re.sub(r"\s+", " ", shown(section(page, "b_unobservable_states")))
    assert "the same basis for system b ( a_unobservable_states : " in text
    assert (
        "$" not in with_formulas("$x$ and $\\dot x_1$") and with_formulas("$\\foo<$") == "foo&lt;"
    )


def test_feedback_links_to_the_theory_and_never_to_a_solution(store, homework):
    graded(store, "ann", "1.15", FIVE)
    (score,) = scores(store, homework)
    page = feedback(homework, score, 'https://example.org/course/"x/')
    assert (
        'href="https://example.org/course/&quot;x/book/ch1.html"' in page
        and "/exercises/ch1/p15.html" in page
    )
    assert "solutions" not in page
    assert "href" not in feedback(homework, score) and "chapter 1 of the workbook" in feedback(
        homework, score
    )


def test_feedback_has_lateness_and_number_of_attempts(store, homework):
    graded(store, "ann", "1.15", FIVE, submitted=DUE + 1)
    assert "Handed in after the due date." in shown(feedback(homework, scores(store, homework)[0]))
    graded(store, "ann", "1.15", FIVE, submitted=DUE - 1)
    page = shown(feedback(homework, scores(store, homework)[0]))
    assert (
        "after the due date" not in page
        and "You handed this in 2 times; what follows is the attempt that counts." in page
    )


def test_remarks_name_whose_fault_it_was(store, homework):
    attempt = store.note_attempt("ann", "hw1", "1.17", "x", 0.0)
    remark = "limits: the notebook was still running when its time was up"
    store.record(
        attempt,
        "e",
        Judgement({"a_region": Verdict(MISSING, "no answer: its time was up")}, {}, [remark]),
    )
    assert "limits: the notebook was still running" in shown(
        feedback(homework, scores(store, homework)[0])
    )


def test_foreign_text_is_escaped(store, homework):
    for name in (HOSTILE, HOSTILE + "2"):
        attempt = store.note_attempt(name, "hw1", "1.17", name, DUE + 9)
        store.record(
            attempt,
            "e",
            Judgement(
                {"a_region": Verdict(WRONG, HOSTILE), "b_region": Verdict(UNCHECKED, HOSTILE)},
                {"a_region": HOSTILE, "b_region": HOSTILE},
                [HOSTILE],
            ),
        )
    store.set_points({(HOSTILE, "hw1", "1.15", "a_region"): HandPoints(1.0, HOSTILE)})
    class_scores = scores(store, homework)
    for page in (
        *(feedback(homework, score, HOSTILE) for score in class_scores),
        summary(homework, class_scores),
    ):
        assert "<script" not in page and "<img" not in page and "Homework &lt;1&gt;" in page
        assert set(re.findall(r"</?([a-z0-9]+)[ >]", page)) <= ALLOWED
        assert 'http-equiv="Content-Security-Policy" content="default-src \'none\'' in page


ALLOWED = {
    "html",
    "head",
    "meta",
    "title",
    "style",
    "body",
    "h1",
    "h2",
    "p",
    "br",
    "span",
    "div",
    "section",
    "header",
    "code",
    "em",
    "ul",
    "li",
    "a",
    "bdi",
    "details",
    "summary",
    "table",
    "tr",
    "th",
    "td",
    "svg",
    "rect",
    "text",
    "line",
    *("math", "mrow", "mi", "mn", "mo", "msub", "msup", "msubsup", "mfrac", "msqrt", "mover"),
    *("mspace", "mtable", "mtr", "mtd"),
}


# Never the solution


def give_away(page, master):
    """Return the lines of the master's answer cells on a page that the student's notebook lacks."""
    own = {
        line.strip()
        for _, source in exercises.find(master.number).cells
        for line in source.split("\n")
    }
    lines = {line.strip() for source in master.code("answer") for line in source.split("\n")} - own
    text = re.sub(r"\s+", " ", shown(page))
    return [line for line in lines if len(line) > 7 and re.sub(r"\s+", " ", line) in text]


def page_of(number, verdicts, texts=None):
    """Return the page of a student with these verdicts."""
    homework = assignments.of_problems("hw1", [number])
    attempts = [Attempt(0, "ann", "hw1", number, "", 0.0, "e", verdicts, texts or {}, ())]
    return feedback(homework, of_student("ann", homework, attempts, {}))


def test_no_line_of_a_solution_is_on_a_page_with_all_hints():
    given_away = []
    for master in read_all(ROOT / "solutions"):
        verdicts = dict.fromkeys(master.answers, Verdict(MISSING, "not answered yet"))
        page = page_of(master.number, verdicts)
        hints = exercises.find(master.number).about["hints"].values()
        text = shown(page)
        assert all(plain(hint) in text for hint in sum(hints, [])), master.number
        given_away += [(master.number, line) for line in give_away(page, master)]
        assert give_away(page + "\n".join(master.code("answer")), master), (
            f"the solution of {master.number} is not seen where it is"
        )
    assert given_away == []


def at_the_ends():
    """Return the first and the last problem of each chapter."""
    chapters = {}
    for exercise in exercises.read_all():
        chapters.setdefault(exercise.number.split(".")[0], []).append(exercise.number)
    return sorted({number for numbers in chapters.values() for number in (numbers[0], numbers[-1])})


@pytest.mark.parametrize("number", at_the_ends())
def test_messages_on_wrong_answers_give_nothing_away(number):
    master, exercise = (
        read_master(ROOT / "solutions" / read_number(number).file(".md")),
        exercises.find(number),
    )
    reference = run_notebook(master.code("data", "answer"), master.answers)
    wrong = [trial.source for trial in master.trials["wrong"]]
    run = run_notebook([*master.code("data", "answer"), *wrong], master.answers)
    verdicts = judge(exercise.code("data", "check"), run, master.answers)
    assert WRONG in {verdict.status for verdict in verdicts.values()}
    page = page_of(
        number, verdicts, {name: describe(decode(data)) for name, data in run.encoded.items()}
    )
    assert give_away(page, master) == []
    answers = {
        name: describe(decode(data))
        for name, data in reference.encoded.items()
        if verdicts[name].status == WRONG
    }
    texts = [describe(decode(data)) for data in run.encoded.values()]
    assert [
        text
        for text in answers.values()
        if len(text) > 7 and text in shown(page) and not any(text in other for other in texts)
    ] == []


# The lecturer's summary


def test_summary(store, homework):
    failure = {"a_region": Verdict(WRONG, "at k1 = -0.5 a root has the real part 1.2e-05")}
    for k, student in enumerate(["ann", "bob", "cid"]):
        graded(
            store,
            student,
            "1.15",
            FIVE,
            submitted=DUE + k,
            texts={"b_region": "k2 < 0", "e_region": f"odd {k}"},
        )
        attempt = store.note_attempt(student, "hw1", "1.17", student, DUE - 1)
        message = failure["a_region"].message.replace("0.5", f"{k}.25").replace("1.2e-05", f"{k}")
        store.record(
            attempt,
            "e",
            Judgement(
                {"a_region": Verdict(WRONG, message), "b_region": Verdict(RIGHT, "")},
                {"a_region": f"k1 > {k}"},
                (),
            ),
        )
    page = summary(homework, scores(store, homework, ["dan"]))
    text = re.sub(r"\s+", " ", shown(page))
    assert (
        "3 of 4 students handed something in; 2 were late; 3 need a lecturer’s look; the middle "
        "one has 2 of 7 "
        "points" in text
    )
    looked_at = page.split("To be looked at")[1].split("<h2>")[0]
    assert (
        looked_at.count("<code>e_region</code>") == 3
        and "odd 2" in looked_at
        and "workbook score STUDENT hw1" in looked_at
    )
    hardest = page.split("hardest first")[1].split("<h2>")[0]
    assert hardest.index("b_region") < hardest.index("a_region"), "the hardest stands first"
    assert "3 right" in hardest and 'style="flex: 3" title="3 wrong"' in hardest
    failures = page.split("Common failures")[1].split("<h2>")[0]
    assert len(re.findall('<td class="number">3</td>', failures)) == 4, (
        "messages that differ only in numbers are one failure"
    )
    identical = page.split("Identical wrong answers")[1]
    assert (
        "k2 &lt; 0" in identical
        and all(name in identical for name in ("ann", "bob", "cid"))
        and "k1 &gt; 1" not in identical
    )


def test_named_mistakes_are_on_both_pages(store, homework):
    for student, answers in {
        "ann": {"a_region": [K2 > 0, K1 > 0]},
        "bob": {"a_region": (K2 > 0) & (0 < K1)},
        "cid": {"a_region": K1 > 7},
        "dan": {"d_region": (K1 > 0) & (K2 > 1)},
    }.items():
        exercise = exercises.find("1.15")
        outcome = {
            "encoded": {name: encode(value).decode() for name, value in answers.items()},
            "unreadable": {},
            "errors": [],
            "stopped": [],
        }
        judged = judging.judge(exercise, Outcome("done", json.dumps(outcome).encode()))
        attempt = store.note_attempt(student, "hw1", "1.15", student, DUE - 1)
        store.record(
            attempt,
            "e",
            Judgement(
                from_plain(json.loads(json.dumps(to_plain(judged)))).verdicts, judged.answers, ()
            ),
        )
    master = read_master(ROOT / "solutions" / read_number("1.15").file(".md"))
    first_sentence, other_sentence = (
        mistake_sentence(master, master.trials["wrong"][k]) for k in (0, 5)
    )
    all_scores = scores(store, homework)
    pages = {score.student: shown(feedback(homework, score)) for score in all_scores}
    assert first_sentence.count("\n") == 1 and all(
        line in pages["ann"] and line in pages["bob"] for line in first_sentence.split("\n")
    )
    assert (
        first_sentence.split("\n")[0] not in pages["cid"] + pages["dan"]
        and other_sentence.split("\n")[0] in pages["dan"]
    )
    talk = (
        re.sub(r"\s+", " ", summary(homework, all_scores))
        .split("What to talk about")[1]
        .split("<h2>")[0]
    )
    (first, second) = re.findall(r"<tr><td.*?</tr>", talk)
    assert re.sub(r"\s+", " ", shown(first)).strip() == (
        f"2 1.15 a_region {first_sentence.partition(chr(10))[0]} ann , bob"
    )
    assert other_sentence.split("\n")[0] in shown(second) and "dan" in second


def test_answers_with_equal_short_texts_are_not_identical(store, homework):
    """A text is cut, and omits the middle of an array: only equal whole answers are identical."""
    for k, student in enumerate(["ann", "bob", "cid"]):
        attempt = store.note_attempt(student, "hw1", "1.15", student, DUE - 1)
        store.record(
            attempt,
            "e",
            Judgement(
                {"a_region": Verdict(WRONG, "no"), "b_region": Verdict(WRONG, "no")},
                {"a_region": "[[1, ..., 9]]", "b_region": "[[2, ..., 9]]"},
                (),
                hashes={"a_region": str(k), "b_region": str(k // 2)},
            ),
        )
    page = summary(homework, scores(store, homework))
    identical = page.split("Identical wrong answers")[1].split("<h2>")[0]
    assert (
        "[[1, ..., 9]]" not in identical
        and "[[2, ..., 9]]" in identical
        and "ann" in identical
        and "cid" not in identical
    )


def test_the_histogram_has_all_students(store, tmp_path):
    homework = an_assignment(tmp_path, 'problems = ["1.17"]')
    for k, (a, b) in enumerate([(RIGHT, RIGHT), (RIGHT, WRONG), (WRONG, RIGHT), (WRONG, WRONG)]):
        graded(store, f"s{k}", "1.17", {"a_region": a, "b_region": b})
    page = summary(homework, scores(store, homework, ["dan"]))
    assert 'aria-label="Number of students by points: 1 from 0, 2 from 1, 1 from 1.8"' in page
    assert re.findall(
        r'text-anchor="middle">(\d+)</text><rect|text-anchor="middle">(\d+)</text><line', page
    ) == [("1", ""), ("2", ""), ("", "1")]


def test_a_summary_without_students_or_points(store, tmp_path):
    homework = an_assignment(tmp_path, 'problems = ["1.17"]\n[points]\n"1.17" = 0')
    assert "0 of 1 student handed something in" in summary(
        homework, scores(store, homework, ["dan"])
    )
    graded(store, "ann", "1.17", {"a_region": RIGHT, "b_region": WRONG})
    assert "Nothing is worth a point." in summary(homework, scores(store, homework))


# In a browser


@pytest.fixture(scope="module")
def driver(tmp_path_factory):
    chromium, program = (
        shutil.which("chromium") or shutil.which("google-chrome"),
        shutil.which("chromedriver"),
    )
    if not (chromium and program):
        (pytest.fail if os.environ.get("CI") == "true" else pytest.skip)(
            "chromium and chromedriver are needed to look at pages"
        )
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    for argument in (
        "--headless=new",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-dev-shm-usage",
        "--no-first-run",
        f"--user-data-dir={tmp_path_factory.mktemp('profile')}",
        "--host-resolver-rules=MAP * ~NOTFOUND",
    ):
        options.add_argument(argument)
    driver = webdriver.Chrome(options=options, service=Service(program))
    yield driver
    driver.quit()


@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("theme, dark", [("light", False), ("dark", True)])
def test_pages_fit_and_are_readable(driver, store, homework, tmp_path, width, theme, dark):
    long = "(0 < k1) & (k1 < 1" + "0" * 280 + ")"
    for student in ("O'Neill, Zoë", "محمد", "x" * 200):
        graded(store, student, "1.15", FIVE, submitted=DUE + 1, texts=dict.fromkeys(FIVE, long))
    class_scores = scores(store, homework, ["dan"])
    named = {"summary": summary(homework, class_scores)}
    named |= {
        str(k): feedback(homework, score, "https://example.org")
        for k, score in enumerate(class_scores)
    }
    driver.execute_cdp_cmd(
        "Emulation.setDeviceMetricsOverride",
        {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 500},
    )
    driver.execute_cdp_cmd(
        "Emulation.setEmulatedMedia",
        {"features": [{"name": "prefers-color-scheme", "value": theme}]},
    )
    for name, page in named.items():
        path = tmp_path / f"{name}.html"
        path.write_text(page, encoding="utf-8")
        driver.get(path.as_uri())
        assert driver.execute_script("return document.documentElement.scrollWidth") <= width, name
        assert [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"] == []
        assert driver.execute_script(LEAST_CONTRAST) >= 4.5, name
        ground = driver.execute_script("return getComputedStyle(document.body).backgroundColor")
        assert (max(map(int, re.findall(r"\d+", ground)[:3])) < 64) == dark
        assert driver.execute_script(
            "return [...document.querySelectorAll('svg text')].every(t => "
            "t.getBoundingClientRect().height > 9)"
        )


def test_points_typed_into_the_page_come_back(driver, store, tmp_path):
    text = 'problems = ["1.17"]\n[by_hand]\nsketch = {points = 3, text = "a sketch"}\n'
    homework = an_assignment(tmp_path, text)
    graded(store, "ann", "1.17", {"a_region": RIGHT, "b_region": RIGHT})
    commands.write(tmp_path / "graded" / "hw1", homework, scores(store, homework), "now")
    (tmp_path / "down").mkdir()
    driver.execute_cdp_cmd(
        "Browser.setDownloadBehavior",
        {"behavior": "allow", "downloadPath": str(tmp_path / "down")},
    )
    driver.get((tmp_path / "graded" / "hw1" / "by_hand.html").as_uri())
    number, comment = driver.find_elements("css selector", "fieldset input")
    number.send_keys("2.5")
    comment.send_keys('=a "good" one; ω')
    driver.find_element("css selector", "button").click()
    table = tmp_path / "down" / "points.csv"
    deadline = time.monotonic() + 20
    while not table.exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    assert points_by_hand.import_table(tmp_path / "graded", table) == 1
    assert store.manual("hw1") == {
        ("ann", "by_hand", "sketch"): HandPoints(2.5, '=a "good" one; ω')
    }


#: The least contrast of any text on the page to what lies behind it.
LEAST_CONTRAST = """
const light = c => { const v = c.match(/[\\d.]+/g).slice(0, 3)
  .map(x => (x /= 255) <= .03928 ? x / 12.92 : ((x + .055) / 1.055) ** 2.4);
                     return .2126 * v[0] + .7152 * v[1] + .0722 * v[2]; };
const ground = e => { for (; e; e = e.parentElement) { const c = getComputedStyle(e).backgroundColor;
  if (!/, 0\\)$/.test(c)) return c; }
                      return 'rgb(255,255,255)'; };
const written = e => [...e.childNodes].some(n => n.nodeType == 3 && n.textContent.trim());
return Math.min(...[...document.querySelectorAll('body *')].filter(written).map(e => {
  const [a, b] = [light(e.namespaceURI.endsWith('svg') ? getComputedStyle(e).fill : getComputedStyle(e).color),
                  light(ground(e))];
  return (Math.max(a, b) + .05) / (Math.min(a, b) + .05); }));
"""

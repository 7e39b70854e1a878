"""The page for points by hand in the browser: what it shows, whom it answers, and what it stores."""

import csv
import http.client
import io
import json
import random
import signal
import subprocess
import sys
import threading
from functools import partial
from pathlib import Path
from urllib.parse import urlsplit

import pytest

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parents[1] / "browser"))
from chromium import browser  # noqa: F401
from classroom import graded, hand_in, write_assignment
from test_pages import LEAST_CONTRAST

from workbook.checks.contract.verdict import RIGHT, UNCHECKED
from workbook.grading import commands
from workbook.grading.course.store import HandPoints, Store
from workbook.grading.reports import review
from workbook.grading.reports.review_page import questions
from workbook.grading.reports.scores import scores
from workbook.notebooks.execution import Child

HOMEWORK = (
    'title = "Homework 1"\nproblems = ["1.17"]\n[by_hand]\n'
    'sketch = {points = 3, text = "a sketch where $k_1 > 0$"}\n'
)
HOSTILE = (
    "</pre></main></section><script>document.title = 'owned'</script>"
    "<img src=x onerror=\"document.title='owned'\"><svg onload=document.title='owned'>"
    "\u202e\x1b[31m' \" ]]> --> {{7*7}} <base href=//evil.example/> <form action=points>"
    "<style>*{display:none}</style><a href=javascript:document.title='owned'>x</a>"
)
STUDENTS = [HOSTILE, "Zoë", "ann", "bob"]


@pytest.fixture
def questions_of_class(tmp_path, store, homework):
    """Ann's region could not be judged; all have written something for the sketch."""
    for student in STUDENTS:
        verdict = UNCHECKED if student == "ann" else RIGHT
        graded(
            store,
            student,
            "1.17",
            {"a_region": verdict, "b_region": RIGHT},
            texts={"a_region": "<b>k1 > 0</b>"},
        )
    class_scores = scores(store, homework, ["dan"])
    commands.write(tmp_path / "graded" / "hw1", homework, class_scores, "now")
    texts = {student: [("ch1-p17.ipynb", [f"I think {HOSTILE}"])] for student in STUDENTS[:3]}
    return questions(homework, class_scores, texts)


@pytest.fixture
def server(tmp_path, questions_of_class):
    with review.ReviewServer(tmp_path / "graded", questions_of_class, "Dr Lund") as running:
        thread = threading.Thread(target=running.serve_forever, daemon=True)
        thread.start()
        yield running
        running.shutdown()
        thread.join(timeout=30)


def ask(server, place="", method="GET", body=None, token=None, path=None, **headers):
    """Return (status, headers, text) of a request; `headers` replace those of the page itself."""
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=30)
    own = {"Host": f"127.0.0.1:{server.server_port}"}
    if method == "POST":
        own |= {"Content-Type": "application/json", "Origin": f"http://{own['Host']}"}
    given = {name.replace("_", "-"): value for name, value in headers.items()}
    path = f"/{server.token if token is None else token}/{place}" if path is None else path
    connection.request(
        method, path, body, {k: v for k, v in (own | given).items() if v is not None}
    )
    reply = connection.getresponse()
    result = reply.status, dict(reply.getheaders()), reply.read().decode()
    connection.close()
    return result


def points_of(student, points, comment="", answer=("by_hand", "sketch"), **more):
    return json.dumps(
        {"key": [student, "hw1", *answer], "points": points, "comment": comment} | more
    )


def test_what_waits_is_listed_by_question(questions_of_class, server):
    assert [(q.problem, q.name, [a.student for a in q.answers]) for q in questions_of_class] == [
        ("1.17", "a_region", ["ann"]),
        ("by_hand", "sketch", sorted(STUDENTS)),
    ]
    status, headers, page = ask(server)
    assert status == 200 and "0 of 4 have points" in page and "dan" not in page
    assert headers["Content-Security-Policy"].startswith("default-src 'none'; connect-src 'self'")
    assert "'unsafe" not in headers["Content-Security-Policy"]
    assert headers["Cache-Control"] == "no-store" and headers["Referrer-Policy"] == "no-referrer"


@pytest.mark.parametrize(
    "request_of_another",
    [
        {"token": "x"},
        {"token": ""},
        {"path": "/"},
        {"path": "//"},
        {"path": "*"},
        {"Host": "evil.example"},
        {"Host": "127.0.0.1.evil.example:80"},
        {"Host": "evil.example:80", "method": "POST", "place": "points"},
        {"method": "POST", "place": "points", "Origin": "http://evil.example"},
        {"method": "POST", "place": "points", "Origin": "null"},
        {"method": "POST", "place": "points", "Sec_Fetch_Site": "cross-site"},
        {"method": "POST", "place": "points", "Content_Type": "text/plain"},
        {"method": "POST", "place": "points", "Content_Type": "application/x-www-form-urlencoded"},
        {"method": "POST", "place": "points", "token": "x"},
        {"method": "POST", "place": "other"},
        {"method": "OPTIONS", "place": "points"},
        {"method": "PUT", "place": "points"},
    ],
)
def test_requests_that_are_not_the_pages_own_are_refused(server, store, request_of_another):
    body = points_of("ann", 3) if "method" in request_of_another else None
    status, headers, text = ask(server, body=body, **request_of_another)
    assert status in (400, 403, 501) and "Access-Control-Allow-Origin" not in headers
    assert server.token not in text and store.manual("hw1") == {}


@pytest.mark.parametrize(
    "body, message",
    [
        (points_of("ann", 4), "worth 3 points"),
        (points_of("ann", -1), "worth 3 points"),
        (points_of("ann", float("nan")), "worth 3 points"),
        (points_of("ann", float("inf")), "worth 3 points"),
        (points_of("ann", 10**400), "worth 3 points"),
        (points_of("ann", "three"), "points are a number"),
        (points_of("ann", True), "points are a number"),
        (points_of("ann", None), "has no points by hand"),
        (points_of("eve", 1), "has no student eve"),
        (points_of("ann", 1, answer=("1.17", "c_region")), "asks for no 1.17 c_region"),
        (points_of("ann", 1, key=["ann", "../../etc", "by_hand", "sketch"]), "no grades of"),
        (points_of("ann", 1, key=["ann", "hw1", "by_hand", ["sketch"]]), "not a request of the"),
        (points_of("ann", 1, comment=3), "not a request of the page"),
        (points_of("ann", 1, key=3), "not a request of the page"),
        ("[" * 90_000, "not a request of the page"),
        ("", "not a request of the page"),
    ],
)
def test_points_that_cannot_be_are_an_error_and_change_nothing(server, store, body, message):
    status, _, text = ask(server, "points", "POST", body)
    assert status == 200 and message in json.loads(text)["error"] and store.manual("hw1") == {}


def test_a_long_request_is_not_read(server):
    assert ask(server, "points", "POST", Content_Length=str(10**9))[0] == 413
    assert ask(server, "points", "POST", Content_Length="-1")[0] == 413


def test_points_are_stored_at_once_as_by_workbook_score(server, store, tmp_path):
    reply = ask(server, "points", "POST", points_of("ann", 2.5, "well \ud800 drawn"))
    assert json.loads(reply[2]) == {"message": "ann, hw1, by_hand sketch: 2.5 of 3 points by hand"}
    assert store.manual("hw1") == {
        ("ann", "by_hand", "sketch"): HandPoints(2.5, "well \\ud800 drawn", "Dr Lund")
    }
    table = (tmp_path / "graded" / "points-by-hand.csv").read_text(encoding="utf-8-sig")
    assert next(csv.reader(io.StringIO(table.split("\n")[1])))[4] == "2.5"
    ask(server, "points", "POST", points_of("ann", None))
    assert store.manual("hw1") == {}


# In a browser


@pytest.mark.parametrize("width", [1400, 390])
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_the_page_in_chromium(browser, server, store, tmp_path, width, theme):  # noqa: F811
    browser.resize(width, 900, phone=width < 500)
    scheme = [{"name": "prefers-color-scheme", "value": theme}]
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": scheme})
    browser.open(server.address)
    assert browser.driver.execute_script(LEAST_CONTRAST) >= 4.5
    browser.driver.find_element("partial link text", "sketch").click()
    assert browser.wait_for("document.querySelectorAll('section.answer').length") == 4
    # What students wrote is text.
    assert "owned" not in browser.run("document.title")
    for element in ("script", "img", "svg", "style", "base", "a"):
        assert not browser.run(f"document.querySelector('main {element}')"), element
    assert HOSTILE[:60] in browser.run("document.querySelector('pre').textContent")
    assert browser.run("document.documentElement.scrollWidth") <= width
    assert browser.driver.execute_script(LEAST_CONTRAST) >= 4.5

    def press(*keys):
        for key in keys:
            browser.driver.switch_to.active_element.send_keys(key)

    # Keys alone: all points and a comment for the first, then it is the second's turn.
    press("f", "c", "clear sketch", "\ue007")
    assert browser.wait_for(
        "document.querySelector('[role=status]').textContent.startsWith('saved')"
    )
    first, second = sorted(STUDENTS)[:2]
    assert store.manual("hw1")[first, "by_hand", "sketch"] == HandPoints(
        3, "clear sketch", "Dr Lund"
    )
    assert browser.wait_for(
        "[...document.querySelectorAll('section.answer')].indexOf(document.activeElement) == 1"
    )
    # The earlier comment again, by its key, and points by their field.
    press("1", "\ue00c", "p", "1,5", "\ue00c", "s")
    assert browser.wait_for("document.querySelectorAll('section.given').length == 2")
    assert store.manual("hw1")[second, "by_hand", "sketch"] == HandPoints(
        1.5, "clear sketch", "Dr Lund"
    )
    assert browser.run("document.querySelector('#given').textContent") == "2"
    # What cannot be stored says so.
    press("p", "9", "\ue007")
    assert browser.wait_for("document.querySelector('.error')")
    assert "worth 3 points" in browser.run("document.querySelector('.error').textContent")
    # A page opened again shows what is stored.
    browser.open(f"{server.address}{browser.run('location.pathname').rpartition('/')[2]}")
    assert browser.run("document.querySelectorAll('input[name=points]')[1].value") == "1.5"
    assert browser.errors() == [] and browser.foreign_requests() == []


# Killed


def _serve_in_child(graded_folder, of_class):
    server = review.ReviewServer(graded_folder, of_class, "Dr Lund")
    yield [server.server_port, server.token]
    server.serve_forever()


class Address:
    def __init__(self, server_port, token):
        self.server_port, self.token = server_port, token


def test_killed_twenty_times_while_saving(questions_of_class, store, tmp_path, homework):
    """Each answer is saved until the page says that it is; the tables are as without a kill."""
    numbers, kills = random.Random(7), 0
    wanted = {
        student: HandPoints(numbers.randrange(7) / 2, f"comment {k}", "Dr Lund")
        for k, student in enumerate(STUDENTS)
    }
    while kills < 20:
        child = Child(_serve_in_child, tmp_path / "graded", questions_of_class)
        address = Address(*child.result(timeout=60))
        killer = threading.Timer(numbers.random() * 0.3, child._process.kill)
        killer.start()
        try:
            for student in [*wanted, *wanted]:
                given = wanted[student]
                ask(address, "points", "POST", points_of(student, given.points, given.comment))
        except (OSError, http.client.HTTPException):
            kills += 1
        killer.join()
        child.end()
        for (student, *_), stored in store.manual("hw1").items():
            assert stored == wanted[student]
    with review.ReviewServer(tmp_path / "graded", questions_of_class, "Dr Lund") as server:
        thread = threading.Thread(target=server.serve_forever, daemon=True)
        thread.start()
        for student, given in wanted.items():
            ask(server, "points", "POST", points_of(student, given.points, given.comment))
        server.shutdown()
    commands.write(tmp_path / "graded" / "hw1", homework, scores(store, homework, ["dan"]), "now")
    with Store(tmp_path / "calm" / "grades.sqlite") as calm:
        for student in STUDENTS:
            verdict = UNCHECKED if student == "ann" else RIGHT
            verdicts = {"a_region": verdict, "b_region": RIGHT}
            graded(calm, student, "1.17", verdicts, texts={"a_region": "<b>k1 > 0</b>"})
        commands.write(tmp_path / "calm" / "hw1", homework, scores(calm, homework, ["dan"]), "now")
        calm.set_points({(s, "hw1", "by_hand", "sketch"): given for s, given in wanted.items()})
        commands.write(tmp_path / "calm" / "hw1", homework, scores(calm, homework, ["dan"]), "now")
    for name in ("grades.csv", "moodle.csv", "mail-merge.csv", "grades.json"):
        killed, undisturbed = (
            (tmp_path / folder / "hw1" / name).read_text() for folder in ("graded", "calm")
        )
        assert killed == undisturbed, name


def test_from_the_command_line(tmp_path):
    write_assignment(tmp_path, HOMEWORK.replace("1.17", "1.15"))
    hand_in(tmp_path, "ann", "1.15", {"a_region": "(k1 > 0) & (k1*k2 > 1)"})
    # A shell that runs the tests in the background lets them ignore SIGINT.
    heeding = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)
    process = subprocess.Popen(
        [
            *(sys.executable, "-m", "workbook", "grade", "submitted", "--out", "graded"),
            *("--review", "--by", "Dr Lund", "--json"),
        ],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=heeding,
    )
    try:
        line = ""
        while "points by hand: http" not in line:
            line = process.stderr.readline()
            assert line, process.communicate()
        address = urlsplit(line.split()[3])
        server = Address(address.port, address.path.strip("/"))
        assert "0 of 1 have points" in ask(server)[2]
        assert "message" in ask(server, "points", "POST", points_of("ann", 2))[2]
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=120)
    finally:
        process.kill()
        process.communicate()
    assert process.returncode == 0, errors
    assert json.loads(output)["assignments"] == {"hw1": {"ann": 3.0}}
    assert "all that was saved is stored" in errors
    with pytest.raises(OSError):
        ask(server)
    row = (tmp_path / "graded" / "hw1" / "grades.csv").read_text().split("\n")[1]
    assert '"ann","1.00","2.00","3.00"' in row

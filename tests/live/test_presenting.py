"""`workbook live` from start to end: notebook, processes and messages."""

import io
import json
import os
import signal
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path
from urllib.parse import parse_qs, urlsplit

import pytest

from workbook.live import LiveError, find_presentation, presenting
from workbook.live.keeping import keep_notebook
from workbook.live.lecture_notebook import lecture_notebook
from workbook.notebooks import exercises

ROOT = Path(__file__).resolve().parents[2]


def workbook(*arguments, **environment):
    return subprocess.run(
        [sys.executable, "-m", "workbook.cli", *arguments],
        env=os.environ | environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
    )


def one_line(done):
    assert done.returncode == 2 and len(done.stderr.strip().splitlines()) == 1, done.stderr
    return done.stderr


def test_the_list_has_lectures_and_problems():
    done = workbook("live", COLUMNS="200")
    assert done.returncode == 0 and "1.15" in done.stdout and "Stability regions" in done.stdout


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["9.99"], "no problem 9.99"),
        (["stabilty"], "there is no lecture stabilty"),
        (["1.15", "--port", "99999", "--no-browser"], "port 99999"),
        (["1.15", "--keep", "x", "--discard"], "either --keep or --discard"),
        (
            ["1.15", "--no-browser", "--keep", str(ROOT / "solutions" / "ch1" / "p15.md")],
            "one of the course's own files",
        ),
    ],
)
def test_bad_input_ends_in_one_line(arguments, message):
    assert message in one_line(workbook("live", *arguments))


def test_a_taken_port_ends_in_one_line():
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = str(other.getsockname()[1])
        assert f"port {port} cannot be had" in one_line(
            workbook("live", "1.15", "--no-browser", "--port", port)
        )


def test_without_a_browser_one_line_says_what_to_do():
    done = workbook("live", "1.15", PATH="/nowhere", DISPLAY="", BROWSER="", WAYLAND_DISPLAY="")
    assert "--no-browser prints the address" in one_line(done)


def test_without_jupyterlab_one_line_says_how_to_get_it(monkeypatch):
    monkeypatch.setattr(presenting, "find_spec", lambda name: None)
    with pytest.raises(LiveError, match="JupyterLab is not installed"):
        presenting.present(find_presentation("1.15"), browser=False)


def test_a_problem_is_shown_without_its_solution():
    notebook = lecture_notebook(find_presentation("1.15"))
    text = json.dumps(notebook)
    sources = [cell["source"] for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert "find the region where the zero solution" in text and "a_poly = s**3" in text
    assert sources[1:3] == ["%answer a_region", "%check a_region"]
    assert (
        "hurwitz_minors" not in text
        and "sp.And" not in text
        and "Hint 1" not in text
        and ":class:" not in text
    )


def test_every_problem_has_a_notebook_with_its_drawings():
    import nbformat

    for exercise in exercises.read_all():
        notebook = nbformat.from_dict(lecture_notebook(find_presentation(exercise.number)))
        nbformat.validate(notebook)
        checked = [
            cell.source.split()[-1] for cell in notebook.cells if cell.source.startswith("%check")
        ]
        assert checked == list(exercise.about["answers"]) or set(checked) == set(
            exercise.about["answers"]
        )
        pictures = [cell for cell in notebook.cells if "attachment:" in cell.source]
        assert all(cell.attachments for cell in pictures)


def call(address, path, body=None, method=None):
    parts = urlsplit(address)
    token = parse_qs(parts.query)["token"][0]
    request = urllib.request.Request(
        f"http://{parts.netloc}{path}",
        json.dumps(body).encode() if body else None,
        {"Authorization": f"token {token}", "Content-Type": "application/json"},
        method=method,
    )
    with urllib.request.urlopen(request, timeout=60) as answer:
        return json.load(answer)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_no_process_is_left_however_it_ends(lecture, number):
    with lecture("1.15", "--discard") as live:
        session = call(
            live.address,
            "/api/sessions",
            {"path": "1.15.ipynb", "name": "", "type": "notebook", "kernel": {"name": "python3"}},
            "POST",
        )
        assert session["kernel"]["id"]
        live.end(number)


def test_a_process_that_has_exited_is_reaped():
    process = subprocess.Popen(
        [sys.executable, "-c", ""], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    process.wait(60)
    process.stdin.write(b"unread")
    presenting._end(process)
    assert process.returncode == 0


def test_kernels_are_forked_with_a_long_path(lecture, tmp_path):
    with lecture("1.15", "--discard") as live:
        end = time.monotonic() + 30
        while (
            not (sockets := list(tmp_path.glob("temporary*/workbook-live-*/kernels")))
            and time.monotonic() < end
        ):
            time.sleep(0.2)
        assert sockets and sockets[0].is_socket()
        live.end()


def test_saving_changes_the_copy_only_which_is_kept(lecture, tmp_path):
    before = {
        path: path.read_bytes()
        for path in (
            ROOT / "solutions" / "ch1" / "p15.md",
            ROOT / "exercises" / "ch1" / "p15.ipynb",
        )
    }
    with lecture("1.15", "--keep", "monday") as live:
        notebook = call(live.address, "/api/contents/1.15.ipynb")["content"]
        notebook["cells"][1]["source"] = "spoilt = True"
        call(
            live.address,
            "/api/contents/1.15.ipynb",
            {"type": "notebook", "content": notebook},
            "PUT",
        )
        assert "kept: monday.ipynb" in live.end()
    assert "spoilt" in (tmp_path / "monday.ipynb").read_text()
    assert {path: path.read_bytes() for path in before} == before
    assert not list(tmp_path.glob("temporary*/workbook-live-*"))


def test_without_a_terminal_the_notebook_is_kept(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "stdin", io.StringIO())
    copy = tmp_path / "copy.ipynb"
    copy.write_text("worked on")
    assert keep_notebook(copy, b"", "1.15", None, discard=True) is None
    assert keep_notebook(copy, b"worked on", "1.15", None, discard=False) is None
    assert keep_notebook(copy, b"", "1.15", None, discard=False) == Path("live-1.15.ipynb")
    assert keep_notebook(copy, b"", "1.15", None, discard=False) == Path("live-1.15-2.ipynb")


@pytest.mark.parametrize("message, kept", [("", None), ("monday", Path("monday.ipynb"))])
def test_closing_asks_whether_to_keep(tmp_path, monkeypatch, message, kept):
    class Terminal:
        def isatty(self):
            return True

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "stdin", Terminal())
    monkeypatch.setattr("builtins.input", lambda question: message)
    copy = tmp_path / "copy.ipynb"
    copy.write_text("worked on")
    assert keep_notebook(copy, b"", "1.15", None, discard=False) == kept

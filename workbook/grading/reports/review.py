"""Serve the pages for points by hand, on this machine only, and store the points at once.

The address has a token, without which nothing is answered; nor is a request that names another host
(a page of another site may let its name point here) or that comes from another page.
"""

import hmac
import json
import secrets
import sys
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from workbook.grading.course.assignment import InputError
from workbook.grading.course.store import Store
from workbook.grading.reports.pages import STYLE, source_hash
from workbook.grading.reports.points_by_hand import score_by_hand
from workbook.grading.reports.review_page import (
    REVIEW_STYLE,
    SCRIPT,
    index_page,
    question_page,
)
from workbook.grading.sandbox.sanitising import sanitise

HOSTS = ("127.0.0.1", "localhost")
#: Bytes of a request with points, and seconds for a request.
MAX_REQUEST, SECONDS = 100_000, 30
HEADERS = {
    "Content-Security-Policy": "default-src 'none'; connect-src 'self'; "
    f"script-src {source_hash(SCRIPT)}; style-src {source_hash(STYLE + REVIEW_STYLE)}; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "Cache-Control": "no-store",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
}


def serve(graded, questions, by=""):
    """Serve until Ctrl-C.

    Parameters
    ----------
    graded : path
        Folder of results.
    questions : list of Question
        What waits for points.
    by : str
        Who gives them.
    """
    with ReviewServer(graded, questions, by) as server:
        print(f"points by hand: {server.address} (Ctrl-C ends)", file=sys.stderr, flush=True)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            print("points by hand: ended, all that was saved is stored", file=sys.stderr)


class ReviewServer(ThreadingHTTPServer):
    """The server of the pages; its `address` has the token."""

    daemon_threads = True

    def __init__(self, graded, questions, by=""):
        super().__init__(("127.0.0.1", 0), _Handler)
        self.graded, self.questions, self.by = Path(graded), questions, by
        self.token, self.saving = secrets.token_urlsafe(32), threading.Lock()

    @property
    def address(self):
        """The address of the first page."""
        return f"http://127.0.0.1:{self.server_port}/{self.token}/"

    def given(self):
        """Return all `HandPoints` by (student, assignment, problem, answer)."""
        with Store(self.graded / "grades.sqlite") as store:
            return {
                (student, name, *answer): points
                for name in dict.fromkeys(question.assignment for question in self.questions)
                for (student, *answer), points in store.manual(name).items()
            }


class _Handler(BaseHTTPRequestHandler):
    timeout = SECONDS

    def do_GET(self):
        place, questions = self._place(), self.server.questions
        if place is None:
            return
        if place == "":
            self._reply(200, index_page(questions, self.server.given()))
        elif place.isascii() and place.isdigit() and len(place) < 6 and int(place) < len(questions):
            self._reply(200, question_page(questions, int(place), self.server.given()))
        else:
            self._reply(404, "there is no such page", "text/plain")

    def do_POST(self):
        place = self._place()
        if place is None:
            return
        origin = f"http://{self.headers.get('Host')}"
        own_page = (
            self.headers.get("Origin", origin) == origin
            and self.headers.get("Sec-Fetch-Site", "same-origin") == "same-origin"
            and self.headers.get_content_type() == "application/json"
        )
        length = self.headers.get("Content-Length", "")
        if place != "points" or not own_page:
            self._reply(403, "this is not a request of the page", "text/plain")
        elif not (length.isascii() and length.isdigit() and int(length) <= MAX_REQUEST):
            self._reply(413, "this request is too long", "text/plain")
        else:
            self._reply(
                200, json.dumps(self._save(self.rfile.read(int(length)))), "application/json"
            )

    def _save(self, request):
        """Store the points of a request; return the message, or the error."""
        try:
            request = json.loads(request)
            (student, assignment, problem, answer), points = request["key"], request["points"]
            comment = sanitise(request["comment"])
            if not all(isinstance(part, str) for part in request["key"]):
                raise TypeError
        except (ValueError, KeyError, TypeError, RecursionError):
            return {"error": "this is not a request of the page"}
        if type(points) not in (int, float, type(None)):
            return {"error": "points are a number, or nothing to take them back"}
        try:
            with self.server.saving:
                message = score_by_hand(
                    self.server.graded,
                    student,
                    assignment,
                    problem,
                    answer,
                    points,
                    comment,
                    self.server.by,
                )
        except InputError as error:
            return {"error": str(error)}
        return {"message": message}

    def _place(self):
        """Return what follows the token in the address; refuse a request without it."""
        host = self.headers.get("Host", "").rpartition(":")[0]
        token, _, place = self.path.removeprefix("/").partition("/")
        if host not in HOSTS:
            self._reply(403, "this page is for this machine only", "text/plain")
        elif not hmac.compare_digest(token.encode(), self.server.token.encode()):
            self._reply(403, "the address is not the one that was printed", "text/plain")
        else:
            return place
        return None

    def _reply(self, status, text, kind="text/html"):
        content = text.encode("utf-8", "backslashreplace")
        self.send_response(status)
        for name, value in HEADERS.items():
            self.send_header(name, value)
        self.send_header("Content-Type", f"{kind}; charset=utf-8")
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    def version_string(self):
        return "workbook"

    def log_message(self, *_):
        """Print nothing: the address has the token."""

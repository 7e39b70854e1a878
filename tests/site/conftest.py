"""Builds both editions of the site once, for a browser that reaches no other machine."""

import fcntl
import functools
import os
import subprocess
import sys
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from types import SimpleNamespace

import pytest
from bs4 import BeautifulSoup
from chromium import browser, moving_browser  # noqa: F401
from firefox import firefox  # noqa: F401

from workbook.grading.sandbox.preloading import freeze_new_objects

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).parent


def pytest_collection_modifyitems(items):
    for item in items:
        if HERE in item.path.parents:
            item.add_marker(pytest.mark.site)
            item.add_marker(pytest.mark.timeout(3600))  # the first of them builds the site


@pytest.fixture(scope="session")
def editions(testrun_uid, core_seconds):
    """Return the folders of the two editions as `make` builds them; a warning ends the build."""
    (ROOT / "_build").mkdir(exist_ok=True)
    # Test processes run in parallel: the first builds, the others wait for it.
    with open(ROOT / "_build" / ".built-for-tests", "a+") as run:
        fcntl.flock(run, fcntl.LOCK_EX)
        run.seek(0)
        if run.read() != testrun_uid:
            with core_seconds("a build"):
                _build()
            run.truncate(0)
            run.write(testrun_uid)
    return SimpleNamespace(
        full=ROOT / "_build" / "html", student=ROOT / "_build" / "student" / "html"
    )


def _build():
    # As from a shell: kernels must not use the tests' backend of Matplotlib.
    settings = {
        key: value
        for key, value in os.environ.items()
        if not key.startswith(("MAKE", "MPLBACKEND"))
    }
    # The running environment is used as it is: nothing is installed.
    process = subprocess.run(
        ["make", "--jobs=2", "book", "book-student", f"VENV={sys.prefix}", "INSTALLED="],
        cwd=ROOT,
        env=settings,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        timeout=3000,
    )
    assert process.returncode == 0, f"the site does not build:\n{process.stdout[-6000:]}"


@pytest.fixture(scope="session")
def pages_of():
    """Return the pages below a folder; _static has templates of the theme, which are no pages."""
    return functools.cache(
        lambda root: sorted(
            path for path in root.rglob("*.html") if root / "_static" not in path.parents
        )
    )


@pytest.fixture(scope="session", params=["full", "student"])
def pages(request, editions, pages_of):
    """Return the folder of an edition, and path -> parsed page, for all tests of an edition."""
    root = getattr(editions, request.param)
    with freeze_new_objects():
        return root, {
            path: BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")
            for path in pages_of(root)
        }


@pytest.fixture(scope="session")
def problem(editions):
    """Return a sample problem: its number, and its page in the edition with solutions."""
    page = min(editions.full.glob("solutions/ch*/p*.html"), key=lambda page: page.stem != "p15")
    return SimpleNamespace(
        page=page.relative_to(editions.full).as_posix(),
        number=f"{page.parent.name[2:]}.{int(page.stem[1:])}",
    )


class _QuietHandler(SimpleHTTPRequestHandler):
    def log_message(self, *args):
        pass


@pytest.fixture(scope="session")
def addresses(editions):
    """Return the addresses of the sites: file and http with solutions, and student."""
    served = {"http": editions.full, "student": editions.student}
    servers = {
        name: ThreadingHTTPServer(("127.0.0.1", 0), partial(_QuietHandler, directory=str(root)))
        for name, root in served.items()
    }
    for server in servers.values():
        threading.Thread(target=server.serve_forever, daemon=True).start()
    yield {
        "file": editions.full.as_uri(),
        **{name: f"http://127.0.0.1:{server.server_port}" for name, server in servers.items()},
    }
    for server in servers.values():
        server.shutdown()
        server.server_close()


@pytest.fixture
def search_for(browser):  # noqa: F811
    """Return a function that opens the search of the open page, types a query and waits for hits."""
    from selenium.webdriver.common.keys import Keys

    def search(text):
        browser.driver.switch_to.active_element.send_keys(Keys.CONTROL, "k")
        browser.driver.switch_to.active_element.send_keys(text)
        assert browser.wait_for("document.querySelectorAll('#search-hits a').length", 60)

    return search

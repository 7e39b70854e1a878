"""Builds both editions of the site once, and opens them in a browser that can reach nothing but
this machine."""

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

from workbook.grading.preloading import freeze_new_objects

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).parent


def pytest_collection_modifyitems(items):
    for item in items:
        if HERE in item.path.parents:
            item.add_marker(pytest.mark.site)
            item.add_marker(pytest.mark.timeout(3600))  # the first of them builds the site


@pytest.fixture(scope="session")
def editions(testrun_uid, core_seconds):
    """The folders of the two editions, as `make` builds them in this checkout; a warning ends the
    build."""
    (ROOT / "_build").mkdir(exist_ok=True)
    # Test processes run side by side: the first builds, the others wait and find the work done.
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
    # As from a shell: the tests' own choice of a backend without pictures is not for the kernels.
    settings = {
        key: value
        for key, value in os.environ.items()
        if not key.startswith(("MAKE", "MPLBACKEND"))
    }
    # The running environment is used as it is: nothing is installed.
    built = subprocess.run(
        ["make", "--jobs=2", "book", "book-student", f"VENV={sys.prefix}", "INSTALLED="],
        cwd=ROOT,
        env=settings,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        timeout=3000,
    )
    assert built.returncode == 0, f"the site does not build:\n{built.stdout[-6000:]}"


@pytest.fixture(scope="session")
def pages_of():
    """The pages below a folder; _static holds templates of the theme, which are no pages."""
    return functools.cache(
        lambda root: sorted(
            path for path in root.rglob("*.html") if root / "_static" not in path.parents
        )
    )


@pytest.fixture(scope="session", params=["full", "student"])
def pages(request, editions, pages_of):
    """The folder of an edition, and path -> parsed page; all tests of an edition share them."""
    root = getattr(editions, request.param)
    with freeze_new_objects():
        return root, {
            path: BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")
            for path in pages_of(root)
        }


@pytest.fixture(scope="session")
def problem(editions):
    """A problem to look at closely: its number, and its page in the edition with solutions."""
    page = min(editions.full.glob("solutions/ch*/p*.html"), key=lambda page: page.stem != "p15")
    return SimpleNamespace(
        page=page.relative_to(editions.full).as_posix(),
        number=f"{page.parent.name[2:]}.{int(page.stem[1:])}",
    )


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *args):
        pass


@pytest.fixture(scope="session")
def addresses(editions):
    """Where the sites are opened: the edition with solutions from the disk and from a web server,
    the other from one."""
    served = {"http": editions.full, "student": editions.student}
    servers = {
        way: ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(root)))
        for way, root in served.items()
    }
    for server in servers.values():
        threading.Thread(target=server.serve_forever, daemon=True).start()
    yield {
        "file": editions.full.as_uri(),
        **{way: f"http://127.0.0.1:{s.server_port}" for way, s in servers.items()},
    }
    for server in servers.values():
        server.shutdown()
        server.server_close()


@pytest.fixture
def found_by_search(browser):  # noqa: F811
    """Types into the search of the open page; the addresses that are found, best first."""
    from selenium.webdriver.common.keys import Keys

    def found(text):
        browser.find(".bd-sidebar-primary .search-button-field").click()
        browser.find("#pst-search-dialog input[type=search]").send_keys(text, Keys.ENTER)
        return browser.wait_for("""/^Search Results/.test(document.querySelector('#search-results h2')?.innerText || '')
            && [...document.querySelectorAll('main #search-results ul.search li > a')].map(link => link.href)""")

    return found

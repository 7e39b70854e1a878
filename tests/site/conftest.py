"""Builds both editions of the site once, and opens them in a browser that can reach nothing but this machine."""

import fcntl
import json
import os
import shutil
import subprocess
import sys
import threading
import time
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from types import SimpleNamespace

import pytest
from bs4 import BeautifulSoup

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).parent


def pytest_collection_modifyitems(items):
    for item in items:
        if HERE in item.path.parents:
            item.add_marker(pytest.mark.site)
            item.add_marker(pytest.mark.timeout(3600))  # the first of them builds the site


@pytest.fixture(scope="session")
def editions(testrun_uid):
    """The folders of the two editions, as `make` builds them in this checkout; a warning ends the build."""
    (ROOT / "_build").mkdir(exist_ok=True)
    # Test processes run side by side: the first builds, the others wait and find the work done.
    with open(ROOT / "_build" / ".built-for-tests", "a+") as run:
        fcntl.flock(run, fcntl.LOCK_EX)
        run.seek(0)
        if run.read() != testrun_uid:
            _build()
            run.truncate(0)
            run.write(testrun_uid)
    return SimpleNamespace(full=ROOT / "_build" / "html", student=ROOT / "_build" / "student" / "html")


def _build():
    # As from a shell: the tests' own choice of a backend without pictures is not for the kernels.
    settings = {key: value for key, value in os.environ.items() if not key.startswith(("MAKE", "MPLBACKEND"))}
    # The running environment is used as it is: nothing is installed.
    built = subprocess.run(["make", "--jobs=2", "book", "book-student", f"VENV={sys.prefix}", "INSTALLED="], cwd=ROOT,
                           env=settings, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=3000)
    assert built.returncode == 0, f"the site does not build:\n{built.stdout[-6000:]}"


@pytest.fixture(scope="session")
def pages_of():
    """The pages below a folder; _static holds templates of the theme, which are no pages."""
    return lambda root: sorted(path for path in root.rglob("*.html") if root / "_static" not in path.parents)


@pytest.fixture(scope="session", params=["full", "student"])
def pages(request, editions, pages_of):
    """The folder of an edition, and path -> parsed page; all tests of an edition share them."""
    root = getattr(editions, request.param)
    return root, {path: BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser") for path in pages_of(root)}


@pytest.fixture(scope="session")
def problem(editions):
    """A problem to look at closely: its number, and its page in the edition with solutions."""
    page = min(editions.full.glob("solutions/ch*/p*.html"), key=lambda page: page.stem != "p15")
    return SimpleNamespace(page=page.relative_to(editions.full).as_posix(),
                           number=f"{page.parent.name[2:]}.{int(page.stem[1:])}")


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *args):
        pass


@pytest.fixture(scope="session")
def addresses(editions):
    """Where the sites are opened: the edition with solutions from the disk and from a web server, the other from
    one."""
    served = {"http": editions.full, "student": editions.student}
    servers = {way: ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(root)))
               for way, root in served.items()}
    for server in servers.values():
        threading.Thread(target=server.serve_forever, daemon=True).start()
    yield {"file": editions.full.as_uri(), **{way: f"http://127.0.0.1:{s.server_port}" for way, s in servers.items()}}
    for server in servers.values():
        server.shutdown()
        server.server_close()


class Browser:
    """Chromium with every name but this machine's unknown to it."""

    def __init__(self, chromium, driver, profile):
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service

        options = webdriver.ChromeOptions()
        options.binary_location = chromium
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                         "--disable-background-networking", "--disable-component-update", "--disable-sync",
                         "--no-first-run", f"--user-data-dir={profile}", "--window-size=1280,900",
                         "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service(driver))
        self.driver.set_script_timeout(60)

    def open(self, address):
        """Open a page and wait until its formulas are set."""
        self.driver.get_log("browser"), self.driver.get_log("performance")  # forget the page before
        self.driver.get(address)
        self.driver.execute_async_script("""
            const done = arguments[0];
            (window.MathJax && MathJax.startup ? MathJax.startup.promise : Promise.resolve()).then(() => done());""")

    def resize(self, width, height, phone=False):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": phone})

    def run(self, script):
        return self.driver.execute_script(f"return {script}")

    def wait_for(self, script, seconds=10):
        """What the script gives as soon as it is true; its last value after so many seconds."""
        end = time.monotonic() + seconds
        while not (found := self.run(script)) and time.monotonic() < end:
            time.sleep(0.1)
        return found

    def find(self, selector):
        from selenium.webdriver.common.by import By
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def errors(self):
        """What the console calls an error since the page was opened."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]

    def foreign_requests(self):
        """Requests to other hosts since the page was opened."""
        messages = (json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance"))
        urls = [m["params"]["request"]["url"] for m in messages if m["method"] == "Network.requestWillBeSent"]
        return [url for url in urls if not url.startswith(("file:", "data:", "blob:", "http://127.0.0.1:"))]


@pytest.fixture(scope="session")
def browser(tmp_path_factory):
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    driver = shutil.which("chromedriver")
    if not (chromium and driver):
        missing = "chromium and chromedriver are needed to open the site"
        if os.environ.get("CI") == "true":
            pytest.fail(missing)
        pytest.skip(missing)
    browser = Browser(chromium, driver, tmp_path_factory.mktemp("profile"))
    yield browser
    browser.driver.quit()


@pytest.fixture
def found_by_search(browser):
    """Types into the search of the open page; the addresses that are found, best first."""
    from selenium.webdriver.common.keys import Keys

    def found(text):
        browser.find(".bd-sidebar-primary .search-button-field").click()
        browser.find("#pst-search-dialog input[type=search]").send_keys(text, Keys.ENTER)
        return browser.wait_for("""/^Search Results/.test(document.querySelector('#search-results h2')?.innerText || '')
            && [...document.querySelectorAll('main #search-results ul.search li > a')].map(link => link.href)""")

    return found

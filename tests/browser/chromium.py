"""Chromium for tests in a browser, without access to any other machine."""

import json
import os
import shutil
import sys
import time
from contextlib import suppress

import psutil
import pytest

#: Linux: orphaned descendants become children of this process.
PR_SET_CHILD_SUBREAPER = 36


def megabytes(pid):
    """Return the memory of a process and its descendants; what they share counts once."""
    top = psutil.Process(pid)
    found = 0
    for process in [top, *top.children(recursive=True)]:
        with suppress(psutil.NoSuchProcess):
            found += process.memory_full_info().pss
    return found / 1e6


class Browser:
    """Chromium that resolves no host name."""

    def __init__(self, chromium, driver, profile, *more):
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service

        options = webdriver.ChromeOptions()
        options.binary_location = chromium
        for argument in (
            "--headless=new",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
            "--no-first-run",
            f"--user-data-dir={profile}",
            "--window-size=1280,900",
            "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
            *more,
        ):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service(driver))
        # axe takes long for a chapter on a busy machine
        self.driver.set_script_timeout(180)
        self._size = None

    def open(self, address):
        """Open a page and wait until its formulas are set."""
        # discard the logs of the previous page
        self.driver.get_log("browser"), self.driver.get_log("performance")
        self.driver.get(address)
        self.driver.execute_async_script("""
            const done = arguments[0];
            (window.MathJax && MathJax.startup ? MathJax.startup.promise : Promise.resolve()).then(() => done());""")

    def resize(self, width, height, phone=False):
        """Resize the window; Chromium does so in several steps, and only the last needs a layout."""
        if self._size == (width, height, phone):
            return
        self.driver.execute_script("document.documentElement.style.contentVisibility = 'hidden'")
        self.driver.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": phone},
        )
        self.driver.execute_script("document.documentElement.style.contentVisibility = ''")
        if not phone:  # on a phone a wide page makes the window wider
            self.wait_for(f"innerWidth === {width}")
        self._size = width, height, phone

    def forget(self):
        """Empty the page, so that it is not laid out again at the next resize."""
        self.driver.execute_script("document.body.replaceChildren()")

    def core_seconds(self):
        """Return the core-seconds of all its processes up to now."""
        driver = psutil.Process(self.driver.service.process.pid)
        return sum(
            sum(process.cpu_times()[:2]) for process in [driver, *driver.children(recursive=True)]
        )

    def megabytes(self):
        """Return the memory of all its processes."""
        return megabytes(self.driver.service.process.pid)

    def show_theme(self, theme):
        """Show the light or the dark theme, at the end of all transitions from the other one."""
        self.driver.execute_script(
            """
            document.documentElement.dataset.theme = arguments[0];
            for (const fade of document.getAnimations().filter(a => a instanceof CSSTransition)) fade.finish();""",
            theme,
        )

    def run(self, script):
        return self.driver.execute_script(f"return {script}")

    def wait_for(self, script, seconds=10):
        """Return the value of a script once it is true, or its last value after so many seconds."""
        end = time.monotonic() + seconds
        while not (value := self.run(script)) and time.monotonic() < end:
            time.sleep(0.1)
        return value

    def evaluate(self, script, *arguments, seconds=300):
        """Return the value of an asynchronous script in the open page, with its `args`."""
        self.driver.execute_script(
            "window.outcome = null;"
            f"(async (...args) => {{ {script} }})(...arguments)"
            ".then(value => { window.outcome = [value]; }, error => { window.outcome = String(error); });",
            *arguments,
        )
        outcome = self.wait_for("window.outcome", seconds)
        assert isinstance(outcome, list), outcome or f"no value after {seconds} s"
        return outcome[0]

    def find(self, selector):
        from selenium.webdriver.common.by import By

        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def errors(self):
        """Return the errors in the console since the page was opened."""
        return [
            entry["message"]
            for entry in self.driver.get_log("browser")
            if entry["level"] == "SEVERE"
        ]

    def foreign_requests(self):
        """Return the requests to other hosts since the page was opened."""
        messages = (
            json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")
        )
        urls = [
            m["params"]["request"]["url"]
            for m in messages
            if m["method"] == "Network.requestWillBeSent"
        ]
        return [
            url
            for url in urls
            if not url.startswith(("file:", "data:", "blob:", "chrome", "http://127.0.0.1:"))
        ]


@pytest.fixture(scope="session")
def browser(tmp_path_factory, core_seconds):
    """Return a browser for still pages.

    Without a graphics card, threaded compositing is a third of the cost of a visit; without it there
    are no frames of animations.
    """
    yield from _running(tmp_path_factory, core_seconds, "--disable-threaded-compositing")


@pytest.fixture(scope="session")
def moving_browser(tmp_path_factory, core_seconds):
    """Return a browser for animations, icons and JupyterLab, which are drawn in frames."""
    yield from _running(tmp_path_factory, core_seconds)


def _running(tmp_path_factory, core_seconds, *arguments):
    chromium = os.environ.get("CHROMIUM") or (
        shutil.which("chromium")
        or shutil.which("chromium-browser")
        or shutil.which("google-chrome")
    )
    driver = os.environ.get("CHROMEDRIVER") or shutil.which("chromedriver")
    if not (chromium and driver):
        missing = "chromium and chromedriver are needed for tests in a browser"
        if os.environ.get("CI") == "true":
            pytest.fail(missing)
        pytest.skip(missing)
    browser = Browser(chromium, driver, tmp_path_factory.mktemp("profile"), *arguments)
    yield browser
    with core_seconds("a browser"):  # its core-seconds are known when it has ended
        _end(browser.driver)


def _end(driver):
    """Quit and wait for all processes of this Chromium, so that their core-seconds are counted.

    Its driver orphans them; on Linux they become children of this process.
    """
    if sys.platform != "linux":
        driver.quit()
        return
    from workbook.grading.sandbox.system_calls import system_call

    system_call("prctl", PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    left = {
        process.pid
        for process in psutil.Process(driver.service.process.pid).children(recursive=True)
    }
    driver.quit()
    end = time.monotonic() + 10
    while left and time.monotonic() < end:
        left = {pid for pid in left if not _has_ended(pid)}
        time.sleep(0.02)


def _has_ended(pid):
    try:
        return os.waitpid(pid, os.WNOHANG) != (0, 0)
    except ChildProcessError:  # it is not yet a child of this process, or it has ended
        return not psutil.pid_exists(pid)

"""Chromium for the tests of what is seen in a browser, and unable to reach anything but this
machine."""

import json
import os
import shutil
import time
from contextlib import suppress

import psutil
import pytest

from workbook.grading.system_calls import system_call

#: Linux: whom the children of a child that ends are left to.
PR_SET_CHILD_SUBREAPER = 36


class Browser:
    """Chromium with every name but this machine's unknown to it."""

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
        # axe takes long for a chapter where others compute beside
        self.driver.set_script_timeout(180)
        self._size = None

    def open(self, address):
        """Open a page and wait until its formulas are set."""
        # forget the page before
        self.driver.get_log("browser"), self.driver.get_log("performance")
        self.driver.get(address)
        self.driver.execute_async_script("""
            const done = arguments[0];
            (window.MathJax && MathJax.startup ? MathJax.startup.promise : Promise.resolve()).then(() => done());""")

    def resize(self, width, height, phone=False):
        """Chromium goes from one size to another in several steps: the page is laid out after the
        last one alone."""
        if self._size == (width, height, phone):
            return
        self.driver.execute_script("document.documentElement.style.contentVisibility = 'hidden'")
        self.driver.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": phone},
        )
        self.driver.execute_script("document.documentElement.style.contentVisibility = ''")
        self._size = width, height, phone

    def forget(self):
        """Empty the page: nothing more is asked of it, and it need not be laid out for the size of
        the next one."""
        self.driver.execute_script("document.body.replaceChildren()")

    def computed(self):
        """The core-seconds of all its processes up to now."""
        driver = psutil.Process(self.driver.service.process.pid)
        return sum(
            sum(process.cpu_times()[:2]) for process in [driver, *driver.children(recursive=True)]
        )

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
        return [
            entry["message"]
            for entry in self.driver.get_log("browser")
            if entry["level"] == "SEVERE"
        ]

    def foreign_requests(self):
        """Requests to other hosts since the page was opened."""
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
    """For pages on which nothing is to move: without a graphics card, layers that a thread of their
    own puts together are a third of what a visit computes, and without that thread no frames of
    animations come."""
    yield from _running(tmp_path_factory, core_seconds, "--disable-threaded-compositing")


@pytest.fixture(scope="session")
def moving_browser(tmp_path_factory, core_seconds):
    """For what moves, for icons and for JupyterLab, which are drawn when a frame is."""
    yield from _running(tmp_path_factory, core_seconds)


def _running(tmp_path_factory, core_seconds, *arguments):
    chromium = (
        shutil.which("chromium")
        or shutil.which("chromium-browser")
        or shutil.which("google-chrome")
    )
    driver = shutil.which("chromedriver")
    if not (chromium and driver):
        missing = "chromium and chromedriver are needed for what is seen in a browser"
        if os.environ.get("CI") == "true":
            pytest.fail(missing)
        pytest.skip(missing)
    browser = Browser(chromium, driver, tmp_path_factory.mktemp("profile"), *arguments)
    yield browser
    with core_seconds("a browser"):  # what it computed is known when it has ended
        _end(browser.driver)


def _end(driver):
    """Quit and wait for all processes of this Chromium. Its driver leaves them behind, so that
    nobody would know what they computed, which is nearly all of it: they are taken on (Linux)."""
    with suppress(OSError):
        system_call("prctl", PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    left = {
        process.pid
        for process in psutil.Process(driver.service.process.pid).children(recursive=True)
    }
    driver.quit()
    end = time.monotonic() + 10
    while left and time.monotonic() < end:
        left = {pid for pid in left if not _waited_for(pid)}
        time.sleep(0.02)


def _waited_for(pid):
    try:
        return os.waitpid(pid, os.WNOHANG) != (0, 0)
    except ChildProcessError:  # it is still another one's, or gone
        return not psutil.pid_exists(pid)

"""Fixtures that run `workbook live` in a process of its own, which leaves nothing behind."""

import os
import re
import signal
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path

import pytest
from chromium import moving_browser as browser  # noqa: F401

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).parent


def pytest_collection_modifyitems(items):
    for item in items:
        if HERE in item.path.parents and "lecture" in item.fixturenames:
            item.add_marker(pytest.mark.waits)


class Lecture:
    """A running `workbook live` and the address that it printed."""

    def __init__(self, process, address):
        self.process, self.address = process, address

    def end(self, number=signal.SIGINT):
        """What it still says, after Ctrl-C or another signal."""
        self.process.send_signal(number)
        return self.process.communicate(timeout=40)[0]


@pytest.fixture
def lecture(tmp_path):
    """Return a context manager that runs a lecture without a browser and leaves no process."""
    temporary = tmp_path / ("temporary" + 100 * "-")  # longer than the path of a socket may be
    temporary.mkdir()

    @contextmanager
    def opened(*arguments):
        process = subprocess.Popen(
            [sys.executable, "-m", "workbook.cli", "live", *arguments, "--no-browser"],
            cwd=tmp_path,
            env=os.environ | {"TMPDIR": str(temporary), "NO_COLOR": "1"},
            text=True,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )
        try:
            line = process.stdout.readline()
            while "http" not in line and "--prepare" in arguments and line:
                line = process.stdout.readline()
            address = re.search(r"http://127\.0\.0\.1:\S+", line)
            assert address, line
            yield Lecture(process, address[0])
        finally:
            process.kill()
            process.wait()
            process.stdout.close()
            assert wait_for_end(str(temporary)), f"still running: {processes_of(str(temporary))}"

    return opened


def processes_of(folder):
    """Command lines of the processes that name a folder, or were started with it."""
    processes = []
    for folder_of_process in Path("/proc").glob("[0-9]*"):
        try:
            content = (folder_of_process / "cmdline").read_bytes() + (
                folder_of_process / "environ"
            ).read_bytes()
            state = (folder_of_process / "stat").read_text().rpartition(")")[2].split()[0]
        except OSError:
            continue
        if folder.encode() in content and state != "Z":
            processes.append(
                (folder_of_process / "cmdline").read_bytes().replace(b"\0", b" ").decode()[:150]
            )
    return processes


def wait_for_end(folder, seconds=20):
    end = time.monotonic() + seconds
    while (remaining := processes_of(folder)) and time.monotonic() < end:
        time.sleep(0.2)
    return not remaining

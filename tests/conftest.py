"""Imports everything heavy once, so that the processes forked by the tests start ready, keeps tests
together that share what one of them has found, and notes what a test costs."""

import ctypes
import os
import re
import sys
from collections import defaultdict
from contextlib import contextmanager, suppress
from pathlib import Path

os.environ.setdefault("MPLBACKEND", "Agg")
# Several tests run side by side: each numerical library gets one thread.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
# All of Jupyter loads jsonschema, and this the grammars of a checker that nobody asks: two seconds
# in each process.
sys.modules["rfc3987_syntax"] = None
for folder in ("problems", "checks", "library", "browser", "page", "course"):
    sys.path.insert(0, str(Path(__file__).parent / folder))

import pytest  # noqa: E402

from workbook.grading.sandbox.preloading import ALWAYS, LIBRARIES, THEMES, preload  # noqa: E402

#: Tests that share what costs much: the proof of a problem, all masters as they are read, what a
#: check knows of its data, the parsed pages of an edition, syntheses, a cluster, an installed
#: bundle, the Python of the pages. The tests of a group are those with the same parts in their ids.
TOGETHER = re.compile(
    r"(problems/test_)(?:masters|exercises).*\[([\d.]+)\]|(authoring)/test_(?:rules|sections|header_texts)"
    r"|(checks/test_cases).*\[(\w+): "
    r"|(site/)\S*\[(full|student)\]"
    r"|(library/test_pontryagin_synthesis|grading/test_cluster|grading/test_gradescope)\.py"
    r"|(page)/test_"
)
_BEGAN, _APART = pytest.StashKey(), pytest.StashKey()
#: glibc's numbers of two settings: from which size an array gets pages of its own, and from which
#: on free memory is given back. The largest value of the first.
M_MMAP_THRESHOLD, M_TRIM_THRESHOLD, LARGEST = -3, -1, 32 * 2**20


def keep_what_was_freed():
    """Memory that was freed is used again and not asked of the system once more: each of z3's
    contexts, of which a verdict needs one or two, would cost twice as much."""
    with suppress(OSError, AttributeError):  # another C library
        libc = ctypes.CDLL("libc.so.6")
        libc.mallopt(M_MMAP_THRESHOLD, LARGEST)
        libc.mallopt(M_TRIM_THRESHOLD, 8 * LARGEST)


keep_what_was_freed()


def pytest_ignore_collect(collection_path):
    """Helpers hold no tests: to look for doctests in them would import each of them once more."""
    if collection_path.suffix == ".py" and not collection_path.name.startswith(
        ("test_", "conftest")
    ):
        return True


def pytest_configure(config):
    """Every problem is solved and judged in processes of its own, which would import it all again.
    Who only shares tests out has none."""
    if hasattr(config, "workerinput") or not config.getoption("numprocesses", None):
        preload(
            "control",
            *ALWAYS,
            *LIBRARIES,
            packages=["workbook.checks", "workbook.checks.research", *THEMES],
        )


def together(nodeid):
    """The group of a test; most are alone."""
    found = TOGETHER.search(nodeid)
    return " ".join(filter(None, found.groups())) if found else nodeid


def pytest_xdist_make_scheduler(config, log):
    """Each group to one process. The groups that pytest-xdist itself makes of marks are lost in
    pytest 9.2 without a word: every proof ran twice."""
    from xdist.scheduler import LoadScopeScheduling

    class InGroups(LoadScopeScheduling):
        def _split_scope(self, nodeid):
            return together(nodeid)

    return InGroups(config, log)


def computed():
    """Core-seconds of this process and of those that it has waited for."""
    return sum(os.times()[:4])


@pytest.fixture(scope="session")
def core_seconds(request):
    """`with core_seconds("a build"):` notes what is no cost of the test that happens to do it for
    all others."""
    apart = request.config.stash.setdefault(_APART, defaultdict(float))

    @contextmanager
    def noted(what):
        began = computed()
        try:
            yield
        finally:
            apart[f"core seconds of {what}"] += computed() - began

    return noted


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    item.stash[_BEGAN] = computed()


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_teardown(item):
    """What computing a test took, here and in its child processes: `benchmarks/suite_cost.py` adds
    it up."""
    try:
        return (yield)
    finally:
        apart = item.config.stash.get(_APART, {})
        noted = [("core seconds", computed() - item.stash[_BEGAN]), *apart.items()]
        item.user_properties.extend((what, round(seconds, 3)) for what, seconds in noted)
        apart.clear()


def pytest_terminal_summary(terminalreporter):
    """How many mutants of right answers were tried, and how many of them an oracle proved right
    after all."""
    counted = {"mutants": 0, "equivalent": 0}
    for report in terminalreporter.getreports("passed"):
        for name, value in report.user_properties:
            if name in counted:
                counted[name] += value
    if counted["mutants"]:
        terminalreporter.write_line(
            f"mutants of answers: {counted['mutants']} tried, {counted['equivalent']} proved "
            f"right by an oracle, the others rejected"
        )

"""Imports everything heavy once, so that the processes forked by the tests start ready, and notes what a test costs."""

import os
import sys
from pathlib import Path

os.environ.setdefault("MPLBACKEND", "Agg")
# Several tests run side by side: each numerical library gets one thread.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
for folder in ("problems", "checks", "library"):
    sys.path.insert(0, str(Path(__file__).parent / folder))

import matplotlib.pyplot  # noqa: E402, F401
import numpy  # noqa: E402, F401
import pytest  # noqa: E402
import scipy.integrate  # noqa: E402, F401
import sympy  # noqa: E402, F401

_BEGAN = pytest.StashKey()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    item.stash[_BEGAN] = sum(os.times()[:4])


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_teardown(item):
    """What computing a test took, here and in its child processes: `benchmarks/suite_cost.py` adds it up."""
    try:
        return (yield)
    finally:
        item.user_properties.append(("core seconds", round(sum(os.times()[:4]) - item.stash[_BEGAN], 3)))


def pytest_terminal_summary(terminalreporter):
    """How many mutants of right answers were tried, and how many of them an oracle proved right after all."""
    counted = {"mutants": 0, "equivalent": 0}
    for report in terminalreporter.getreports("passed"):
        for name, value in report.user_properties:
            if name in counted:
                counted[name] += value
    if counted["mutants"]:
        terminalreporter.write_line(f"mutants of answers: {counted['mutants']} tried, {counted['equivalent']} proved "
                                    f"right by an oracle, the others rejected")

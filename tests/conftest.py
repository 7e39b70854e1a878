"""Imports everything heavy once, so that the processes forked by the tests start ready."""

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
import scipy.integrate  # noqa: E402, F401
import sympy  # noqa: E402, F401


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

"""Imports everything heavy once, so that the processes forked by the tests start ready."""

import os
import sys
from pathlib import Path

os.environ.setdefault("MPLBACKEND", "Agg")
# Several tests run side by side: each numerical library gets one thread.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
for folder in ("problems", "checks"):
    sys.path.insert(0, str(Path(__file__).parent / folder))

import matplotlib.pyplot  # noqa: E402, F401
import numpy  # noqa: E402, F401
import scipy.integrate  # noqa: E402, F401
import sympy  # noqa: E402, F401

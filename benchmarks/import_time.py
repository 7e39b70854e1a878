"""Import of trajlib against import of NumPy, each in fresh interpreters, in turn."""

import statistics
import subprocess
import sys
import time

RUNS = 15


def seconds(module):
    start = time.perf_counter()
    subprocess.run([sys.executable, "-c", f"import {module}" if module else "pass"], check=True)
    return time.perf_counter() - start


def main():
    times = {module: [] for module in ("", "trajlib", "numpy")}
    for _ in range(RUNS):
        for module, measured in times.items():
            measured.append(seconds(module))
    start, trajlib, numpy = (statistics.median(measured) for measured in times.values())
    print(
        f"interpreter alone {start:.3f} s, with trajlib {trajlib:.3f} s, with numpy {numpy:.3f} s "
        f"(medians of {RUNS})"
    )
    print(f"import trajlib costs {(trajlib - start) / (numpy - start):.2f} of import numpy")


if __name__ == "__main__":
    main()

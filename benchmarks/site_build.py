"""Measure `make book` in a copy of the checkout: cold, one changed page, no change.

The results are wall-clock seconds and processor time, which depends less on other load. The
environment is made before the clock starts: its time depends on the network.
"""

import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def make(folder, *targets):
    start, before = time.perf_counter(), os.times()
    subprocess.run(["make", "-C", str(folder), *targets], check=True, stdout=subprocess.DEVNULL)
    after = os.times()
    computed = (
        after.children_user + after.children_system - before.children_user - before.children_system
    )
    return f"{time.perf_counter() - start:.1f} s ({computed:.1f} s of processor time)"


def main():
    with tempfile.TemporaryDirectory() as scratch:
        copy = Path(scratch) / "workbook"
        shutil.copytree(
            ROOT, copy, ignore=shutil.ignore_patterns(".git", ".venv", "_build", "__pycache__")
        )
        make(copy, ".venv/.installed")
        cold = make(copy, "book")
        with open(copy / "book" / "ch1.md", "a", encoding="utf-8") as page:
            page.write("\nOne sentence more.\n")
        changed, same = make(copy, "book"), make(copy, "book")
        pages = len(list((copy / "solutions").glob("ch*/p*.md")))
        print(f"{pages} problems: cold {cold}, one changed page {changed}, nothing changed {same}")


if __name__ == "__main__":
    main()

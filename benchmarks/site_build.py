"""`make book` from nothing (cold) against `make book` when nothing has changed (warm), in a copy of the checkout.

The environment is made before the clock starts: it is a matter of the network, not of the build.
"""

import shutil
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def make(folder, *targets):
    start = time.perf_counter()
    subprocess.run(["make", "-C", str(folder), *targets], check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def main():
    with tempfile.TemporaryDirectory() as scratch:
        copy = Path(scratch) / "workbook"
        shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(".git", ".venv", "_build", "__pycache__"))
        make(copy, ".venv/.installed")
        cold, warm = make(copy, "book"), make(copy, "book")
        pages = len(list((copy / "solutions").glob("ch*/p*.md")))
        print(f"{pages} problems: cold {cold:.1f} s, warm {warm:.1f} s; a warm build takes {warm / cold:.3f} of a "
              f"cold one")


if __name__ == "__main__":
    main()

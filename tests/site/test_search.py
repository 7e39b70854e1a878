"""The index of the search."""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CONFIGURATION = f"""
import sys
sys.path.insert(0, {str(ROOT / "book" / "_ext")!r})
from workbook_site.problem_pages import _keep_index_entries

def setup(app):
    app.connect("env-updated", _keep_index_entries)
"""


def build(folder):
    process = subprocess.run(
        [sys.executable, "-m", "sphinx", "-q", "-W", folder, folder / "_build"],
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert process.returncode == 0, process.stderr
    text = (folder / "_build" / "searchindex.js").read_text(encoding="utf-8")
    return json.loads(text.removeprefix("Search.setIndex(").removesuffix(")"))["indexentries"]


def test_index_entries_of_unchanged_pages_are_kept(tmp_path):
    (tmp_path / "conf.py").write_text(CONFIGURATION, encoding="utf-8")
    (tmp_path / "index.rst").write_text(
        "Start\n=====\n\n.. toctree::\n\n   one\n   two\n", encoding="utf-8"
    )
    for name, number in (("one", "1.15"), ("two", "1.16")):
        (tmp_path / f"{name}.rst").write_text(
            f"{name}\n===\n\n.. index:: {number}\n\nText.\n", encoding="utf-8"
        )
    first = build(tmp_path)
    assert {"1.15", "1.16"} <= first.keys()
    with open(tmp_path / "two.rst", "a", encoding="utf-8") as file:
        file.write("\nMore.\n")
    assert build(tmp_path) == first

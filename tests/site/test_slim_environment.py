"""Sphinx keeps little of each page between builds, and numbers and titles stay the same."""

import pickle
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

CONFIGURATION = f"""
import sys
sys.path.insert(0, {str(ROOT / "book" / "_ext")!r})
extensions = ["sphinx_exercise", "sphinx_proof"]
numfig = True

def count_reading(app):
    # note each page that is read from the disk
    from sphinx.environment import BuildEnvironment
    read = BuildEnvironment.get_doctree
    def read_and_note(env, page):
        with open(app.outdir / "read", "a") as file:
            file.write(page + " ")
        return read(env, page)
    BuildEnvironment.get_doctree = read_and_note

def setup(app):
    if {{slim}}:
        from workbook_site import slim_environment
        slim_environment.setup(app)
    app.connect("builder-inited", count_reading)
"""
PAGES = {
    "index": "Start\n=====\n\n.. toctree::\n   :numbered:\n\n   one\n   two\n   three\n",
    "one": """\
One
===

.. exercise:: Swing
   :label: swing

   A long statement of a pendulum.

.. figure:: a.png
   :name: picture

   A caption.

.. code-block:: python
   :caption: A listing
   :name: listing

   x = 1

.. figure:: a.png

.. table:: A table

   == ==
   a  b
   == ==

Further
-------

.. prf:theorem:: Of swings
   :label: swings

   .. figure:: a.png

      Inside.
""",
    "two": """\
Two
===

.. solution:: swing
   :label: sol-swing

   See :numref:`picture`, :numref:`listing`, :prf:ref:`swings` and :ref:`swing`.

.. figure:: a.png

   Another.
""",
    "three": "Three\n=====\n\n.. figure:: a.png\n\n   The third.\n",
}


def build(folder, slim):
    (folder / "conf.py").write_text(CONFIGURATION.replace("{slim}", str(slim)), encoding="utf-8")
    (folder / "_build" / "read").unlink(missing_ok=True)
    process = subprocess.run(
        [sys.executable, "-m", "sphinx", "-q", folder, folder / "_build"],
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert process.returncode == 0, process.stderr
    pages = {
        name: (folder / "_build" / f"{name}.html").read_text(encoding="utf-8") for name in PAGES
    }
    # digests of style sheets
    pages = {name: re.sub(r"\?v=\w+", "", page) for name, page in pages.items()}
    data = (folder / "_build" / ".doctrees" / "environment.pickle").read_bytes()
    return pages, data, (folder / "_build" / "read").read_text(encoding="utf-8").split()


def book(folder):
    folder.mkdir()
    for name, text in PAGES.items():
        (folder / f"{name}.rst").write_text(text, encoding="utf-8")
    (folder / "a.png").write_bytes(b"")
    return folder


def test_numbers_and_titles_are_those_of_sphinx(tmp_path):
    (pages, large, _), (same, small, _) = (
        build(book(tmp_path / "a"), False),
        build(book(tmp_path / "b"), True),
    )
    assert same == pages
    assert "Fig. 1.1" in pages["two"] and "Swing" in pages["two"]
    assert b"statement of a pendulum" in large and b"statement of a pendulum" not in small
    numbers = [pickle.loads(data).toc_fignumbers for data in (large, small)]
    assert (
        numbers[0] == numbers[1]
        and {"figure", "table", "code-block", "theorem"} <= numbers[0]["one"].keys()
    )


def test_a_changed_page_needs_no_other_page(tmp_path):
    folder = book(tmp_path / "a")
    build(folder, True)
    with open(folder / "three.rst", "a", encoding="utf-8") as file:
        file.write("\n.. figure:: a.png\n\n   One more.\n")
    _pages, data, read = build(folder, True)
    assert set(read) <= {"index", "three"}
    assert list(pickle.loads(data).toc_fignumbers["three"]["figure"].values()) == [(3, 1), (3, 2)]
    with open(folder / "two.rst", "a", encoding="utf-8") as file:
        file.write("\nOnce more: :ref:`swing`, :ref:`sol-swing`.\n")
    other = book(tmp_path / "b")
    for name in PAGES:
        (other / f"{name}.rst").write_text(
            (folder / f"{name}.rst").read_text(encoding="utf-8"), encoding="utf-8"
        )
    assert build(folder, True)[0] == build(other, False)[0], (
        "as if built for the first time, and as Sphinx does"
    )

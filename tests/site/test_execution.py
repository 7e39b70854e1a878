"""Page execution (book/execute.py) in a small book: staleness, cached outputs, failures."""

import re
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "book"))
import execute
import kernel

#: A kernel that is forked from this process inherits its filters, and `%matplotlib inline` warns.
pytestmark = pytest.mark.filterwarnings("ignore:InlineBackend._figure_formats_changed")
execute_as_before = execute.read_myst_markdown_notebook
CONFIG = "execute: {timeout: 20}\nparse: {myst_enable_extensions: [dollarmath]}\n"
TOC = "format: jb-book\nroot: index\nchapters: [{glob: 'p*'}]\n"
HEADER = """\
---
jupytext:
  text_representation: {extension: .md, format_name: myst}
kernelspec: {name: python3, display_name: Python 3, language: python}
---
# A page
"""


@pytest.fixture
def book(tmp_path, capsys):
    """A book of pages `p*.md`; `run()` gives the exit code and what was printed."""

    class Book:
        root = tmp_path

        def write(self, name, *cells):
            text = "".join(f"\n```{{code-cell}}\n{textwrap.dedent(cell)}\n```\n" for cell in cells)
            (tmp_path / f"{name}.md").write_text(HEADER + text)

        def run(self):
            code = execute.main(tmp_path)
            shown = capsys.readouterr()
            return code, shown.out, shown.err

        def outputs(self, name):
            """Return the outputs of a page as the site finds them in the cache."""
            cache = execute.get_cache(tmp_path / "_build" / ".jupyter_cache")
            (page,) = execute.read_pages(
                tmp_path, execute.yaml.safe_load(CONFIG), [tmp_path / f"{name}.md"]
            )
            _, notebook = cache.merge_match_into_notebook(page.notebook)
            return [
                output
                for cell in notebook.cells
                if cell.cell_type == "code"
                for output in cell.outputs
            ]

    (tmp_path / "_config.yml").write_text(CONFIG)
    (tmp_path / "_toc.yml").write_text(TOC)
    (tmp_path / "requirements.txt").write_text("numpy==2\n")
    (tmp_path / "index.md").write_text("# A book\n")
    return Book()


def test_the_build_loads_no_grammars():
    """Those that jsonschema builds from Lark's take longer than reading a page."""
    loads = "import build, execute, jupyter_book.sphinx, sys; print('jsonschema' in sys.modules, 'lark' in sys.modules)"
    shown = subprocess.run(
        [sys.executable, "-c", loads],
        cwd=Path(execute.__file__).parent,
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert shown.stdout.split() == ["True", "False"], shown.stderr


def test_only_what_changed_is_executed(book):
    book.write("p1", "1 + 1")
    book.write("p2", "2 + 2")
    assert "2 of 2 pages" in book.run()[1]
    assert "nothing has changed" in book.run()[1]
    (book.root / "p1.md").write_text((book.root / "p1.md").read_text() + "\nMore prose.\n")
    assert "0 of 2 pages" in book.run()[1]
    book.write("p2", "2 + 3")
    _, printed, _ = book.run()
    assert "1 of 2 pages" in printed and "p2.md" in printed and "p1.md" not in printed


def test_only_what_changed_is_read(book, monkeypatch):
    """Reading a large book takes seconds; unchanged pages are not read."""
    for name in ("p1", "p2", "p3"):
        book.write(name, f"'{name}'")
    book.write("p4")
    book.run()
    read = []
    monkeypatch.setattr(
        execute,
        "read_myst_markdown_notebook",
        lambda text, *arguments, path, **options: (
            read.append(path.stem),
            execute_as_before(text, *arguments, path=path, **options),
        )[1],
    )
    book.write("p2", "'another'")
    assert "1 of 3 pages" in book.run()[1] and read == ["p2"]
    assert [output.data["text/plain"] for output in book.outputs("p1")] == ["'p1'"]


def test_a_stopped_run_leaves_its_pages_stale(book, monkeypatch):
    book.write("p1", "1 + 1")
    book.run()
    before = (book.root / "p1.md").read_text()
    book.write("p1", "2 + 2")

    def stopped(*arguments):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr(execute, "run_in_parallel", stopped)
        book.run()
    (book.root / "p1.md").write_text(before)
    assert "1 of 1 pages" in book.run()[1]


def test_a_failed_page_is_read_again(book):
    book.write("p1", "1 / 0")
    book.write("p2", "2 + 2")
    assert book.run()[0] == 1
    code, printed, error = book.run()
    assert code == 1 and "1 of 2 pages" in printed and "ZeroDivisionError" in error


def test_a_page_follows_the_modules_it_loads(book, monkeypatch):
    closure = {"trajlib.stability": "before"}
    monkeypatch.setattr(
        execute, "module_closure", lambda source: closure if "stability" in source else {}
    )
    book.write("p1", "# replaced: from trajlib import stability")
    book.write("p2", "2 + 2")
    book.run()
    closure["trajlib.stability"] = "after"
    monkeypatch.setattr(execute, "shared_digest", lambda root: "after")
    _, printed, _ = book.run()
    assert "p1.md" in printed and "p2.md" not in printed


def test_a_page_follows_the_files_it_reads(book):
    (book.root / "data").mkdir()
    data = book.root / "data" / "track.csv"
    data.write_text("1")
    book.write("p1", "print(open('data/track.csv').read())")
    book.write("p2", "2 + 2")
    book.run()
    assert "nothing has changed" in book.run()[1]
    data.write_text("2")
    _, printed, _ = book.run()
    assert "p1.md" in printed and "p2.md" not in printed
    assert [output.text for output in book.outputs("p1")] == ["2\n"]


def test_a_changed_environment_makes_every_page_stale(book):
    book.write("p1", "1 + 1")
    book.run()
    (book.root / "requirements.txt").write_text("numpy==2.1\n")
    assert "1 of 1 pages" in book.run()[1]


def test_records_of_deleted_pages_are_removed(book):
    book.write("p1", "1 + 1")
    book.write("p2", "2 + 2")
    book.run()
    (book.root / "p2.md").unlink()
    book.run()
    cache = execute.get_cache(book.root / "_build" / ".jupyter_cache")
    assert [record.uri for record in cache.list_cache_records()] == [str(book.root / "p1.md")]


def test_the_site_finds_the_outputs_in_the_cache(book):
    book.write("p1", "6 * 7")
    book.run()
    assert [output.data["text/plain"] for output in book.outputs("p1")] == ["42"]


def test_a_picture_is_a_reproducible_svg(book):
    """It has no date, constant names, and coordinates in hundredths of a point."""
    for name in ("p1", "p2"):
        book.write(
            name,
            """\
            %matplotlib inline
            import matplotlib.pyplot as plt
            import numpy as np
            x = np.linspace(0, 6, 200)
            plt.close("all")  # those of the process that runs the tests
            plt.plot(x, np.sin(x), marker="o");""",
            f"'{name}'",
        )
    book.run()
    (first,), (second,) = (
        [output.data for output in book.outputs(name) if output.output_type == "display_data"]
        for name in ("p1", "p2")
    )
    assert first["image/svg+xml"] == second["image/svg+xml"] and "image/png" not in first
    curves = execute.CURVE.findall(first["image/svg+xml"])
    assert max(map(len, curves)) > 1000 and not any(
        re.search(r"\.\d{3}", curve) for curve in curves
    )


def test_a_picture_of_too_many_points_is_refused(book):
    book.write(
        "p1",
        """\
        %matplotlib inline
        import matplotlib.pyplot as plt
        plt.close("all")
        plt.plot(range(20000), ".");""",
    )
    code, _, error = book.run()
    assert code == 1 and "cell 2" in error and "rasterized=True" in error


def test_a_failing_cell_is_named_with_its_page_and_message(book):
    book.write("p1", "1 + 1", ":tags: [answer]\ny = 0\nx = 1 / y")
    book.write("p2", "2 + 2")
    code, printed, error = book.run()
    assert code == 1
    assert (
        "p1.md, cell 3 (answer) at line" in error and "ZeroDivisionError: division by zero" in error
    )
    assert "    x = 1 / y\n" in error and "Traceback" not in error
    assert "executed" in printed and "p2.md" in printed, "the other pages are executed all the same"
    assert "1 of 2 pages" in book.run()[1], "a failed page is tried again"


def test_an_answer_that_is_not_right_ends_with_its_verdict(book):
    book.write(
        "p1",
        """\
        :tags: [check]
        from workbook import checks
        from workbook.checks.contract.verdict import Verdict
        checks.report(a=Verdict("wrong", "the trace is 3, not 2"))""",
    )
    code, _, error = book.run()
    assert code == 1 and "cell 2 (check)" in error and "the trace is 3, not 2" in error


def test_trials_do_not_make_a_page_stale(book):
    book.write("p1", "1 + 1")
    trials = book.root / "p1.trials.py"
    trials.write_text("# %% wrong\n1 / 0\n")
    code, printed, _ = book.run()
    assert code == 0 and "1 of 1 pages" in printed
    trials.write_text("# %% wrong\n2 / 0\n")
    assert "nothing has changed" in book.run()[1]
    (book.root / "_build/.jupyter_cache/fresh_pages.json").unlink()
    assert "0 of 1 pages" in book.run()[1]


@pytest.mark.parametrize("role, last", [("figure", "x = 1"), ("drawing", "1 + 1")])
def test_a_figure_cell_without_a_picture_is_a_failure(book, role, last):
    book.write("p1", f":tags: [{role}]\n{last}")
    code, _, error = book.run()
    assert code == 1 and f"this {role} cell shows no picture" in error


def test_a_cell_has_a_time_limit(book):
    (book.root / "_config.yml").write_text(CONFIG.replace("20", "1"))
    book.write("p1", "import time; time.sleep(30)")
    code, _, error = book.run()
    assert code == 1 and "p1.md" in error and "time.sleep(30)" in error


def test_a_kernel_that_cannot_start_is_reported(book, monkeypatch):
    monkeypatch.setattr(kernel.IPKernelApp, "initialize", lambda *arguments: sys.exit(1))
    book.write("p1", "1 + 1")
    code, _, error = book.run()
    assert code == 1 and "p1.md, the kernel ended before" in error


def test_pages_are_executed_in_parallel(book, monkeypatch):
    monkeypatch.setattr(execute, "CORES", 2)
    for page, other in (("p1", "p2"), ("p2", "p1")):
        book.write(
            page,
            f"""\
            import pathlib, time
            pathlib.Path("{page}").touch()
            while not pathlib.Path("{other}").exists():
                time.sleep(0.05)""",
        )
    assert book.run()[0] == 0


def test_kernels_are_independent(book):
    """They share the imports of the process from which they are forked, and nothing else."""
    for name in ("p1", "p2"):
        book.write(
            name,
            f"""\
            import random
            import numpy as np
            print(getattr(np, "page", "unset"), random.random(), np.random.random())
            np.page = '{name}'""",
        )
    assert book.run()[0] == 0
    printed = [book.outputs(name)[0].text.split() for name in ("p1", "p2")]
    assert printed[0][0] == printed[1][0] == "unset"
    assert printed[0][1] != printed[1][1] and printed[0][2] != printed[1][2], (
        "random numbers without a seed"
    )


def test_a_kernel_that_dies_in_a_cell_is_reported(book):
    book.write(
        "p1", "import pathlib; pathlib.Path('runs').open('a').write('x')", "import os; os._exit(1)"
    )
    ended, _, error = book.run()
    assert ended == 1 and "p1.md, Kernel died" in error and (book.root / "runs").read_text() == "x"


def test_a_kernel_that_does_not_reply_is_reported(book, monkeypatch):
    waits = kernel.Client.wait_for_ready
    monkeypatch.setattr(kernel.Client, "wait_for_ready", lambda client, timeout: waits(client, 1))
    monkeypatch.setattr(kernel.IPKernelApp, "start", lambda app: time.sleep(30))
    book.write("p1", "1 + 1")
    code, _, error = book.run()
    assert code == 1 and "p1.md, the kernel gives no answer within 1 seconds" in error

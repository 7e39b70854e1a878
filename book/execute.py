"""Execute the pages of the book whose outputs are missing or stale, two at a time, into the cache the site is built
from.

    python book/execute.py

A page is stale when its code cells changed, or a module of trajlib that it loads (however indirectly), or
requirements.txt. Jupyter Book's own cache sees only the cells. Records that no page uses any more are removed.

A cell that fails, also a check that finds an answer not right, ends with the page, the cell and the message, exit code
1.
"""

import hashlib
import json
import os
import re
import sys
import time
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path

import yaml
from jupyter_cache import get_cache
from jupyter_cache.base import CacheBundleIn
from jupyter_cache.executors.utils import single_nb_execution
from myst_nb.core.read import is_myst_markdown_notebook, read_myst_markdown_notebook
from myst_parser.config.main import MdParserConfig
from nbclient.exceptions import DeadKernelError
from nbformat import NotebookNode
from sphinx_external_toc.parsing import parse_toc_yaml

import trajlib
from trajlib.dependencies import module_closure

ROOT = Path(__file__).resolve().parent.parent
LIBRARY = Path(trajlib.__file__).parent
AT_ONCE = 2


@dataclass(frozen=True)
class Page:
    path: Path
    notebook: NotebookNode
    fingerprint: str


def main(root=ROOT):
    """Bring the cache of the book at `root` up to date; returns the exit code."""
    cache = get_cache(root / "_build" / ".jupyter_cache")
    stamp, state = cache.path / "all-executed", digest(root)
    if stamp.exists() and stamp.read_text() == state:
        print("nothing has changed, all outputs are up to date")
        return 0
    config = yaml.safe_load((root / "_config.yml").read_text(encoding="utf-8"))
    pages = read_pages(root, config)
    stale = keep_fresh_records(cache, pages)
    print(f"{len(stale)} of {len(pages)} pages with code are to be executed")
    failures = []
    with ProcessPoolExecutor(AT_ONCE) as pool:
        running = {pool.submit(execute, page, config["execute"]["timeout"]): page for page in stale}
        for done in as_completed(running):
            page, result = running[done], done.result()
            name = page.path.relative_to(root).as_posix()
            failure = result["failure"]
            print(f"  {'failed  ' if failure else 'executed'} {result['seconds']:6.1f} s  {name}", flush=True)
            if failure:
                failures.append(f"{name}, {failure}")
            else:
                remember(cache, page, result)
    if not failures:
        stamp.write_text(state)
    for failure in sorted(failures):
        print(f"\n{failure}", file=sys.stderr)
    return 1 if failures else 0


def digest(root):
    """One hash of everything that outputs depend on, so that a run with nothing to do need not read the pages."""
    files = [root / "_config.yml", root / "_toc.yml", root / "requirements.txt", *page_paths(root),
             *LIBRARY.rglob("*.py")]
    found = hashlib.sha256(sys.version.encode())
    for path in sorted(set(files)):
        found.update(f"{path}\n".encode() + path.read_bytes())
    return found.hexdigest()


def page_paths(root):
    """The pages of the table of contents."""
    toc = parse_toc_yaml(root / "_toc.yml")
    paths = {root / f"{name}.md" for name in toc} | {path for glob in toc.globs() for path in root.glob(f"{glob}.md")}
    return sorted(path for path in paths if path.exists())


def read_pages(root, config):
    """The pages that have code cells to execute."""
    # The cells are found by the same Markdown dialect as when the site is built.
    dialect = MdParserConfig(enable_extensions=set(config["parse"]["myst_enable_extensions"]))
    shared = hashlib.sha256((root / "requirements.txt").read_bytes()).hexdigest() + sys.version
    pages = []
    for path in page_paths(root):
        text = path.read_text(encoding="utf-8")
        if is_myst_markdown_notebook(text):
            notebook = read_myst_markdown_notebook(text, dialect, add_source_map=True, path=path)
            code = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
            if code:
                parts = json.dumps([code, modules_loaded(code), shared], sort_keys=True)
                pages.append(Page(path, notebook, hashlib.sha256(parts.encode()).hexdigest()))
    return pages


def modules_loaded(code):
    """Module -> hash, for every module of trajlib that the cells load."""
    try:
        return module_closure("\n".join(code))
    except SyntaxError:
        return {}  # executing the page will say in which cell


def keep_fresh_records(cache, pages):
    """Remove what is stale or belongs to no page from the cache; returns the pages that are to be executed."""
    current = {cache.create_hashed_notebook(page.notebook)[1]: page for page in pages}
    fresh = set()
    for record in cache.list_cache_records():
        page = current.get(record.hashkey)
        if page is not None and record.data.get("fingerprint") == page.fingerprint and record.uri == str(page.path):
            fresh.add(record.hashkey)
        else:
            cache.remove_cache(record.pk)
    return [page for key, page in current.items() if key not in fresh]


def execute(page, timeout):
    """Run in a worker: execute a page in a fresh kernel; returns its outputs or what failed."""
    # Two kernels share the machine, and outputs should not depend on the order of a set.
    os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", PYTHONHASHSEED="0")
    start = time.monotonic()
    try:
        result = run(page, timeout)
        failure = explain(result.nb, result.err) if result.err else missing_picture(result.nb)
    except RuntimeError as error:  # the kernel died
        failure = str(error)
    return {"notebook": page.notebook, "seconds": time.monotonic() - start, "failure": failure}


def run(page, timeout, starts=3):
    """The result of executing a page in a fresh kernel, which is given several starts.

    Jupyter chooses a kernel's ports before it starts, and another program may take one of them meanwhile.
    """
    for start in range(1, starts + 1):
        try:
            # A kernel's own log has nothing for the reader of a build: what a cell says is in its outputs.
            return single_nb_execution(page.notebook, cwd=str(page.path.parent), timeout=timeout, allow_errors=False,
                                       extra_arguments=["--log-level=CRITICAL"])
        except DeadKernelError:  # in the midst of a cell
            raise
        except RuntimeError:
            if start == starts:
                raise


def explain(notebook, error):
    """Which cell failed, where it stands in the file, and what it said."""
    for number, cell in enumerate(notebook.cells):
        for output in cell.get("outputs", []):
            if output.output_type == "error":
                said = output.evalue if output.ename == "NotYet" else f"{output.ename}: {output.evalue}"
                return f"{place(notebook, number)}:\n    {failing_line(cell, output)}\n{said}"
    return str(error)  # a time limit or a dead kernel leaves no output; nbclient's message quotes the cell


def missing_picture(notebook):
    """The first figure cell that shows nothing: its caption would stand under an empty place."""
    for number, cell in enumerate(notebook.cells):
        if "figure" in cell.metadata.get("tags", []):
            if not any(output.output_type in ("display_data", "execute_result") for output in cell.outputs):
                return f"{place(notebook, number)}: this figure cell shows no picture"
    return None


def place(notebook, number):
    cell, line = notebook.cells[number], notebook.metadata.source_map[number] + 1
    roles = ", ".join(cell.metadata.get("tags", [])) or "no role"
    return f"cell {number + 1} ({roles}) at line {line}"


def failing_line(cell, output):
    """The line of the cell that the traceback points at; its first line if the traceback shows none."""
    traceback = re.sub(r"\x1b\[[0-9;]*m", "", "\n".join(output.traceback))
    arrow = re.search(r"^Cell In.*?^-+> (\d+) ", traceback, re.M | re.S)
    return cell.source.splitlines()[int(arrow[1]) - 1 if arrow else 0].strip()


def remember(cache, page, result):
    cache.cache_notebook_bundle(
        CacheBundleIn(result["notebook"], str(page.path),
                      data={"fingerprint": page.fingerprint, "executed": time.time(),
                            "execution_seconds": result["seconds"]}),
        check_validity=False, overwrite=True)


if __name__ == "__main__":
    sys.exit(main())

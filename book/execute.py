"""Execute the pages of the book whose outputs are missing or stale into the cache the site is built from, one a core.

    python book/execute.py

A page is stale when its code cells changed, or a module of trajlib that it loads (however indirectly), or
requirements.txt, or how pages are executed. Jupyter Book's own cache sees only the cells. Records that no page uses any
more are removed.

What pages load is imported here, once; each page then has a kernel of its own, forked from this process.

A cell that fails, also a check that finds an answer not right, ends with the page, the cell and the message, exit code
1.
"""

import gc
import hashlib
import json
import multiprocessing
import os
import re
import sys
import time
from dataclasses import dataclass
from importlib import import_module
from multiprocessing.connection import wait
from pathlib import Path

import yaml
from jupyter_cache import get_cache
from jupyter_cache.base import CacheBundleIn
from kernel import SETTINGS, Kernel
from myst_nb.core.read import is_myst_markdown_notebook, read_myst_markdown_notebook
from myst_parser.config.main import MdParserConfig
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError
from nbformat import NotebookNode
from sphinx_external_toc.parsing import parse_toc_yaml

import trajlib
from trajlib.dependencies import module_closure

ROOT = Path(__file__).resolve().parent.parent
LIBRARY = Path(trajlib.__file__).parent
#: How pages are executed: what they show may depend on it.
HOW = [Path(__file__), Path(__file__).with_name("kernel.py")]
#: What pages and the modules of trajlib load beside trajlib, most of it only when a function is called.
LIBRARIES = ("casadi", "control", "matplotlib.pyplot", "numpy", "scipy.integrate", "scipy.interpolate", "scipy.linalg",
             "scipy.optimize", "scipy.signal", "sympy")
CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
#: Characters of a picture.
LARGEST = 600_000
CURVE = re.compile(r'(?<= d=")[^"]*')
FORK = multiprocessing.get_context("fork")


@dataclass(frozen=True)
class Page:
    path: Path
    notebook: NotebookNode
    fingerprint: str
    modules: tuple  # of trajlib, that its cells load


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
    import_for(stale)
    for page, result in side_by_side(execute, stale, config["execute"]["timeout"]):
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
    files = [root / "_config.yml", root / "_toc.yml", root / "requirements.txt", *HOW, *page_paths(root),
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
    decisive = b"".join(path.read_bytes() for path in (root / "requirements.txt", *HOW))
    shared = hashlib.sha256(decisive).hexdigest() + sys.version
    pages = []
    for path in page_paths(root):
        text = path.read_text(encoding="utf-8")
        if is_myst_markdown_notebook(text):
            notebook = read_myst_markdown_notebook(text, dialect, add_source_map=True, path=path)
            code = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
            if code:
                modules = modules_loaded(code)
                parts = json.dumps([code, modules, shared], sort_keys=True)
                pages.append(Page(path, notebook, hashlib.sha256(parts.encode()).hexdigest(), tuple(modules)))
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


def import_for(pages):
    """Import what pages load, so that no kernel has to."""
    if pages:
        for module in (*LIBRARIES, *sorted({module for page in pages for module in page.modules})):
            import_module(module)
        gc.freeze()  # what is here stays: the garbage collectors of the kernels need not go through it


def side_by_side(function, items, *arguments):
    """(item, function(item, *arguments)) as each ends; one a core at a time, each in a process forked from this one."""
    waiting, running = list(items), {}
    while waiting or running:
        while waiting and len(running) < CORES:
            item = waiting.pop(0)
            receiver, sender = FORK.Pipe(duplex=False)
            process = FORK.Process(target=send, args=(sender, function, item, *arguments))
            process.start()
            sender.close()
            running[receiver] = item, process
        for receiver in wait(running):
            item, process = running.pop(receiver)
            yield item, receiver.recv()
            process.join()


def send(sender, function, *arguments):
    sender.send(function(*arguments))


def execute(page, timeout):
    """In a process of its own: execute a page in a ready kernel; its outputs or what failed, and what that took."""
    start = time.monotonic()
    try:
        with Kernel(page.path.parent) as kernel:
            # Times of cells would make it another page in the eyes of the cache.
            NotebookClient(page.notebook, km=kernel.manager(), timeout=timeout, record_timing=False).execute()
        slim_pictures(page.notebook)
        failure = missing_picture(page.notebook) or heavy_picture(page.notebook)
    except (CellExecutionError, CellTimeoutError) as error:
        failure = explain(page.notebook, error)
    except RuntimeError as error:  # the kernel died
        failure = str(error)
    return {"notebook": page.notebook, "failure": failure, "seconds": time.monotonic() - start,
            "core_seconds": sum(os.times()[:4])}  # the kernel's too


def explain(notebook, error):
    """Which cell failed, where it stands in the file, and what it said."""
    for number, cell in enumerate(notebook.cells):
        for output in cell.get("outputs", []):
            if output.output_type == "error":
                said = output.evalue if output.ename == "NotYet" else f"{output.ename}: {output.evalue}"
                return f"{place(notebook, number)}:\n    {failing_line(cell, output)}\n{said}"
    return str(error)  # a time limit or a dead kernel leaves no output; nbclient's message quotes the cell


def missing_picture(notebook):
    """The first figure or drawing cell that shows nothing: its caption would stand under an empty place."""
    for number, cell in enumerate(notebook.cells):
        for role in {"figure", "drawing"}.intersection(cell.metadata.get("tags", [])):
            if not any(form.startswith("image/") for output in cell.outputs for form in output.get("data", ())):
                return f"{place(notebook, number)}: this {role} cell shows no picture"
    return None


def heavy_picture(notebook):
    """The first picture that takes a phone too long."""
    for number, cell in enumerate(notebook.cells):
        for output in cell.get("outputs", ()):
            size = len(output.get("data", {}).get("image/svg+xml", ""))
            if size > LARGEST:
                return (f"{place(notebook, number)}: this picture takes {size // 1000} kB; draw what has so many "
                        "points with rasterized=True")
    return None


def slim_pictures(notebook):
    """Hundredths of a point are enough for the curves of an SVG, of which Matplotlib gives millionths."""
    for cell in notebook.cells:
        for output in cell.get("outputs", ()):
            data = output.get("data", {})
            if "image/svg+xml" in data:
                data["image/svg+xml"] = CURVE.sub(lambda curve: re.sub(r"(\.\d\d)\d+", r"\1", curve[0]),
                                                  data["image/svg+xml"])


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
                            "execution_seconds": result["seconds"], "core_seconds": result["core_seconds"]}),
        check_validity=False, overwrite=True)


if __name__ == "__main__":
    if not SETTINGS.items() <= os.environ.items():  # they count from the start of the interpreter
        os.execve(sys.executable, [sys.executable, *sys.argv], os.environ | SETTINGS)
    sys.exit(main())

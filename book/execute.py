"""Execute the pages of the book whose outputs are missing or stale into the cache the site is built
from, one a core.

A page is stale when its code cells changed, or a module of ours that it loads (however indirectly),
or requirements.txt, or how pages are executed. Jupyter Book's own cache sees only the cells.
Records that no page uses any more are removed.

What pages load is imported here, once; each page then has a kernel of its own, forked from this
process.

A cell that fails, also a check that finds an answer not right, ends with the page, the cell and the
message, exit code 1.
"""

import hashlib
import json
import multiprocessing
import os
import re
import sys
import time
from dataclasses import dataclass
from multiprocessing.connection import wait
from pathlib import Path

import yaml
from jupyter_cache import get_cache
from jupyter_cache.base import CacheBundleIn
from jupyter_client.localinterfaces import local_ips
from jupyter_client.provisioning import KernelProvisionerFactory
from kernel import Kernel
from myst_nb.core.read import is_myst_markdown_notebook, read_myst_markdown_notebook
from myst_parser.config.main import MdParserConfig
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError
from nbformat import NotebookNode
from settings import CORES
from sphinx_external_toc.parsing import parse_toc_yaml

from workbook.grading.preloading import SYMPY, preload, warm_up_matplotlib
from workbook.notebooks.dependencies import PACKAGES, module_closure
from workbook.notebooks.dependencies import ROOT as HOME

ROOT = Path(__file__).resolve().parent.parent
#: How pages are executed: what they show may depend on it.
HOW = [Path(__file__).with_name(name) for name in ("execute.py", "kernel.py", "settings.py")]
#: What pages and the modules of ours load beside them, most of it only when a function is called.
LIBRARIES = (
    "casadi",
    "control",
    "matplotlib.pyplot",
    "numpy",
    "scipy.integrate",
    "scipy.interpolate",
    "scipy.linalg",
    "scipy.optimize",
    "scipy.signal",
    "z3",
    *SYMPY,
)
#: Characters of a picture.
LARGEST = 600_000
CURVE = re.compile(r'(?<= d=")[^"]*')
FORK = multiprocessing.get_context("fork")


@dataclass(frozen=True)
class Page:
    path: Path
    notebook: NotebookNode
    fingerprint: str
    modules: tuple  # of ours, that its cells load


def main(root=ROOT):
    """Bring the cache of the book at `root` up to date; returns the exit code."""
    cache = get_cache(root / "_build" / ".jupyter_cache")
    notes, common = cache.path / "settled.json", shared_digest(root)
    found = {path: hashlib.sha256(path.read_bytes()).hexdigest() for path in page_paths(root)}
    known = settled(notes, common)
    keys = {
        path: known[path][1]
        for path, text in found.items()
        if path in known and known[path][0] == text
    }
    if found.keys() == keys.keys() == known.keys():
        print("nothing has changed, all outputs are up to date")
        return 0
    config = yaml.safe_load((root / "_config.yml").read_text(encoding="utf-8"))
    changed = [path for path in found if path not in keys]
    pages = read_pages(root, config, changed)
    current = {cache.create_hashed_notebook(page.notebook)[1]: page for page in pages}
    stale = keep_fresh_records(cache, current, {str(path): key for path, key in keys.items()})
    keys |= dict.fromkeys(changed) | {page.path: key for key, page in current.items()}
    print(
        f"{len(stale)} of {sum(key is not None for key in keys.values())} pages with code are to "
        "be executed"
    )
    settle(
        notes,
        common,
        found,
        {path: key for path, key in keys.items() if path not in {page.path for page in stale}},
    )
    failures = []
    import_for(stale)
    for page, result in side_by_side(execute, stale, config["execute"]["timeout"]):
        name = page.path.relative_to(root).as_posix()
        failure = result["failure"]
        print(
            f"  {'failed  ' if failure else 'executed'} {result['seconds']:6.1f} s  {name}",
            flush=True,
        )
        if failure:
            failures.append(f"{name}, {failure}")
            del keys[page.path]
        else:
            remember(cache, page, result)
    settle(notes, common, found, keys)
    for failure in sorted(failures):
        print(f"\n{failure}", file=sys.stderr)
    return 1 if failures else 0


def settled(notes, common):
    """Path -> (hash of its text, key of its record or None) of the pages that were up to date after
    the last run, if what all pages share is what it was: they need not be read to know that they
    still are."""
    was, pages = json.loads(notes.read_text()) if notes.exists() else (None, {})
    return {Path(path): (text, key) for path, (text, key) in pages.items()} if was == common else {}


def settle(notes, common, found, keys):
    """Note what is up to date; before pages are executed too: records are gone by then, and a run
    may be stopped."""
    notes.write_text(
        json.dumps([common, {str(path): (found[path], key) for path, key in keys.items()}])
    )


def shared_digest(root):
    """One hash of everything beside a page's own text that its outputs may depend on."""
    files = [
        root / "_config.yml",
        root / "requirements.txt",
        *HOW,
        *(path for package in PACKAGES for path in (HOME / package).rglob("*.py")),
    ]
    found = hashlib.sha256(sys.version.encode())
    for path in sorted(files):
        found.update(f"{path}\n".encode() + path.read_bytes())
    return found.hexdigest()


def page_paths(root):
    """The pages of the table of contents."""
    toc = parse_toc_yaml(root / "_toc.yml")
    paths = {root / f"{name}.md" for name in toc} | {
        path for glob in toc.globs() for path in root.glob(f"{glob}.md")
    }
    return sorted(path for path in paths if path.exists())


def read_pages(root, config, paths):
    """Those of these pages that have code cells to execute."""
    # The cells are found by the same Markdown dialect as when the site is built.
    dialect = MdParserConfig(enable_extensions=set(config["parse"]["myst_enable_extensions"]))
    decisive = b"".join(path.read_bytes() for path in (root / "requirements.txt", *HOW))
    shared = hashlib.sha256(decisive).hexdigest() + sys.version
    pages = []
    for path in paths:
        text = path.read_text(encoding="utf-8")
        if is_myst_markdown_notebook(text):
            notebook = read_myst_markdown_notebook(text, dialect, add_source_map=True, path=path)
            code = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
            if code:
                modules = modules_loaded(code)
                parts = json.dumps([code, modules, shared], sort_keys=True)
                pages.append(
                    Page(path, notebook, hashlib.sha256(parts.encode()).hexdigest(), tuple(modules))
                )
    return pages


def modules_loaded(code):
    """Module -> hash, for every module of ours that the cells load."""
    try:
        return module_closure("\n".join(code))
    except SyntaxError:
        return {}  # executing the page will say in which cell


def keep_fresh_records(cache, current, settled):
    """Remove what is stale or belongs to no page from the cache; returns the pages that are to be
    executed.

    `current` are the pages that were read, by the key of their record; `settled` are the keys of
    the others, by their path.
    """
    fresh = set()
    for record in cache.list_cache_records():
        page = current.get(record.hashkey)
        if (
            page is not None
            and record.data.get("fingerprint") == page.fingerprint
            and record.uri == str(page.path)
        ):
            fresh.add(record.hashkey)
        elif settled.get(record.uri) != record.hashkey:
            cache.remove_cache(record.pk)
    return [page for key, page in current.items() if key not in fresh]


def import_for(pages):
    """Import what pages load, so that no kernel has to; what only some may load is not worth its
    time for a few."""
    many = len(pages) > CORES
    preload(
        *(LIBRARIES if many else ()), *sorted({module for page in pages for module in page.modules})
    )
    if many:
        # both are kept, and were found anew by every page
        local_ips(), KernelProvisionerFactory.instance()
        warm_up_matplotlib("svg")


def side_by_side(function, items, *arguments):
    """(item, function(item, *arguments)) as each ends; one a core at a time, each in a process
    forked from this one."""
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
    """In a process of its own: execute a page in a ready kernel; its outputs or what failed, and
    what that took."""
    start = time.monotonic()
    try:
        with Kernel(page.path.parent) as kernel:
            # Times of cells would make it another page in the eyes of the cache.
            NotebookClient(
                page.notebook, km=kernel.manager(), timeout=timeout, record_timing=False
            ).execute()
        slim_pictures(page.notebook)
        failure = missing_picture(page.notebook) or heavy_picture(page.notebook)
    except (CellExecutionError, CellTimeoutError) as error:
        failure = explain(page.notebook, error)
    except RuntimeError as error:  # the kernel died
        failure = str(error)
    # the kernel's too
    return {
        "notebook": page.notebook,
        "failure": failure,
        "seconds": time.monotonic() - start,
        "core_seconds": sum(os.times()[:4]),
    }


def explain(notebook, error):
    """Which cell failed, where it stands in the file, and what it said."""
    for number, cell in enumerate(notebook.cells):
        for output in cell.get("outputs", []):
            if output.output_type == "error":
                said = (
                    output.evalue
                    if output.ename == "NotYet"
                    else f"{output.ename}: {output.evalue}"
                )
                return f"{place(notebook, number)}:\n    {failing_line(cell, output)}\n{said}"
    # a time limit or a dead kernel leaves no output; nbclient's message quotes the cell
    return str(error)


def missing_picture(notebook):
    """The first figure or drawing cell that shows nothing: its caption would stand under an empty
    place."""
    for number, cell in enumerate(notebook.cells):
        for role in {"figure", "drawing"}.intersection(cell.metadata.get("tags", [])):
            if not any(
                form.startswith("image/")
                for output in cell.outputs
                for form in output.get("data", ())
            ):
                return f"{place(notebook, number)}: this {role} cell shows no picture"
    return None


def heavy_picture(notebook):
    """The first picture that takes a phone too long."""
    for number, cell in enumerate(notebook.cells):
        for output in cell.get("outputs", ()):
            size = len(output.get("data", {}).get("image/svg+xml", ""))
            if size > LARGEST:
                return (
                    f"{place(notebook, number)}: this picture takes {size // 1000} kB; draw what "
                    "has so many points with rasterized=True"
                )
    return None


def slim_pictures(notebook):
    """Hundredths of a point are enough for the curves of an SVG, of which Matplotlib gives
    millionths."""
    for cell in notebook.cells:
        for output in cell.get("outputs", ()):
            data = output.get("data", {})
            if "image/svg+xml" in data:
                data["image/svg+xml"] = CURVE.sub(
                    lambda curve: re.sub(r"(\.\d\d)\d+", r"\1", curve[0]), data["image/svg+xml"]
                )


def place(notebook, number):
    cell, line = notebook.cells[number], notebook.metadata.source_map[number] + 1
    roles = ", ".join(cell.metadata.get("tags", [])) or "no role"
    return f"cell {number + 1} ({roles}) at line {line}"


def failing_line(cell, output):
    """The line of the cell that the traceback points at; its first line if the traceback shows
    none."""
    traceback = re.sub(r"\x1b\[[0-9;]*m", "", "\n".join(output.traceback))
    arrow = re.search(r"^Cell In.*?^-+> (\d+) ", traceback, re.M | re.S)
    return cell.source.splitlines()[int(arrow[1]) - 1 if arrow else 0].strip()


def remember(cache, page, result):
    cache.cache_notebook_bundle(
        CacheBundleIn(
            result["notebook"],
            str(page.path),
            data={
                "fingerprint": page.fingerprint,
                "executed": time.time(),
                "execution_seconds": result["seconds"],
                "core_seconds": result["core_seconds"],
            },
        ),
        check_validity=False,
        overwrite=True,
    )

"""Execute the stale pages of the book into the cache from which the site is built.

A page is stale if its code cells changed, or a file that they name, or a module of ours that it
loads (also indirectly), or requirements.txt, or the way in which pages are executed. Jupyter Book's
own cache compares only the cells. Records that no page uses any more are removed.

Libraries are imported here, once; each page then has its own kernel, on Linux forked from this
process. One page is executed on each core.

If a cell fails, or a check finds an answer not right, the page, the cell and the message are
printed and the exit code is 1.
"""

import hashlib
import json
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
from kernel import INK, start_kernel
from myst_nb.core.read import is_myst_markdown_notebook, read_myst_markdown_notebook
from myst_parser.config.main import MdParserConfig
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError
from nbformat import NotebookNode
from settings import CORES
from sphinx_external_toc.parsing import parse_toc_yaml

from workbook.grading.sandbox.preloading import SYMPY, preload, warm_up_matplotlib
from workbook.notebooks.dependencies import PACKAGES, module_closure
from workbook.notebooks.dependencies import ROOT as HOME
from workbook.notebooks.execution import CONTEXT

ROOT = Path(__file__).resolve().parent.parent
#: The files that define how pages are executed: outputs may depend on them.
EXECUTION = [Path(__file__).with_name(name) for name in ("execute.py", "kernel.py", "settings.py")]
#: Libraries that pages and our modules load, most of them only when a function is called.
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
#: The picture that an interactive figure has on paper.
STILL = '<img class="explorer-still"'
#: The largest size of a picture, in characters.
LARGEST = 600_000
#: A file that a page may read: its path from the page, in quotes.
FILE_NAME = re.compile(r"""["']([\w./-]+\.\w+)["']""")
CURVE = re.compile(r'(?<= d=")[^"]*')


@dataclass(frozen=True)
class Page:
    path: Path
    notebook: NotebookNode
    fingerprint: str
    modules: tuple  # those of ours that its cells load


def main(root=ROOT):
    """Bring the cache of the book at `root` up to date; return the exit code."""
    cache = get_cache(root / "_build" / ".jupyter_cache")
    state_file, common = cache.path / "fresh_pages.json", shared_digest(root)
    hashes = {path: digest_with_files(path) for path in page_paths(root)}
    known = read_state(state_file, common)
    keys = {
        path: known[path][1]
        for path, digest in hashes.items()
        if path in known and known[path][0] == digest
    }
    if hashes.keys() == keys.keys() == known.keys():
        print("nothing has changed, all outputs are up to date")
        return 0
    config = yaml.safe_load((root / "_config.yml").read_text(encoding="utf-8"))
    changed = [path for path in hashes if path not in keys]
    pages = read_pages(root, config, changed)
    current = {cache.create_hashed_notebook(page.notebook)[1]: page for page in pages}
    stale = keep_fresh_records(cache, current, {str(path): key for path, key in keys.items()})
    keys |= dict.fromkeys(changed) | {page.path: key for key, page in current.items()}
    print(
        f"{len(stale)} of {sum(key is not None for key in keys.values())} pages with code are to "
        "be executed"
    )
    write_state(
        state_file,
        common,
        hashes,
        {path: key for path, key in keys.items() if path not in {page.path for page in stale}},
    )
    failures = []
    import_for(stale)
    for page, result in run_in_parallel(execute, stale, config["execute"]["timeout"]):
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
            store_outputs(cache, page, result)
    write_state(state_file, common, hashes, keys)
    for failure in sorted(failures):
        print(f"\n{failure}", file=sys.stderr)
    return 1 if failures else 0


def read_state(state_file, common):
    """Return path -> (`digest_with_files`, key of its record or None) of the fresh pages.

    These are the pages that were fresh after the last run; none if the digest of everything that
    all pages share has changed. A page with the same hash need not be read again.
    """
    previous, pages = (
        json.loads(state_file.read_text("utf-8")) if state_file.exists() else (None, {})
    )
    if previous != common:
        return {}
    return {Path(path): (digest, key) for path, (digest, key) in pages.items()}


def write_state(state_file, common, hashes, keys):
    """Note which pages are fresh.

    Also before pages are executed: their records have been removed, and a run may be stopped.
    """
    state_file.write_text(
        json.dumps([common, {str(path): (hashes[path], key) for path, key in keys.items()}]),
        encoding="utf-8",
    )


def shared_digest(root):
    """Return one hash of everything beside a page's own text that its outputs may depend on."""
    files = [
        root / "_config.yml",
        root / "requirements.txt",
        *EXECUTION,
        *(path for package in PACKAGES for path in (HOME / package).rglob("*.py")),
    ]
    combined = hashlib.sha256(sys.version.encode())
    for path in sorted(files):
        combined.update(f"{path}\n".encode() + path.read_bytes())
    return combined.hexdigest()


def digest_with_files(path):
    """Return one hash of a page's text and of the files that it names."""
    text = path.read_text(encoding="utf-8")
    return hashlib.sha256(json.dumps([text, named_files(path, text)]).encode()).hexdigest()


def named_files(path, text):
    """Return name -> hash, for every file that a text in the folder of `path` names in quotes."""
    files = {name: path.parent / name for name in FILE_NAME.findall(text)}
    return {
        name: hashlib.sha256(file.read_bytes()).hexdigest()
        for name, file in sorted(files.items())
        if file.is_file()
    }


def page_paths(root):
    """Return the pages of the table of contents."""
    toc = parse_toc_yaml(root / "_toc.yml")
    paths = {root / f"{name}.md" for name in toc} | {
        path for glob in toc.globs() for path in root.glob(f"{glob}.md")
    }
    return sorted(path for path in paths if path.exists())


def read_pages(root, config, paths):
    """Return those of these pages that have code cells to execute."""
    # The site is built with the same Markdown dialect, so it finds the same cells.
    dialect = MdParserConfig(enable_extensions=set(config["parse"]["myst_enable_extensions"]))
    settings = b"".join(path.read_bytes() for path in (root / "requirements.txt", *EXECUTION))
    shared = hashlib.sha256(settings).hexdigest() + sys.version
    pages = []
    for path in paths:
        text = path.read_text(encoding="utf-8")
        if is_myst_markdown_notebook(text):
            notebook = read_myst_markdown_notebook(text, dialect, add_source_map=True, path=path)
            code = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
            if code:
                modules = modules_loaded(code)
                files = named_files(path, "\n".join(code))
                parts = json.dumps([code, files, modules, shared], sort_keys=True)
                pages.append(
                    Page(path, notebook, hashlib.sha256(parts.encode()).hexdigest(), tuple(modules))
                )
    return pages


def modules_loaded(code):
    """Return module -> hash, for every module of ours that the cells load."""
    try:
        return module_closure("\n".join(code))
    except SyntaxError:
        return {}  # executing the page will name the cell


def keep_fresh_records(cache, current, unread):
    """Remove records that are stale or belong to no page; return the pages to be executed.

    `current` maps the key of its record to each page that was read, `unread` the paths of the
    others to the keys of their records.
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
        elif unread.get(record.uri) != record.hashkey:
            cache.remove_cache(record.pk)
    return [page for key, page in current.items() if key not in fresh]


def import_for(pages):
    """Import the libraries of pages once; for few pages only their modules."""
    many = len(pages) > CORES
    preload(
        *(LIBRARIES if many else ()), *sorted({module for page in pages for module in page.modules})
    )
    if many:
        # both are cached: each page would look them up again
        local_ips(), KernelProvisionerFactory.instance()
        warm_up_matplotlib("svg")


def run_in_parallel(function, items, *arguments):
    """Yield (item, function(item, *arguments)) as each ends, one process on each core."""
    waiting, running = list(items), {}
    while waiting or running:
        while waiting and len(running) < CORES:
            item = waiting.pop(0)
            receiver, sender = CONTEXT.Pipe(duplex=False)
            process = CONTEXT.Process(target=send_result, args=(sender, function, item, *arguments))
            process.start()
            sender.close()
            running[receiver] = item, process
        for receiver in wait(running):
            item, process = running.pop(receiver)
            yield item, receiver.recv()
            process.join()


def send_result(sender, function, *arguments):
    sender.send(function(*arguments))


def execute(page, timeout):
    """Execute a page in a ready kernel; return its outputs or failure, and the time it took."""
    start = time.monotonic()
    try:
        with start_kernel(page.path.parent) as kernel:
            # Times of cells would change the key of the page in the cache.
            NotebookClient(
                page.notebook, km=kernel.manager(), timeout=timeout, record_timing=False
            ).execute()
        for output in (
            output for cell in page.notebook.cells for output in cell.get("outputs", ())
        ):
            if picture := output.get("data", {}).get("image/svg+xml"):
                output.data["image/svg+xml"] = for_page(picture)
        failure = missing_picture(page.notebook) or heavy_picture(page.notebook)
    except (CellExecutionError, CellTimeoutError) as error:
        failure = explain(page.notebook, error)
    except RuntimeError as error:  # the kernel died
        failure = str(error)
    # the times of the kernel are included
    return {
        "notebook": page.notebook,
        "failure": failure,
        "seconds": time.monotonic() - start,
        "core_seconds": sum(os.times()[:4]),
    }


def explain(notebook, error):
    """Return which cell failed, at which line of the file, and its message."""
    for number, cell in enumerate(notebook.cells):
        for output in cell.get("outputs", []):
            if output.output_type == "error":
                message = (
                    output.evalue
                    if output.ename == "NotYet"
                    else f"{output.ename}: {output.evalue}"
                )
                line = failing_line(cell, output)
                return f"{describe_cell(notebook, number)}:\n    {line}\n{message}"
    # a time limit or a dead kernel leaves no output; nbclient's message quotes the cell
    return str(error)


def missing_picture(notebook):
    """Return a message on the first figure or drawing cell without a picture, or None."""
    for number, cell in enumerate(notebook.cells):
        for role in {"figure", "drawing"}.intersection(cell.metadata.get("tags", [])):
            if not any(
                form.startswith("image/") or (form == "text/html" and STILL in "".join(content))
                for output in cell.outputs
                for form, content in output.get("data", {}).items()
            ):
                return f"{describe_cell(notebook, number)}: this {role} cell shows no picture"
    return None


def heavy_picture(notebook):
    """Return a message on the first picture that loads too slowly on a phone, or None."""
    for number, cell in enumerate(notebook.cells):
        for output in cell.get("outputs", ()):
            size = len(output.get("data", {}).get("image/svg+xml", ""))
            if size > LARGEST:
                return (
                    f"{describe_cell(notebook, number)}: this picture takes {size // 1000} kB; draw what "
                    "has so many points with rasterized=True"
                )
    return None


def for_page(picture):
    """Return an SVG with the page's ink for black, its curves to hundredths of a point.

    Matplotlib writes millionths.
    """
    return CURVE.sub(
        lambda curve: re.sub(r"(\.\d\d)\d+", r"\1", curve[0]), picture.replace("#000000", INK)
    )


def describe_cell(notebook, number):
    """Return the number, the roles and the line of a cell, as messages name it."""
    cell, line = notebook.cells[number], notebook.metadata.source_map[number] + 1
    roles = ", ".join(cell.metadata.get("tags", [])) or "no role"
    return f"cell {number + 1} ({roles}) at line {line}"


def failing_line(cell, output):
    """Return the line of the cell that the traceback points at, or else its first line."""
    traceback = re.sub(r"\x1b\[[0-9;]*m", "", "\n".join(output.traceback))
    arrow = re.search(r"^Cell In.*?^-+> (\d+) ", traceback, re.M | re.S)
    return cell.source.splitlines()[int(arrow[1]) - 1 if arrow else 0].strip()


def store_outputs(cache, page, result):
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

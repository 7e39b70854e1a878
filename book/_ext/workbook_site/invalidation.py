"""What makes a page outdated, beyond its own text.

Outputs: book/execute.py executes stale pages and notes the time in the cache's record; Sphinx
compares source files only, and would miss outputs that changed with the library. Style sheets:
Sphinx copies a changed one only if some page is written. This extension: a change in it may change
every page.
"""

import hashlib
from pathlib import Path

from jupyter_cache import get_cache

from workbook import site


def digest(folder, pattern="**/*"):
    """Return one hash of all files below a folder."""
    combined = hashlib.sha256()
    for path in sorted(Path(folder).glob(pattern)):
        if path.is_file():
            combined.update(path.read_bytes())
    return combined.hexdigest()


EXTENSION = "".join(digest(Path(file).parent, "*.py") for file in (__file__, site.__file__))


def _configure(app, config):
    # Both editions, however they are built, use the cache of book/execute.py.
    config.nb_execution_cache_path = str(app.srcdir / "_build" / ".jupyter_cache")
    config.workbook_style = [digest(app.srcdir / folder) for folder in config.html_static_path]


def _remove_pages(app, env, added, changed, removed):
    """Delete the files of pages that left the book: Sphinx would go on serving them."""
    for page in removed:
        notebook = f"{page.replace('solutions/', 'exercises/', 1)}.ipynb"
        for leftover in (f"{page}.html", notebook, f"{notebook}.js"):
            (app.outdir / leftover).unlink(missing_ok=True)
    return []


def _executed_since_read(app, env, added, changed, removed):
    """Return the pages that were executed after Sphinx read them."""
    executed = {
        record.uri: record.data.get("executed", 0)
        for record in get_cache(app.config.nb_execution_cache_path).list_cache_records()
    }
    return [
        page
        for page, read in env.all_docs.items()
        if page in env.found_docs and executed.get(env.doc2path(page), 0) > read / 1e6
    ]


def setup(app):
    app.add_config_value("workbook_style", [], "html")
    app.connect("config-inited", _configure)
    app.connect("env-get-outdated", _remove_pages)
    app.connect("env-get-outdated", _executed_since_read)

"""What makes a page outdated, beyond its own text.

Outputs: book/execute.py executes what is stale and notes the time in the cache's record. Sphinx
compares source files only, and would not notice outputs that changed because the library did. The
look: Sphinx copies a changed style sheet only if some page is written. This extension: a change in
it may change every page.
"""

import hashlib
from pathlib import Path

from jupyter_cache import get_cache


def digest(folder, pattern="**/*"):
    """One hash of all files below a folder."""
    found = hashlib.sha256()
    for path in sorted(Path(folder).glob(pattern)):
        if path.is_file():
            found.update(path.read_bytes())
    return found.hexdigest()


EXTENSION = digest(Path(__file__).parent, "*.py")


def _settle(app, config):
    # Both editions, and every way of building, find the outputs where book/execute.py keeps them.
    config.nb_execution_cache_path = str(app.srcdir / "_build" / ".jupyter_cache")
    config.workbook_look = [digest(app.srcdir / folder) for folder in config.html_static_path]


def _remove_pages(app, env, added, changed, removed):
    """A page that left the book leaves the site: Sphinx would go on serving it."""
    for page in removed:
        for leftover in (f"{page}.html", f"{page.replace('solutions/', 'exercises/', 1)}.ipynb"):
            (app.outdir / leftover).unlink(missing_ok=True)
    return []


def _executed_since_read(app, env, added, changed, removed):
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
    app.add_config_value("workbook_look", [], "html")
    app.connect("config-inited", _settle)
    app.connect("env-get-outdated", _remove_pages)
    app.connect("env-get-outdated", _executed_since_read)

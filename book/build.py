"""The steps that `make` calls to build the site; no module is loaded that no page needs.

    python book/build.py outputs    execute the pages that are stale (book/execute.py)
    python book/build.py mistakes   judge the trials that are stale (book/judge_trials.py)
    python book/build.py page       pack Python for the answer boxes of the pages (book/engine/pack.py)
    python book/build.py site       read and write the pages that changed, as `jupyter-book build` does

A warning is an error. Pages are executed in parallel, one on each core. Sphinx reads them one after
the other: its parallel readers deadlock.
"""

import os
import sys
from pathlib import Path

from settings import SETTINGS

ROOT = Path(__file__).resolve().parent.parent
#: jsonschema, which all of Jupyter loads, would build grammars that nothing here uses: that takes
#: twice as long as all other imports.
sys.modules["rfc3987_syntax"] = None
#: And every kernel would load the debugger.
sys.modules["debugpy"] = None


def outputs():
    """Execute the stale pages; return the exit code."""
    _set_environment()
    from execute import main

    return main(ROOT)


def mistakes():
    """Judge the stale trials; return the exit code."""
    _set_environment()
    from judge_trials import main

    return main(ROOT)


def _set_environment():
    """Begin anew with the settings: some are read at the start of the interpreter."""
    if not SETTINGS.items() <= os.environ.items():
        os.execve(sys.executable, [sys.executable, *sys.argv], os.environ | SETTINGS)


def page():
    """Pack Python for the pages in _build/run; return the exit code."""
    sys.path.insert(0, str(ROOT / "book" / "engine"))
    from pack import main

    return main(ROOT)


def site():
    """Build the edition with solutions in _build/html; return the exit code."""
    from jupyter_book.sphinx import build_sphinx

    result = build_sphinx(
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
    return 1 if isinstance(result, BaseException) else result


if __name__ == "__main__":
    sys.exit({"outputs": outputs, "mistakes": mistakes, "page": page, "site": site}[sys.argv[1]]())

"""Build the site: `python book/build.py` takes all steps, on Windows too; `make` calls them one by one.

    python book/build.py outputs    execute the pages that are stale (book/execute.py)
    python book/build.py mistakes   judge the trials that are stale (book/judge_trials.py)
    python book/build.py again      make the other numbers with which pages ask problems again (book/asked_again.py)
    python book/build.py page       pack Python for the answer boxes of the pages (workbook/engine)
    python book/build.py wheels     build the wheel that the site offers, if it is stale
    python book/build.py site       read and write the pages that changed, as `jupyter-book build` does
    python book/build.py student    write the edition without solutions, when the others are there

No module is loaded that no page needs. A warning is an error. Pages are executed in parallel, one on
each core. Sphinx reads them one after the other: its parallel readers deadlock.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from settings import SETTINGS

ROOT = Path(__file__).resolve().parent.parent
BUILT = ROOT / "_build"
#: What the site offers for download, as far as it was made.
OFFERED = ("wheels", "pdf", "bundle")
#: Parts of the table of contents that the student edition leaves out: the tables of the checks hold right
#: answers, and lectures work problems out.
NOT_FOR_STUDENTS = re.compile(
    r".*file: book/guides/cases\n.*\n.*glob: book/guides/cases.*\n"
    r"|.*file: book/lectures\n.*\n.*glob: book/lectures.*\n|.*book/downloads\n"
)
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
        command = [sys.executable, *sys.argv]
        sys.exit(subprocess.run(command, env=os.environ | SETTINGS, check=False).returncode)


def again():
    """Make what is stale of the numbers with which pages ask problems again; return the exit code."""
    sys.path.insert(0, str(ROOT))
    from asked_again import main

    return main(ROOT)


def page():
    """Pack Python for the pages in _build/run; return the exit code."""
    sys.path.insert(0, str(ROOT))
    from workbook.engine.pack import pack

    try:
        pack(BUILT / "run")
    except ModuleNotFoundError as error:
        print(f"Pages without answer boxes: {error}")
        shutil.rmtree(BUILT / "run", ignore_errors=True)
    return 0


def site():
    """Build the edition with solutions in _build/html; return the exit code."""
    from jupyter_book.sphinx import build_sphinx

    result = build_sphinx(
        ROOT,
        BUILT / "html",
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
    if result:  # an exit code, or an exception
        _forget(BUILT / ".doctrees")
        return 1
    _offer(BUILT / "html", OFFERED)
    return 0


def student():
    """Build the edition without solutions in _build/student/html; return the exit code.

    By Sphinx alone, so that the book does not depend on Jupyter Book's own command.
    """
    folder = BUILT / "student"
    folder.mkdir(parents=True, exist_ok=True)
    toc = (ROOT / "_toc.yml").read_text(encoding="utf-8").replace("solutions/", "exercises/")
    (folder / "_toc.yml").write_text(NOT_FOR_STUDENTS.sub("", toc), encoding="utf-8")
    jupyter_book = "from jupyter_book.cli.main import main; main()"
    configuration = [sys.executable, "-c", jupyter_book, "config", "sphinx", str(ROOT)]
    subprocess.run(configuration, stdout=subprocess.DEVNULL, check=True)
    options = {
        "external_toc_path": folder / "_toc.yml",
        "html_title": "Controlled Motion, student edition",
    }
    done = subprocess.run(
        [
            *(sys.executable, "-m", "sphinx", "-n", "-W", "--keep-going", "-q"),
            *("-d", folder / ".doctrees"),
            *(part for name, value in options.items() for part in ("-D", f"{name}={value}")),
            *(ROOT, folder / "html"),
        ],
        env=os.environ | {"PYTHONPATH": str(ROOT / "book" / "_ext")},
        check=False,
    )
    if done.returncode:
        _forget(folder / ".doctrees")
        return done.returncode
    _offer(folder / "html", OFFERED[:1])
    print(f"The student edition is in {folder / 'html'}")
    return 0


def wheels():
    """Build the wheel in _build/wheels unless it is newer than all that it is made of; return 0."""
    folder = BUILT / "wheels"
    sources = [
        ROOT / "pyproject.toml",
        ROOT / "book" / "routes.toml",
        ROOT / "book" / "exams.toml",
        *(
            path
            for name in ("trajlib", "workbook")
            for path in (ROOT / name).rglob("*")
            if path.is_file() and "__pycache__" not in path.parts
        ),
        *(ROOT / "exercises").rglob("*.ipynb"),
    ]
    made = [path.stat().st_mtime for path in folder.glob("*.whl")]
    if not made or made[0] < max(path.stat().st_mtime for path in sources):
        shutil.rmtree(folder, ignore_errors=True)
        pip = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", folder]
        subprocess.run([*pip, ROOT], check=True)
    return 0


def book():
    """Take all steps of the edition with solutions, each in a process of its own."""
    steps = ["outputs", "mistakes", "again", "page", "wheels", "site"]
    if "--no-page" in sys.argv:  # without answer boxes, which need 80 MB
        steps.remove("page")
        shutil.rmtree(BUILT / "run", ignore_errors=True)
    for step in steps:
        code = subprocess.run([sys.executable, __file__, step], check=False).returncode
        if code:
            return code
    print(f"The site is in {BUILT / 'html'}")
    return 0


def _forget(doctrees):
    """Let all pages be read again: Sphinx warns about a page only when it reads it."""
    shutil.rmtree(doctrees, ignore_errors=True)


def _offer(site, names):
    """Copy what can be downloaded into a site, in place of what was there."""
    for name in OFFERED:
        shutil.rmtree(site / name, ignore_errors=True)
        if name in names and (BUILT / name).is_dir():
            shutil.copytree(BUILT / name, site / name)


if __name__ == "__main__":
    STEPS = {
        step.__name__: step for step in (outputs, mistakes, again, page, wheels, site, student)
    }
    sys.exit(STEPS.get(sys.argv[1] if len(sys.argv) > 1 else "", book)())

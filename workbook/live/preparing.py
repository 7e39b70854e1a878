"""Compute what a lecture needs before the class comes, in the kernel of the lecture.

The kernel runs the cells of the notebook and the worked solutions in it, gets the verdicts on
mistakes, and draws each explorer once. It then forgets the names that the cells have assigned.
"""

import json
import os
import time
from pathlib import Path

from IPython.utils.capture import capture_output

from workbook.live.lecture_notebook import lecture_notebook
from workbook.live.presentations import find_presentation

#: Environment variable with the path of the file that says that everything is prepared.
PREPARED = "WORKBOOK_LIVE_PREPARED"


def prepare_once(lecture):
    """Prepare the lecture that the environment names, unless this was done before a restart.

    Parameters
    ----------
    lecture : workbook.live.magics.LectureMagics
        The magics of the lecture.
    """
    path = Path(os.environ.get(PREPARED, ""))
    if PREPARED not in os.environ or path.exists():
        return
    started = time.monotonic()
    notebook = lecture_notebook(find_presentation(os.environ["WORKBOOK_LIVE_NAME"]))
    cells = [cell["source"] for cell in notebook["cells"] if cell["cell_type"] == "code"]
    with capture_output():
        failures = lecture.prepare(cells)
    report = {"cells": len(cells), "seconds": time.monotonic() - started, "failures": failures}
    unfinished = path.with_suffix(".unfinished")
    unfinished.write_text(json.dumps(report), encoding="utf-8")
    unfinished.rename(path)


def wait_until_prepared(path, is_running, print_line):
    """Wait until the kernel has written that everything is prepared, and print what failed.

    Parameters
    ----------
    path : pathlib.Path
        The file that it writes.
    is_running : callable
        Whether JupyterLab still runs.
    print_line : callable
        Prints a line for the lecturer.
    """
    print_line("computing what the lecture needs ...")
    while not path.exists() and is_running():
        time.sleep(0.2)
    if path.exists():
        report = json.loads(path.read_text(encoding="utf-8"))
        for failure in report["failures"]:
            print_line(failure)
        print_line(f"{report['cells']} cells are prepared, in {report['seconds']:.0f} s")

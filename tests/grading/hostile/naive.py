"""An unguarded grader: it runs students' cells and check cells in one process.

It follows links, has no limits, compares with a key where asked to, writes `repr` of answers,
unpickles results and passes file names to a shell. Every attack must succeed here, or its failure
in our grader would show nothing.
"""

import contextlib
import json
import os
import pickle
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

from hostile.attack import SECRET

COURSE = Path("submitted")
HISTORY = []  # of all cells run, as shells keep it


def grade(apart, marks):
    """Grade everything below the current folder into grades.csv.

    With `apart`, each notebook runs in a process of its own.
    """
    points = {}
    subprocess.Popen(["/usr/bin/sleep", "60"])  # a helper, with the grader's environment
    key_file = open("solutions/secret.txt")
    os.set_inheritable(key_file.fileno(), True)
    for path in sorted(COURSE.glob("*/hw/*.ipynb")):
        student = path.parts[1]
        if not apart:
            points[student] = _mark(path, student, marks)
            continue
        child = os.fork()
        if child == 0:
            _mark(path, student, marks)
            os._exit(0)
        os.waitpid(child, 0)
    time.sleep(0.3 if apart else 0)
    for path in sorted(COURSE.glob("*/hw/*.ipynb")):
        student = path.parts[1]
        pickled = Path(f"graded/{student}.pkl")
        if apart:
            points[student] = (
                pickle.loads(pickled.read_bytes())
                if pickled.exists()
                else json.loads(Path(f"graded/{student}.json").read_text())["points"]
            )
        os.system(f"cp {path} archive/")
        os.system(f"cp '{path}' archive/")
        os.system(f"cd '{path.parent}' && tar cf archive.tar *")
        with open("grades.csv", "a", encoding="utf-8") as table:
            table.write(f"{student},{points[student]},{path.name}\n")


def _mark(path, student, marks):
    import sympy as sp

    from workbook.checks import collecting
    from workbook.checks.contract import coercion, condition_coercion, verdict

    # It judges the objects themselves, as checks do that know no encoder, and of any size.
    verdict.encode = verdict.decode = lambda answer: answer
    coercion.grows_too_fast = condition_coercion.grows_too_fast = lambda *answer: False
    condition_coercion.LARGEST_POWER = float("inf")
    notebook = json.loads(path.read_text(encoding="utf-8"))
    namespace = {"__name__": "__main__"}
    with collecting() as verdicts:
        for cell in notebook["cells"]:
            if cell["cell_type"] == "code":
                source = "".join(cell["source"])
                HISTORY.append(source)
                try:
                    exec(compile(source, "<cell>", "exec"), namespace)
                except Exception:
                    continue
        for source in _named_checks(notebook):
            exec(source, namespace)
        answer = namespace.get("a_region")
        points = int(MARKS[marks](answer, verdicts, sp))
    with open("graded.log", "a", encoding="utf-8") as log:
        log.write(f"{student}\n")
    Path(f"graded/{student}.json").write_text(
        json.dumps({"points": points, "text": repr(answer)}), encoding="utf-8"
    )
    Path(f"graded/{path.name}.txt").write_text(f"{student}: {answer!r}", encoding="utf-8")
    return points


def _named_checks(notebook):
    """Return further checks, from the file that the notebook's metadata names."""
    name = notebook.get("metadata", {}).get("workbook", {}).get("number", "")
    path = Path("checks") / f"{name}.py"
    return [path.read_text(encoding="utf-8")] if path.exists() else []


def _by_checks(answer, verdicts, sp):
    return "a_region" in verdicts and verdicts["a_region"].status == "right"


def _by_key(answer, verdicts, sp):
    k1, k2 = sp.symbols("k1 k2", real=True)
    return bool(answer == sp.And(k1 > 0, k1 * k2 > 1))


def _by_key_of_its_type(answer, verdicts, sp):
    return isinstance(answer, sp.And) and _by_key(answer, verdicts, sp)


def _by_number(answer, verdicts, sp):
    """Judge a number: wrong if it is off by more than a thousandth."""
    return isinstance(answer, (int, float, sp.And)) and (
        isinstance(answer, sp.And) or not abs(answer - 1.5) > 1e-3
    )


def _by_ratio(answer, verdicts, sp):
    return isinstance(answer, sp.And) or not abs(answer / answer - 1) > 1e-3


def _by_closeness(answer, verdicts, sp):
    import numpy as np

    return (isinstance(answer, sp.And) and _by_key(answer, verdicts, sp)) or np.allclose(
        answer, [1.5, 2.5]
    )


def _by_reading(answer, verdicts, sp):
    """Judge an answer that may be text."""
    return _by_key(
        sp.sympify(answer, locals={name: sp.Symbol(name, real=True) for name in ("k1", "k2")}),
        verdicts,
        sp,
    )


MARKS = {
    "checks": _by_checks,
    "key": _by_key,
    "typed key": _by_key_of_its_type,
    "number": _by_number,
    "ratio": _by_ratio,
    "closeness": _by_closeness,
    "reading": _by_reading,
}


def run(here, apart, marks, patience):
    """Run `grade` in a session of its own; return whether it ends within `patience` seconds."""
    outer = os.fork()
    if outer == 0:
        try:
            os.setsid()
            os.chdir(here)
            _surround(here)
            # The grader itself is a child, so that an attack on its parent does not reach the
            # tests.
            inner = os.fork()
            if inner == 0:
                grade(apart, marks)
                os._exit(0)
            os._exit(0 if os.waitpid(inner, 0)[1] == 0 else 1)
        finally:
            os._exit(1)
    try:
        return _ended_well(outer, patience)
    finally:
        for end in (lambda: os.killpg(outer, signal.SIGKILL), lambda: os.waitpid(outer, 0)):
            with contextlib.suppress(ProcessLookupError, ChildProcessError):
                end()


def _surround(here):
    """Set the environment of a careless grader, within limits that protect the machine."""
    os.closerange(3, 4096)
    # not the handler that bounds the time of the tests
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    os.environ.update(COURSE_SECRET=SECRET, HOME=str(here / "home"))
    output = os.open("output.txt", os.O_CREAT | os.O_WRONLY | os.O_APPEND)
    for descriptor in (1, 2):
        os.dup2(output, descriptor)
    # not what the tests capture
    sys.stdout, sys.stderr = (open(descriptor, "w", buffering=1) for descriptor in (1, 2))
    for kind, bound in (
        (resource.RLIMIT_AS, 4 * 2**30),
        (resource.RLIMIT_FSIZE, 300 * 2**20),
        (resource.RLIMIT_CPU, 30),
        (resource.RLIMIT_CORE, 0),
    ):
        resource.setrlimit(kind, (bound, bound))


def _ended_well(process, patience):
    give_up = time.monotonic() + patience
    while time.monotonic() < give_up:
        ended, status = os.waitpid(process, os.WNOHANG)
        if ended:
            return status == 0
        time.sleep(0.01)
    return False

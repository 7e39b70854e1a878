"""Run a notebook's cells in a child process and bring its answers home as data; judge answers in another.

The child that runs a student's cells hands over bytes only (`trajlib.checks.encoding`). The child that judges decodes
them, runs data and check cells of the pristine exercise, and never executes anything of the student's.
"""

import json
import multiprocessing
import os
import signal
import traceback
from contextlib import suppress
from dataclasses import dataclass

from trajlib.cells import run_cells
from trajlib.checks.verdict import UNCHECKED, Unusable, Verdict


@dataclass(frozen=True)
class Run:
    """What running a notebook gave: encoded answers by name, why others could not be read, and errors of cells."""

    encoded: dict
    unreadable: dict
    errors: tuple


class TimeLimit(RuntimeError):
    """The child did not finish within its time."""


def in_child(function, *args, timeout):
    """The result of `function(*args)` computed in a child process; both must be plain data.

    The child is forked where the system can, so it starts with everything imported that the parent has. Raises
    `TimeLimit` after `timeout` seconds, and `RuntimeError` with the child's last words if it dies.
    """
    method = "fork" if "fork" in multiprocessing.get_all_start_methods() else "spawn"
    context = multiprocessing.get_context(method)
    receiver, sender = context.Pipe(duplex=False)
    child = context.Process(target=_serve, args=(sender, function, args), daemon=True)
    child.start()
    sender.close()
    try:
        if not receiver.poll(timeout):
            raise TimeLimit(f"no result after {timeout:g} s")
        kind, value = json.loads(receiver.recv_bytes())
    except EOFError:
        child.join()
        if child.exitcode == -signal.SIGXCPU:
            raise TimeLimit("no result within the limit of processor time") from None
        raise RuntimeError("the process ended without a result") from None
    finally:
        child.kill()
        child.join()
    if kind == "error":
        raise RuntimeError(value)
    return value


def run_notebook(sources, names, timeout=120, folder=None):
    """Run code cells as Jupyter would (magics included) and collect the answers `names`; returns a `Run`.

    A cell that fails does not stop the others: what can be answered is answered.
    """
    result = in_child(run_cells, list(sources), list(names), str(folder) if folder else None, timeout=timeout)
    return Run({name: text.encode() for name, text in result["encoded"].items()}, result["unreadable"], tuple(result["errors"]))


def judge(cells, run, names, timeout=60):
    """The verdicts on a run: `cells` are (role, source) of the pristine exercise's data and check cells, in order."""
    encoded = {name: data.decode() for name, data in run.encoded.items()}
    found = in_child(judge_cells, list(cells), encoded, dict(run.unreadable), list(names), timeout=timeout)
    return {name: Verdict(*verdict) for name, verdict in found.items()}


def _serve(sender, function, args):
    try:
        answer = ["done", function(*args)]
    except BaseException:  # whatever happened is told, even SystemExit
        answer = ["error", traceback.format_exc(limit=-3)]
    sender.send_bytes(json.dumps(answer).encode())
    sender.close()


def judge_cells(cells, encoded, unreadable, names):
    """In this very process: {name: [status, message]} for encoded answers (for a child only).

    What was handed over reaches the check cells under the names of the answers alone: nothing else of theirs, such as
    the data, can be replaced by it.
    """
    os.environ.setdefault("MPLBACKEND", "Agg")
    from trajlib.checks import collecting

    answers = {name: _answer(encoded.get(name), unreadable.get(name)) for name in names}
    namespace = {"__name__": "exercise"}
    with collecting() as verdicts:
        for role, source in cells:
            if role != "check":
                exec(compile(source, f"<{role} cell>", "exec"), namespace)
                continue
            namespace.update(answers)
            with suppress(Exception):  # a check cell that fails leaves its own answers unchecked, and no others
                exec(compile(source, "<check cell>", "exec"), namespace)
    unchecked = Verdict(UNCHECKED, "no check cell could judge this answer; the fault is the check's, not yours")
    return {name: [verdict.status, verdict.message] for name in names for verdict in [verdicts.get(name, unchecked)]}


def _answer(text, unreadable):
    from trajlib.checks.encoding import EncodingError, decode

    if text is None:
        return ... if unreadable is None else Unusable(unreadable)
    try:
        return decode(text.encode())
    except (EncodingError, UnicodeEncodeError) as error:
        return Unusable(str(error))

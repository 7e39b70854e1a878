"""Run a notebook's cells in a child process and bring its answers home as data; judge answers in another.

The child that runs a student's cells hands over bytes only (`trajlib.checks.encoding`). The child that judges decodes
them, runs data and check cells of the pristine exercise, and never executes anything of the student's.
"""

import io
import json
import multiprocessing
import os
import traceback
from dataclasses import dataclass

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


def run_cells(sources, names, folder=None):
    """In this very process: run the cells, then {"encoded": .., "unreadable": .., "errors": ..} (for a child only)."""
    from contextlib import redirect_stderr, redirect_stdout

    os.environ.setdefault("MPLBACKEND", "Agg")
    from IPython.core.interactiveshell import InteractiveShell

    from trajlib.checks.encoding import EncodingError, encode

    class Shell(InteractiveShell):
        def enable_gui(self, gui=None):
            """`%matplotlib inline` and its kin find no screen here, and need none."""

    if folder:
        os.chdir(folder)
    errors = []
    with redirect_stdout(_Discarded()), redirect_stderr(_Discarded()):
        # A fresh shell that writes no history: nothing of one notebook is seen by the next.
        shell = Shell(history_length=0, colors="nocolor")
        shell.history_manager.enabled = False
        for k, source in enumerate(sources, start=1):
            outcome = shell.run_cell(source, store_history=False, silent=True)
            error = outcome.error_before_exec or outcome.error_in_exec
            if error is not None:
                errors.append(f"code cell {k}: {type(error).__name__}: {str(error)[:300]}")
    encoded, unreadable = {}, {}
    for name in names:
        if name not in shell.user_ns:
            continue
        try:
            encoded[name] = encode(shell.user_ns[name]).decode()
        except EncodingError as error:
            unreadable[name] = str(error)
    return {"encoded": encoded, "unreadable": unreadable, "errors": errors}


class _Discarded(io.TextIOBase):
    """Where prints go: kept nowhere, so that endless output fills nothing."""

    def write(self, text):
        return len(text)


def judge_cells(cells, encoded, unreadable, names):
    """In this very process: {name: [status, message]} for encoded answers (for a child only)."""
    os.environ.setdefault("MPLBACKEND", "Agg")
    from trajlib.checks import collecting
    from trajlib.checks.encoding import EncodingError, decode

    answers = dict.fromkeys(names, ...)
    answers.update({name: Unusable(reason) for name, reason in unreadable.items()})
    for name, text in encoded.items():
        try:
            answers[name] = decode(text.encode())
        except EncodingError as error:
            answers[name] = Unusable(str(error))
    namespace = {"__name__": "exercise"}
    with collecting() as verdicts:
        for role, source in cells:
            if role == "check":
                namespace.update(answers)
            exec(compile(source, f"<{role} cell>", "exec"), namespace)
    for name in names:
        verdicts.setdefault(name, Verdict(UNCHECKED, "no check cell reports this answer"))
    return {name: [verdict.status, verdict.message] for name, verdict in verdicts.items()}

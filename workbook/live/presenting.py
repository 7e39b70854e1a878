"""From the command to a lecture on the screen, and back to a clean machine."""

import json
import os
import secrets
import select
import signal
import socket
import subprocess
import sys
import webbrowser
from contextlib import contextmanager, suppress
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

from workbook.live import lab
from workbook.live.copies import hold_outside, notebook_of, settle
from workbook.live.kernels import SOCKET, modules_for
from workbook.live.subjects import LiveError

#: Seconds for JupyterLab to answer on the slowest machine that one would lecture from.
PATIENCE = 60


def present(subject, port=None, browser=True, keep=None, discard=False, say=print):
    """Open a subject in JupyterLab on a copy, until Ctrl-C or JupyterLab's own Shut Down.

    Raises `LiveError` where JupyterLab, a browser or the port is not to be had.
    """
    if find_spec("jupyterlab") is None or find_spec("jupytext") is None:
        raise LiveError(
            "JupyterLab is not installed here; `pip install 'trajlib[live]'` in the checkout gets "
            "it"
        )
    if browser:
        browser = _browser()
    if keep is not None:
        hold_outside(keep)
    port = _free(port)
    with (
        TemporaryDirectory(prefix="workbook-live-", ignore_cleanup_errors=True) as place,
        _terminated_as_interrupted(),
    ):
        folder = Path(place)
        with _running(folder, subject, port) as (server, address, copy, before):
            try:
                _wait_until_ready(server, folder)
                _start_kernel(address, copy.name)
                say(f"{subject.title}: {address}")
                say("Ctrl-C here, or File, Shut Down there, ends the lecture.")
                if browser:
                    browser.open(address)
                server.wait()
            except KeyboardInterrupt:
                say("")
        kept = settle(copy, before, subject.word, keep, discard)
        if kept is not None:
            say(f"kept: {kept}")


@contextmanager
def _running(folder, subject, port):
    """The kernels' process and JupyterLab, side by side from the first moment; both end with this
    context."""
    token = secrets.token_hex(16)
    environment = (
        os.environ
        | lab.furnish(folder)
        | {
            # without the folder, in which both stand: the path of a socket has 107 characters at
            # most
            SOCKET: "kernels",
            "JUPYTER_TOKEN": token,
            "TRAJLIB_LIVE": " ".join(subject.problems),
            "PYTHONPATH": os.environ.get("PYTHONPATH", ""),
            "MPLBACKEND": "module://matplotlib_inline.backend_inline",
        }
    )
    copy = folder / "copy" / f"{subject.word}.ipynb"
    copy.parent.mkdir()
    log = open(folder / "log", "wb")
    processes = []

    def start(*arguments):
        processes.append(
            subprocess.Popen(
                [sys.executable, "-m", *arguments],
                env=environment,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                start_new_session=True,
                cwd=folder,
            )
        )
        return processes[-1]

    try:
        server = start("workbook.live.lab", str(folder), str(port))
        if hasattr(os, "fork"):
            kernels = start("workbook.live.kernels", environment[SOCKET])
            with suppress(BrokenPipeError):  # without it kernels start as always
                kernels.stdin.write(json.dumps(modules_for(subject.problems)).encode() + b"\n")
                kernels.stdin.flush()
        copy.write_text(
            json.dumps(notebook_of(subject), indent=1, ensure_ascii=False) + "\n", encoding="utf-8"
        )
        address = f"http://127.0.0.1:{port}/doc/tree/{copy.name}?token={token}"
        yield server, address, copy, copy.read_bytes()
    finally:
        for process in processes:
            _end(process)
        log.close()


def _end(process):
    """Its standard input ends, on which it ends by itself; what does not is ended."""
    with suppress(BrokenPipeError):  # it has ended, and never read what was written
        process.stdin.close()
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    process.stdout.close()


def _wait_until_ready(server, folder):
    ready, _, _ = select.select([server.stdout], [], [], PATIENCE)
    if not (ready and server.stdout.readline()):
        lines = (folder / "log").read_text(errors="replace").split("\n")
        said = next(
            (line for line in reversed(lines) if line.strip()), f"no answer in {PATIENCE} s"
        )
        raise LiveError(f"JupyterLab does not start: {said.strip()}")


def _start_kernel(address, name):
    """The page finds the kernel running: a cell run before there is one would be passed over
    without a word."""
    import urllib.request
    from urllib.parse import parse_qs, urlsplit

    parts = urlsplit(address)
    asked = {"path": name, "name": name, "type": "notebook", "kernel": {"name": "python3"}}
    request = urllib.request.Request(
        f"http://{parts.netloc}/api/sessions",
        json.dumps(asked).encode(),
        {
            "Authorization": f"token {parse_qs(parts.query)['token'][0]}",
            "Content-Type": "application/json",
        },
    )
    try:
        # Not by way of a proxy: this is the same machine.
        urllib.request.build_opener(urllib.request.ProxyHandler({})).open(
            request, timeout=PATIENCE
        ).close()
    except OSError as error:
        raise LiveError(f"JupyterLab starts no kernel: {error}") from None


def _free(port):
    """The port if nobody has it, any that nobody has without one."""
    with socket.socket() as trial:
        if hasattr(socket, "SO_REUSEADDR") and os.name == "posix":
            trial.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            trial.bind(("127.0.0.1", port or 0))
        except (OSError, OverflowError) as error:
            raise LiveError(
                f"port {port} cannot be had ({getattr(error, 'strerror', None) or error}); another "
                "--port, or none, takes a free one"
            ) from None
        return trial.getsockname()[1]


def _browser():
    try:
        return webbrowser.get()
    except webbrowser.Error:
        raise LiveError(
            "no browser is found here; --no-browser prints the address for one elsewhere"
        ) from None


@contextmanager
def _terminated_as_interrupted():
    """What ends this process politely ends the lecture as Ctrl-C does."""

    def interrupt(*_):
        raise KeyboardInterrupt

    before = {
        number: signal.signal(number, interrupt)
        for number in (signal.SIGTERM, getattr(signal, "SIGHUP", None))
        if number is not None
    }
    try:
        yield
    finally:
        for number, handler in before.items():
            with suppress(ValueError):
                signal.signal(number, handler)

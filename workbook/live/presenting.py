"""Run a lecture: start JupyterLab and the kernel forkserver, open the page, stop both."""

import json
import os
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import threading
import urllib.request
import webbrowser
from contextlib import contextmanager, suppress
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from urllib.parse import parse_qs, urlsplit

from workbook.live import lab
from workbook.live.errors import LiveError
from workbook.live.keeping import keep_notebook, validate_destination
from workbook.live.kernel_forkserver import SOCKET, modules_of_problems
from workbook.live.lecture_notebook import lecture_notebook
from workbook.live.preparing import PREPARED, wait_until_prepared

SLIDES_STYLE = Path(__file__).parent / "labextension" / "slides.css"
#: Seconds in which JupyterLab answers on a slow machine.
TIMEOUT = 60


def present(
    presentation, port=None, browser=True, keep=None, discard=False, prepare=False, print_line=print
):
    """Open a problem or a lecture in JupyterLab, on a copy, until it is shut down.

    Ctrl-C or JupyterLab's own Shut Down ends it.

    Parameters
    ----------
    presentation : Presentation
        The problem or lecture.
    port : int, optional
        Port of JupyterLab; without it a free one.
    browser : bool
        Whether a browser is opened.
    keep : pathlib.Path, optional
        File or folder to keep the notebook in (`workbook.live.keeping`).
    discard : bool
        Whether the notebook is thrown away without asking.
    prepare : bool
        Whether everything is computed before the address is printed.
    print_line : callable
        Prints a line for the lecturer.

    Raises
    ------
    LiveError
        If JupyterLab, a browser or the port is not available.
    """
    if any(find_spec(name) is None for name in ("jupyterlab", "jupytext", "ipywidgets")):
        raise LiveError(
            "JupyterLab is not installed here; `pip install 'trajlib[live]'` in the checkout gets it"
        )
    if browser:
        browser = _find_browser()
    if keep is not None:
        validate_destination(keep)
    port = _free_port(port)
    with (
        TemporaryDirectory(prefix="workbook-live-", ignore_cleanup_errors=True) as path,
        _signals_as_interrupts(),
    ):
        folder = Path(path)
        with _running(folder, presentation, port, prepare) as (server, address, notebook, original):
            try:
                _wait_until_ready(server, folder)
                _start_kernel(address, notebook.name)
                if prepare:
                    wait_until_prepared(
                        folder / "prepared", lambda: server.poll() is None, print_line
                    )
                print_line(f"{presentation.title}: {address}")
                print_line("Ctrl-C here, or File, Shut Down there, ends the lecture.")
                if browser:
                    browser.open(address)
                server.wait()
            except KeyboardInterrupt:
                print_line("")
        destination = keep_notebook(notebook, original, presentation.name, keep, discard)
        if destination is not None:
            print_line(f"kept: {destination}")


@contextmanager
def _running(folder, presentation, port, prepare):
    """Start JupyterLab and the kernel forkserver at the same time; both end with this context."""
    token = secrets.token_hex(16)
    environment = (
        os.environ
        | lab.write_settings(folder)
        | {
            # relative to the working folder, since the path of a socket has at most 107 characters
            SOCKET: "kernels",
            "JUPYTER_TOKEN": token,
            "WORKBOOK_LIVE_PROBLEMS": " ".join(presentation.problems),
            "WORKBOOK_LIVE_NAME": presentation.name,
            **({PREPARED: str(folder / "prepared")} if prepare else {}),
            "PYTHONPATH": os.environ.get("PYTHONPATH", ""),
            "MPLBACKEND": "module://matplotlib_inline.backend_inline",
        }
    )
    notebook = folder / "copy" / f"{presentation.name}.ipynb"
    notebook.parent.mkdir()
    # the page of slides asks for these styles, and a missing one is an error in its console
    shutil.copyfile(SLIDES_STYLE, notebook.with_name("rise.css"))
    notebook.with_suffix(".css").touch()
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
        if sys.platform != "win32":
            forkserver = start("workbook.live.kernel_forkserver", environment[SOCKET])
            with suppress(BrokenPipeError):  # without a forkserver kernels start as usual
                forkserver.stdin.write(
                    json.dumps(modules_of_problems(presentation.problems)).encode() + b"\n"
                )
                forkserver.stdin.flush()
        notebook.write_text(
            json.dumps(lecture_notebook(presentation), indent=1, ensure_ascii=False) + "\n",
            encoding="utf-8",
        )
        address = f"http://127.0.0.1:{port}/doc/tree/{notebook.name}?token={token}"
        yield server, address, notebook, notebook.read_bytes()
    finally:
        for process in processes:
            _end(process)
        log.close()


def _end(process):
    """Close the standard input of a process, on which it exits; kill it if it does not."""
    with suppress(BrokenPipeError):  # it has exited without reading its input
        process.stdin.close()
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    process.stdout.close()


def _wait_until_ready(server, folder):
    lines = []
    # a thread, since Windows cannot wait for a pipe for a limited time
    reader = threading.Thread(target=lambda: lines.append(server.stdout.readline()), daemon=True)
    reader.start()
    reader.join(TIMEOUT)
    if not any(lines):
        lines = (folder / "log").read_text(encoding="utf-8", errors="replace").split("\n")
        reason = next(
            (line for line in reversed(lines) if line.strip()), f"no answer in {TIMEOUT} s"
        )
        raise LiveError(f"JupyterLab does not start: {reason.strip()}")


def _start_kernel(address, name):
    """Start the kernel before the page opens, which ignores a cell that is run without one."""
    parts = urlsplit(address)
    session = {"path": name, "name": name, "type": "notebook", "kernel": {"name": "python3"}}
    request = urllib.request.Request(
        f"http://{parts.netloc}/api/sessions",
        json.dumps(session).encode(),
        {
            "Authorization": f"token {parse_qs(parts.query)['token'][0]}",
            "Content-Type": "application/json",
        },
    )
    try:
        # no proxy: this is the same machine
        urllib.request.build_opener(urllib.request.ProxyHandler({})).open(
            request, timeout=TIMEOUT
        ).close()
    except OSError as error:
        raise LiveError(f"JupyterLab starts no kernel: {error}") from None


def _free_port(port):
    """Return the port if it is free, or any free port; raise `LiveError` otherwise."""
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


def _find_browser():
    try:
        return webbrowser.get()
    except webbrowser.Error:
        raise LiveError(
            "no browser is found here; --no-browser prints the address for one elsewhere"
        ) from None


@contextmanager
def _signals_as_interrupts():
    """Let SIGTERM and SIGHUP end the lecture as Ctrl-C does."""

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

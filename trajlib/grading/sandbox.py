"""The parent's side of the sandbox: hand a notebook in, get bytes and how it ended."""

import json
from dataclasses import asdict, dataclass

from trajlib.grading import framing, isolation

#: What a ready worker may need longer than the notebook itself: forking, namespaces, collecting.
GRACE = 10.0


@dataclass(frozen=True)
class Limits:
    """What one notebook may use."""

    wall_seconds: float = 120
    cpu_seconds: int = 120
    memory_megabytes: int = 2048
    disk_megabytes: int = 64
    processes: int = 32


@dataclass(frozen=True)
class Outcome:
    """How a notebook ended ("done", "time", "died") and the bytes it handed over, not looked into."""

    ended: str
    handed_over: bytes


class Sandbox:
    """A ready worker in a sandbox; `run` may be called again and again, each notebook sees an untouched machine.

    Raises `isolation.NoIsolation` where none can be had. Use as a context manager.
    """

    def __init__(self, limits=Limits()):
        self.limits = limits
        self._worker = None

    def __enter__(self):
        self._start()
        return self

    def __exit__(self, *_):
        self._stop()

    def run(self, sources, names):
        """Run code cells and collect the answers `names`; returns an `Outcome`, whatever the notebook does."""
        if self._worker is None:
            self._start()
        request = {"sources": list(sources), "names": list(names), "limits": asdict(self.limits)}
        try:
            framing.send(self._worker.stdin.fileno(), json.dumps(request).encode())
            ended, _, handed_over = framing.receive(self._worker.stdout.fileno(), self.limits.wall_seconds + GRACE).partition(b"|")
            return Outcome(ended.decode(), handed_over)
        except (framing.Broken, BrokenPipeError) as broken:
            # The worker itself is gone or hangs: a new one serves the next notebook.
            self._stop()
            return Outcome("died", str(broken).encode())

    def _start(self):
        self._worker = isolation.spawn("trajlib.grading.worker")
        try:
            if framing.receive(self._worker.stdout.fileno(), timeout=60) != b"ready":
                raise framing.Broken("no greeting")
        except framing.Broken:
            self._worker.kill()
            said = self._worker.stderr.read().decode(errors="replace").strip().split("\n")[-1]
            self._worker = None
            raise isolation.NoIsolation(f"the sandbox does not start here: {said or 'it ended without a word'}") from None

    def _stop(self):
        if self._worker is not None:
            self._worker.kill()
            self._worker.wait()
            for pipe in (self._worker.stdin, self._worker.stdout, self._worker.stderr):
                pipe.close()
            self._worker = None

"""Forkserver: imports once, forks workers on request.

A forkserver (on Android: zygote) starts afresh with an empty environment and receives only
requests to fork, never data of a student: whatever it held would be in the memory of every
notebook's process. A request names what to run as "module:function", and only the names of an
allow-list are started. Three forkservers grade:

- the first imports what notebooks and checks need, and forks worker processes (`worker_pool`);
- each worker process has a second one, forked from the first before that imports what only checks
  use (the smaller a process, the cheaper its forks). Sandboxes are forked from it, so a worker
  process is no ancestor of them, and nothing that it receives is ever inside one;
- inside each sandbox, a third one (`notebook_worker`) forks a process for each notebook.
"""

import importlib
import json
import os
import signal
import socket
import subprocess
import threading
import time
from contextlib import contextmanager, suppress
from functools import partial

from workbook.grading.sandbox import framing, isolation
from workbook.grading.sandbox.limits import ProcessStartError
from workbook.grading.sandbox.preloading import collapse_into_huge_pages, preload
from workbook.grading.sandbox.system_calls import die_with_parent

#: All that the forkservers outside a sandbox start, as "module:function".
FORKSERVER = "workbook.grading.sandbox.forkserver:serve_inherited"
WORKER_PROCESS = "workbook.grading.pool.worker_pool:run_worker"
NOTEBOOK_WORKER = "workbook.grading.sandbox.notebook_worker:serve_notebooks"
ALLOWED = (FORKSERVER, WORKER_PROCESS, NOTEBOOK_WORKER)

START = "from workbook.grading.sandbox import forkserver; forkserver.main({control}, {modules!r})"
#: Bytes of a request or a reply.
MAX_MESSAGE = 2**16
#: Seconds that importing everything may take, on a busy machine.
REPLY_SECONDS = 120
MAX_DESCRIPTOR = 4096


class Forkserver:
    """A client's end of a forkserver; several threads may use it."""

    def __init__(self, control, end=lambda: None, bubblewrap=None):
        self._control, self._end, self._bubblewrap = control, end, bubblewrap
        self._lock = threading.Lock()
        control.settimeout(REPLY_SECONDS)

    @classmethod
    def start(cls, modules):
        """Start a fresh process that imports `modules` (names) and then forks on request."""
        control, server_end = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with server_end:
            command = isolation.python_command(
                START.format(control=server_end.fileno(), modules=list(modules))
            )
            # In a session of its own, so that Ctrl-C reaches the grader alone, which then ends it.
            process = subprocess.Popen(
                command,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                env=isolation.grader_environment(),
                pass_fds=[server_end.fileno()],
                start_new_session=True,
                preexec_fn=partial(die_with_parent, os.getpid()),
            )
        return cls(control, lambda: (process.kill(), process.wait()))

    @classmethod
    def attach(cls, descriptor, bubblewrap):
        """Use a child forkserver whose socket another process handed over as `descriptor`.

        `bubblewrap` is its path as the grader found it: this process does not have the grader's
        PATH.
        """
        return cls(socket.socket(fileno=descriptor), bubblewrap=bubblewrap)

    def spawn_child(self):
        """Fork a child forkserver; return (pid, control socket).

        The child has imported what this one has by now, and exits when the socket closes.
        """
        with self._lock:
            self._send({"huge pages": True})
        control, child_end = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with child_end:
            return self.fork(FORKSERVER, [], [child_end.fileno()]), control

    def alive(self):
        """Return whether the process runs; no other thread may be waiting for a reply."""
        with self._lock:  # without a request, the socket becomes readable only when it ends
            return self._control.fileno() >= 0 and not framing.readable([self._control], 0)

    @property
    def bubblewrap(self):
        """The path of bubblewrap; raises `SandboxUnavailableError` if it is not installed."""
        return self._bubblewrap or isolation.find_bubblewrap()

    def load(self, modules):
        """Import more modules before the next fork, without waiting for it.

        If the forkserver dies of that, the next fork raises the error.
        """
        with self._lock, suppress(ProcessStartError):
            self._send({"load": list(modules)})

    def fork(self, name, arguments, descriptors):
        """Fork a process that runs `name` of `ALLOWED` with JSON-able arguments; return its pid.

        The process has these descriptors as its 0, 1, ...; None keeps the forkserver's own.
        """
        with self._lock:
            self.begin_fork(name, arguments, descriptors)
            return self.finish_fork()

    def begin_fork(self, name, arguments, descriptors):
        """Request a fork without waiting; for the only user of this forkserver."""
        targets = [
            target for target, descriptor in enumerate(descriptors) if descriptor is not None
        ]
        self._send(
            {"fork": name, "arguments": arguments, "targets": targets},
            [descriptors[target] for target in targets],
        )

    def finish_fork(self):
        """Return the pid of the process that `begin_fork` requested."""
        return self._receive()["pid"]

    def receive_proc(self):
        """Return (own pid, descriptor of the /proc that has it), which a sandbox's sends first."""
        with _start_errors():
            pid, descriptors, _, _ = socket.recv_fds(self._control, MAX_MESSAGE, 1)
        if not descriptors:
            raise ProcessStartError("the process that notebooks are forked from ended")
        return int(pid), descriptors[0]

    def wake(self, pid):
        """Send SIGALRM to a process that was forked here."""
        self._send({"wake": pid})

    def forget(self, pid):
        """End a process without waiting for it."""
        self._send({"forget": pid})

    def exit_code(self, pid, within=0.0):
        """Return a process's exit code, negative for a signal; None if it runs after `within` s."""
        return self._request({"exit code": pid, "within": within})["code"]

    def end(self, pid, within=0.0):
        """Return a process's exit code; kill it and its session if it runs after `within` s."""
        return self._request({"end": pid, "within": within})["code"]

    def close(self):
        """End the forkserver, and with it all that was forked from it."""
        self._control.close()
        self._end()

    def _request(self, request):
        with self._lock:
            self._send(request)
            return self._receive()

    def _send(self, request, descriptors=()):
        with _start_errors():
            socket.send_fds(self._control, [json.dumps(request).encode()], descriptors)

    def _receive(self):
        with _start_errors():
            reply = self._control.recv(MAX_MESSAGE)
        if not reply:
            raise ProcessStartError(
                "the process that others are forked from ended: the machine may be out of memory; "
                "the same command goes on from here"
            )
        return json.loads(reply)


@contextmanager
def _start_errors():
    """Raise `ProcessStartError` in place of an `OSError` on the control socket."""
    try:
        yield
    except OSError as error:
        raise ProcessStartError(
            f"the process that others are forked from is gone or too slow ({error}): the machine "
            "may be out of memory; the same command goes on from here"
        ) from None


# In the forkserver


def main(control, modules):
    """Import `modules` and the modules of the allow-list, then serve the socket `control`."""
    preload(*modules, *(name.partition(":")[0] for name in ALLOWED))
    serve(socket.socket(fileno=control), ALLOWED)


def serve_inherited():
    """Serve, in a forked process, the socket that it has as standard input."""
    serve(take_control_socket(), ALLOWED)


def serve(control, allowed, first_arguments=(), before_fork=None, after_end=lambda: None):
    """Fork on request until the socket `control` closes.

    Requests come from the grader alone.

    Parameters
    ----------
    control : socket.socket
        A SOCK_SEQPACKET socket with the requests; the client is a `Forkserver`.
    allowed : collection of str
        The names "module:function" that may be started.
    first_arguments : tuple
        Arguments that each function gets before those of the request.
    before_fork : callable, optional
        Called before each fork; given where each child begins a PID namespace of its own, from
        which its parent cannot be seen.
    after_end : callable
        Called after a child was ended, and when the socket has closed.
    """
    parent = os.getpid() if before_fork is None else 0
    while True:
        message, descriptors, _, _ = socket.recv_fds(control, MAX_MESSAGE, 3)
        if not message:
            after_end()
            return
        request = json.loads(message)
        if "load" in request:
            preload(*request["load"])
            continue
        if "huge pages" in request:
            collapse_into_huge_pages()
            continue
        if "wake" in request:
            with suppress(ProcessLookupError):
                os.kill(request["wake"], signal.SIGALRM)
            continue
        if "forget" in request:
            _end(request["forget"], 0)
            after_end()
            continue
        if "fork" in request:
            if before_fork is not None:
                before_fork()
            pid = os.fork()
            if pid == 0:
                control.detach()
                _run_and_exit(request, allowed, first_arguments, descriptors, parent)
            for descriptor in descriptors:
                os.close(descriptor)
            reply = {"pid": pid}
        elif "exit code" in request:
            reply = {"code": _exit_code(request["exit code"], request["within"])}
        else:
            reply = {"code": _end(request["end"], request["within"])}
            after_end()
        with suppress(BrokenPipeError, ConnectionResetError):
            control.send(json.dumps(reply).encode())


def entry_point(name, allowed):
    """Return the function "module:function"; raise `PermissionError` unless it is allowed."""
    if name not in allowed:
        raise PermissionError(f"a forkserver does not start {name!r}")
    module, _, function = name.partition(":")
    return getattr(importlib.import_module(module), function)


#: Exit codes of processes that have ended, by pid.
_exit_codes: dict[int, int] = {}


def _exit_code(pid, within):
    deadline = time.monotonic() + within
    while pid not in _exit_codes:
        ended, status = os.waitpid(pid, os.WNOHANG)
        if ended:
            _exit_codes[pid] = os.waitstatus_to_exitcode(status)
        elif time.monotonic() >= deadline:
            return None
        else:
            time.sleep(0.005)
    return _exit_codes[pid]


def _end(pid, within):
    if _exit_code(pid, within) is None:
        with suppress(ProcessLookupError):
            os.killpg(pid, signal.SIGKILL)
        os.kill(pid, signal.SIGKILL)
        _exit_codes[pid] = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
    return _exit_codes.pop(pid)


def _run_and_exit(request, allowed, first_arguments, descriptors, parent):
    """Run what a child was forked for and exit, whatever happens, without the parent's cleanup."""
    code = 1
    try:
        _take_over(descriptors, request["targets"], parent)
        entry_point(request["fork"], allowed)(*first_arguments, *request["arguments"])
        code = 0
    except SystemExit as exit_request:
        code = exit_request.code if isinstance(exit_request.code, int) else 0
    except BaseException as error:
        with suppress(OSError):
            os.write(2, f"{error!r}\n".encode(errors="replace"))
    finally:
        os._exit(code)


def _take_over(descriptors, targets, parent):
    """Make the forked process independent of its parent, but for the given descriptors."""
    # Or signals to its process group, number 0, would reach its parent through all namespaces.
    os.setsid()
    die_with_parent(parent)
    # Both ascend, so that none is overwritten before it is duplicated.
    for target, descriptor in zip(targets, descriptors, strict=True):
        os.dup2(descriptor, target)
    os.closerange(max([2, *targets]) + 1, MAX_DESCRIPTOR)
    _exit_codes.clear()


def take_control_socket():
    """Return the socket that this process has as standard input, which becomes /dev/null."""
    control, null = os.dup(0), os.open("/dev/null", os.O_RDONLY)
    os.dup2(null, 0)
    os.close(null)
    return socket.socket(fileno=control)

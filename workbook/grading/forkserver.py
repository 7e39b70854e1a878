"""A process that has imported what grading needs, and from which others are forked that need not
import it again.

It is started afresh with an empty environment, and hears only what to fork, never anything of a
student's: whatever it held would stand in the memory of every notebook's process. Sandboxes come
from a second forkserver, forked from the first before that imports what checks alone use: the smaller
a process, the cheaper its forks. A lane asks for them there, and is itself no ancestor of theirs;
so nothing that a lane learns is ever inside one. In a sandbox, notebooks' processes come from a
third one (`worker`).
"""

import json
import os
import signal
import socket
import subprocess
import threading
import time
from contextlib import contextmanager, suppress
from functools import partial

from workbook.grading import framing, isolation
from workbook.grading.isolation import NotStarted, end_with_parent
from workbook.grading.preloading import into_huge_pages, preload

START = "from workbook.grading import forkserver; forkserver.main({control}, {modules!r})"
#: Bytes of a request or an answer.
LONGEST = 2**16
#: Seconds that importing everything may take, on a busy machine.
TO_ANSWER = 120
HIGHEST_DESCRIPTOR = 4096


class Forkserver:
    """The other processes' end: asks for forks. Several threads may."""

    def __init__(self, control, end=lambda: None, bubblewrap=None):
        self._control, self._end, self._bubblewrap, self._asking = (
            control,
            end,
            bubblewrap,
            threading.Lock(),
        )
        control.settimeout(TO_ANSWER)

    @classmethod
    def start(cls, modules):
        """A fresh process, which imports `modules` (names) and then forks."""
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with theirs:
            command = isolation.python(START.format(control=theirs.fileno(), modules=list(modules)))
            # In a session of its own, so that Ctrl-C reaches the grader alone, which then ends it.
            process = subprocess.Popen(
                command,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                env=isolation.environment_outside(),
                pass_fds=[theirs.fileno()],
                start_new_session=True,
                preexec_fn=partial(end_with_parent, os.getpid()),
            )
        return cls(ours, lambda: (process.kill(), process.wait()))

    @classmethod
    def at(cls, descriptor, bubblewrap):
        """One that was `divided` off by another process, which handed the socket over.

        `bubblewrap` is where the grader found it, whose PATH this process has not.
        """
        return cls(socket.socket(fileno=descriptor), bubblewrap=bubblewrap)

    def spawn_child(self):
        """Fork a forkserver from this one, which has imported what this one has by now: its number,
        and the socket on which whoever holds that can ask it; it ends when nobody does."""
        with self._asking:
            self._tell({"pack": True})
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with theirs:
            return self.fork("forkserver", [], [theirs.fileno()]), ours

    def alive(self):
        """Whether its process runs; nobody may be waiting for an answer of it."""
        with self._asking:  # nothing but its end comes unasked
            return self._control.fileno() >= 0 and not framing.readable([self._control], 0)

    @property
    def bubblewrap(self):
        """Where bubblewrap is. Raises `NoIsolation` where there is none."""
        return self._bubblewrap or isolation.bubblewrap()

    def load(self, modules):
        """Let it import more before it forks next. Nobody waits for that; if it dies of it, the
        next fork tells."""
        with self._asking, suppress(NotStarted):
            self._tell({"load": list(modules)})

    def fork(self, kind, given, descriptors):
        """Fork a process of a `kind` (of `_KINDS`) with these descriptors as its 0, 1, ..., where
        None leaves what is there; returns its number."""
        with self._asking:
            self.begin_fork(kind, given, descriptors)
            return self.forked()

    def begin_fork(self, kind, given, descriptors):
        """What `fork` does, without waiting: whoever alone asks this forkserver gets the number from
        `forked`."""
        numbers = [
            number for number, descriptor in enumerate(descriptors) if descriptor is not None
        ]
        self._tell(
            {"fork": kind, "given": given, "numbers": numbers},
            [descriptors[number] for number in numbers],
        )

    def forked(self):
        return self._answer()["number"]

    def place_in_proc(self):
        """Of one that tells it first of all: its number, and a descriptor of the /proc in which it
        has this number."""
        with _told():
            number, descriptors, _, _ = socket.recv_fds(self._control, LONGEST, 1)
        if not descriptors:
            raise NotStarted("the process that notebooks are forked from ended")
        return int(number), descriptors[0]

    def wake(self, number):
        """Send a process that was forked here the signal of an alarm."""
        self._tell({"wake": number})

    def forget(self, number):
        """What `end` does, without waiting."""
        self._tell({"forget": number})

    def ended(self, number, within=0.0):
        """The exit code of a process forked here, negative for a signal; None if it runs on after
        so many seconds."""
        return self._ask({"ended": number, "within": within})["code"]

    def end(self, number, within=0.0):
        """Its exit code; if it runs on after so many seconds, it is killed with all that it started
        in its session."""
        return self._ask({"end": number, "within": within})["code"]

    def close(self):
        """End the forkserver; what was forked from it ends too."""
        self._control.close()
        self._end()

    def _ask(self, request):
        with self._asking:
            self._tell(request)
            return self._answer()

    def _tell(self, request, descriptors=()):
        with _told():
            socket.send_fds(self._control, [json.dumps(request).encode()], descriptors)

    def _answer(self):
        with _told():
            answer = self._control.recv(LONGEST)
        if not answer:
            raise NotStarted(
                "the process that others are forked from ended: the machine may be out of memory; "
                "the same command goes on from here"
            )
        return json.loads(answer)


@contextmanager
def _told():
    try:
        yield
    except OSError as error:
        raise NotStarted(
            f"the process that others are forked from is gone or too slow ({error}): the machine "
            "may be out of memory; the same command goes on from here"
        ) from None


# In the forkserver


def main(control, modules):
    preload(*modules, "workbook.grading.worker_pool", "workbook.grading.notebook_worker")
    serve(socket.socket(fileno=control), _KINDS)


def serve(control, kinds, apart=None, tidy=lambda: None):
    """Fork as asked, of `kinds` (functions by name), until nobody is there to ask. Requests are the
    grader's own; nothing else ever comes in.

    `apart` is called before each fork where each process begins a namespace of its own, from which
    no parent is to be seen; `tidy` when one was ended, and in the end.
    """
    this = os.getpid() if apart is None else 0
    while True:
        message, descriptors, _, _ = socket.recv_fds(control, LONGEST, 3)
        if not message:
            tidy()
            return
        request = json.loads(message)
        if "load" in request:
            preload(*request["load"])
            continue
        if "pack" in request:
            into_huge_pages()
            continue
        if "wake" in request:
            with suppress(ProcessLookupError):
                os.kill(request["wake"], signal.SIGALRM)
            continue
        if "forget" in request:
            _end(request["forget"], 0)
            tidy()
            continue
        if "fork" in request:
            if apart is not None:
                apart()
            number = os.fork()
            if number == 0:
                control.detach()
                _run_to_the_end(
                    _become,
                    kinds[request["fork"]],
                    request["given"],
                    descriptors,
                    request["numbers"],
                    this,
                )
            for descriptor in descriptors:
                os.close(descriptor)
            answer = {"number": number}
        elif "ended" in request:
            answer = {"code": _code(request["ended"], request["within"])}
        else:
            answer = {"code": _end(request["end"], request["within"])}
            tidy()
        with suppress(BrokenPipeError, ConnectionResetError):
            control.send(json.dumps(answer).encode())


#: Exit codes of processes that have ended, by their numbers.
_codes = {}


def _code(number, within):
    give_up = time.monotonic() + within
    while number not in _codes:
        ended, status = os.waitpid(number, os.WNOHANG)
        if ended:
            _codes[number] = os.waitstatus_to_exitcode(status)
        elif time.monotonic() >= give_up:
            return None
        else:
            time.sleep(0.005)
    return _codes[number]


def _end(number, within):
    if _code(number, within) is None:
        with suppress(ProcessLookupError):
            os.killpg(number, signal.SIGKILL)
        os.kill(number, signal.SIGKILL)
        _codes[number] = os.waitstatus_to_exitcode(os.waitpid(number, 0)[1])
    return _codes.pop(number)


def _become(function, given, descriptors, numbers, parent):
    # Or signals to its process group, number 0, would reach its parent through all namespaces.
    os.setsid()
    end_with_parent(parent)
    # both ascend, so that none is in the way
    for number, descriptor in zip(numbers, descriptors, strict=True):
        os.dup2(descriptor, number)
    os.closerange(max([2, *numbers]) + 1, HIGHEST_DESCRIPTOR)
    _codes.clear()
    function(*given)


def _run_to_the_end(function, *given):
    """Run what a forked process is for; it ends here, whatever happens, and nothing of its parent's
    is tidied up."""
    code = 1
    try:
        function(*given)
        code = 0
    except SystemExit as asked:
        code = asked.code if isinstance(asked.code, int) else 0
    except BaseException as error:
        with suppress(OSError):
            os.write(2, f"{error!r}\n".encode(errors="replace"))
    finally:
        os._exit(code)


def control_of_input():
    """The socket that this process was forked with as its input, which now leads nowhere."""
    control, nothing = os.dup(0), os.open("/dev/null", os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    return socket.socket(fileno=control)


def _forkserver():
    serve(control_of_input(), _KINDS)


def _lane(settings, bubblewrap):
    from workbook.grading import worker_pool

    worker_pool.work(settings, bubblewrap)


def _worker(mode, limits, bubblewrap, folder):
    from workbook.grading import notebook_worker

    notebook_worker.begin(mode, limits, bubblewrap, folder)


_KINDS = {"forkserver": _forkserver, "lane": _lane, "worker": _worker}

"""Notebook worker: a forkserver inside a sandbox that forks a process for each notebook.

The forked process is the first of a PID namespace of its own, without network, with an empty /tmp
and no /proc, without capabilities, within limits. When it is done, or out of time, everything that
it left behind ends with it.

The notebook worker never holds a request or an answer: whatever it had read would be in the memory
of every later notebook's process. Nor does any process that it was forked from (`forkserver`). It
only forks, and ends what it forked: the pipes for the request and the answers connect the grader
to the notebook's process, and the grader watches it (`watchdog`). The process exists, and is
confined, before its request comes: while one notebook is judged, the next one's is prepared.

There are three modes: `nested`, as described; `single-use`, where the system allows no namespaces
inside the sandbox: this very process runs one notebook, in a sandbox of its own; `trusted`, without
a sandbox.
"""

import ctypes
import fcntl
import json
import math
import os
import resource
import shutil
import socket
import struct
import tempfile
import time
from functools import partial

from workbook.grading.sandbox import forkserver, framing, seccomp, watchdog
from workbook.grading.sandbox.isolation import (
    ENVIRONMENT,
    SCRATCH,
    enter_pid_namespace,
    enter_sandbox,
    visible_paths,
)
from workbook.grading.sandbox.limits import SandboxUnavailableError
from workbook.grading.sandbox.preloading import preload
from workbook.grading.sandbox.system_calls import (
    CLONE_NEWIPC,
    CLONE_NEWNET,
    CLONE_NEWNS,
    MS_BIND,
    MS_NODEV,
    MS_NOSUID,
    MS_PRIVATE,
    MS_RDONLY,
    MS_REC,
    address_space_bytes,
    enter_namespaces,
    mount,
    system_call,
)
from workbook.notebooks.cells import prepare, run_cells

PR_SET_NO_NEW_PRIVS, PR_CAPBSET_DROP, PR_SET_CHILD_SUBREAPER = 38, 24, 36
CAPABILITY_VERSION_3 = 0x20080522
#: All that the forkserver inside a sandbox starts.
NOTEBOOK = "workbook.grading.sandbox.notebook_worker:run_notebook"
#: The greetings of a notebook worker; any other is why the sandbox does not start.
READY, NOT_NESTED = b"ready", b"not nested"


def serve_notebooks(mode, limits, bubblewrap, folder):
    """Enter a sandbox and serve as the forkserver of notebooks' processes there.

    For a process forked from a forkserver, whose standard input is the control socket.

    Parameters
    ----------
    mode : str
        "nested"; or "trusted" to serve outside any sandbox.
    limits : dict
        Those of each notebook, as of `limits.Limits`.
    bubblewrap : str or None
        Path of bubblewrap.
    folder : str
        The home of trusted notebooks, empty.
    """
    trusted = mode == "trusted"
    home = {"HOME": folder, "TMPDIR": folder, "MPLCONFIGDIR": folder} if trusted else {}
    # Visible folders (an installation) that lie where notebooks find an empty folder; collected
    # while paths are as outside.
    in_scratch = [
        str(path)
        for path in visible_paths()
        if any(path.is_relative_to(folder) for folder in SCRATCH)
    ]
    before_fork = None
    if not trusted:
        try:
            seccomp.require_known_machine()
            enter_sandbox(bubblewrap, limits)
            os.chdir("/tmp")
            _drop_capabilities()
            before_fork = enter_pid_namespace()
            if not _can_nest(before_fork, limits, in_scratch):
                raise OSError
        except SandboxUnavailableError as error:
            framing.send(1, str(error).encode())
            return
        except OSError:
            framing.send(1, NOT_NESTED)
            return
    os.environ.clear()
    os.environ.update(ENVIRONMENT | home)
    prepare()
    control = forkserver.take_control_socket()
    proc = os.open("/proc", os.O_RDONLY | os.O_DIRECTORY)
    framing.send(1, READY)
    # The grader looks for notebooks' processes below this pid, in this /proc.
    socket.send_fds(control, [os.readlink("/proc/self").encode()], [proc])
    after_end = partial(_clean_up, folder, proc) if trusted else lambda: None
    if trusted:  # orphans become children of this process
        system_call("prctl", PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    forkserver.serve(
        control, (NOTEBOOK,), (limits, mode, folder, in_scratch), before_fork, after_end
    )


def run_once(limits, modules):
    """Run a single notebook in this fresh process, which has a sandbox or a user of its own.

    `modules` are imported before the request comes.
    """
    try:
        seccomp.require_known_machine()
    except SandboxUnavailableError as error:
        framing.send(1, str(error).encode())
        return
    preload(*modules)
    prepare()
    framing.send(1, READY)
    run_notebook(limits, "single-use", "/tmp", [])


def _can_nest(before_fork, limits, in_scratch):
    """Return whether this system allows namespaces inside the sandbox, tried in a child."""
    before_fork()
    child = os.fork()
    if child == 0:
        try:
            _enter_notebook_namespaces(limits, in_scratch)
            os._exit(0)
        finally:
            os._exit(1)
    return os.waitpid(child, 0)[1] == 0


def _clean_up(folder, proc):
    """Remove what a trusted notebook left: processes, which no namespace ends, and files."""
    watchdog.kill_descendants(proc)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder, exist_ok=True)


# The notebook's own process


def run_notebook(limits, mode, folder, in_scratch):
    """Drop all privileges, run one notebook, hand over its answers, and exit.

    The request comes on descriptor 0, the answers leave on 1.
    """
    pid = os.getpid()
    try:
        results, requests = _close_all_but(1, 0)
        try:
            _confine(limits, mode, in_scratch)
            os.chdir(tempfile.mkdtemp(dir=folder) if mode == "trusted" else folder)
        except Exception as error:
            framing.send(results, repr(error).encode())
            return
        # Failures after this message are the notebook's, failures before it are not.
        framing.send(results, watchdog.PREPARED)
        request = json.loads(framing.receive(requests))
        os.close(requests)
        # Wall time runs on while other processes have the processors. Where the watchdog can wake
        # a cell that sleeps, none is stopped for it.
        seconds = (
            [limits["cpu_seconds"]]
            if mode != "single-use"
            else [limits["cpu_seconds"], limits["wall_seconds"]]
        )
        message = _run_cells(request, seconds)
        if os.getpid() == pid:  # not in a child that the notebook forked
            framing.send(results, message)
    finally:
        os._exit(0)


def _run_cells(request, seconds):
    try:
        return json.dumps(
            run_cells(
                request["sources"], request["names"], before=request["before"], seconds=seconds
            )
        ).encode()
    except BaseException as error:  # the student's code may end in anything
        return json.dumps(
            {
                "encoded": {},
                "unreadable": {},
                "errors": [f"the notebook ended: {type(error).__name__}"],
                "stopped": [],
                "failed": {},
                "overwritten": {},
                "meant": {},
            }
        ).encode()


def _confine(limits, mode, in_scratch):
    if mode == "nested":
        _enter_notebook_namespaces(limits, in_scratch)
    _set_limits(limits, mode)
    if mode == "nested":
        mount("tmpfs", "/proc", "tmpfs", MS_NOSUID | MS_NODEV | MS_RDONLY, "nr_inodes=1,mode=555")
    if mode != "trusted":
        _drop_privileges()


def _enter_notebook_namespaces(limits, in_scratch):
    """Enter namespaces without network and without files that others wrote."""
    enter_namespaces(CLONE_NEWNS | CLONE_NEWNET | CLONE_NEWIPC)
    mount("none", "/", flags=MS_REC | MS_PRIVATE)
    opened = {path: os.open(path, os.O_PATH) for path in in_scratch}
    for folder in SCRATCH:
        mount(
            "tmpfs",
            folder,
            "tmpfs",
            MS_NOSUID | MS_NODEV,
            f"size={limits['disk_megabytes']}m,nr_inodes=10000,mode=1777",
        )
    for path, descriptor in opened.items():
        if os.path.isdir(f"/proc/self/fd/{descriptor}"):
            os.makedirs(path, exist_ok=True)
        else:
            os.makedirs(os.path.dirname(path), exist_ok=True)
            open(path, "x").close()
        mount(f"/proc/self/fd/{descriptor}", path, flags=MS_BIND | MS_REC)
        os.close(descriptor)


def _close_all_but(*descriptors_to_keep):
    """Close every file but these, which become 3, 4, ...; 0, 1 and 2 become /dev/null."""
    duplicates = [
        fcntl.fcntl(descriptor, fcntl.F_DUPFD_CLOEXEC, 3 + len(descriptors_to_keep))
        for descriptor in descriptors_to_keep
    ]
    descriptors = [
        os.dup2(descriptor, target, inheritable=False)
        for target, descriptor in enumerate(duplicates, start=3)
    ]
    os.closerange(3 + len(descriptors_to_keep), forkserver.MAX_DESCRIPTOR)
    null = os.open("/dev/null", os.O_RDWR)
    for descriptor in (0, 1, 2):
        os.dup2(null, descriptor)
    os.close(null)
    return descriptors


def _set_limits(limits, mode):
    """Set the kernel's limits, which bind each process by itself; `watchdog` checks the sums."""
    # The process may have loaded the libraries itself, which is not the notebook's time or memory.
    bounds = {
        resource.RLIMIT_AS: address_space_bytes() + limits["memory_megabytes"] * 2**20,
        resource.RLIMIT_CPU: math.ceil(time.process_time() + limits["cpu_seconds"]) + 5,
        resource.RLIMIT_FSIZE: limits["disk_megabytes"] * 2**20,
        resource.RLIMIT_NOFILE: 128,
        resource.RLIMIT_CORE: 0,
    }
    if mode != "trusted":  # there it would count all processes of the user
        bounds[resource.RLIMIT_NPROC] = limits["processes"]
        # The kernel counts queued signals by user, all notebooks' together. With none allowed,
        # ordinary signals still arrive.
        bounds[resource.RLIMIT_SIGPENDING] = 0
    for kind, bound in bounds.items():
        resource.setrlimit(kind, (bound, bound))
    os.nice(5)  # the grader goes first


def _drop_privileges():
    """Drop all capabilities for good and forbid system calls that would undo the sandbox."""
    _drop_capabilities()
    seccomp.install_filter()


def _drop_capabilities():
    system_call("prctl", PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    for capability in range(64):
        try:
            system_call("prctl", PR_CAPBSET_DROP, capability, 0, 0, 0)
        except OSError:
            break  # past the last capability this kernel knows, or none to begin with
    header = struct.pack("II", CAPABILITY_VERSION_3, 0)
    system_call("capset", ctypes.c_char_p(header), ctypes.c_char_p(bytes(24)))

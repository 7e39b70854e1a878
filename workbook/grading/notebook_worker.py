"""Runs students' notebooks inside the sandbox: a ready process that forks a child of its own for
each.

The child is the first process of a PID namespace of its own, without network, with an empty /tmp
and no /proc, without capabilities, within limits; when it is done, or out of time, everything it
left behind ends with it.

The ready process never holds a request or an answer itself: whatever it had read would stand in the
memory of every later child. Nor does any process that it was forked from (`forkserver`). It only
forks, and ends what it forked: the pipes on which the request comes and the answers leave lead from
the grader to the child, and the grader watches it (`watching`). The child is there, and confined,
before its request comes: while one notebook is judged, the next one's place gets ready.

There are three modes: `nested`, as said; `once`, where the system allows no namespaces inside the
sandbox: one notebook, run by this very process, which a sandbox of its own surrounds; `trusting`,
with no sandbox around at all.
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

from workbook.grading import forkserver, framing, seccomp, watchdog
from workbook.grading.isolation import (
    CLONE_NEWIPC,
    CLONE_NEWNET,
    CLONE_NEWNS,
    ENVIRONMENT,
    MS_BIND,
    MS_NODEV,
    MS_NOSUID,
    MS_PRIVATE,
    MS_RDONLY,
    MS_REC,
    SCRATCH,
    NoIsolation,
    enter,
    enter_namespaces,
    enter_own_namespace,
    loaded,
    mount,
    system_call,
    visible,
)
from workbook.grading.preloading import preload
from workbook.notebooks.cells import prepare, run_cells

PR_SET_NO_NEW_PRIVS, PR_CAPBSET_DROP, PR_SET_CHILD_SUBREAPER = 38, 24, 36
CAPABILITY_VERSION_3 = 0x20080522
#: Said in place of "ready" where the system allows no namespaces inside the sandbox.
NOT_NESTED = b"not nested"


def begin(mode, limits, bubblewrap, folder):
    """In a process forked from a forkserver: go into a sandbox, and be the forkserver of notebooks'
    processes there, each within the limits (`sandbox.Limits` as a dict); or with the mode
    "trusting" here, with an empty `folder` for a home."""
    home = {"HOME": folder, "TMPDIR": folder, "MPLCONFIGDIR": folder} if mode == "trusting" else {}
    # Visible folders (an installation) that lie where notebooks find an empty folder; found while
    # paths are as outside.
    in_scratch = [
        str(path) for path in visible() if any(path.is_relative_to(folder) for folder in SCRATCH)
    ]
    apart = None
    if mode != "trusting":
        try:
            seccomp.check_known()
            enter(bubblewrap, limits)
            os.chdir("/tmp")
            _drop_capabilities()
            apart = enter_own_namespace()
            if not _can_nest(apart, limits, in_scratch):
                raise OSError
        except NoIsolation as error:
            framing.send(1, str(error).encode())
            return
        except OSError:
            framing.send(1, NOT_NESTED)
            return
    os.environ.clear()
    os.environ.update(ENVIRONMENT | home)
    prepare()
    control, proc = forkserver.control_of_input(), os.open("/proc", os.O_RDONLY | os.O_DIRECTORY)
    framing.send(1, b"ready")
    # Where the grader finds below which process notebooks run.
    socket.send_fds(control, [os.readlink("/proc/self").encode()], [proc])
    tidy = partial(_tidy, folder, proc) if mode == "trusting" else lambda: None
    if mode == "trusting":  # orphans come to this process
        system_call("prctl", PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    forkserver.serve(
        control, {"notebook": partial(_run, limits, 0, 1, mode, folder, in_scratch)}, apart, tidy
    )


def once(limits, modules):
    """In a fresh process that a sandbox of its own surrounds, or a user of its own: run a single
    notebook here, for which `modules` are imported beforehand."""
    try:
        seccomp.check_known()
    except NoIsolation as error:
        framing.send(1, str(error).encode())
        return
    preload(*modules)
    prepare()
    framing.send(1, b"ready")
    _run(limits, 0, 1, "once", "/tmp", [])


def _can_nest(apart, limits, in_scratch):
    """Try in a child whether this system allows namespaces inside the sandbox."""
    apart()
    child = os.fork()
    if child == 0:
        try:
            _surround(limits, in_scratch)
            os._exit(0)
        finally:
            os._exit(1)
    return os.waitpid(child, 0)[1] == 0


def _tidy(folder, proc):
    """What a trusted notebook left: processes, which end with nothing, and files."""
    watchdog.end_descendants(proc)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder, exist_ok=True)


# The notebook's own process


def _surround(limits, in_scratch):
    """Namespaces in which there is no network, and nothing that others wrote."""
    enter_namespaces(CLONE_NEWNS | CLONE_NEWNET | CLONE_NEWIPC)
    mount("none", "/", flags=MS_REC | MS_PRIVATE)
    held = {path: os.open(path, os.O_PATH) for path in in_scratch}
    for folder in SCRATCH:
        mount(
            "tmpfs",
            folder,
            "tmpfs",
            MS_NOSUID | MS_NODEV,
            f"size={limits['disk_megabytes']}m,nr_inodes=10000,mode=1777",
        )
    for path, descriptor in held.items():
        if os.path.isdir(f"/proc/self/fd/{descriptor}"):
            os.makedirs(path, exist_ok=True)
        else:
            _touch(path)
        mount(f"/proc/self/fd/{descriptor}", path, flags=MS_BIND | MS_REC)
        os.close(descriptor)


def _touch(path):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    open(path, "x").close()


def _run(limits, requests, results, mode, folder, in_scratch):
    """Give up everything, run the notebook that comes on `requests`, hand the answers over; never
    returns."""
    this = os.getpid()
    try:
        results, requests = _keep_only(results, requests)
        try:
            _confine(limits, mode, in_scratch)
            os.chdir(tempfile.mkdtemp(dir=folder) if mode == "trusting" else folder)
        except Exception as error:
            framing.send(results, repr(error).encode())
            return
        # Whatever fails from here on is the notebook's affair, and what failed before is not.
        framing.send(results, watchdog.PREPARED)
        request = json.loads(framing.receive(requests))
        os.close(requests)
        # The clock goes on while others have the processors. Where whoever watches can wake a cell
        # that sleeps, none is stopped for that.
        seconds = (
            [limits["cpu_seconds"]]
            if mode != "once"
            else [limits["cpu_seconds"], limits["wall_seconds"]]
        )
        message = _answers(request, seconds)
        if os.getpid() == this:  # not a child that the notebook forked and forgot
            framing.send(results, message)
    finally:
        os._exit(0)


def _answers(request, seconds):
    try:
        return json.dumps(
            run_cells(
                request["sources"], request["names"], before=request["before"], seconds=seconds
            )
        ).encode()
    except BaseException as error:  # the student's code may end in anything; it is told
        return json.dumps(
            {
                "encoded": {},
                "unreadable": {},
                "errors": [f"the notebook ended: {type(error).__name__}"],
                "stopped": [],
            }
        ).encode()


def _confine(limits, mode, in_scratch):
    if mode == "nested":
        _surround(limits, in_scratch)
    _limit(limits, mode)
    if mode == "nested":
        mount("tmpfs", "/proc", "tmpfs", MS_NOSUID | MS_NODEV | MS_RDONLY, "nr_inodes=1,mode=555")
    if mode != "trusting":
        _give_up_privileges()


def _keep_only(*kept):
    """Close every file but these, which become numbers 3, 4, ...; input and output lead nowhere."""
    aside = [fcntl.fcntl(descriptor, fcntl.F_DUPFD_CLOEXEC, 3 + len(kept)) for descriptor in kept]
    numbers = [
        os.dup2(descriptor, number, inheritable=False)
        for number, descriptor in enumerate(aside, start=3)
    ]
    os.closerange(3 + len(kept), 4096)
    nothing = os.open("/dev/null", os.O_RDWR)
    for descriptor in (0, 1, 2):
        os.dup2(nothing, descriptor)
    os.close(nothing)
    return numbers


def _limit(limits, mode):
    """Limits of the kernel on this process and its children, each for itself; `watching` sums
    up."""
    # The process may have loaded the libraries itself, which is not the notebook's time or memory.
    bounds = {
        resource.RLIMIT_AS: loaded() + limits["memory_megabytes"] * 2**20,
        resource.RLIMIT_CPU: math.ceil(time.process_time() + limits["cpu_seconds"]) + 5,
        resource.RLIMIT_FSIZE: limits["disk_megabytes"] * 2**20,
        resource.RLIMIT_NOFILE: 128,
        resource.RLIMIT_CORE: 0,
    }
    if mode != "trusting":  # there it would count all processes of the user
        bounds[resource.RLIMIT_NPROC] = limits["processes"]
    for kind, bound in bounds.items():
        resource.setrlimit(kind, (bound, bound))
    os.nice(5)  # the grader goes first


def _give_up_privileges():
    """No capability in this user namespace, none to come back by an executable, no system call that
    would undo the sandbox."""
    _drop_capabilities()
    seccomp.forbid()


def _drop_capabilities():
    system_call("prctl", PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    for capability in range(64):
        try:
            system_call("prctl", PR_CAPBSET_DROP, capability, 0, 0, 0)
        except OSError:
            break  # past the last capability this kernel knows, or none to begin with
    header = struct.pack("II", CAPABILITY_VERSION_3, 0)
    system_call("capset", ctypes.c_char_p(header), ctypes.c_char_p(bytes(24)))

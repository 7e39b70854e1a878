"""Runs students' notebooks inside the sandbox: a ready process that forks a child of its own for each.

`python -m trajlib.grading.worker` reads requests and writes what each child handed over, as bytes it never looks
into. The child is the first process of a PID namespace of its own, without network, with an empty /tmp and no /proc,
without capabilities and within limits; when it is done, or out of time, everything it left behind ends with it.
"""

import ctypes
import json
import os
import resource
import signal
import struct
import sys

from trajlib.grading import framing
from trajlib.grading.isolation import (CLONE_NEWIPC, CLONE_NEWNET, CLONE_NEWNS, CLONE_NEWPID, CLONE_NEWUSER, MS_NODEV, MS_NOSUID,
                                       MS_PRIVATE, MS_REC, mount, system_call, unshare)

PR_SET_NO_NEW_PRIVS, PR_CAPBSET_DROP = 38, 24
CAPABILITY_VERSION_3 = 0x20080522
DONE, TIME, DIED = b"done", b"time", b"died"


def main():
    _make_ready()
    framing.send(1, b"ready")
    while True:
        try:
            request = json.loads(framing.receive(0))
        except framing.Broken:
            return
        framing.send(1, b"|".join(_run_apart(request)))


def _make_ready():
    """Import what notebooks use, once; children inherit it."""
    import IPython.core.interactiveshell  # noqa: F401
    import matplotlib.pyplot  # noqa: F401
    import scipy.integrate  # noqa: F401
    import scipy.linalg  # noqa: F401
    import sympy  # noqa: F401

    import trajlib.checks.encoding
    import trajlib.execution  # noqa: F401
    for name in trajlib.checks.__all__:
        getattr(trajlib.checks, name)


def _run_apart(request):
    """(how it ended, what the child handed over) for one notebook."""
    limits = request["limits"]
    results, child_end = os.pipe()
    announced, announcing = os.pipe()
    keeper = os.fork()
    if keeper == 0:
        os.close(results)
        os.close(announced)
        _keep(request, child_end, announcing)
    os.close(child_end)
    os.close(announcing)
    first = struct.unpack(">I", os.read(announced, 4) or b"\0\0\0\0")[0]
    os.close(announced)
    try:
        return DONE, framing.receive(results, timeout=limits["wall_seconds"])
    except framing.Broken as broken:
        return (TIME if str(broken) == "time" else DIED), str(broken).encode()
    finally:
        os.close(results)
        # With the first process of its namespace every thread, child and daemon of the notebook ends.
        for process in (first, keeper):
            if process:
                try:
                    os.kill(process, signal.SIGKILL)
                except ProcessLookupError:
                    pass
        os.waitpid(keeper, 0)


def _keep(request, results, announcing):
    """In the child: enter namespaces, start the first process in them, tell its number and wait."""
    try:
        user, group = os.getuid(), os.getgid()
        unshare(CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWIPC)
        for name, text in (("setgroups", "deny"), ("uid_map", f"{user} {user} 1"), ("gid_map", f"{group} {group} 1")):
            with open(f"/proc/self/{name}", "w") as file:
                file.write(text)
        mount("none", "/", flags=MS_REC | MS_PRIVATE)
        megabytes = request["limits"]["disk_megabytes"]
        for folder in ("/tmp", "/dev/shm"):
            mount("tmpfs", folder, "tmpfs", MS_NOSUID | MS_NODEV, f"size={megabytes}m,nr_inodes=10000,mode=1777")
        first = os.fork()
        if first == 0:
            os.close(announcing)
            mount("tmpfs", "/proc", "tmpfs", MS_NOSUID | MS_NODEV, "size=0,mode=555")
            _run(request, results)
        os.write(announcing, struct.pack(">I", first))
        os.close(announcing)
        os.close(results)
        os.waitpid(first, 0)
    finally:
        os._exit(0)


def _run(request, results):
    """In the first process of the namespaces: give up everything, run the notebook, hand the answers over."""
    from trajlib.execution import run_cells

    try:
        _give_up_privileges()
        _limit(request["limits"])
        nothing = os.open("/dev/null", os.O_RDWR)
        for descriptor in (0, 1, 2):
            os.dup2(nothing, descriptor)
        os.closerange(3, results)
        os.closerange(results + 1, 4096)
        os.chdir("/tmp")
        outcome = run_cells(request["sources"], request["names"])
        framing.send(results, json.dumps(outcome).encode())
    except BaseException as error:  # the student's code may end in anything; it is told, and the process ends
        framing.send(results, json.dumps({"encoded": {}, "unreadable": {}, "errors": [f"the notebook ended: {type(error).__name__}"]}).encode())
    finally:
        os._exit(0)


def _give_up_privileges():
    """No capability in this user namespace, none to come back by an executable."""
    system_call("prctl", PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    for capability in range(64):
        try:
            system_call("prctl", PR_CAPBSET_DROP, capability, 0, 0, 0)
        except OSError:
            break  # past the last capability this kernel knows
    header = struct.pack("II", CAPABILITY_VERSION_3, 0)
    system_call("capset", ctypes.c_char_p(header), ctypes.c_char_p(bytes(24)))


def _limit(limits):
    """Limits of the kernel on this process and its children."""
    bounds = {resource.RLIMIT_AS: limits["memory_megabytes"] * 2**20, resource.RLIMIT_CPU: limits["cpu_seconds"],
              resource.RLIMIT_FSIZE: limits["disk_megabytes"] * 2**20, resource.RLIMIT_NPROC: limits["processes"],
              resource.RLIMIT_NOFILE: 256, resource.RLIMIT_CORE: 0}
    for kind, bound in bounds.items():
        resource.setrlimit(kind, (bound, bound))


if __name__ == "__main__":
    sys.exit(main())

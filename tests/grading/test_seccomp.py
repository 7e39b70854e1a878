"""The filter of system calls: what it denies, and that ordinary computing is allowed."""

import ctypes
import errno
import fcntl
import platform
import socket
import struct
from functools import partial

import pytest

from workbook.grading.sandbox import seccomp
from workbook.grading.sandbox.isolation import SandboxUnavailableError
from workbook.grading.sandbox.notebook_worker import PR_SET_NO_NEW_PRIVS
from workbook.grading.sandbox.system_calls import system_call
from workbook.notebooks.execution import in_child


def _under_the_filter(function):
    system_call("prctl", PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    seccomp.install_filter()
    return function()


def _denied():
    """Return the result of each denied call with arguments of zero."""
    libc = ctypes.CDLL(None, use_errno=True)
    column = seccomp.ARCHITECTURES[platform.machine()][1]
    results = {}
    for name, numbers in seccomp.DENIED.items():
        ctypes.set_errno(0)
        results[name] = [libc.syscall(numbers[column], 0, 0, 0, 0, 0, 0), ctypes.get_errno()]
    return results


def test_denied_system_calls():
    assert in_child(_under_the_filter, _denied, timeout=60) == dict.fromkeys(
        seccomp.DENIED, [-1, errno.EPERM]
    )


def _settings():
    """Return the results of reading and of setting limits and signal actions."""
    libc = ctypes.CDLL(None, use_errno=True)
    column = seccomp.ARCHITECTURES[platform.machine()][1]
    limit, action = ctypes.create_string_buffer(16), ctypes.create_string_buffer(152)
    results = []
    for call, arguments in (
        (seccomp.PRLIMIT, (0, 0, None, limit)),
        (seccomp.PRLIMIT, (0, 0, limit, None)),
        (seccomp.SIGACTION, (17, None, action, 8)),
        (seccomp.SIGACTION, (17, action, None, 8)),
        (seccomp.SIGACTION, (10, action, None, 8)),
    ):
        ctypes.set_errno(0)
        results.append([libc.syscall(call[column], *arguments), ctypes.get_errno()])
    return results


def test_limits_and_sigchld_can_be_read_but_not_set():
    asked, denied = [0, 0], [-1, errno.EPERM]
    assert in_child(_under_the_filter, _settings, timeout=60) == [
        asked,
        denied,
        asked,
        denied,
        asked,
    ]


def _clones():
    libc = ctypes.CDLL(None, use_errno=True)
    column = seccomp.ARCHITECTURES[platform.machine()][1]
    results = []
    for flag in (0x20000, 0x2000000, 0x4000000, 0x8000000, 0x10000000, 0x20000000, 0x40000000):
        results.append(
            [libc.syscall(seccomp.CLONE[column], flag | 17, 0, 0, 0, 0), ctypes.get_errno()]
        )
    results.append([libc.syscall(seccomp.CLONE3[column], 0, 0), ctypes.get_errno()])
    return results


def test_no_clone_with_a_new_namespace():
    assert in_child(_under_the_filter, _clones, timeout=60) == [[-1, errno.EPERM]] * 7 + [
        [-1, errno.ENOSYS]
    ]


def _sockets():
    results = {}
    for name, number in {
        "unix": 1,
        "inet": 2,
        "inet6": 10,
        "netlink": 16,
        "packet": 17,
        "bluetooth": 31,
        "alg": 38,
        "vsock": 40,
    }.items():
        try:
            socket.socket(
                number, socket.SOCK_RAW if name in ("netlink", "packet") else socket.SOCK_STREAM
            ).close()
            results[name] = 0
        except OSError as error:
            results[name] = error.errno
    return results


def test_sockets_of_confined_families_only():
    results = in_child(_under_the_filter, _sockets, timeout=60)
    assert results.pop("unix") == results.pop("inet") == 0
    results.pop("inet6")  # allowed; not every machine has it
    assert set(results.values()) == {errno.EAFNOSUPPORT}


def _locks(path):
    """Return what a process learns of locks that another holds on a file it can only read."""
    learned = []
    with open(path) as file:
        for lock in (fcntl.flock, fcntl.lockf):
            try:
                lock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
                learned.append("free")
            except BlockingIOError:
                learned.append("locked")
        for command in (fcntl.F_GETLK, fcntl.F_GETLEASE, fcntl.F_NOTIFY):
            try:
                fcntl.fcntl(file, command, struct.pack("hhqqi4x", fcntl.F_RDLCK, 0, 0, 0, 0))
                learned.append("asked")
            except PermissionError:
                learned.append("denied")
            except (OSError, TypeError):
                learned.append("asked")
    return learned


def test_no_lock_passes_a_bit_to_another_notebook(tmp_path):
    path = tmp_path / "library.py"
    with open(path, "w") as file, open(path, "w") as other:
        fcntl.flock(file, fcntl.LOCK_EX)
        fcntl.lockf(other, fcntl.LOCK_EX)
        assert in_child(_locks, path, timeout=60)[:2] == ["locked", "locked"], "unguarded"
        guarded = in_child(_under_the_filter, partial(_locks, path), timeout=60)
    assert guarded == ["free", "free", "denied", "denied", "denied"]


def _own_database(path):
    import sqlite3

    with sqlite3.connect(path) as database:
        database.execute("CREATE TABLE a (b)")
        database.execute("INSERT INTO a VALUES (1)")
        database.commit()
        return database.execute("SELECT b FROM a").fetchone()[0]


def test_a_database_of_ones_own_can_be_used(tmp_path):
    use = partial(_own_database, str(tmp_path / "own.sqlite"))
    assert in_child(_under_the_filter, use, timeout=60) == 1


def _ordinary_work():
    import subprocess
    import threading

    import numpy
    from scipy.integrate import solve_ivp

    threads = [threading.Thread(target=numpy.linalg.eig, args=(numpy.eye(50),)) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=30)
    solve_ivp(lambda t, x: -x, (0, 1), [1.0], method="LSODA")
    socket.socketpair()
    called = []
    ctypes.CFUNCTYPE(None)(lambda: called.append(1))()
    return [
        subprocess.run(["/bin/echo", "fine"], capture_output=True, text=True, timeout=30).stdout,
        called,
    ]


def test_ordinary_computing_is_allowed():
    assert in_child(_under_the_filter, _ordinary_work, timeout=60) == ["fine\n", [1]]


@pytest.mark.parametrize("machine", seccomp.ARCHITECTURES)
def test_every_jump_stays_within_the_program(machine):
    program = seccomp._program(machine)
    steps = [struct.unpack("HBBI", program[k : k + 8]) for k in range(0, len(program), 8)]
    assert len(steps) < 4096, "as long as the kernel takes"
    for k, (code, if_true, if_false, _) in enumerate(steps):
        if code & 7 == 5:
            assert k + 1 + max(if_true, if_false) < len(steps)
    assert steps[-1] == (6, 0, 0, seccomp.ALLOW)


def test_unknown_machines_are_refused(monkeypatch):
    monkeypatch.setattr(platform, "machine", lambda: "pdp11")
    with pytest.raises(SandboxUnavailableError, match="pdp11"):
        seccomp.require_known_machine()

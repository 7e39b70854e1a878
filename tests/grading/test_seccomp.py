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
from workbook.grading.sandbox.limits import SandboxUnavailableError
from workbook.grading.sandbox.notebook_worker import PR_SET_NO_NEW_PRIVS
from workbook.grading.sandbox.system_calls import system_call
from workbook.notebooks.execution import in_child


def _under_the_filter(function):
    system_call("prctl", PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    seccomp.install_filter()
    return function()


#: What a notebook could do with each call, by the numbers of the kernel's tables for x86_64 and arm64.
#: The list is that of Docker's default profile, as far as a process without privileges can make
#: these calls, with what the head of `seccomp` gives as reasons: it does not depend on the filter.
HARMFUL = {
    "enter a namespace of its own": {"unshare": (272, 97), "setns": (308, 268)},
    "mount what it likes": {
        "mount": (165, 40),
        "umount2": (166, 39),
        "pivot_root": (155, 41),
        "chroot": (161, 51),
        "open_tree": (428, 428),
        "move_mount": (429, 429),
        "fsopen": (430, 430),
        "fsconfig": (431, 431),
        "fsmount": (432, 432),
        "fspick": (433, 433),
        "mount_setattr": (442, 442),
    },
    "hold memory that no limit counts": {
        "memfd_create": (319, 279),
        "memfd_secret": (447, 447),
        "shmget": (29, 194),
        "semget": (64, 190),
        "msgget": (68, 186),
        "mq_open": (240, 180),
        "add_key": (248, 217),
    },
    "look into other processes": {
        "ptrace": (101, 117),
        "process_vm_readv": (310, 270),
        "process_vm_writev": (311, 271),
        "process_madvise": (440, 440),
        "kcmp": (312, 272),
        "pidfd_getfd": (438, 438),
        "perf_event_open": (298, 241),
    },
    "use keys of the session": {"request_key": (249, 218), "keyctl": (250, 219)},
    "run code in the kernel, or stop the kernel at a page": {
        "bpf": (321, 280),
        "userfaultfd": (323, 282),
        "io_uring_setup": (425, 425),
        "io_uring_enter": (426, 426),
        "io_uring_register": (427, 427),
    },
    "see what other notebooks do with a file": {
        "open_by_handle_at": (304, 265),
        "fanotify_init": (300, 262),
        "inotify_init": (253, None),
        "inotify_init1": (294, 26),
        "inotify_add_watch": (254, 27),
    },
    "be counted with other notebooks of its user": {"sendmsg": (46, 211), "sendmmsg": (307, 269)},
    "set limits by which it fails like the grader": {"setrlimit": (160, 164)},
}
NUMBERS = {name: numbers for calls in HARMFUL.values() for name, numbers in calls.items()}


def _filtered(machine, number, *arguments):
    """Return what the filter makes of a system call, by running its program here."""
    audit, _ = seccomp.ARCHITECTURES[machine]
    data = struct.pack("IIQ6Q", number, audit, 0, *arguments, *[0] * (6 - len(arguments)))
    program, place = seccomp._program(machine), 0
    while True:
        code, if_true, if_false, value = struct.unpack_from("HBBI", program, 8 * place)
        place += 1
        if code == 0x20:
            (loaded,) = struct.unpack_from("I", data, value)
        elif code == 0x06:
            return value
        else:
            test = {0x15: loaded == value, 0x35: loaded >= value, 0x45: loaded & value != 0}[code]
            place += if_true if test else if_false


@pytest.mark.parametrize("column, machine", list(enumerate(seccomp.ARCHITECTURES)))
def test_every_harmful_call_is_denied(column, machine):
    numbers = {name: pair[column] for name, pair in NUMBERS.items() if pair[column] is not None}
    denied = {name for name, n in numbers.items() if _filtered(machine, n) == 0x50001}
    assert denied == set(numbers)
    assert _filtered(machine, (0, 63)[column]) == seccomp.ALLOW, "read"


def _denied():
    """Return the result of each harmful call with arguments of zero."""
    libc = ctypes.CDLL(None, use_errno=True)
    column = list(seccomp.ARCHITECTURES).index(platform.machine())
    results = {}
    for name, numbers in NUMBERS.items():
        if numbers[column] is not None:
            ctypes.set_errno(0)
            results[name] = [libc.syscall(numbers[column], 0, 0, 0, 0, 0, 0), ctypes.get_errno()]
    return results


def test_denied_system_calls():
    results = in_child(_under_the_filter, _denied, timeout=60)
    assert results == dict.fromkeys(results, [-1, errno.EPERM]) and len(results) > 40


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
    import asyncio
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
    asyncio.run(asyncio.sleep(0))
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

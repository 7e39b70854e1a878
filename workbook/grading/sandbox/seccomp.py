"""Seccomp: a filter of system calls.

A notebook's process installs it before the first cell. Denied are:

- new namespaces, since in one of its own a process is root and may mount file systems of any size;
- memory that belongs to no process and so escapes every limit;
- access to other processes, and to keys;
- sockets of families that no network namespace confines (vsock reaches a virtual machine's host),
  and options that enlarge their buffers;
- limits of the notebook's own making, by which the kernel would kill it in a way that looks like a
  failure of the grader;
- another treatment of SIGCHLD, since the processor time of children that nobody waits for is not
  counted;
- descriptors on their way through a socket, and larger pipes: the kernel counts both by user, and
  where the grader is not root all notebooks have its user;
- news of what others do with a file: all notebooks see the same libraries, and a lock, a lease or a
  watch on one of these would pass bits from one running notebook to another.

A lock is granted without being taken, for programs that lock their own files. Everything else is
allowed.
"""

import ctypes
import errno
import platform
import signal
import socket
import struct

from workbook.grading.sandbox.limits import SandboxUnavailableError
from workbook.grading.sandbox.system_calls import system_call

PR_SET_SECCOMP, SECCOMP_MODE_FILTER = 22, 2
ALLOW, ERRNO, KILL = 0x7FFF0000, 0x00050000, 0x80000000

#: Audit number of each architecture, and the column of its system call numbers below.
ARCHITECTURES = {"x86_64": (0xC000003E, 0), "aarch64": (0xC00000B7, 1)}
#: On x86_64 a second table of the same system calls begins here.
X32 = 0x40000000

#: In the place of a number that an architecture does not have.
NONE = 0xFFFFFFFF

DENIED = {
    # namespaces and mounts
    "unshare": (272, 97),
    "setns": (308, 268),
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
    # memory that belongs to no process
    "memfd_create": (319, 279),
    "memfd_secret": (447, 447),
    "shmget": (29, 194),
    "semget": (64, 190),
    "msgget": (68, 186),
    "mq_open": (240, 180),
    # descriptors on their way, which the kernel counts by user
    "sendmsg": (46, 211),
    "sendmmsg": (307, 269),
    # limits, which are the grader's to set
    "setrlimit": (160, 164),
    # other processes, keys, and parts of the kernel that no computation needs
    "ptrace": (101, 117),
    "process_vm_readv": (310, 270),
    "process_vm_writev": (311, 271),
    "process_madvise": (440, 440),
    "pidfd_getfd": (438, 438),
    "kcmp": (312, 272),
    "add_key": (248, 217),
    "request_key": (249, 218),
    "keyctl": (250, 219),
    "bpf": (321, 280),
    "perf_event_open": (298, 241),
    "userfaultfd": (323, 282),
    "fanotify_init": (300, 262),
    "open_by_handle_at": (304, 265),
    "inotify_init": (253, NONE),
    "inotify_init1": (294, 26),
    "inotify_add_watch": (254, 27),
    "io_uring_setup": (425, 425),
    "io_uring_enter": (426, 426),
    "io_uring_register": (427, 427),
}
CLONE, CLONE3, SOCKET, SOCKETPAIR, SETSOCKOPT = (
    (56, 220),
    (435, 435),
    (41, 198),
    (53, 199),
    (54, 208),
)
PRLIMIT, SIGACTION = (302, 261), (13, 134)
FLOCK, FCNTL = (73, 32), (72, 25)
#: Commands of `fcntl`: those that lock (two for a process, two for an open file), and those that ask
#: for locks, leases, news of a folder, and a larger pipe.
LOCKING, ASKING = (6, 7, 37, 38), (5, 36, 1024, 1025, 1026, 1031)
#: Any of the flags with which `clone` would make a namespace.
NEW_NAMESPACE = 0x7E020000
FAMILIES = (socket.AF_UNIX, socket.AF_INET, socket.AF_INET6)
#: Options of SOL_SOCKET that set the size of a buffer, the last two whatever the system's limit.
BUFFERS = (socket.SO_SNDBUF, socket.SO_RCVBUF, 32, 33)
#: Offsets of the first arguments of a system call.
FIRST, SECOND, THIRD = 16, 24, 32


def require_known_machine():
    """Raise `SandboxUnavailableError` on a machine for which there is no filter."""
    if platform.machine() not in ARCHITECTURES:
        raise SandboxUnavailableError(
            f"no filter of system calls is known for {platform.machine()}; there is one for "
            f"{' and '.join(ARCHITECTURES)}"
        )


def install_filter():
    """Install the filter in this process and its future children, for good.

    It needs `no_new_privs`.
    """
    program = _program(platform.machine())
    buffer = ctypes.create_string_buffer(program, len(program))
    header = struct.pack("HP", len(program) // 8, ctypes.addressof(buffer))
    system_call("prctl", PR_SET_SECCOMP, SECCOMP_MODE_FILTER, ctypes.c_char_p(header), 0, 0)


def _program(machine):
    """Return the filter as instructions of the classic Berkeley packet filter.

    Its data are the number of the system call, the architecture, ..., the arguments.
    """
    audit, column = ARCHITECTURES[machine]
    program = [_load(4), *_unless_equal(audit, [_return(KILL)]), _load(0)]
    if machine == "x86_64":
        program += [_jump(AT_LEAST, X32, 0, 1), _return(KILL)]
    for numbers in DENIED.values():
        program += _if_equal(numbers[column], [_return(ERRNO | errno.EPERM)])
    # The C library falls back to clone from clone3, whose flags no filter can read.
    program += _if_equal(CLONE3[column], [_return(ERRNO | errno.ENOSYS)])
    program += _if_equal(
        CLONE[column],
        [
            _load(FIRST),
            _jump(ANY_BIT, NEW_NAMESPACE, 0, 1),
            _return(ERRNO | errno.EPERM),
            _return(ALLOW),
        ],
    )
    for call in (SOCKET, SOCKETPAIR):
        families = [
            step for family in FAMILIES for step in _if_equal(int(family), [_return(ALLOW)])
        ]
        program += _if_equal(
            call[column], [_load(FIRST), *families, _return(ERRNO | errno.EAFNOSUPPORT)]
        )
    sizes = [
        step for option in BUFFERS for step in _if_equal(option, [_return(ERRNO | errno.EPERM)])
    ]
    program += _if_equal(
        SETSOCKOPT[column],
        [
            _load(SECOND),
            *_unless_equal(socket.SOL_SOCKET, [_return(ALLOW)]),
            _load(THIRD),
            *sizes,
            _return(ALLOW),
        ],
    )
    program += _if_equal(PRLIMIT[column], _if_null(THIRD))
    program += _if_equal(
        SIGACTION[column],
        [_load(FIRST), *_if_equal(signal.SIGCHLD, _if_null(SECOND)), _return(ALLOW)],
    )
    program += _if_equal(FLOCK[column], [_return(ERRNO)])  # success, without the call
    commands = [
        step
        for numbers, result in ((LOCKING, ERRNO), (ASKING, ERRNO | errno.EPERM))
        for number in numbers
        for step in _if_equal(number, [_return(result)])
    ]
    program += _if_equal(FCNTL[column], [_load(SECOND), *commands, _return(ALLOW)])
    return b"".join([*program, _return(ALLOW)])


def _if_null(pointer):
    """Allow a system call only if the pointer to what it would set is null, in both halves."""
    denied = _unless_equal(0, [_return(ERRNO | errno.EPERM)])
    return [_load(pointer), *denied, _load(pointer + 4), *denied, _return(ALLOW)]


EQUAL, AT_LEAST, ANY_BIT = 0x15, 0x35, 0x45


def _load(offset):
    return struct.pack("HBBI", 0x20, 0, 0, offset)


def _jump(test, value, if_true, if_false):
    return struct.pack("HBBI", test, if_true, if_false, value)


def _return(value):
    return struct.pack("HBBI", 0x06, 0, 0, value)


def _if_equal(value, steps):
    return [_jump(EQUAL, value, 0, len(steps)), *steps]


def _unless_equal(value, steps):
    return [_jump(EQUAL, value, len(steps), 0), *steps]

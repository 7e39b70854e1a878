"""System calls that isolate a process: namespaces, mounts, and the end with its parent."""

import ctypes
import os
import signal

CLONE_NEWNS, CLONE_NEWIPC = 0x20000, 0x8000000
CLONE_NEWUSER, CLONE_NEWPID, CLONE_NEWNET = 0x10000000, 0x20000000, 0x40000000
MS_RDONLY, MS_NOSUID, MS_NODEV, MS_BIND, MS_REC, MS_PRIVATE = 1, 2, 4, 4096, 16384, 1 << 18

PR_SET_PDEATHSIG, PR_SET_DUMPABLE = 1, 4
#: An ioctl on a namespace: open the user namespace that it belongs to.
NS_GET_USERNS = 0xB701

_libc = ctypes.CDLL(None, use_errno=True)


def system_call(name, *arguments):
    """Call a function of the C library; raise `OSError` if it does not return 0."""
    if getattr(_libc, name)(*arguments) != 0:
        number = ctypes.get_errno()
        raise OSError(number, f"{name}: {os.strerror(number)}")


def unshare(flags):
    """Leave namespaces for new ones (Python 3.11 has no `os.unshare`)."""
    system_call("unshare", flags)


def mount(source, target, kind=None, flags=0, options=None):
    """Mount a file system, or with MS_BIND a folder or file."""
    encoded = [value.encode() if value is not None else None for value in (source, target, kind)]
    system_call("mount", *encoded, flags, options.encode() if options else None)


def enter_namespaces(flags):
    """Leave namespaces for new ones, in a new user namespace with the same user."""
    user, group = os.getuid(), os.getgid()
    unshare(CLONE_NEWUSER | flags)
    for name, text in (
        ("setgroups", "deny"),
        ("uid_map", f"{user} {user} 1"),
        ("gid_map", f"{group} {group} 1"),
    ):
        with open(f"/proc/self/{name}", "w") as file:
            file.write(text)


def die_with_parent(parent):
    """Let the kernel kill this process when its parent ends, however that ends.

    `parent` is its pid as it had it when it forked; 0 in a namespace that does not show it.
    """
    system_call("prctl", PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    if os.getppid() != parent:  # it ended before the call, and no signal would come
        os._exit(1)


def address_space_bytes():
    """Return the bytes of address space that this process has."""
    try:
        with open("/proc/self/statm") as file:
            return int(file.read().split()[0]) * os.sysconf("SC_PAGE_SIZE")
    except OSError:
        return 0  # not Linux

"""Make Python on Linux what it is on Windows or macOS, as far as our own modules can see.

Python imports this module at its start where the folder is on PYTHONPATH, so also in child processes.
Environment variables choose what it does:

PLATFORM   win32 or darwin: our modules see this `sys.platform`, and neither modules nor attributes
           that Python lacks there; processes are spawned.
ENCODING   The encoding of the system's language: that of pipes, and of files that name none.
DRIVE      A folder in which names differ by more than their case, and are no names of devices.

Libraries still see Linux: their parts for Windows load what only Windows has. What stays different:
libraries in C, locks, the console.
"""

import asyncio  # noqa: F401 (they take from `os` and `signal` what is hidden below)
import builtins
import contextlib
import errno
import functools
import io
import multiprocessing
import os
import re
import signal
import socket
import sys
import types

OURS = ("workbook", "trajlib", "build", "execute", "judge_trials", "kernel", "settings")
PLATFORM = os.environ.get("PLATFORM", "linux")
ENCODING = os.environ.get("ENCODING", "utf-8")
DRIVE = os.environ.get("DRIVE")
ONLY_LINUX = {
    os: "sched_getaffinity sched_setaffinity O_PATH memfd_create pidfd_open setns unshare"
}
ONLY_UNIX = {
    os: "fork forkpty getuid geteuid getgid getegid getpgid setpgid setsid killpg nice chown fchown "
    "lchown chroot mkfifo mknod sysconf wait wait3 wait4 WNOHANG pipe2 initgroups setgroups "
    "getloadavg uname statvfs O_DIRECTORY O_NOFOLLOW O_NONBLOCK O_CLOEXEC",
    signal: "ITIMER_REAL ITIMER_PROF ITIMER_VIRTUAL setitimer getitimer alarm pause sigwait "
    "pthread_sigmask pthread_kill SIG_BLOCK SIG_UNBLOCK SIG_SETMASK SIGALRM SIGPROF SIGXCPU SIGCHLD "
    "SIGKILL SIGSTOP SIGCONT SIGUSR1 SIGUSR2 SIGHUP SIGPIPE SIGQUIT",
    socket: "AF_UNIX socketpair",
}
MODULES_OF_UNIX = {"fcntl", "grp", "pty", "pwd", "resource", "syslog", "termios", "tty"}
#: Names of devices, with any suffix, and characters that Windows has in no name.
NO_NAME = re.compile(r'(?i:con|prn|aux|nul|com\d|lpt\d)(\..*)?|.*[<>:"|?*\x00-\x1f].*', re.DOTALL)


#: Functions of `os` that take a path first.
BY_PATH = "open stat lstat mkdir unlink remove rmdir listdir scandir chdir access utime"


class Elsewhere(types.ModuleType):
    """A module with other values for some attributes, and without others."""

    def __init__(self, module, missing=(), **others):
        super().__init__(module.__name__)
        self.__dict__.update(_module=module, _missing=frozenset(missing), **others)

    def __getattr__(self, name):
        if name in self._missing:
            raise AttributeError(f"module {self.__name__!r} has no attribute {name!r}")
        return getattr(self._module, name)

    def __setattr__(self, name, value):
        setattr(self._module, name, value)


def hide(platform):
    """Let our modules import what Python has on the platform."""
    missing = {module: set(names.split()) for module, names in ONLY_LINUX.items()}
    if platform == "win32":
        for module, names in ONLY_UNIX.items():
            missing.setdefault(module, set()).update(names.split())
    others = {os: {"name": "nt", "O_BINARY": 0}} if platform == "win32" else {}
    seen = {m.__name__: Elsewhere(m, names, **others.get(m, {})) for m, names in missing.items()}
    seen["sys"] = Elsewhere(sys, platform=platform)
    real_import = builtins.__import__

    def import_elsewhere(name, globals=None, locals=None, fromlist=(), level=0):
        if level == 0 and ((globals or {}).get("__name__") or "").split(".")[0] in OURS:
            if platform == "win32" and name in MODULES_OF_UNIX:
                raise ModuleNotFoundError(f"No module named {name!r}", name=name)
            if name in seen:
                return seen[name]
        return real_import(name, globals, locals, fromlist, level)

    builtins.__import__ = import_elsewhere
    if platform == "win32":
        multiprocessing.get_all_start_methods = lambda: ["spawn"]
        for method in ("fork", "forkserver"):
            multiprocessing.context._concrete_contexts.pop(method)
        multiprocessing.set_start_method("spawn")


def write_and_read_text_as_there(of_system):
    """Let pipes have the encoding, and files that name none, with \\r\\n at the ends of lines."""
    for stream in (sys.stdin, sys.stdout, sys.stderr):
        stream.reconfigure(encoding=of_system, errors=stream.errors)
    real_open = io.open

    def open_there(
        file,
        mode="r",
        buffering=-1,
        encoding=None,
        errors=None,
        newline=None,
        closefd=True,
        opener=None,
    ):
        if "b" not in mode:
            encoding = of_system if encoding in (None, "locale") else encoding
            newline = "\r\n" if newline is None and "r" not in mode else newline
        return real_open(file, mode, buffering, encoding, errors, newline, closefd, opener)

    io.open = builtins.open = open_there


def ignore_case(drive):
    """Let the functions of files find names of a folder in any case, and refuse those of devices."""
    real_listdir = os.listdir

    def listed(folder):
        with contextlib.suppress(FileNotFoundError, NotADirectoryError):
            return real_listdir(folder)
        return []

    def on_disk(path):
        if not isinstance(path, (str, os.PathLike)) or isinstance(os.fspath(path), bytes):
            return path
        full = os.path.abspath(path)
        if full != drive and not full.startswith(drive + os.sep):
            return path
        found = drive
        for part in full[len(drive) :].split(os.sep)[1:]:
            if NO_NAME.fullmatch(part):
                raise OSError(errno.EINVAL, os.strerror(errno.EINVAL), os.fspath(path))
            part = part.rstrip(". ")
            same = [name for name in listed(found) if name.casefold() == part.casefold()]
            found = os.path.join(found, *(same[:1] or [part]))
        return found

    def mapped(function, paths=1):
        @functools.wraps(function)
        def there(*arguments, **keywords):
            head = [on_disk(path) for path in arguments[:paths]]
            return function(*head, *arguments[paths:], **keywords)

        return there

    for name in BY_PATH.split():
        setattr(os, name, mapped(getattr(os, name)))
    for name in ("rename", "replace", "link"):
        setattr(os, name, mapped(getattr(os, name), 2))
    io.open = builtins.open = mapped(io.open)


if "ENCODING" in os.environ:
    write_and_read_text_as_there(ENCODING)
if DRIVE is not None:
    ignore_case(DRIVE)
if PLATFORM != "linux":
    hide(PLATFORM)

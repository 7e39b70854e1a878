"""A process with nothing in sight: bubblewrap from an empty root, without privileges, network or a home.

Inside there are /usr, the interpreter and its packages, and the folder of trajlib (no exercises, no solutions), all
read-only, and an empty /tmp. The environment is empty.
"""

import ctypes
import os
import shutil
import site
import subprocess
import sys
import sysconfig
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]
#: The user that the sandbox runs as when the grader itself is root: limits on processes do not bind root.
NOBODY = 65534

CLONE_NEWNS, CLONE_NEWIPC, CLONE_NEWUSER, CLONE_NEWPID, CLONE_NEWNET = 0x20000, 0x8000000, 0x10000000, 0x20000000, 0x40000000
MS_NOSUID, MS_NODEV, MS_BIND, MS_REC, MS_PRIVATE = 2, 4, 4096, 16384, 1 << 18

_libc = ctypes.CDLL(None, use_errno=True)


class NoIsolation(RuntimeError):
    """This machine offers no sandbox; the message says what is missing."""


def system_call(name, *arguments):
    """A call of the C library that raises `OSError` when it fails."""
    if getattr(_libc, name)(*arguments) != 0:
        number = ctypes.get_errno()
        raise OSError(number, f"{name}: {os.strerror(number)}")


def unshare(flags):
    """Leave namespaces (Python 3.11 has no `os.unshare`)."""
    system_call("unshare", flags)


def mount(source, target, kind=None, flags=0, options=None):
    encoded = [value.encode() if value is not None else None for value in (source, target, kind)]
    system_call("mount", *encoded, flags, options.encode() if options else None)


def visible():
    """The only folders of this machine that a sandboxed process sees besides /usr."""
    packages = {Path(path) for path in [*site.getsitepackages(), sysconfig.get_paths()["purelib"]] if Path(path).is_dir()}
    prefixes = {Path(sys.base_prefix), Path(sys.executable).parent, Path(sys.prefix) / "pyvenv.cfg", *packages, PACKAGE}
    # The interpreter is often a chain of links out of the environment: every link on the way has to be there.
    prefixes.add(Path(os.path.realpath(sys.base_prefix)))
    shown = sorted(path for path in prefixes if path.exists() and not path.is_relative_to("/usr"))
    return [path for path in shown if not any(other != path and path.is_relative_to(other) for other in shown)]


def spawn(module, arguments=()):
    """Start `python -m module` in a sandbox; returns the `Popen` with binary pipes on stdin and stdout.

    Raises `NoIsolation` where bubblewrap is missing or the system forbids what it needs.
    """
    bwrap = shutil.which("bwrap")
    if bwrap is None:
        raise NoIsolation("bubblewrap is not installed (on Debian and Ubuntu: apt install bubblewrap)")
    folders = visible()
    as_root = os.getuid() == 0
    # Root hands the folders over under /mnt of a mount namespace of its own, since nobody may not enter /root.
    source = {path: f"/mnt/{k}" if as_root else str(path) for k, path in enumerate(folders)}
    command = [bwrap, "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL", "--clearenv",
               "--setenv", "HOME", "/tmp", "--setenv", "PATH", "/usr/bin", "--setenv", "LANG", "C.UTF-8",
               "--setenv", "MPLBACKEND", "Agg", "--setenv", "MPLCONFIGDIR", "/tmp/matplotlib", "--setenv", "OPENBLAS_NUM_THREADS", "1",
               "--ro-bind", "/usr", "/usr", "--symlink", "usr/lib", "/lib", "--symlink", "usr/lib64", "/lib64", "--symlink", "usr/bin", "/bin",
               "--proc", "/proc", "--dev", "/dev", "--tmpfs", "/tmp", "--chdir", "/tmp"]
    for path in folders:
        command += ["--ro-bind", source[path], str(path)]
    # Nothing outside /tmp and /dev/shm can be written, so no notebook leaves anything for the next.
    command += ["--remount-ro", "/dev", "--remount-ro", "/", sys.executable, "-E", "-s", "-m", module, *map(str, arguments)]

    def hand_over():
        if as_root:
            unshare(CLONE_NEWNS)
            mount("none", "/", flags=MS_REC | MS_PRIVATE)
            mount("tmpfs", "/mnt", "tmpfs", options="mode=755")
            for path in folders:
                _touch_like(path, source[path])
                mount(str(path), source[path], flags=MS_BIND | MS_REC)
            os.setgroups([])
            os.setresgid(NOBODY, NOBODY, NOBODY)
            os.setresuid(NOBODY, NOBODY, NOBODY)

    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            preexec_fn=hand_over, close_fds=True, env={})


def _touch_like(path, target):
    """An empty folder or file at `target` to mount `path` on."""
    if path.is_dir():
        os.mkdir(target)
    else:
        with open(target, "xb"):
            pass

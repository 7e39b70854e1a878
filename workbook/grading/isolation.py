"""A process with nothing in sight: bubblewrap from an empty root, without privileges, network or a
home.

Inside there are /usr, the interpreter and its packages, and the folders of trajlib and workbook (no
exercises, no solutions), all read-only, and an empty /tmp. The environment is empty.
"""

import ctypes
import fcntl
import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]
CHECKOUT = PACKAGE.parent
LIBRARY = CHECKOUT / "trajlib"
#: Where a notebook may write: into memory, as much as it is allowed.
SCRATCH = ("/tmp", "/dev/shm")
#: All that a notebook finds in its environment.
ENVIRONMENT = {
    "HOME": "/tmp",
    "PATH": "/usr/bin",
    "LANG": "C.UTF-8",
    "MPLBACKEND": "Agg",
    "MPLCONFIGDIR": "/tmp/matplotlib",
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    # Each thread of the C library would reserve a great deal of address space, which is
    # what the limit on memory counts.
    "MALLOC_ARENA_MAX": "2",
    # What it has freed it keeps for the next formula: the kernel would have to clear
    # every page anew.
    "MALLOC_MMAP_THRESHOLD_": str(2**25),
    "MALLOC_TRIM_THRESHOLD_": str(2**26),
}
#: The user that the sandbox runs as when the grader itself is root: limits on processes do not bind
#: root.
NOBODY = 65534

CLONE_NEWNS, CLONE_NEWIPC = 0x20000, 0x8000000
CLONE_NEWUSER, CLONE_NEWPID, CLONE_NEWNET = 0x10000000, 0x20000000, 0x40000000
MS_RDONLY, MS_NOSUID, MS_NODEV, MS_BIND, MS_REC, MS_PRIVATE = 1, 2, 4, 4096, 16384, 1 << 18

PR_SET_PDEATHSIG, PR_SET_DUMPABLE = 1, 4
#: Of a namespace: the user namespace that it belongs to.
NS_GET_USERNS = 0xB701

_libc = ctypes.CDLL(None, use_errno=True)


class NoIsolation(RuntimeError):
    """This machine offers no sandbox; the message says what is missing."""


class NotStarted(NoIsolation):
    """A process of the grader ended, or was too slow, while it got ready, again and again: no word
    on whether the machine offers a sandbox."""


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
    """The only folders of this machine that a sandboxed process sees besides /usr; `covered` are
    empty there."""
    prefixes = {
        Path(sys.base_prefix),
        Path(sys.executable).parent,
        Path(sys.prefix) / "pyvenv.cfg",
        *_packages(),
        PACKAGE,
        LIBRARY,
    }
    # The interpreter is often a chain of links out of the environment: every link on the way has to
    # be there.
    prefixes.add(Path(os.path.realpath(sys.base_prefix)))
    return sorted(path for path in prefixes if path.exists() and not path.is_relative_to("/usr"))


def covered():
    """Folders in a visible one that are not to be seen all the same: a wheel's exercises; a
    checkout's, should it lie in /usr."""
    inside = [PACKAGE / "_exercises"]
    if (CHECKOUT / "pyproject.toml").exists():
        inside += CHECKOUT.iterdir()
    shown = visible()
    return sorted(
        path
        for path in inside
        if path.is_dir()
        and shown_through(path)
        and not any(other.is_relative_to(path) for other in shown)
    )


def shown_through(path):
    """The visible folder through which notebooks could read `path`, or None."""
    path = Path(path).resolve()
    return next(
        (folder for folder in [Path("/usr"), *visible()] if path.is_relative_to(folder)), None
    )


def _packages():
    """Where the libraries are, also those of the user or of the system beside an environment."""
    return [
        Path(path)
        for path in sys.path
        if Path(path).name in ("site-packages", "dist-packages") and Path(path).is_dir()
    ]


def bubblewrap():
    """Where bubblewrap is. Raises `NoIsolation` where there is none."""
    found = shutil.which("bwrap")
    if found is None:
        raise NoIsolation(
            "bubblewrap is not installed (on Debian and Ubuntu: apt install bubblewrap)"
        )
    return found


def spawn_once(bwrap, limits, modules):
    """Start a worker for a single notebook in a sandbox; returns the `Popen` with binary pipes on
    stdin and stdout.

    For systems that let nobody into a sandbox that is there already, or allow no namespaces inside
    one. `limits` are those of `sandbox.Limits`, as a dict; `modules` (names) are imported before
    the notebook comes. Raises `NoIsolation` where bubblewrap cannot be run.
    """
    inside = python(
        f"from workbook.grading import worker; worker.once({limits!r}, {list(modules)!r})"
    )
    # The first process of a namespace cannot be killed from inside.
    command, hand_over = _sandbox(bwrap, limits, ["--as-pid-1"], inside)
    try:
        # In a session of its own, so that Ctrl-C reaches the grader alone, which then ends its
        # sandboxes.
        return subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            preexec_fn=hand_over,
            close_fds=True,
            start_new_session=True,
            env={},
        )
    except (OSError, subprocess.SubprocessError) as error:
        raise NoIsolation(f"the sandbox does not start here: {error}") from None


def enter(bwrap, limits):
    """Make a sandbox, and go on inside it: this returns in a child of this process, which itself
    waits for the child and ends as it does. Raises `OSError` where the system lets nobody in.

    For a process that was forked with all that notebooks need, and has nothing else in it.
    """
    parent, (told, tell) = os.getppid(), os.pipe()
    (stays, holds), (hears, says) = os.pipe(), os.pipe()
    # What holds the sandbox says back what it is told: then bubblewrap has done its work. It ends
    # with its input.
    command, hand_over = _sandbox(bwrap, limits, ["--info-fd", str(tell)], ["/usr/bin/cat"])
    holder = subprocess.Popen(
        command, stdin=stays, stdout=says, preexec_fn=hand_over, pass_fds=[tell], env={}
    )
    for descriptor in (tell, stays, says):
        os.close(descriptor)
    os.write(holds, b"?")
    if not os.read(hears, 1):
        code = holder.wait()
        os._exit(code if code > 0 else 128 - code)
    with open(told) as file:
        inside = json.load(file)["child-pid"]
    if os.getuid() == 0:
        _become_nobody()
    _join(inside)
    end_with_parent(parent)  # which changing what one may do takes back
    _go_on_in_a_child()
    os.closerange(3, 4096)


def enter_own_namespace():
    """Inside a sandbox, go on in a child with a namespace of processes of its own, and the right to
    make further ones; returns a function after which the next child begins one of these."""
    enter_namespaces(CLONE_NEWPID)
    _go_on_in_a_child()
    own = os.open("/proc/self/ns/pid", os.O_RDONLY)

    def apart():
        system_call("setns", own, CLONE_NEWPID)  # or it could be left once only
        unshare(CLONE_NEWPID)

    return apart


def enter_namespaces(flags):
    """Leave namespaces for new ones, in a user namespace with the same user."""
    user, group = os.getuid(), os.getgid()
    unshare(CLONE_NEWUSER | flags)
    for name, text in (
        ("setgroups", "deny"),
        ("uid_map", f"{user} {user} 1"),
        ("gid_map", f"{group} {group} 1"),
    ):
        with open(f"/proc/self/{name}", "w") as file:
            file.write(text)


def _go_on_in_a_child():
    """Return in a child, of a namespace from which this process is not to be seen; this one ends as
    the child does."""
    child = os.fork()
    if child == 0:
        end_with_parent(0)
        return
    os.close(0), os.close(1)  # so that the grader sees the child's end
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    os._exit(code if code >= 0 else 128 - code)


def _join(process):
    """Enter all namespaces of another process; of pids only children of this one do."""
    kinds = ("mnt", "net", "ipc", "uts", "pid", "user")
    opened = [os.open(f"/proc/{process}/ns/{kind}", os.O_RDONLY) for kind in kinds]
    # Bubblewrap makes the others in one user namespace, and then a second one, without its rights,
    # inside that.
    for namespace in [fcntl.ioctl(opened[0], NS_GET_USERNS), *opened]:
        system_call("setns", namespace, 0)
        os.close(namespace)
    system_call("prctl", PR_SET_DUMPABLE, 1, 0, 0, 0)  # its own /proc is its own again


def _become_nobody():
    os.setgroups([])
    os.setresgid(NOBODY, NOBODY, NOBODY)
    os.setresuid(NOBODY, NOBODY, NOBODY)
    system_call("prctl", PR_SET_DUMPABLE, 1, 0, 0, 0)


def _sandbox(bwrap, limits, options, inside):
    """(command, what its process does first) of a sandbox with the process `inside` in it."""
    folders = visible()
    as_root = os.getuid() == 0
    # Root hands the folders over under /mnt of a mount namespace of its own, since nobody may not
    # enter /root.
    source = {path: f"/mnt/{k}" if as_root else str(path) for k, path in enumerate(folders)}
    command = [
        bwrap,
        "--unshare-all",
        "--die-with-parent",
        "--new-session",
        "--cap-drop",
        "ALL",
        "--clearenv",
        "--ro-bind",
        "/usr",
        "/usr",
        "--symlink",
        "usr/lib",
        "/lib",
        "--symlink",
        "usr/lib64",
        "/lib64",
        "--symlink",
        "usr/bin",
        "/bin",
        # Debian's libraries find one another through these.
        "--ro-bind-try",
        "/etc/alternatives",
        "/etc/alternatives",
        "--ro-bind-try",
        "/etc/ld.so.cache",
        "/etc/ld.so.cache",
        "--proc",
        "/proc",
        "--dev",
        "/dev",
        "--chdir",
        "/tmp",
    ]
    for folder in SCRATCH:
        command += ["--size", str(limits["disk_megabytes"] * 2**20), "--tmpfs", folder]
    for name, value in ENVIRONMENT.items():
        command += ["--setenv", name, value]
    for path in folders:
        command += ["--ro-bind", source[path], str(path)]
    for path in covered():
        command += ["--tmpfs", str(path), "--remount-ro", str(path)]
    # Nothing outside /tmp and /dev/shm can be written, so no notebook leaves anything for the next.
    command += [*options, "--remount-ro", "/dev", "--remount-ro", "/", *inside]
    grader = os.getpid()

    def hand_over():
        if as_root:
            unshare(CLONE_NEWNS)
            mount("none", "/", flags=MS_REC | MS_PRIVATE)
            mount("tmpfs", "/mnt", "tmpfs", options="mode=755")
            for path in folders:
                _touch_like(path, source[path])
                mount(str(path), source[path], flags=MS_BIND | MS_REC)
            _become_nobody()
        end_with_parent(grader)

    return command, hand_over


def end_with_parent(parent):
    """Let the kernel kill this process when its parent ends, however that ends; `parent` is the
    number it had for the one who forks, 0 in a namespace where that one is not to be seen."""
    system_call("prctl", PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    if os.getppid() != parent:  # it ended before we asked, and nothing would ever tell
        os._exit(1)


def loaded():
    """Bytes of address space that this process has already: limits on memory are for what comes on
    top."""
    try:
        with open("/proc/self/statm") as file:
            return int(file.read().split()[0]) * os.sysconf("SC_PAGE_SIZE")
    except OSError:
        return 0  # not Linux


def python(code):
    """The command that runs `code` in a fresh interpreter, isolated from variables, the user's
    folders and the current one; libraries are found where the grader itself found them."""
    paths = [str(path) for path in _packages()]
    found = (
        "import sys; of_packages = [k for k, path in enumerate(sys.path) if "
        "path.endswith('-packages')]\n"
        # Before all packages, among which may be another workbook; behind Python's own
        # library.
        "sys.path.insert(of_packages[0] if of_packages else len(sys.path), "
        f"{str(PACKAGE.parent)!r})\n"
        f"sys.path += [path for path in {paths!r} if path not in sys.path]\n"
    )
    return [sys.executable, "-I", "-c", found + code]


def environment_outside():
    """The environment of a process of ours from which notebooks' processes are forked: nothing of
    the grader's own."""
    # The list of fonts, which takes a second to make; no folder that others could have prepared, as
    # they could in /tmp.
    return ENVIRONMENT | {
        "HOME": "/nonexistent",
        "MPLCONFIGDIR": os.path.expanduser("~/.cache/matplotlib"),
    }


def _touch_like(path, target):
    """An empty folder or file at `target` to mount `path` on."""
    if path.is_dir():
        os.mkdir(target)
    else:
        with open(target, "xb"):
            pass

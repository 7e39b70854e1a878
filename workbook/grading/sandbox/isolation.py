"""Isolation: a process in a bubblewrap sandbox, built from an empty root.

It has no privileges, no network and no home. Inside there are /usr, the interpreter and its
packages, and the folders of trajlib and workbook (no exercises, no solutions), all read-only, and
an empty /tmp. The environment has only `ENVIRONMENT`.
"""

import fcntl
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

from workbook.grading.sandbox.limits import SandboxUnavailableError
from workbook.grading.sandbox.system_calls import (
    CLONE_NEWNS,
    CLONE_NEWPID,
    MS_BIND,
    MS_PRIVATE,
    MS_REC,
    NS_GET_USERNS,
    PR_SET_DUMPABLE,
    die_with_parent,
    enter_namespaces,
    mount,
    system_call,
    unshare,
)

PACKAGE = Path(__file__).resolve().parents[2]
CHECKOUT = PACKAGE.parent
LIBRARY = CHECKOUT / "trajlib"
#: Where a notebook may write: file systems in memory, of limited size.
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
    # Freed memory is kept for the next formula: else the kernel would clear every page anew.
    "MALLOC_MMAP_THRESHOLD_": str(2**25),
    "MALLOC_TRIM_THRESHOLD_": str(2**26),
}
#: The users that sandboxes run as when the grader itself is root, whom limits on processes do not
#: bind: one each, by the pid of the process that makes the sandbox. The kernel counts descriptors in
#: flight, pending signals and the buffers of pipes by user, and two notebooks of one user could tell
#: each other something by these counts. No system gives out numbers from the first one on; where it
#: is not available, as in some containers, all sandboxes run as nobody.
FIRST_USER, NOBODY = 0x70000000, 65534


def visible_paths():
    """Return the only paths of this machine that a sandboxed process sees besides /usr.

    `hidden_folders` within them are empty there.
    """
    paths = {
        Path(sys.base_prefix),
        Path(sys.executable).parent,
        Path(sys.prefix) / "pyvenv.cfg",
        *_package_folders(),
        PACKAGE,
        LIBRARY,
    }
    # The interpreter is often a chain of links out of the environment: every link must be visible.
    paths.add(Path(os.path.realpath(sys.base_prefix)))
    return sorted(path for path in paths if path.exists() and not path.is_relative_to("/usr"))


def hidden_folders():
    """Return folders within visible ones that are to be empty in the sandbox.

    These are a wheel's exercises, and the other folders of a checkout within a visible folder.
    """
    inside = [PACKAGE / "_exercises"]
    if (CHECKOUT / "pyproject.toml").exists():
        inside += CHECKOUT.iterdir()
    visible = visible_paths()
    return sorted(
        path
        for path in inside
        if path.is_dir()
        and visible_parent(path)
        and not any(shown.is_relative_to(path) for shown in visible)
    )


def visible_parent(path):
    """Return the visible folder through which notebooks could read `path`, or None."""
    path = Path(path).resolve()
    return next(
        (folder for folder in [Path("/usr"), *visible_paths()] if path.is_relative_to(folder)), None
    )


def _package_folders():
    """Return the folders of libraries, also those of the user or the system."""
    return [
        Path(path)
        for path in sys.path
        if Path(path).name in ("site-packages", "dist-packages") and Path(path).is_dir()
    ]


def find_bubblewrap():
    """Return the path of bubblewrap; raise `SandboxUnavailableError` if it is not installed."""
    path = shutil.which("bwrap")
    if path is None:
        raise SandboxUnavailableError(
            "bubblewrap is not installed (on Debian and Ubuntu: apt install bubblewrap)"
        )
    return path


def spawn_sandboxed(bwrap, limits, code):
    """Run Python code in a sandbox of its own; return the `Popen` with binary pipes.

    For systems that let no process enter an existing sandbox, or allow no namespaces inside one.

    Parameters
    ----------
    bwrap : str
        Path of bubblewrap.
    limits : dict
        As of `limits.Limits`.
    code : str
        What the interpreter inside runs.

    Raises
    ------
    SandboxUnavailableError
        Where bubblewrap cannot be run.
    """
    # The first process of a namespace cannot be killed from inside.
    command, prepare = _sandbox_command(bwrap, limits, ["--as-pid-1"], python_command(code))
    try:
        # In a session of its own, so that Ctrl-C reaches the grader alone, which then ends its
        # sandboxes.
        return subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            preexec_fn=prepare,
            close_fds=True,
            start_new_session=True,
            env={},
        )
    except (OSError, subprocess.SubprocessError) as error:
        raise SandboxUnavailableError(f"the sandbox does not start here: {error}") from None


def enter_sandbox(bwrap, limits):
    """Make a sandbox and return inside it, in a child of this process.

    This process itself waits for the child and exits as it does. It is one that was forked with
    all that notebooks need, and holds nothing else. Raises `OSError` where the system lets no
    process enter a sandbox.
    """
    parent, (info, info_end) = os.getppid(), os.pipe()
    (holder_input, holder_writer), (holder_reader, holder_output) = os.pipe(), os.pipe()
    # `cat` holds the sandbox open and ends with its input; when it echoes a byte, bubblewrap has
    # done its work.
    command, prepare = _sandbox_command(
        bwrap, limits, ["--info-fd", str(info_end)], ["/usr/bin/cat"]
    )
    holder = subprocess.Popen(
        command,
        stdin=holder_input,
        stdout=holder_output,
        preexec_fn=prepare,
        pass_fds=[info_end],
        env={},
    )
    for descriptor in (info_end, holder_input, holder_output):
        os.close(descriptor)
    os.write(holder_writer, b"?")
    if not os.read(holder_reader, 1):
        code = holder.wait()
        os._exit(code if code > 0 else 128 - code)
    with open(info) as file:
        pid = json.load(file)["child-pid"]
    if os.getuid() == 0:
        _become(sandbox_user())
    _join_namespaces(pid)
    die_with_parent(parent)  # a change of user or namespaces undoes it
    _continue_in_child()
    os.closerange(3, 4096)


def enter_pid_namespace():
    """Inside a sandbox, return in a child that has a PID namespace of its own.

    Returns a function after which the next child is the first of a further PID namespace.
    """
    enter_namespaces(CLONE_NEWPID)
    _continue_in_child()
    namespace = os.open("/proc/self/ns/pid", os.O_RDONLY)

    def before_fork():
        system_call("setns", namespace, CLONE_NEWPID)  # or it could be left only once
        unshare(CLONE_NEWPID)

    return before_fork


def _continue_in_child():
    """Return in a child whose namespace does not show its parent, which exits as it does."""
    child = os.fork()
    if child == 0:
        die_with_parent(0)
        return
    os.close(0), os.close(1)  # so that the grader sees the child's end
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    os._exit(code if code >= 0 else 128 - code)


def _join_namespaces(pid):
    """Enter all namespaces of another process; the PID namespace only for future children."""
    kinds = ("mnt", "net", "ipc", "uts", "pid", "user")
    opened = [os.open(f"/proc/{pid}/ns/{kind}", os.O_RDONLY) for kind in kinds]
    # Bubblewrap makes the other namespaces in one user namespace, and inside it a second user
    # namespace without rights over them.
    for namespace in [fcntl.ioctl(opened[0], NS_GET_USERNS), *opened]:
        system_call("setns", namespace, 0)
        os.close(namespace)
    system_call("prctl", PR_SET_DUMPABLE, 1, 0, 0, 0)  # so that its files in /proc are its own


def sandbox_user():
    """Return the user as whom the sandboxes of this process run, if it is root."""
    user = FIRST_USER + os.getpid()
    with open("/proc/self/uid_map") as users, open("/proc/self/gid_map") as groups:
        available = all(
            any(int(first) <= user < int(first) + int(count) for first, _, count in ranges)
            for ranges in (map(str.split, users), map(str.split, groups))
        )
    return user if available else NOBODY


def _become(user):
    """Become a user without rights, and the group of the same number."""
    os.setgroups([])
    os.setresgid(user, user, user)
    os.setresuid(user, user, user)
    system_call("prctl", PR_SET_DUMPABLE, 1, 0, 0, 0)


def _sandbox_command(bwrap, limits, options, inside):
    """Return (command of a sandbox around the command `inside`, what to call before its exec)."""
    folders = visible_paths()
    as_root = os.getuid() == 0
    # Root binds the folders under /mnt of a mount namespace of its own, since the user nobody
    # cannot enter /root.
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
    for path in hidden_folders():
        command += ["--tmpfs", str(path), "--remount-ro", str(path)]
    # Nothing outside /tmp and /dev/shm can be written, so no notebook leaves anything for the next.
    command += [*options, "--remount-ro", "/dev", "--remount-ro", "/", *inside]
    grader, user = os.getpid(), sandbox_user()

    def prepare():
        if as_root:
            unshare(CLONE_NEWNS)
            mount("none", "/", flags=MS_REC | MS_PRIVATE)
            mount("tmpfs", "/mnt", "tmpfs", options="mode=755")
            for path in folders:
                _make_mount_point(path, source[path])
                mount(str(path), source[path], flags=MS_BIND | MS_REC)
            _become(user)
        die_with_parent(grader)

    return command, prepare


def python_command(code):
    """Return the command that runs `code` in a fresh, isolated interpreter.

    It ignores variables, the user's folders and the current one, and finds libraries where the
    grader itself found them.
    """
    paths = [str(path) for path in _package_folders()]
    set_path = (
        "import sys; of_packages = [k for k, path in enumerate(sys.path) if "
        "path.endswith('-packages')]\n"
        # Before all packages, among which may be another workbook; behind Python's own library.
        "sys.path.insert(of_packages[0] if of_packages else len(sys.path), "
        f"{str(PACKAGE.parent)!r})\n"
        f"sys.path += [path for path in {paths!r} if path not in sys.path]\n"
    )
    return [sys.executable, "-I", "-c", set_path + code]


def grader_environment():
    """Return the environment of a process from which notebooks' processes are forked.

    It has nothing of the grader's own environment.
    """
    # Matplotlib's list of fonts takes a second to make, so it is the user's own; not one in a
    # folder that others could have prepared, as they could in /tmp.
    return ENVIRONMENT | {
        "HOME": "/nonexistent",
        "MPLCONFIGDIR": os.path.expanduser("~/.cache/matplotlib"),
    }


def _make_mount_point(path, target):
    """Make an empty folder or file at `target` to mount `path` on."""
    if path.is_dir():
        os.mkdir(target)
    else:
        with open(target, "xb"):
            pass

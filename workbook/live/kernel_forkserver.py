"""Forkserver of kernels: imports once what lectures use, forks a kernel for each request.

    python -m workbook.live.kernel_forkserver SOCKET

is the forkserver. It imports `LIBRARIES` and the modules that a line of its standard input names as
JSON, then answers requests on the socket. It exits with its kernels when its standard input closes,
so that it outlives no parent process. On Windows, where nothing forks, there is none.
"""

import importlib
import json
import os
import select
import signal
import socket
import sys
import traceback
from contextlib import suppress

#: Environment variable with the path of the socket.
SOCKET = "WORKBOOK_LIVE_KERNELS"
NO_FORK = "Windows forks no process"
#: Modules that cells of lectures and the magics load, most of them only when a function is called.
LIBRARIES = (
    "ipykernel.kernelapp",
    "matplotlib.pyplot",
    "scipy.integrate",
    "scipy.linalg",
    "scipy.optimize",
    "jupytext.myst",
    "yaml",
    "workbook.live.magics",
    "workbook.live.counterexample",
    "scipy.ndimage",
    "workbook.authoring.master",
    "workbook.authoring.mistakes",
    "workbook.authoring.student_notebook",
    "workbook.live.catch_up",
    "workbook.display.results",
    "trajlib.plotting.curves",
    "trajlib.plotting.parameter_plane",
    "trajlib.plotting.phase_plane",
)


def skip_rfc3987_grammars():
    """Keep jsonschema from building grammars for rfc3987 formats, which takes over a second.

    Jupyter loads jsonschema but checks no such format.
    """
    sys.modules.setdefault("rfc3987_syntax", None)


def modules_of_problems(numbers):
    """Return the names of our modules that the cells of problems use; takes a third of a second."""
    # the forkserver has nothing to do with masters, and starts sooner without them
    from workbook.notebooks import exercises
    from workbook.notebooks.dependencies import module_closure

    texts = [exercises.master_path(number).read_text(encoding="utf-8") for number in numbers]
    cells = [
        block.split("```")[0].split("]\n", 1)[-1]
        for text in texts
        for block in text.split("```{code-cell}")[1:]
    ]
    return list(module_closure("\n".join(["import trajlib, workbook", *cells])))


def serve(address):
    """Run the forkserver on a socket until standard input closes."""
    if sys.platform == "win32":
        raise OSError(NO_FORK)
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(address)
        listener.listen()
        signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # no zombies of kernels that end
        _import_all()
        kernels = []
        while True:
            ready, _, _ = select.select([listener, sys.stdin], [], [])
            if sys.stdin in ready and not os.read(sys.stdin.fileno(), 1):
                break
            if listener in ready:
                with listener.accept()[0] as connection:
                    kernels.append(_fork_kernel(connection, listener))
    for pid in kernels:
        with suppress(ProcessLookupError):
            os.killpg(pid, signal.SIGKILL)


def request_kernel(address, request):
    """Request a kernel from the forkserver at a socket and return its process id.

    Parameters
    ----------
    address : str
        Path of the socket.
    request : dict
        `connection_file` (path), `env` (environment) and `folder` (path) of the kernel.

    Returns
    -------
    int
        The process id.

    Raises
    ------
    OSError
        If the forkserver is not there or forks no kernel.
    """
    if sys.platform == "win32":
        raise OSError(NO_FORK)
    with socket.socket(socket.AF_UNIX) as connection:
        connection.settimeout(60)
        connection.connect(address)
        connection.sendall(json.dumps(request).encode() + b"\n")
        with connection.makefile() as reply:
            pid = int(reply.readline() or "0")
    if not pid:
        raise ConnectionError(f"no kernel from {address}")
    return pid


def _import_all():
    # in the forkserver alone
    from workbook.grading.sandbox.preloading import SYMPY, freeze_new_objects, warm_up_matplotlib

    with freeze_new_objects():
        os.environ["MPLBACKEND"] = "module://matplotlib_inline.backend_inline"
        skip_rfc3987_grammars()
        # jupytext imports it where it is, and does not need it
        sys.modules["jupyter_server"] = None
        for name in (*LIBRARIES, *SYMPY):
            importlib.import_module(name)
        # The parent has found these meanwhile. Read without a buffer, since `select` in `serve`
        # would not see what a buffer holds.
        for name in json.loads(sys.stdin.buffer.raw.readline() or "[]"):
            importlib.import_module(name)
        # modules that compute with it load it late
        if any("casadi" in name or ".optima." in name for name in sys.modules):
            importlib.import_module("casadi")
        warm_up_matplotlib("png")
        del sys.modules["rfc3987_syntax"], sys.modules["jupyter_server"]


def _fork_kernel(connection, listener):
    if sys.platform == "win32":
        raise OSError(NO_FORK)
    with connection.makefile() as lines:
        request = json.loads(lines.readline())
    pid = os.fork()
    if pid == 0:
        connection.close()
        listener.close()
        _run_kernel(request)
    connection.sendall(f"{pid}\n".encode())
    return pid


def _run_kernel(request):
    """Run a kernel in the fork, as `python -m ipykernel_launcher` does; never returns."""
    if sys.platform == "win32":
        raise OSError(NO_FORK)
    try:
        os.setsid()
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        os.environ.clear()
        os.environ.update(request["env"])
        os.chdir(request["folder"])
        sys.path[0] = ""
        import numpy

        # all forks have the same state; Python's `random` does this by itself
        numpy.random.seed()
        from ipykernel.kernelapp import IPKernelApp

        app = IPKernelApp.instance()
        app.initialize(
            [
                f"--f={request['connection_file']}",
                f"--IPKernelApp.parent_handle={os.getppid()}",
                "--HistoryManager.hist_file=:memory:",
            ]
        )
        app.start()
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(0)


if __name__ == "__main__":
    serve(sys.argv[1])

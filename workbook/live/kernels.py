"""Kernels that are ready at once: forks of a process that has imported all that a lecture uses.

    python -m workbook.live.kernels SOCKET

is that process. It imports what every lecture uses and the modules that a line of its standard
input names, then forks a kernel for every request that comes by its socket. It ends, with its
kernels, when its standard input does: whoever started it need not come back to end it.
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

#: The variable of the environment that names the socket.
SOCKET = "WORKBOOK_LIVE_KERNELS"
#: What cells of lectures and the magics load beside trajlib, most of it only when a function is
#: called.
LIBRARIES = (
    "ipykernel.kernelapp",
    "matplotlib.pyplot",
    "scipy.integrate",
    "scipy.linalg",
    "scipy.optimize",
    "jupytext.myst",
    "yaml",
    "workbook.live.magics",
    "workbook.live.counterexamples",
    "scipy.ndimage",
    "workbook.authoring.master",
    "workbook.authoring.mistakes",
    "workbook.authoring.student_notebook",
    "workbook.live.catching_up",
    "workbook.display.results",
    "trajlib.plotting.curves",
    "trajlib.plotting.parameter_plane",
    "trajlib.plotting.phase_plane",
)


def without_grammars():
    """jsonschema, which Jupyter loads, would build the grammars of a checker that nothing here
    asks: over a second."""
    sys.modules.setdefault("rfc3987_syntax", None)


def modules_for(numbers):
    """Our modules that the cells of some problems use; to find them takes a third of a second."""
    from workbook.authoring.contract import master_file
    from workbook.notebooks import exercises
    from workbook.notebooks.dependencies import module_closure

    texts = [
        (exercises.CHECKOUT / "solutions" / master_file(number)).read_text(encoding="utf-8")
        for number in numbers
    ]
    cells = [
        block.split("```")[0].split("]\n", 1)[-1]
        for text in texts
        for block in text.split("```{code-cell}")[1:]
    ]
    return list(module_closure("\n".join(["import trajlib, workbook", *cells])))


def serve(address):
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(address)
        listener.listen()
        signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # nobody waits for a kernel that ends
        _import_all()
        kernels = []
        while True:
            ready, _, _ = select.select([listener, sys.stdin], [], [])
            if sys.stdin in ready and not os.read(sys.stdin.fileno(), 1):
                break
            if listener in ready:
                with listener.accept()[0] as connection:
                    kernels.append(_answer(connection, listener))
    for pid in kernels:
        with suppress(ProcessLookupError):
            os.killpg(pid, signal.SIGKILL)


def ask(address, request):
    """Ask the process at `address` for a kernel; returns its number. Raises `OSError` if nobody is
    there."""
    with socket.socket(socket.AF_UNIX) as connection:
        connection.settimeout(60)
        connection.connect(address)
        connection.sendall(json.dumps(request).encode() + b"\n")
        with connection.makefile() as answer:
            return int(answer.readline() or "0") or _nobody(address)


def _nobody(address):
    raise ConnectionError(f"no kernel from {address}")


def _import_all():
    from workbook.grading.preloading import SYMPY, freeze_new_objects, warm_up_matplotlib

    with freeze_new_objects():
        os.environ["MPLBACKEND"] = "module://matplotlib_inline.backend_inline"
        without_grammars()
        # jupytext would import a server, and do without one
        sys.modules["jupyter_server"] = None
        for name in (*LIBRARIES, *SYMPY):
            importlib.import_module(name)
        # found meanwhile by who started this; read without a buffer, in which `select` would miss
        # the end
        for name in json.loads(sys.stdin.buffer.raw.readline() or "[]"):
            importlib.import_module(name)
        if any("casadi" in name for name in sys.modules):
            importlib.import_module("casadi")
        warm_up_matplotlib("png")
        del sys.modules["rfc3987_syntax"], sys.modules["jupyter_server"]


def _answer(connection, listener):
    with connection.makefile() as asked:
        request = json.loads(asked.readline())
    pid = os.fork()
    if pid == 0:
        connection.close()
        listener.close()
        _be_kernel(request)
    connection.sendall(f"{pid}\n".encode())
    return pid


def _be_kernel(request):
    """In the fork: be a kernel until the end, as `python -m ipykernel_launcher` is."""
    try:
        os.setsid()
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        nothing = os.open(os.devnull, os.O_RDONLY)
        os.dup2(nothing, 0)
        os.environ.clear()
        os.environ.update(request["env"])
        os.chdir(request["folder"])
        sys.path[0] = ""
        import numpy

        # as `random` does by itself: a fork would repeat the numbers of its brothers
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

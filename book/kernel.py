"""A Jupyter kernel that is ready at once: a fork of this process, with all its imports.

Elsewhere than on Linux it is a process of its own, which imports for itself: Windows forks none, and
libraries of macOS may crash after a fork.

It has to be forked before this process has a thread or a ZeroMQ context, since neither survives a
fork. The kernel itself takes free ports and writes them into its connection file, so that no other
program can take one of them in between.
"""

import os
import signal
import subprocess
import sys
import traceback
from contextlib import suppress
from pathlib import Path
from queue import Empty
from tempfile import TemporaryDirectory

import numpy
from ipykernel.kernelapp import IPKernelApp
from jupyter_client import AsyncKernelClient, AsyncKernelManager
from jupyter_client.provisioning import LocalProvisioner
from traitlets.config import Config

#: What a kernel writes when it can be asked.
READY = b"ready"
#: The page's ink, --ink of its light theme, and the page's font, as Matplotlib reads it; what that
#: lacks is taken from Matplotlib's own.
INK = "#1d2530"
FONT = Path(__file__).with_name("_static") / "fonts" / "workbook-sans.ttf"
FAMILIES = ["Workbook Sans", "DejaVu Sans"]
#: Pictures are sharp at any size, the same pictures are the same bytes, and they have no ground: the
#: page is their paper. In the dark theme its style sheet turns their lightness round.
PICTURES = {
    "figure_formats": {"svg"},
    "rc": {
        "svg.hashsalt": "workbook",
        "font.family": FAMILIES,
        **dict.fromkeys(["figure.facecolor", "axes.facecolor"], "none"),
        "legend.facecolor": "white",
        **dict.fromkeys(
            ["text.color", "axes.edgecolor", "axes.labelcolor", "xtick.color", "ytick.color"], INK
        ),
    },
    "print_figure_kwargs": {"bbox_inches": "tight", "metadata": {"Date": None}, "dpi": 220},
}


def set_up_pictures():
    """Give Matplotlib the page's font and the settings of PICTURES.

    The kernel's own backend sets them only for figures of pyplot.
    """
    from matplotlib import font_manager, rcParams

    if FAMILIES[0] not in font_manager.get_font_names():
        font_manager.fontManager.addfont(FONT)
    rcParams.update(PICTURES["rc"])


class Client(AsyncKernelClient):
    """A client of a kernel that is ready.

    Jupyter's own client waits until the kernel is silent for a fifth of a second. This one waits
    for the first message instead, so that it is not taken for a message on a cell.
    """

    async def wait_for_ready(self, timeout):
        message = None
        while not message:
            self.kernel_info()
            try:
                await self.shell_channel.get_msg(timeout=timeout)
            except Empty:
                raise RuntimeError(f"the kernel gives no answer within {timeout} seconds") from None
            with suppress(Empty):  # the channel may not be connected yet
                message = await self.iopub_channel.get_msg(timeout=0.2)


class Kernel:
    """A kernel in `folder` with the interface of `subprocess.Popen`; the end of `with` ends it."""

    stdin = stdout = stderr = None

    def __init__(self, folder):
        self._folder = TemporaryDirectory()
        self._file = f"{self._folder.name}/kernel.json"
        self.returncode = None
        with self._start(folder) as answer:
            if not answer.read(len(READY)):
                raise RuntimeError("the kernel ended before it could be asked anything")

    def _start(self, folder):
        """Start the process; return a file in which it writes `READY`."""
        receiver, sender = os.pipe()
        self.pid = os.fork()
        if self.pid == 0:
            os.close(receiver)
            _serve(self._file, folder, sender)
        os.close(sender)
        return open(receiver, "rb")

    def manager(self):
        """Return a kernel manager for nbclient, which finds this kernel running."""
        manager = AsyncKernelManager(connection_file=self._file, client_factory=Client)
        manager.load_connection_file()
        manager.provisioner = LocalProvisioner(
            kernel_spec=manager.kernel_spec, kernel_id="", parent=manager
        )
        manager.provisioner.process = self
        manager.provisioner.pid = manager.provisioner.pgid = self.pid
        return manager

    def poll(self):
        return self._wait(os.WNOHANG)

    def wait(self):
        return self._wait(0)

    def _wait(self, options):
        if self.returncode is None:
            pid, status = os.waitpid(self.pid, options)
            self.returncode = os.waitstatus_to_exitcode(status) if pid else None
        return self.returncode

    def send_signal(self, number):
        os.kill(self.pid, number)

    def __enter__(self):
        return self

    def __exit__(self, *error):
        if self.poll() is None:
            os.killpg(self.pid, signal.SIGKILL)
            self.wait()
        self._folder.cleanup()


class SpawnedKernel(Kernel):
    """The same in a process of its own."""

    def _start(self, folder):
        self._process = subprocess.Popen(
            [sys.executable, __file__, self._file, folder], stdout=subprocess.PIPE
        )
        self.pid = self._process.pid
        return self._process.stdout

    def poll(self):
        return self._process.poll()

    def wait(self):
        return self._process.wait()

    def send_signal(self, number):
        self._process.send_signal(number)

    def __exit__(self, *error):
        self._process.kill()
        self._process.wait()
        self._folder.cleanup()


def start_kernel(folder):
    """Return a kernel in a folder."""
    return (Kernel if sys.platform == "linux" else SpawnedKernel)(folder)


def _serve(connection_file, folder, sender):
    """Run the kernel in this process, as `python -m ipykernel_launcher` does; never return."""
    parent = []
    try:
        if sys.platform != "win32":
            os.setsid()
            parent = [f"--IPKernelApp.parent_handle={os.getppid()}"]
        os.chdir(folder)
        sys.path[:] = [
            path for path in sys.path if path != os.path.dirname(os.path.abspath(__file__))
        ]
        # as `random` does by itself: all forks would draw the same numbers
        numpy.random.seed()
        set_up_pictures()
        app = IPKernelApp.instance(config=Config(InlineBackend=PICTURES))
        # A kernel's own log is no use in a build: the messages of a cell are in its outputs.
        app.initialize(
            [
                f"--f={connection_file}",
                "--log-level=CRITICAL",
                "--HistoryManager.hist_file=:memory:",
                *parent,
            ]
        )
        os.write(sender, READY)
        app.start()
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(1)


if __name__ == "__main__":
    _serve(sys.argv[1], sys.argv[2], sys.stdout.fileno())

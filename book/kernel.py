"""A Jupyter kernel that is ready at once: a fork of this process, with all that this process has
imported.

It has to be forked before this process has a thread or a ZeroMQ context, since neither lives on in
a fork. The kernel takes free ports and writes them into its connection file, so that no other
program can take one of them meanwhile.
"""

import os
import signal
import sys
import traceback
from contextlib import suppress
from queue import Empty
from tempfile import TemporaryDirectory

import numpy
from ipykernel.kernelapp import IPKernelApp
from jupyter_client import AsyncKernelClient, AsyncKernelManager
from jupyter_client.provisioning import LocalProvisioner
from traitlets.config import Config

#: Pictures are sharp at any size, and the same pictures are the same bytes.
PICTURES = {
    "figure_formats": {"svg"},
    "rc": {"svg.hashsalt": "workbook"},
    "print_figure_kwargs": {"bbox_inches": "tight", "metadata": {"Date": None}, "dpi": 220},
}


class Client(AsyncKernelClient):
    """Who talks to a kernel that is ready: at once, where Jupyter's own would wait until nothing is
    heard of it for a fifth of a second. What the kernel tells of the first question is not taken
    for what it tells of a cell."""

    async def wait_for_ready(self, timeout):
        heard = None
        while not heard:
            self.kernel_info()
            try:
                await self.shell_channel.get_msg(timeout=timeout)
            except Empty:
                raise RuntimeError(f"the kernel gives no answer within {timeout} seconds") from None
            with suppress(Empty):  # or it was not listened to yet
                heard = await self.iopub_channel.get_msg(timeout=0.2)


class Kernel:
    """A running kernel in `folder`, with what `subprocess.Popen` has of a process; within `with` it
    lives."""

    stdin = stdout = stderr = None

    def __init__(self, folder):
        self._place = TemporaryDirectory()
        self._file = f"{self._place.name}/kernel.json"
        self.returncode = None
        ready, tell = os.pipe()
        self.pid = os.fork()
        if self.pid == 0:
            os.close(ready)
            _serve(self._file, folder, tell)
        os.close(tell)
        with open(ready, "rb") as answer:
            if not answer.read():
                raise RuntimeError("the kernel ended before it could be asked anything")

    def manager(self):
        """What nbclient asks for: it finds this kernel running and needs not start one."""
        manager = AsyncKernelManager(connection_file=self._file, client_factory=Client)
        manager.load_connection_file()
        manager.provisioner = LocalProvisioner(
            kernel_spec=manager.kernel_spec, kernel_id="", parent=manager
        )
        manager.provisioner.process, manager.provisioner.pid, manager.provisioner.pgid = (
            self,
            self.pid,
            self.pid,
        )
        return manager

    def poll(self):
        return self._ended(os.WNOHANG)

    def wait(self):
        return self._ended(0)

    def _ended(self, how):
        if self.returncode is None:
            pid, status = os.waitpid(self.pid, how)
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
        self._place.cleanup()


def _serve(connection_file, folder, tell):
    """In the fork: be a kernel until the end, as `python -m ipykernel_launcher` is."""
    try:
        os.setsid()
        os.chdir(folder)
        sys.path[:] = [
            path for path in sys.path if path != os.path.dirname(os.path.abspath(__file__))
        ]
        # as `random` does by itself: a fork would repeat the numbers of its brothers
        numpy.random.seed()
        app = IPKernelApp.instance(config=Config(InlineBackend=PICTURES))
        # A kernel's own log has nothing for the reader of a build: what a cell says is in its
        # outputs.
        app.initialize(
            [
                f"--f={connection_file}",
                "--log-level=CRITICAL",
                "--HistoryManager.hist_file=:memory:",
                f"--IPKernelApp.parent_handle={os.getppid()}",
            ]
        )
        os.write(tell, b"ready")
        os.close(tell)
        app.start()
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(1)

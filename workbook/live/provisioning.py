"""Kernel provisioner that takes JupyterLab's kernels from `workbook.live.kernel_forkserver`.

Where no forkserver answers, kernels start as processes of their own, as usual.
"""

import asyncio
import os
import signal
import sys
from importlib.metadata import EntryPoint

from jupyter_client.provisioning import KernelProvisionerFactory, LocalProvisioner

from workbook.live.kernel_forkserver import SOCKET, request_kernel


class ForkedKernelProvisioner(LocalProvisioner):
    """Provisioner that requests a fork instead of starting a process."""

    async def launch_kernel(self, cmd, **options):
        request = {
            "connection_file": self.parent.connection_file,
            "env": options.get("env") or dict(os.environ),
            "folder": options.get("cwd") or os.getcwd(),
        }
        try:
            self.pid = self.pgid = await asyncio.to_thread(
                request_kernel, os.environ[SOCKET], request
            )
        except (OSError, KeyError):  # no forkserver, as on Windows
            return await super().launch_kernel(cmd, **options)
        self.process = _ForkedProcess(self.pid)
        self.cwd = request["folder"]
        return self.connection_info


class _ForkedProcess:
    """The methods of `subprocess.Popen` for a process that is not our child."""

    stdin = stdout = stderr = None

    def __init__(self, pid):
        self.pid = pid

    def poll(self):
        try:
            os.kill(self.pid, 0)
        except ProcessLookupError:
            return 0
        return None

    def wait(self):
        return self.poll()

    def send_signal(self, number):
        os.kill(self.pid, number)

    def kill(self):
        if sys.platform != "win32":
            self.send_signal(signal.SIGKILL)

    def terminate(self):
        self.send_signal(signal.SIGTERM)


def register_provisioner():
    """Make the provisioner the default of the JupyterLab server in this process."""
    factory = KernelProvisionerFactory.instance()
    name = "workbook-live"
    factory.provisioners[name] = EntryPoint(
        name, f"{__name__}:{ForkedKernelProvisioner.__name__}", factory.GROUP_NAME
    )
    factory.default_provisioner_name = name

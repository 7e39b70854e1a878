"""Tells JupyterLab's server to take its kernels from `workbook.live.kernels`; without it they start
as always."""

import asyncio
import os
import signal
from importlib.metadata import EntryPoint

from jupyter_client.provisioning import KernelProvisionerFactory, LocalProvisioner

from workbook.live.kernels import SOCKET, ask


class ForkedKernels(LocalProvisioner):
    """Asks for a fork instead of starting a process."""

    async def launch_kernel(self, cmd, **given):
        request = {
            "connection_file": self.parent.connection_file,
            "env": given.get("env") or dict(os.environ),
            "folder": given.get("cwd") or os.getcwd(),
        }
        try:
            self.pid = self.pgid = await asyncio.to_thread(ask, os.environ[SOCKET], request)
        # no such process, and on Windows no such sockets
        except (OSError, KeyError, AttributeError):
            return await super().launch_kernel(cmd, **given)
        self.process = _Forked(self.pid)
        self.cwd = request["folder"]
        return self.connection_info


class _Forked:
    """What `subprocess.Popen` has of a process, for one that is not our child."""

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
        self.send_signal(signal.SIGKILL)

    def terminate(self):
        self.send_signal(signal.SIGTERM)


def take_over():
    """All kernels of this process's server from here on."""
    factory = KernelProvisionerFactory.instance()
    name = "workbook-live"
    factory.provisioners[name] = EntryPoint(
        name, f"{__name__}:{ForkedKernels.__name__}", factory.GROUP_NAME
    )
    factory.default_provisioner_name = name

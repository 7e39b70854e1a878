"""Run a command as an ordinary user, also where the tests themselves run as root."""

import os
import subprocess
import sys
from pathlib import Path

from workbook.grading.sandbox.system_calls import (
    CLONE_NEWNS,
    MS_BIND,
    MS_PRIVATE,
    MS_REC,
    mount,
    unshare,
)

USER = 54321


def run(code, folder, timeout=120):
    """Run Python `code` in `folder`, which becomes the user's home; return the process."""
    environment = {"PATH": os.environ["PATH"], "HOME": str(folder), "LANG": "C.UTF-8"}
    if os.getuid() == 0:
        os.chown(folder, USER, USER)
        for above in Path(folder).parents[:3]:  # temporary folders of tests are private
            os.chmod(above, os.stat(above).st_mode | 0o055) if above != Path("/tmp") else None
    return subprocess.run(
        [sys.executable, "-c", code],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=timeout,
        preexec_fn=_become_ordinary if os.getuid() == 0 else None,
    )


def _become_ordinary():
    """Drop root's rights, and keep the interpreter readable even if it is in root's home."""
    prefix = os.path.realpath(sys.base_prefix)
    unshare(CLONE_NEWNS)
    mount("none", "/", flags=MS_REC | MS_PRIVATE)
    if prefix.startswith("/root/"):
        mount("tmpfs", "/mnt", "tmpfs", options="mode=755")
        os.mkdir("/mnt/prefix")
        mount(prefix, "/mnt/prefix", flags=MS_BIND | MS_REC)
        mount("tmpfs", "/root", "tmpfs", options="mode=755")
        os.makedirs(prefix)
        mount("/mnt/prefix", prefix, flags=MS_BIND | MS_REC)
    os.setgroups([])
    os.setresgid(USER, USER, USER)
    os.setresuid(USER, USER, USER)

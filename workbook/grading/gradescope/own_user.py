"""Run a notebook as a user of its own, for containers that allow no sandbox.

Limits, watchdog and filter of system calls are those of the sandbox. File permissions replace its
empty file system. The filter replaces its empty network: here it denies all sockets but those of
the machine itself (AF_UNIX).
"""

import os
import signal
import socket
import subprocess
import sys
from dataclasses import asdict

from workbook.grading.sandbox import isolation, notebook_worker, seccomp, system_calls
from workbook.grading.sandbox.limits import Outcome
from workbook.grading.sandbox.sandbox import Sandbox


class OwnUser(Sandbox):
    """Runs notebooks one by one as `user` (an entry of the password file). Needs root."""

    def __init__(self, user, limits):
        super().__init__(limits, single_use=True)
        self._user = user

    def __enter__(self):
        # It starts with the first notebook, which starts it again if the machine is too slow.
        return self

    def _start_worker(self):
        code = (
            f"from workbook.grading.gradescope import own_user; own_user.run_as({self._user.pw_uid}, "
            f"{self._user.pw_gid}, {asdict(self.limits)!r}, {list(self._modules)!r})"
        )
        return subprocess.Popen(
            [sys.executable, "-I", "-c", code],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            close_fds=True,
            start_new_session=True,
            env=isolation.ENVIRONMENT,
        )

    def _stop(self):
        started = self._worker is not None
        super()._stop()
        if started:
            self._kill_remaining()

    def _kill_remaining(self):
        """Kill everything that the notebook left running as its user."""
        killer = os.fork()
        if killer == 0:
            try:
                os.setresuid(*[self._user.pw_uid] * 3)
                os.kill(-1, signal.SIGKILL)  # all that this user may kill, except this process
            finally:
                os._exit(0)
        os.waitpid(killer, 0)

    def _outcome(self, ended, message):
        # Unlike in a sandbox, a notebook's process can be killed by the notebook.
        return Outcome(ended.decode(), message)


def run_as(user, group, limits, modules):
    """As root, run a single-use notebook worker as another user, and exit as it does.

    That user cannot reach this process.

    Parameters
    ----------
    user, group : int
        Numeric ids.
    limits : dict
        As of `limits.Limits`.
    modules : list of str
        What the notebook finds imported.
    """
    system_calls.system_call("prctl", notebook_worker.PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    parent, child = os.getpid(), os.fork()
    if child == 0:
        try:
            os.setgroups([])
            os.setresgid(group, group, group)
            os.setresuid(user, user, user)
            system_calls.die_with_parent(parent)
            os.umask(0o077)
            # No namespace confines the network here.
            seccomp.FAMILIES = (socket.AF_UNIX,)
            notebook_worker.run_once(limits, modules)
        except BaseException as error:
            print(repr(error), file=sys.stderr, flush=True)  # the grader reads the last line
        finally:
            os._exit(1)
    for descriptor in (0, 1, 2):
        os.close(descriptor)  # so that the grader sees the worker's end
    code = None
    while code is None:
        process, status = os.wait()  # orphans of the notebook end here too
        if process == child:
            code = os.waitstatus_to_exitcode(status)
    os._exit(code if code >= 0 else 128 - code)

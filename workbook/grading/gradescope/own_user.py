"""A notebook under a user of its own, for containers in which no sandbox can be had.

Limits, the watching of them and the filter of system calls are those of the sandbox. In place of
its empty file system stand the permissions of files, and in place of its empty network the filter,
which here denies all sockets but those of the machine itself.
"""

import os
import signal
import socket
import subprocess
import sys
from dataclasses import asdict

from workbook.grading import isolation, notebook_worker, seccomp
from workbook.grading.sandbox import Outcome, Sandbox


class OwnUser(Sandbox):
    """Runs notebooks one by one as `user` (an entry of the password file). Needs root."""

    def __init__(self, user, limits):
        super().__init__(limits, once=True)
        self._user = user

    def __enter__(self):
        # started with the first notebook, and tried again if the machine is too slow at first
        return self

    def _spawn(self):
        start = (
            f"from workbook.grading.gradescope import own_user; own_user.keep({self._user.pw_uid}, "
            f"{self._user.pw_gid}, {asdict(self.limits)!r}, {list(self._modules)!r})"
        )
        return subprocess.Popen(
            [sys.executable, "-I", "-c", start],
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
            self._end_what_is_left()

    def _end_what_is_left(self):
        """Everything that the notebook left running as its user."""
        sweeper = os.fork()
        if sweeper == 0:
            try:
                os.setresuid(*[self._user.pw_uid] * 3)
                os.kill(-1, signal.SIGKILL)  # all that this user may kill, but for the sweeper
            finally:
                os._exit(0)
        os.waitpid(sweeper, 0)

    def _told(self, ended, message):
        # Unlike in a sandbox, a notebook's process can be killed by the notebook.
        return Outcome(ended.decode(), message)


def keep(user, group, limits, modules):
    """As root: run the worker, for a notebook within the limits that finds `modules` imported, as
    another user, who cannot reach this process, and end as the worker ends."""
    isolation.system_call("prctl", notebook_worker.PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    this, child = os.getpid(), os.fork()
    if child == 0:
        try:
            os.setgroups([])
            os.setresgid(group, group, group)
            os.setresuid(user, user, user)
            isolation.end_with_parent(this)
            os.umask(0o077)
            # No namespace confines the network here.
            seccomp.FAMILIES = (socket.AF_UNIX,)
            notebook_worker.once(limits, modules)
        except BaseException as error:
            print(repr(error), file=sys.stderr, flush=True)  # the grader reads the last line
        finally:
            os._exit(1)
    for descriptor in (0, 1, 2):
        os.close(descriptor)  # so that the grader sees the worker's end
    ended = None
    while ended is None:
        process, status = os.wait()  # orphans of the notebook end here too
        if process == child:
            ended = os.waitstatus_to_exitcode(status)
    os._exit(ended if ended >= 0 else 128 - ended)

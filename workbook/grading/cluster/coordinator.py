"""Coordinator: send notebooks to the workers of a Dask cluster and collect the verdicts.

Both are bytes of JSON. Dask transports them and knows which workers there are; the coordinator
decides which worker grades what. So only few notebooks are on their way at a time, a worker is
asked whether it can grade before it gets one, and if a worker ends, its notebooks go to another.
"""

import json
import queue
import time
import uuid
from collections import Counter, deque
from collections.abc import Callable
from contextlib import suppress
from dataclasses import asdict, dataclass
from urllib.parse import urlsplit

from workbook.grading.cluster import dask_worker
from workbook.grading.cluster.connection import ClusterError, connected, innermost_cause, security
from workbook.grading.pool.grader import Task, to_plain
from workbook.grading.pool.judging import grader_failure
from workbook.grading.sandbox.limits import SandboxUnavailableError

#: How often a notebook is begun at which processes end, before it is left to the next run.
MAX_TRIES = 3
#: Notebooks on their way to a worker beyond those that it is grading, so that it need not wait.
PREFETCH = 1
#: Seconds for workers to appear; for them to report that they are ready; between two looks at which
#: workers there are.
APPEAR_SECONDS, READY_SECONDS, UPDATE_SECONDS = 30, 120, 1
CONTINUES = "what is graded is stored, and the same command goes on from there"


@dataclass(frozen=True)
class Cluster:
    """A Dask cluster that grades.

    Files that are not given are those of Dask's own configuration.

    Parameters
    ----------
    address : str
        The scheduler's, "tls://host:8786".
    ca_file, cert, key : path, optional
        Files with the certificates by which both sides know each other.
    report : callable
        Called with lines for the lecturer.
    """

    address: str
    ca_file: str | None = None
    cert: str | None = None
    key: str | None = None
    report: Callable = lambda line: None

    def check(self):
        """Raise `ClusterError` for what can be seen without a connection."""
        security(self)

    def grade_all(self, tasks, settings):
        """Grade tasks as `worker_pool.grade_all` does; yield (key, result).

        A result also has the "limits" that it had on its worker. Raises `ClusterError`, and
        `SandboxUnavailableError` if a worker has no sandbox, before anything is graded.
        """
        tasks = list(tasks)
        library = dask_worker.library_versions(
            sorted({name for t in tasks for name in (t.problem, *t.other_variants)})
        )
        try:
            with connected(self) as client:
                order = {"run": uuid.uuid4().hex, "library": library, "settings": asdict(settings)}
                del order["settings"]["course"]  # each machine has its own
                run = _Run(client, tasks, order, self)
                try:
                    yield from run.results()
                finally:
                    run.end()
        except OSError as error:
            raise ClusterError(
                f"the cluster at {self.address} cannot be reached any more ({error})"
            ) from None


@dataclass
class _Call:
    """A call on its way to a worker, to grade a task, or with None to prepare."""

    future: object
    address: str
    task: Task | None


class _Run:
    """The tasks that wait, the calls on their way, and the workers."""

    def __init__(self, client, tasks, order, cluster):
        self._client, self._order, self._cluster = client, order, cluster
        self._waiting, self._failures, self._failed_on = deque(tasks), Counter(), {}
        self._calls, self._finished, self._given_up = {}, queue.SimpleQueue(), deque()
        # Threads by worker; the largest number of them seen on each machine.
        self._threads, self._threads_on_host = {}, {}
        self._asked, self._ready, self._refusals = set(), set(), {}
        self._next_update = self._last_ready = time.monotonic()

    def results(self):
        """Yield (key, result) of each task."""
        self._gather_workers()
        while self._waiting or any(call.task for call in self._calls.values()):
            self._update_workers()
            self._require_worker()
            self._assign_tasks()
            yield from self._finished_tasks()
            while self._given_up:
                task = self._given_up.popleft()
                failure = grader_failure(task.names, "one of its processes ended")
                yield task.key, to_plain(failure)

    def end(self):
        """End all calls, also during a notebook."""
        futures = [call.future for call in self._calls.values()]
        self._calls.clear()
        with suppress(Exception):
            self._client.cancel(futures, force=True) if futures else None
        with suppress(Exception):
            self._client.run(dask_worker.end_run, self._order["run"], on_error="ignore")

    # Workers

    def _gather_workers(self):
        """Ask all workers, and refuse a cluster if one cannot grade: now rather than in an hour."""
        deadline = time.monotonic() + APPEAR_SECONDS
        self._update_workers(now=True)
        while not self._threads:
            if time.monotonic() > deadline:
                raise ClusterError(f"the scheduler at {self._cluster.address} has no workers")
            time.sleep(0.1)
            self._update_workers(now=True)
        deadline = time.monotonic() + READY_SECONDS
        while self._asked and not (self._ready and time.monotonic() > deadline):
            for _ in self._finished_tasks():
                pass  # only replies to the question come so far
            for address, reply in self._refusals.items():
                raise _refusal_error(address, reply)
            if not self._ready and time.monotonic() > deadline:
                raise ClusterError(
                    f"no worker of {self._cluster.address} was ready to grade within "
                    f"{READY_SECONDS} s"
                )
            self._update_workers()

    def _update_workers(self, now=False):
        """Ask new workers whether they are ready, and take back the tasks of those that left."""
        if not now and time.monotonic() < self._next_update:
            return
        self._next_update = time.monotonic() + UPDATE_SECONDS
        if self._client.status != "running":
            raise ClusterError(f"the scheduler at {self._cluster.address} has gone; {CONTINUES}")
        self._threads = dict(self._client.nthreads())
        for host in {_host(address) for address in self._threads}:
            threads = sum(
                count for address, count in self._threads.items() if _host(address) == host
            )
            self._threads_on_host[host] = max(threads, self._threads_on_host.get(host, 0))
        for key in [key for key, call in self._calls.items() if call.address not in self._threads]:
            call = self._calls.pop(key)
            call.future.cancel()
            self._asked.discard(call.address)
            if call.task:
                self._retry(call)
        self._ready &= self._threads.keys()
        for address in self._threads.keys() - self._asked - self._ready - self._refusals.keys():
            self._asked.add(address)
            self._call(dask_worker.prepare, address)

    def _require_worker(self):
        if self._ready or self._asked:
            self._last_ready = time.monotonic()
        elif time.monotonic() > self._last_ready + APPEAR_SECONDS:
            for address in self._threads.keys() & self._refusals.keys():
                raise _refusal_error(address, self._refusals[address])
            raise ClusterError(f"no worker is left at {self._cluster.address}; {CONTINUES}")

    # Tasks

    def _assign_tasks(self):
        """Send each worker as many tasks as it has threads, and `PREFETCH` more."""
        assigned = Counter(call.address for call in self._calls.values() if call.task)
        for address in self._ready:
            for _ in range(self._threads.get(address, 0) + PREFETCH - assigned[address]):
                task = self._next_task(address)
                if task is not None:
                    self._call(dask_worker.grade, address, task)

    def _next_task(self, address):
        """Return the first task for a worker: not one that failed on it, unless on all others."""
        for k, task in enumerate(self._waiting):
            if (
                not (failed_on := self._failed_on.get(task.key, set()))
                or address not in failed_on
                or self._ready <= failed_on
            ):
                del self._waiting[k]
                return task
        return None

    def _call(self, function, address, task=None):
        order = json.dumps(
            self._order | {"workers": self._threads_on_host[_host(address)]}
        ).encode()
        # Neither names nor anything else of the student's: the code of the notebook alone.
        arguments = () if task is None else (task.to_json(),)
        future = self._client.submit(
            function,
            order,
            *arguments,
            workers=[address],
            allow_other_workers=False,
            pure=False,
        )
        self._calls[future.key] = _Call(future, address, task)
        future.add_done_callback(lambda done: self._finished.put(done.key))

    def _finished_tasks(self):
        """Yield (key, result) of a call that has finished, if it was of a task.

        Waits for a call to finish, but not beyond the next update of the workers.
        """
        try:
            timeout = max(0.01, self._next_update - time.monotonic())
            key = self._finished.get(timeout=timeout)
        except queue.Empty:
            return
        call = self._calls.get(key)
        if call is None:
            return  # of a worker that was given up
        try:
            reply = self._reply(call)
        except TimeoutError:  # the worker ended after it had finished: the update notices it
            self._update_workers(now=True)
            self._finished.put(key)
            return
        del self._calls[key]
        self._asked.discard(call.address)
        if "refused" in reply:
            self._refuse(call, reply)
        elif call.task is None:
            self._ready.add(call.address)
        elif "result" in reply:
            yield call.task.key, reply["result"] | {"limits": reply["limits"]}
        else:
            self._retry(call)

    def _reply(self, call):
        """Return a worker's reply; {} if its process ended."""
        from distributed import KilledWorker  # loaded by now, since there is a client

        try:
            return json.loads(call.future.result(timeout=5))
        except TimeoutError:
            raise
        except KilledWorker:
            return {}
        except Exception as error:
            if call.future.cancelled():
                return {}
            return {"refused": f"it cannot grade ({innermost_cause(error)})", "sandbox": False}

    def _refuse(self, call, reply):
        self._ready.discard(call.address)
        if call.address not in self._refusals and self._ready:
            self._cluster.report(f"worker {call.address} gets no notebooks: {reply['refused']}")
        self._refusals[call.address] = reply
        if call.task:
            self._waiting.appendleft(call.task)

    def _retry(self, call):
        """Let the task of a process that ended wait again; after `MAX_TRIES`, give it up."""
        key = call.task.key
        self._failures[key] += 1
        self._failed_on.setdefault(key, set()).add(call.address)
        if self._failures[key] < MAX_TRIES:
            self._waiting.appendleft(call.task)
        else:
            self._given_up.append(call.task)


def _host(address):
    return urlsplit(address).hostname


def _refusal_error(address, reply):
    error = SandboxUnavailableError if reply["sandbox"] else ClusterError
    return error(f"worker {address}: {reply['refused']}")

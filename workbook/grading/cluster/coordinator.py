"""Grading on the machines of a Dask cluster: whole notebooks go out, verdicts come back, both as
bytes of JSON.

Dask brings them to its workers and says which workers there are; who grades what is decided here.
So only few notebooks are on their way at a time, a worker is asked whether it is fit before it gets
one, and one that ends costs nothing: its notebooks go to another.
"""

import json
import logging
import os
import queue
import socket
import ssl
import threading
import time
import uuid
import warnings
from collections import Counter, deque
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from urllib.parse import urlsplit

from workbook.grading.assignment import BadInput
from workbook.grading.cluster import dask_worker
from workbook.grading.grader import as_plain
from workbook.grading.isolation import NoIsolation
from workbook.grading.judging import failed

#: How often a notebook is begun at which processes end, before it is left to the next run.
MOST_TRIES = 3
#: Notebooks on their way to a worker beyond those it is grading, so that it need not wait for us.
AHEAD = 1
#: Seconds: to reach the scheduler; for workers to come, or to say that they are fit; between looks
#: at who is there.
TO_CONNECT, TO_COME, TO_GET_READY, BETWEEN_LOOKS = 10, 30, 120, 1
GOES_ON = "what is graded is stored, and the same command goes on from there"


class ClusterError(BadInput):
    """The cluster cannot be used, or not any more; the message is one line that says why."""


@dataclass(frozen=True)
class Cluster:
    """A scheduler's address, "tls://host:8786", and the files by which both sides know each other.

    Files that are not named are those of Dask's own configuration. `tell` is called with a line for
    the lecturer.
    """

    address: str
    ca_file: str | None = None
    cert: str | None = None
    key: str | None = None
    tell: object = lambda line: None


def grade_all(units, settings, cluster):
    """Grade units as `lanes.grade_all` does; a result says also which "limits" it had on its
    worker.

    Raises `ClusterError`, and `NoIsolation` if a worker has no sandbox, before anything is graded.
    """
    units = list(units)
    library = dask_worker.library(sorted({unit["problem"] for unit in units}))
    try:
        with _connected(cluster) as client:
            run = _Run(
                client, units, settings | {"run": uuid.uuid4().hex, "library": library}, cluster
            )
            try:
                yield from run.results()
            finally:
                run.end()
    except OSError as error:
        raise ClusterError(
            f"the cluster at {cluster.address} cannot be reached any more ({error})"
        ) from None


def check(cluster):
    """Raise `ClusterError` for what can be seen without a connection: no Dask, no address, no
    certificates."""
    _security(cluster)


@contextmanager
def _connected(cluster):
    """A Dask client. What Dask itself would say of its connections is left unsaid: it fills
    pages."""
    security, distributed = _security(cluster), _dask()
    for name in ("distributed", "distributed.client", "tornado", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    try:
        with warnings.catch_warnings():
            # what differs between the machines, `dask_worker` says
            warnings.simplefilter("ignore")
            # Dask's own limit is not one on what answers nothing at all.
            client = _within(
                3 * TO_CONNECT,
                lambda: distributed.Client(
                    cluster.address, security=security, timeout=TO_CONNECT, set_as_default=False
                ),
            )
    except (OSError, RuntimeError, TypeError, ValueError) as error:
        cause = _cause(error)
        # of Dask's last try, cut short: the one before it failed for a reason
        if cause in ("CancelledError", "TimeoutError"):
            cause = _refusal_of(cluster.address)
        hint = (
            "; is its certificate signed by the same CA, and does it use TLS?"
            if "ssl" in cause.lower()
            else ""
        )
        raise ClusterError(
            f"no scheduler can be reached at {cluster.address}: {cause}{hint}"
        ) from None
    try:
        yield client
    finally:
        with suppress(Exception):
            client.close(timeout=5)


def _dask():
    try:
        import distributed  # for nothing else is it needed, and it takes its time
    except ImportError:
        raise ClusterError(
            "grading on a cluster needs Dask, which is not installed here: pip install distributed"
        ) from None
    return distributed


def _security(cluster):
    """What a connection to this address needs: None, or the certificates."""
    distributed = _dask()
    try:
        parts = urlsplit(cluster.address)
        good = (
            parts.scheme in ("tls", "tcp")
            and parts.hostname
            and parts.port
            and not (parts.path or parts.query)
        )
    except ValueError:
        good = False
    if not good:
        raise ClusterError(
            f"{cluster.address} is not the address of a scheduler, which looks like tls://host:8786"
        )
    if parts.scheme == "tcp":
        return None
    options = {
        "tls_ca_file": ("--tls-ca-file", cluster.ca_file),
        "tls_client_cert": ("--tls-cert", cluster.cert),
        "tls_client_key": ("--tls-key", cluster.key),
    }
    named = {name: str(path) for name, (_, path) in options.items() if path is not None}
    security = distributed.Security(require_encryption=True, **named)
    for name, (option, _) in options.items():
        path = getattr(security, name)
        if path is None:
            raise ClusterError(
                f"{cluster.address} needs certificates; {option} names a file of them, as --help "
                "tells"
            )
        if not os.access(path, os.R_OK):
            raise ClusterError(f"{option} {path}: there is no such file that could be read")
    try:
        security.get_connection_args("client")
    except ssl.SSLError as error:
        raise ClusterError(f"these certificates cannot be used: {_cause(error)}") from None
    return security


def _cause(error):
    """The innermost reason, in one line: Dask wraps it into its own words."""
    while error.__cause__ is not None:
        error = error.__cause__
    return " ".join(str(error).rpartition("Error: ")[2].split())[:200] or type(error).__name__


def _within(seconds, function):
    """The value of `function()`, in a thread that is left behind if it does not end in time: then
    raises `TimeoutError`."""
    ended = queue.SimpleQueue()

    def work():
        try:
            ended.put((function(), None))
        except BaseException as error:
            ended.put((None, error))

    threading.Thread(target=work, daemon=True).start()
    try:
        value, error = ended.get(timeout=seconds)
    except queue.Empty:
        raise TimeoutError from None
    if error is not None:
        raise error
    return value


def _refusal_of(address):
    """Why nothing can be connected to an address, asked of the system itself."""
    parts = urlsplit(address)
    try:
        with socket.create_connection((parts.hostname, parts.port), timeout=TO_CONNECT):
            return f"something listens there, but gives no answer within {TO_CONNECT} s"
    except TimeoutError:
        return f"no answer within {TO_CONNECT} s"
    except OSError as error:
        return error.strerror or str(error)


@dataclass
class _Flight:
    """A call on its way: of a unit, or with None of the question whether the worker is fit."""

    future: object
    address: str
    unit: dict | None


class _Run:
    """Which units wait, which are where, and which workers there are."""

    def __init__(self, client, units, given, cluster):
        self._client, self._given, self._cluster = client, given, cluster
        self._waiting, self._tries, self._been = deque(units), Counter(), {}
        self._flights, self._landed, self._given_up = {}, queue.SimpleQueue(), deque()
        # of each worker there is; the most lanes seen on each machine
        self._threads, self._on_host = {}, {}
        self._asked, self._fit, self._refused = set(), set(), {}
        self._next_look = self._last_fit = time.monotonic()

    def results(self):
        self._gather_workers()
        while self._waiting or any(flight.unit for flight in self._flights.values()):
            self._look()
            self._require_a_worker()
            self._feed()
            yield from self._landings()
            while self._given_up:
                unit = self._given_up.popleft()
                yield unit["key"], as_plain(failed(unit["names"], "one of its processes ended"))

    def end(self):
        """Nothing is left to run, also in the midst of a notebook."""
        futures = [flight.future for flight in self._flights.values()]
        self._flights.clear()
        with suppress(Exception):
            self._client.cancel(futures, force=True) if futures else None
        with suppress(Exception):
            self._client.run(dask_worker.end, self._given["run"], on_error="ignore")

    # Workers

    def _gather_workers(self):
        """Ask everyone who is there, and refuse a cluster of which one is not fit: better now than
        after an hour."""
        give_up = time.monotonic() + TO_COME
        self._look(now=True)
        while not self._threads:
            if time.monotonic() > give_up:
                raise ClusterError(f"the scheduler at {self._cluster.address} has no workers")
            time.sleep(0.1)
            self._look(now=True)
        give_up = time.monotonic() + TO_GET_READY
        while self._asked and not (self._fit and time.monotonic() > give_up):
            for _ in self._landings():
                pass  # there are none yet but answers to our question
            for address, answer in self._refused.items():
                raise _error(address, answer)
            if not self._fit and time.monotonic() > give_up:
                raise ClusterError(
                    f"no worker of {self._cluster.address} was ready to grade within "
                    f"{TO_GET_READY} s"
                )
            self._look()

    def _look(self, now=False):
        """Who is there? New ones are asked whether they are fit; what those had who are gone goes
        to others."""
        if not now and time.monotonic() < self._next_look:
            return
        self._next_look = time.monotonic() + BETWEEN_LOOKS
        if self._client.status != "running":
            raise ClusterError(f"the scheduler at {self._cluster.address} has gone; {GOES_ON}")
        self._threads = dict(self._client.nthreads())
        for host in {_host(address) for address in self._threads}:
            lanes = sum(count for address, count in self._threads.items() if _host(address) == host)
            self._on_host[host] = max(lanes, self._on_host.get(host, 0))
        for key in [
            key for key, flight in self._flights.items() if flight.address not in self._threads
        ]:
            flight = self._flights.pop(key)
            flight.future.cancel()
            self._asked.discard(flight.address)
            if flight.unit:
                self._again(flight)
        self._fit &= self._threads.keys()
        for address in self._threads.keys() - self._asked - self._fit - self._refused.keys():
            self._asked.add(address)
            self._send("ready", address)

    def _require_a_worker(self):
        if self._fit or self._asked:
            self._last_fit = time.monotonic()
        elif time.monotonic() > self._last_fit + TO_COME:
            for address in self._threads.keys() & self._refused.keys():
                raise _error(address, self._refused[address])
            raise ClusterError(f"no worker is left at {self._cluster.address}; {GOES_ON}")

    # Units

    def _feed(self):
        """To each worker as many as it can do, and little more."""
        there = Counter(flight.address for flight in self._flights.values() if flight.unit)
        for address in self._fit:
            for _ in range(self._threads.get(address, 0) + AHEAD - there[address]):
                unit = self._take(address)
                if unit is not None:
                    self._send("grade", address, unit)

    def _take(self, address):
        """The first unit that a worker may have: one at which a worker ended goes to another, if
        there is another."""
        for k, unit in enumerate(self._waiting):
            if (
                not (been := self._been.get(unit["key"], set()))
                or address not in been
                or self._fit <= been
            ):
                del self._waiting[k]
                return unit
        return None

    def _send(self, name, address, unit=None):
        settings = json.dumps(self._given | {"lanes": self._on_host[_host(address)]}).encode()
        # Neither names nor anything else of the student's: the code of the notebook alone.
        sent = (
            ()
            if unit is None
            else (json.dumps({part: unit[part] for part in ("problem", "sources")}).encode(),)
        )
        future = self._client.submit(
            getattr(dask_worker, name),
            settings,
            *sent,
            workers=[address],
            allow_other_workers=False,
            pure=False,
        )
        self._flights[future.key] = _Flight(future, address, unit)
        future.add_done_callback(lambda done: self._landed.put(done.key))

    def _landings(self):
        """(key, result) of a call that has come back, if it is of a unit; waits for one, but not
        past the next look."""
        try:
            flight = self._flights.get(
                key := self._landed.get(timeout=max(0.01, self._next_look - time.monotonic()))
            )
        except queue.Empty:
            return
        if flight is None:
            return  # of a worker that was given up
        try:
            answer = self._answer(flight)
        except TimeoutError:  # the worker ended after it had finished: the next look will tell
            self._look(now=True)
            self._landed.put(key)
            return
        del self._flights[key]
        self._asked.discard(flight.address)
        if "refused" in answer:
            self._refuse(flight, answer)
        elif flight.unit is None:
            self._fit.add(flight.address)
        elif "result" in answer:
            yield flight.unit["key"], answer["result"] | {"limits": answer["limits"]}
        else:
            self._again(flight)

    def _answer(self, flight):
        """What a worker said; {} if its process ended."""
        from distributed import KilledWorker

        try:
            return json.loads(flight.future.result(timeout=5))
        except TimeoutError:
            raise
        except KilledWorker:
            return {}
        except Exception as error:
            if flight.future.cancelled():
                return {}
            return {"refused": f"it cannot grade ({_cause(error)})", "sandbox": False}

    def _refuse(self, flight, answer):
        self._fit.discard(flight.address)
        if flight.address not in self._refused and self._fit:
            self._cluster.tell(f"worker {flight.address} gets no notebooks: {answer['refused']}")
        self._refused[flight.address] = answer
        if flight.unit:
            self._waiting.appendleft(flight.unit)

    def _again(self, flight):
        """The unit of a process that ended waits again; once too often, and it is given up."""
        key = flight.unit["key"]
        self._tries[key] += 1
        self._been.setdefault(key, set()).add(flight.address)
        if self._tries[key] < MOST_TRIES:
            self._waiting.appendleft(flight.unit)
        else:
            self._given_up.append(flight.unit)


def _host(address):
    return urlsplit(address).hostname


def _error(address, answer):
    if answer["sandbox"]:
        return NoIsolation(f"worker {address}: {answer['refused']}")
    return ClusterError(f"worker {address}: {answer['refused']}")

"""Which worker of a cluster grades which notebook, with a fake Dask that the tests control."""

import json
from collections import Counter

import pytest

from workbook.grading.cluster import connection, coordinator, dask_worker
from workbook.grading.pool.grader import Task


class Dask:
    """A client whose calls finish when the test says so."""

    status = "running"

    def __init__(self, **threads):
        self.threads, self.calls, self.cancelled = (
            {f"tls://10.0.0.{k}:1": count for k, count in enumerate(threads.values(), 1)},
            [],
            0,
        )

    def nthreads(self):
        return self.threads

    def submit(
        self, function, settings, task=b"null", workers=(), allow_other_workers=True, pure=True
    ):
        assert (
            type(settings) is bytes and type(task) is bytes and not allow_other_workers and not pure
        )
        call = Call(
            function.__name__, json.loads(settings), json.loads(task), *workers, key=len(self.calls)
        )
        self.calls.append(call)
        return call

    def cancel(self, futures, force):
        self.cancelled += len(futures)

    def run(self, function, run, on_error):
        assert function is dask_worker.end_run and on_error == "ignore"


class Call:
    def __init__(self, name, settings, task, address, key):
        self.name, self.settings, self.task = name, settings, task
        self.address, self.key, self.reply = address, key, None

    def add_done_callback(self, function):
        self._done = function

    def finish(self, **reply):
        self.reply = reply
        self._done(self)

    def result(self, timeout):
        return json.dumps(self.reply).encode()

    def cancel(self):
        self.reply = {}

    def is_open(self):
        return self.reply is None


@pytest.fixture
def quick(monkeypatch):
    """Short timeouts."""
    for name, value in (("UPDATE_SECONDS", 0.0), ("APPEAR_SECONDS", 0.2), ("READY_SECONDS", 0.2)):
        monkeypatch.setattr(coordinator, name, value)


def make_run(dask, number, lines=None):
    tasks = [Task("1.15", True, [str(key)], key=key, names=["a_region"]) for key in range(number)]
    return coordinator._Run(
        dask,
        tasks,
        {"run": "x"},
        coordinator.Cluster("tls://10.0.0.0:1", report=(lines if lines is not None else []).append),
    )


def results_of(dask, run, reply):
    """Return all results of a run, while `reply(call)` replies to each call.

    None is for a worker that has left.
    """

    def finish_calls():
        for call in [call for call in dask.calls if call.is_open()]:
            if call.address in dask.threads and (fields := reply(call)) is not None:
                call.finish(**fields)

    finished_tasks = run._finished_tasks
    run._finished_tasks = lambda: (finish_calls(), finished_tasks())[1]
    return list(run.results())


def graded(call):
    return (
        {} if call.name == "prepare" else {"result": {"graded": call.task["sources"]}, "limits": {}}
    )


def test_few_tasks_are_on_their_way_and_only_the_code_is_sent(quick):
    dask, most = Dask(a=2, b=1), Counter()

    def reply(call):
        for address in dask.threads:
            most[address] = max(
                most[address],
                sum(
                    other.is_open() and other.name == "grade"
                    for other in dask.calls
                    if other.address == address
                ),
            )
        return graded(call)

    results = results_of(dask, make_run(dask, 50), reply)
    assert sorted(key for key, _ in results) == list(range(50)) and all(
        result["graded"] == [str(key)] for key, result in results
    )
    assert most == {
        "tls://10.0.0.1:1": 2 + coordinator.PREFETCH,
        "tls://10.0.0.2:1": 1 + coordinator.PREFETCH,
    }
    assert {frozenset(call.task) for call in dask.calls if call.task} == {
        frozenset({"problem", "direction", "sources", "other_variants"})
    }
    assert {call.address: call.settings["workers"] for call in dask.calls} == {
        "tls://10.0.0.1:1": 2,
        "tls://10.0.0.2:1": 1,
    }


def test_a_notebook_that_ends_processes_is_given_up_after_three_workers(quick):
    dask = Dask(a=1, b=1, c=1, d=1)
    results = results_of(
        dask,
        make_run(dask, 9),
        lambda call: {} if call.task and call.task["sources"] == ["4"] else graded(call),
    )
    given_up = [result for key, result in results if key == 4]
    assert sorted(key for key, _ in results) == list(range(9)) and len(given_up) == 1
    assert given_up[0]["final"] == "no" and given_up[0]["remarks"] == (
        "grader: it failed on this notebook (one of its processes ended)",
    )
    tried = [call.address for call in dask.calls if call.task and call.task["sources"] == ["4"]]
    assert len(tried) == len(set(tried)) == coordinator.MAX_TRIES, "each time another worker"


def test_tasks_of_a_worker_that_left_go_to_others_and_count_once(quick):
    dask, late = Dask(a=1, b=1), []

    def reply(call):
        if call.name == "grade" and call.address == "tls://10.0.0.1:1":
            late.append(call)
            if len(late) == 2:
                del dask.threads[call.address]
            return None
        if not dask.threads.keys() & {call.address for call in late}:
            for call_of_lost_worker in late:
                # It had finished after all.
                call_of_lost_worker.finish(**graded(call_of_lost_worker))
        return graded(call)

    results = results_of(dask, make_run(dask, 6), reply)
    assert sorted(key for key, _ in results) == list(range(6)) and len(late) == 2


def test_a_worker_that_comes_later_gets_notebooks_if_it_can_grade(quick):
    dask, lines = Dask(a=1), []

    def reply(call):
        if call.name == "grade":
            dask.threads |= {"tls://10.0.0.8:1": 1, "tls://10.0.0.9:1": 1}
        return (
            {"refused": "it has sympy 1.12", "sandbox": False}
            if call.address == "tls://10.0.0.9:1"
            else graded(call)
        )

    results = results_of(dask, make_run(dask, 9), reply)
    assert sorted(key for key, _ in results) == list(range(9))
    assert {call.address for call in dask.calls if call.task} == {
        "tls://10.0.0.1:1",
        "tls://10.0.0.8:1",
    }
    assert lines == [] or lines == ["worker tls://10.0.0.9:1 gets no notebooks: it has sympy 1.12"]


def test_no_worker_and_no_scheduler_are_errors(quick):
    with pytest.raises(
        connection.ClusterError, match="the scheduler at tls://10.0.0.0:1 has no workers"
    ):
        results_of(Dask(), make_run(Dask(), 1), graded)
    dask = Dask(a=1)
    with pytest.raises(
        connection.ClusterError,
        match="no worker of tls://10.0.0.0:1 was ready to grade within 0.2 s",
    ):
        results_of(dask, make_run(dask, 1), lambda call: None)
    dask = Dask(a=1)
    with pytest.raises(
        connection.ClusterError,
        match="no worker is left at tls://10.0.0.0:1; what is graded is stored",
    ):
        results_of(
            dask,
            make_run(dask, 9),
            lambda call: dask.threads.clear() or graded(call) if call.task else graded(call),
        )
    dask = Dask(a=1)
    with pytest.raises(
        connection.ClusterError,
        match="the scheduler at tls://10.0.0.0:1 has gone; what is graded is stored",
    ):
        results_of(
            dask, make_run(dask, 9), lambda call: setattr(dask, "status", "closed") or graded(call)
        )

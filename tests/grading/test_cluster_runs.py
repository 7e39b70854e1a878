"""Which worker of a cluster gets which notebook, and what becomes of it: with a Dask that does as
the test says."""

import json
from collections import Counter

import pytest

from workbook.grading.cluster import coordinator, dask_worker


class Dask:
    """A client whose calls come back when the test says so."""

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
        self, function, settings, unit=b"null", workers=(), allow_other_workers=True, pure=True
    ):
        assert (
            type(settings) is bytes and type(unit) is bytes and not allow_other_workers and not pure
        )
        call = Call(
            function.__name__, json.loads(settings), json.loads(unit), *workers, key=len(self.calls)
        )
        self.calls.append(call)
        return call

    def cancel(self, futures, force):
        self.cancelled += len(futures)

    def run(self, function, run, on_error):
        assert function is dask_worker.end and on_error == "ignore"


class Call:
    def __init__(self, name, settings, unit, address, key):
        self.name, self.settings, self.unit = name, settings, unit
        self.address, self.key, self.answer = address, key, None

    def add_done_callback(self, function):
        self._done = function

    def comes_back(self, **answer):
        self.answer = answer
        self._done(self)

    def result(self, timeout):
        return json.dumps(self.answer).encode()

    def cancel(self):
        self.answer = {}

    def open(self):
        return self.answer is None


@pytest.fixture
def quick(monkeypatch):
    """No second is waited for anything."""
    for name, value in (("BETWEEN_LOOKS", 0.0), ("TO_COME", 0.2), ("TO_GET_READY", 0.2)):
        monkeypatch.setattr(coordinator, name, value)


def run_of(dask, number, told=None):
    units_ = [
        {
            "key": key,
            "problem": "1.15",
            "sources": [str(key)],
            "names": ["a_region"],
            "student": "ada",
        }
        for key in range(number)
    ]
    return coordinator._Run(
        dask,
        units_,
        {"run": "x"},
        coordinator.Cluster("tls://10.0.0.0:1", tell=(told if told is not None else []).append),
    )


def following(dask, run, answers):
    """All results of a run, while `answers(call)` answers each call of the workers; None for a
    worker that is gone."""

    def land():
        for call in [call for call in dask.calls if call.open()]:
            if call.address in dask.threads and (answer := answers(call)) is not None:
                call.comes_back(**answer)

    landings = run._landings
    run._landings = lambda: (land(), landings())[1]
    return list(run.results())


def graded(call):
    return (
        {} if call.name == "ready" else {"result": {"graded": call.unit["sources"]}, "limits": {}}
    )


def test_only_so_many_are_on_their_way_and_nothing_else_of_the_students(quick):
    dask, most = Dask(a=2, b=1), Counter()

    def answers(call):
        for address in dask.threads:
            most[address] = max(
                most[address],
                sum(
                    one.open() and one.name == "grade"
                    for one in dask.calls
                    if one.address == address
                ),
            )
        return graded(call)

    results = following(dask, run_of(dask, 50), answers)
    assert sorted(key for key, _ in results) == list(range(50)) and all(
        result["graded"] == [str(key)] for key, result in results
    )
    assert most == {
        "tls://10.0.0.1:1": 2 + coordinator.AHEAD,
        "tls://10.0.0.2:1": 1 + coordinator.AHEAD,
    }
    assert {frozenset(call.unit) for call in dask.calls if call.unit} == {
        frozenset({"problem", "sources"})
    }
    assert {call.address: call.settings["lanes"] for call in dask.calls} == {
        "tls://10.0.0.1:1": 2,
        "tls://10.0.0.2:1": 1,
    }


def test_a_notebook_at_which_processes_end_is_given_up_after_three_workers(quick):
    dask = Dask(a=1, b=1, c=1, d=1)
    results = following(
        dask,
        run_of(dask, 9),
        lambda call: {} if call.unit and call.unit["sources"] == ["4"] else graded(call),
    )
    given_up = [result for key, result in results if key == 4]
    assert sorted(key for key, _ in results) == list(range(9)) and len(given_up) == 1
    assert given_up[0]["final"] == "no" and given_up[0]["remarks"] == (
        "grader: it failed on this notebook (one of its processes ended)",
    )
    tried = [call.address for call in dask.calls if call.unit and call.unit["sources"] == ["4"]]
    assert len(tried) == len(set(tried)) == coordinator.MOST_TRIES, "each time another one"


def test_what_a_worker_had_that_is_gone_goes_to_others_and_counts_once(quick):
    dask, late = Dask(a=1, b=1), []

    def answers(call):
        if call.name == "grade" and call.address == "tls://10.0.0.1:1":
            late.append(call)
            if len(late) == 2:
                del dask.threads[call.address]
            return None
        if not dask.threads.keys() & {one.address for one in late}:
            for one in late:
                one.comes_back(**graded(one))  # what it had done after all
        return graded(call)

    results = following(dask, run_of(dask, 6), answers)
    assert sorted(key for key, _ in results) == list(range(6)) and len(late) == 2


def test_who_comes_later_gets_notebooks_if_it_is_fit(quick):
    dask, told = Dask(a=1), []

    def answers(call):
        if call.name == "grade":
            dask.threads |= {"tls://10.0.0.8:1": 1, "tls://10.0.0.9:1": 1}
        return (
            {"refused": "it has sympy 1.12", "sandbox": False}
            if call.address == "tls://10.0.0.9:1"
            else graded(call)
        )

    results = following(dask, run_of(dask, 9), answers)
    assert sorted(key for key, _ in results) == list(range(9))
    assert {call.address for call in dask.calls if call.unit} == {
        "tls://10.0.0.1:1",
        "tls://10.0.0.8:1",
    }
    assert told == [] or told == ["worker tls://10.0.0.9:1 gets no notebooks: it has sympy 1.12"]


def test_no_worker_and_no_scheduler_are_said(quick):
    with pytest.raises(
        coordinator.ClusterError, match="the scheduler at tls://10.0.0.0:1 has no workers"
    ):
        following(Dask(), run_of(Dask(), 1), graded)
    dask = Dask(a=1)
    with pytest.raises(
        coordinator.ClusterError,
        match="no worker of tls://10.0.0.0:1 was ready to grade within 0.2 s",
    ):
        following(dask, run_of(dask, 1), lambda call: None)
    dask = Dask(a=1)
    with pytest.raises(
        coordinator.ClusterError,
        match="no worker is left at tls://10.0.0.0:1; what is graded is stored",
    ):
        following(
            dask,
            run_of(dask, 9),
            lambda call: dask.threads.clear() or graded(call) if call.unit else graded(call),
        )
    dask = Dask(a=1)
    with pytest.raises(
        coordinator.ClusterError,
        match="the scheduler at tls://10.0.0.0:1 has gone; what is graded is stored",
    ):
        following(
            dask, run_of(dask, 9), lambda call: setattr(dask, "status", "closed") or graded(call)
        )

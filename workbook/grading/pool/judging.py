"""Judging: decode what a notebook handed over, and run the exercise's check cells on it.

A child judges, within bounds on time and memory, since an answer can be an expression built to
explode: the kernel keeps the bounds on Linux, elsewhere the parent does. The child runs nothing of
a student's, only our own cells on data, as a kernel does in which check cells run again and again:
so it judges one notebook after the other, and a child for each would cost more than most judgements
do. An unusual judgement is repeated by a fresh child, and the child that gave it judges nothing
else. If the whole notebook cannot be judged within the bounds, its answers are judged one by one,
each in a child of its own, so that one exploding answer costs only itself; it becomes `unchecked`,
which a lecturer has to look at, never wrong and never right.
"""

import hashlib
import json
import math
import multiprocessing
import os
import random
import re
import sys
import time
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache
from typing import NamedTuple

from workbook.checks.contract import cell_watch
from workbook.checks.contract.encoding import describe
from workbook.checks.contract.verdict import MISSING, UNCHECKED, Unusable, Verdict
from workbook.grading.sandbox.sanitising import sanitise
from workbook.grading.sandbox.submitted_file import MAX_CELLS
from workbook.notebooks.execution import CONTEXT, Child, TimeLimit, decoded, judge_answers, run_cell

#: The remark on a notebook that handed nothing over, by how it ended: whose doing it was, and what.
END_REMARKS = {
    "time": "limits: the notebook was still running when its time was up",
    "memory": "limits: the notebook needed more memory than allowed",
    "processes": "limits: the notebook started more processes than allowed",
    "sockets": "limits: the notebook opened more sockets than allowed",
    "large": "limits: the notebook handed over more than allowed",
    "died": "notebook: its process was ended by what the notebook did",
    "failed": "grader: it failed on this notebook",
    "elsewhere": "grader: this notebook waits for a machine with Linux",
}
#: Seconds in which every honest answer can be judged: each one gets so many while any time is left.
MIN_ANSWER_SECONDS = 5
NEVER_ASSIGNED = (
    "no cell of the notebook assigned this variable: was it renamed, or did its cell fail?"
)
FINAL, WITHIN_LIMITS, NOT_FINAL, ELSEWHERE = "yes", "within limits", "no", "elsewhere"


@dataclass(frozen=True)
class Bounds:
    """What judging one notebook may use; wall time may be three times the processor time.

    Parameters
    ----------
    seconds, answer_seconds : float
        Of processor time: for the whole notebook, and for one answer that is judged alone.
    memory_megabytes : int
        Of memory.
    """

    seconds: float = 90
    answer_seconds: float = 20
    memory_megabytes: int = 4096

    @property
    def first_seconds(self):
        """The part of `seconds` for all answers at once; the rest is for them one by one."""
        return self.seconds / 2


@dataclass(frozen=True)
class Judgement:
    """The verdicts on a notebook.

    Parameters
    ----------
    verdicts : dict
        Verdicts by answer.
    answers : dict
        The answers as short texts.
    remarks : tuple of str
        On the notebook as a whole; each begins with whose doing it is: "notebook", "limits" or
        "grader".
    final : str
        "yes"; "within limits" if other limits could change it; "no" if the grader itself failed,
        so that the notebook is to be graded again; "elsewhere" if it is to be graded on a machine
        with Linux.
    hashes : dict
        Hashes of the whole encoded answers.
    seconds : float
        Of computing that running and judging the notebook took.
    """

    verdicts: dict
    answers: dict
    remarks: tuple
    final: str = FINAL
    hashes: dict = field(default_factory=dict)
    seconds: float = field(default=0.0, compare=False)


def judge(exercise, outcome, bounds=Bounds()):
    """Return the `Judgement` on one sandbox `Outcome` for a pristine `exercises.Exercise`."""
    judge = Judge(bounds)
    try:
        return judge.judge(exercise, outcome)
    finally:
        judge.end()


class Judge:
    """Judges one notebook after the other.

    Call `prepare` for an exercise while the notebook still runs, then `judge` with its outcome, and
    `end` after the last one. `seconds_used` is the processor time of all judgements so far.
    """

    def __init__(self, bounds=Bounds()):
        self._bounds, self._process = bounds, None
        self.seconds_used = 0.0

    def prepare(self, exercise):
        """Start the judging process for an exercise, unless there is one."""
        if self._process is None:
            self._process = _JudgingProcess(_cells(exercise))

    def judge(self, exercise, outcome):
        """Return the `Judgement` on a sandbox `Outcome`."""
        names, cells = list(exercise.about["answers"]), _cells(exercise)
        remaining = self._bounds.first_seconds
        if outcome.ended != "done":
            return _without_answers(names, outcome)
        while True:
            self.prepare(exercise)
            fresh, began = self._process.fresh, time.monotonic()
            try:
                judgement = self._process.judgement(
                    outcome.handed_over,
                    _Request(cells, names, remaining, self._bounds.memory_megabytes),
                )
            except RuntimeError as error:
                judgement, fresh = None, fresh or isinstance(error, TimeLimit)
            self.seconds_used += self._process.seconds_used
            unusual = judgement is None or any(
                v.status == UNCHECKED for v in judgement.verdicts.values()
            )
            if unusual or self._process.has_grown:
                self.end()
            if judgement is not None and (fresh or not unusual):
                return judgement
            remaining -= time.monotonic() - began
            if fresh or remaining < 1:
                before = _seconds_of_children()
                judgement = _one_by_one(cells, outcome.handed_over, names, self._bounds)
                self.seconds_used += _seconds_of_children() - before
                return judgement

    def end(self):
        """End the judging process."""
        if self._process is not None:
            self._process.end()
            self._process = None


def _cells(exercise):
    return tuple(exercise.code("data", "check"))


def grader_failure(names, reason):
    """Return the `Judgement` when the grader failed: no fault of the student, and not final."""
    verdict = Verdict(UNCHECKED, "the grader failed on this notebook; it will be graded again")
    return Judgement(
        dict.fromkeys(names, verdict), {}, (f"{END_REMARKS['failed']} ({reason})",), NOT_FINAL
    )


def _without_answers(names, outcome):
    details = sanitise(outcome.handed_over.decode("utf-8", "replace")[:200])
    if outcome.ended == "failed":
        return grader_failure(names, details)
    if outcome.ended == "elsewhere":
        verdict = Verdict(UNCHECKED, f"waits to be graded on a machine with Linux: {details}")
        remark = f"{END_REMARKS['elsewhere']} ({details})"
        return Judgement(dict.fromkeys(names, verdict), {}, (remark,), ELSEWHERE)
    remark = END_REMARKS[outcome.ended] + (f" ({details})" if outcome.ended == "died" else "")
    return Judgement(
        dict.fromkeys(names, Verdict(MISSING, f"no answer: {remark.partition(': ')[2]}")),
        {},
        (remark,),
        FINAL if outcome.ended == "died" else WITHIN_LIMITS,
    )


def _one_by_one(cells, handed_over, names, bounds):
    """Judge each answer alone, within the time left for the notebook."""
    verdicts, answers, remarks, hashes = {}, {}, (), {}
    remaining = bounds.seconds - bounds.first_seconds
    for waiting, name in zip(range(len(names), 0, -1), names):
        seconds = min(
            bounds.answer_seconds, remaining, max(MIN_ANSWER_SECONDS, remaining / waiting)
        )
        if seconds < 1:
            verdicts[name] = Verdict(
                UNCHECKED,
                f"judging this notebook took longer than {bounds.seconds:g} s; "
                "a lecturer has to look at it",
            )
            continue
        process, before = _JudgingProcess(cells), _seconds_of_children()
        try:
            judgement = process.judgement(
                handed_over, _Request(cells, names, seconds, bounds.memory_megabytes, name)
            )
            verdicts[name], remarks = judgement.verdicts[name], judgement.remarks
            answers |= judgement.answers
            hashes |= judgement.hashes
        except TimeLimit:
            verdicts[name] = Verdict(
                UNCHECKED,
                f"judging this answer took longer than {seconds:.3g} s; "
                "a lecturer has to look at it",
            )
        except RuntimeError:
            verdicts[name] = Verdict(
                UNCHECKED,
                "judging this answer needed more memory than allowed, or failed; "
                "a lecturer has to look at it",
            )
        finally:
            process.end()
        remaining -= _seconds_of_children() - before
    return Judgement(verdicts, answers, remarks, WITHIN_LIMITS, hashes)


def _seconds_of_children():
    """Return the processor time of all children that have ended.

    Windows does not tell, so there it is the time that has elapsed.
    """
    if sys.platform == "win32":
        return time.monotonic()
    used = os.times()
    return used.children_user + used.children_system


class _Request(NamedTuple):
    """What is to be judged by `cells`: the answers `names`, or `only` one, and within which bounds."""

    cells: tuple
    names: list
    seconds: float
    megabytes: int
    only: str | None = None


class _JudgingProcess:
    """A child that judges one notebook after the other; it first runs the data cells of `cells`.

    `fresh` is whether it has judged nothing yet; `has_grown`, whether it should judge no more;
    `seconds_used` is the processor time of the last judgement.
    """

    def __init__(self, cells):
        receiver, self._sender = CONTEXT.Pipe(duplex=False)
        self._child = Child(_serve, receiver, self._sender, cells)
        self.fresh, self.has_grown, self.seconds_used = True, False, 0.0
        receiver.close()

    def judgement(self, handed_over, request):
        """Judge what was handed over; raise `TimeLimit` or another `RuntimeError`."""
        self.fresh, self.seconds_used = False, request.seconds  # if it ends without a result
        with suppress(OSError):  # it has died, which reading its result shows
            self._sender.send_bytes(json.dumps(request).encode())
            self._sender.send_bytes(handed_over)
        memory = math.inf if sys.platform == "linux" else request.megabytes * 2**20
        result = self._child.result(timeout=3 * request.seconds, memory=memory)
        verdicts, answers, remarks, stopped, hashes, self.has_grown, self.seconds_used = result
        return Judgement(
            {name: Verdict(*verdict) for name, verdict in verdicts.items()},
            answers,
            tuple(remarks),
            WITHIN_LIMITS if stopped else FINAL,
            hashes,
        )

    def end(self):
        self._sender.close()
        self._child.end()


# In the child

#: Bytes by which a process may grow while it judges, and still judge another notebook.
MAX_GROWTH = 2**29


def _serve(receiver, sender, cells):
    """Judge each request until the pipe closes."""
    if sys.platform == "linux":
        from workbook.grading.sandbox.system_calls import die_with_parent  # for Linux only

        die_with_parent(multiprocessing.parent_process().pid)
    sender.close()  # or the pipe would not end when the parent closes its copy
    _after_data_cells(tuple(cells))
    size_at_start = _address_space_bytes()
    with suppress(EOFError):
        while True:
            request = _Request(*json.loads(receiver.recv_bytes()))
            began = time.process_time()
            _reset()
            _set_limits(request)
            result = _judge(receiver.recv_bytes(), request)
            has_grown = _address_space_bytes() > size_at_start + MAX_GROWTH
            yield [*result, has_grown, time.process_time() - began]


def _reset():
    """Clear SymPy's cache and seed random numbers, so that no verdict depends on earlier ones."""
    import numpy as np  # here, since a process that only waits for a judge needs none of them
    import sympy.core.cache
    import sympy.core.random

    sympy.core.cache.clear_cache()
    for generator in (random, np.random, sympy.core.random):
        generator.seed(0)


def _set_limits(request):
    """Limit what this process may use from now on, where the kernel does that."""
    if sys.platform != "linux":
        return
    import resource  # Linux has it

    memory = _address_space_bytes() + request.megabytes * 2**20
    cpu_time = int(time.process_time() + request.seconds) + 1
    for kind, bound in ((resource.RLIMIT_AS, memory), (resource.RLIMIT_CPU, cpu_time)):
        resource.setrlimit(kind, (bound, resource.getrlimit(kind)[1]))


def _address_space_bytes():
    """Return the bytes of address space of this process; 0 where only the parent limits it."""
    if sys.platform != "linux":
        return 0
    from workbook.grading.sandbox.system_calls import address_space_bytes  # for Linux only

    return address_space_bytes()


@lru_cache(maxsize=16)
def _after_data_cells(cells):
    """Return (namespace after the data cells at the beginning, the cells that follow).

    These cells are ours, and the same for all notebooks.
    """
    first = next((k for k, (role, _) in enumerate(cells) if role == "check"), len(cells))
    namespace = {"__name__": "exercise"}
    try:
        for cell in cells[:first]:
            run_cell(cell, namespace)
    except Exception:  # it comes again, and is reported, when the cells are run to judge
        return None, cells
    return namespace, cells[first:]


def _judge(handed_over, request):
    """Decode the bytes strictly, keep the answers asked for, and judge them."""
    read = texts = assigned = None
    names = request.names

    def answers():
        nonlocal read, texts, assigned
        read = _parse(handed_over, [name for name in names if request.only in (None, name)])
        values = decoded(read.encoded, read.unreadable, names)
        texts = {name: _short_text(values[name]) for name in read.encoded}
        assigned = {*read.encoded, *read.unreadable, *cell_watch.stopped, *cell_watch.meant}
        return values

    namespace, following = _after_data_cells(tuple(map(tuple, request.cells)))
    verdicts = judge_answers(following, answers, names, namespace and dict(namespace))
    hashes = {
        name: hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()
        for name, text in read.encoded.items()
    }
    plain_verdicts = {
        name: [
            status,
            NEVER_ASSIGNED
            if status == MISSING and name not in assigned
            else sanitise(message[:2000], keep="\n"),
            mistake,
        ]
        for name, (status, message, mistake) in verdicts.items()
    }
    return [plain_verdicts, texts, read.remarks, read.stopped, hashes]


def _short_text(answer):
    """Return an answer as a short text for the lecturer."""
    if isinstance(answer, Unusable):
        return f"({sanitise(answer.reason[:400])})"
    # Matrices are printed over several lines with padded columns; a line break within a text is an
    # escape already.
    return sanitise(re.sub(r"\s+", " ", describe(answer).replace("[\n", "[")))


class _HandedOver(NamedTuple):
    """What a notebook handed over: texts of answers, why others have none, and whether cells were stopped."""

    encoded: dict
    unreadable: dict
    remarks: list
    stopped: bool


def _parse(handed_over, names):
    """Return what was handed over, for the answers `names`.

    Bytes not of the form of `run_cells` count as nothing. `report` gets the notes on cells.
    """
    try:
        outcome = json.loads(handed_over)
        encoded, unreadable, errors, stopped = (
            outcome[key] for key in ("encoded", "unreadable", "errors", "stopped")
        )
        cell_watch.recall(*(outcome.get(notes, {}) for notes in ("failed", "overwritten", "meant")))
        if not (
            type(errors) is type(stopped) is list
            and _are_texts([*encoded.items(), *unreadable.items(), errors])
            and all(type(k) is int and 0 < k <= MAX_CELLS for k in stopped)
        ):
            raise ValueError
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        cell_watch.recall({}, {}, {})
        return _HandedOver({}, {}, ["notebook: what it handed over cannot be read"], False)
    # All texts of the notebook are marked as such, since they could pretend to be the grader's.
    remarks = [f"notebook: {sanitise(error[:400])}" for error in errors[:20]]
    remarks += [
        f"limits: code cell {k} was stopped: it took half of the time that was left"
        for k in stopped[:20]
    ]
    return _HandedOver(
        {name: encoded[name] for name in names if name in encoded},
        {
            name: f"notebook: {sanitise(unreadable[name][:400])}"
            for name in names
            if name in unreadable
        },
        remarks,
        bool(stopped),
    )


def _are_texts(groups):
    return all(type(text) is str for group in groups for text in group)

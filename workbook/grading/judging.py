"""Judge what a notebook handed over: decode, run data and check cells of the pristine exercise,
within limits.

A forked child judges, within bounds on time and memory, since an answer can be an expression built
to explode. It runs nothing of a student's, only our own cells on data, as a kernel does in which
check cells run again and again: so it judges one notebook after the other, and a fork for each
would cost more than most judgements do. Whatever is unusual there is judged again by a fresh child,
and nothing else by the one that met it. If the whole notebook cannot be judged within the bounds,
its answers are judged one by one, each in a child of its own, so that one such answer costs only
itself; it becomes `unchecked`, which a lecturer has to look at, never wrong and never right.
"""

import hashlib
import json
import multiprocessing
import random
import re
import resource
import sys
import time
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache

from workbook.checks.contract.encoding import describe
from workbook.checks.contract.verdict import MISSING, UNCHECKED, Unusable, Verdict
from workbook.grading.isolation import end_with_parent, loaded
from workbook.grading.sanitising import printable
from workbook.grading.submitted_file import MOST_CELLS
from workbook.notebooks.execution import CONTEXT, Child, TimeLimit, decoded, judge_answers, run_cell

#: How a notebook ended that handed nothing over: whose affair it is, in the words of a remark.
ENDS = {
    "time": "limits: the notebook was still running when its time was up",
    "memory": "limits: the notebook needed more memory than allowed",
    "processes": "limits: the notebook started more processes than allowed",
    "sockets": "limits: the notebook opened more sockets than allowed",
    "large": "limits: the notebook handed over more than allowed",
    "died": "notebook: its process was ended by what the notebook did",
    "failed": "grader: it failed on this notebook",
}
#: Seconds that every honest answer can be judged in: as much is tried for each one while any time
#: is left.
ENOUGH = 5
NEVER_ASSIGNED = (
    "no cell of the notebook assigned this variable: was it renamed, or did its cell fail?"
)
FINAL, WITHIN_LIMITS, NOT_FINAL = "yes", "within limits", "no"


@dataclass(frozen=True)
class Bounds:
    """What judging one notebook in all, and one answer of it, may take: seconds of computing, three
    times as many on the clock."""

    seconds: float = 90
    answer_seconds: float = 20
    memory_megabytes: int = 4096

    @property
    def first_seconds(self):
        """For all answers at once; what is left of `seconds` is for them one by one."""
        return self.seconds / 2


@dataclass(frozen=True)
class Judgement:
    """Verdicts by answer, the answers as short texts (and hashes of the whole ones), and remarks on
    the notebook itself.

    Each remark begins with whose affair it is: "notebook", "limits" or "grader". `final` is "yes";
    "within limits" if other limits could change it; "no" if the grader itself failed, so that the
    notebook is to be graded again.
    """

    verdicts: dict
    answers: dict
    remarks: tuple
    final: str = FINAL
    hashes: dict = field(default_factory=dict)


def judge(exercise, outcome, bounds=Bounds()):
    """The `Judgement` on a sandbox `Outcome` for a pristine exercise
    (`workbook.notebooks.exercises.Exercise`)."""
    judge = Judge(bounds)
    try:
        return judge.of(exercise, outcome)
    finally:
        judge.end()


class Judge:
    """Judges one notebook after the other: `get_ready` for an exercise while the notebook still
    runs, then judge `of` its outcome."""

    def __init__(self, bounds=Bounds()):
        self._bounds, self._process = bounds, None

    def get_ready(self, exercise):
        if self._process is None:
            self._process = _Process(_cells(exercise))

    def of(self, exercise, outcome):
        names, cells, left = (
            list(exercise.about["answers"]),
            _cells(exercise),
            self._bounds.first_seconds,
        )
        if outcome.ended != "done":
            return _without_answers(names, outcome)
        while True:
            self.get_ready(exercise)
            fresh, begun = self._process.fresh, time.monotonic()
            try:
                judgement = self._process.judgement(
                    outcome.handed_over, cells, names, left, self._bounds.memory_megabytes
                )
            except RuntimeError as error:
                judgement, fresh = None, fresh or isinstance(error, TimeLimit)
            unusual = judgement is None or any(
                v.status == UNCHECKED for v in judgement.verdicts.values()
            )
            if unusual or self._process.worn:
                self.end()
            if judgement is not None and (fresh or not unusual):
                return judgement
            left -= time.monotonic() - begun
            if fresh or left < 1:
                return _one_by_one(cells, outcome.handed_over, names, self._bounds)

    def end(self):
        if self._process is not None:
            self._process.end()
            self._process = None


def _cells(exercise):
    return tuple(exercise.code("data", "check"))


def failed(names, why):
    """The `Judgement` when the grader could not do its work: nothing is the student's fault, and
    nothing is final."""
    verdict = Verdict(UNCHECKED, "the grader failed on this notebook; it will be graded again")
    return Judgement(dict.fromkeys(names, verdict), {}, (f"{ENDS['failed']} ({why})",), NOT_FINAL)


def _without_answers(names, outcome):
    manner = printable(outcome.handed_over.decode("utf-8", "replace")[:200])
    if outcome.ended == "failed":
        return failed(names, manner)
    remark = ENDS[outcome.ended] + (f" ({manner})" if outcome.ended == "died" else "")
    return Judgement(
        dict.fromkeys(names, Verdict(MISSING, f"no answer: {remark.partition(': ')[2]}")),
        {},
        (remark,),
        FINAL if outcome.ended == "died" else WITHIN_LIMITS,
    )


def _one_by_one(cells, handed_over, names, bounds):
    """Judge each answer alone, within what is left for the notebook: one that explodes costs only
    itself."""
    verdicts, answers, remarks, hashes = {}, {}, (), {}
    left = bounds.seconds - bounds.first_seconds
    for waiting, name in zip(range(len(names), 0, -1), names):
        seconds = min(bounds.answer_seconds, left, max(ENOUGH, left / waiting))
        if seconds < 1:
            verdicts[name] = Verdict(
                UNCHECKED,
                f"judging this notebook took longer than {bounds.seconds:g} s; "
                "a lecturer has to look at it",
            )
            continue
        process, before = _Process(cells), _computed_by_children()
        try:
            alone = process.judgement(
                handed_over, cells, names, seconds, bounds.memory_megabytes, only=name
            )
            verdicts[name], remarks = alone.verdicts[name], alone.remarks
            answers |= alone.answers
            hashes |= alone.hashes
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
        left -= _computed_by_children() - before
    return Judgement(verdicts, answers, remarks, WITHIN_LIMITS, hashes)


def _computed_by_children():
    """Seconds of computing of all children that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class _Process:
    """A child that judges whatever is handed over, one notebook after the other; it begins with
    what `cells` need."""

    def __init__(self, cells):
        receiver, self._sender = CONTEXT.Pipe(duplex=False)
        self._child = Child(_serve, receiver, self._sender, cells)
        #: Whether it has judged nothing yet, and whether it should judge no more.
        self.fresh, self.worn = True, False
        receiver.close()

    def judgement(self, handed_over, cells, names, seconds, megabytes, only=None):
        """On all answers, or `only` one. Raises `TimeLimit` or another `RuntimeError`."""
        self.fresh = False
        with suppress(OSError):  # it has died, which its result will tell
            self._sender.send_bytes(json.dumps([cells, names, seconds, megabytes, only]).encode())
            self._sender.send_bytes(handed_over)
        verdicts, answers, remarks, stopped, hashes, self.worn = self._child.result(
            timeout=3 * seconds
        )
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

#: Bytes that a process may have taken on while it judged, and still judge.
WORN = 2**29


def _serve(receiver, sender, cells):
    """Judge what comes, until nothing does any more."""
    if sys.platform == "linux":
        end_with_parent(multiprocessing.parent_process().pid)
    sender.close()  # or its own copy would keep it waiting when the other one is gone
    _begun(tuple(cells))
    at_first = loaded()
    with suppress(EOFError):
        while True:
            cells, names, seconds, megabytes, only = json.loads(receiver.recv_bytes())
            _forget()
            _limit(seconds, megabytes)
            judged = _judged(receiver.recv_bytes(), tuple(map(tuple, cells)), names, only)
            yield [*judged, loaded() > at_first + WORN]


def _forget():
    """So that no verdict depends on what was judged before: a formula that equals another is no
    better known for it, and chance is the same for all."""
    import numpy as np  # here, since whoever only waits for a judge needs none of them
    import sympy.core.cache
    import sympy.core.random

    sympy.core.cache.clear_cache()
    for chance in (random, np.random, sympy.core.random):
        chance.seed(0)


def _limit(seconds, megabytes):
    """What this process may use from now on."""
    memory, processor = loaded() + megabytes * 2**20, int(time.process_time() + seconds) + 1
    for kind, bound in ((resource.RLIMIT_AS, memory), (resource.RLIMIT_CPU, processor)):
        resource.setrlimit(kind, (bound, resource.getrlimit(kind)[1]))


@lru_cache(maxsize=16)
def _begun(cells):
    """(names and values after the data cells at the beginning, the cells that follow): ours, and
    the same for all who are judged."""
    first = next((k for k, (role, _) in enumerate(cells) if role == "check"), len(cells))
    namespace = {"__name__": "exercise"}
    try:
        for cell in cells[:first]:
            run_cell(cell, namespace)
    except Exception:  # the judge meets it too, and tells
        return None, cells
    return namespace, cells[first:]


def _judged(handed_over, cells, names, only):
    """Read the bytes strictly, keep the answers asked for, judge."""
    found = {}

    def answers():
        encoded, unreadable, found["remarks"], found["stopped"] = _read(
            handed_over, [name for name in names if only in (None, name)]
        )
        given = decoded(encoded, unreadable, names)
        found["never assigned"] = set(names) - {*encoded, *unreadable}
        found["texts"] = {name: _described(given[name]) for name in encoded}
        found["hashes"] = {
            name: hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()
            for name, text in encoded.items()
        }
        return given

    namespace, following = _begun(cells)
    verdicts = judge_answers(following, answers, names, namespace and dict(namespace))
    told = {
        name: [
            status,
            NEVER_ASSIGNED
            if status == MISSING and name in found["never assigned"]
            else printable(message[:2000], keep="\n"),
            mistake,
        ]
        for name, (status, message, mistake) in verdicts.items()
    }
    return [told, *(found[key] for key in ("texts", "remarks", "stopped", "hashes"))]


def _described(answer):
    """A short text for the lecturer's eyes."""
    if isinstance(answer, Unusable):
        return f"({printable(answer.reason[:400])})"
    # Matrices are printed over several lines; a line break in a text is an escape already.
    # They pad their columns, too.
    return printable(re.sub(r"\s+", " ", describe(answer).replace("[\n", "[")))


def _read(handed_over, names):
    """(encoded, unreadable, remarks, whether cells were stopped) from a worker's bytes, of the
    answers `names`.

    Bytes that are not of the worker's form count as nothing handed over.
    """
    try:
        outcome = json.loads(handed_over)
        encoded, unreadable, errors, stopped = (
            outcome[key] for key in ("encoded", "unreadable", "errors", "stopped")
        )
        if not (
            _are_texts(encoded.items())
            and _are_texts(unreadable.items())
            and type(errors) is type(stopped) is list
            and _are_texts([errors])
            and all(type(k) is int and 0 < k <= MOST_CELLS for k in stopped)
        ):
            raise ValueError
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return {}, {}, ["notebook: what it handed over cannot be read"], False
    # All words of its own are said to be the notebook's, since they could pretend to be another's.
    remarks = [f"notebook: {printable(error[:400])}" for error in errors[:20]]
    remarks += [
        f"limits: code cell {k} was stopped: it took half of the time that was left"
        for k in stopped[:20]
    ]
    return (
        {name: encoded[name] for name in names if name in encoded},
        {
            name: f"notebook: {printable(unreadable[name][:400])}"
            for name in names
            if name in unreadable
        },
        remarks,
        bool(stopped),
    )


def _are_texts(groups):
    return all(type(one) is str for group in groups for one in group)

"""Judge what a notebook handed over: decode, run data and check cells of the pristine exercise, within limits.

Each judgement is a forked child with bounds on time and memory, since an answer can be an expression built to
explode. It starts while the notebook is still running, and finds the data cells run: its parent does that once a
problem. If the whole notebook cannot be judged
within them, its answers are judged one by one, so that one such answer costs only itself; it becomes `unchecked`, which
a lecturer has to look at, never wrong and never right.
"""

import hashlib
import json
import multiprocessing
import re
import resource
import sys
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache

from trajlib.checks.contract.encoding import describe
from trajlib.checks.contract.verdict import MISSING, UNCHECKED, Unusable, Verdict
from trajlib.execution import CONTEXT, Child, TimeLimit, decoded, judge_answers, run_cell
from trajlib.grading.isolation import end_with_parent, loaded
from trajlib.grading.printable import printable
from trajlib.grading.submitted_file import MOST_CELLS

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
#: Seconds that every honest answer can be judged in: as much is tried for each one while any time is left.
ENOUGH = 5
NEVER_ASSIGNED = "no cell of the notebook assigned this variable: was it renamed, or did its cell fail?"
FINAL, WITHIN_LIMITS, NOT_FINAL = "yes", "within limits", "no"


@dataclass(frozen=True)
class Bounds:
    """What judging one notebook in all, and one answer of it, may take: seconds of computing, three times as many on
    the clock."""

    seconds: float = 90
    answer_seconds: float = 20
    memory_megabytes: int = 4096

    @property
    def first_seconds(self):
        """For all answers at once; what is left of `seconds` is for them one by one."""
        return self.seconds / 2


@dataclass(frozen=True)
class Judgement:
    """Verdicts by answer, the answers as short texts (and hashes of the whole ones), and remarks on the notebook
    itself.

    Each remark begins with whose affair it is: "notebook", "limits" or "grader". `final` is "yes"; "within limits" if
    other limits could change it; "no" if the grader itself failed, so that the notebook is to be graded again.
    """

    verdicts: dict
    answers: dict
    remarks: tuple
    final: str = FINAL
    hashes: dict = field(default_factory=dict)


def judge(exercise, outcome, bounds=Bounds()):
    """The `Judgement` on a sandbox `Outcome` for a pristine exercise (`trajlib.exercises.Exercise`)."""
    judging = Judging(exercise, bounds)
    try:
        return judging.of(outcome)
    finally:
        judging.end()


class Judging:
    """Gets ready from now on to judge one notebook of an exercise; then `of` its outcome comes the judgement."""

    def __init__(self, exercise, bounds=Bounds()):
        self._names, self._bounds = list(exercise.about["answers"]), bounds
        self._cells = tuple(exercise.code("data", "check"))
        self._first = _Judge(self._cells, self._names, bounds.first_seconds, bounds.memory_megabytes)

    def of(self, outcome):
        if outcome.ended != "done":
            return _without_answers(self._names, outcome)
        try:
            return self._first.judgement(outcome.handed_over)
        except RuntimeError:
            return _one_by_one(self._cells, outcome.handed_over, self._names, self._bounds)

    def end(self):
        self._first.end()


def failed(names, why):
    """The `Judgement` when the grader could not do its work: nothing is the student's fault, and nothing is final."""
    verdict = Verdict(UNCHECKED, "the grader failed on this notebook; it will be graded again")
    return Judgement(dict.fromkeys(names, verdict), {}, (f"{ENDS['failed']} ({why})",), NOT_FINAL)


def _without_answers(names, outcome):
    manner = printable(outcome.handed_over.decode("utf-8", "replace")[:200])
    if outcome.ended == "failed":
        return failed(names, manner)
    remark = ENDS[outcome.ended] + (f" ({manner})" if outcome.ended == "died" else "")
    return Judgement(dict.fromkeys(names, Verdict(MISSING, f"no answer: {remark.partition(': ')[2]}")), {}, (remark,),
                     FINAL if outcome.ended == "died" else WITHIN_LIMITS)


def _one_by_one(cells, handed_over, names, bounds):
    """Judge each answer alone, within what is left for the notebook: one that explodes costs only itself."""
    verdicts, answers, remarks, hashes = {}, {}, (), {}
    left = bounds.seconds - bounds.first_seconds
    for waiting, name in zip(range(len(names), 0, -1), names):
        seconds = min(bounds.answer_seconds, left, max(ENOUGH, left / waiting))
        if seconds < 1:
            verdicts[name] = Verdict(UNCHECKED, f"judging this notebook took longer than {bounds.seconds:g} s; "
                                     "a lecturer has to look at it")
            continue
        judge, before = _Judge(cells, names, seconds, bounds.memory_megabytes, only=name), _computed_by_children()
        try:
            alone = judge.judgement(handed_over)
            verdicts[name], remarks = alone.verdicts[name], alone.remarks
            answers |= alone.answers
            hashes |= alone.hashes
        except TimeLimit:
            verdicts[name] = Verdict(UNCHECKED, f"judging this answer took longer than {seconds:.3g} s; "
                                     "a lecturer has to look at it")
        except RuntimeError:
            verdicts[name] = Verdict(UNCHECKED, "judging this answer needed more memory than allowed, or failed; "
                                     "a lecturer has to look at it")
        finally:
            judge.end()
        left -= _computed_by_children() - before
    return Judgement(verdicts, answers, remarks, WITHIN_LIMITS, hashes)


def _computed_by_children():
    """Seconds of computing of all children that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


@lru_cache(maxsize=16)
def _begun(cells):
    """(names and values after the data cells at the beginning, the cells that follow): ours, and the same for all who
    are judged, who each get a copy with their process."""
    first = next((k for k, (role, _) in enumerate(cells) if role == "check"), len(cells))
    namespace = {"__name__": "exercise"}
    try:
        for cell in cells[:first]:
            run_cell(cell, namespace)
    except Exception:  # the judge meets it too, and tells
        return None, cells
    return namespace, cells[first:]


class _Judge:
    """A child that judges once what is handed over: all answers, or `only` one."""

    def __init__(self, cells, names, seconds, megabytes, only=None):
        receiver, self._sender = CONTEXT.Pipe(duplex=False)
        _begun(tuple(cells))  # here, so that it is there in all who are forked from this process
        self._child = Child(_judge, receiver, self._sender, cells, names, seconds, megabytes, only)
        self._seconds = seconds
        receiver.close()

    def judgement(self, handed_over):
        with suppress(OSError):  # it has died, which its result will tell
            self._sender.send_bytes(handed_over)
        verdicts, answers, remarks, stopped, hashes = self._child.result(timeout=3 * self._seconds)
        return Judgement({name: Verdict(*verdict) for name, verdict in verdicts.items()}, answers, tuple(remarks),
                         WITHIN_LIMITS if stopped else FINAL, hashes)

    def end(self):
        self._sender.close()
        self._child.end()


def _judge(receiver, sender, cells, names, seconds, megabytes, only):
    """In the child: read the bytes strictly, keep the answers asked for, judge."""
    if sys.platform == "linux":
        end_with_parent(multiprocessing.parent_process().pid)
    sender.close()  # or its own copy would keep it waiting when the other one is gone
    memory = loaded() + megabytes * 2**20
    resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
    found = {}

    def answers():
        encoded, unreadable, found["remarks"], found["stopped"] = _read(receiver.recv_bytes(),
                                                                        [name for name in names
                                                                         if only in (None, name)])
        given = decoded(encoded, unreadable, names)
        found["never assigned"] = set(names) - {*encoded, *unreadable}
        found["texts"] = {name: _described(given[name]) for name in encoded}
        found["hashes"] = {name: hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()
                           for name, text in encoded.items()}
        return given

    namespace, following = _begun(tuple(cells))
    verdicts = judge_answers(following, answers, names, namespace)
    told = {name: [status, NEVER_ASSIGNED if status == MISSING and name in found["never assigned"]
                   else printable(message[:2000], keep="\n"), mistake]
            for name, (status, message, mistake) in verdicts.items()}
    return [told, *(found[key] for key in ("texts", "remarks", "stopped", "hashes"))]


def _described(answer):
    """A short text for the lecturer's eyes."""
    if isinstance(answer, Unusable):
        return f"({printable(answer.reason[:400])})"
    # Matrices are printed over several lines; a line break in a text is an escape already.
    # They pad their columns, too.
    return printable(re.sub(r"\s+", " ", describe(answer).replace("[\n", "[")))


def _read(handed_over, names):
    """(encoded, unreadable, remarks, whether cells were stopped) from a worker's bytes, of the answers `names`.

    Bytes that are not of the worker's form count as nothing handed over.
    """
    try:
        outcome = json.loads(handed_over)
        encoded, unreadable, errors, stopped = (outcome[key] for key in ("encoded", "unreadable", "errors", "stopped"))
        if not (_are_texts(encoded.items()) and _are_texts(unreadable.items()) and type(errors) is type(stopped) is list
                and _are_texts([errors]) and all(type(k) is int and 0 < k <= MOST_CELLS for k in stopped)):
            raise ValueError
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return {}, {}, ["notebook: what it handed over cannot be read"], False
    # All words of its own are said to be the notebook's, since they could pretend to be another's.
    remarks = [f"notebook: {printable(error[:400])}" for error in errors[:20]]
    remarks += [f"limits: code cell {k} was stopped: it took half of the time that was left" for k in stopped[:20]]
    return ({name: encoded[name] for name in names if name in encoded},
            {name: f"notebook: {printable(unreadable[name][:400])}" for name in names if name in unreadable}, remarks,
            bool(stopped))


def _are_texts(groups):
    return all(type(one) is str for group in groups for one in group)

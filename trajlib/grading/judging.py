"""Judge what a notebook handed over: decode, run data and check cells of the pristine exercise, within limits.

Each judgement is a forked child with bounds on time and memory, since an answer can be an expression built to
explode. If the whole notebook cannot be judged in time, its answers are judged one by one, so that one such answer
costs only itself; it becomes `unchecked`, which a lecturer has to look at, never wrong and never right.
"""

import json
import resource
from dataclasses import dataclass

from trajlib.checks.encoding import EncodingError, decode, describe
from trajlib.checks.verdict import MISSING, UNCHECKED, Verdict
from trajlib.execution import TimeLimit, in_child, judge_cells


@dataclass(frozen=True)
class Bounds:
    """What judging one notebook, and then one answer, may take."""

    seconds: float = 60
    answer_seconds: float = 20
    memory_megabytes: int = 4096


@dataclass(frozen=True)
class Judgement:
    """Verdicts by answer, the answers as short texts, and what is to be said of the notebook itself, in sentences."""

    verdicts: dict
    answers: dict
    remarks: tuple


def judge(exercise, outcome, bounds=Bounds()):
    """The `Judgement` on a sandbox `Outcome` for a pristine exercise (`trajlib.exercises.Exercise`)."""
    names = list(exercise.about["answers"])
    if outcome.ended != "done":
        reason = {"time": "the notebook was still running at its time limit",
                  "died": "the notebook's process was ended before it could hand its answers over (memory, a signal, an exit)"}[outcome.ended]
        return Judgement(dict.fromkeys(names, Verdict(MISSING, f"no answer: {reason}")), {}, (reason,))
    cells = exercise.code("data", "check")
    try:
        return _apart(cells, outcome.handed_over, names, bounds.seconds, bounds.memory_megabytes)
    except (TimeLimit, RuntimeError):
        return _one_by_one(cells, outcome.handed_over, names, bounds)


def _one_by_one(cells, handed_over, names, bounds):
    """Judge each answer alone: one that explodes costs only itself."""
    verdicts, answers, remarks = {}, {}, ()
    for name in names:
        try:
            alone = _apart(cells, handed_over, names, bounds.answer_seconds, bounds.memory_megabytes, only=name)
            verdicts[name], remarks = alone.verdicts[name], alone.remarks
            answers |= alone.answers
        except TimeLimit:
            verdicts[name] = Verdict(UNCHECKED, f"judging this answer took longer than {bounds.answer_seconds:g} s; a lecturer has to look at it")
        except RuntimeError:
            verdicts[name] = Verdict(UNCHECKED, "judging this answer needed more memory than allowed, or failed; a lecturer has to look at it")
    return Judgement(verdicts, answers, remarks)


def _apart(cells, handed_over, names, seconds, megabytes, only=None):
    verdicts, answers, remarks = in_child(_judge, cells, handed_over, names, megabytes, only, timeout=seconds)
    return Judgement({name: Verdict(*verdict) for name, verdict in verdicts.items()}, answers, tuple(remarks))


def _judge(cells, handed_over, names, megabytes, only):
    """In the child: read the bytes strictly, keep the answers asked for, judge."""
    resource.setrlimit(resource.RLIMIT_AS, (megabytes * 2**20, megabytes * 2**20))
    encoded, unreadable, errors = _read(handed_over)
    if only is not None:
        encoded = {name: text for name, text in encoded.items() if name == only}
        unreadable = {name: text for name, text in unreadable.items() if name == only}
    return [judge_cells(cells, encoded, unreadable, names), _described(encoded), errors]


def _described(encoded):
    """The answers as short texts, for the lecturer's eyes."""
    found = {}
    for name, text in encoded.items():
        try:
            found[name] = describe(decode(text.encode()))
        except EncodingError as error:
            found[name] = f"({error})"
    return found


def _read(handed_over):
    """(encoded, unreadable, errors) from a worker's bytes; what is not of this form counts as nothing handed over."""
    try:
        outcome = json.loads(handed_over)
        parts = outcome["encoded"], outcome["unreadable"], outcome["errors"]
        if not (_texts(parts[0].items()) and _texts(parts[1].items()) and all(type(error) is str for error in parts[2])):
            raise ValueError
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return {}, {}, ["what the notebook handed over cannot be read"]
    return parts[0], parts[1], [error[:400] for error in parts[2][:20]]


def _texts(items):
    return all(type(key) is str and type(value) is str for key, value in items)

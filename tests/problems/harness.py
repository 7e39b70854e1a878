"""Solve and judge problems, each in a process of its own, with a record of what is called."""

import statistics
import time
import traceback

from call_recorder import recorded_calls, recording_codes

from workbook.authoring.judged_problem import JudgedProblem, data_of, encoded, worked_answers

#: What `_pace` is on the quiet machine that the limits of verdicts are for.
PACE = 0.155
#: Solvers that an answer and its check must not share.
OURS = ("trajlib.", "workbook.")
SOLVERS = (*OURS, "control", "casadi", "scipy.linalg", "scipy.optimize", "sympy.solvers")
recording_codes(SOLVERS)  # each problem is solved and judged in processes forked from this one


def solve(master):
    """Return the encoded answers of a master and the functions called."""
    data = data_of(master)
    with recorded_calls(SOLVERS, from_answers) as called:
        answers = worked_answers(master, data)
    return {"answers": encoded(answers), "called": sorted(called)}


def first_verdicts(master, answers):
    """Return {name: processor seconds} of the first verdicts, one after the other.

    The seconds are scaled to a quiet machine: where others work beside, the same computation takes
    longer, and so does a known one.
    """
    problem, seconds = JudgedProblem(master, answers), {}
    problem.judge({})  # imports
    before = _slowness()
    for name in answers:
        start = time.process_time()
        problem.judge_one(name, problem.reference[name])
        seconds[name] = time.process_time() - start
    slower = (before + _slowness()) / 2
    return {name: taken / slower for name, taken in seconds.items()}


def _slowness():
    """Return how many times slower than a quiet machine this one computes now, at least 1."""
    return max(1.0, statistics.median([_pace() for _ in range(4)][1:]) / PACE)


def _pace():
    """Return the processor seconds of a computation that is always the same."""
    start = time.process_time()
    table = {(k % 977, str(k)): k * k for k in range(120_000)}
    assert sum(square for (_, digits), square in sorted(table.items()) if digits.endswith("7")) > 0
    return time.process_time() - start


def each_part(master, answers, parts):
    """Return {name: ["done", part(problem)] or ["error", its traceback]}, one after the other.

    What the parts share is computed once.
    """
    problem, results = JudgedProblem(master, answers), {}
    for name, part in parts.items():
        try:
            results[name] = ["done", part(problem)]
        except Exception:
            results[name] = ["error", traceback.format_exc(limit=-5)]
    return results


def from_answers(module, caller):
    """Return whether a call counts: all of ours, and of other solvers from an answer cell."""
    return module.startswith(OURS) or caller.f_code.co_filename == "<answer cell>"


def from_checks(module, caller):
    """Return whether a call counts: all of ours, and of other solvers from a check."""
    return (
        module.startswith(OURS)
        or caller.f_code.co_filename == "<check cell>"
        or caller.f_globals.get("__name__", "").startswith("workbook.checks")
    )

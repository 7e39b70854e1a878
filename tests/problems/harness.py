"""Run a master's cells by role and judge answers, each problem in a process of its own."""

import ast
import functools
import statistics
import time
import traceback

import sympy as sp
from call_recorder import recorded_calls, recording_codes
from forms import each_form

from workbook import checks
from workbook.checks.contract.check_cells import reported_names, with_one_answer
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import encode
from workbook.systems import Controlled

#: What `_pace` is on the quiet machine that the limits of verdicts are for.
PACE = 0.155
#: Solvers that an answer and its check must not share.
OURS = ("trajlib.", "workbook.")
SOLVERS = (*OURS, "control", "casadi", "scipy.linalg", "scipy.optimize", "sympy.solvers")
recording_codes(SOLVERS)  # each problem is solved and judged in processes forked from this one


class JudgedProblem:
    """A master with its data in place, which judges any values of its answers.

    Its own answers come from another process (`solve`), so that nothing is cached yet here of what
    checks compute.
    """

    def __init__(self, master, answers):
        self.master = master
        self.data = data_of(master)
        self.reference = {name: decode(text.encode()) for name, text in answers.items()}
        self.calls = {
            name: call
            for source in master.code("check")
            for name, call in check_calls(source).items()
        }
        self._forms = {}
        self._alone = alone(master)

    def judge(self, answers):
        """Return verdicts on `answers`; those left out are missing."""
        namespace = self.data | dict.fromkeys(self.master.answers, ...) | answers
        with checks.collecting() as verdicts:
            for source in self.master.code("check"):
                execute(source, "check", namespace)
        return verdicts

    def judge_among_right(self, names, answers):
        """Return verdicts on the answers `names`, with the reference for all not in `answers`."""
        with checks.collecting() as verdicts:
            for name in names:
                exec(self._alone[name], self.data | self.reference | answers)
        return verdicts

    def judge_one(self, name, value):
        """Return the verdict on one answer, from its own check cell alone."""
        with checks.collecting() as verdicts:
            exec(self._alone[name], self.data | self.reference | {name: value})
        return verdicts[name]

    def judge_in_homework(self, name, value):
        """Return the verdict of `judge_one` without the direction of a wrong number."""
        with checks.collecting() as verdicts:
            checks.hide_direction()
            exec(self._alone[name], self.data | self.reference | {name: value})
        return verdicts[name]

    def after(self, source):
        """Return the names after a trial, which begins with the data and the reference."""
        namespace = self.data | self.reference
        execute(source, "trial", namespace)
        return namespace

    @functools.cache
    def given(self, role):
        """Return the values that the trials of a role assign to their answers, after the encoder."""
        return [
            decode(encode(self.after(trial.source)[trial.name]))
            for trial in self.master.trials[role]
        ]

    def forms(self, name, value):
        """Return other forms of a value of an answer by their names, cached."""
        key = name, encode(value)
        if key not in self._forms:
            self._forms[key] = dict(self.each_form(name, value))
        return self._forms[key]

    def each_form(self, name, value):
        """Yield the same as pairs, each computed when it is asked for."""
        return each_form(value, self.master.answers[name].kind, self.symbols(name))

    def check_arguments(self, name):
        """Return (function name, data arguments, options) of the check of an answer, evaluated."""
        call = self.calls[name]
        return (
            ast.unparse(call.func).removeprefix("checks."),
            [self._value(arg) for arg in call.args[1:]],
            {k.arg: self._value(k.value) for k in call.keywords},
        )

    def symbols(self, name):
        """Return the only list of symbols in the check's arguments with the answer's, or ()."""
        _, arguments, options = self.check_arguments(name)
        own = getattr(self.reference[name], "free_symbols", set())
        values = [
            value.state if isinstance(value, Controlled) else value
            for value in (*arguments, *options.values())
        ]
        lists = [
            part
            for part in values
            if isinstance(part, (list, tuple))
            and own
            and own <= {symbol for symbol in part if isinstance(symbol, sp.Symbol)}
        ]
        return lists[0] if len(lists) == 1 else ()

    def _value(self, node):
        return eval(compile(ast.Expression(node), "<argument>", "eval"), self.data | self.reference)


def data_of(master):
    data = {"__name__": "exercise"}
    for source in master.code("data"):
        execute(source, "data", data)
    return data


def alone(master):
    """Return the check cell of each answer with its report reduced to this answer, compiled."""
    return {
        name: compile(with_one_answer(source, name), "<check cell>", "exec")
        for source in master.code("check")
        for name in reported_names(source)
    }


def execute(source, role, namespace):
    exec(compile(source, f"<{role} cell>", "exec"), namespace)


def check_calls(source):
    """Return the call that judges each answer in a check cell, by answer.

    The cell ends with `checks.report(name=checks.f(name, ...))`.
    """
    report = ast.parse(source).body[-1].value
    return {keyword.arg: keyword.value for keyword in report.keywords}


def solve(master):
    """Return the encoded answers of a master and the functions called."""
    namespace = data_of(master)
    with recorded_calls(SOLVERS, from_answers) as called:
        for source in master.code("answer"):
            execute(source, "answer", namespace)
    return {
        "answers": {name: encode(namespace[name]).decode() for name in master.answers},
        "called": sorted(called),
    }


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

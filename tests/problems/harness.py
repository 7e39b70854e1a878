"""Runs a master's cells by role and judges answers, each problem in a process of its own."""

import ast
import functools
import statistics
import time
import traceback

import sympy as sp
from calls import calls_noted, codes_that_note
from forms import each_form

from workbook import checks
from workbook.checks.contract.check_cells import reported_names
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import encode
from workbook.systems import Controlled

#: What `_pace` is on the quiet machine that the limits of verdicts are for.
PACE = 0.155
#: Solvers that an answer and its check must not share.
OURS = ("trajlib.", "workbook.")
SOLVERS = (*OURS, "control", "casadi", "scipy.linalg", "scipy.optimize", "sympy.solvers")
codes_that_note(SOLVERS)  # each problem is solved and judged in processes forked from this one


class Workbench:
    """A master with its data in place: judges whatever is put in the place of its answers.

    Its own answers come from another process (`solve`), so that here nothing is known yet of what
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
        """Verdicts on `answers`; those left out are missing."""
        namespace = self.data | dict.fromkeys(self.master.answers, ...) | answers
        with checks.collecting() as verdicts:
            for source in self.master.code("check"):
                execute(source, "check", namespace)
        return verdicts

    def judge_among_right(self, names, answers):
        """Verdicts on the answers `names`, with the reference in the place of all that are not
        among `answers`."""
        with checks.collecting() as verdicts:
            for name in names:
                exec(self._alone[name], self.data | self.reference | answers)
        return verdicts

    def judge_one(self, name, value):
        """The verdict on one answer, from its own check cell alone."""
        with checks.collecting() as verdicts:
            exec(self._alone[name], self.data | self.reference | {name: value})
        return verdicts[name]

    def after(self, source):
        """The names after a trial, which starts from the data and the reference."""
        namespace = self.data | self.reference
        execute(source, "trial", namespace)
        return namespace

    @functools.cache
    def given(self, role):
        """What the trials of a role give their answers, after the encoder."""
        return [
            decode(encode(self.after(trial.source)[trial.name]))
            for trial in self.master.trials[role]
        ]

    def forms(self, name, value):
        """Other forms of a value of an answer by their names: those of the same value once."""
        key = name, encode(value)
        if key not in self._forms:
            self._forms[key] = dict(self.each_form(name, value))
        return self._forms[key]

    def each_form(self, name, value):
        """The same as pairs, each when it is asked for."""
        return each_form(value, self.master.answers[name].kind, self.symbols(name))

    def check_arguments(self, name):
        """(function name, data arguments, options) of the check of an answer, evaluated."""
        call = self.calls[name]
        return (
            ast.unparse(call.func).removeprefix("checks."),
            [self._value(arg) for arg in call.args[1:]],
            {k.arg: self._value(k.value) for k in call.keywords},
        )

    def symbols(self, name):
        """The list of symbols given to the check of an answer that holds those of the answer, if
        there is one alone."""
        _, arguments, options = self.check_arguments(name)
        own = getattr(self.reference[name], "free_symbols", set())
        given = [
            one.state if isinstance(one, Controlled) else one
            for one in (*arguments, *options.values())
        ]
        lists = [
            part
            for part in given
            if isinstance(part, (list, tuple))
            and own
            and own <= {one for one in part if isinstance(one, sp.Symbol)}
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
    """The check cell of each answer with its report reduced to this answer, compiled."""
    return {
        name: compile(_only(source, name), "<check cell>", "exec")
        for source in master.code("check")
        for name in reported_names(source)
    }


def execute(source, role, namespace):
    exec(compile(source, f"<{role} cell>", "exec"), namespace)


def check_calls(source):
    """The call that judges each answer in a check cell, `checks.report(name=checks.f(name, ...))`,
    by answer."""
    report = ast.parse(source).body[-1].value
    return {keyword.arg: keyword.value for keyword in report.keywords}


def solve(master):
    """{"answers": what the answer cells give, encoded, "called": the functions called for it,
    "seconds": of the processor}."""
    namespace = data_of(master)
    with calls_noted(SOLVERS, from_answers) as called:
        for source in master.code("answer"):
            execute(source, "answer", namespace)
    return {
        "answers": {name: encode(namespace[name]).decode() for name in master.answers},
        "called": sorted(called),
        "seconds": time.process_time(),
    }


def first_verdicts(master, answers):
    """{name: seconds of the processor} that the first verdicts on the answers take, one after the
    other, as it would on a quiet machine: where others work beside, the same computation takes
    longer, and so does one that is known."""
    bench, seconds = Workbench(master, answers), {}
    bench.judge({})  # imports
    paces = [_pace() for _ in range(4)][1:]
    for name in answers:
        start = time.process_time()
        bench.judge_one(name, bench.reference[name])
        seconds[name] = time.process_time() - start
    paces += [_pace() for _ in range(3)]
    slower = max(1.0, statistics.median(paces) / PACE)
    return {name: taken / slower for name, taken in seconds.items()}


def _pace():
    """Seconds of the processor that a computation takes which is always the same."""
    start = time.process_time()
    table = {(k % 977, str(k)): k * k for k in range(120_000)}
    assert sum(square for (_, digits), square in sorted(table.items()) if digits.endswith("7")) > 0
    return time.process_time() - start


def each_part(master, answers, parts):
    """{name: ["done", part(bench)] or ["error", its traceback]}, one after the other: what they
    share is computed once.

    Under "seconds" stands the processor time they took together.
    """
    bench, found = Workbench(master, answers), {}
    for name, part in parts.items():
        try:
            found[name] = ["done", part(bench)]
        except Exception:
            found[name] = ["error", traceback.format_exc(limit=-5)]
    return found | {"seconds": ["done", time.process_time()]}


def from_answers(module, caller):
    """All calls of ours are heeded, and those of other solvers from an answer cell."""
    return module.startswith(OURS) or caller.f_code.co_filename == "<answer cell>"


def from_checks(module, caller):
    """The same from a check cell or a check."""
    return (
        module.startswith(OURS)
        or caller.f_code.co_filename == "<check cell>"
        or caller.f_globals.get("__name__", "").startswith("workbook.checks")
    )


def _only(source, name):
    """The check cell with its report reduced to one answer."""
    tree = ast.parse(source)
    report = tree.body[-1].value
    report.keywords = [keyword for keyword in report.keywords if keyword.arg == name]
    return tree

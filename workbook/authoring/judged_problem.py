"""A problem with its data in place, which judges any values of its answers."""

import ast

import sympy as sp

from workbook import checks
from workbook.authoring.forms import each_form
from workbook.checks.contract.check_cells import reported_names, with_one_answer
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import encode
from workbook.systems import Controlled


class JudgedProblem:
    """A master with its data in place, which judges any values of its answers.

    Its own answers come from another process (`worked_answers`), so that nothing is cached yet here
    of what checks compute.

    Parameters
    ----------
    master : Master
        The master; its data cells are run.
    answers : dict of str
        Its worked answers, encoded.
    """

    def __init__(self, master, answers):
        self.master = master
        self.data = data_of(master)
        self.reference = {name: decode(text.encode()) for name, text in answers.items()}
        self.calls = {
            name: call
            for source in master.code("check")
            for name, call in call_nodes(source).items()
        }
        self._forms, self._given = {}, {}
        self._alone = {
            name: compile(with_one_answer(source, name), "<check cell>", "exec")
            for source in master.code("check")
            for name in reported_names(source)
        }

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
        return self.judge_among_right([name], {name: value})[name]

    def after(self, source):
        """Return the names after a trial, which begins with the data and the reference."""
        namespace = self.data | self.reference
        execute(source, "trial", namespace)
        return namespace

    def given(self, role):
        """Return the values that the trials of a role assign to their answers, after the encoder."""
        if role not in self._given:
            self._given[role] = [
                decode(encode(self.after(trial.source)[trial.name]))
                for trial in self.master.trials[role]
            ]
        return self._given[role]

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
    """Return the names after the data cells of a master."""
    data = {"__name__": "exercise"}
    for source in master.code("data"):
        execute(source, "data", data)
    return data


def worked_answers(master, data):
    """Return the worked answers of a master by name, given `data_of` it."""
    namespace = dict(data)
    for source in master.code("answer"):
        execute(source, "answer", namespace)
    return {name: namespace[name] for name in master.answers}


def encoded(answers):
    """Return answers by name, encoded as text."""
    return {name: encode(value).decode() for name, value in answers.items()}


def execute(source, role, namespace):
    """Run a cell of a role in a namespace."""
    exec(compile(source, f"<{role} cell>", "exec"), namespace)


def call_nodes(source):
    """Return the call that judges each answer in a check cell, by answer.

    The cell ends with `checks.report(name=checks.f(name, ...))`.
    """
    report = ast.parse(source).body[-1].value
    return {keyword.arg: keyword.value for keyword in report.keywords}

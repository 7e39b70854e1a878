"""A problem with its data, worked answers and trials, and the verdict on any answer."""

import ast
import re
from difflib import get_close_matches
from functools import cached_property

from workbook.authoring.master import read_master
from workbook.authoring.mistakes import trial_value
from workbook.authoring.statements import assigned_names
from workbook.checks import collecting
from workbook.checks.contract.check_cells import reported_names
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import describe, encode
from workbook.checks.contract.traversal import EncodingError
from workbook.checks.contract.verdict import Unusable
from workbook.live.errors import LiveError
from workbook.live.steps import solution_steps
from workbook.notebooks import exercises


class WorkedProblem:
    """A problem of the checkout; each part is read or computed when it is first used.

    Parameters
    ----------
    number : str
        Number of the problem, such as "1.15".
    """

    def __init__(self, number):
        self.number = number
        self._verdicts = {}

    @cached_property
    def master(self):
        """The master."""
        return read_master(exercises.master_path(self.number))

    @cached_property
    def exercise(self):
        """The pristine exercise."""
        try:
            return exercises.find(self.number)
        except exercises.UnknownExercise as error:
            raise LiveError(error) from None

    @cached_property
    def steps(self):
        """The steps of the worked solution, by answer."""
        return solution_steps(self.master)

    @cached_property
    def data(self):
        """The values of the names in the data cells, by name."""
        return _run(self.exercise.code("data"))

    @cached_property
    def solved(self):
        """The values of the names in the data and answer cells, by name."""
        return _run(
            (role, cell.source)
            for cell in self.master.cells
            for role in [cell.role]
            if role in ("data", "answer")
        )

    def cells_before(self, name):
        """Return the sources of the worked answer cells before the one that assigns an answer."""
        sources = self.master.code("answer")
        index = next(
            k for k, source in enumerate(sources) if name in assigned_names(source, [name])
        )
        return sources[:index]

    def trials(self, name):
        """Return the wrong trials of an answer."""
        return [trial for trial in self.master.trials["wrong"] if trial.name == name]

    def trial_value(self, trial):
        """Return the value that a trial gives to its answer."""
        answers = {name: self.solved[name] for name in self.master.answers}
        return trial_value(trial, self.data | answers)

    def trial_text(self, trial):
        """Return a trial as one may say it: its code, or its value where that uses worked answers."""
        nodes = (node for node in ast.walk(ast.parse(trial.source)) if isinstance(node, ast.Name))
        used = {node.id for node in nodes if isinstance(node.ctx, ast.Load)}
        if not used & set(self.master.answers):
            return trial.source
        value = re.sub(r"\s+", " ", describe(self.trial_value(trial)).replace("[\n", "["))
        return f"{trial.name} = {value}"

    def verdict(self, name, value):
        """Return the verdict of the check cell on a value of an answer."""
        try:
            key = name, "" if value is ... else encode(value)
        except EncodingError as error:
            return self._judged(name, Unusable(str(error)))
        if key not in self._verdicts:
            self._verdicts[key] = self._judged(name, ... if value is ... else decode(key[1]))
        return self._verdicts[key]

    def _judged(self, name, value):
        cell = next(
            source for _, source in self.exercise.code("check") if name in reported_names(source)
        )
        # fresh data for each verdict, in case a check changes an object of them
        names = (
            _run(self.exercise.code("data"))
            | dict.fromkeys(self.exercise.about["answers"], ...)
            | {name: value}
        )
        with collecting() as verdicts:
            exec(compile(cell, "<check cell>", "exec"), names)
        return verdicts[name]


def _run(cells):
    from IPython.utils.capture import capture_output

    names = {"__name__": "lecture"}
    with capture_output():
        for role, source in cells:
            exec(compile(source, f"<{role} cell>", "exec"), names)
    return names


def choose_answer(problems, words):
    """Return the problem and the answer that words such as "1.16 a_region" name.

    Parameters
    ----------
    problems : dict of WorkedProblem
        The problems of the lecture, by number.
    words : str
        An answer, after the number of its problem where several problems have it. The problem may
        also be another one than those of the lecture.

    Returns
    -------
    problem : WorkedProblem
        The problem.
    name : str
        The answer.

    Raises
    ------
    LiveError
        If there is no such answer, or several problems have it.
    """
    *numbers, name = words.split() or [""]
    if len(numbers) > 1:
        raise LiveError(f"one answer at a time, and not {words}")
    if numbers and numbers[0] not in problems:
        try:
            problems = problems | {numbers[0]: WorkedProblem(exercises.find(numbers[0]).number)}
        except exercises.UnknownExercise as error:
            raise LiveError(error) from None
    candidates = [
        problem for number, problem in problems.items() if number in numbers or not numbers
    ]
    matches = [problem for problem in candidates if name in problem.exercise.about["answers"]]
    if len(matches) == 1:
        return matches[0], name
    if matches:
        raise LiveError(
            f"{name} is an answer of {' and of '.join(p.number for p in matches)}; say which: "
            f"{matches[0].number} {name}"
        )
    answers = [answer for problem in candidates for answer in problem.exercise.about["answers"]]
    similar = get_close_matches(name, answers, cutoff=0.4) or answers[:6]
    fault = f"there is no answer {name}" if name else "name an answer"
    raise LiveError(
        f"{fault}; "
        + (f"there is {', '.join(similar)}" if similar else "this lecture has no problem")
    )

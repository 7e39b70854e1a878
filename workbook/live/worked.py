"""A problem with all that is known of it: data, worked answers, trials, and the verdict on any
answer."""

from functools import cached_property

from workbook.live.steps import steps_of
from workbook.live.subjects import LiveError
from workbook.notebooks import exercises


class Worked:
    """One problem of the checkout, read and computed when it is first asked for."""

    def __init__(self, number):
        self.number = number

    @cached_property
    def master(self):
        from workbook.authoring import read
        from workbook.authoring.contract import master_file

        return read(exercises.CHECKOUT / "solutions" / master_file(self.number))

    @cached_property
    def exercise(self):
        try:
            return exercises.find(self.number)
        except exercises.UnknownExercise as error:
            raise LiveError(error) from None

    @cached_property
    def steps(self):
        return steps_of(self.master)

    @cached_property
    def data(self):
        """The names of the data cells; raises `LiveError` for a problem that is not there."""
        return _run(self.exercise.code("data"))

    @cached_property
    def solved(self):
        """The names of data and answer cells."""
        return _run(
            (role, cell.source)
            for cell in self.master.cells
            for role in [cell.role]
            if role in ("data", "answer")
        )

    def before(self, name):
        """Sources of the worked answer cells before the one that assigns the answer `name`."""
        from workbook.authoring.statements import assigned_names

        sources = self.master.code("answer")
        here = next(k for k, source in enumerate(sources) if name in assigned_names(source, [name]))
        return sources[:here]

    def trials(self, name):
        return [trial for trial in self.master.trials["wrong"] if trial.name == name]

    def value_of(self, trial):
        from workbook.authoring.mistakes import value_of

        answers = {name: self.solved[name] for name in self.master.answers}
        return value_of(trial, self.data | answers)

    def verdict(self, name, value):
        """What the check cell says of a value given to the answer `name`."""
        from workbook.checks import collecting
        from workbook.checks.contract.check_cells import reported_names
        from workbook.checks.contract.decoding import decode
        from workbook.checks.contract.encoding import encode
        from workbook.checks.contract.traversal import EncodingError
        from workbook.checks.contract.verdict import Unusable

        try:
            value = ... if value is ... else decode(encode(value))
        except EncodingError as error:
            value = Unusable(str(error))
        cell = next(
            source for _, source in self.exercise.code("check") if name in reported_names(source)
        )
        # what the data cells made is theirs: a check that changed it would spoil the next one
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


def chosen(problems, words):
    """(the `Worked` problem, the answer) that "a_region" or "1.16 a_region" names among `problems`.

    Raises `LiveError` for no name, an unknown one, and one that several of the problems have.
    """
    from difflib import get_close_matches

    *numbers, name = words.split() or [""]
    if len(numbers) > 1:
        raise LiveError(f"one answer at a time, and not {words}")
    if numbers and numbers[0] not in problems:
        try:
            problems = problems | {numbers[0]: Worked(exercises.find(numbers[0]).number)}
        except exercises.UnknownExercise as error:
            raise LiveError(error) from None
    among = {
        number: worked for number, worked in problems.items() if number in numbers or not numbers
    }
    found = [worked for worked in among.values() if name in worked.exercise.about["answers"]]
    if len(found) == 1:
        return found[0], name
    if found:
        raise LiveError(
            f"{name} is an answer of {' and of '.join(w.number for w in found)}; say which: "
            f"{found[0].number} {name}"
        )
    known = [answer for worked in among.values() for answer in worked.exercise.about["answers"]]
    near = get_close_matches(name, known, cutoff=0.4) or known[:6]
    said = f"there is no answer {name}" if name else "name an answer"
    raise LiveError(
        f"{said}; " + (f"there is {', '.join(near)}" if near else "this lecture has no problem")
    )

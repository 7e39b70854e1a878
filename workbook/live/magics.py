"""The magics of a lecture, as an IPython extension.

They are `%answer`, `%catchup`, `%hint`, `%check`, `%mistake`, `%poll`, `%explore` and `%%solution`.

All but the last two are followed by the name of an answer, `a_region`, with its problem where several
problems of the lecture have it, `1.16 a_region`. Whatever fails in a magic ends in one line.

A lecture and the solutions that it shows have names in common, `target` or `n`. The cells of
a solution begin with `%%solution 1.16` there and have the names of that problem only.
"""

import builtins
import itertools
import os
from collections import defaultdict
from contextlib import contextmanager, suppress

import ipywidgets
from IPython.core.error import UsageError
from IPython.core.magic import Magics, cell_magic, line_magic, magics_class, no_var_expand
from IPython.display import Markdown, display
from IPython.utils.capture import capture_output

from workbook.authoring.plain_markdown import plain_markdown
from workbook.authoring.statements import assigned_names
from workbook.checks.contract.report import report
from workbook.checks.contract.reporting import NotYet
from workbook.live import steps
from workbook.live.catch_up import cells_above
from workbook.live.errors import LiveError, error_line
from workbook.live.recordings import Recordings
from workbook.live.worked_problem import WorkedProblem, choose_answer

MAGICS = ("answer", "catchup", "hint", "check", "mistake", "poll", "explore", "solution")


@magics_class
class LectureMagics(Magics):
    """Magics of one lecture; they count what has been shown of each answer."""

    def __init__(self, shell):
        super().__init__(shell)
        self._problems = {
            number: WorkedProblem(number)
            for number in os.environ.get("WORKBOOK_LIVE_PROBLEMS", "").split()
        }
        #: The names of the solutions beside a lecture, by problem; those of a problem that is
        #: presented itself are the lecturer's own.
        is_problem = os.environ.get("WORKBOOK_LIVE_NAME", "") in self._problems
        self._names = None if is_problem else defaultdict(dict)
        self._recordings = None
        self._counts = {}
        self._last_answer = ""
        self._inserted = None

    @no_var_expand
    @line_magic
    def answer(self, line):
        """%answer a_region: one step more of the worked answer; without a name, of the last one."""
        with _errors_in_one_line():
            problem, name = self._choose_answer(line or self._last_answer)
            self._last_answer = f"{problem.number} {name}" if len(self._problems) != 1 else name
            all_steps = problem.steps[name]
            k = self._count("answer", problem, name)
            if k >= len(all_steps):
                raise LiveError(f"that is all of {name}")
            step = all_steps[k]
            if step.kind == steps.TEXT:
                _show_markdown(problem, step.text)
                if k + 1 < len(all_steps):
                    self.shell.set_next_input(f"%answer {self._last_answer}")
            else:
                with self._names_of(problem):
                    self._prepare(problem, name, step.text)
                head = f"%%solution {problem.number}\n" if self._names is not None else ""
                self.shell.set_next_input(head + step.text)
                self._inserted = head + step.text if k + 1 < len(all_steps) else None

    @cell_magic
    def solution(self, line, cell):
        """%%solution 1.16: run a cell of its solution, with the names of that problem."""
        with _errors_in_one_line():
            problem = self._problems.setdefault(line.strip(), WorkedProblem(line.strip()))
            _ = problem.exercise  # raises if there is none
        with self._names_of(problem):
            if not self.shell.run_cell(cell).success:
                self._inserted = None

    @no_var_expand
    @line_magic
    def hint(self, line):
        """%hint a_region: the hints so far, and one more."""
        with _errors_in_one_line():
            problem, name = self._choose_answer(line)
            hints = problem.exercise.about["hints"][name]
            count = min(self._count("hint", problem, name) + 1, len(hints))
            _show_markdown(
                problem,
                "\n\n".join(f"**Hint {k}.** {hint}" for k, hint in enumerate(hints[:count], 1)),
            )

    @no_var_expand
    @line_magic
    def check(self, line):
        """%check a_region = k1 > 0 judges the expression, %check a_region the variable."""
        with _errors_in_one_line():
            name, equals, expression = line.partition("=")
            problem, name = self._choose_answer(name)
            with self._names_of(problem):
                if equals:
                    self._assign(problem, name, expression.strip())
                value = self.shell.user_ns.get(name, ...)
            verdict = problem.verdict(name, value)
            with suppress(NotYet):
                report(**{name: verdict})

    @no_var_expand
    @line_magic
    def mistake(self, line):
        """%mistake a_region: a likely wrong answer with its verdict; another one at each call."""
        from workbook.live.counterexample import counterexample_figure  # Matplotlib, SciPy

        with _errors_in_one_line():
            problem, name = self._choose_answer(line)
            trials = problem.trials(name)
            trial = trials[self._count("mistake", problem, name) % len(trials)]
            value = problem.trial_value(trial)
            display(Markdown(f"What one may say:\n\n```python\n{problem.trial_text(trial)}\n```"))
            with suppress(NotYet):
                report(**{name: problem.verdict(name, value)})
            figure = counterexample_figure(value, problem.solved[name])
            if figure is not None:
                display(figure)

    @no_var_expand
    @line_magic
    def catchup(self, line):
        """%catchup: run the cells above this one; %catchup c_region: all before that answer."""
        with _errors_in_one_line():
            if line.strip():
                problem, name = self._choose_answer(line)
                cells = [
                    *(source for _, source in problem.exercise.code("data")),
                    *problem.cells_before(name),
                ]
            else:
                cells = [cell for cell in cells_above(self.shell) if not is_lecture_magic(cell)]
            self._run_quietly(cells)
            print(f"{len(cells)} cell{'s' * (len(cells) != 1)} run")

    @no_var_expand
    @line_magic
    def poll(self, line):
        """%poll a_region: the right answer among likely wrong ones, for a show of hands.

        Counts may follow, %poll a_region 12 40 3 8.
        """
        from workbook.live.polls import poll  # ipywidgets

        with _errors_in_one_line():
            words = line.split()
            k = next((k for k, word in enumerate(words) if not word[0].isdigit()), len(words))
            problem, name = self._choose_answer(" ".join(words[: k + 1]))
            display(poll(problem, name, words[k + 1 :]))

    @no_var_expand
    @line_magic
    def explore(self, line):
        """%explore phase_portrait 1.4: a picture that follows its sliders; %explore: the list."""
        from workbook.live.explorers import explore, list_explorers  # ipywidgets

        with _errors_in_one_line():
            if line.strip():
                display(explore(line))
            else:
                print(list_explorers())

    def prepare(self, cells):
        """Compute beforehand what cells of a lecture show; return a line for each that fails."""
        self._recordings, failures = Recordings(self.shell), []
        for source in cells:
            try:
                if is_lecture_magic(source):
                    self._prepare_magic(*source.lstrip("%").split(maxsplit=1))
                else:
                    self._run_quietly([source])
            except LiveError as error:
                failures.append(str(error))
        ipywidgets.Widget.close_all()
        _replace(self.shell.user_ns, _own_names(self.shell), {})
        self._names = self._names if self._names is None else defaultdict(dict)
        self._counts, self._recordings = {}, None
        return failures

    def _prepare_magic(self, magic, line):
        if magic == "explore":
            self.explore(line)
            return
        problem, name = self._choose_answer(line)
        _ = problem.solved
        if magic in ("mistake", "poll"):
            for _ in problem.trials(name):
                getattr(self, magic)(line)
        elif magic == "answer":
            with self._names_of(problem):
                for step in problem.steps[name]:
                    if step.kind != steps.TEXT:
                        self._prepare(problem, name, step.text)
                        self._run_quietly([step.text])

    def after_cell(self, result):
        """Insert `%answer` below an inserted cell that has run without an error."""
        run = (result.info.raw_cell or "").strip() if result.info else ""
        if self._inserted and run and run.split("\n")[0] == self._inserted.strip().split("\n")[0]:
            self._inserted = None
            if result.success:
                self.shell.set_next_input(f"%answer {self._last_answer}")

    def _assign(self, problem, name, expression):
        if not expression:
            raise LiveError(f"write what is to be judged: %check {name} = ...")
        if self._names is not None:
            self._run_quietly(source for _, source in problem.exercise.code("data"))
        try:
            self.shell.user_ns[name] = self.shell.ev(expression)
        except Exception as error:
            raise LiveError(
                f"{expression} cannot be computed: {type(error).__name__}: {error}"
            ) from None

    @contextmanager
    def _names_of(self, problem):
        """Put the names of a problem for those of the lecture."""
        names = self.shell.user_ns
        if self._names is None:
            yield
            return
        lecture = _own_names(self.shell)
        _replace(names, lecture, self._names[problem.number])
        try:
            yield
        finally:
            self._names[problem.number] = _own_names(self.shell)
            _replace(names, self._names[problem.number], lecture)

    def _choose_answer(self, words):
        problem, name = choose_answer(self._problems, words)
        self._problems.setdefault(problem.number, problem)
        return problem, name

    def _count(self, magic, problem, name):
        """Return how often a magic was called before with an answer.

        `%answer` counts answers that share their steps together.
        """
        key = magic, problem.number, problem.steps[name] if magic == "answer" else name
        self._counts[key] = self._counts.get(key, -1) + 1
        return self._counts[key]

    def _prepare(self, problem, name, source):
        """Run the imports of the cells before an inserted cell, and the cells if it uses them."""
        before = problem.cells_before(name)
        figures = problem.master.code("figure")
        self._run_quietly([steps.needed_imports([*before, *figures])])
        if missing := self._missing(source) & set(problem.solved):
            self._run_quietly([*(source for _, source in problem.exercise.code("data")), *before])
            print(f"worked out before, and run now: {', '.join(sorted(missing))}")
        # a picture may use a function that an earlier one defines
        for figure in itertools.takewhile(lambda figure: figure != source, figures):
            if assigned_names(figure, self._missing(source)):
                self._run_quietly([figure])

    def _missing(self, source):
        return steps.names_used(source) - set(self.shell.user_ns) - set(dir(builtins))

    def _run_quietly(self, cells):
        for source in cells:
            if self._recordings is not None:
                error = self._recordings.record(source)
            else:
                with capture_output():
                    outcome = self.shell.run_cell(source, store_history=False)
                error = outcome.error_before_exec or outcome.error_in_exec
            if error is not None:
                first = source.strip().split("\n")[0]
                raise LiveError(
                    f"the cell that begins with {first!r} fails: {type(error).__name__}: {error}"
                )


def is_lecture_magic(source):
    """Return whether a cell calls a magic of the lecture, which does something else each time."""
    first = source.strip().partition(" ")[0].partition("\n")[0]
    return first.lstrip("%") in MAGICS and first.startswith("%")


def _own_names(shell):
    """Return what the user of a shell has assigned, by name."""
    return {
        name: value
        for name, value in shell.user_ns.items()
        if not name.startswith("_") and name not in shell.user_ns_hidden
    }


def _replace(names, old, new):
    for name in old:
        del names[name]
    names.update(new)


def _show_markdown(problem, text):
    display(Markdown(plain_markdown(text, number=problem.number)[0]))


@contextmanager
def _errors_in_one_line():
    try:
        yield
    except UsageError:
        raise
    except Exception as error:
        raise UsageError(error_line(error)) from None

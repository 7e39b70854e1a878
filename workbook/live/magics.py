"""The magics of a lecture: `%answer`, `%catchup`, `%hint`, `%check`, `%mistake` and `%poll`, and
`%explore`.

Each but the last names an answer, `a_region`, where a lecture has several problems with its
problem, `1.16 a_region`. What is not understood ends in one line.
"""

import builtins
import os
from contextlib import contextmanager, suppress

from IPython.core.error import UsageError
from IPython.core.magic import Magics, line_magic, magics_class, no_var_expand
from IPython.display import Markdown, display

from workbook.live import steps
from workbook.live.prose import prose
from workbook.live.subjects import LiveError
from workbook.live.worked import Worked, chosen

OURS = ("answer", "catchup", "hint", "check", "mistake", "poll", "explore")


@magics_class
class LectureMagics(Magics):
    """One lecture: what has been shown of each answer so far is known until the kernel ends."""

    def __init__(self, shell):
        super().__init__(shell)
        self._problems = {
            number: Worked(number) for number in os.environ.get("TRAJLIB_LIVE", "").split()
        }
        self._shown = {}
        self._last = ""
        self._handed_out = None

    @no_var_expand
    @line_magic
    def answer(self, line):
        """%answer a_region: one step more of the worked answer; without a name, of the one
        before."""
        with _in_one_line():
            worked, name = self._chosen(line or self._last)
            self._last = f"{worked.number} {name}" if len(self._problems) != 1 else name
            all_steps = worked.steps[name]
            k = self._next("answer", worked, name)
            if k >= len(all_steps):
                raise LiveError(f"that is all of {name}")
            step = all_steps[k]
            if step.kind == steps.IDEA:
                _show_markdown(worked, step.text)
                if k + 1 < len(all_steps):
                    self.shell.set_next_input(f"%answer {self._last}")
            else:
                self._make_ready(worked, name, step.text)
                self.shell.set_next_input(step.text)
                self._handed_out = step.text if k + 1 < len(all_steps) else None

    @no_var_expand
    @line_magic
    def hint(self, line):
        """%hint a_region: the hints so far, and one more."""
        with _in_one_line():
            worked, name = self._chosen(line)
            hints = worked.exercise.about["hints"][name]
            told = min(self._next("hint", worked, name) + 1, len(hints))
            _show_markdown(
                worked,
                "\n\n".join(f"**Hint {k}.** {hint}" for k, hint in enumerate(hints[:told], 1)),
            )

    @no_var_expand
    @line_magic
    def check(self, line):
        """%check a_region = k1 > 0 judges the expression, %check a_region what the variable is."""
        from workbook.checks import NotYet, report

        with _in_one_line():
            name, given, expression = line.partition("=")
            worked, name = self._chosen(name)
            if given:
                if not expression.strip():
                    raise LiveError(f"write what is to be judged: %check {name} = ...")
                try:
                    self.shell.user_ns[name] = self.shell.ev(expression.strip())
                except Exception as error:
                    raise LiveError(
                        f"{expression.strip()} cannot be computed: {type(error).__name__}: {error}"
                    ) from None
            verdict = worked.verdict(name, self.shell.user_ns.get(name, ...))
            with suppress(NotYet):
                report(**{name: verdict})

    @no_var_expand
    @line_magic
    def mistake(self, line):
        """%mistake a_region: what half the class would say, and what speaks against it; one more at
        each call."""
        from workbook.checks import NotYet, report
        from workbook.live.counterexamples import picture

        with _in_one_line():
            worked, name = self._chosen(line)
            trials = worked.trials(name)
            trial = trials[self._next("mistake", worked, name) % len(trials)]
            value = worked.value_of(trial)
            display(Markdown(f"What one may say:\n\n```python\n{trial.source}\n```"))
            with suppress(NotYet):
                report(**{name: worked.verdict(name, value)})
            shown = picture(value, worked.solved[name])
            if shown is not None:
                display(shown)

    @no_var_expand
    @line_magic
    def catchup(self, line):
        """%catchup runs the cells above this one; %catchup c_region what is worked out before that
        answer."""
        from workbook.live.catching_up import cells_above

        with _in_one_line():
            if line.strip():
                worked, name = self._chosen(line)
                cells = [
                    *(source for _, source in worked.exercise.code("data")),
                    *worked.before(name),
                ]
            else:
                cells = [cell for cell in cells_above(self.shell) if not is_ours(cell)]
            self._run_quietly(cells)
            print(f"{len(cells)} cell{'s' * (len(cells) != 1)} run")

    @no_var_expand
    @line_magic
    def poll(self, line):
        """%poll a_region: the right answer among likely wrong ones, for a show of hands; then the
        reveal.

        Counts may follow, %poll a_region 12 40 3 8.
        """
        from workbook.live.polls import poll

        with _in_one_line():
            words = line.split()
            named = next((k for k, word in enumerate(words) if not word[0].isdigit()), len(words))
            worked, name = self._chosen(" ".join(words[: named + 1]))
            display(poll(worked, name, words[named + 1 :]))

    @no_var_expand
    @line_magic
    def explore(self, line):
        """%explore phase_portrait 1.4 shows a picture that follows its sliders; %explore alone
        lists them."""
        from workbook.live.explorers import explore, listed

        with _in_one_line():
            if line.strip():
                display(explore(line))
            else:
                print(listed())

    def after_cell(self, result):
        """When the cell that was handed out has run, the next one asks for the step after it."""
        run = (result.info.raw_cell or "").strip() if result.info else ""
        if (
            self._handed_out
            and run
            and run.split("\n")[0] == self._handed_out.strip().split("\n")[0]
        ):
            self._handed_out = None
            if result.success:
                self.shell.set_next_input(f"%answer {self._last}")

    def _chosen(self, words):
        worked, name = chosen(self._problems, words)
        self._problems.setdefault(worked.number, worked)
        return worked, name

    def _next(self, magic, worked, name):
        """How often a magic has been called with an answer; those worked out in one cell are
        one."""
        key = magic, worked.number, worked.steps[name] if magic == "answer" else name
        self._shown[key] = self._shown.get(key, -1) + 1
        return self._shown[key]

    def _make_ready(self, worked, name, source):
        """Give the cell handed out what it takes from the cells before: their imports, and their
        results if used."""
        before = worked.before(name)
        self._run_quietly([steps.needed_imports([*before, *worked.master.code("figure")])])
        lacking = steps.names_used(source) - set(self.shell.user_ns) - set(dir(builtins))
        if lacking & set(worked.solved):
            self._run_quietly([*(source for _, source in worked.exercise.code("data")), *before])
            print(
                f"worked out before, and run now: {', '.join(sorted(lacking & set(worked.solved)))}"
            )

    def _run_quietly(self, cells):
        from IPython.utils.capture import capture_output

        for source in cells:
            with capture_output():
                outcome = self.shell.run_cell(source, store_history=False)
            error = outcome.error_before_exec or outcome.error_in_exec
            if error is not None:
                first = source.strip().split("\n")[0]
                raise LiveError(
                    f"the cell that begins with {first!r} fails: {type(error).__name__}: {error}"
                )


def is_ours(source):
    """Whether a cell asks for something of this lecture: to run it again would show one step
    more."""
    first = source.strip().partition(" ")[0].partition("\n")[0]
    return first.lstrip("%") in OURS and first.startswith("%")


def _show_markdown(worked, text):
    display(Markdown(prose(text, worked.number)))


@contextmanager
def _in_one_line():
    try:
        yield
    except LiveError as error:
        raise UsageError(str(error)) from None

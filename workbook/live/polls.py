"""Polls: the right answer among those of named mistakes, for a show of hands.

The order of the answers is fixed by a hash and does not depend on which one is right. The lecturer
counts hands, by typing or with the button beside each answer. Only the reveal shows which one is
right, and beside each other one a question to think about.
"""

import html
from dataclasses import dataclass
from hashlib import sha256

import ipywidgets

from trajlib.typesetting import FORMULA, typeset
from workbook.authoring.mistakes import mistake_sentence
from workbook.live.callbacks import ErrorLine
from workbook.live.errors import LiveError

#: At most so many wrong options, of at most so many letters.
WRONG_OPTIONS, MAX_LENGTH = 3, 400
LETTERS = "ABCD"
STYLE = """<style>
.workbook-poll .widget-html-content, .workbook-poll .widget-htmlmath-content {
  font-size: 21px; line-height: 1.5; overflow: visible }
.workbook-poll input, .workbook-poll button { font-size: 19px !important; height: 38px !important; line-height: 38px }
.workbook-bar { height: 26px; min-width: 2px; border-radius: 3px; background: #56B4E9 }
.workbook-right { border-left: 8px solid #009E73; padding-left: 8px }
.workbook-wrong { border-left: 8px dotted #D55E00; padding-left: 8px }
</style>"""


@dataclass(frozen=True)
class Option:
    """An answer of a poll.

    Attributes
    ----------
    text : str
        The answer in HTML with formulas.
    right : bool
        Whether it is right.
    explanation : str
        The sentence on the mistake, if there is one.
    """

    text: str
    right: bool
    explanation: str = ""


def options(problem, name):
    """Return the right answer and up to three wrong ones, in the order in which they are shown.

    Mistakes with a sentence are preferred.

    Raises
    ------
    LiveError
        If there is no wrong answer that is short enough.
    """
    kind = problem.master.answers[name].kind
    right = value_html(problem.solved[name], kind)
    by_text = {right: Option(right, right=True)}
    trials = sorted(
        problem.trials(name), key=lambda trial: mistake_sentence(problem.master, trial) is None
    )
    for trial in trials:
        text = value_html(problem.trial_value(trial), kind)
        if len(by_text) <= WRONG_OPTIONS and len(text) <= MAX_LENGTH and text not in by_text:
            explanation = (mistake_sentence(problem.master, trial) or "").partition("\n")[0]
            by_text[text] = Option(text, right=False, explanation=explanation)
    if len(by_text) == 1:
        raise LiveError(
            f"{name} has no wrong answer that fits on a line; %mistake {name} shows those there are"
        )
    return sorted(
        by_text.values(),
        key=lambda option: sha256(f"{problem.number} {name} {option.text}".encode()).hexdigest(),
    )


def value_html(value, kind=""):
    """Return a value as HTML with formulas between dollars; `kind` is the type of the answer."""
    # when the first answer is shown: a poll opens without SymPy
    import sympy as sp

    from trajlib.stability.regions import latex_condition

    if isinstance(value, (bool, sp.logic.boolalg.BooleanAtom)):
        always, never = ("yes", "no") if kind == "yes/no" else ("always", "never")
        return always if value else never
    if isinstance(value, str):
        return html.escape(value)
    if isinstance(value, sp.logic.boolalg.Boolean):
        return f"${latex_condition(value)}$"
    if isinstance(value, dict):
        return "; ".join(f"{value_html(key)}: {value_html(item)}" for key, item in value.items())
    if isinstance(value, (list, tuple)) and any(
        isinstance(item, (str, bool, dict)) for item in value
    ):
        return ", ".join(map(value_html, value))
    return f"${sp.latex(value)}$"


class Poll(ipywidgets.VBox):
    """Widget with the question and its options; `reveal` shows which one is right.

    Parameters
    ----------
    problem : WorkedProblem
        The problem.
    name : str
        The answer that is asked for.
    counts : sequence of int
        Hands counted before, one number for each option, or none.

    Raises
    ------
    LiveError
        If there are no options, or as many counts are not given.
    """

    def __init__(self, problem, name, counts=()):
        self.options = options(problem, name)
        if len(counts) not in (0, len(self.options)):
            raise LiveError(
                f"there are {len(self.options)} answers here; expected as many counts, not "
                f"{len(counts)}"
            )
        answer = problem.master.answers[name]
        self.error = ErrorLine()
        guard = self.error.guard
        self.counts = [
            ipywidgets.BoundedIntText(count, min=0, max=9999, layout={"width": "90px"})
            for count in counts or [0] * len(self.options)
        ]
        self._bars = [ipywidgets.HTML(layout={"width": "330px"}) for _ in self.options]
        self._explanations = [
            ipywidgets.HTMLMath(layout={"margin": "0 0 10px 46px"}) for _ in self.options
        ]
        self._reveal = ipywidgets.Button(
            description="Reveal", button_style="primary", layout={"width": "140px"}
        )
        self._reveal.on_click(guard(self.reveal))
        rows = []
        for letter, option, count, bar, explanation in zip(
            LETTERS, self.options, self.counts, self._bars, self._explanations
        ):
            hand = ipywidgets.Button(
                description="+1", tooltip=f"one hand more for {letter}", layout={"width": "60px"}
            )
            hand.on_click(guard(lambda _, count=count: setattr(count, "value", count.value + 1)))
            count.observe(guard(lambda _: self._draw()), "value")
            text = ipywidgets.HTMLMath(
                f"<b>{letter}</b>&ensp; {option.text}", layout={"width": "560px"}
            )
            row = ipywidgets.HBox(
                [text, hand, count, bar], layout={"align_items": "center", "flex_flow": "row wrap"}
            )
            rows += [row, explanation]
        question = f"<b>{problem.number}, {name.replace('_', ' ')}.</b> Which one is it? {_text_html(answer.text)}"
        super().__init__(
            [ipywidgets.HTML(STYLE), ipywidgets.HTMLMath(question), *rows, self._reveal, self.error]
        )
        self.add_class("workbook-poll")
        self._draw()

    def reveal(self, _=None):
        """Show which option is right, and the explanations of the others."""
        for option, explanation in zip(self.options, self._explanations):
            explanation.value = (
                '<div class="workbook-right">✓ right</div>'
                if option.right
                else f'<div class="workbook-wrong">✗ {typeset(option.explanation) or "wrong"}</div>'
            )
        self._reveal.disabled = True

    def _draw(self):
        total = sum(count.value for count in self.counts)
        for count, bar in zip(self.counts, self._bars):
            share = count.value / total if total else 0
            bar.value = (
                '<div style="display: flex; gap: 8px; align-items: center"><div '
                'class="workbook-bar" '
                f'style="width: {220 * share:.0f}px"></div>{f"{share:.0%}" if total else ""}</div>'
            )


def poll(problem, name, counts=()):
    """Return the poll on an answer; `counts` are words or numbers, one for each option, or none.

    Raises
    ------
    LiveError
        As `Poll`, and for counts that are no whole numbers.
    """
    try:
        counts = [int(count) for count in counts]
    except ValueError:
        raise LiveError(
            f"counts of hands are whole numbers, not {' '.join(map(str, counts))}"
        ) from None
    return Poll(problem, name, counts)


def _text_html(text):
    """Return a text with formulas and code as HTML."""
    parts, end = [], 0
    for formula in (*FORMULA.finditer(text), None):
        pieces = html.escape(text[end : formula.start() if formula else None]).split("`")
        parts += [f"<code>{piece}</code>" if k % 2 else piece for k, piece in enumerate(pieces)]
        if formula:
            parts.append(html.escape(formula[0], quote=False))
            end = formula.end()
    return "".join(parts)

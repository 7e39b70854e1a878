"""A poll before the reveal: the right answer among those that the named mistakes give, shown of
hands.

The answers stand in an order that is always the same and says nothing. The lecturer counts hands,
by typing or with the button beside each answer; only the reveal tells which one is right, and each
other one what is to be thought over.
"""

import html
from dataclasses import dataclass
from hashlib import sha256

import ipywidgets

from trajlib.typesetting import FORMULA, typeset
from workbook.live.subjects import LiveError

WRONG, LONGEST = 3, 400
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
    """An answer to choose: its text in HTML with formulas, whether it is right, and what its giver
    is told."""

    text: str
    right: bool
    said: str = ""


def options(worked, name):
    """The right answer and up to three wrong ones, as they are shown; raises `LiveError` where
    there is no wrong one.

    Mistakes that have a sentence come before those that have none.
    """
    from workbook.authoring.mistakes import sentence

    kind = worked.master.answers[name].kind
    right = shown(worked.solved[name], kind)
    found = {right: Option(right, right=True)}
    trials = sorted(worked.trials(name), key=lambda trial: sentence(worked.master, trial) is None)
    for trial in trials:
        text = shown(worked.value_of(trial), kind)
        if len(found) <= WRONG and len(text) <= LONGEST and text not in found:
            told = (sentence(worked.master, trial) or "").partition("\n")[0]
            found[text] = Option(text, right=False, said=told)
    if len(found) == 1:
        raise LiveError(
            f"{name} has no wrong answer that fits on a line; %mistake {name} shows those there are"
        )
    return sorted(
        found.values(),
        key=lambda one: sha256(f"{worked.number} {name} {one.text}".encode()).hexdigest(),
    )


def shown(value, kind=""):
    """A value in HTML with formulas between dollars; `kind` is the type of the answer."""
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
        return "; ".join(f"{shown(key)}: {shown(item)}" for key, item in value.items())
    if isinstance(value, (list, tuple)) and any(
        isinstance(item, (str, bool, dict)) for item in value
    ):
        return ", ".join(map(shown, value))
    return f"${sp.latex(value)}$"


class Poll(ipywidgets.VBox):
    """The question with its answers; `reveal` tells which is right."""

    def __init__(self, worked, name, counts=()):
        self.options = options(worked, name)
        if len(counts) not in (0, len(self.options)):
            raise LiveError(
                f"there are {len(self.options)} answers here; expected as many counts, not "
                f"{len(counts)}"
            )
        answer = worked.master.answers[name]
        self.counts = [
            ipywidgets.BoundedIntText(count, min=0, max=9999, layout={"width": "90px"})
            for count in counts or [0] * len(self.options)
        ]
        self._bars = [ipywidgets.HTML(layout={"width": "330px"}) for _ in self.options]
        self._said = [ipywidgets.HTMLMath(layout={"margin": "0 0 10px 46px"}) for _ in self.options]
        self._reveal = ipywidgets.Button(
            description="Reveal", button_style="primary", layout={"width": "140px"}
        )
        self._reveal.on_click(self.reveal)
        rows = []
        for letter, option, count, bar, said in zip(
            LETTERS, self.options, self.counts, self._bars, self._said
        ):
            hand = ipywidgets.Button(
                description="+1", tooltip=f"one hand more for {letter}", layout={"width": "60px"}
            )
            hand.on_click(lambda _, count=count: setattr(count, "value", count.value + 1))
            count.observe(lambda _: self._draw(), "value")
            text = ipywidgets.HTMLMath(
                f"<b>{letter}</b>&ensp; {option.text}", layout={"width": "560px"}
            )
            row = ipywidgets.HBox(
                [text, hand, count, bar], layout={"align_items": "center", "flex_flow": "row wrap"}
            )
            rows += [row, said]
        question = f"<b>{worked.number}, {name.replace('_', ' ')}.</b> Which one is it? {_words(answer.text)}"
        super().__init__(
            [ipywidgets.HTML(STYLE), ipywidgets.HTMLMath(question), *rows, self._reveal]
        )
        self.add_class("workbook-poll")
        self._draw()

    def reveal(self, _=None):
        """Say which answer is right, and to the others what to think over."""
        for option, said in zip(self.options, self._said):
            said.value = (
                '<div class="workbook-right">✓ right</div>'
                if option.right
                else f'<div class="workbook-wrong">✗ {typeset(option.said) or "wrong"}</div>'
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


def poll(worked, name, counts=()):
    """The poll on an answer; `counts` are words or numbers, one for each answer, or none."""
    try:
        counts = [int(count) for count in counts]
    except ValueError:
        raise LiveError(
            f"counts of hands are whole numbers, not {' '.join(map(str, counts))}"
        ) from None
    return Poll(worked, name, counts)


def _words(text):
    """Words with formulas and code, as HTML."""
    parts, end = [], 0
    for formula in (*FORMULA.finditer(text), None):
        pieces = html.escape(text[end : formula.start() if formula else None]).split("`")
        parts += [f"<code>{piece}</code>" if k % 2 else piece for k, piece in enumerate(pieces)]
        if formula:
            parts.append(html.escape(formula[0], quote=False))
            end = formula.end()
    return "".join(parts)

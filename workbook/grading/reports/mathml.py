r"""Formulas on pages: from TeX to MathML, which browsers set without scripts.

It knows what the statements, answers and hints of the workbook write; a formula with anything else
is left in plain characters.

>>> with_formulas(r"where $k_1 \geq 2$")
'where <math alttext="k1 &gt;= 2"><msub><mi>k</mi><mn>1</mn></msub><mo>≥</mo><mn>2</mn></math>'
>>> with_formulas(r"where $\unknown < 2$")
'where unknown &lt; 2'
"""

import re
from functools import cache
from html import escape

from trajlib.typesetting import FORMULA, GREEK, plain

#: Words in a formula, which keep their spaces.
WORDS = re.compile(r"\\(?:operatorname|mathrm|text|mathbf|mathcal)\{([^{}]*)\}")
TOKEN = re.compile(
    WORDS.pattern.replace("([^{}]*)", "[^{}]*")
    + r"|\\begin\{\w+\*?\}|\\end\{\w+\*?\}|\\[A-Za-z]+|\\.|\d+(?:\.\d+)?|\s+|.",
    re.DOTALL,
)
LETTERS = GREEK | {
    "varphi": "φ", "varepsilon": "ε", "vartheta": "ϑ", "varrho": "ϱ", "ell": "ℓ", "infty": "∞",
    "partial": "∂", "top": "⊤", "emptyset": "∅", "hbar": "ħ",
}  # fmt: skip
SIGNS = {
    "leq": "≤", "le": "≤", "geq": "≥", "ge": "≥", "neq": "≠", "ne": "≠", "equiv": "≡", "pm": "±",
    "mp": "∓", "to": "→", "cdot": "⋅", "times": "×", "ldots": "…", "dots": "…", "cdots": "⋯", "in": "∈",
    "notin": "∉", "subset": "⊂", "cup": "∪", "cap": "∩", "int": "∫", "sum": "∑", "prod": "∏",
    "approx": "≈", "sim": "∼", "prime": "′", "mid": "|", "colon": ":", "ll": "≪", "gg": "≫",
    "lvert": "|", "rvert": "|", "lVert": "‖", "rVert": "‖", "|": "‖", "{": "{", "}": "}", "nabla": "∇",
    "langle": "⟨", "rangle": "⟩", "mapsto": "↦", "Rightarrow": "⇒", "perp": "⊥", "vdots": "⋮",
    "ddots": "⋱", "forall": "∀", "exists": "∃", "setminus": "∖", "lfloor": "⌊", "rfloor": "⌋",
    "circ": "∘",
}  # fmt: skip
FUNCTIONS = re.compile(
    "sin|cos|tan|cot|sinh|cosh|tanh|arcsin|arccos|arctan|exp|log|ln|det|max|min|sup|inf|lim|ker|dim|arg"
)
ACCENTS = {"dot": "˙", "ddot": "¨", "dddot": "⃛", "bar": "¯", "tilde": "~", "hat": "^", "vec": "→"}
SPACES = {",": "0.17em", ";": "0.28em", ":": "0.22em", " ": "0.3em", "quad": "1em", "qquad": "2em"}
SPACES |= {"!": "0"}
#: Commands about size and form, which leave no trace.
SKIPPED = {"left", "right", "big", "Big", "bigl", "bigr", "Bigl", "Bigr", "displaystyle", "limits"}
FENCES = {
    "pmatrix": "()",
    "bmatrix": "[]",
    "vmatrix": "||",
    "cases": "{",
    "matrix": "",
    "aligned": "",
}


class UnknownTeXError(ValueError):
    """The formula has something that this module does not know."""


def with_formulas(text):
    """Return text with TeX formulas between dollars as HTML; escapes the rest."""
    parts = FORMULA.split(text)  # every second is a formula
    return "".join(_math(part) if k % 2 else escape(plain(part)) for k, part in enumerate(parts))


@cache
def _math(formula):
    text = escape(plain(f"${formula}$"), quote=True)
    try:
        return f'<math alttext="{text}">{_Parser(formula).row()}</math>'
    except UnknownTeXError:
        return text


class _Parser:
    """A recursive descent through the tokens of a formula."""

    def __init__(self, formula):
        self._tokens = [token for token in TOKEN.findall(formula) if not token.isspace()][::-1]

    def row(self, end=()):
        """Return everything up to one of the tokens `end`, which is left there."""
        parts = []
        while self._tokens and self._tokens[-1] not in end:
            parts.append(self._with_scripts())
        return "".join(parts)

    def _next(self):
        if not self._tokens:
            raise UnknownTeXError
        return self._tokens.pop()

    def _with_scripts(self):
        base, scripts = self._atom(), {}
        while self._tokens and self._tokens[-1] in ("^", "_", "'"):
            token = self._next()
            if token == "'":
                scripts["^"] = scripts.get("^", "") + "<mo>′</mo>"
            else:
                scripts[token] = scripts.get(token, "") + self._argument()
        lower, upper = scripts.get("_"), scripts.get("^")
        upper = f"<mrow>{upper}</mrow>" if upper else None
        if lower and upper:
            return f"<msubsup>{base}{lower}{upper}</msubsup>"
        if lower:
            return f"<msub>{base}{lower}</msub>"
        return f"<msup>{base}{upper}</msup>" if upper else base

    def _argument(self):
        """Return the next group in braces, or else the next atom, as one element."""
        if self._tokens and self._tokens[-1] == "{":
            self._next()
            content = self.row(("}",))
            if self._next() != "}":
                raise UnknownTeXError
            return f"<mrow>{content}</mrow>"
        return self._atom()

    def _atom(self):
        token = self._next()
        if token == "{":
            self._tokens.append(token)
            return self._argument()
        if words := WORDS.fullmatch(token):
            return f'<mi mathvariant="normal">{escape(plain(words[1]))}</mi>'
        if token.startswith("\\begin{"):
            return self._environment(token[7:-1])
        if token.startswith("\\"):
            return self._command(token[1:])
        if token[0].isdigit():
            return f"<mn>{token}</mn>"
        if token.isalpha():
            return f"<mi>{token}</mi>"
        if token in "^_}&$%#~":
            raise UnknownTeXError
        return f"<mo>{'−' if token == '-' else escape(token)}</mo>"

    def _command(self, name):
        if name in LETTERS:
            return f"<mi>{LETTERS[name]}</mi>"
        if name in SIGNS:
            return f"<mo>{SIGNS[name]}</mo>"
        if FUNCTIONS.fullmatch(name):
            return f"<mi>{name}</mi>"
        if name in ACCENTS:
            return f'<mover accent="true">{self._argument()}<mo>{ACCENTS[name]}</mo></mover>'
        if name in SPACES:
            return f'<mspace width="{SPACES[name]}"></mspace>'
        if name in SKIPPED:
            if self._tokens and self._tokens[-1] == ".":
                self._next()
            return ""
        if name in ("frac", "tfrac", "dfrac"):
            return f"<mfrac>{self._fraction_part()}{self._fraction_part()}</mfrac>"
        if name == "sqrt":
            return f"<msqrt>{self._argument()}</msqrt>"
        if name == "overset":
            above = self._argument()
            return f"<mover>{self._argument()}{above}</mover>"
        raise UnknownTeXError

    def _fraction_part(self):
        """Return a part of a fraction, where \\frac12 means two digits."""
        token = self._tokens[-1] if self._tokens else ""
        if token.isdigit() and len(token) > 1:
            self._tokens[-1] = token[1:]
            return f"<mn>{token[0]}</mn>"
        return self._argument()

    def _environment(self, name):
        if name not in FENCES:
            raise UnknownTeXError
        rows, end = [[]], f"\\end{{{name}}}"
        while True:
            rows[-1].append(self.row(("&", "\\\\", end)))
            token = self._next()
            if token == end:
                break
            if token == "\\\\":
                rows.append([])
        body = "".join(
            f"<mtr>{''.join(f'<mtd>{cell}</mtd>' for cell in cells)}</mtr>"
            for cells in rows
            if any(cells)
        )
        fences = [f"<mo>{fence}</mo>" for fence in FENCES[name]] + ["", ""]
        return f"<mrow>{fences[0]}<mtable>{body}</mtable>{fences[1]}</mrow>"

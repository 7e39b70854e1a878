r"""Formulas in text: from TeX to plain characters, and from plain characters to HTML.

>>> plain(r"the roots of $\det(M s^2 + D s + K)$, for $\dot x_1 \leq \sqrt{2}/x_{10}$ and $\varphi_0 \neq 0$")
"the roots of det(M s^2 + D s + K), for x1' <= sqrt(2)/x10 and phi0 != 0"
>>> plain(r"$\psi_x x_1x_2 + r_sv_{x0} = \ldots$")
'psi_x x1 x2 + r_s v_x0 = ...'
>>> plain(r"$K_{xx^2}$ and $r_{\tau}$")
'K_(xx^2) and r_tau'
>>> typeset("at k1 = -2 the root of x**2 + k1*x >= 0 is a_root")
'at <i>k</i><sub>1</sub> = −2 the root of <i>x</i><sup>2</sup> + <i>k</i><sub>1</sub>\u202f<i>x</i> ≥ 0 is a_root'
>>> typeset("A - LH - mu - a case")
'<i>A</i> − <i>LH</i> − μ – a case'
>>> typeset("a 3 x (n + 1) matrix x with x x' = 1")
'a 3 × (<i>n</i> + 1) matrix <i>x</i> with <i>x</i> <i>x</i>′ = 1'
>>> typeset("under it dH/dtheta stays zero")
'under it <i>d</i><i>H</i>/<i>d</i>θ stays zero'
>>> typeset("the bounds are -ubar and omegabar")
'the bounds are −<i>u&#772;</i> and ω&#772;'
>>> typeset("the integral of d/dt(x x')")
'the integral of <i>d</i>/<i>d</i><i>t</i>(<i>x</i> <i>x</i>′)'
>>> typeset("off by 2e-05 m at s = 3 km/s")
'off by 2·10<sup>−5</sup> m at <i>s</i> = 3 km/s'
>>> typeset("write `x1 != 0` for every x1 != 0")
"write <code style='color: inherit; background: none'>x1 != 0</code> for every <i>x</i><sub>1</sub> ≠ 0"
>>> typeset("for psi_x = 1, v_y = 2 and K_xy = 3")
'for ψ<sub><i>x</i></sub> = 1, <i>v</i><sub><i>y</i></sub> = 2 and <i>K</i><sub><i>xy</i></sub> = 3'
"""

import html
import re
from collections.abc import Callable

FORMULA = re.compile(r"\$([^$]+)\$")
SIGNS = {
    "leq": "<=",
    "le": "<=",
    "geq": ">=",
    "neq": "!=",
    "equiv": "==",
    "pm": "+-",
    "to": "->",
    "cdot": "*",
    "dots": "...",
    "ldots": "...",
    "infty": "oo",
    "top": "T",
}
#: In this order: the content of braces is read before what it belongs to.
TYPED = [
    (re.compile(pattern), typed)
    for pattern, typed in [
        (r"(?<=_[A-Za-z\d])(?=\\?[A-Za-z])", " "),
        (r"(\\(?!d{1,3}ot|bar|[lr]vert)[A-Za-z]+)(?=\\[A-Za-z])", r"\1 "),
        (
            r"\\(d{1,3})ot(?![a-z]) ?(\\?[A-Za-z]+(?:_(?:\w|\{\w+\}))?)",
            lambda m: m[2] + "'" * len(m[1]),
        ),
        (r"\\bar ?(\w|\\[A-Za-z]+)", r"\1bar"),
        (r"\\(?:operatorname|mathrm|text)\{([^{}]*)\}", r"\1"),
        (r"_\{(\d+)\}|_(\d)", lambda m: m[1] or m[2]),
        (r"_\{(\\?[A-Za-z]\w*)\}", r"_\1"),
        (r"_\{([^{}]*)\}", r"_(\1)"),
        (r"\\partial ?", "d"),
        (r"\\sqrt\{([^{}]*)\}", r"sqrt(\1)"),
        (r"\^\{(-?\w+)\}", r"^\1"),
        (r"\^\{([^{}]*)\}", r"^(\1)"),
        (r"\^\*", "*"),
        (r"\\frac(\d)(\d)", r"\1/\2"),
        (
            r"\\frac\{([^{}]*)\}\{([^{}]*)\}",
            lambda m: "/".join(_whole(part) for part in m.groups()),
        ),
        (r"\\lvert |\\[lr]vert", "|"),
        (r"\\[,; ]", " "),
        (r"\\(leq?|geq|neq|to|cdot|l?dots|infty|top|pm|equiv)(?![A-Za-z])", lambda m: SIGNS[m[1]]),
        (r"\\var(?=phi|epsilon|rho)|\\(?=[A-Za-z{}])", ""),
        (r"  +", " "),
    ]
]

#: A dark JupyterLab has a dark background for code, and a verdict a light one.
AS_AROUND = "color: inherit; background: none"
SET = {"+/-": "±", "<=": "≤", ">=": "≥", "!=": "≠", "->": "→", "oo": "∞", "-": "−"}
GREEK = dict(
    zip(
        [
            "alpha",
            "beta",
            "gamma",
            "delta",
            "epsilon",
            "zeta",
            "eta",
            "theta",
            "iota",
            "kappa",
            "lambda",
            "mu",
            "nu",
            "xi",
            "pi",
            "rho",
            "sigma",
            "tau",
            "upsilon",
            "phi",
            "chi",
            "psi",
            "omega",
        ],
        "αβγδεζηθικλμνξπρστυφχψω",
    )
)
GREEK |= {name.capitalize(): letter.upper() for name, letter in GREEK.items()}
#: Powers, products and roots in the notation of code.
TYPEWRITTEN = re.compile(r"\*\*|[\w)]\*[A-Za-z(]|\bsqrt\(")
#: Code, and certain formulas in a line of words: letters with numbers, Greek letters, letters
#: beside a sign.
MATHEMATICS = re.compile(
    r"""
    `(?P<code>[^`]+)`
  | \bd(?P<above>[A-Za-z]|%s)?/d(?P<below>[A-Za-z]|%s)(?!\w)
  | (?:\*\*|\^)\s*(?: (?P<power>-?\w+) | \((?P<powers>[^()]+)\) )
  | (?<=\d)e(?P<exponent>[+-]\d+)\b
  | (?<=\d\ )(?P<unit>(?:k?m|s|rad)(?:/s²?)?)(?![\w^*'(/]|\s*[-+=<>])
  | (?<![\w.'"]) (?<!item\ ) (?P<letter>[A-Za-z]|%s)
    (?: _?(?P<index>\d+) | _(?P<name>[A-Za-z]|%s|(?<=[A-Z]_)[a-z]{2}) )? (?P<primes>'*)
    (?! [\w"'] | \.\w | (?<=\b[aAI])(?=\s+\w) )
  | \b(?P<barred>[A-Za-z]|%s)bar\b
  | (?<=[-+]\ ) (?P<product>[A-Z]{2}\b)
  | (?<=[\w)]) (?P<times>\*|\ \*\ ) (?=[\w(])
  | (?P<sign><=|>=|!=|->|\+/-|\boo\b|(?<![\w)])-(?=[\d.]|[A-Za-z]\w?\b|\w+bar\b|\()
      |(?<=\s)-(?=\s(?: [\d(] | (?!a\s)(?:[A-Za-z]|%s)(?:\d+|_\w+)?(?!\w) | [A-Z]{2}\b )))
  | (?<=\ )(?P<dash>-)(?=\ [a-z]+\ )
  | \b(?P<root>sqrt)(?=\()
  | (?:(?<=\b[\dA-Za-z])|(?<=\)))\ (?P<cross>x)\ (?=[\dA-Za-z]\b|\()
"""
    % (6 * ("|".join(sorted(GREEK, key=len, reverse=True)),)),
    re.X,
)


def plain(text: str) -> str:
    """Return a text with its TeX formulas in plain characters, for comments and terminals.

    Parameters
    ----------
    text : str
        Text with TeX formulas between dollars.

    Returns
    -------
    str
    """
    return FORMULA.sub(lambda formula: _typed(formula[1]), text).replace("`", "")


def _whole(part):
    """Return a numerator or denominator, in brackets unless it is a single word."""
    return part if re.fullmatch(r"d?\\?\w+", part) else f"({part})"


def _typed(formula):
    for pattern, replacement in TYPED:
        formula = pattern.sub(replacement, formula)
    return formula.strip()


def typeset(text: str, escape: Callable = html.escape) -> str:
    """Return a text with formulas in plain characters as HTML.

    Powers become superscripts, indices subscripts, names of Greek letters and signs characters.
    Text between backticks is code.

    Parameters
    ----------
    text : str
        Text; it is not read as Python, so it may come from any source.
    escape : callable
        Applied to the words between formulas.

    Returns
    -------
    str
    """
    pieces, end = [], 0
    for match in MATHEMATICS.finditer(text):
        pieces += [escape(text[end : match.start()]), _html(match)]
        end = match.end()
    return "".join([*pieces, escape(text[end:])])


def _letter(name):
    return GREEK.get(name, f"<i>{name}</i>" if name else "")


def _html(match):
    if match["code"]:
        return f"<code style='{AS_AROUND}'>{html.escape(match['code'])}</code>"
    if match["product"]:
        return f"<i>{match['product']}</i>"
    if match["barred"]:
        return (
            f"{GREEK[match['barred']]}&#772;"
            if match["barred"] in GREEK
            else f"<i>{match['barred']}&#772;</i>"
        )
    if match["dash"]:
        return "–"
    if match["power"] or match["powers"]:
        return f"<sup>{typeset(match['power'] or match['powers'])}</sup>"
    if match["unit"]:
        return match["unit"]
    if match["exponent"]:
        return f"·10<sup>{typeset(str(int(match['exponent'])))}</sup>"
    if match["cross"]:
        return " × "
    if match["below"]:
        return "/".join("<i>d</i>" + _letter(match[part]) for part in ("above", "below"))
    if match["letter"]:
        letter, name = (_letter(match[part]) for part in ("letter", "name"))
        lowered = match["index"] or (match["name"] and name)
        return letter + (f"<sub>{lowered}</sub>" if lowered else "") + "′" * len(match["primes"])
    if match["times"]:
        return "·" if match.string[match.end()].isdigit() else "\u202f"
    return "√" if match["root"] else SET[match["sign"]]


def escape_markdown(text: str) -> str:
    """Return text for a notebook's Markdown: x1*x2 keeps its star."""
    return text.replace("*", r"\*").replace("_", r"\_")

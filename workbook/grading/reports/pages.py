"""Parts of HTML pages, each a single file without external resources.

A page runs no script but the one that it is made with, of which it names the hash: so nothing that a
student writes can run.
"""

import base64
import hashlib
from html import escape

#: The colours of the workbook's site; every text has a contrast of at least 4.5 to its background.
STYLE = """
:root { color-scheme: light dark; --ink: #1d2530; --soft: #55606e; --paper: #fff; --card: #fbfaf7; --line: #dcdfe4;
  --accent: #0b6b74;
  --right: #17683a; --wrong: #a3262c; --missing: #6a5a00; --invalid: #74379a; --unchecked: #0f5a86; }
@media (prefers-color-scheme: dark) { :root {
  --ink: #dce1e7; --soft: #9aa6b3; --paper: #13171c; --card: #191f26; --line: #313a45; --accent: #62c6cd;
  --right: #7fd6a0; --wrong: #ff9a94; --missing: #e5cf6b; --invalid: #d3a6f2; --unchecked: #8cc8f0; } }
* { box-sizing: border-box; }
body { font: 1rem/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 50rem;
  margin: 2rem auto; padding: 0 1rem; overflow-wrap: break-word; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0 0 .5rem; }
h2 { font-size: 1.15rem; margin: 2.2rem 0 .5rem; display: flex; gap: 1rem; justify-content: space-between;
  align-items: baseline; }
a { color: var(--accent); } p { margin: .4rem 0; } .soft { color: var(--soft); }
.points { white-space: nowrap; font-weight: 600; }
code { font: .9em ui-monospace, Menlo, Consolas, monospace; overflow-wrap: anywhere; }
.key code { overflow-wrap: normal; }
.answer { background: var(--card); border: 1px solid var(--line); border-left: .3rem solid var(--tone, var(--line));
  border-radius: .3rem; padding: .5rem .8rem; margin: .5rem 0; }
.answer header { display: flex; flex-wrap: wrap; gap: 0 1rem; justify-content: space-between; align-items: baseline; }
.typed, pre { white-space: pre-wrap; } fieldset { border: 1px solid var(--line); margin: .4rem 0; }
.verdict { color: var(--tone); font-weight: 600; } details { margin: .2rem 0; }
summary { color: var(--accent); cursor: pointer; }
.right { --tone: var(--right); } .wrong { --tone: var(--wrong); } .missing { --tone: var(--missing); }
.invalid { --tone: var(--invalid); } .unchecked { --tone: var(--unchecked); }
.wide { overflow-x: auto; } table { border-collapse: collapse; width: 100%; }
td, th { text-align: left; padding: .35rem .8rem .35rem 0; vertical-align: top; border-bottom: 1px solid var(--line); }
.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
svg { max-width: 100%; height: auto; display: block; } svg text { fill: var(--ink); font-size: 12px; }
@media (max-width: 30rem) { svg text { font-size: 21px; } }
.bar { display: flex; min-width: 7rem; height: .8rem; margin-top: .35rem; border-radius: .2rem; overflow: hidden; }
.bar span { background: var(--tone); } ul { padding-left: 1.2rem; margin: .4rem 0; }
@media print { body { margin: 0; max-width: none; } .answer { break-inside: avoid; } }
"""


def page(title, subtitle, body, script="", connects=False, style=STYLE):
    """Return a whole page; `body` is HTML, `script` the only one that it may run.

    `connects` is whether the script may ask the server that the page comes from.
    """
    allowed = f"; script-src {source_hash(script)}" if script else ""
    allowed += "; connect-src 'self'" if connects else ""
    element = f"<script>{script}</script>" if script else ""
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        '<meta http-equiv="Content-Security-Policy" content="default-src \'none\'; style-src '
        f"'unsafe-inline'{allowed}\"><title>{escape(title)}: "
        f"{escape(subtitle)}</title><style>{style}</style></head><body><h1>{escape(title)}<br><span "
        f'class="soft">{person(subtitle)}</span></h1>{body}{element}</body></html>\n'
    )


def source_hash(text):
    """Return how a Content-Security-Policy names a script or style."""
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def table(header, rows):
    """Return a table that scrolls on a narrow screen; `rows` are HTML."""
    if not rows:
        return "<p>None.</p>"
    head = "".join(f"<th>{name}</th>" for name in header)
    return f'<div class="wide"><table><tr>{head}</tr>{"".join(rows)}</table></div>'


def answer_name(problem, answer):
    """Return the table cell with the name of an answer."""
    return f'<td class="key">{escape(problem)} <code>{escape(answer)}</code></td>'


def person(name):
    """Return a name isolated from the text around it, in whatever direction it is written."""
    return f"<bdi>{escape(name)}</bdi>"


def points(value):
    """Return points with at most two decimals.

    >>> points(2.5), points(10.0), points(1 / 3)
    ('2.5', '10', '0.33')
    """
    return f"{value:.2f}".rstrip("0").rstrip(".")


def count(number, noun):
    """Return a number with its noun.

    >>> count(1, "answer"), count(2, "answer")
    ('1 answer', '2 answers')
    """
    return f"{number} {noun}{'s' * (number != 1)}"

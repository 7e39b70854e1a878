r"""Results with their words: `show` is `print` for whoever reads mathematics.

In a notebook and on the site formulas are set, in a terminal they are typed as `print` types them.
What is too long to stand beside words stands on a line of its own, a long sum on several.

>>> import sympy as sp
>>> k1, k2 = sp.symbols("k1 k2")
>>> show("the second minor, for $k_1 > 0$:", k1*k2 - 1)
the second minor, for k1 > 0: k1*k2 - 1

Rows of numbers are a `table`, with a head for each column.
"""

import html
import re

from trajlib.typesetting import FORMULA, plain, typeset
from workbook.jupyter import in_notebook

__all__ = ["show", "table"]

#: What Markdown would take for its own.
MARKUP = re.compile(r"[\\`*_{}\[\]#|~$]")

NUMBER = re.compile(r"[-+]?\.?\d")
#: Rounding leaves a sign before a zero.
MINUS_ZERO = re.compile(r"(?<![\w.)])-(?=0\.0+(?![\d.eE]))")
#: What fits into a line beside words, and into a line of its own, in letters.
BESIDE, LINE = 46, 66
UNSEEN = re.compile(
    r"\\(?:left|right|d?frac|displaystyle|limits|mathrm|operatorname|(?:begin|end)\{\w+\})|[{}_^&\s]"
)


def show(*values):
    """Words and results in a line, with commas between results; in a notebook their formulas are
    set.

    Formulas in words stand between dollars. Results are what they are: SymPy expressions, lists and
    dicts of them, and what the functions of trajlib return.
    """
    values = [MINUS_ZERO.sub("", value) if isinstance(value, str) else value for value in values]
    words = _joined(
        values, [plain(value) if isinstance(value, str) else str(value) for value in values]
    )
    _display(words, lambda: _joined(values, map(_markdown, values)))


def table(heads, rows):
    """Rows of values under heads; numbers keep the digits of their text, `f"{x:.3f}"`.

    >>> table(["$k$", "root"], [[1, "0.50"], [10, "-12.25"]])
     k    root
     1    0.50
    10  -12.25
    """
    heads = [str(head) for head in heads]
    rows = [
        [MINUS_ZERO.sub("", cell) if isinstance(cell, str) else cell for cell in row]
        for row in rows
    ]
    if wrong := [row for row in rows if len(row) != len(heads)]:
        raise ValueError(
            f"rows: expected {len(heads)} values in each, as there are heads, got {wrong[0]}"
        )
    typed = [
        [plain(cell) if isinstance(cell, str) else str(cell) for cell in row]
        for row in (heads, *rows)
    ]
    # numbers end below each other
    ends = [all(NUMBER.match(cell) for cell in column[1:]) for column in zip(*typed)]
    widths = [max(map(len, column)) for column in zip(*typed)]
    lines = (
        "  ".join(
            cell.rjust(width) if end else cell.ljust(width)
            for cell, width, end in zip(row, widths, ends)
        )
        for row in typed
    )
    words = "\n".join(line.rstrip() for line in lines)
    _display(words, lambda: _table([heads, *rows], ends))


def _table(rows, ends):
    heads, *rows = (f"| {' | '.join(map(_cell, row))} |" for row in rows)
    return "\n".join([heads, f"|{'|'.join('---:' if end else ':---' for end in ends)}|", *rows])


def _cell(value):
    """What stands between the bars of a table, which a formula must not hold."""
    return FORMULA.sub(
        lambda formula: formula[0].replace("|", r"\vert "), _markdown(value)
    ).replace("\n", " ")


def _display(words, markdown):
    if not in_notebook():
        print(words)
        return
    from IPython.display import display

    display({"text/plain": words, "text/markdown": markdown()}, raw=True)


def _joined(values, texts):
    """With a space between, but before a sign that ends or divides, and a comma between two
    results: side by side they would read as a product."""
    joined, result = "", False
    for value, text in zip(values, texts):
        if not (isinstance(value, str) and value[:1] in (",", ".", ";", ":", ")")) and joined:
            # what stands on lines of its own needs no comma
            joined += (
                ", " if result and not isinstance(value, str) and not joined.endswith("\n") else " "
            )
        joined, result = joined + text, not isinstance(value, str)
    return joined


def _markdown(value):
    value = _read(value)
    if isinstance(value, str):
        parts = re.split(r"(\$[^$]+\$)", value)
        return "".join(
            part if FORMULA.fullmatch(part) else typeset(part, _escaped) for part in parts
        )
    if isinstance(value, dict) and value:
        return ", ".join(f"{_markdown(key)}: {_markdown(item)}" for key, item in value.items())
    if _is_formula(value):
        latex = _latex(value)
        if isinstance(value, (list, tuple)) and _letters(latex) > BESIDE:
            return ", ".join(map(_markdown, value))
        return _set(latex, lambda: _on_lines(value))
    for form in ("_repr_markdown_", "_repr_latex_"):
        if hasattr(value, form):
            text = getattr(value, form)()
            inner = re.fullmatch(r"\$(?:\\displaystyle)?([^$]+)\$", text)
            return _set(inner[1].strip()) if inner else f"\n\n{text}\n\n" if "\n" in text else text
    if type(value) in (list, tuple) and value:
        listed = ", ".join(map(_markdown, value))
        return listed if all(isinstance(item, str) for item in value) else f"({listed})"
    # A text that was broken into lines for a terminal flows again.
    return _markdown(re.sub(r"\n +", " ", str(value)))


def _read(value):
    """Without what no reader wants: the comma after the only entry of a tuple, and digits of
    decimals beyond eight. Arrays and lists of rows are matrices."""
    if type(value).__module__ == "numpy":
        value = value.tolist()
    if type(value) in (list, tuple):
        entries = [_read(entry) for entry in value]
        if (
            type(value) is list
            and all(type(row) is list for row in entries)
            and _is_matrix(entries)
        ):
            import sympy as sp

            return sp.Matrix(entries)
        return entries[0] if type(value) is tuple and len(entries) == 1 else type(value)(entries)
    if isinstance(value, float):
        return float(f"{value:.8g}") + 0.0
    if isinstance(value, complex):
        import sympy as sp

        real, imaginary = (sp.sympify(f"{part:.8g}") for part in (value.real, value.imag))
        return real + sp.I * imaginary
    if hasattr(value, "xreplace"):
        import sympy as sp

        return value.xreplace(
            {
                number: sp.Float(f"{float(number):.8g}")
                for number in value.atoms(sp.Float)
                if len(str(number)) > 9
            }
        )
    return value


def _is_matrix(rows):
    """Whether these are lists of numbers and expressions, all of a length."""
    import sympy as sp

    return len(set(map(len, rows))) == 1 and all(
        isinstance(entry, (sp.Expr, int, float, complex)) for row in rows for entry in row
    )


def _is_formula(value):
    import sympy as sp

    if isinstance(value, (list, tuple)):
        return len(value) > 0 and all(map(_is_formula, value))
    return isinstance(value, (sp.Basic, sp.MatrixBase, int, float, complex)) and not isinstance(
        value, bool
    )


def _latex(value):
    """With the functions and letters as the book writes them."""
    import sympy as sp

    return re.sub(
        r"\\(phi|epsilon)(?![a-z])",
        r"\\var\1",
        sp.latex(value, inv_trig_style="full", ln_notation=True),
    )


def _set(latex, on_lines=None):
    """A formula beside words where it fits there, else on a line of its own or on several."""
    count = _letters(latex)
    if count <= BESIDE:
        return f"${latex}$"
    return f"\n\n$$\n{on_lines() if on_lines and count > LINE else latex}\n$$\n\n"


def _letters(latex):
    return len(re.sub(r"\\[A-Za-z]+|\\.", "x", UNSEEN.sub("", latex)))


def _on_lines(value):
    """A sum, or an equation with one on its right, broken between its terms."""
    import sympy as sp

    left, total = (
        (f"{_latex(value.lhs)} ={{}}", value.rhs) if isinstance(value, sp.Eq) else ("", value)
    )
    if not isinstance(total, sp.Add):
        return _latex(value)
    lines = [""]
    for term in total.as_ordered_terms():
        latex = _latex(term)
        latex = latex if latex.startswith("-") or lines == [""] else "+ " + latex
        if _letters(lines[-1] + latex) > LINE and lines[-1]:
            lines.append("")
        lines[-1] += latex + " "
    return rf"\begin{{aligned}} {left} & " + r"\\ & ".join(lines) + r"\end{aligned}"


def _escaped(text):
    return (
        MARKUP.sub(r"\\\g<0>", html.escape(text, quote=False))
        .replace("  ", "\u2003")
        .replace("\n", "\\\n")
    )

r"""Show results with texts: `show` is `print` with typeset formulas in notebooks.

In a notebook and on the site formulas are typeset; in a terminal they are printed as text. A
formula that is too long to stand beside words is displayed on a line of its own, a long sum on
several.

>>> import sympy as sp
>>> k1, k2 = sp.symbols("k1 k2")
>>> show("the second minor, for $k_1 > 0$:", k1*k2 - 1)
the second minor, for k1 > 0: k1*k2 - 1

Rows of numbers are shown by `table`.
"""

import html
import re

from trajlib.typesetting import FORMULA, plain, typeset
from workbook.jupyter import runs_in_notebook

__all__ = ["show", "table"]

#: Characters with a meaning in Markdown.
MARKUP = re.compile(r"[\\`*_{}\[\]#|~$]")

NUMBER = re.compile(r"[-+]?\.?\d")
#: The sign of a zero that is left by rounding.
MINUS_ZERO = re.compile(r"(?<![\w.)])-(?=0\.0+(?![\d.eE]))")
#: Letters of a formula that fit beside words, and into a line of its own.
INLINE, LINE = 46, 66
INVISIBLE = re.compile(
    r"\\(?:left|right|d?frac|displaystyle|limits|mathrm|operatorname|(?:begin|end)\{\w+\})|[{}_^&\s]"
)


def show(*values):
    """Show texts and results in a line, with commas between neighbouring results.

    Parameters
    ----------
    *values
        Texts (str), in which formulas stand between dollars, and results: SymPy expressions,
        numbers, arrays, lists and dicts of them, and results of trajlib's functions.

    Examples
    --------
    >>> show("the roots of $s^2 - 1$:", [1, -1])
    the roots of s^2 - 1: [1, -1]
    """
    values = [MINUS_ZERO.sub("", value) if isinstance(value, str) else value for value in values]
    text = _join(
        values, [plain(value) if isinstance(value, str) else str(value) for value in values]
    )
    _display(text, lambda: _join(values, map(_markdown, values)))


def table(heads, rows):
    """Show rows of values as a table.

    Parameters
    ----------
    heads : sequence of str
        Heads of the n columns; formulas stand between dollars.
    rows : sequence of sequence, shape (m, n)
        The values; numbers as texts keep their digits, ``f"{x:.3f}"``.

    Raises
    ------
    ValueError
        If a row has not as many values as there are heads.

    Examples
    --------
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
    texts = [
        [plain(cell) if isinstance(cell, str) else str(cell) for cell in row]
        for row in (heads, *rows)
    ]
    is_numeric = [all(NUMBER.match(cell) for cell in column[1:]) for column in zip(*texts)]
    widths = [max(map(len, column)) for column in zip(*texts)]
    lines = (
        "  ".join(
            cell.rjust(width) if numeric else cell.ljust(width)
            for cell, width, numeric in zip(row, widths, is_numeric)
        )
        for row in texts
    )
    text = "\n".join(line.rstrip() for line in lines)
    _display(text, lambda: _table([heads, *rows], is_numeric))


def _table(rows, is_numeric):
    heads, *rows = (f"| {' | '.join(map(_cell, row))} |" for row in rows)
    return "\n".join(
        [heads, f"|{'|'.join('---:' if numeric else ':---' for numeric in is_numeric)}|", *rows]
    )


def _cell(value):
    """Return the Markdown of a table cell; bars in formulas would end the cell."""
    return FORMULA.sub(
        lambda formula: formula[0].replace("|", r"\vert "), _markdown(value)
    ).replace("\n", " ")


def _display(text, markdown):
    if not runs_in_notebook():
        print(text)
        return
    from IPython.display import display

    display({"text/plain": text, "text/markdown": markdown()}, raw=True)


def _join(values, texts):
    """Join texts with spaces, and commas between results, which would read as a product.

    There is no space before punctuation.
    """
    joined, after_result = "", False
    for value, text in zip(values, texts):
        if not (isinstance(value, str) and value[:1] in (",", ".", ";", ":", ")")) and joined:
            # no comma after a formula on lines of its own
            joined += (
                ", "
                if after_result and not isinstance(value, str) and not joined.endswith("\n")
                else " "
            )
        joined, after_result = joined + text, not isinstance(value, str)
    return joined


def _markdown(value):
    value = _simplify(value)
    if isinstance(value, str):
        parts = re.split(r"(\$[^$]+\$)", value)
        return "".join(
            part if FORMULA.fullmatch(part) else typeset(part, _escape) for part in parts
        )
    if isinstance(value, dict) and value:
        return ", ".join(f"{_markdown(key)}: {_markdown(item)}" for key, item in value.items())
    if _is_formula(value):
        latex = _latex(value)
        if isinstance(value, (list, tuple)) and _letters(latex) > INLINE:
            return ", ".join(map(_markdown, value))
        return _formula(latex, lambda: _on_lines(value))
    for form in ("_repr_markdown_", "_repr_latex_"):
        if hasattr(value, form):
            text = getattr(value, form)()
            inner = re.fullmatch(r"\$(?:\\displaystyle)?([^$]+)\$", text)
            return (
                _formula(inner[1].strip()) if inner else f"\n\n{text}\n\n" if "\n" in text else text
            )
    if type(value) in (list, tuple) and value:
        listed = ", ".join(map(_markdown, value))
        return listed if all(isinstance(item, str) for item in value) else f"({listed})"
    # a text may be broken into lines for a terminal
    return _markdown(re.sub(r"\n +", " ", str(value)))


def _simplify(value):
    """Return a value with at most eight digits, a 1-tuple as its entry, and arrays as matrices."""
    if type(value).__module__ == "numpy":
        value = value.tolist()
    if type(value) in (list, tuple):
        entries = [_simplify(entry) for entry in value]
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
    """Return whether rows are lists of numbers and expressions of equal length."""
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
    """Return LaTeX with the functions and letters of the book."""
    import sympy as sp

    return re.sub(
        r"\\(phi|epsilon)(?![a-z])",
        r"\\var\1",
        sp.latex(value, inv_trig_style="full", ln_notation=True),
    )


def _formula(latex, on_lines=None):
    """Return a formula beside words if it fits, else on a line of its own or on several."""
    count = _letters(latex)
    if count <= INLINE:
        return f"${latex}$"
    return f"\n\n$$\n{on_lines() if on_lines and count > LINE else latex}\n$$\n\n"


def _letters(latex):
    return len(re.sub(r"\\[A-Za-z]+|\\.", "x", INVISIBLE.sub("", latex)))


def _on_lines(value):
    """Return the LaTeX of a sum, or of an equation with one on its right, broken between terms."""
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


def _escape(text):
    return (
        MARKUP.sub(r"\\\g<0>", html.escape(text, quote=False))
        .replace("  ", "\u2003")
        .replace("\n", "\\\n")
    )

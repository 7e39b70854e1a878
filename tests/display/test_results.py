"""Results in a notebook and in a terminal: formulas, texts and line breaks."""

import re
import sys
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from IPython import display

from trajlib.structure import observability
from trajlib.typesetting import typeset
from workbook.display import results
from workbook.display.results import LINE, show, table

k1, x, psi2 = sp.symbols("k1 x psi2")


@pytest.fixture
def shown(monkeypatch):
    """What a notebook shows of values, or of a table: its Markdown and its plain text."""
    displayed = []
    monkeypatch.setitem(
        sys.modules,
        "IPython",
        SimpleNamespace(get_ipython=lambda: SimpleNamespace(kernel=True), display=display),
    )
    monkeypatch.setattr(display, "display", lambda data, raw: displayed.append(data))

    def of(*values, by=show):
        by(*values)
        return SimpleNamespace(
            set=displayed[-1]["text/markdown"], typed=displayed[-1]["text/plain"]
        )

    return of


def test_results_in_a_terminal(capsys):
    show("on $k_1 = 0$:", x**2 / k1, [k1, 2], {k1: 1}, 0.5)
    assert capsys.readouterr().out == "on k1 = 0: x**2/k1, [k1, 2], {k1: 1}, 0.5\n"


def test_a_table_in_a_notebook(shown):
    expected = shown(
        [r"$|\lambda|$", "kind", "of it"],
        [["0.50", "x1 | x2", k1 / 2], [f"{-1e-9:.1f}", "-", 2]],
        by=table,
    )
    assert expected.set.splitlines() == [
        r"| $\vert \lambda\vert $ | kind | of it |",
        "|---:|:---|:---|",
        r"| 0.50 | <i>x</i><sub>1</sub> \| <i>x</i><sub>2</sub> | $\frac{k_{1}}{2}$ |",
        "| 0.0 | - | $2$ |",
    ]
    assert expected.typed.splitlines() == [
        "|lambda|  kind     of it",
        "    0.50  x1 | x2  k1/2",
        "     0.0  -        2",
    ]


def test_a_table_has_a_head_for_each_column():
    with pytest.raises(
        ValueError, match="expected 1 values in each, as there are heads, got .1, 2."
    ):
        table(["$k$"], [[1, 2]])


def test_no_zero_has_a_sign(shown):
    expected = shown(f"at $T$: {-1e-9:.4f}, {-0.04:.2f}, {-1e-9:.1e}, 1-0.0")
    assert (
        expected.typed == "at T: 0.0000, -0.04, -1.0e-09, 1-0.0" and "−0.0000" not in expected.set
    )


@pytest.mark.parametrize(
    "value, expected",
    [
        (x**2 / k1, r"$\frac{x^{2}}{k_{1}}$"),
        ([k1, sp.Rational(1, 2)], r"$\left[ k_{1}, \  \frac{1}{2}\right]$"),
        ({k1: 2, "type": x**2}, "$k_{1}$: $2$, type: $x^{2}$"),
        (sp.And(x > 0, k1 < 1), r"$x > 0 \wedge k_{1} < 1$"),
        (["stable focus", "u+"], "stable focus, <i>u</i>+"),
        ([(k1 > 0, "stable node")], "(($k_{1} > 0$, stable node))"),
        (0.5, "$0.5$"),
        (2.5000000000000018, "$2.5$"),
        (1.01668673480049e-11, r"$1.0166867 \cdot 10^{-11}$"),
        ([sp.Float(2) / 9 * x], r"$\left[ 0.22222222 x\right]$"),
        (sp.Rational(1, 3).evalf(4), "$0.3333$"),
        ([-0.5 + 1.5130000001j, 2 - 1j], r"$\left[ -0.5 + 1.513 i, \  2 - i\right]$"),
        (sp.symbols("phi epsilon_1"), r"$\left( \varphi, \  \varepsilon_{1}\right)$"),
        (sp.asin(x) + sp.log(x), r"$\ln{\left(x \right)} + \arcsin{\left(x \right)}$"),
        ((psi2,), r"$\psi_{2}$"),
        ([(x, 1.0), (k1,)], r"$\left[ \left( x, \  1.0\right), \  k_{1}\right]$"),
        ((("u+", 0.0, 0.24999999999999986),), "(<i>u</i>+, $0.0$, $0.25$)"),
        (
            np.array([[1, -0.0], [1 / 3, 2]]),
            r"$\left[\begin{matrix}1.0 & 0.0\\0.33333333 & 2.0\end{matrix}\right]$",
        ),
        (np.array([1.5, 2]), r"$\left[ 1.5, \  2.0\right]$"),
        ([[0, x], [1, 2]], r"$\left[\begin{matrix}0 & x\\1 & 2\end{matrix}\right]$"),
        ([[0, 1], [2]], r"$\left[ \left[ 0, \  1\right], \  \left[ 2\right]\right]$"),
        (np.bool_(True), "True"),
        (True, "True"),
        (
            "  at $k_1 = 0$, a_region [x](y) <b>",
            "\u2003at $k_1 = 0$, a\\_region \\[<i>x</i>\\](<i>y</i>) &lt;<i>b</i>&gt;",
        ),
        ("x**()", r"<i>x</i>\*\*()"),
        ("det = k1**2 - x/psi2", "det = <i>k</i><sub>1</sub><sup>2</sup> − <i>x</i>/ψ<sub>2</sub>"),
    ],
)
def test_results_in_a_notebook(shown, value, expected):
    assert shown(value).set == expected
    assert "**" not in expected


def test_commas_separate_results(shown):
    assert shown("both:", x, k1, "and", 2, ";", k1).set == "both: $x$, $k_{1}$ and $2$; $k_{1}$"
    wide = sp.expand((x + k1) ** 9)
    assert "$$\n\n $x$" in shown(wide, x).set and ",\n\n$$" not in shown(wide, x).set


def test_results_of_the_library_use_their_own_form(shown):
    result = observability(sp.Matrix([[0, 1], [0, 0]]), sp.Matrix([[1, 0]]))
    assert shown("seen:", result).set == f"seen: {result._repr_markdown_()}"


def test_a_long_sum_is_broken_between_its_terms(shown):
    total = sp.expand((x + k1 + psi2) ** 6)
    text = shown(sp.Eq(x, total, evaluate=False)).set
    lines = re.search(r"\$\$\n\\begin\{aligned\} (.*)\\end\{aligned\}\n\$\$", text, re.S)[1].split(
        r"\\"
    )
    assert len(lines) > 2 and max(map(results._letters, lines)) <= LINE + 8
    assert lines[0].startswith("x ={} & ")
    terms = sum(
        len(re.findall(r"(?:^|[+-]) ?\S", line.partition("&")[2].strip())) for line in lines
    )
    assert terms == len(total.args)


def test_a_long_list_may_break_at_its_commas(shown):
    assert shown([sp.expand((x + k1) ** 3)] * 3).set.count("$, $") == 2


@given(st.text(alphabet="ab1k_*^'\"<>&()-= \\$|[]`", max_size=40))
def test_html_in_texts_is_escaped(text):
    without = re.sub(r"</?(?:i|sub|sup|code)>|<code style='[a-z:; ]*'>", "", typeset(text))
    assert "<" not in without and ">" not in without


@pytest.mark.parametrize(
    "words",
    [
        "a motion of the equation",
        "non-zero, well-posed",
        "item a and items",
        "the a_region",
        "Ackermann's rule",
        "a 3-vector",
        '"k1" is a name',
        "sp.And(x.y)",
    ],
)
def test_words_are_no_formulas(words):
    assert typeset(words, escape=str) == words

"""Interactive figures: the declaration, its values in Python, the HTML and the errors."""

import json
import re

import numpy as np
import pytest
import sympy as sp
from bs4 import BeautifulSoup

from workbook.display import Explorer
from workbook.display.explorer.evaluation import evaluate
from workbook.display.explorer.formulas import Formula
from workbook.display.explorer.page import asset

X, V, K, C, S, N, W, T = sp.symbols("x v k c s n w t", real=True)
RE, IM = sp.symbols("Re Im", real=True)


def figure():
    """A figure with a parameter that is dragged and one with a slider, and every kind of step."""
    figure = Explorer("Does <it> move?", "A description.")
    figure.parameter(X, 1, (-2, 2))
    figure.parameter(K, 4, (1, 9), label="stiffness")
    figure.quantity(C, sp.sqrt(K))
    motion = figure.trajectory([X, V], [V, -K * X], [X, 0], 1.5)
    motion.last(S, X)
    figure.recursion([W], [W / 2 + N], [K], 3, data={V: [0, 1, 2, 3]})
    figure.roots(S**0 * K + W**2, W)
    figure.table({N: [0, 1], W: [2, 3]})
    plane = figure.panel(X, "v", (-2, 2), (-4, 4))
    plane.region(X**2 < K, "inside")
    plane.field(sp.Symbol("v"), -K * X)
    plane.line(motion, X, V, "dashed")
    plane.point(X, 0, "initial state")
    figure.panel("Re", "Im", (-1, 1), (-4, 4), 0.5, below=True).marks(figure.series[2], RE, IM)
    figure.sentence((K < 2, "slow"), (True, "x = {x} and the end is {s}"))
    return figure


def test_values_are_those_of_the_closed_forms():
    values = evaluate(figure(), {"k": 2.25})
    assert values.scalars[:3] == [1, 2.25, 1.5]
    motion, filtered, roots, table = values.series
    assert np.allclose(motion[1], np.cos(1.5 * motion[0]), atol=1e-9)
    assert values.scalars[3] == pytest.approx(np.cos(2.25), abs=1e-9)
    assert filtered.tolist() == [
        [0, 1, 2, 3],
        [2.25, 2.125, 3.0625, 4.53125],
        [0, 1, 2, 3],
    ]
    assert sorted(roots[1]) == pytest.approx([-1.5, 1.5]) and table.tolist() == [[0, 1], [2, 3]]


def test_first_values_are_set_by_name():
    changed = figure()
    changed.set(k="2.25", x=0.5)
    assert (
        evaluate(changed).scalars[:2]
        == [0.5, 2.25]
        == evaluate(figure(), {"x": 0.5, "k": 2.25}).scalars[:2]
    )


def test_the_page_holds_the_declaration_the_question_and_a_picture():
    page = BeautifulSoup(figure()._repr_html_(), "html.parser")
    box = page.find(class_="explorer")
    data = json.loads(box["data-explorer"])
    assert box.find(class_="explorer-question").text == "Does <it> move?"
    assert box.img["alt"] == "A description." and box.img["src"].startswith("data:image/svg+xml")
    sliders = [(parameter["label"], parameter["slider"]) for parameter in data["parameters"]]
    assert sliders == [("x", False), ("stiffness", True)]
    region, field, line, point = data["panels"][0]["parts"]
    # only what depends on a parameter is computed anew
    assert [part["uses"] for part in (region, field, line, point)] == [[1], [1], [0, 1], [0]]
    assert region["condition"] == "[Math.pow(c[0], 2) < v[1]]" and point["moved"] == [0, None]
    assert page.script.text == asset("explorer.js") and "</" not in asset("explorer.js")
    assert figure()._repr_html_() == figure()._repr_html_()


def test_the_sentence_has_its_numbers():
    explorer = figure()
    assert explorer.sentences[0].text([1, 1.5, 0, 0]) == "slow"
    assert explorer.sentences[0].text([-0.12345, 4, 0, 1234.5]) == "x = −0.123 and the end is 1230"


def test_a_static_picture_has_every_panel():
    picture = figure().plot(k=2)
    assert [len(ax.lines) + len(ax.collections) for ax in picture.axes] == [5, 1]


@pytest.mark.parametrize(
    "value, expected",
    [
        (sp.Piecewise((X, X > 1), (sp.Abs(K) ** sp.Rational(1, 3), True)), 2),
        (sp.And(X > 0, sp.Or(K < 1, sp.Not(X > K))), True),
        (sp.Max(X, K, 0) + sp.sign(X) * sp.atan2(K, X) + sp.pi, 8 + np.arctan(8) + np.pi),
        (3 - 2 * sp.Mod(X - K, 3), -1),
        (sp.true, True),
    ],
)
def test_formulas_are_written_on_one_line(value, expected):
    formula = Formula("value", value, [X, K])
    assert "\n" not in formula.javascript and not re.search(r"\b[xk]\b", formula.javascript)
    assert formula([1.0, 8.0]) == pytest.approx(expected)


def explorer():
    explorer = Explorer("q", "d")
    explorer.parameter(X, 0, (-1, 1))
    return explorer


def panel():
    return explorer().panel("a", "b", (0, 1), (0, 1))


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: explorer().parameter(X, 0, (-1, 1)), "symbol: x has a value already"),
        (lambda: explorer().parameter("k", 0, (-1, 1)), "symbol: expected a symbol"),
        (lambda: explorer().parameter(K, 2, (-1, 1)), "k: expected a number from -1 to 1, got 2"),
        (lambda: explorer().parameter(K, 1, (1, 1)), "limits: expected"),
        (lambda: figure().set(k=10), "k: expected a number from 1 to 9, got 10"),
        (lambda: figure().set(q=1), "there is no parameter q; there is x, k"),
        (lambda: figure().set(k="much"), "k: expected a number, got much"),
        (lambda: explorer().parameter(K, 1, (0, 1), step=0), "step: expected a positive number"),
        (lambda: explorer().parameter(K, 1, (0, 1), play=-1), "play: expected a positive number"),
        (lambda: explorer().quantity(C, X + K), "value: k is neither a parameter nor a quantity"),
        (lambda: explorer().quantity(C, sp.erf(X)), "value: JavaScript has no function"),
        (lambda: explorer().quantity(C, "x"), "value: expected an expression of SymPy"),
        (lambda: explorer().trajectory([V], [V], [X, X], 1), "rates, initial: expected one"),
        (lambda: explorer().trajectory([V], [K], [X], 1), "rates: k is neither"),
        (lambda: explorer().trajectory([V], [V], [V], 1), "initial: v is neither"),
        (lambda: explorer().trajectory([V], [V], [X], K), "end: k is neither"),
        (lambda: explorer().recursion([V], [], [X], 1), "updates, initial: expected one"),
        (lambda: explorer().recursion([V], [V], [X], 2, data={W: [1]}), "data: expected 3 numbers"),
        (lambda: explorer().table({V: [1], W: [1, 2]}), "data: expected columns of one length"),
        (lambda: explorer().table({V: [np.nan]}), "data: expected a list of finite numbers"),
        (lambda: explorer().roots(sp.sin(S), S), "polynomial: expected one in s"),
        (lambda: explorer().curve(S, 0, V), "high: v is neither"),
        (lambda: explorer().curve(S, 0, 1).last(X, S), "symbol: x has a value already"),
        (lambda: explorer().panel("a", "b", (0, 0), (0, 1)), "x_range: expected"),
        (lambda: panel().region(K > 0), "condition: k is neither"),
        (lambda: panel().segments([(0, 0), (X, 1)], "wavy"), "style: expected one of solid"),
        (lambda: explorer().sentence((X > 0, "positive")), "cases: expected the condition True"),
        (lambda: explorer().sentence((True, "{y}")), "cases: y is no scalar"),
        (lambda: panel()._explorer.plot(y=1), "values: there is no parameter y"),
    ],
)
def test_bad_input_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_a_remainder_stands_in_brackets():
    assert Formula("value", 1 - 2 * sp.Mod(X, 2), [X]).javascript == "1 - 2*(((v[0] % 2) + 2) % 2)"

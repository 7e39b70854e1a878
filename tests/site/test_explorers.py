"""Interactive figures in the browser: their numbers, pointer, keyboard and screen readers.

The figures of the book are made from its cells: those that declare one, and those that they need.
No site is built but for the last tests.
"""

import gzip
import json
import re
import symtable
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from myst_nb.core.read import read_myst_markdown_notebook
from selenium.webdriver.common.keys import Keys
from selenium_axe_python import Axe

from workbook.display import Explorer
from workbook.display.explorer.evaluation import SERIES, evaluate

ROOT = Path(__file__).resolve().parents[2]
FIGURE = re.compile(r"\bExplorer\(")
PAGES = sorted(
    path.relative_to(ROOT).as_posix()
    for path in [
        *ROOT.glob("book/*.md"),
        *ROOT.glob("book/ch*/*.md"),
        *ROOT.glob("solutions/*/*.md"),
    ]
    if FIGURE.search(path.read_text(encoding="utf-8"))
)
#: A call of formulas in the browser: [[code, v, c], ...] -> their values.
CALL = """JSON.stringify(JSON.parse(arguments[0]).map(
    ([code, v, c]) => new Function("v", "c", "return " + code)(v, c)))"""


def cells_of(page):
    """Return the code cells of a page: code, names that it uses, names that it assigns."""
    notebook = read_myst_markdown_notebook((ROOT / page).read_text(encoding="utf-8"))
    cells = []
    for code in (cell.source for cell in notebook.cells if cell.cell_type == "code"):
        table = symtable.symtable(code, page, "exec")
        assigned = {
            symbol.get_name()
            for symbol in table.get_symbols()
            if symbol.is_assigned() or symbol.is_imported()
        }
        cells.append((code, names_used(table), assigned))
    return cells


def names_used(table):
    """Return the names of the module that its code, or a function in it, reads."""
    used = {
        symbol.get_name()
        for symbol in table.get_symbols()
        if symbol.is_referenced() and (table.get_type() == "module" or symbol.is_global())
    }
    return used.union(*(names_used(inner) for inner in table.get_children()))


@pytest.fixture(scope="module", params=PAGES)
def figures(request):
    """Return the figures of a page of the book."""
    first, *others = cells_of(request.param)
    needed, run = set(), []
    for code, used, assigned in reversed(others):
        if FIGURE.search(code) or needed & assigned:
            needed = (needed | used) - assigned
            run.append(code)
    namespace = {}
    for code in [first[0], *reversed(run)]:
        exec(compile(code, request.param, "exec"), namespace)
    return [value for value in namespace.values() if isinstance(value, Explorer)]


@pytest.fixture
def show(browser, tmp_path):
    """Return a function that opens a page with nothing but figures."""

    def show(*figures):
        path = tmp_path / "page.html"
        content = "".join(figure._repr_html_() for figure in figures)
        path.write_text(
            '<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Figures</title>'
            f"</head><body><main><h1>Figures</h1>{content}</main></body></html>",
            encoding="utf-8",
        )
        browser.open(path.as_uri())
        assert browser.errors() == [] and browser.foreign_requests() == []

    return show


def oscillator():
    x, v, k, end = sp.symbols("x v k end", real=True)
    figure = Explorer("Where does it come back?", "An oscillator.")
    figure.parameter(x, 1, (-2, 2))
    figure.parameter(v, 0, (-2, 2))
    figure.parameter(k, 1, (0.5, 4))
    motion = figure.trajectory([x, v], [v, -k * x], [x, v], 6)
    motion.last(end, x)
    plane = figure.panel("x", "v", (-3, 3), (-3, 3))
    plane.line(motion, x, v)
    plane.point(x, v, "initial state")
    figure.sentence((x < 0, "left of it"), (True, "x = {x}, v = {v}, k = {k}"))
    return figure


@pytest.mark.parametrize("page", PAGES)
def test_the_cell_of_a_figure_changes_no_name_that_a_later_cell_uses(page):
    from_figures = set()
    for code, used, assigned in cells_of(page):
        if FIGURE.search(code):
            from_figures |= assigned
        else:
            assert not from_figures & used - assigned, code
            from_figures -= assigned


def settings(figure):
    """Return values of the parameters: the first ones, and some more between their limits."""
    generator = np.random.default_rng(5)
    yield [parameter.value for parameter in figure.parameters]
    for _ in range(3):
        shares = generator.uniform(0.1, 0.9, len(figure.parameters))
        yield [
            low + step * round(share * (high - low) / step)
            for share, (low, high), step in (
                (share, parameter.limits, parameter.step)
                for share, parameter in zip(shares, figure.parameters)
            )
        ]


def evaluated(figure, inputs):
    names = [str(parameter.symbol) for parameter in figure.parameters]
    return evaluate(figure, dict(zip(names, inputs)))


def entries(figure, values):
    """Yield every formula of a figure with points at which it is needed: formula, v, c."""
    generator = np.random.default_rng(7)
    series = iter(range(len(figure.series)))
    for step in figure.steps:
        own = (
            next(series)
            if step.kind in ("trajectory", "recursion", "curve", "table", "roots")
            else None
        )
        source = step.constants.get("series", own)
        for formulas in step.formulas.values():
            for formula in formulas:
                yield formula, [] if not formula.columns else values.series[source]
    for panel in figure.panels:
        ranges = np.array([panel.x_range, panel.y_range])
        for part in panel.parts:
            points = generator.uniform(ranges[:, :1], ranges[:, 1:], (2, 40))
            columns = points if part.series is None else values.series[part.series]
            for formulas in part.formulas.values():
                for formula in formulas:
                    yield formula, columns if formula.columns else []
    for sentence in figure.sentences:
        yield from ((condition, []) for condition, _ in sentence.cases)


def test_every_formula_has_the_value_of_sympy(browser, figures, show):
    show()
    for figure in figures:
        for inputs in settings(figure):
            values = evaluated(figure, inputs)
            calls, expected = [], []
            for formula, columns in entries(figure, values):
                rows = np.array(columns).T
                rows = rows[:: max(1, len(rows) // 25)] if len(columns) else [[]]
                calls += [[formula.javascript, values.scalars, list(row)] for row in rows]
                expected += [float(formula(values.scalars, row)) for row in rows]
            computed = json.loads(
                browser.driver.execute_script(f"return {CALL}", json.dumps(calls))
            )
            for call, value, other in zip(calls, expected, computed, strict=True):
                if np.isfinite(value):
                    assert other == pytest.approx(value, rel=1e-9, abs=1e-9), call
                else:
                    assert other is None, call


def agreement(figure, values):
    """Return how closely two computations of a figure can agree.

    Two roots that coincide move by the square root of what the coefficients are rounded by.
    """
    kinds = [step.kind for step in figure.steps]
    if "trajectory" in kinds:
        return 1e-4
    with_series = [kind for kind in kinds if kind in SERIES]
    for kind, series in zip(with_series, values.series):
        if kind != "roots":
            continue
        roots = series[0] + 1j * series[1]
        distances = np.abs(roots[:, None] - roots)[np.triu_indices(len(roots), 1)]
        if distances.size and distances.min() < 1e-6 * np.abs(roots).max():
            return 1e-7
    return 1e-9


def test_series_and_scalars_agree_with_scipy(browser, figures, show):
    show(*figures)
    for k, figure in enumerate(figures):
        for inputs in settings(figure):
            values = evaluated(figure, inputs)
            state = browser.driver.execute_script(
                """const figure = document.querySelectorAll(".explorer")[arguments[0]].explorer;
                figure.move(new Map(arguments[1].map((value, k) => [k, value])));
                return JSON.stringify([figure.v, figure.rows]);""",
                k,
                inputs,
            )
            scalars, series = json.loads(state)
            tolerance = agreement(figure, values)
            assert scalars == pytest.approx(values.scalars, rel=tolerance, abs=tolerance)
            for rows, expected in zip(series, values.series, strict=True):
                columns = np.array(rows).T
                if len(columns) == 2 and len(columns[0]) < 12:  # roots come in any order
                    columns, expected = (
                        part[:, np.lexsort(part.round(6))] for part in (columns, expected)
                    )
                scale = np.maximum(1, np.abs(expected).max(axis=1, keepdims=True))
                assert columns.shape == expected.shape
                assert np.abs((columns - expected) / scale).max() < tolerance, figure


def test_a_point_is_dragged_clicked_and_moved_by_arrow_keys(browser, show):
    from selenium.webdriver import ActionChains

    show(oscillator())
    handle = browser.find(".handle")
    sentence = "document.querySelector('.explorer-sentence').textContent"
    line = "document.querySelector('path.line').getAttribute('d')"
    assert browser.run(sentence) == "x = 1, v = 0, k = 1"
    before = browser.run(line)
    handle.send_keys(Keys.ARROW_RIGHT, Keys.ARROW_UP, Keys.ARROW_UP)
    assert browser.run(sentence) == "x = 1.15, v = 0.3, k = 1" and browser.run(line) != before
    assert handle.get_attribute("aria-valuetext") == "x = 1.15, v = 0.3"
    handle.send_keys(Keys.SHIFT, Keys.ARROW_LEFT)
    assert browser.run(sentence).startswith("x = 1.14")  # 1.135
    width = browser.run("document.querySelector('rect.frame').getBoundingClientRect().width")
    ActionChains(browser.driver).drag_and_drop_by_offset(handle, -round(width / 3), 0).perform()
    assert browser.run(sentence) == "left of it"  # 1.135 - 2
    position = "document.querySelector('.explorer').explorer.inputs"
    assert browser.run(position)[:2] == pytest.approx([-0.865, 0.3], abs=0.03)
    frame = browser.find("rect.frame")
    ActionChains(browser.driver).move_to_element(frame).click().perform()
    assert browser.run(position)[:2] == pytest.approx([0, 0], abs=0.03)
    browser.find(".explorer button").click()
    assert browser.run(sentence) == "x = 1, v = 0, k = 1"
    # limits are kept
    handle.send_keys(Keys.ARROW_UP * 20)
    assert browser.run(sentence) == "x = 1, v = 2, k = 1"


def test_a_slider_is_a_native_input_with_its_value(browser, show):
    show(oscillator())
    slider = browser.find(".explorer input[type=range]")
    assert slider.accessible_name.startswith("k")
    slider.send_keys(Keys.END)
    assert browser.find(".explorer output").text == "4"
    assert browser.run("document.querySelector('.explorer-sentence').textContent").endswith("k = 4")
    # what is read aloud waits until the reader pauses
    words = "document.querySelector('.explorer-sentence').ariaBusy"
    assert browser.wait_for(f"{words} == 'false'")
    assert browser.find(".explorer-sentence").get_attribute("aria-live") == "polite"


def moving():
    now = sp.Symbol("now", real=True)
    figure = Explorer("When does it turn?", "A body on a track.")
    figure.parameter(now, 0, (0, 3), "time t", play=1)
    figure.panel("x", "", (-2, 2), (-1, 1), 0.3).point(sp.sin(now), 0)
    figure.sentence((True, "t = {now}"))
    return figure


def test_a_motion_plays_to_its_end(moving_browser, tmp_path):
    page = tmp_path / "page.html"
    page.write_text(f"<!doctype html>{moving()._repr_html_()}", encoding="utf-8")
    moving_browser.open(page.as_uri())
    now = "document.querySelector('.explorer').explorer.inputs[0]"
    button = moving_browser.find(".explorer-controls button")
    assert button.accessible_name == "Play" and moving_browser.run(now) == 0
    button.click()
    assert moving_browser.wait_for(f"{now} == 3") and button.accessible_name == "Play"


def test_with_reduced_motion_it_goes_on_by_steps(browser, show):
    emulate = "Emulation.setEmulatedMedia"
    browser.driver.execute_cdp_cmd(
        emulate, {"features": [{"name": "prefers-reduced-motion", "value": "reduce"}]}
    )
    try:
        show(moving())
        button = browser.find(".explorer-controls button")
        assert button.accessible_name == "Next step"
        button.click()
        assert browser.find(".explorer output").text == "0.25"
    finally:
        browser.driver.execute_cdp_cmd(emulate, {"features": []})


def test_axe_finds_no_fault(browser, show):
    show(oscillator(), moving())
    axe = Axe(browser.driver)
    axe.inject()
    assert axe.run("document", "{resultTypes: ['violations']}")["violations"] == []


def test_without_javascript_and_on_paper_the_picture_stands(browser, show):
    show(oscillator())
    shown = """['.explorer-still', '.explorer-panels'].map(
        selector => getComputedStyle(document.querySelector(selector)).display)"""
    assert browser.run(shown) == ["none", "flex"]
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        assert browser.run(shown) == ["block", "none"]
    finally:
        browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    browser.driver.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": True})
    try:
        browser.driver.refresh()
        assert browser.find(".explorer-still").is_displayed()
    finally:
        browser.driver.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": False})


def test_pages_load_the_script_only_for_a_figure(editions):
    for page in ("book/ch1/lyapunov.md", "book/index.md", "book/bibliography.md"):
        text = (editions.full / page).with_suffix(".html").read_text(encoding="utf-8")
        assert text.count("explorer.js") == (page in PAGES)
        assert "explorer-asset" not in text


@pytest.mark.parametrize("page", PAGES)
def test_figures_of_the_site_work_and_are_small(browser, addresses, editions, page):
    browser.open(f"{addresses['file']}/{page.removesuffix('.md')}.html")
    assert browser.run("[...document.querySelectorAll('.explorer')].every(box => box.explorer)")
    assert browser.errors() == [] and browser.foreign_requests() == []
    handles = """[...document.querySelectorAll('.explorer .handle[role=slider]')].map(
        handle => handle.ariaLabel)"""
    assert not [name for name in browser.run(handles) if name.startswith(("point", ","))]
    figures = "".join(
        browser.run(
            """[...document.querySelectorAll('.explorer')].map(
                box => box.dataset.explorer + box.querySelector('img').src)"""
        )
    )
    assets = [
        (editions.full / "_static" / f"explorer.{kind}").read_text() for kind in ("js", "css")
    ]
    assert len(gzip.compress("".join([figures, *assets]).encode())) < 350_000

"""What `solve` shows while it computes, and the log of it."""

import io
from dataclasses import replace
from types import SimpleNamespace

import pytest
import sympy as sp

from trajlib.pontryagin import Infeasible, NotConverged, Problem
from trajlib.pontryagin.problem import log as log_module

x, v, u = sp.symbols("x v u")
CART = {x: v, v: u}
LIMITED = Problem(CART, {u: (-1, 1)}, {x: 0, v: 0}, {x: 3, v: 0}, path=[v <= 1])
# In least time with a bound of the angle of the load: more lists of arcs than time.
p, s, a, w = sp.symbols("p s a w")
CRANE = Problem(
    {p: s, s: u, a: w, w: -a - u},
    {u: (-1, 1)},
    dict.fromkeys((p, s, a, w), 0),
    {p: 5, s: 0, a: 0, w: 0},
    path=[sp.Abs(a) <= sp.Rational(4, 5)],
)
PENDULUM = Problem({x: v, v: u - sp.sin(x)}, {u: (-1, 1)}, {x: 2, v: 0}, {x: 0, v: 0})


def test_log_has_starts_arcs_and_residuals():
    extremal = replace(PENDULUM).solve()
    entries = list(extremal.log)
    assert [e.seconds for e in entries] == sorted(e.seconds for e in entries)
    starts = [e for e in entries if e.event == "start"]
    assert len(starts) == extremal.optimality.starts > 1
    assert [e.text.split()[1] for e in starts] == [str(i + 1) for i in range(len(starts))]
    costs = [e.value for e in entries if e.event in ("start", "grid") and e.value is not None]
    assert min(costs) == pytest.approx(extremal.cost, rel=1e-2)
    *_, arcs = (e for e in entries if e.event == "arcs")
    assert arcs.text == f"{', '.join(kind for kind, _, _ in extremal.arcs)}: an extremal"
    *_, newton = (e for e in entries if e.event == "Newton")
    assert newton.value < 1e-12 and "s  Newton  residual" in repr(extremal.log)
    assert extremal.log[0].text == "refusals before the search"


def test_log_of_a_reformulated_problem_and_of_an_error():
    frugal = Problem(CART, {u: (-1, 1)}, {x: 0, v: 0}, {x: 1, v: 0}, running=sp.Abs(u), duration=3)
    log = frugal.solve().log
    assert log[0].text == "|u| in the running cost" and any(e.event == "arcs" for e in log)
    with pytest.raises(Infeasible) as raised:
        Problem(CART, {u: (-1, 1)}, {x: 0, v: 2}, {x: 3, v: 0}, path=[v <= 1]).solve()
    assert [e.text for e in raised.value.log] == ["refusals before the search"]
    with pytest.raises(NotConverged) as raised:
        CRANE.solve(time_limit=2)
    log = raised.value.log
    assert len(log) > 1 and log[-1].seconds < 5


def test_logs_are_apart():
    first = replace(LIMITED).solve()
    count = len(first.log)
    second = replace(LIMITED).solve()
    assert len(first.log) == count == len(second.log) and first.log is not second.log
    assert log_module.current_log().entries == []


class Terminal(io.StringIO):
    def isatty(self):
        return True


def lines(text):
    return [line.rstrip() for line in text.split("\r")]


def test_line_is_rewritten_and_removed(monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr("sys.stderr", terminal)
    monkeypatch.setattr(log_module, "BETWEEN", 0.0)
    starts = replace(PENDULUM).solve(progress=True).optimality.starts
    before, *shown, removed, after = lines(terminal.getvalue())
    assert before == removed == after == "" and "\n" not in terminal.getvalue()
    assert any(f"{starts} starts, best cost" in line for line in shown)
    assert any("list 1 of arcs: u-" in line or "list 1 of arcs: u+" in line for line in shown)
    assert all(len(line) <= 79 and line.split(";")[0].endswith(" s") for line in shown)
    # Each kind of event once, in the same order.
    both = [line for line in shown if "residual" in line and "list" in line]
    assert both and all(line.index("residual") < line.index("list") for line in both)
    assert all(line.count("best cost") <= 1 for line in shown)


@pytest.mark.parametrize(
    ("progress", "delay", "shown"), [(False, 0, 0), (None, 0, 1), (None, 60, 0)]
)
def test_line_by_default(progress, delay, shown, monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr("sys.stderr", terminal)
    monkeypatch.setattr(log_module, "DELAY", delay)
    replace(LIMITED).solve(progress=progress)
    assert bool(terminal.getvalue()) == shown


def test_nothing_is_shown_where_nobody_watches(monkeypatch, capsys):
    monkeypatch.setattr(log_module, "DELAY", 0.0)
    replace(LIMITED).solve()
    assert capsys.readouterr() == ("", "")
    with pytest.raises(TypeError, match="progress: expected True, False or None, got 'yes'"):
        replace(LIMITED).solve(progress="yes")


@pytest.mark.parametrize("person", [True, False])
def test_line_of_a_notebook(person, monkeypatch, capsys):
    """A notebook that is executed as a batch cannot ask for input."""
    IPython = pytest.importorskip("IPython")
    shown = []
    handle = SimpleNamespace(update=lambda content, raw: shown.append(content["text/plain"]))

    def display(content, raw, display_id):
        shown.append(content["text/plain"])
        return handle

    shell = SimpleNamespace(kernel=SimpleNamespace(_allow_stdin=person))
    monkeypatch.setattr(IPython, "get_ipython", lambda: shell)
    monkeypatch.setattr("IPython.display.display", display)
    monkeypatch.setattr(log_module, "DELAY", 0.0)
    replace(LIMITED).solve()
    assert capsys.readouterr() == ("", "")
    assert bool(shown) == person and (not shown or (shown[-1] == "" and " s; " in shown[0]))

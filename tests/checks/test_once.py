"""What is true of the data alone is found once: a further verdict on the same data does not look
for it again."""

import gc
import weakref

import pytest
import sympy as sp
from case import check_named

from trajlib.pontryagin import Problem
from workbook.checks.references.optima import direct_optimum
from workbook.checks.references.optima.direct_problem import statement

x, y, angle = sp.symbols("x y angle")
t, T, a, b = sp.symbols("t T a b", positive=True)
TURNED = [x * sp.cos(angle) + y * sp.sin(angle), y * sp.cos(angle) - x * sp.sin(angle)]
CALLS = {
    "uncorrelated": ("solveset", [[0, sp.pi / 2], [0]], (*TURNED, [x, y], sp.diag(1, 4), angle)),
    "research.range_observable": (
        "factor",
        [sp.Ne(a, 0), sp.Ne(b, 0)],
        ([x + y * t, 1 + t], t, T, [a, b]),
    ),
}


@pytest.mark.parametrize("name", CALLS)
def test_a_second_verdict_asks_no_solver(name, monkeypatch):
    solver, (first, second), data = CALLS[name]
    check, asked, solve = check_named(name), [], getattr(sp, solver)
    monkeypatch.setattr(sp, solver, lambda *given: (asked.append(given), solve(*given))[1])
    assert check(first, *data).status in ("right", "wrong") and len(asked) == 1
    assert check(second, *data).status in ("right", "wrong") and len(asked) == 1


def test_what_a_search_has_made_goes_with_it():
    """A process judges many notebooks: of the searches only the last ones are kept."""
    u, v = sp.symbols("u v")
    problem = Problem({x: u, y: v}, {u: (-1, 1), v: (-1, 1)}, {x: 0, y: 0}, [x - 1, y - 2])
    direct_optimum._search.cache_clear()
    kept = weakref.ref(direct_optimum._search(statement(problem), ()))
    assert abs(kept().best([]).duration - 2) < 1e-9
    direct_optimum._search.cache_clear()
    gc.collect()
    assert kept() is None

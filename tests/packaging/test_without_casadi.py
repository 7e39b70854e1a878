"""Where CasADi is absent, as in a page of the site, all modules load and other checks judge."""

import subprocess
import sys

IMPORTS = """
import importlib, pkgutil, sys
sys.modules["casadi"] = None
import trajlib, workbook.checks
for package in (trajlib, workbook.checks):
    for module in pkgutil.walk_packages(package.__path__, package.__name__ + "."):
        importlib.import_module(module.name)
"""
STATE = """
import sys
sys.modules["casadi"] = None
import sympy as sp
from trajlib.pontryagin import Problem

x, v, u = sp.symbols("x v u")
cart = {x: v, v: u}
problem = Problem(cart, {u: (-1, 1)}, {x: 0, v: 0}, {x: 3, v: 0}, path=[v <= 1])
print(problem.conditions().hamiltonian, problem.conditions().path[0].order)
problem._repr_markdown_()
print("trajlib.pontryagin.indirect" in sys.modules, "trajlib.pontryagin.planar_synthesis" in sys.modules)
"""
JUDGE = """
import sys
sys.modules["casadi"] = None
from workbook.checks.contract.verdict import judged
from trajlib._lazy import casadi

@judged
def solves(answer):
    return str(casadi.SX.sym("x"))

print(solves(1))
"""


def shown(code):
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=120
    )
    return run.stdout


def test_all_modules_load():
    assert shown(IMPORTS) == ""


def test_problems_are_stated_and_their_conditions_derived():
    assert shown(STATE) == "-lambda0 + psi1*v + psi2*u 1\nFalse False\n"


def test_a_check_that_needs_it_says_where_it_runs():
    assert "status='unchecked', message='this check runs in the notebook" in shown(JUDGE)


def test_lambdify_finds_the_functions_before_anything_else_was_used():
    code = (
        "import sympy as sp\n"
        "from trajlib._lazy import casadi\n"
        "x = sp.Symbol('x')\n"
        "print(sp.lambdify(x, sp.exp(x), casadi)(casadi.SX.sym('x')))"
    )
    assert shown(code) == "exp(x)\n"

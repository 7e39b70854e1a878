"""Problems of a course of one's own, made of what `workbook new` writes.

They ask for a subspace, an optimal control, and a number that a check in `checks.py` judges.
"""

import re
from pathlib import Path

GUIDE = Path(__file__).resolve().parents[2] / "book" / "guides" / "own_course.md"

SUBSPACE_PAGE = {
    "PLACEHOLDER title of problem robotics.2": "Unobservable states of two joints",
    "condition: PLACEHOLDER the real $k$ for which the zero solution is asymptotically stable": (
        "list of vector: a basis of the unobservable subspace"
    ),
    "a_region": "a_basis",
    "PLACEHOLDER What signs do the coefficients have?": "Which states give the output zero forever?",
    "Find where the zero solution is asymptotically stable:": "Find the unobservable subspace:",
    "\\quad\\ddot x + k\\dot x + x = 0.": (
        "\\quad\\dot x_1 = x_1,\\ \\dot x_2 = 2x_2,\\ \\text{where } x_1 \\text{ is measured}."
    ),
    'k, s = sp.symbols("k s", real=True)\na_poly = s**2 + k*s + 1': (
        "a_system = Linear(A=sp.diag(1, 2), H=sp.Matrix([[1, 0]]))"
    ),
    "from workbook import checks": "from workbook import checks\nfrom workbook.systems import Linear",
    "a_basis = k > 0": "a_basis = [[0, 1]]",
    "checks.stability_region(a_basis, a_poly, [k])": "checks.unobservable_states(a_basis, a_system)",
    "PLACEHOLDER": "",
}
SUBSPACE_TRIALS = """\
# %% wrong
a_basis = [[1, 0]]  # Is this state not the one that is measured? (hint 1)

# %% right
a_basis = [[0, -3]]  # a multiple
"""
CONTROL_PAGE = {
    "PLACEHOLDER title of problem robotics.3": "Energy of a carriage that is moved by a length",
    "condition: PLACEHOLDER the real $k$ for which the zero solution is asymptotically stable": (
        "expression: the control $u(t)$ of minimum energy"
    ),
    "a_region": "a_control",
    "PLACEHOLDER What signs do the coefficients have?": "Of which degree in $t$ is the control?",
    "Find where the zero solution is asymptotically stable:": (
        "Move the carriage by $L$ from rest to rest in time 1 with minimum $\\int_0^1 u^2\\,dt$:"
    ),
    "\\quad\\ddot x + k\\dot x + x = 0.": "\\quad\\ddot x = u.",
    'k, s = sp.symbols("k s", real=True)\na_poly = s**2 + k*s + 1': (
        't, x, v, u = sp.symbols("t x v u", real=True)\n'
        'L = sp.Symbol("L", positive=True)\n'
        "a_move = Problem({x: v, v: u}, {u: (-sp.oo, sp.oo)}, {x: 0, v: 0}, [x - L, v], u**2, duration=1)"
    ),
    "from workbook import checks": (
        "from trajlib.pontryagin import Problem\nfrom workbook import checks"
    ),
    "a_control = k > 0": "a_control = 6*L*(1 - 2*t)",
    "checks.stability_region(a_control, a_poly, [k])": (
        "checks.optimal_control(a_control, a_move, t, [L])"
    ),
    "PLACEHOLDER": "",
}
CONTROL_TRIALS = """\
# %% wrong
a_control = 6*L*t  # Is the carriage at rest at the end? (hint 1)

# %% right
a_control = [[6*L*(1 - 2*t), 1]]  # as one arc
"""
REACH_PAGE = {
    "PLACEHOLDER title of problem robotics.4": "Nearest position of an arm with two links",
    "condition: PLACEHOLDER the real $k$ for which the zero solution is asymptotically stable": (
        "number: the least distance of the hand from the base"
    ),
    "a_region": "a_least",
    "PLACEHOLDER What signs do the coefficients have?": "How far is the hand if the arm is folded?",
    "Find where the zero solution is asymptotically stable:": "How near does the hand come to the base?",
    "\\quad\\ddot x + k\\dot x + x = 0.": "\\quad l_1 = 5,\\ l_2 = 3",
    'k, s = sp.symbols("k s", real=True)\na_poly = s**2 + k*s + 1': "lengths = [5, 3]",
    "a_least = k > 0": "a_least = 5 - 3",
    "checks.stability_region(a_least, a_poly, [k])": "checks.least_reach(a_least, lengths)",
    "PLACEHOLDER": "",
}
REACH_TRIALS = """\
# %% wrong
a_least = 8  # Is the arm stretched or folded? (hint 1)

# %% right
a_least = sp.sqrt(4)  # as a root
"""
REACH = (REACH_PAGE, REACH_TRIALS)
SUBSPACE, CONTROL = (SUBSPACE_PAGE, SUBSPACE_TRIALS), (CONTROL_PAGE, CONTROL_TRIALS)


def fill_in(page, trials, texts, trials_text):
    """Write a problem into the two files of its scaffold."""
    text = page.read_text(encoding="utf-8")
    for old, new in texts.items():
        assert old in text, old
        text = text.replace(old, new)
    page.write_text(text, encoding="utf-8")
    trials.write_text(trials_text, encoding="utf-8")


def checks_of_the_guide():
    """Return the `checks.py` that the guide shows."""
    [block] = re.findall(r"```python\n(# checks\.py\n.*?)```", GUIDE.read_text("utf-8"), re.S)
    return block

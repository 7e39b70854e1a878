"""A linear system as a model of small deviations from a motion of a nonlinear one.

The nonlinear system is a field of its state, the motion a dict from the state to functions of time, `{phi: t, r: 1,
...}`. The derivatives of the field along the motion, which have to be constant, make the equations in deviations; they
are found here exactly, and so no answer to an earlier question is needed.
"""

import sympy as sp

from trajlib.checks.contract.claims import Choice, Matrix
from trajlib.checks.contract.verdict import judged
from trajlib.checks.structure.decompositions import judge_similarity
from trajlib.checks.structure.output_meaning import judge_meaning


@judged(Matrix(shape="A"))
def change_to_deviations(claim, A, field, state, motion):
    """A matrix S with y = S x: it turns x' = A x (A: n x n) into the equations in the deviations y of the n symbols
    `state` from a motion, {symbol: function of time}."""
    return judge_similarity(claim, A, _along(field, state, motion))


@judged(Choice(words="quantities"))
def measured_quantity(claim, A, H, field, state, motion, quantities):
    """Which of the `quantities` (name: expression in the state) the measurement z = H x of x' = A x is, deviations from
    a motion meant."""
    rows = {name: _along([quantity], state, motion) for name, quantity in quantities.items()}
    return judge_meaning(claim, A, H, _along(field, state, motion), rows)


def _along(expressions, state, motion):
    """The derivatives with respect to the state, on the motion."""
    found = sp.Matrix(list(expressions)).jacobian(list(state)).subs(motion).applyfunc(sp.simplify)
    if found.free_symbols:
        raise RuntimeError("the equations in deviations are not constant")
    return found

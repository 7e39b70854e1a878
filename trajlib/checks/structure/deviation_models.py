"""A linear system as a model of small deviations from a motion of a nonlinear one.

The nonlinear system is a field of its state, the motion a dict from the state to functions of time, `{phi: t, r: 1,
...}`. The derivatives of the field along the motion, which have to be constant, make the equations in deviations; they
are found here exactly, and so no answer to an earlier question is needed.
"""

import sympy as sp

from trajlib.checks.contract import coercion
from trajlib.checks.contract.verdict import judged
from trajlib.checks.structure.decompositions import similarity
from trajlib.checks.structure.output_meaning import judge_meaning


@judged
def change_to_deviations(answer, A, field, state, motion):
    """A matrix S with y = S x: it turns x' = A x into the equations in the deviations y of the state from a motion."""
    return similarity.__wrapped__(answer, A, _along(field, state, motion))


@judged
def measured_quantity(answer, A, H, field, state, motion, quantities):
    """Which of the `quantities` (name: expression in the state) the measurement z = H x of x' = A x is, deviations from
    a motion meant."""
    claim = coercion.as_choice(answer, tuple(quantities))
    rows = {name: _along([quantity], state, motion) for name, quantity in quantities.items()}
    return judge_meaning(claim, A, H, _along(field, state, motion), rows)


def _along(expressions, state, motion):
    """The derivatives with respect to the state, on the motion."""
    found = sp.Matrix(list(expressions)).jacobian(list(state)).subs(motion).applyfunc(sp.simplify)
    if found.free_symbols:
        raise RuntimeError("the equations in deviations are not constant")
    return found

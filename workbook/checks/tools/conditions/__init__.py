"""Comparison of a student's condition with the true one, decided for all values where possible.

`reference_condition` states where a condition has to hold, `decimals` what a number in decimals
stands for, `evaluation` whether a condition holds at one point. `decision` asks the solver z3 about
all points, after `polynomial_form` has made conditions polynomial. Where z3 is absent or gives up,
`cell_search` tries one point of each cell of a `decomposition` on which nothing changes, whose
polynomials `elimination` finds and whose coordinates are `real_roots`. `sampling` tries points where
nothing can be decided, and the verdict then says at how many points it agrees. `comparison` joins
them.
"""

from trajlib._lazy import lazy_names

_EXPORTS = {
    "reference_condition": ["Case", "ReferenceCondition", "exactly"],
    "decimals": ["readings"],
    "evaluation": ["Condition", "allowed"],
    "sampling": ["on_borders"],
    "comparison": ["compare", "contradiction_message", "decide"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)

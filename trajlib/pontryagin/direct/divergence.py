"""Costs that fall without bound along the iterates of IPOPT."""

from trajlib.pontryagin.problem.errors import Unbounded
from trajlib.pontryagin.problem.steps import Refusal


def _refuse_divergence(numeric, search):
    failure = search.divergence()
    if failure:
        raise Unbounded(
            f"the cost falls without bound (it passed {numeric.user_cost(failure.cost):.3g}): "
            "there is no optimal process. Check the sign of the cost, bound the controls, or "
            "fix the duration."
        )


DIVERGENCE = Refusal(
    "cost without a lower bound",
    "The cost fell below every bound along the iterates of IPOPT.",
    "numerical evidence",
    (),
    Unbounded,
    _refuse_divergence,
)

"""All steps of `solve`, in the order in which they are tried."""

from trajlib.pontryagin.direct.free_duration import EXTREME_DURATION
from trajlib.pontryagin.direct.negative_loop import NEGATIVE_LOOP
from trajlib.pontryagin.direct.refusals import (
    BEFORE_SEARCH,
    OF_SOLUTIONS,
    WITHOUT_EXTREMAL,
    WITHOUT_SOLUTION,
)
from trajlib.pontryagin.indirect.arc_search import SEARCH
from trajlib.pontryagin.indirect.bounded_extremal import STATE_BOUNDS
from trajlib.pontryagin.indirect.chattering import CHATTERING
from trajlib.pontryagin.indirect.contacts import HIGH_ORDER
from trajlib.pontryagin.indirect.infinite_horizon import RICCATI
from trajlib.pontryagin.indirect.l1_control import ABSOLUTE_VALUES
from trajlib.pontryagin.indirect.linear_quadratic import LINEAR_QUADRATIC
from trajlib.pontryagin.indirect.polynomial_end import POLYNOMIAL_END
from trajlib.pontryagin.indirect.scaled_extremal import NATURAL_UNITS
from trajlib.pontryagin.problem.steps import Step

# Of the statement; the problem in other units comes later, since proofs are told in the user's.
REFORMULATIONS = (STATE_BOUNDS, ABSOLUTE_VALUES)

ORDER: tuple[tuple[str, tuple[Step, ...]], ...] = (
    ("infinite horizon", (RICCATI,)),
    ("reformulations of the statement", REFORMULATIONS),
    ("refusals before any search", BEFORE_SEARCH),
    ("methods without a search", (LINEAR_QUADRATIC, POLYNOMIAL_END)),
    ("units", (NATURAL_UNITS,)),
    ("search, where no method above gives the extremal", (SEARCH,)),
    ("refusals where no discrete solution is found", WITHOUT_SOLUTION),
    ("refusals of discrete solutions", (NEGATIVE_LOOP, *OF_SOLUTIONS)),
    ("refusals of lists of arcs", (EXTREME_DURATION, CHATTERING, HIGH_ORDER)),
    ("refusals where no arcs lead to an extremal", WITHOUT_EXTREMAL),
)

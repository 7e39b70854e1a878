"""The refusals around the search for discrete solutions, in the order in which they are tried."""

from dataclasses import replace

from trajlib.pontryagin.direct.degenerate_target import (
    DEGENERATE_TARGET,
    refuse_degenerate_target,
)
from trajlib.pontryagin.direct.divergence import DIVERGENCE
from trajlib.pontryagin.direct.ends_beyond_constraints import ENDS_BEYOND_CONSTRAINTS
from trajlib.pontryagin.direct.first_integrals import FIRST_INTEGRALS, FIXED_POINT
from trajlib.pontryagin.direct.free_duration import ANY_DURATION, FALLING_COST, OPEN_DURATION
from trajlib.pontryagin.direct.guesses import starting_guesses
from trajlib.pontryagin.direct.impulses import IMPULSES
from trajlib.pontryagin.direct.infeasibility import LINEAR_TARGETS
from trajlib.pontryagin.direct.passing_beyond import PASSING_BEYOND
from trajlib.pontryagin.direct.separating_costate import SEPARATING_COSTATE
from trajlib.pontryagin.direct.sliding import SLIDING
from trajlib.pontryagin.direct.start_on_target import START_ON_TARGET
from trajlib.pontryagin.direct.transcription import INTERVALS

# Proofs from the statement alone: refuse(numeric).
BEFORE_SEARCH = (
    START_ON_TARGET,
    ENDS_BEYOND_CONSTRAINTS,
    *LINEAR_TARGETS,
    FIXED_POINT,
    FIRST_INTEGRALS,
    ANY_DURATION,
)
# Where the search has found no discrete solution: refuse(numeric, search).
WITHOUT_SOLUTION = (
    DIVERGENCE,
    replace(
        DEGENERATE_TARGET,
        refuse=lambda numeric, _search: refuse_degenerate_target(
            numeric, next(iter(starting_guesses(numeric, INTERVALS)))[1]
        ),
    ),
    SEPARATING_COSTATE,
)
# Of the discrete solutions, before their arcs are joined: refuse(numeric, search_result).
OF_SOLUTIONS = (DEGENERATE_TARGET, FALLING_COST)
# Where no arcs led to an extremal: refuse(numeric, solution, side); a solution that one of them
# returns is tried in place of the first.
WITHOUT_EXTREMAL = (PASSING_BEYOND, SLIDING, OPEN_DURATION, IMPULSES)

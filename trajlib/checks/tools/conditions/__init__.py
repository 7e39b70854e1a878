"""A student's condition against the true one: decided for all values at once wherever that can be done.

`truth` says where a condition has to hold, `decimals` what a number in decimals stands for, `evaluation` what holds
at one place. `decision` asks a solver about all places, of what `plain` has made polynomial; `sampling` tries places
where nothing can be decided, and the verdict then says at how many points it agrees. `comparison` joins them.
"""

from trajlib.checks.tools.conditions.comparison import compare, contrary, decide
from trajlib.checks.tools.conditions.decimals import readings
from trajlib.checks.tools.conditions.evaluation import Condition, allowed, place_text
from trajlib.checks.tools.conditions.sampling import on_borders
from trajlib.checks.tools.conditions.truth import Case, Truth, exactly

__all__ = ["Case", "Condition", "Truth", "allowed", "compare", "contrary", "decide", "exactly", "on_borders",
           "place_text", "readings"]

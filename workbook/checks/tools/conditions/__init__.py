"""A student's condition against the true one: decided for all values at once wherever that can be
done.

`truth` says where a condition has to hold, `decimals` what a number in decimals stands for,
`evaluation` what holds at one place. `decision` asks a solver about all places, of what `plain` has
made polynomial; `sampling` tries places where nothing can be decided, and the verdict then says at
how many points it agrees. `comparison` joins them.
"""

from trajlib._lazy import lazy_names

_EXPORTS = {
    "truth": ["Case", "Truth", "exactly"],
    "decimals": ["readings"],
    "evaluation": ["Condition", "allowed", "place_text"],
    "sampling": ["on_borders"],
    "comparison": ["compare", "contrary", "decide"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)

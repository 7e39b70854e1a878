"""Explorers: pictures of a lecture that follow a slider, the pointer, or both.

One function each, in a module of its own; `explore` finds one by its name, as `%explore` does.
"""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(
    __name__,
    {
        "region": ["region_of_stability"],
        "phase": ["phase_portrait"],
        "lost_mode": ["losing_a_mode"],
        "popov": ["popov_distance"],
        "fastest": ["fastest_motion"],
        "circle": ["circle_synthesis"],
        "by_hand": ["against_the_best"],
        "asking": ["explore", "listed"],
    },
)

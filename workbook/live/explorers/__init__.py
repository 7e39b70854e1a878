"""Explorers: interactive figures of a lecture that follow sliders and the pointer.

Each is a function in a module of its own; `explore` finds it by its name, as `%explore` does.
"""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(
    __name__,
    {
        "region": ["region_of_stability"],
        "phase": ["phase_portrait"],
        "cancellation": ["pole_zero_cancellation"],
        "unobservability": ["distance_to_unobservable"],
        "fastest": ["fastest_motion"],
        "circle": ["circle_synthesis"],
        "manual": ["manual_control"],
        "by_name": ["explore", "list_explorers"],
    },
)

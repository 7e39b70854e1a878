"""What a page shows: results with their words, drawings of bodies, and animations."""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(
    __name__,
    {
        "results": ["show", "table"],
        "drawings": ["Drawing", "along"],
        "animations": ["Animation"],
    },
)

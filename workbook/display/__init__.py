"""What pages show: results, tables, drawings of bodies, animations, interactive figures."""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(
    __name__,
    {
        "results": ["show", "table"],
        "drawings": ["Drawing"],
        "sheet": ["Sheet", "along"],
        "animations": ["Animation"],
        "explorer.declaration": ["Explorer"],
    },
)

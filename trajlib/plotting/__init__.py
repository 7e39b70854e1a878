"""Pictures: each function draws on the Axes it is given and returns that Axes.

Colours are those of Okabe and Ito, which colour-blind readers can distinguish, the lightest three
darkened to a contrast of 3 to white. A line style, a marker or a hatching repeats what a colour
means, so that the pictures survive a black-and-white printer. Sizes suit a narrow screen. Importing
this package changes nothing in Matplotlib: the style applies to figures made here, and elsewhere
inside `with style():`.

>>> from trajlib import plotting
>>> "phase_portrait" in dir(plotting)
True
"""

from trajlib._lazy import lazy_names

# No module has the name of an export: importing it would put the module in the place of the
# function.
_EXPORTS = {
    "appearance": ["BLACK", "BLUE", "GREEN", "GREY", "ORANGE", "PURPLE", "RED", "SKY", "style"],
    "plane": ["window"],
    "phase_plane": [
        "level_curve",
        "mark_equilibria",
        "nullclines",
        "phase_portrait",
        "sublevel_component",
    ],
    "parameter_plane": ["region"],
    "curves": ["estimate", "roots"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)

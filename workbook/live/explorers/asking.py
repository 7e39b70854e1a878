"""An explorer by its name, as a lecturer asks for it: `phase_portrait 1.4 epsilon=0.5`."""

import inspect
from difflib import get_close_matches

from workbook.live import explorers
from workbook.live.subjects import LiveError

NAMES = (
    "region_of_stability",
    "phase_portrait",
    "losing_a_mode",
    "popov_distance",
    "fastest_motion",
    "circle_synthesis",
    "against_the_best",
)


def listed():
    """Each explorer with what it takes and the first line of what it does."""
    lines = []
    for name in NAMES:
        function = getattr(explorers, name)
        takes = " ".join(f"[{word}]" for word in inspect.signature(function).parameters)
        lines.append(
            f"%explore {f'{name} {takes}'.strip():35} {inspect.getdoc(function).splitlines()[0]}"
        )
    return "\n".join(lines)


def explore(words):
    """The explorer that words name: its name, problem and item where it takes them, and values for
    its parameters.

    Raises `LiveError` for a name, a problem or a parameter that is not there, and for a value out
    of its range.
    """
    name, *given = words.split()
    if name not in NAMES:
        near = get_close_matches(name, NAMES, cutoff=0.3)
        raise LiveError(
            f"there is no explorer {name}; "
            + (f"did you mean {near[0]}?" if near else f"there is {', '.join(NAMES)}")
        )
    function = getattr(explorers, name)
    places = [word for word in given if "=" not in word]
    takes = list(inspect.signature(function).parameters)
    if len(places) > len(takes):
        raise LiveError(
            f"{name} takes {' and '.join(takes) or 'no problem'}, and not {' '.join(places)}"
        )
    found = function(*places)
    found.set(**dict(word.split("=", 1) for word in given if "=" in word))
    return found

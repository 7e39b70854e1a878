"""Open an explorer by its name and arguments, such as `phase_portrait 1.4 epsilon=0.5`."""

import inspect
from difflib import get_close_matches

from workbook.live import explorers
from workbook.live.errors import LiveError

NAMES = (
    "region_of_stability",
    "phase_portrait",
    "pole_zero_cancellation",
    "distance_to_unobservable",
    "fastest_motion",
    "circle_synthesis",
    "manual_control",
)


def list_explorers():
    """Return a text with a line for each explorer: its arguments and what it shows."""
    lines = []
    for name in NAMES:
        function = getattr(explorers, name)
        arguments = " ".join(f"[{word}]" for word in inspect.signature(function).parameters)
        lines.append(
            f"%explore {f'{name} {arguments}'.strip():43} {inspect.getdoc(function).splitlines()[0]}"
        )
    return "\n".join(lines)


def explore(words):
    """Open the explorer that a line of words names.

    Parameters
    ----------
    words : str
        Name of the explorer, problem and item where it has these arguments, and values of its
        parameters: "phase_portrait 1.4 epsilon=0.5".

    Returns
    -------
    workbook.display.Explorer or workbook.live.explorers.kernel_figure.KernelFigure
        A figure of formulas, or one that the kernel draws.

    Raises
    ------
    LiveError
        If there is no such explorer, problem, item or parameter, or a value is out of range.
    """
    name, *arguments = words.split()
    if name not in NAMES:
        similar = get_close_matches(name, NAMES, cutoff=0.3)
        raise LiveError(
            f"there is no explorer {name}; "
            + (f"did you mean {similar[0]}?" if similar else f"there is {', '.join(NAMES)}")
        )
    function = getattr(explorers, name)
    positional = [word for word in arguments if "=" not in word]
    parameters = list(inspect.signature(function).parameters)
    if len(positional) > len(parameters):
        raise LiveError(
            f"{name} takes {' and '.join(parameters) or 'no problem'}, and not "
            f"{' '.join(positional)}"
        )
    explorer = function(*positional)
    try:
        explorer.set(**dict(word.split("=", 1) for word in arguments if "=" in word))
    except ValueError as error:
        raise LiveError(error) from None
    return explorer

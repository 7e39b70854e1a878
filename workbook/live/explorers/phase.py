"""The phase portrait of a planar problem of chapter 1, whose parameters and trajectory are moved."""

import sympy as sp

from workbook.display import Explorer
from workbook.live.errors import LiveError
from workbook.live.explorers.built_once import built_once
from workbook.live.explorers.portraits import PORTRAITS
from workbook.live.worked_problem import WorkedProblem

#: Length of a trajectory each way, in windows; its number of steps; speeds (windows a unit of time)
#: below the last one count as slower, so that a trajectory ends at an equilibrium.
LENGTH, POINTS, SLOW = 12, 3600, 0.02


@built_once
def phase_portrait(problem="1.4", item=""):
    """Show a phase portrait with sliders for its parameters, and the trajectory of a point that is moved.

    Equilibria are marked: filled if stable, open if unstable, a cross for a saddle.

    Parameters
    ----------
    problem : str
        A problem of chapter 1.
    item : str
        The letter of the system, where the problem has several.

    Raises
    ------
    LiveError
        If the problem has no planar system with this letter.
    """
    item, portrait = _portrait(problem, item)
    data = WorkedProblem(problem).data
    rates, state = (
        part(data) if callable(part) else data[part] for part in (portrait.field, portrait.state)
    )
    rates = sp.Matrix([sp.sympify(rate) for rate in rates])
    symbols = {symbol.name: symbol for symbol in rates.free_symbols}
    rates = rates.subs(
        {symbols[name]: value for name, value in portrait.constants.items() if name in symbols}
    )
    window = portrait.x_range, portrait.y_range
    figure = Explorer(
        f"Phase portrait of {f'{problem} {item}'.strip()}: how does it follow the parameters?",
        "The directions of a planar system, its equilibria, and a trajectory.",
    )
    for name, (low, high, value) in portrait.parameters.items():
        figure.parameter(symbols.get(name, sp.Symbol(name)), value, (low, high))
    for symbol, (low, high) in zip(state, window):
        figure.parameter(symbol, low + 0.7 * (high - low), (low, high))
    plane = figure.panel(*state, *window, height=0.7)
    plane.segments([(portrait.x_range[0], 0), (portrait.x_range[1], 0)], "thin")
    plane.segments([(0, portrait.y_range[0]), (0, portrait.y_range[1])], "thin")
    plane.field(*rates)
    # along its length a trajectory leaves the window and reaches an equilibrium in the same steps
    speed = sp.sqrt(
        sum((rate / (high - low)) ** 2 for rate, (low, high) in zip(rates, window)) + SLOW**2
    )
    for sign, label in ((-1, ""), (1, "trajectory")):
        motion = figure.trajectory(
            state, [sign * rate / speed for rate in rates], state, LENGTH, points=POINTS
        )
        plane.line(motion, *state, label=label)
    slopes = rates.jacobian(list(state))
    equilibria = figure.equilibria(state, rates, *window)
    determinant, trace = slopes.det(), slopes.trace()
    nowhere = (sp.nan, True)
    for kind, style, *cases in (
        ("saddle", "cross", (state[0], determinant < -1e-9), nowhere),
        ("stable", "dot", (sp.nan, determinant < 1e-9), (state[0], trace < -1e-9), nowhere),
        ("unstable", "ring", (sp.nan, determinant < 1e-9), (state[0], trace > 1e-9), nowhere),
    ):
        plane.marks(equilibria, sp.Piecewise(*cases), state[1], style, kind)
    plane.point(*state, "point of the trajectory")
    return figure


def _portrait(problem, item):
    if problem not in PORTRAITS:
        raise LiveError(f"problem {problem} moves in no plane; there is {', '.join(PORTRAITS)}")
    items = PORTRAITS[problem]
    if not item:
        return next(iter(items.items()))
    if item not in items:
        raise LiveError(
            f"problem {problem} has no system {item}; "
            + (f"there is {', '.join(items)}" if "" not in items else "it has one only")
        )
    return item, items[item]

"""The values of an `Explorer`, computed in Python.

The static picture is drawn from them, and the tests compare what the browser computes with them.
"""

from dataclasses import dataclass

import numpy as np

__all__ = ["Values", "evaluate"]

#: A series ends where one of its values is larger.
LARGEST = 1e6
#: Steps of Newton's method to an equilibrium.
NEWTON_STEPS = 14


@dataclass(frozen=True)
class Values:
    """Scalars in the order of their declaration, series as arrays of shape (columns, rows)."""

    scalars: list
    series: list


def evaluate(explorer, values=()):
    """Compute all scalars and series.

    Parameters
    ----------
    explorer : Explorer
        The figure.
    values : dict of str to float
        Values of parameters by name; the others have their first values.

    Returns
    -------
    Values
        What was computed.

    Raises
    ------
    ValueError
        If there is no such parameter.
    """
    values = dict(values)
    scalars, series, parameters = [], [], iter(explorer.parameters)
    for step in explorer.steps:
        if step.kind == "parameter":
            parameter = next(parameters)
            scalars.append(float(values.pop(str(parameter.symbol), parameter.value)))
        elif step.kind in SCALARS:
            scalars.append(float(SCALARS[step.kind](step, scalars, series)))
        else:
            series.append(SERIES[step.kind](step, scalars))
    if values:
        raise ValueError(f"values: there is no parameter {', '.join(values)}")
    return Values(scalars, series)


def _quantity(step, v, series):
    return step.formulas["value"][0](v)


def _over_rows(step, v, series):
    return step.formulas["value"][0](v, series[step.constants["series"]])


def _trajectory(step, v):
    from scipy.integrate import solve_ivp

    initial, end = _all(step, "initial", v), float(step.formulas["end"][0](v))
    times = np.linspace(0, end, step.constants["points"] + 1)
    if end == 0:
        return np.vstack([times, np.outer(initial, np.ones_like(times))])

    def rates(t, x):
        return _all(step, "rates", v, [t, *x])

    if not np.isfinite(rates(0, initial)).all():  # outside the domain of the rates
        return np.array([[0, *initial]]).T

    def escapes(t, x):
        return LARGEST - np.abs(x).max()

    escapes.terminal = True
    result = solve_ivp(
        rates, (0, end), initial, "DOP853", times, events=escapes, rtol=1e-10, atol=1e-12
    )
    return np.vstack([result.t, result.y])


def _recursion(step, v):
    data = np.array(step.constants["data"]).reshape(-1, step.constants["steps"] + 1)
    rows = [np.array([0, *_all(step, "initial", v), *data[:, 0]])]
    states = len(step.formulas["initial"])
    for n in range(1, step.constants["steps"] + 1):
        row = [n, *rows[-1][1 : states + 1], *data[:, n]]
        rows.append(np.array([n, *_all(step, "updates", v, row), *data[:, n]]))
    return np.array(rows).T


def _curve(step, v):
    low, high = (float(step.formulas[role][0](v)) for role in ("low", "high"))
    return np.linspace(low, high, step.constants["points"] + 1)[None]


def _roots(step, v):
    roots = np.roots(_all(step, "coefficients", v))
    return np.array([roots.real, roots.imag])


def _equilibria(step, v):
    points = np.array(step.constants["data"])
    size = np.ptp(step.constants["ranges"], axis=1)[:, None]

    def values(role):
        return [formula(v, points) for formula in step.formulas[role]]

    with np.errstate(all="ignore"):
        for _ in range(NEWTON_STEPS):
            (f, g), (a, b, c, d) = values("rates"), values("slopes")
            points = points - np.array([d * f - b * g, a * g - c * f]) / (a * d - b * c)
        low, high = np.transpose(step.constants["ranges"])[..., None]
        found = (np.hypot(*values("rates")) < 1e-9) & ((low <= points) & (points <= high)).all(
            axis=0
        )
    _, first = np.unique(np.round(points / size, 4)[:, found], axis=1, return_index=True)
    return points[:, found][:, first]


def _all(step, role, v, c=()):
    return np.array([float(formula(v, c)) for formula in step.formulas[role]])


SCALARS = {
    "quantity": _quantity,
    "last": lambda *arguments: _over_rows(*arguments)[-1],
    "largest": lambda *arguments: _over_rows(*arguments).max(),
}
SERIES = {
    "trajectory": _trajectory,
    "recursion": _recursion,
    "curve": _curve,
    "table": lambda step, v: np.array(step.constants["data"]),
    "roots": _roots,
    "equilibria": _equilibria,
}

"""What the phase portraits of chapter 1 show: windows, fields, parameters."""

import dataclasses
from dataclasses import dataclass

import numpy as np
import sympy as sp


@dataclass(frozen=True)
class Portrait:
    """What to draw of a problem.

    Attributes
    ----------
    x_range, y_range : (float, float)
        The window.
    field, state : str or callable
        Right-hand side and state variables: names of data, or functions of the data.
    parameters : dict
        (low, high, initial value) of each parameter with a slider, by name.
    constants : dict
        Values of the other symbols, by name.
    """

    x_range: tuple
    y_range: tuple
    field: object = "field"
    state: object = "state"
    parameters: dict = dataclasses.field(default_factory=dict)
    constants: dict = dataclasses.field(default_factory=dict)


def _matrix(name):
    return {"field": lambda data: data[name] * sp.Matrix(PLANE), "state": lambda data: PLANE}


def _oscillator(name):
    """Return the portrait's field and state for an equation that is linear in x''."""

    def rates(data):
        t, x = data["t"], data["x"]
        second = sp.solve(data[name], x.diff(t, 2))[0]
        return [PLANE[1], second.subs(x.diff(t), PLANE[1]).subs(x, PLANE[0])]

    return {"field": rates, "state": lambda data: PLANE}


def _polar(data):
    """Return the field of 1.12 in Cartesian coordinates, x = r cos(phi), y = r sin(phi)."""
    x, y = PLANE
    radius = sp.sqrt(x**2 + y**2)
    radial, angular = (
        data[name].subs(data["r"], radius) for name in ("radial_rate", "angular_rate")
    )
    return [radial * x / radius - angular * y, radial * y / radius + angular * x]


def _heading(data):
    """Return the field of 1.10 for the heading and its rate, at the constant speed V."""
    _alpha, omega = data["heading"]
    return [omega, data["field"][4].subs({data["u_D"]: 0})]


PLANE = sp.symbols("x1 x2", real=True)
GAINS = {"k1": (-4, 4, -2), "k2": (-4, 4, -3)}
PORTRAITS = {
    "1.1": {
        "a": Portrait((-3, 3), (-1.41, 1.41), "a_field", "a_state"),
        "b": Portrait((-3, 6), (-3, 3.5), "b_field", "b_state"),
        "c": Portrait((-3, 4), (-2, 7), "c_field", "c_state"),
    },
    "1.2": {
        "": Portrait(
            (-7.5, 7.5), (-3.4, 3.4), parameters={"delta": (-1, 3, 0.3), "omega": (0.3, 2, 1)}
        )
    },
    "1.3": {
        "": Portrait((-10, 10), (-10, 10), parameters={"b": (-0.1, 0.1, -0.04), "a": (-1, 3, 1)})
    },
    "1.4": {"": Portrait((-3, 3), (-4, 4), parameters={"epsilon": (-2, 3, 0.5)})},
    "1.6": {
        "a": Portrait(
            (-0.8, 3.6),
            (-2, 2.6),
            "a_field",
            parameters={"k": (-1.2, -0.05, -0.3)},
            constants={"Omega": 1},
        ),
        "b": Portrait(
            (-0.8, 3.6),
            (-2, 2.6),
            "b_field",
            parameters={"k": (-1.2, -0.05, -0.3), "k1": (0.05, 2, 0.5)},
            constants={"Omega": 1},
        ),
    },
    "1.7": {
        "": Portrait(
            (0, 10),
            (0, 3),
            lambda data: [data["v"], *data["field"]],
            lambda data: [PLANE[0], data["v"]],
            parameters={"P": (0.5, 4, 2)},
            constants={"m": 1, "g": 1, "k": 0.5},
        )
    },
    "1.8": {
        "": Portrait(
            (-np.pi, np.pi),
            (0.05, 2.6),
            "b_field",
            parameters={"P": (0, 2.5, 0.5), "k": (0, 1, 0.3)},
            constants={"g": 1},
        )
    },
    "1.9": {
        "": Portrait(
            (-np.pi, np.pi),
            (0.05, 2.6),
            parameters={"k": (0, 1, 0.2), "k1": (0.2, 2, 1)},
            constants={"g": 1},
        )
    },
    "1.10": {
        "": Portrait(
            (-2, 2),
            (-2, 2),
            _heading,
            "heading",
            parameters={"V": (-2, 2, 1), "k2": (-2, 2, 1)},
            constants={"k1": 1, "k3": 1},
        )
    },
    "1.11": {
        "": Portrait(
            (0.05, 4),
            (-np.pi, np.pi),
            "plus_field",
            parameters={"ubar": (0.1, 2, 0.6), "b": (0.05, 0.95, 0.5)},
        )
    },
    "1.12": {
        "": Portrait(
            (-1.8, 1.8), (-1.8, 1.8), _polar, lambda data: PLANE, parameters={"u": (0, 5, 3)}
        )
    },
    "1.13": {item: Portrait((-1.8, 1.8), (-1.8, 1.8), f"{item}_field") for item in "abc"},
    "1.14": {
        item: Portrait(
            (-3, 3), (-3, 3), **_oscillator(f"{item}_equation"), parameters={"k": (low, high, at)}
        )
        for item, low, high, at in (
            ("a", -2, 2, -0.5),
            ("b", -2, 2, -0.5),
            ("c", -2, 0.95, -0.5),
            ("d", 0.05, 2, 0.5),
        )
    },
    "1.16": {
        item: Portrait((-3, 3), (-3, 3), **_matrix(f"{item}_matrix"), parameters=GAINS)
        for item in "abcdef"
    },
    "1.17": {
        "": Portrait(
            (-3, 3),
            (-3, 3),
            **_matrix("A"),
            parameters={"epsilon": (-1, 5, 1), "omega2": (-1, 6, 2)},
        )
    },
}

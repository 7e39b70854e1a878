"""The distance to the nearest pair that is not observable, Popov's criterion, while a parameter of
the output moves."""

import numpy as np
import sympy as sp

from trajlib import plotting
from workbook.live.explorers.stage import Explorer, Stage, near, slider
from workbook.live.subjects import LiveError
from workbook.live.worked import Worked

#: The range of the parameter, places of the curve, points of the picture of sigma, and the
#: bracket's width.
RANGE, PLACES, GRID, WITHIN = (-4.0, 4.0), 81, (90, 70), 0.05
REACH = 3.2


def popov_distance(problem="2.5", item="g"):
    """How near the pair A, H(alpha) is to losing a mode: the least of sigma(lambda) over the
    complex plane.

    Left is sigma, the least singular value of (A - lambda E; H), darker where it is smaller, with
    the eigenvalues and the number that the nearest unobservable pair loses; right its least value
    over alpha. `problem`, `item`: one whose data have `A_g` and `H_g` with one parameter: "2.5" g
    to j.
    """
    from trajlib.structure import distance_to_unobservable

    A, output, alpha = _asked(problem, item)
    stage = Stage(2, height=4.8)
    complex_plane, curve = stage.axes
    real, imaginary = np.linspace(-REACH, REACH, GRID[0]), np.linspace(-REACH, REACH, GRID[1])
    points = (real + 1j * imaginary[:, None]).ravel()
    image = stage.moving(
        complex_plane.imshow(
            np.zeros(GRID[::-1]),
            extent=(-REACH, REACH) * 2,
            origin="lower",
            cmap="cividis",
            vmin=-1.5,
            vmax=0.7,
            interpolation="bilinear",
            aspect="auto",
        )
    )
    complex_plane.set(
        xlabel=r"Re $\lambda$",
        ylabel=r"Im $\lambda$",
        title=r"$\log_{10}\,\sigma_{\min}(A - \lambda E;\ H)$",
    )
    stage.figure.colorbar(image, ax=complex_plane)
    values = np.linalg.eigvals(A)
    eigenvalues = stage.line(complex_plane, "x", color="white", markersize=11, markeredgewidth=3)
    eigenvalues.set_data(values.real, values.imag)
    nearest = stage.line(
        complex_plane,
        "o",
        markerfacecolor="none",
        markeredgecolor=plotting.ORANGE,
        markersize=15,
        markeredgewidth=3,
    )
    places = np.linspace(*RANGE, PLACES)
    distances = [distance_to_unobservable(A, output(place), within=0.2).upper for place in places]
    curve.plot(places, distances, "-", color=plotting.BLUE)
    curve.set(
        xlim=RANGE, ylim=(0, 1.1 * max(distances)), xlabel=rf"${sp.latex(alpha)}$", title="distance"
    )
    now = stage.line(curve, "o", color=plotting.ORANGE, markersize=11)

    def draw(**parameter):
        (value,) = parameter.values()
        H = output(value)
        found = distance_to_unobservable(A, H, within=WITHIN)
        image.set_data(np.log10(_sigma(A, H, points).reshape(GRID[::-1]) + 1e-3))
        pair = np.array([found.eigenvalue, np.conj(found.eigenvalue)])
        nearest.set_data(pair.real, pair.imag)
        now.set_data([value], [found.upper])
        lost = f"{found.eigenvalue.real:.2f}" + (
            f" ± {abs(found.eigenvalue.imag):.2f}i" if abs(found.eigenvalue.imag) > 1e-6 else ""
        )
        return (
            f"the distance is between {found.lower:.3g} and {found.upper:.3g}, proved; the nearest "
            f"pair that is not observable loses {lost}"
        )

    def pointed(axes, stroke):
        if axes is curve:
            (control,) = controls.values()
            control.value = near(control, stroke[-1, 0])

    controls = {alpha.name: slider(alpha.name, *RANGE, 1.0)}
    words = f"problem {problem}, item {item}: crosses are eigenvalues, the circle is what the nearest such pair loses"
    return Explorer(stage, controls, draw, pointed, words=words)


def _sigma(A, H, points):
    """The least singular value at many points; the root of the eigenvalue of the square is good for
    a picture."""
    pencils = A - points[:, None, None] * np.eye(len(A))
    squares = pencils.conj().transpose(0, 2, 1) @ pencils + H.T @ H
    return np.sqrt(np.maximum(np.linalg.eigvalsh(squares)[:, 0], 0))


def _asked(problem, item):
    data = Worked(problem).data
    A, H = data.get(f"A_{item}"), data.get(f"H_{item}")
    parameters = (
        sorted(H.free_symbols, key=str)
        if A is not None and H is not None and not A.free_symbols
        else []
    )
    if len(parameters) != 1:
        raise LiveError(
            f"problem {problem} has no item {item} with numbers A_{item} and one parameter in "
            f"H_{item}; 2.5 has g, h, i, j"
        )
    function = sp.lambdify(parameters, H, "numpy")
    return (
        np.array(A, dtype=float),
        lambda value: np.array(function(value), dtype=float),
        parameters[0],
    )

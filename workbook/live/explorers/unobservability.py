"""Distance to the nearest unobservable pair by the PBH test, over a parameter of the output."""

import numpy as np
import sympy as sp

from trajlib import plotting, structure
from workbook.live.errors import LiveError
from workbook.live.explorers.blitting import BlittedFigure
from workbook.live.explorers.kernel_figure import KernelFigure, nearest_value, slider
from workbook.live.worked_problem import WorkedProblem

#: Range of the parameter, points of the curve, grid of the image of sigma, width of the enclosure.
RANGE, POINTS, GRID, WITHIN = (-4.0, 4.0), 81, (90, 70), 0.05
REACH = 3.2


def distance_to_unobservable(problem="2.5", item="g"):
    """Show the distance of A, H(alpha) to unobservability: the least sigma(lambda) in the plane.

    Left: sigma, the least singular value of (A - lambda I; H), darker where it is smaller, with the
    eigenvalues and the unobservable eigenvalue of the nearest pair. Right: the least value over
    alpha.

    Parameters
    ----------
    problem, item : str
        A problem whose data have a matrix `A_g` and `H_g` with one parameter: "2.5" g to j.

    Raises
    ------
    LiveError
        If there is no such item.
    """

    A, output, alpha = _pair(problem, item)
    figure = BlittedFigure(2, height=4.8)
    complex_plane, curve = figure.axes
    real, imaginary = np.linspace(-REACH, REACH, GRID[0]), np.linspace(-REACH, REACH, GRID[1])
    points = (real + 1j * imaginary[:, None]).ravel()
    image = figure.animate(
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
        title=r"$\log_{10}\,\sigma_{\min}(A - \lambda I;\ H)$",
    )
    figure.figure.colorbar(image, ax=complex_plane)
    spectrum = np.linalg.eigvals(A)
    eigenvalues = figure.line(complex_plane, "x", color="white", markersize=11, markeredgewidth=3)
    eigenvalues.set_data(spectrum.real, spectrum.imag)
    nearest = figure.line(
        complex_plane,
        "o",
        markerfacecolor="none",
        markeredgecolor=plotting.ORANGE,
        markersize=15,
        markeredgewidth=3,
    )
    values = np.linspace(*RANGE, POINTS)
    distances = [
        structure.distance_to_unobservable(A, output(value), within=0.2).upper for value in values
    ]
    curve.plot(values, distances, "-", color=plotting.BLUE)
    curve.set(
        xlim=RANGE, ylim=(0, 1.1 * max(distances)), xlabel=rf"${sp.latex(alpha)}$", title="distance"
    )
    current = figure.line(curve, "o", color=plotting.ORANGE, markersize=11)

    def draw(**parameter):
        (value,) = parameter.values()
        H = output(value)
        result = structure.distance_to_unobservable(A, H, within=WITHIN)
        image.set_data(np.log10(_sigma(A, H, points).reshape(GRID[::-1]) + 1e-3))
        pair = np.array([result.eigenvalue, np.conj(result.eigenvalue)])
        nearest.set_data(pair.real, pair.imag)
        current.set_data([value], [result.upper])
        eigenvalue = f"{result.eigenvalue.real:.2f}" + (
            f" ± {abs(result.eigenvalue.imag):.2f}i" if abs(result.eigenvalue.imag) > 1e-6 else ""
        )
        return (
            f"the distance is between {result.lower:.3g} and {result.upper:.3g}, proved; the nearest "
            f"unobservable pair has the unobservable eigenvalue {eigenvalue}"
        )

    def on_stroke(axes, points):
        if axes is curve:
            (control,) = controls.values()
            control.value = nearest_value(control, points[-1, 0])

    controls = {alpha.name: slider(alpha.name, *RANGE, 1.0)}
    title = (
        f"problem {problem}, item {item}: crosses are eigenvalues, the circle is the unobservable "
        "one of the nearest pair"
    )
    return KernelFigure(figure, controls, draw, on_stroke, title=title)


def _sigma(A, H, points):
    """Return the least singular value at many points, to the accuracy of a picture."""
    pencils = A - points[:, None, None] * np.eye(len(A))
    squares = pencils.conj().transpose(0, 2, 1) @ pencils + H.T @ H
    return np.sqrt(np.maximum(np.linalg.eigvalsh(squares)[:, 0], 0))


def _pair(problem, item):
    data = WorkedProblem(problem).data
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

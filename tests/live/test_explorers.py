"""Explorers: the mathematics, sliders and clicks, and messages on bad input."""

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad_vec
from scipy.linalg import expm

from trajlib import stability
from workbook.display.explorer.evaluation import evaluate
from workbook.live import LiveError
from workbook.live.explorers import (
    circle_synthesis,
    distance_to_unobservable,
    explore,
    fastest_motion,
    list_explorers,
    manual_control,
    phase_portrait,
    pole_zero_cancellation,
    region_of_stability,
)
from workbook.live.explorers.blitting import BlittedFigure
from workbook.live.explorers.by_name import NAMES
from workbook.live.explorers.circle import STEP
from workbook.live.explorers.kernel_figure import KernelFigure, slider
from workbook.live.explorers.portraits import PORTRAITS
from workbook.live.worked_problem import WorkedProblem


def text(explorer):
    return explorer._text.value


def picture(explorer):
    return bytes(explorer._image.value)


def stroke(explorer, axes, points):
    """Pull the pointer over points of some axes, as the layer in the page tells it."""
    size = explorer.figure.figure.bbox.size
    fractions = axes.transData.transform(points) / size
    explorer._pointer.value = " ".join(
        [str(explorer.frames), *(f"{number:.5f}" for number in fractions.ravel())]
    )


def sentence(figure, **values):
    """What an explorer of formulas says for values of its parameters."""
    return figure.sentences[0].text(evaluate(figure, values).scalars)


def test_roots_follow_the_parameters():
    figure = region_of_stability("1.15", "a")
    for k1, k2, stable in ((2.5, 1.5, True), (2.5, 0.3, False), (0.5, 1, False)):
        values = evaluate(figure, {"k1": k1, "k2": k2})
        expected = np.roots([1, k1, k2, 1])
        assert values.series[0][0].max() == pytest.approx(expected.real.max())
        (region,) = (part for part in figure.panels[0].parts if part.kind == "region")
        assert bool(region.formulas["condition"][0](values.scalars, [k1, k2])) == stable
        assert sentence(figure, k1=k1, k2=k2).startswith("All" if stable else "Not all")


@pytest.mark.slow
@pytest.mark.parametrize("problem", PORTRAITS)
def test_every_portrait_follows_its_parameters(problem):
    for item, portrait in PORTRAITS[problem].items():
        explorer = phase_portrait(problem, item)
        for name, (low, high, _) in portrait.parameters.items():
            explorer.set(**{name: (low + high) / 2})
            middle = picture(explorer)
            explorer.set(**{name: low + 0.9 * (high - low)})
            assert picture(explorer) != middle, f"{problem} {item} {name}"
        assert explorer.error.value == ""


def test_every_planar_problem_of_chapter_1_has_a_portrait():
    others = {"1.5": "six dimensions", "1.15": "third order", "1.18": "third order"}
    assert set(PORTRAITS) | set(others) == {f"1.{k}" for k in range(1, 19)}


def test_equilibria_are_those_of_the_library():
    data = WorkedProblem("1.6").data
    field = data["b_field"]
    k, k1, Omega = (
        next(s for s in field[1].free_symbols if s.name == name) for name in ("k", "k1", "Omega")
    )
    explorer = phase_portrait("1.6", "b")
    for value, gain in ((-0.3, 0.5), (-0.6, 1.0), (-0.9, 0.5)):
        explorer.set(k=value, k1=gain)
        # sin 2 phi = 4 k/3, as the right-hand side says
        double = np.arcsin(4 * value / 3) if value > -0.75 else np.nan
        angles = [
            base + n * np.pi for n in (-1, 0, 1) for base in (double / 2, np.pi / 2 - double / 2)
        ]
        matrices = [
            sp.Matrix(field)
            .jacobian(data["state"])
            .subs({k: value, k1: gain, Omega: 1, data["phi"]: angle})
            for angle in angles
            if -0.8 <= angle <= 3.6
        ]
        kinds = [str(stability.classify_planar(matrix)) for matrix in matrices]
        line = text(explorer)
        saddles, stable = (
            sum(kind.startswith(word) for kind in kinds) for word in ("saddle", "stable")
        )
        assert f"{saddles} saddle" in line if saddles else "saddle" not in line
        assert f"{stable} stable" in line if stable else "none" in line


def test_a_click_draws_the_motion_through_it():
    explorer = phase_portrait("1.4")
    before = picture(explorer)
    stroke(explorer, explorer.figure.axes[0], [(1, 1)])
    assert picture(explorer) != before
    explorer.set(epsilon=2.96)  # backwards this is so stiff that the line ends early
    stroke(explorer, explorer.figure.axes[0], [(-1.8, 1.6)])
    for line in explorer.figure.axes[0].lines:
        x, y = line.get_data()
        assert (
            np.isfinite(x).all() and np.abs(x).max(initial=0) < 10 and np.abs(y).max(initial=0) < 10
        )


def test_ellipses_of_problem_2_27_are_those_of_the_gramians():
    figure, data = pole_zero_cancellation(), WorkedProblem("2.27").data
    A = np.array(data["A"], dtype=float)
    for alpha, beta in ((0.5, 2.0), (-2.0, 0.75)):
        B, H = (
            np.array(data[name].subs({data["alpha"]: alpha, data["beta"]: beta}), dtype=float)
            for name in "BH"
        )
        for panel, matrix, column, size in (
            (figure.panels[0], A, B, 1),
            (figure.panels[1], A.T, H.T, 10),
        ):
            gramian = quad_vec(
                lambda t: expm(matrix * t) @ column @ (expm(matrix * t) @ column).T, 0, 3
            )[0]
            values = evaluate(figure, {"alpha": alpha, "beta": beta})
            line = next(part for part in panel.parts if part.kind == "line")
            points = np.array(
                [
                    line.formulas[role][0](values.scalars, values.series[line.series])
                    for role in "xy"
                ]
            )
            form = np.linalg.inv(gramian) if size == 1 else gramian
            forms = size**2 * np.einsum("in,ij,jn->n", points, form, points)
            assert forms == pytest.approx(1, abs=1e-8)


def test_uncontrollable_modes_of_problem_2_27():
    figure = pole_zero_cancellation()
    for beta in (0, 1):
        assert "uncontrollable" in sentence(figure, alpha=-1.5, beta=beta)
    assert "unobservable" in sentence(figure, alpha=-1, beta=2)
    assert "No mode is cancelled" in sentence(figure, alpha=-1.05, beta=2)
    with pytest.raises(LiveError, match="there is no parameter gamma; there is alpha, beta"):
        explore("pole_zero_cancellation gamma=1")


def test_distance_vanishes_for_an_unobservable_pair():
    explorer = distance_to_unobservable("2.5", "g")
    data = WorkedProblem("2.5").data
    from trajlib.structure import observability

    for alpha in (-1, 1):
        explorer.set(alpha=alpha)
        unobservable = not observability(data["A_g"], data["H_g"].subs(data["alpha"], alpha)).holds
        assert ("between 0 and" in text(explorer)) == unobservable


def test_a_value_that_is_set_is_not_kept_for_the_next_time():
    first = explore("pole_zero_cancellation alpha=1.5")
    second = explore("pole_zero_cancellation")
    assert [evaluate(figure).scalars[0] for figure in (first, second)] == [1.5, 0.5]
    assert first.steps is second.steps  # compiled once


@pytest.mark.parametrize("R", [0.7, 1.6, 2.6])
def test_times_to_the_circle_are_those_of_the_reachable_set(R):
    """Compare times with those at which the reachable set meets or leaves the disc."""
    initial_states = np.array(
        [0.2 + 0.1j, -0.3 - 0.35j, 0.5j * R, 0.8 * R, 1.5 * R + 0.5j, -2.5 - 2j, 4.1 + 0.3j]
    )
    figure = circle_synthesis()
    times = [
        evaluate(figure, {"x1": state.real, "x2": state.imag, "R": R}).series[0][-1][-1]
        for state in initial_states
    ]
    angle = np.linspace(0, 2 * np.pi, 361)
    steps = np.linspace(0, 12, 2401)
    # psi at the end; before it the costate was turned on, and its second component drives
    drive = np.abs(np.sin(angle[None, :] + steps[:, None]))
    spread = np.vstack([np.zeros(361), np.cumsum((drive[1:] + drive[:-1]) / 2, axis=0) * steps[1]])
    for state, time in zip(initial_states, times):
        centre = np.real(state * np.exp(-1j * steps[:, None]) * np.exp(-1j * angle[None, :]))
        arrived = (
            (centre - spread).max(axis=1) <= R
            if abs(state) > R
            else (centre + spread).max(axis=1) >= R
        )
        assert abs(steps[np.argmax(arrived)] - time) < 2 * STEP, state


def test_drawing_the_optimal_control_gives_the_optimal_energy():
    explorer = manual_control()
    explorer.set(best_arcs=1)
    best = 24.5  # half of (3 + 2*2)**2: each half turn adds 2 to the amplitude
    assert f"{best:.2f} is the best" in text(explorer)
    axes = explorer.figure.axes[0]
    # beyond the bounds: held at them
    stroke(explorer, axes, [(0.01, -1.1), (3.13, -1.1), (3.15, 1.1), (6.28, 1.1)])
    by_hand = float(text(explorer).split("at the end: ")[1].split()[0])
    assert best - 0.15 < by_hand <= best
    stroke(explorer, axes, [(0.01, 0.2), (6.28, 0.2)])
    assert float(text(explorer).split("at the end: ")[1].split()[0]) < 10


def test_fastest_motion_ends_at_rest_and_switches_with_the_costate():
    figure = fastest_motion()
    path, costate, control = (
        part
        for panel in figure.panels
        for part in panel.parts
        if part.kind == "line" and part.style != "dashed"
    )
    for x, v in ((1, 0), (-1.2, 0.7), (0.4, -1.3)):
        values = evaluate(figure, {"x1": x, "x2": v})
        times = values.series[0][0]

        def along(part, role):
            return np.array([part.formulas[role][0](values.scalars, [t]) for t in times], float)

        first = -1 if x + v * abs(v) / 2 > 0 else 1
        assert times[-1] == pytest.approx(2 * np.sqrt(v * v / 2 - first * x) - first * v, abs=1e-6)
        states = np.array([along(path, "x"), along(path, "y")])
        assert states[:, 0] == pytest.approx([x, v]) and states[:, -1] == pytest.approx(0, abs=1e-9)
        psi, u = along(costate, "y"), along(control, "y")
        away = np.abs(psi) > 0.05
        assert (np.sign(psi[away]) == u[away]).all()
        # the equations of the motion, by differences
        middle = away[1:] & away[:-1] & (u[1:] == u[:-1])
        rates = np.diff(states) / np.diff(times)
        assert rates[1][middle] == pytest.approx(u[1:][middle])
        speeds = (states[1][1:] + states[1][:-1]) / 2
        assert rates[0][middle] == pytest.approx(speeds[middle])


@pytest.mark.parametrize(
    "line, message",
    [
        (
            "regoin_of_stability",
            "there is no explorer regoin_of_stability; did you mean region_of_stability?",
        ),
        ("region_of_stability 1.4", "has no item a with a polynomial"),
        ("region_of_stability 9.9", "no problem 9.9"),
        ("region_of_stability 1.15 a k1=7", "k1: expected a number from -2 to 4, got 7"),
        ("region_of_stability 1.15 a k9=1", "there is no parameter k9; there is k1, k2"),
        ("phase_portrait 1.4 epsilon=7", "epsilon = 7: it goes from -2 to 3 here"),
        ("phase_portrait 1.4 k9=1", "there is no parameter k9; there is epsilon"),
        ("phase_portrait 1.4 epsilon=much", "epsilon: expected a number, got much"),
        ("region_of_stability 1.15 a k1=much", "k1: expected a number, got much"),
        ("phase_portrait 1.15", "moves in no plane"),
        ("phase_portrait 1.4 b", "it has one only"),
        ("phase_portrait 1.1 z", "there is a, b, c"),
        ("pole_zero_cancellation 2.27", "takes no problem"),
        ("distance_to_unobservable 2.5 a", "2.5 has g, h, i, j"),
        ("fastest_motion 5.3", "takes no problem"),
    ],
)
def test_bad_input_ends_in_one_line(line, message):
    with pytest.raises(LiveError) as raised:
        explore(line)
    assert message in str(raised.value) and "\n" not in str(raised.value)
    # in a cell without a magic, too
    assert raised.value._render_traceback_() == [str(raised.value)]


def send(widget, **state):
    """Change a widget as the page does."""
    widget._handle_msg({"content": {"data": {"method": "update", "state": state}}})


def test_an_error_of_a_callback_is_one_line_in_the_explorer(capsys, caplog):
    failing = {"draw": False, "stroke": False}

    def draw(x):
        if failing["draw"]:
            raise TypeError("no <number>\nbut a list")
        return f"x = {x:g}"

    def on_stroke(axes, points):
        if failing["stroke"]:
            raise LiveError("press inside the circle")

    explorer = KernelFigure(BlittedFigure(1), {"x": slider("x", 0, 1, 0.5)}, draw, on_stroke)
    (axes,) = explorer.figure.axes
    message = "this does not work: TypeError: no &lt;number&gt;"
    failing["draw"] = True
    send(explorer.controls["x"], value=0.25)
    assert message in explorer.error.value and "but a list" not in explorer.error.value
    failing.update(draw=False, stroke=True)
    send(explorer.controls["x"], value=0.75)
    assert explorer.error.value == "" and "0.75" in text(explorer)
    stroke(explorer, axes, [(0.5, 0.5)])
    assert ">press inside the circle<" in explorer.error.value
    send(explorer._pointer, value="not a number")
    assert "this does not work: ValueError" in explorer.error.value
    failing.update(draw=True, stroke=False)  # the stroke succeeds, the frame does not
    stroke(explorer, axes, [(0.5, 0.5)])
    assert message in explorer.error.value
    assert capsys.readouterr().err == "" and not caplog.records


def test_the_list_names_every_explorer():
    assert [line.split()[1] for line in list_explorers().splitlines()] == list(NAMES)


def test_the_regions_of_the_circle_synthesis_are_symmetric():
    figure = explore("circle_synthesis R=2.6")
    (region,) = (part for part in figure.panels[0].parts if part.kind == "region")
    scalars = evaluate(figure).scalars

    def filled(x, y):
        return bool(region.formulas["condition"][0](scalars, [x, y]))

    for x, y in ((0.5, 0.2), (1.4, 1.1), (3.3, 0.2), (-4, 2)):
        assert filled(x, y) != filled(-x, -y)

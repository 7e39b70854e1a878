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
from workbook.live.explorers.by_name import NAMES
from workbook.live.explorers.circle import STEP
from workbook.live.explorers.portraits import PORTRAITS
from workbook.live.worked_problem import WorkedProblem


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


def along(part, values, role):
    return part.formulas[role][0](values.scalars, values.series[part.series])


@pytest.mark.slow
@pytest.mark.parametrize("problem", PORTRAITS)
def test_every_portrait_follows_its_parameters(problem):
    for item, portrait in PORTRAITS[problem].items():
        figure = phase_portrait(problem, item)
        (field,) = (part for part in figure.panels[0].parts if part.kind == "field")
        x, y = np.meshgrid(
            *(np.linspace(*ends, 9) for ends in (portrait.x_range, portrait.y_range))
        )
        for k, (name, (low, high, _)) in enumerate(portrait.parameters.items()):
            assert str(figure.parameters[k].symbol) == name
            scalars = [parameter.value for parameter in figure.parameters]
            rates = []
            for value in ((low + high) / 2, low + 0.9 * (high - low)):
                scalars[k] = value
                rates.append([field.formulas[role][0](scalars, [x, y]) for role in "xy"])
            assert not np.allclose(*rates, equal_nan=True), f"{problem} {item} {name}"
        assert figure.plot() is not None


def test_every_planar_problem_of_chapter_1_has_a_portrait():
    others = {"1.5": "six dimensions", "1.15": "third order", "1.18": "third order"}
    assert set(PORTRAITS) | set(others) == {f"1.{k}" for k in range(1, 19)}


def test_equilibria_are_those_of_the_library():
    data = WorkedProblem("1.6").data
    field = data["b_field"]
    k, k1, Omega = (
        next(s for s in field[1].free_symbols if s.name == name) for name in ("k", "k1", "Omega")
    )
    figure = phase_portrait("1.6", "b")
    marks = {part.label: part for part in figure.panels[0].parts if part.kind == "marks"}
    for value, gain in ((-0.3, 0.5), (-0.6, 1.0), (-0.9, 0.5)):
        values = evaluate(figure, {"k": value, "k1": gain})
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
        for word in ("saddle", "stable", "unstable"):
            shown = np.isfinite(along(marks[word], values, "x")).sum()
            assert shown == sum(kind.startswith(word) for kind in kinds), (value, word)


def test_a_trajectory_passes_its_point_both_ways_at_any_speed():
    figure = phase_portrait("1.4")
    x, y = (str(parameter.symbol) for parameter in figure.parameters[1:])
    backwards, forwards = (part for part in figure.panels[0].parts if part.kind == "line")
    values = evaluate(figure, {"epsilon": 0.3, x: 1, y: 1})
    for part in (backwards, forwards):
        assert [along(part, values, role)[0] for role in "xy"] == [1, 1]
    # the limit cycle of van der Pol's equation has the amplitude 2.00 at this epsilon
    assert np.abs(along(forwards, values, "x")[-900:]).max() == pytest.approx(2, abs=0.01)
    assert [along(backwards, values, role)[-1] for role in "xy"] == pytest.approx([0, 0], abs=0.02)
    # where the equation is stiff, lines are finite and stay in sight of the window
    values = evaluate(figure, {"epsilon": 2.96, x: -1.8, y: 1.6})
    for part in (backwards, forwards):
        line = np.array([along(part, values, role) for role in "xy"])
        assert np.isfinite(line).all() and np.abs(line).max() < 120


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
    figure = distance_to_unobservable("2.5", "g")
    data = WorkedProblem("2.5").data
    from trajlib.structure import observability

    for alpha in (-1, 1):
        unobservable = not observability(data["A_g"], data["H_g"].subs(data["alpha"], alpha)).holds
        assert ("between 0 and" in sentence(figure, alpha=alpha)) == unobservable


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


@pytest.mark.parametrize("item, alpha", [("g", 0.5), ("h", -0.7), ("i", 2), ("j", 1.3)])
def test_the_region_of_sigma_is_that_of_the_singular_values(item, alpha):
    figure = distance_to_unobservable("2.5", item)
    data = WorkedProblem("2.5").data
    A, H = (
        np.array(data[name].subs(data["alpha"], alpha), float)
        for name in (f"A_{item}", f"H_{item}")
    )
    (region,) = (part for part in figure.panels[0].parts if part.kind == "region")
    plane = np.random.default_rng(0).uniform(-3.2, 3.2, (2, 300))
    least = np.array(
        [
            np.linalg.svd(np.vstack([A - (p + 1j * q) * np.eye(len(A)), H]))[1][-1]
            for p, q in plane.T
        ]
    )
    level = np.median(least)
    values = evaluate(figure, {"alpha": alpha, "level": level})
    inside = region.formulas["condition"][0](values.scalars, plane)
    apart = np.abs(least - level) > 1e-6
    assert (inside == (least < level))[apart].all() and inside.any() and not inside.all()


def test_setting_the_optimal_control_gives_the_optimal_energy():
    figure = manual_control()
    best = 24.5  # half of (3 + 2*2)**2: each half turn adds 2 to the amplitude
    optimal = {f"u{k}": -1 if k <= 4 else 1 for k in range(1, 9)}
    said = sentence(figure, **optimal, best_arcs=1)
    assert said == f"Energy at the end: {best} by hand, {best:.2f} is the best."
    assert sentence(figure) == "Energy at the end: 4.5 by hand."
    lines = [part for part in figure.panels[1].parts if part.kind == "line"]
    values = evaluate(figure, optimal | {"best_arcs": 1})
    by_hand, optimum = (np.array([along(line, values, role) for role in "xy"]) for line in lines)
    assert by_hand == pytest.approx(optimum, abs=1e-6)
    assert np.isnan(along(lines[1], evaluate(figure), "x")).all()


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
        ("phase_portrait 1.4 epsilon=7", "epsilon: expected a number from -2 to 3, got 7"),
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

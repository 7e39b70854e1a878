"""Problems with path constraints, terminal inequalities and state-dependent bounds."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from optimal_control_records import (
    CONSTRAINED,
    INTEGRATED,
    bryson_denham,
    double_integrator,
    record,
)
from scipy.integrate import solve_ivp

from trajlib.pontryagin import (
    Chattering,
    Infeasible,
    NotConverged,
    NotUnique,
    Problem,
    certify,
    synthesis,
)

R = sp.Rational
x, v, w, t, h, m, u = sp.symbols("x v w t h m u")
GODDARD = record("Goddard with a speed limit")


def validate(record):
    """Compare the extremal of a record with its second route and with what is printed."""
    extremal = record.problem.solve()
    assert record.arcs is None or [kind for kind, _, _ in extremal.arcs] == record.arcs
    assert abs(extremal.cost - float(record.cost)) <= record.tolerance * (1 + abs(record.cost))
    if record.times is not None:
        expected = np.array(record.times, dtype=float)
        assert np.allclose(extremal.switching_times, expected, rtol=0, atol=record.tolerance)
    for _, value, tolerance in record.published:
        assert abs(extremal.cost - value) <= tolerance
    for _, value in record.refuted:
        assert abs(extremal.cost - value) > 1e-3
    assert extremal.certificate().holds(1e-10)


@pytest.mark.parametrize("name", CONSTRAINED)
def test_record(name):
    validate(record(name))


@pytest.mark.slow
@pytest.mark.parametrize("name", INTEGRATED)
def test_record_by_integration(name):
    validate(record(name))


def test_goddard_as_published():
    extremal = GODDARD.problem.solve()
    published = [0.02350968, 0.05973738, 0.10157134]
    assert np.allclose(extremal.switching_times, published, rtol=0, atol=1.5e-8)
    assert abs(extremal.duration - 0.2020474405) < 1e-10


@pytest.mark.parametrize(
    ("limit", "jumps"), [(R(1, 5), [48 * (1 - R(4, 5))]), (R(1, 9), [18, 18]), (R(1, 6), [16])]
)
def test_jumps_of_the_costate(limit, jumps):
    """nu = 48 (1 - 4 l) at a touch point, 2/(9 l^2) at both ends of a boundary arc."""
    extremal = bryson_denham(limit).problem.solve()
    assert np.allclose([nu for _, _, nu in extremal.jumps], np.array(jumps, float), rtol=1e-10)
    assert extremal.optimality.proved
    assert np.allclose(extremal.path_multiplier(np.linspace(0, 1, 11)), 0)


def test_extremals_on_a_boundary_are_not_called_minimal():
    """Without a theorem nothing is claimed beyond the necessary conditions, and all say so."""
    extremal = GODDARD.problem.solve()
    for text in (str(extremal.optimality), extremal.certificate()._repr_markdown_()):
        assert "not tested along the boundary" in text and "locally minimal" not in text
    assert extremal.optimality.kind == "extremal" and "extremal, best of" in repr(extremal)


def test_multiplier_along_a_boundary_arc():
    """x = 1/2 held: psi = u = 0, and psi' = x + eta (-1) gives eta = 1/2."""
    extremal = CONSTRAINED["boundary to the end"].problem.solve()
    assert np.allclose(extremal.path_multiplier([1.0, 2.0, 2.9]), [[0, 0.5, 0.5]], atol=1e-10)


@pytest.mark.parametrize("factor", [R(1, 10**4), 10**4])
def test_other_units(factor):
    """Lengths in other units: the same arcs, the cost times the square of the factor."""
    problem = Problem(
        {x: v, v: u},
        {u: None},
        {x: 0, v: factor},
        {x: 0, v: -factor},
        running=u**2 / 2,
        duration=1,
        path=[x <= factor / 9],
    )
    extremal = problem.solve()
    assert abs(extremal.cost / factor**2 - 4) < 1e-9
    assert np.allclose(extremal.switching_times, [1 / 3, 2 / 3], atol=1e-9)
    assert np.allclose([float(nu / factor) for _, _, nu in extremal.jumps], 18)
    assert extremal.certificate().holds()


def test_inactive_constraint():
    free = double_integrator(terminal={x: 1, v: 0})
    limited = double_integrator(terminal={x: 1, v: 0}, path=[v <= 2])
    assert abs(limited.solve().cost - free.solve().cost) < 1e-14
    assert not limited.solve().touches_boundary


def test_conditions():
    problem = bryson_denham(R(1, 9)).problem
    (constraint,) = problem.conditions().path
    psi1, psi2 = problem.conditions().costate
    assert constraint.order == 2
    assert constraint.derivatives == (x - R(1, 9), v, u)
    assert constraint.boundary_control == {u: 0}
    assert constraint.conditions == (psi2, -psi1)
    assert constraint.density == 0
    assert constraint.adjoint[psi1] == constraint.multiplier
    shown = problem.conditions()._repr_markdown_()
    assert "of order $p = 2$" in shown and r"\nu \ge 0" in shown


def test_conditions_of_goddard():
    """v = 1/10: thrust is drag plus weight."""
    (constraint,) = GODDARD.problem.conditions().path
    assert constraint.order == 1
    force = 310 * v**2 * sp.exp(500 - 500 * h) + m / h**2
    assert sp.simplify(constraint.boundary_control[u] * R(7, 2) - force) == 0


def test_certificate_finds_what_is_wrong():
    """Each condition of a constraint has a trajectory that violates it alone."""
    problem = Problem({x: u}, {u: (-1, 1)}, {x: 0}, running=x, duration=2, path=[x >= -1])
    sections = [1.0]

    def state(s):
        return [np.maximum(-s, -1.0)]

    def control(s):
        return [np.where(s < 1, -1.0, 0.0)]

    def costate(s):
        return [np.where(s < 1, s - 1, 0.0)]

    def failures(q=state, p=costate, r=control, problem=problem):
        return certify(problem, q, p, r, 2, sections).failures()

    assert failures() == []
    assert failures(problem=Problem(**arguments(problem, path=[x >= -R(1, 2)]))) == [
        "adjoint",
        "path",
    ]
    # eta < 0: for the opposite cost the state is not to be kept at the boundary.
    opposite = Problem(**arguments(problem, running=-x))
    assert "sign" in failures(p=lambda s: [0 * s], problem=opposite)
    # A costate that jumps where no constraint is active.
    assert (
        "jumps"
        in certify(
            problem,
            state,
            lambda s: [np.where(s < 0.5, s - 2, costate(s)[0])],
            control,
            2,
            [0.5, 1.0],
        ).failures()
    )


def arguments(problem, **changed):
    names = ("dynamics", "controls", "initial", "running", "duration", "path")
    return {name: getattr(problem, name) for name in names} | changed


def test_certificate_between_grid_points():
    """A narrow peak of the state between all samples is found."""
    problem = Problem({x: u}, {u: None}, {x: 0}, running=u**2, duration=1, path=[x <= R(1, 2)])

    def state(s):
        return [0.5 + 1e-3 - 2 * (s - 0.50321) ** 2]

    evidence = certify(problem, state, lambda s: [0 * s], lambda s: [-4 * (s - 0.50321)], 1)
    assert abs(evidence.path - 1e-3) < 1e-9


@pytest.mark.parametrize(
    ("error", "text", "arguments"),
    [
        (TypeError, "path: expected inequalities", {"path": [x]}),
        (TypeError, "path: expected inequalities", {"path": [sp.Eq(x, 1)]}),
        (TypeError, "path: expected inequalities", {"path": [x < 1]}),
        (TypeError, "path: expected a list", {"path": "x <= 1"}),
        (ValueError, "path: .* does not depend on the state", {"path": [t <= 1]}),
        (ValueError, "path: .* is a second upper bound of u", {"path": [u <= x]}),
        (ValueError, "path: .* is a second lower bound of u", {"path": [u**2 + x**2 <= 1]}),
        (ValueError, "path: .* neither a constraint", {"path": [u**2 + x**2 >= 1]}),
        (ValueError, "path: .* neither a constraint", {"path": [u**3 + u + x <= 1]}),
        (
            ValueError,
            "first_return: not provided",
            {"path": [v <= 1], "terminal": [x], "first_return": True},
        ),
        (ValueError, "path: .* is not smooth", {"path": [sp.Max(x, v) <= 1]}),
        (ValueError, "path: .* is a second upper bound of u", {"path": [sp.exp(u) + x <= 3]}),
        (ValueError, "neither a constraint .* nor one", {"path": [u * x <= 2]}),
        (ValueError, "path: .* are the same inequality", {"path": [x <= 1, x <= 1]}),
        (ValueError, "path: .* are the same inequality", {"path": [x <= 1, 2 * x <= 2]}),
        (ValueError, "terminal: .* contains a control", {"terminal": [x - 1, u <= 1]}),
    ],
)
def test_statements_that_are_refused(error, text, arguments):
    with pytest.raises(error, match=text):
        double_integrator(**{"terminal": {x: 1, v: 0}} | arguments)


def test_constraints_that_are_solved_for_the_control():
    rest = {x: 0, v: 0}, {x: 1, v: 0}
    # v = sin t up to the middle, where 1 - cos t = 1/2
    disc = Problem({x: v, v: u}, {u: None}, *rest, path=[u**2 + v**2 <= 1])
    assert disc.controls[u] == (-sp.sqrt(1 - v**2), sp.sqrt(1 - v**2))
    assert disc.solve().duration == pytest.approx(2 * np.pi / 3, abs=1e-10)
    factor = Problem({x: v, v: u}, {u: (-1, None)}, *rest, path=[u * (1 + v**2) <= 1])
    assert factor.controls[u] == (-1, 1 / (1 + v**2))
    growing = Problem({x: v, v: u}, {u: (-1, None)}, *rest, path=[sp.exp(u) + v <= 2])
    extremal = growing.solve()
    motion = solve_ivp(
        lambda _, y: [y[1], np.log(2 - y[1])],
        (0, extremal.switching_times[0]),
        [0, 0],
        rtol=1e-12,
        atol=1e-13,
    )
    position, velocity = motion.y[:, -1]
    assert position + velocity**2 / 2 == pytest.approx(1, abs=1e-9)
    assert extremal.duration - extremal.switching_times[0] == pytest.approx(velocity, abs=1e-9)
    assert extremal.certificate().holds(1e-10)


@pytest.mark.parametrize(
    ("error", "text", "problem"),
    [
        (
            Infeasible,
            "initial state violates",
            double_integrator(terminal=[x - 1], path=[x >= R(1, 2)]),
        ),
        (
            Infeasible,
            "final state violates",
            double_integrator(terminal=[x - 1], path=[x <= R(1, 2)]),
        ),
        (
            Chattering,
            "order 3",
            Problem(
                {x: v, v: w, w: u},
                {u: None},
                {x: 1, v: -2, w: 0},
                running=x + u**2 / 2,
                duration=10,
                path=[x >= 0],
            ),
        ),
        (
            NotUnique,
            "followed at once, .* their multipliers are not unique",
            Problem(
                {x: u},
                {u: None},
                {x: 0},
                running=(x - 2) ** 2 + u**2,
                duration=4,
                path=[x <= 1, x**3 <= 1],
            ),
        ),
        (
            NotUnique,
            "multiplier is not unique",
            Problem({x: u}, {u: (0, 1)}, {x: 0}, running=(x - 2) ** 2, duration=2, path=[x <= 1]),
        ),
        (
            ValueError,
            "depend on the control .* initial state alone decides",
            Problem({x: v, v: -x, w: u}, {u: (0, 1)}, {x: 0, v: 1, w: 0}, [w - 1], path=[x <= 2]),
        ),
    ],
)
def test_problems_that_are_refused(error, text, problem):
    with pytest.raises(error, match=text):
        problem.solve()


k = sp.Symbol("k")
PARAMETER = Problem(
    {x: k + u, k: 0},
    {u: None},
    {x: 0, k: None},
    {x: 1},
    running=u**2 + k**2 / 2,
    duration=1,
    path=[k <= R(1, 2)],
)


@pytest.mark.parametrize(
    ("cost", "problem"),
    [
        # (1 - k)^2 + k^2/2 is least for k = 2/3.
        (R(3, 8), PARAMETER),
        (R(1, 3), replace(PARAMETER, path=[k <= 1], terminal_inequalities=())),
        (
            2,
            Problem(
                {x: k * v, v: k * u, k: 0},
                {u: (-1, 1)},
                {x: 1, v: 0, k: None},
                {x: 0, v: 0},
                final=k,
                running=0,
                duration=1,
                path=[k >= R(1, 10)],
            ),
        ),
        # x' = v, v' = -x keeps the radius, so that x(0) = -2.
        (
            1 - 2 * sp.sin(1),
            Problem(
                {x: v, v: -x, k: u},
                {u: None},
                {x: None, v: 0, k: 0},
                {k: 1},
                running=x + u**2,
                duration=1,
                path=[x**2 + v**2 <= 4],
            ),
        ),
        (
            # d^2/T + 9 T/4 with d = 1/2 is least for T = 1/3.
            R(17, 10),
            Problem(
                {x: u, t: 1},
                {u: None},
                {x: 0, t: 0},
                {x: R(1, 2)},
                running=u**2 + R(9, 4),
                path=[t <= R(1, 5)],
            ),
        ),
        # What a given parameter satisfies is no constraint.
        (
            2,
            Problem(
                {x: k + u, k: 0},
                {u: None},
                {x: 0, k: 1},
                {x: 1},
                running=u**2 + 2 * k**2,
                duration=1,
                path=[k <= 1],
            ),
        ),
    ],
)
def test_constraints_on_parameters_and_time(cost, problem):
    extremal = problem.solve()
    assert not problem.path
    assert extremal.certificate().holds()
    assert abs(extremal.cost - float(cost)) < 1e-9


def test_given_parameter_outside_its_constraint():
    problem = replace(PARAMETER, initial={x: 0, k: 1})
    with pytest.raises(Infeasible, match="initial state violates the constraint k - 1/2 <= 0"):
        problem.solve()


def passing(velocity, *discs):
    """A unit mass passes discs (x, y, radius) with the least energy, with a given initial velocity."""
    y, vx, vy, ux, uy = sp.symbols("y v_x v_y u_x u_y")
    return Problem(
        {x: vx, y: vy, vx: ux, vy: uy},
        {ux: None, uy: None},
        {x: 0, y: 0, vx: velocity[0], vy: velocity[1]},
        {x: 1, y: 0},
        running=(ux**2 + uy**2) / 2,
        duration=1,
        path=[(x - a) ** 2 + (y - b) ** 2 >= r**2 for a, b, r in discs],
    )


@pytest.mark.parametrize("velocity", [(1, R(3, 10)), (1, R(1, 2)), (1, R(2, 5))])
@pytest.mark.parametrize("mirrored", [1, -1])
def test_obstacles_are_passed_on_the_better_side(velocity, mirrored):
    vx, vy = velocity
    problem = passing((vx, mirrored * vy), (R(1, 2), mirrored * R(1, 10), R(1, 4)))
    y = problem.state[1]
    sides = [problem.solve(guess={x: [0, 0.5, 1], y: [0, b, 0]}).cost for b in (0.5, -0.5)]
    assert max(sides) > 1.02 * min(sides)
    assert abs(problem.solve().cost - min(sides)) < 1e-9


def test_two_obstacles_are_passed_on_all_sides():
    problem = passing((1, 0), (R(1, 4), R(1, 20), R(1, 8)), (R(3, 4), -R(1, 20), R(1, 8)))
    assert problem.solve().optimality.processes == 4


def test_given_structures_and_syntheses_are_refused():
    problem = double_integrator(terminal={x: 1, v: 0}, path=[v <= R(1, 2)])
    with pytest.raises(ValueError, match="structure: with path constraints"):
        problem.solve(structure=["u+", "u-"])
    with pytest.raises(ValueError, match="problem: a planar synthesis"):
        synthesis(problem)
    assert not problem.solve().certificate(proved=True).holds


def test_contact_that_steps_pass_over():
    """Braking from v = 1 takes 1/2: no process exists, and none is returned."""
    problem = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 0, v: 1}, {x: 0, v: -1}, path=[x <= R(1, 4)])
    with pytest.raises(NotConverged, match="pass beyond it between them"):
        problem.solve()


def test_extremal_is_shown():
    import matplotlib

    matplotlib.use("agg")
    extremal = CONSTRAINED["limits of speed and acceleration"].problem.solve()
    assert len(extremal.plot()) == 4
    assert "boundary 2" in extremal._repr_markdown_()
    assert "path constraints" in extremal.certificate()._repr_markdown_()

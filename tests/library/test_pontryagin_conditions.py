"""The statement of a problem, and the conditions derived from it."""

import pytest
import sympy as sp

from trajlib.pontryagin import Problem

x, x1, x2, u, v, a, R, A = sp.symbols("x x1 x2 u v a R A")
h, w, m = sp.symbols("h w m")
psi1, psi2, psi3 = sp.symbols("psi1:4", real=True)
lambda0 = sp.Symbol("lambda0", nonnegative=True)
lambda1 = sp.Symbol("lambda1", real=True)
ONE = {u: (-1, 1)}
START = {x1: a, x2: 0}
PLANE = {x1: x2, x2: u}


def test_parameters_and_substitution():
    problem = Problem(PLANE, {u: (-A, A)}, START, [x1**2 + x2**2 - R**2])
    assert problem.parameters == (A, R, a) and problem.time_optimal and problem.free_time
    given = problem.subs({R: 2, A: 0.1})
    assert given.parameters == (a,) and given.terminal == (x1**2 + x2**2 - 4,)
    assert given.controls[u] == (-sp.Rational(1, 10), sp.Rational(1, 10))
    with pytest.raises(ValueError, match="subs: x1 is no parameter"):
        problem.subs({x1: 1})
    with pytest.raises(ValueError, match="solve: no value for a"):
        given.solve()


def test_forms_of_the_arguments():
    one = Problem(PLANE, ONE, START, [x1, x2])
    for terminal in ({x1: 0, x2: 0}, [sp.Eq(x1, 0), sp.Eq(x2, 0)], (x1, x2)):
        assert Problem(PLANE, ONE, START, terminal).terminal == one.terminal
    assert Problem(PLANE, {u: None}, START, [x1]).controls[u] == (-sp.oo, sp.oo)
    assert Problem(PLANE, {u: (0, None)}, START, x1).controls[u] == (0, sp.oo)
    assert Problem(PLANE, ONE, START, [x1], final=x2).running == 0
    assert Problem(PLANE, ONE, START, [x1], duration=(1, 2)).free_time


def test_the_time_is_the_last_state():
    t = sp.Symbol("t")
    given = Problem({x: u + t}, ONE, {x: 0}, {x: 4}, path=[x <= 5 + t], time=t)
    written = Problem({x: u + t, t: 1}, ONE, {x: 0, t: 0}, {x: 4}, path=[x <= 5 + t])
    assert given.state == (x, t) and repr(given) == repr(written)
    assert repr(given.subs({})) == repr(written), "a copy has the time once"


@pytest.mark.parametrize(
    "change, message",
    [
        ({"time": "t"}, "time: expected a symbol, got 't'"),
        ({"time": x1}, "time: x1 is among dynamics already"),
        ({"time": u}, "time: u is among controls already"),
        ({"time": m, "dynamics": [x2]}, "dynamics: expected a dict"),
        ({"dynamics": {}}, "dynamics: expected a dict"),
        ({"dynamics": {x1: "x2", x2: u}}, "dynamics of x1: expected a SymPy expression"),
        ({"controls": {u: (1, -1)}}, "expected lower < upper for u"),
        ({"controls": {u: 1}}, r"expected \(lower, upper\) for u"),
        ({"controls": {u: (-u, 1)}}, "bounds of u contain a control"),
        ({"controls": {v: (-1, 1)}}, "v acts neither"),
        ({"controls": {x1: (-1, 1)}}, "x1 is a state already"),
        ({"initial": {x1: 1}}, "initial: no value for x2; write None"),
        ({"initial": {x1: 1, x2: 0, x: 1}}, "initial: x is no state"),
        ({"initial": {x1: x2, x2: 0}}, "expected numbers or parameters"),
        ({"terminal": [u]}, "terminal: u contains a control"),
        ({"terminal": [R - 1]}, "does not depend on the state"),
        ({"terminal": [x1, x2, x1 - x2]}, "3 equations for 2 states"),
        ({"terminal": 3}, "terminal: expected a list"),
        ({"terminal": []}, "something must end the process"),
        ({"running": 0}, "both are zero"),
        ({"final": u}, "final: u contains a control"),
        ({"duration": -1}, "duration: expected a positive number"),
        ({"duration": (2, 1)}, "shortest < longest"),
        ({"maximise": 1}, "maximise: expected True or False"),
        ({"first_return": True}, "first_return: expected one terminal equation"),
    ],
)
def test_invalid_arguments(change, message):
    arguments = {
        "dynamics": PLANE,
        "controls": ONE,
        "initial": START,
        "terminal": [x1, x2],
    } | change
    with pytest.raises((TypeError, ValueError), match=message):
        Problem(**arguments)


def test_conditions_of_example_1():
    """Without the additional states of the book: psi_0 = -lambda_0 there, H here is the rest."""
    derived = Problem(PLANE, ONE, {x1: 0, x2: 0}, [x2], running=x1, duration=1).conditions()
    assert derived.hamiltonian == psi1 * x2 + psi2 * u - lambda0 * x1
    assert derived.adjoint == {psi1: lambda0, psi2: -psi1}
    assert derived.switching == {u: psi2}
    assert derived.maximising[u].subs(psi2, 3) == 1 and derived.maximising[u].subs(psi2, -3) == -1
    assert derived.transversality == (psi1, psi2 + lambda1) and derived.reduced_transversality == (
        psi1,
    )
    assert (
        derived.stationarity is None
        and derived.normal == psi1 * x2 + psi2 * u - x1
        and derived.abnormal == psi1 * x2 + psi2 * u
    )
    arc = derived.singular[u]
    assert arc.excluded and arc.derivatives[:2] == (psi2, -psi1)


def test_conditions_of_example_2():
    derived = Problem(PLANE, ONE, START, [x1**2 + x2**2 - R**2]).conditions()
    assert derived.hamiltonian == psi1 * x2 + psi2 * u - lambda0 and derived.stationarity == sp.Eq(
        derived.hamiltonian, 0
    )
    assert derived.transversality == (psi1 + 2 * lambda1 * x1, psi2 + 2 * lambda1 * x2)
    (tangent,) = derived.reduced_transversality
    assert sp.expand(tangent**2 - (psi1 * x2 - psi2 * x1) ** 2) == 0
    text = derived._repr_markdown_()
    for part in (
        "Pontryagin function",
        "Adjoint system",
        "Transversality",
        "No singular arc",
        "Abnormal case",
        r"\dot{\psi}_{1}",
    ):
        assert part in text


def test_maximum_of_the_cost_changes_the_sign_of_its_part():
    derived = Problem(PLANE, ONE, START, [x2], final=x1, running=x2, maximise=True).conditions()
    assert derived.hamiltonian == psi1 * x2 + psi2 * u + lambda0 * x2
    assert derived.transversality == (psi1 - lambda0, psi2 + lambda1)


def test_free_initial_state():
    derived = Problem(
        PLANE, ONE, {x1: 0, x2: None}, [x1 - 1], running=u**2, duration=1
    ).conditions()
    assert derived.initial_transversality == (psi2,)


def test_control_inside_its_bounds():
    derived = Problem(PLANE, {u: (-1, A)}, START, [x1, x2], running=u**2, duration=3).conditions()
    law = derived.maximising[u]
    assert [law.subs({psi2: p, lambda0: 1, A: 2}) for p in (-5, 1, 9)] == [-1, sp.Rational(1, 2), 2]
    steering = Problem({x1: sp.cos(v), x2: sp.sin(v)}, {v: None}, START, [x1]).conditions()
    # Two stationary courses, a maximum and a minimum: left open.
    assert (
        steering.switching == {}
        and steering.maximising[v] is None
        and r"\arg\max" in steering._repr_markdown_()
    )


@pytest.mark.parametrize(
    "problem, order, surface, control, kelley",
    [
        (Problem({x: u}, ONE, {x: 1}, [x - 1], running=x**2, duration=2), 1, (x,), 0, -2 * lambda0),
        (Problem(PLANE, ONE, START, [x1, x2], running=x1**2), 2, (x1, x2), 0, -2 * lambda0),
        # Worked example 3 of the book: on x1 = x2 and x1 = -x2.
        (
            Problem(PLANE, ONE, START, [x1, x2], running=(x1 - x2) ** 2),
            1,
            ((x1 - x2) * (x1 + x2),),
            x1,
            -2 * lambda0,
        ),
        (
            Problem({x: u}, ONE, {x: 1}, [x - 1], running=-(x**2), duration=2),
            1,
            (x,),
            0,
            2 * lambda0,
        ),
        # 5.54: straight on, where the sine of the angle is zero.
        (
            Problem(
                {x1: 2 - sp.cos(x2), x2: sp.sin(x2) / x1 + u}, ONE, START, [x1 - 3], maximise=True
            ),
            1,
            (sp.sin(x2),),
            0,
            sp.Symbol("psi1", real=True) * sp.cos(x2),
        ),
    ],
)
def test_singular_arcs(problem, order, surface, control, kelley):
    arc = problem.conditions().singular[u]
    assert (arc.order, arc.surface, arc.control, arc.kelley) == (
        order,
        surface,
        control,
        kelley,
    ) and not arc.excluded


def test_singular_arc_on_two_rays():
    """Mixing of catalysts: on a singular arc r = x1/x2 is 10 + sqrt(10) or 10 - sqrt(10).

    r' = 0 gives u. The surface is of second degree in both states, so that neither can be
    substituted.
    """
    arc = (
        Problem(
            {x1: u * (10 * x2 - x1), x2: u * (x1 - 10 * x2) - (1 - u) * x2},
            {u: (0, 1)},
            {x1: 1, x2: 0},
            final=x1 + x2,
            duration=1,
        )
        .conditions()
        .singular[u]
    )
    assert arc.order == 1 and arc.kelley != 0
    for r in (10 + sp.sqrt(10), 10 - sp.sqrt(10)):
        ray = {x1: r * x2}
        assert [sp.simplify(e.subs(ray)) for e in arc.surface] == [0]
        assert sp.simplify(arc.control.subs(ray) - 1 / (r - 8 - 10 / r)) == 0


@pytest.mark.timeout(60)
def test_a_closed_form_of_the_maximum_is_not_searched_for_long():
    """Two reactions at a temperature between bounds; SymPy would search for minutes."""
    rates = [4000 * sp.exp(-2500 / u) * x1**2, 620000 * sp.exp(-5000 / u) * x2]
    reactor = Problem(
        {x1: -rates[0], x2: rates[0] - rates[1]},
        {u: (298, 398)},
        {x1: 1, x2: 0},
        final=-x2,
        duration=1,
    )
    assert r"\arg\max" in reactor.conditions()._repr_markdown_()


@pytest.mark.slow
def test_surface_has_no_factor_that_is_positive_by_assumption():
    """Greatest range with the drag v**p m**q: the mass is positive, and no factor of the surface."""
    mass, p, q, c = sp.symbols("mass p q c", positive=True)
    speed, way, P = sp.symbols("v x P", real=True)
    drag = speed**p * mass**q
    arc = (
        Problem(
            {way: speed, speed: (P - drag) / mass, mass: -P / c},
            {P: (0, 3)},
            {way: 0, speed: 1, mass: 1},
            [speed - sp.Rational(1, 2), mass - sp.Rational(1, 2)],
            final=way,
            maximise=True,
        )
        .conditions()
        .singular[P]
    )
    (surface,) = arc.surface
    assert not surface.has(mass)
    assert sp.simplify(surface.subs(speed, c * (p - 1) / (q - 1))) == 0
    assert sp.simplify(arc.control - drag) == 0


def test_singular_arc_of_the_goddard_problem():
    """Surface and feedback against the extremal that was found without them."""
    drag = 310 * w**2 * sp.exp(-500 * (h - 1))
    problem = Problem(
        {h: w, w: (sp.Rational(7, 2) * u - drag) / m - 1 / h**2, m: -7 * u},
        {u: (0, 1)},
        {h: 1, w: 0, m: 1},
        [m - sp.Rational(3, 5)],
        final=h,
        maximise=True,
    )
    arc = problem.conditions().singular[u]
    assert arc.order == 1 and len(arc.surface) == 1
    extremal = problem.solve()
    t = sum(extremal.switching_times) / 2
    point = dict(zip((h, w, m), extremal.state(t)))
    scale = sum(abs(float(term.subs(point))) for term in arc.surface[0].args)
    assert abs(float(arc.surface[0].subs(point))) < 1e-9 * scale
    assert float(arc.control.subs(point)) == pytest.approx(extremal.control(t)[0], rel=1e-9)
    assert (
        float(arc.kelley.subs(point).subs(dict(zip((psi1, psi2, psi3), extremal.costate(t))))) < 0
    )


def test_names_of_multipliers_are_reserved():
    with pytest.raises(ValueError, match="psi1 is the name of a costate"):
        Problem(
            {sp.Symbol("psi1"): u}, ONE, {sp.Symbol("psi1"): 1}, [sp.Symbol("psi1")]
        ).conditions()


def test_the_statement_is_shown():
    text = Problem(
        PLANE,
        {u: (-1, 1), v: (0, None)},
        {x1: 1, x2: None},
        [x1],
        running=u**2 + v**2,
        duration=(1, 2),
    )._repr_markdown_()
    for part in (
        r"|u| \le 1",
        r"0 \le v",
        r"x_{2}(0)\ \text{free}",
        r"\int_0",
        r"1 \le t_k \le 2",
        r"\to \min",
    ):
        assert part in text


def test_control_field_without_costates():
    x, y, v, u, k = sp.symbols("x y v theta k")
    plane = {x: v * sp.cos(u), y: v * sp.sin(u), v: -k * v**2 - sp.sin(u)}
    field = (
        Problem(plane, {u: None}, {x: 0, y: 0, v: 1}, final=-x, duration=1)
        .conditions()
        .control_field
    )
    assert list(field) == [u, v] and field[v] == plane[v]
    assert sp.simplify(field[u] - sp.cos(u) * (1 + 3 * k * v**2 * sp.sin(u)) / v) == 0
    with pytest.raises(ValueError, match="2 costates are not known"):
        Problem(
            plane, {u: None}, {x: 0, y: 0, v: 1}, [y], final=-x, duration=1
        ).conditions().control_field


@pytest.mark.slow
def test_singular_arcs_are_not_searched_for_in_very_long_formulas():
    """The arm of a robot, problem 8 of COPS: three lengths and angles, each with its own motor."""
    length, base, angle, *rates = y = sp.symbols("y1:7")
    motors = sp.symbols("u1:4")
    inertia = ((5 - length) ** 3 + length**3) / 3
    accelerations = [motors[0] / 5, motors[1] / (inertia * sp.sin(angle) ** 2), motors[2] / inertia]
    arm = Problem(
        dict(zip(y, [*rates, *accelerations])),
        dict.fromkeys(motors, (-1, 1)),
        dict(zip(y, [sp.Rational(9, 2), 0, sp.pi / 4, 0, 0, 0])),
        [base - 2 * sp.pi / 3],
    )
    for arc in arm.conditions().singular.values():
        assert arc.order is None and arc.control is None and not arc.excluded
        assert "more than 100 terms" in arc.reason and "not looked for" in arc.reason

"""Certificates of wrong extremals, and the errors of problems without one."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from trajlib.pontryagin import (
    Chattering,
    Infeasible,
    PontryaginError,
    Problem,
    StartOnTarget,
    Unbounded,
    WrongStructure,
    certify,
    compare,
)

pytestmark = pytest.mark.slow
x, x1, x2, u, v = sp.symbols("x x1 x2 u v")
half = sp.Rational(1, 2)
ONE = {u: (-1, 1)}
PLANE = {x1: x2, x2: u}
TRANSFER = Problem(PLANE, ONE, {x1: 1, x2: 0}, [x1, x2])
CIRCLE = Problem(PLANE, ONE, {x1: 3, x2: 0}, [x1**2 + x2**2 - 1])
TURNPIKE = Problem({x: u}, ONE, {x: 1}, [x - half], running=x**2, duration=2)
QUADRATIC = Problem(
    PLANE, ONE, {x1: 1, x2: 0}, [x1, x2], running=u**2, duration=sp.Rational(21, 10)
)


def changed_certificate(problem, wrong=None, times=None, multiplier=None, duration=None):
    """Return the certificate of an extremal with replaced functions, {"state": lambda t, y: y}."""
    extremal, wrong = problem.solve(), wrong or {}

    def changed(name):
        right = getattr(extremal, name)
        return lambda t: wrong[name](t, right(t)) if name in wrong else right(t)

    return certify(
        problem,
        *(changed(name) for name in ("state", "costate", "control")),
        duration or extremal.duration,
        extremal.switching_times if times is None else times,
        extremal.multiplier if multiplier is None else multiplier,
        [kind for kind, _, _ in extremal.arcs],
    )


@pytest.mark.parametrize("problem", [TRANSFER, CIRCLE, TURNPIKE, QUADRATIC])
def test_mutants_fail(problem):
    assert changed_certificate(problem).holds(1e-11)
    mutants = {
        "costate of the wrong sign": ({"costate": lambda t, p: -p}, {"maximum"}),
        "costate off by a factor": ({"costate": lambda t, p: 1.001 * p}, None),
        "costate shifted": ({"costate": lambda t, p: p + 1e-3}, None),
        "control slightly small": ({"control": lambda t, w: 0.999 * w}, None),
        "control too large": (
            {"control": lambda t, w: 1.001 * w},
            {"bounds"} if problem is not TURNPIKE else None,
        ),
        "state drifts": ({"state": lambda t, y: y * (1 + 1e-4 * t)}, {"dynamics"}),
        "another start": ({"state": lambda t, y: y + 1e-4}, None),
    }
    for name, (wrong, conditions) in mutants.items():
        failures = set(changed_certificate(problem, wrong).failures())
        # A costate with another factor is as good where the cost does not restrict it: that is
        # lambda_0 changed.
        assert failures and (conditions is None or conditions <= failures), name


def test_a_jump_of_the_state_at_a_switching_is_detected():
    evidence = changed_certificate(TRANSFER, {"state": lambda t, y: y + np.where(t < 1, 0, 1e-3)})
    assert {"dynamics", "terminal"} <= set(evidence.failures())


def test_wrong_multipliers():
    assert "stationarity" in changed_certificate(TRANSFER, multiplier=0.5).failures()
    assert "multipliers" in changed_certificate(TRANSFER, multiplier=-1.0).failures()
    assert changed_certificate(
        TRANSFER, {"costate": lambda t, p: 0 * p}, multiplier=0.0
    ).failures() == ["multipliers"]


def test_admissible_processes_that_are_no_extremals():
    """To the origin with a detour, u = -1, 0, 1: no costate fits."""
    s = (np.sqrt(5) - 1) / 2
    times = [s, s + 1]

    def state(t):
        return np.array(
            [
                np.where(
                    t < s,
                    1 - t**2 / 2,
                    np.where(t < s + 1, 1 - s**2 / 2 - s * (t - s), (2 * s + 1 - t) ** 2 / 2),
                ),
                np.where(t < s, -t, np.where(t < s + 1, -s, t - 2 * s - 1)),
            ]
        )

    def control(t):
        return np.array([np.where(t < s, -1.0, np.where(t < s + 1, 0.0, 1.0))])

    evidence = certify(
        TRANSFER, state, lambda t: np.array([-1 + 0 * t, t - s - 1]), control, 2 * s + 1, times
    )
    assert (
        not {"dynamics", "adjoint", "terminal", "bounds", "initial"} & set(evidence.failures())
        and "maximum" in evidence.failures()
    )


def test_the_first_return_is_tested():
    problem = Problem(
        {x1: x2, x2: -u * x1}, {u: (1, 4)}, {x1: 1, x2: 0}, [x2], maximise=True, first_return=True
    )

    def state(t):
        return np.array([np.cos(t), -np.sin(t)])

    # One and a half turns at u = 1 satisfy everything else.
    evidence = certify(
        problem,
        state,
        lambda t: np.array([np.sin(t), np.cos(t)]),
        lambda t: 1 + 0 * t[None],
        3 * np.pi,
    )
    assert "passage" in evidence.failures()


def test_kelley_of_a_singular_arc_that_maximises():
    """x = 0 with the cost -x^2: all first-order conditions hold, Kelley's does not."""
    problem = Problem({x: u}, ONE, {x: 0}, [x], running=-(x**2), duration=1)

    def nothing(t):
        return np.zeros((1, len(t)))

    assert certify(problem, nothing, nothing, nothing, 1.0, arcs=["singular"]).failures() == [
        "kelley"
    ]


def test_arguments_of_certify():
    with pytest.raises(ValueError, match=r"expected state\(t\) of shape \(1, "):
        certify(TURNPIKE, lambda t: [t, t], lambda t: [t], lambda t: [t], 2)
    with pytest.raises(ValueError, match="switching times between 0 and the duration"):
        certify(TURNPIKE, lambda t: [t], lambda t: [t], lambda t: [t], 2, [3])
    assert (
        "kelley" not in changed_certificate(TURNPIKE).failures()
        and "Kelley" in changed_certificate(TURNPIKE)._repr_markdown_()
    )


def test_rounding_proves_no_target_out_of_reach():
    """x2 cannot fall; the equations ask for x2 = 0, with an error of least squares."""
    problem = Problem({x1: v, x2: u}, {v: (-1, 1), u: (0, 1)}, {x1: 0, x2: 0}, [x1 + x2 - 1, x2])
    assert problem.solve().duration == pytest.approx(1, abs=1e-12)


@pytest.mark.parametrize(
    "problem, error, message",
    [
        (
            Problem({x1: x2, x2: x1 + u}, ONE, {x1: 2, x2: 0}, [x1, x2]),
            Infeasible,
            "cannot be reached",
        ),
        (
            Problem({x: x + u}, ONE, {x: 1.5}, [x]),
            Infeasible,
            "x begins at 1.5 and cannot fall below 1.5",
        ),
        (Problem(PLANE, {u: (0, 1)}, {x1: 1, x2: 1}, [x1, x2]), Infeasible, "cannot be reached"),
        (
            replace(QUADRATIC, duration=1),
            Infeasible,
            "duration 1 is too short: the least time in which the target is reached is 2",
        ),
        (Problem({x: u}, {u: None}, {x: 1}, [x]), Unbounded, "in any time t > 0"),
        (
            Problem({x: u}, {u: None}, {x: 1}, running=x, duration=1),
            Unbounded,
            "falls without bound",
        ),
        (
            Problem({x1: x2, x2: -x1 + u}, ONE, {x1: 1, x2: 0}, [x2], running=-(x1**2) - x2**2),
            StartOnTarget,
            "first_return=True",
        ),
        # Worked example 3 of the book rests on the singular line for ever.
        (
            Problem(PLANE, ONE, {x1: 1, x2: 0}, [x1, x2], running=(x1 - x2) ** 2),
            Unbounded,
            r"no best duration was found: the cost keeps falling .* towards about 2\.278461\. .* "
            r"as the duration grows",
        ),
        (
            Problem(PLANE, ONE, {x1: 1, x2: 0}, [x1, x2], running=-((x1 - x2) ** 2), maximise=True),
            Unbounded,
            r"the cost keeps rising .* towards about -2\.278461\.",
        ),
        (
            Problem(PLANE, ONE, {x1: 1, x2: 0}, [x1, x2], running=x1**2),
            Chattering,
            "switches infinitely often",
        ),
        (Problem(PLANE, ONE, {x1: 1, x2: 0}, running=x1**2, duration=5), Chattering, "order 2"),
        (replace(TRANSFER, initial={x1: 0, x2: 0}), StartOnTarget, "after zero time"),
        (replace(QUADRATIC, running=sp.Abs(u - x1)), ValueError, "p - q"),
    ],
)
def test_problems_without_an_extremal(problem, error, message):
    with pytest.raises(error, match=message):
        problem.solve()


def fuller(a=1.0):
    """Return the cost from (a, 0) and the ratio of the arcs of Fuller's problem.

    On x1 = -k x2 |x2|, k = sqrt((sqrt(33) - 1)/24), arcs repeat on a smaller scale, with the cost
    c |x2|^5; the speed falls by q = sqrt((1 + 2k)/(1 - 2k)) from one switching to the next.
    """
    k = np.sqrt((np.sqrt(33) - 1) / 24)
    q = np.sqrt((1 + 2 * k) / (1 - 2 * k))

    def square(x, speed, time):
        """The integral of (x + speed s + s^2/2)^2, by Gauss's formula."""
        nodes, weights = np.polynomial.legendre.leggauss(5)
        s = (1 + nodes) / 2 * time
        return (x + speed * s + s**2 / 2) ** 2 @ weights * time / 2

    c = square(k, -1.0, 1 + 1 / q) / (1 - q**-5)
    # From (a, 0) with u = -1 until a - v^2/2 = k v^2 (mirrored: from -a with u = 1).
    v = np.sqrt(a / (k + 0.5))
    return square(-a, 0.0, v) + c * v**5, q


@pytest.mark.parametrize(
    "problem, sign",
    [
        (Problem(PLANE, ONE, {x1: 1, x2: 0}, [x1, x2], running=x1**2), 1),
        (Problem(PLANE, ONE, {x1: 1, x2: 0}, [x1, x2], running=-(x1**2), maximise=True), -1),
        (Problem(PLANE, ONE, {x1: 1, x2: 0}, running=x1**2, duration=5), 1),
    ],
)
def test_numbers_of_chattering(problem, sign):
    with pytest.raises(Chattering, match="each arc is 4.1301") as caught:
        problem.solve()
    numbers, (cost, ratio) = caught.value.numbers, fuller()
    assert abs(sign * numbers.cost - cost) < numbers.cost_error < 1e-11
    assert abs(numbers.ratio - ratio) < numbers.ratio_error < 1e-4
    assert len(numbers.lengths) >= 5


def test_errors_of_chattering_with_a_changing_ratio():
    """A pendulum tends to Fuller's plant only in the limit.

    Its bounds count by their distance from the control there.
    """
    pendulum = Problem(
        {x1: x2, x2: u - sp.sin(x1)}, {u: (-2, 2)}, {x1: 1, x2: 0}, [x1, x2], running=x1**2
    )
    with pytest.raises(Chattering) as caught:
        pendulum.solve()
    numbers = caught.value.numbers
    assert abs(numbers.ratio - fuller()[1]) < numbers.ratio_error < 0.1


def test_fuller_before_the_switchings_accumulate():
    """In a short time no arc is singular: the same problem has an extremal with few arcs."""
    extremal = Problem(PLANE, ONE, {x1: 1, x2: 0}, running=x1**2, duration=1.5).solve()
    assert [kind for kind, _, _ in extremal.arcs] == ["u-", "u+"] and extremal.certificate().holds(
        1e-11
    )


@pytest.mark.parametrize(
    "structure, message",
    [
        (["u+", "u-"], "u[+], u-|shrinks"),
        (["u-", "u+", "u-"], "shrinks to nothing"),
    ],
)
def test_structures_without_an_extremal(structure, message):
    with pytest.raises(PontryaginError, match=message):
        TRANSFER.solve(structure)


@pytest.mark.parametrize(
    "structure, error, message",
    [
        ("u-", TypeError, "expected a list of arcs"),
        (["up"], ValueError, "expected one of u-, u[+], interior, singular"),
        (["interior"], ValueError, "H is linear in u"),
        (["u-", "u-"], ValueError, "are one arc"),
        ([], ValueError, "at least one arc"),
        ([("u-", "u+")], ValueError, "for each of 1 controls"),
    ],
)
def test_invalid_structures(structure, error, message):
    with pytest.raises(error, match=message):
        TRANSFER.solve(structure)


def test_singular_arcs_of_a_controllable_linear_plant():
    with pytest.raises(WrongStructure, match="u has no singular arc"):
        TRANSFER.solve(["u-", "singular", "u+"])
    with pytest.raises(PontryaginError, match="none of the structures"):
        compare(TRANSFER, [["u+", "u-"]])


def test_bounded_duration_ends_at_its_bound():
    # The cost falls as the time grows; H does not vanish at the longest.
    slow = replace(QUADRATIC, duration=(2, 3)).solve()
    assert (
        slow.duration == 3
        and slow.cost == pytest.approx(4 / 9, abs=1e-12)
        and slow.certificate().holds(1e-11)
    )
    assert replace(TRANSFER, duration=(1, 10)).solve().duration == pytest.approx(2, abs=1e-11)
    for longest in (1, sp.Rational(17, 10)):
        with pytest.raises(Infeasible, match="a costate separates it"):
            replace(TRANSFER, duration=(half, longest)).solve()


@pytest.mark.parametrize("offset", [2, 3])
def test_residuals_of_h_are_relative_to_its_largest_terms(offset):
    """x = 1 - t, psi = t - a: H = a - 2, with |psi f| <= a and a density 1 + x <= 2."""
    x, u = sp.symbols("x u")
    problem = Problem({x: u}, {u: (-1, 1)}, {x: 1}, [x], running=1 + x)
    evidence = certify(
        problem, lambda t: [1 - t], lambda t: [t - offset], lambda t: [0 * t - 1], duration=1
    )
    expected = pytest.approx((offset - 2) / (1 + offset + 2), rel=1e-3, abs=1e-12)
    assert evidence.stationarity == expected and evidence.end == expected

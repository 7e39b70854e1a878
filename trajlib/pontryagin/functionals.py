"""The calculus of variations: what makes a functional least, and the same asked as a problem of
optimal control.

    J[x] = int_a^b L(t, x, x', ..., x^(n)) dt + Phi(x(b), ..., x^(n-1)(b))     (`systems.Functional`)

With the momenta p_n = dL/dx^(n), p_k = dL/dx^(k) - p_(k+1)' the first variation is

    delta J = int E h dt + [p_1 h + ... + p_n h^(n-1)]_a^b + delta Phi,   E = dL/dx - p_1' :

E = 0 is the equation of Euler and Poisson, and where x^(k-1) is not given at an end, its momentum
has to balance Phi there: p_k(b) = -dPhi/dx^(k-1)(b), p_k(a) = 0 (natural conditions). The costate
of the maximum principle is psi_k = p_k where J is to be least, and -p_k where it is to be greatest.

>>> import sympy as sp
>>> from trajlib import pontryagin
>>> from workbook.systems import Functional
>>> t, x = sp.Symbol("t"), sp.Function("x")
>>> J = Functional(x(t).diff(t)**2 + x(t)**2, x(t), (t, 0, 1), start=[1], final=-x(1)**2)
>>> pontryagin.euler_equation(J)
Eq(2*x(t) - 2*Derivative(x(t), (t, 2)), 0)
>>> pontryagin.natural_conditions(J)
[Eq(-2*x(1) + 2*Subs(Derivative(x(t), t), t, 1), 0)]
>>> pontryagin.functional_value(J, sp.exp(t))
-1
>>> round(pontryagin.control_problem(J).solve().cost, 9)
-1.0
"""

import sympy as sp

from trajlib.pontryagin.optimal_control import Problem


def momenta(functional):
    """p_1, ..., p_n, a list of expressions in time and the motion."""
    found = [sp.Integer(0)]
    for derivative in functional.derivatives[:0:-1]:
        found.insert(0, _slope(functional, derivative) - found[0].diff(functional.time))
    return found[:-1]


def euler_equation(functional):
    """The equation of Euler and Poisson for the motion, an `Eq` with the right-hand side 0."""
    left = (
        _slope(functional, functional.motion) - momenta(functional)[0].diff(functional.time).doit()
    )
    return sp.Eq(sp.expand(left), 0)


def natural_conditions(functional):
    """What has to hold at the ends for the values that are not given there: a list of equations."""
    time, begin, end = functional.interval
    found = []
    for p, given in zip(momenta(functional), functional.start):
        if given is None:
            found.append(sp.expand(p).subs(time, begin))
    for p, derivative, given in zip(momenta(functional), functional.derivatives, functional.end):
        if given is None:
            at_end, value = derivative.subs(time, end), sp.Dummy("value")
            slope = functional.final.subs(at_end, value).diff(value).subs(value, at_end)
            found.append(sp.expand(p).subs(time, end) + slope)
    return [sp.Eq(e, 0) for e in found]


def end_conditions(functional, motion):
    """What the ends ask of a motion, an expression in time with constants in it that are still to
    be found: equations for the given values, and the natural conditions."""
    time, begin, end = functional.interval
    given = [
        (derivative, place, value)
        for place, values in ((begin, functional.start), (end, functional.end))
        for derivative, value in zip(functional.derivatives, values)
        if value is not None
    ]
    return [
        sp.Eq(derivative.subs(functional.motion, motion).doit().subs(time, place), value)
        for derivative, place, value in given
    ] + [_at_ends(functional, e, motion) for e in natural_conditions(functional)]


def functional_value(functional, motion):
    """J of a motion, an expression in time."""
    time, begin, end = functional.interval
    along = sp.expand(functional.integrand.subs(functional.motion, motion).doit())
    return sp.integrate(along, (time, begin, end)) + _at_ends(functional, functional.final, motion)


def control_problem(functional):
    """The same as a problem of optimal control: `Problem` with the states x1 = x, x2 = x', ... and
    the control u = x^(n) without bounds; time is a state where the integrand depends on it."""
    n, time = functional.order, functional.time
    state, control = (
        sp.symbols(f"{functional.motion.func}1:{n + 1}", real=True),
        sp.Symbol("u", real=True),
    )
    names = dict(reversed(list(zip(functional.derivatives, (*state, control)))))
    running = functional.integrand.subs(names)
    _, begin, end = functional.interval
    ends = {derivative.subs(time, end): x for derivative, x in zip(functional.derivatives, state)}
    dynamics, initial = dict(zip(state, (*state[1:], control))), dict(zip(state, functional.start))
    if running.has(time):
        dynamics, initial = dynamics | {time: 1}, initial | {time: begin}
    return Problem(
        dynamics,
        {control: (None, None)},
        initial,
        [x - value for x, value in zip(state, functional.end) if value is not None],
        running=running,
        final=functional.final.subs(ends),
        duration=end - begin,
        maximise=functional.maximise,
    )


def _slope(functional, derivative):
    """The partial derivative of the integrand, the motion and its derivatives taken as
    independent."""
    symbols = [sp.Dummy(f"x{k}") for k in range(functional.order + 1)]
    apart = functional.integrand.subs(dict(reversed(list(zip(functional.derivatives, symbols)))))
    slope = apart.diff(symbols[functional.derivatives.index(derivative)])
    return slope.subs(dict(zip(symbols, functional.derivatives)))


def _at_ends(functional, expression, motion):
    """An expression in the values of x, x', ... at the ends, for a motion."""
    time = functional.time
    for place in functional.interval[1:]:
        for k in range(2 * functional.order - 1, -1, -1):
            derivative = functional.motion.diff(time, k) if k else functional.motion
            expression = expression.subs(
                derivative.subs(time, place), motion.diff(time, k).subs(time, place)
            )
    return expression

"""The calculus of variations, and its problems stated as problems of optimal control.

    J[x] = int_a^b L(t, x, x', ..., x^(n)) dt + Phi(x(b), ..., x^(n-1)(b))     (`systems.Functional`)

With the momenta p_n = dL/dx^(n), p_k = dL/dx^(k) - p_(k+1)' the first variation is

    delta J = int E h dt + [p_1 h + ... + p_n h^(n-1)]_a^b + delta Phi,   E = dL/dx - p_1' :

E = 0 is the Euler-Poisson equation, and where x^(k-1) is free at an end, its momentum balances Phi
there: p_k(b) = -dPhi/dx^(k-1)(b), p_k(a) = 0 (natural boundary conditions). The costate of the
maximum principle is psi_k = p_k for a minimum of J, and -p_k for a maximum.

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


def momenta(functional) -> list[sp.Expr]:
    """Return the momenta p_1, ..., p_n of a functional.

    Parameters
    ----------
    functional : Functional
        J[x] with derivatives of x up to the order n.

    Returns
    -------
    list of sympy.Expr
        p_n = dL/dx^(n), p_k = dL/dx^(k) - p_(k+1)', in time, x and its derivatives.

    Examples
    --------
    >>> from workbook.systems import Functional
    >>> t, x = sp.Symbol("t"), sp.Function("x")
    >>> momenta(Functional(x(t).diff(t)**2, x(t), (t, 0, 1), start=[0], end=[1]))
    [2*Derivative(x(t), t)]
    """
    result = [sp.Integer(0)]
    for derivative in functional.derivatives[:0:-1]:
        result.insert(0, _slope(functional, derivative) - result[0].diff(functional.time))
    return result[:-1]


def euler_equation(functional) -> sp.Eq:
    """Return the Euler-Poisson equation of a functional.

    Parameters
    ----------
    functional : Functional
        J[x] with derivatives of x up to the order n.

    Returns
    -------
    sympy.Equality
        dL/dx - p_1' = 0, a differential equation of the order 2n for x.

    Examples
    --------
    >>> from workbook.systems import Functional
    >>> t, x = sp.Symbol("t"), sp.Function("x")
    >>> euler_equation(Functional(x(t).diff(t)**2, x(t), (t, 0, 1), start=[0], end=[1]))
    Eq(-2*Derivative(x(t), (t, 2)), 0)
    """
    left_side = (
        _slope(functional, functional.motion) - momenta(functional)[0].diff(functional.time).doit()
    )
    return sp.Eq(sp.expand(left_side), 0)


def natural_conditions(functional) -> list[sp.Eq]:
    """Return the natural boundary conditions, for the values that are free at the ends.

    Parameters
    ----------
    functional : Functional
        J[x]; a value None in its `start` or `end` is free.

    Returns
    -------
    list of sympy.Equality
        p_k(a) = 0 and p_k(b) + dPhi/dx^(k-1)(b) = 0, one for each free value; those at a first.

    Examples
    --------
    >>> from workbook.systems import Functional
    >>> t, x = sp.Symbol("t"), sp.Function("x")
    >>> natural_conditions(Functional(x(t).diff(t)**2, x(t), (t, 0, 1), start=[0]))
    [Eq(2*Subs(Derivative(x(t), t), t, 1), 0)]
    """
    time, begin, end = functional.interval
    conditions = []
    for p, value in zip(momenta(functional), functional.start):
        if value is None:
            conditions.append(sp.expand(p).subs(time, begin))
    for p, derivative, value in zip(momenta(functional), functional.derivatives, functional.end):
        if value is None:
            at_end, value = derivative.subs(time, end), sp.Dummy("value")
            slope = functional.final.subs(at_end, value).diff(value).subs(value, at_end)
            conditions.append(sp.expand(p).subs(time, end) + slope)
    return [sp.Eq(e, 0) for e in conditions]


def end_conditions(functional, motion) -> list[sp.Eq]:
    """Return the equations that both ends give for the constants in a motion.

    Parameters
    ----------
    functional : Functional
        J[x], with its values at the ends.
    motion : sympy.Expr
        x as an expression in time with constants that are still to be found.

    Returns
    -------
    list of sympy.Equality
        The given values, then the natural boundary conditions for the free ones.

    Examples
    --------
    >>> from workbook.systems import Functional
    >>> t, x, C = sp.Symbol("t"), sp.Function("x"), sp.symbols("C:2")
    >>> end_conditions(Functional(x(t).diff(t)**2, x(t), (t, 0, 1), start=[0], end=[1]), C[0] + C[1]*t)
    [Eq(C0, 0), Eq(C0 + C1, 1)]
    """
    time, begin, end = functional.interval
    conditions = [
        (derivative, instant, value)
        for instant, values in ((begin, functional.start), (end, functional.end))
        for derivative, value in zip(functional.derivatives, values)
        if value is not None
    ]
    return [
        sp.Eq(derivative.subs(functional.motion, motion).doit().subs(time, instant), value)
        for derivative, instant, value in conditions
    ] + [_at_ends(functional, e, motion) for e in natural_conditions(functional)]


def functional_value(functional, motion) -> sp.Expr:
    """Return the value J of a functional on a motion.

    Parameters
    ----------
    functional : Functional
        J[x].
    motion : sympy.Expr
        x as an expression in time.

    Returns
    -------
    sympy.Expr
        The integral and the terminal part together, exact where SymPy integrates.

    Examples
    --------
    >>> from workbook.systems import Functional
    >>> t, x = sp.Symbol("t"), sp.Function("x")
    >>> functional_value(Functional(x(t).diff(t)**2, x(t), (t, 0, 1), start=[0], end=[1]), t**2)
    4/3
    """
    time, begin, end = functional.interval
    along = sp.expand(functional.integrand.subs(functional.motion, motion).doit())
    return sp.integrate(along, (time, begin, end)) + _at_ends(functional, functional.final, motion)


def control_problem(functional) -> Problem:
    """Return a variational problem as a problem of optimal control.

    Parameters
    ----------
    functional : Functional
        J[x] with derivatives of x up to the order n.

    Returns
    -------
    Problem
        With the states x1 = x, ..., xn = x^(n-1) and the control u = x^(n) without bounds; time is
        a state where the integrand depends on it.

    Examples
    --------
    >>> from workbook.systems import Functional
    >>> t, x = sp.Symbol("t"), sp.Function("x")
    >>> J = Functional(x(t).diff(t)**2, x(t), (t, 0, 1), start=[0], end=[1])
    >>> control_problem(J).dynamics, control_problem(J).running
    ({x1: u}, u**2)
    """
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
    """Return the partial derivative of the integrand, x and its derivatives being independent."""
    symbols = [sp.Dummy(f"x{k}") for k in range(functional.order + 1)]
    apart = functional.integrand.subs(dict(reversed(list(zip(functional.derivatives, symbols)))))
    slope = apart.diff(symbols[functional.derivatives.index(derivative)])
    return slope.subs(dict(zip(symbols, functional.derivatives)))


def _at_ends(functional, expression, motion):
    """Evaluate an expression in the values of x, x', ... at the ends for a motion."""
    time = functional.time
    for end in functional.interval[1:]:
        for k in range(2 * functional.order - 1, -1, -1):
            derivative = functional.motion.diff(time, k) if k else functional.motion
            expression = expression.subs(
                derivative.subs(time, end), motion.diff(time, k).subs(time, end)
            )
    return expression

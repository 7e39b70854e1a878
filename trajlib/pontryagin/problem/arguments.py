"""The arguments of `Problem`, each read into one form or refused with one clear error."""

from collections.abc import Iterable, Mapping

import sympy as sp

from trajlib._arguments.symbols import exact_decimals, read_expression, read_symbols


def read_table(dynamics):
    if not isinstance(dynamics, Mapping) or not dynamics:
        raise TypeError(f"dynamics: expected a dict {{state: right-hand side}}, got {dynamics!r}")
    symbols = read_symbols(dynamics, "dynamics")
    return {s: exact_decimals(read_expression(dynamics[s], f"dynamics of {s}")) for s in symbols}


def read_bounds(controls):
    if not isinstance(controls, Mapping) or not controls:
        raise TypeError(f"controls: expected a dict {{control: (lower, upper)}}, got {controls!r}")
    result = {}
    for u in read_symbols(controls, "controls"):
        pair = (None, None) if controls[u] is None else controls[u]
        if isinstance(pair, str) or not isinstance(pair, Iterable) or len(pair := tuple(pair)) != 2:
            raise TypeError(f"controls: expected (lower, upper) for {u}, got {controls[u]!r}")
        low, high = (
            default if b is None else exact_decimals(read_expression(b, f"bound of {u}"))
            for b, default in zip(pair, (-sp.oo, sp.oo))
        )
        if (high - low).is_positive is False and low != -sp.oo and high != sp.oo:
            raise ValueError(f"controls: expected lower < upper for {u}, got ({low}, {high})")
        if low == sp.oo or high == -sp.oo:
            raise ValueError(f"controls: no value of {u} lies between {low} and {high}")
        result[u] = (low, high)
    return result


def read_initial(initial):
    if not isinstance(initial, Mapping):
        raise TypeError(
            f"initial: expected a dict from states to their values at t = 0, got {initial!r}"
        )
    return {
        s: None if v is None else exact_decimals(read_expression(v, f"initial value of {s}"))
        for s, v in initial.items()
    }


def read_terminal(terminal):
    """Return (equations, inequalities): expressions that vanish, and relations g <= 0."""
    if isinstance(terminal, Mapping):
        terminal = [s - read_expression(v, f"terminal value of {s}") for s, v in terminal.items()]
    elif isinstance(terminal, (sp.Expr, sp.Equality)):
        terminal = [terminal]
    if isinstance(terminal, str) or not isinstance(terminal, Iterable):
        raise TypeError(
            f"terminal: expected a list of expressions that vanish at the end, got {terminal!r}"
        )
    terminal = list(terminal)
    inequalities = [g for g in terminal if isinstance(g, (sp.LessThan, sp.GreaterThan))]
    sides = (
        g.lhs - g.rhs if isinstance(g, sp.Equality) else g
        for g in terminal
        if g not in inequalities
    )
    equations = tuple(exact_decimals(read_expression(g, "terminal")) for g in sides)
    return equations, read_inequalities(inequalities, "terminal")


def read_inequalities(path, name):
    """Return inequalities as a tuple of relations g <= 0."""
    if isinstance(path, (sp.Basic, bool)):
        path = [path]
    if isinstance(path, str) or not isinstance(path, Iterable):
        raise TypeError(f"{name}: expected a list of inequalities such as [v <= 1], got {path!r}")
    result = []
    for relation in path:
        for part in relation.args if isinstance(relation, sp.And) else [relation]:
            if not isinstance(part, (sp.LessThan, sp.GreaterThan)):
                raise TypeError(
                    f"{name}: expected inequalities with <= or >=, such as v <= 1, got {part!r}"
                )
            sides = exact_decimals(part.lts) - exact_decimals(part.gts)
            result += _without_modulus(sides)
    return inequalities(result)


def inequalities(expressions):
    """Return the relations g <= 0 for expressions g."""
    return tuple(sp.LessThan(g, 0, evaluate=False) for g in expressions)


def bounds_from_path(controls, path):
    """Return (controls, path) with inequalities that bound one control moved to its bounds."""
    controls, remaining = dict(controls), []
    for relation in path:
        acting = relation.lhs.free_symbols & set(controls)
        if not acting:
            remaining.append(relation)
            continue
        bounds = _bounds(relation.lhs, next(iter(acting))) if len(acting) == 1 else None
        if bounds is None:
            raise ValueError(
                f"path: {relation} is neither a constraint on the state nor one that means u <= b or "
                "u >= b, or both, for one control; other mixed constraints are not provided for"
            )
        (u,) = acting
        for side, bound in bounds.items():
            if controls[u][side].is_finite is not False:
                raise ValueError(
                    f"path: {relation} is a second {('lower', 'upper')[side]} bound of {u}, beside "
                    f"{controls[u][side]}; expected one (leave the other one out of controls)"
                )
            controls[u] = (controls[u][0], bound) if side else (bound, controls[u][1])
    return controls, tuple(remaining)


def _bounds(g, u):
    """Return {0: lower, 1: upper bound} of u where g <= 0 means these bounds, else None.

    So it is where g grows or falls with u and g = 0 has one solution, and where g is quadratic in u
    and convex. Signs are those for real symbols.
    """
    real = {s: sp.Dummy(s.name, real=True) for s in g.free_symbols if s.is_real is None}
    back = {dummy: s for s, dummy in real.items()}
    g, u = g.subs(real), real.get(u, u)
    slope = sp.factor(g.diff(u))
    if slope.is_positive or slope.is_negative:
        solutions = sp.solve(g, u)
        if len(solutions) != 1 or solutions[0].is_real is False:
            return None
        return {int(bool(slope.is_positive)): solutions[0].subs(back)}
    if not g.is_polynomial(u) or sp.degree(g, u) != 2:
        return None
    a, b, c = sp.Poly(g, u).all_coeffs()
    if not a.is_positive:
        return None
    middle = -b / (2 * a)
    half = sp.sqrt(sp.expand(middle**2 - c / a))
    return {side: (middle + sign * half).subs(back) for side, sign in ((0, -1), (1, 1))}


def _without_modulus(g):
    """Return the expressions whose signs are those of |e| - c <= 0: e - c and -e - c."""
    moduli = [a for a in g.atoms(sp.Abs) if g.coeff(a) == 1]
    if len(moduli) != 1:
        return [g]
    (modulus,) = moduli
    return [g.xreplace({modulus: sign * modulus.args[0]}) for sign in (1, -1)]


def read_duration(duration):
    if duration is None:
        return None
    if isinstance(duration, (tuple, list)):
        if len(duration) != 2:
            raise TypeError(f"duration: expected a number or (shortest, longest), got {duration!r}")
        low, high = (exact_decimals(read_expression(d, "duration")) for d in duration)
        if low.is_nonnegative is False or (high - low).is_positive is False:
            raise ValueError(f"duration: expected 0 <= shortest < longest, got ({low}, {high})")
        return low, high
    duration = exact_decimals(read_expression(duration, "duration"))
    if duration.is_positive is False and duration != sp.oo:
        raise ValueError(f"duration: expected a positive number, got {duration}")
    return duration

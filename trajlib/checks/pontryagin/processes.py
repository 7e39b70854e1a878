"""Optimal processes whatever the cost: controls and motions in time, costs, durations, costates.

`problem` is a `pontryagin.Problem`, with one control; `parameters` a dict from its symbols to the intervals in which
answers are tried. The optimum comes from `direct_optimum`, which knows nothing of costates. All answers are judged in
one way: a process has to be admissible, to keep to the ends, and to cost no more than the optimum that was found.
"""

import numpy as np

from trajlib.checks.contract import coercion
from trajlib.checks.contract.claims import Expression
from trajlib.checks.contract.tolerance import same, share
from trajlib.checks.contract.verdict import Invalid, Wrong, judged
from trajlib.checks.pontryagin.open_loop import INTEGRATED, Control, Path, at_instants, jumps
from trajlib.checks.tools.values import real_function, value_at
from trajlib.checks.tools.wording import rounded_text
from trajlib.checks.truths.optima.direct_optimum import optima

#: Up to which share of its terms the least cost is known, and the cost of a process that is followed in small steps.
COSTS = 1e-6


@judged
def optimal_control(answer, problem, time, parameters=None):
    """The control of an optimal process: an expression in time and parameters, or a list of arcs [value, until]."""
    read = Control(answer, time, list(parameters or {}))
    begun = ", begun as the best process is," if None in problem.initial.values() else ""
    for values, best in optima(problem, parameters):
        where = told_for(values)
        path = Path(best, read.sections(values, best.duration), where)
        path.admissible(read.rounding)
        keeps_to_the_ends(path.states[-1], best, read.rounding, f"{where}under your control{begun}")
        if problem.first_return:
            meets_once(path.times, path.states, best, where)
        costs_least(best.total(path.states[-1]), best, problem, read.rounding, where + "your control")
    return "it is admissible, keeps to the ends, and no process was found that does better"


@judged
def optimal_motion(answer, problem, time, parameters=None):
    """An optimal motion: all states as functions of time and parameters, or the first one, if the others are its
    derivatives."""
    claims = _states(answer, problem, [time, *(parameters or {})], time)
    values_of, rates_of = (real_function([time, *(parameters or {})], part)
                           for part in (claims, [claim.diff(time) for claim in claims]))
    rounding = share(*claims, computed=INTEGRATED)
    for values, best in optima(problem, parameters):
        where, numbers = told_for(values), list(values.values())
        slack, given = rounding * best.size(), [v is not None for v in problem.initial.values()]
        start = values_of(0.0, *numbers)
        if not np.all((np.abs(start - best.start[:-1]) <= slack)[given]):
            raise Wrong(f"{where}your motion starts at {point_text(start)}, not where it should")
        scale = 10 * rounding * (1 + np.abs(best.states).max() * (1 + 1 / best.duration))
        for k, t in enumerate(best.times):
            # At a jump of the control a derivative need not exist.
            near = t * (1 - 1e-7)
            y, rate = values_of(near, *numbers), rates_of(near, *numbers)
            if not np.all(np.isfinite([*y, *rate])):
                raise Wrong(f"{where}your motion is not real at t = {t:.4g}")
            low, high = _rates(best, y)
            if not np.all((rate >= low - scale) & (rate <= high + scale)):
                j = int(np.argmax(np.maximum(low - scale - rate, rate - high - scale)))
                raise Wrong(f"{where}at t = {t:.4g} your motion is at {point_text(y)} with "
                            f"{list(problem.dynamics)[j]}' = {rate[j]:.4g}, which no admissible control gives there")
        for j, name in enumerate(problem.dynamics):
            for t in jumps(lambda times, j=j: at_instants(values_of, times, *numbers)[j], best.duration):
                raise Wrong(f"{where}on your motion {name} jumps at t = {t:.4g}")
        keeps_to_the_ends(np.append(values_of(best.duration * (1 - 1e-9), *numbers), 0), best, rounding,
                           where + "on your motion")
        off = [np.abs(values_of(t, *numbers) - best.states[:, k]).max() for k, t in enumerate(best.times)]
        if not max(off) <= 3 * slack:
            raise Wrong(f"{where}your motion is one that the system can have, but another one with the same ends does "
                        f"better; the two come to be {max(off):.4g} apart")
    return "it starts where it should, obeys the equations, keeps to the ends, and is the best motion found"


@judged(Expression("parameters"))
def optimal_cost(claim, problem, parameters=None):
    """The cost of the optimal process, as an expression in the parameters.

    Where these are the start and the duration is free, what is left of a process is optimal too: the cost is asked
    there as well.
    """
    better = "greater" if problem.maximise else "less"
    starts = list(problem.initial.values())
    anywhere = (problem.duration is None and not problem.first_return and len(set(starts)) == len(starts)
                and all(start in (parameters or {}) for start in starts))
    cost_of = real_function([*starts, *(p for p in parameters if p not in starts)], [claim]) if anywhere else None
    for values, best in optima(problem, parameters):
        where = told_for(values)
        said = value_at(claim, values, "the cost")
        if not same(said, best.cost, claim, best.cost_size(), COSTS):
            beyond = (said < best.cost) != problem.maximise
            raise Wrong(f"{where}your cost is {said:.4g}; " + (
                "no admissible process that keeps to the ends was found that does so well" if beyond else
                f"there is an admissible process with a cost that is {better}"))
        if anywhere:
            _left_over(claim, cost_of, values, best, starts, parameters)
    return "it is the cost of the best process found"


def _left_over(claim, cost_of, values, best, starts, parameters):
    """Raise `Wrong` where a claim for all starts is not what the rest of the best process costs."""
    states, true = best.left()
    inside = np.all([(y > float(parameters[s].inf)) & (y < float(parameters[s].sup)) for s, y in zip(starts, states)],
                    axis=0)
    states, true = states[:, inside], true[inside]
    said = cost_of(*states, *(float(v) for p, v in values.items() if p not in starts))[0]
    off = ~np.atleast_1d(same(np.nan_to_num(said, nan=np.inf), true, claim, best.cost_size(), COSTS))
    for k in np.flatnonzero(off)[:1]:
        gives = f"{said[k]:.4g}" if np.isfinite(said[k]) else "no real number"
        raise Wrong(f"from the start {point_text(states[:, k])} your cost is {gives}; the best process found costs "
                    + ("more" if true[k] > said[k] else "less" if np.isfinite(said[k]) else "a real number"))


@judged(Expression("parameters"))
def optimal_duration(claim, problem, parameters=None):
    """The duration of the optimal process, as an expression in the parameters."""
    for values, best in optima(problem, parameters):
        said = value_at(claim, values, "the duration")
        if not same(said, best.duration, claim, computed=INTEGRATED):
            raise Wrong(f"{told_for(values)}your duration is {said:.4g}; the best process found ends "
                        + ("earlier" if said > best.duration else "later"))
    return "it is the duration of the best process found"


@judged
def optimal_costate(answer, problem, time, parameters=None):
    """Costates along the optimal process with lambda_0 = 1, a list in the order of the states, or one expression."""
    symbols, state = [time, *(parameters or {})], list(problem.dynamics)
    n, free_time = len(state), problem.duration is None or isinstance(problem.duration, tuple)
    if n == 1 and not isinstance(answer, (list, tuple)) and not hasattr(answer, "shape"):
        answer = [answer]
    claims = coercion.as_expressions(answer, symbols, n)
    rounding, sign = share(*claims, computed=INTEGRATED), -1 if problem.maximise else 1
    values_of, slopes_of = (real_function(symbols, part) for part in (claims, [e.diff(time) for e in claims]))
    for values, best in optima(problem, parameters):
        where, numbers = told_for(values), list(values.values())
        largest = np.abs(np.nan_to_num(values_of(best.times, *numbers))).max()
        for k, t in enumerate(best.times):
            psi, slope = (function(t * (1 - 1e-7), *numbers) for function in (values_of, slopes_of))
            there = f"{where}at t = {t:.4g}"
            if not np.all(np.isfinite([*psi, *slope])):
                raise Wrong(f"{there} your costates are not real")
            y, u = best.states[:, k], best.controls[k]
            full = np.append(psi, -sign)  # H is the product of this with the rates, the running cost being the last
            terms = -best.jacobians(y, u)[0].T * full
            size = np.abs(terms).sum() + largest / best.duration
            if not np.all(np.abs(slope - terms.sum(axis=1)) <= 10 * rounding * size):
                j = int(np.argmax(np.abs(slope - terms.sum(axis=1))))
                raise Wrong(f"{there} the adjoint equation for {state[j]} does not hold: the derivative of "
                            f"your costate is {slope[j]:.4g}, the equation with your costates demands "
                            f"{terms.sum(axis=1)[j]:.4g}")
            hamiltonian = [full @ best.field(np.append(y, 0), v) for v in (u, *_others(best, u))]
            size = np.abs(hamiltonian).max() + np.abs(full * best.field(np.append(y, 0), u)).sum()
            if not hamiltonian[0] >= max(hamiltonian) - 10 * rounding * size:
                raise Wrong(f"{there} the optimal control does not make H greatest with your costates: it gives "
                            f"{hamiltonian[0]:.4g}, another one {max(hamiltonian):.4g}")
            if free_time and not abs(hamiltonian[0]) <= 10 * rounding * (size + 1):
                raise Wrong(f"{there} H is {hamiltonian[0]:.4g} with your costates; the duration is free")
        _, final, normals = best.jacobians(best.states[:, -1], best.controls[-1])
        psi = values_of(best.duration * (1 - 1e-9), *numbers)
        _transversal(psi + sign * final[0], normals, rounding * (largest + np.abs(final).sum()),
                     f"{where}at the end your costates are {point_text(psi)}")
        free = np.array([value is None for value in problem.initial.values()])
        begin = values_of(0.0, *numbers)
        if not np.all(np.abs(begin[free]) <= 10 * rounding * largest):
            raise Wrong(f"{where}at the beginning your costates are {point_text(begin)}; what is free there has none")
    return "adjoint equations, maximum condition and transversality hold along the best process found"


# What a process has to do.


def keeps_to_the_ends(y, best, rounding, what):
    gap = best.gap(y)
    if len(gap) and not np.max(np.abs(gap)) <= 2 * rounding * best.size():
        raise Wrong(f"{what} the state is {point_text(y[:-1])} when the best process ends, which is not on the target")


def meets_once(times, states, best, where):
    sides = np.array([best.gap(y)[0] for y in states[1:-1]])
    small = 1e-6 * best.size()
    if sides.min(initial=0) < -small and sides.max(initial=0) > small:
        k = int(np.flatnonzero(np.sign(sides) != np.sign(sides[np.argmax(np.abs(sides[:9]))]))[0])
        raise Wrong(f"{where}the target is met at t = {times[k + 1]:.4g} already, and the process ends there")


def costs_least(cost, best, problem, rounding, whose):
    excess = (best.cost - cost) if problem.maximise else (cost - best.cost)
    allowed = max(COSTS, rounding if rounding > INTEGRATED else 0) * best.cost_size()
    if excess < -10 * allowed:
        raise RuntimeError(f"a process was given that does better than the best one found, by {-excess:.2g}")
    if not excess <= allowed:
        raise Wrong(f"{whose} costs {cost:.4g}; there is an admissible process with the same ends that costs "
                    + ("more, and the cost is to be great" if problem.maximise else "less"))


def _transversal(rest, normals, allowed, what):
    if len(normals):
        rest = rest - normals.T @ np.linalg.lstsq(normals.T, rest, rcond=None)[0]
    if not np.all(np.abs(rest) <= 10 * allowed + 1e-9):
        raise Wrong(f"{what}; the condition of transversality does not hold for them")


# Small things.


def _states(answer, problem, symbols, time):
    """All states as expressions; those that are not given are derivatives: x1' = x2."""
    single = not isinstance(answer, (list, tuple)) and not hasattr(answer, "shape")
    claims = [coercion.as_expression(answer, symbols)] if single else coercion.as_expressions(answer, symbols)
    state = list(problem.dynamics)
    while len(claims) < len(state) and problem.dynamics[state[len(claims) - 1]] == state[len(claims)]:
        claims.append(claims[-1].diff(time))
    if len(claims) != len(state):
        raise Invalid(f"expected the motion as expressions in {time}: {', '.join(map(str, state))}")
    return claims


def _rates(best, y):
    """The least and the greatest rate of each state that an admissible control gives."""
    y = np.append(y, 0)
    moved = best.field(y, 1.0)[:-1] != best.field(y, 0.0)[:-1]
    ends = [best.field(y, u)[:-1] if np.isfinite(u) else np.where(moved, u, best.field(y, 0.0)[:-1])
            for u in best.bounds]
    if not all(map(np.isfinite, best.bounds)):
        return np.where(moved, -np.inf, ends[0]), np.where(moved, np.inf, ends[1])
    return np.minimum(*ends), np.maximum(*ends)


def _others(best, u):
    """Controls with which that of the optimum is compared."""
    low, high = best.bounds
    around = u + (1 + abs(u)) * np.array([-1, -0.1, 0.1, 1])
    return [*np.clip(around, low, high), *(v for v in (low, high) if np.isfinite(v))]


def told_for(values):
    return f"for {rounded_text(values)} " if values else ""


def point_text(values):
    return f"{values[0] + 0:.4g}" if len(values) == 1 else "(" + ", ".join(f"{v + 0:.4g}" for v in values) + ")"

"""A control that is given as a function of time, or as a list of arcs, and the motion under it."""

import numpy as np
import sympy as sp

from trajlib.checks.contract import coercion
from trajlib.checks.contract.tolerance import share
from trajlib.checks.contract.verdict import Invalid, Wrong
from trajlib.checks.tools.values import real_function

#: What an answer without decimals may be off by: the precision of integrating it.
INTEGRATED = 1e-5


class Control:
    """A control in time: an expression, or a list of arcs [value, until]; read once, evaluated for many parameters."""

    def __init__(self, answer, time, parameters):
        self.time, self.parameters = time, list(parameters)
        if _is_list(answer) and len(answer) and all(_is_list(arc) and len(arc) == 2 for arc in answer):
            symbols = [time, *parameters]
            arcs = [[coercion.as_expression(value, symbols), coercion.as_expression(until, parameters)]
                    for value, until in answer]
            self._values = [real_function(symbols, [value]) for value, _ in arcs]
            self._ends = [real_function(self.parameters, [until]) for _, until in arcs]
            parts = [part for arc in arcs for part in arc]
        else:
            parts = [coercion.as_expression(answer, [time, *parameters])]
            self._values, self._ends = [real_function([time, *parameters], parts)], None
        self.rounding = share(*parts, computed=INTEGRATED)

    def sections(self, values, duration):
        """Triples (begin, end, function of an array of times) between the jumps, from 0 to the given duration."""
        numbers = [float(values[p]) for p in self.parameters]

        def smooth(value):
            def u(times):
                said = at_instants(value, times, *numbers)[0]
                # At a single instant, as between the cases t < 1 and t > 1, a control need not be defined.
                for aside in (1e-9 * duration, -1e-9 * duration):
                    undefined = np.flatnonzero(np.isnan(said))
                    if len(undefined):
                        said[undefined] = at_instants(value, times[undefined] + aside, *numbers)[0]
                for t in times[np.isnan(said)]:
                    raise Wrong(f"your control at {self.time} = {t:.4g} is no real number, or not defined")
                return said

            return u

        if self._ends is None:
            u = smooth(self._values[0])
            breaks = jumps(u, duration)
            # The value at a jump itself is of no account: it is asked a little inside.
            return [(a, b, _inside(u, a, b)) for a, b in zip([0.0, *breaks], [*breaks, duration])]
        begin, found = 0.0, []
        for k, (value, until) in enumerate(zip(self._values, self._ends), 1):
            end = _real(until(*numbers), f"the end of your arc number {k}")
            if not end > begin:
                raise Wrong(f"your arcs end at times that do not grow: {end:.4g} comes after {begin:.4g}")
            found.append((begin, min(end, duration), smooth(value)))
            if begin > duration * (1 + self.rounding):
                raise Wrong(f"your last arc begins at {begin:.4g}, when the target should be met already")
            begin = end
        if begin < duration * (1 - self.rounding):
            raise Wrong(f"your last arc ends at {begin:.4g}, when the target cannot yet be met")
        return [(a, b, u) for a, b, u in found if b > a]


class Path:
    """The motion under a student's control."""

    def __init__(self, best, sections, where):
        self.best, self.where, self.sections = best, where, sections
        y = np.array(best.start, dtype=float)
        self.times, self.states, self.controls = [0.0], [y], []
        for begin, end, u in sections:
            steps = max(8, int(240 * (end - begin) / best.duration))
            h = (end - begin) / steps
            times = begin + h / 2 * np.arange(2 * steps + 1)
            said = u(times).tolist()
            for k in range(1, 2 * steps, 2):
                y = _step(best.field, said[k - 1:k + 2], y, h)
                self.times.append(times[k + 1])
                self.states.append(y)
                self.controls.append((times[k], said[k]))

    def admissible(self, rounding):
        low, high = self.best.bounds
        slack = max(1e-9, rounding / 10) * (high - low)
        for t, u in self.controls:
            if not low - slack <= u <= high + slack:
                raise Wrong(f"{self.where}your control is {u:.4g} at t = {t:.4g}, outside its bounds {low:.4g} and "
                            f"{high:.4g}")

    def miss(self):
        return float(np.max(np.abs(self.best.gap(self.states[-1])))), self.best.size()

    def met_before_the_end(self):
        return any(self.best.met_between(self.best.start, y) for y in self.states[1:-1])


def _step(field, controls, y, h):
    """A step of the method of Runge and Kutta under a control given at its begin, middle and end."""
    begin, middle, end = controls
    a = field(y, begin)
    b = field(y + h / 2 * a, middle)
    c = field(y + h / 2 * b, middle)
    d = field(y + h * c, end)
    return y + h / 6 * (a + 2 * b + 2 * c + d)


def _is_list(answer):
    return isinstance(answer, (list, tuple, sp.Tuple))


def jumps(u, duration, pieces=360):
    """The instants of (0, duration) where a function of an array of times jumps, by bisection between neighbours that
    differ."""
    times = np.linspace(0, duration, pieces + 1)
    times[0] += 1e-9 * duration
    values = u(times)
    scale = max(map(abs, values)) or 1.0
    left, right, a, b = times[:-1], times[1:], values[:-1], values[1:]
    for _ in range(45):
        differ = ~(abs(a - b) < 1e-6 * scale)
        left, right, a, b = left[differ], right[differ], a[differ], b[differ]
        if not len(left):
            return []
        middle = (left + right) / 2
        value = u(middle)
        later = abs(value - a) < abs(value - b)
        left, right = np.where(later, middle, left), np.where(later, right, middle)
        a, b = np.where(later, value, a), np.where(later, b, value)
    return [t for t in left if 1e-6 * duration < t < (1 - 1e-6) * duration]


def at_instants(function, times, *numbers):
    """What a `real_function` of time gives at an array of times, a row for each of its expressions."""
    try:
        return function(times, *numbers)
    except Invalid:  # some functions, such as erf, are known for single numbers alone
        return np.array([function(t, *numbers) for t in times]).T


def _inside(u, begin, end):
    margin = 1e-9 * (end - begin)
    return lambda times: u(np.clip(times, begin + margin, end - margin))


def _real(value, what):
    """The only entry of an array, which `real_function` gives."""
    if not np.isfinite(value[0]):
        raise Wrong(f"{what} is no real number, or not defined")
    return float(value[0])

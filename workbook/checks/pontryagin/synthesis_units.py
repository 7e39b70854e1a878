"""Syntheses in the plane in the natural units of their statement.

The states of `sampled_optimum` and its horizon have the size of one. A problem stated in other units is
judged in its natural ones, and the answer with it; the coordinates in a message are then in these.
"""

import dataclasses
import functools
import inspect
from types import SimpleNamespace

import sympy as sp

from workbook.checks.contract.verdict import Wrong
from workbook.checks.references.natural_units import TIME, natural_units
from workbook.checks.references.optima.units import normalised_gap


def in_natural_units(unit=None):
    """Decorate a check of a synthesis so that it gets its data in natural units.

    Parameters
    ----------
    unit : callable, optional
        `unit(units, arguments)` returns the unit of the answer, or a list of those of its parts, from
        {symbol: unit} and the check's arguments by name. The answer has none if it is left out.
    """

    def decorated(check):
        signature = inspect.signature(check)

        @functools.wraps(check)
        def judged_in_units(*data, **options):
            bound = signature.bind(*data, **options)
            bound.apply_defaults()
            arguments = bound.arguments
            units = _units(arguments)
            if all(size == 1 for size in units.values()):
                return check(*data, **options)
            answer = next(iter(arguments))
            of_answer = 1 if unit is None else unit(units, arguments)
            conversion = _Conversion(units)
            arguments |= {
                name: CONVERTED[name](conversion, value)
                for name, value in arguments.items()
                if name in CONVERTED and value is not None
            }
            arguments[answer] = conversion.value(arguments[answer], of_answer)
            try:
                return check(*bound.args, **bound.kwargs)
            except Wrong as wrong:
                raise Wrong(f"{_units_text(units)}: {wrong}") from None

        return judged_in_units

    return decorated


def time_unit(units, arguments):
    """Return the unit of an answer that is a time."""
    return units[TIME]


def control_unit(units, arguments):
    """Return the unit of an answer that is a law."""
    return units[arguments["system"].control]


def ordinate_unit(units, arguments):
    """Return the unit of a curve, which gives one state in the other."""
    (variable,) = arguments["domain"]
    return next(units[x] for x in arguments["system"].state if x != variable)


def state_units(units, arguments):
    """Return the units of the two parts of an answer that is a point."""
    return [units[x] for x in arguments["system"].state]


def determinant_units(units, arguments):
    """Return the units of two determinants, each of a tangent and a velocity."""
    first, second = state_units(units, arguments)
    return [first * second / units[TIME]] * 2


class _Conversion:
    """The data of a synthesis in other units, given by symbol."""

    def __init__(self, units):
        self.units = units
        self._products = {s: s * size for s, size in units.items() if size != 1}

    def value(self, written, unit=1):
        """Return an expression, a condition, or a list of them in the new units."""
        if isinstance(written, (list, tuple)):
            parts = unit if isinstance(unit, list) else [unit] * len(written)
            return type(written)(map(self.value, written, parts))
        if not isinstance(written, sp.Basic):
            return written if unit == 1 else written / unit
        replaced = written.xreplace(self._products)
        return replaced if unit == 1 else replaced / unit

    def system(self, system):
        """Return a system."""
        return dataclasses.replace(
            system,
            dynamics={
                x: self.value(sp.sympify(f), self.units[x] / self.units[TIME])
                for x, f in system.dynamics.items()
            },
            controls={
                u: tuple(self.value(sp.sympify(b), self.units[u]) for b in bounds)
                for u, bounds in system.controls.items()
            },
        )

    def target(self, target):
        """Return a target: expressions that vanish on it, or points."""
        if isinstance(target, (list, tuple)):
            return type(target)(map(self._target_part, target))
        return self._target_part(target)

    def _target_part(self, part):
        if isinstance(part, (list, tuple, sp.Tuple)):
            return self.point(part)
        return normalised_gap(self.value(sp.sympify(part)), list(self.units)[:2], ())

    def point(self, point):
        """Return a point of the plane, a list."""
        sizes = list(self.units.values())[:2]
        return [self.value(sp.sympify(part), size) for part, size in zip(point, sizes)]

    def domain(self, domain):
        """Return {state: interval}."""
        return {
            x: sp.Interval(*(end / self.units[x] for end in interval.args[:2]), *interval.args[2:])
            for x, interval in domain.items()
        }

    def curve(self, curve):
        """Return a curve as `time_optimal_law` takes it; its symbol is the second coordinate."""
        symbol, abscissa, ends, *numbered = curve
        first, second = list(self.units.values())[:2]
        self._products[symbol] = symbol * second
        return symbol, self.value(abscissa, first), self.point(ends), *numbered


CONVERTED = {
    "system": _Conversion.system,
    "target": _Conversion.target,
    "start": _Conversion.value,
    "ends": _Conversion.point,
    "domain": _Conversion.domain,
    "curve": _Conversion.curve,
}


def _units(arguments):
    """Return the natural units of the states, in their order, of the control and of `TIME`."""
    system, target = arguments["system"], arguments["target"]
    parts = target if isinstance(target, (list, tuple)) else [target]
    gaps = [
        gap
        for part in parts
        for gap in (
            [x - value for x, value in zip(system.state, part)]
            if isinstance(part, (list, tuple, sp.Tuple))
            else [part]
        )
    ]
    gaps += [
        x - end
        for x, interval in (arguments.get("domain") or {}).items()
        for end in interval.args[:2]
        if end.is_finite is not False
    ]
    record = SimpleNamespace(
        dynamics=system.dynamics,
        controls={system.control: tuple(map(sp.sympify, system.bounds))},
        state=system.state,
        control=[system.control],
        initial={},
        terminal=list(map(sp.sympify, gaps)),
        running=sp.S.One,
        final=sp.S.Zero,
        duration=None,
    )
    domain = arguments.get("parameters") or {}
    units = natural_units(
        record, {p: values for p, values in domain.items() if p != arguments.get("variable")}
    )
    return {s: units[s] for s in (*system.state, system.control, TIME)}


def _units_text(units):
    named = [f"{float(size):.4g} for {s}" for s, size in units.items() if s != TIME and size != 1]
    if units[TIME] != 1:
        named.append(f"{float(units[TIME]):.4g} for the time")
    return "with the units " + ", ".join(named)

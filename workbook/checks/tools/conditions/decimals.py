"""Decimals in a condition: each stands for all numbers of its interval (`exact_values`).

A border in decimals stands for a strip.
"""

import itertools

import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract.tolerance import exact_values, in_decimals

#: The corners of the intervals are tried in conditions that have no more decimals.
MOST_DECIMALS = 4
#: What holds on a border, by the corners of the strip that stands for it.
ON_BORDER = {sp.Lt: sp.And, sp.Gt: sp.And, sp.Le: sp.Or, sp.Ge: sp.Or}
STRICTNESS = {sp.Gt: sp.Ge, sp.Ge: sp.Gt, sp.Lt: sp.Le, sp.Le: sp.Lt}


def readings(claim):
    """Return a claim with its decimals as written, at the ends of their intervals, and on borders.

    In the last one each strip that stands for a border belongs to what the border belongs to.
    """
    claim = with_plain_powers(claim)
    decimals = sorted((n for n in claim.atoms(sp.Float) if n != 0), key=float)
    exact = rational(claim)
    if not 0 < len(decimals) <= MOST_DECIMALS:
        return [exact]
    corners = [
        dict(zip(decimals, chosen)) for chosen in itertools.product(*map(exact_values, decimals))
    ]
    on_borders = {
        atom: _on_border(atom, corners) for atom in claim.atoms(Relational) if in_decimals(atom)
    }
    return [
        exact,
        *(claim.xreplace(corner) for corner in corners),
        *([rational(claim.xreplace(on_borders))] if on_borders else []),
    ]


def _on_border(atom, corners):
    if type(atom) in ON_BORDER:
        return ON_BORDER[type(atom)](*(atom.xreplace(corner) for corner in corners))
    # An equation with decimals stands for one that holds somewhere between the corners.
    low, high = (
        atom.lhs.xreplace(corner) - atom.rhs.xreplace(corner)
        for corner in (corners[0], corners[-1])
    )
    return low * high <= 0 if isinstance(atom, sp.Eq) else low * high > 0


def opened(claim):
    """Return a claim with a symbol for each decimal of a relation, and {symbol: (low, high)}.

    Equal decimals of different relations may stand for different numbers.
    """
    relations, intervals = {}, {}
    for atom in filter(in_decimals, claim.atoms(Relational)):
        symbols = {n: sp.Dummy("number", real=True) for n in atom.atoms(sp.Float)}
        intervals |= {symbol: exact_values(n) for n, symbol in symbols.items()}
        relations[atom] = atom.func(*(side.xreplace(symbols) for side in atom.args))
    return claim.xreplace(relations), intervals


def with_either_strictness(claim, intervals):
    """Return an opened claim with one symbol more for each relation, strict or not by its value.

    The relation is as written where the symbol is zero.
    """
    relations, choices = {}, {}
    for atom in claim.atoms(*STRICTNESS):
        if atom.free_symbols & set(intervals):
            choices[choice := sp.Dummy("choice", real=True)] = (0, 1)
            alternative = STRICTNESS[type(atom)](*atom.args)
            relations[atom] = sp.ITE(sp.Eq(choice, 0), atom, alternative)
    return claim.xreplace(relations), intervals | choices


def with_plain_powers(claim):
    """Return a claim with exponents in decimals as fractions: x**0.5 is a square root."""
    powers = {
        power: sp.Pow(power.base, sp.nsimplify(power.exp, rational=True))
        for power in claim.atoms(sp.Pow)
        if power.exp.is_Float
    }
    return claim.xreplace(powers) if powers else claim


def rational(expression):
    """Return an expression with its decimals as fractions."""
    return expression.xreplace({n: sp.Rational(str(n)) for n in expression.atoms(sp.Float)})

"""Decimals in a condition: each stands for all numbers that round to it.

A border in decimals stands for a strip.
"""

import itertools

import mpmath
import sympy as sp


def readings(claim):
    """Return a claim with its decimals as written, and with each off by half a unit."""
    claim = _with_plain_powers(claim)
    decimals = sorted(claim.atoms(sp.Float), key=float)
    ranges = []
    for number in decimals:
        whole = sp.nsimplify(number, rational=True)
        # By mpmath, since it may be beyond what a float holds.
        half = (
            sp.Rational(1, 2) * sp.Integer(10) ** (int(mpmath.floor(mpmath.log10(abs(whole)))) - 2)
            if whole
            else 0
        )
        ranges.append((whole, whole - half, whole + half) if half else (whole,))
    exact = claim.xreplace({number: choices[0] for number, choices in zip(decimals, ranges)})
    if not any(len(choices) > 1 for choices in ranges) or len(ranges) > 4:
        return [exact]
    corners = [
        dict(zip(decimals, chosen))
        for chosen in itertools.product(*(part[1:] or part for part in ranges))
    ]
    # An equation with decimals stands for one that holds somewhere between the corners.
    widened = {}
    for atom in claim.atoms(sp.Eq, sp.Ne):
        if atom.has(sp.Float):
            low, high = (
                atom.lhs.xreplace(corner) - atom.rhs.xreplace(corner)
                for corner in (corners[0], corners[-1])
            )
            widened[atom] = low * high <= 0 if isinstance(atom, sp.Eq) else low * high > 0
    return [
        exact,
        *(claim.xreplace(corner) for corner in corners),
        *([claim.xreplace(widened).xreplace(corners[0])] if widened else []),
    ]


def _with_plain_powers(claim):
    """Return a claim with exponents in decimals as fractions: x**0.5 is a square root."""
    powers = {
        power: sp.Pow(power.base, sp.nsimplify(power.exp, rational=True))
        for power in claim.atoms(sp.Pow)
        if power.exp.is_Float
    }
    return claim.xreplace(powers) if powers else claim


def rational(expression):
    """Return an expression with its decimals as fractions."""
    return sp.nsimplify(expression, rational=True) if expression.has(sp.Float) else expression

"""Sample values of symbols: exact ones for messages that can be checked by hand, random ones, and
all over a domain.

A domain is a dict from symbols to SymPy intervals; what it does not name ranges over all that the
assumptions of the symbol allow.
"""

import functools
import itertools
import math
from fractions import Fraction

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.tools.conditions import Condition, allowed
from workbook.checks.tools.values import at_once

#: How many times as large as the others a value is that lies far out.
FAR = sp.Integer(10)
#: How many combinations of values are looked at for cases that an answer distinguishes.
MOST_CASES = 64
#: For how many data the places that a search found are kept.
MOST_KEPT = 32
POSITIVE, NEGATIVE = sp.Interval.open(0, sp.oo), sp.Interval.open(-sp.oo, 0)


def found_once(search):
    """A search for places, dicts {symbol: value}, from the data alone: what it finds serves every
    answer."""
    known = {}

    @functools.wraps(search)
    def places(*data, **options):
        asked = _fixed(data), _fixed(options)
        if asked not in known:
            if len(known) == MOST_KEPT:
                known.clear()
            known[asked] = list(search(*data, **options))
        return [dict(place) for place in known[asked]]

    return places


def _fixed(data):
    """Data as a key: lists as tuples, dicts as pairs."""
    if isinstance(data, dict):
        return tuple((key, _fixed(value)) for key, value in data.items())
    return tuple(map(_fixed, data)) if isinstance(data, (list, tuple)) else data


def sample_values(parameters, count=6, seed=5):
    """Rational values for parameters, of both signs unless their assumptions say otherwise: a list
    of dicts.

    Among any four that follow one another from the start on, a parameter has sizes below and above
    one, of either sign.
    """
    random = np.random.default_rng(seed)
    samples = []
    for k in range(count):
        if k % 4 == 0:
            kinds = {p: random.permutation(4) for p in parameters}
        sizes = {
            p: int(random.integers(14, 40) if kind[k % 4] % 2 else random.integers(3, 13))
            for p, kind in kinds.items()
        }
        signs = {
            p: 1 if p.is_nonnegative else -1 if p.is_nonpositive or kind[k % 4] < 2 else 1
            for p, kind in kinds.items()
        }
        samples.append({p: sp.Rational(signs[p] * sizes[p], 13) for p in parameters})
    return samples


def general_values(parameters):
    """Rational values for parameters as `sample_values` gives them, but none a small number or a
    small multiple of another; the last two are large, of either sign: a root or a modulus may be
    right close by alone. Those of integer symbols are whole."""
    if not parameters:
        return [{}]
    primes = (997, 1009, 1013, 1019, 1021, 1031, 1033, 1039)
    found = [
        {
            p: value * sp.Rational(prime, 1000)
            for (p, value), prime in zip(values.items(), itertools.cycle(primes))
        }
        for values in sample_values(parameters, 6)
    ]
    far = {p: FAR * value for p, value in found[1].items()}
    far = [
        far,
        {p: value if p.is_nonnegative or p.is_nonpositive else -value for p, value in far.items()},
    ]
    return [_scaled(values, 1, values) for values in (*found, *far)]


def allowed_values(parameters, given, count):
    """Rational values of both signs for parameters, those only that satisfy the condition or
    conditions `given`; whole numbers for symbols of such. Where too few values of size one do,
    larger ones are taken too."""
    return (
        [dict(values) for values in _allowed(tuple(parameters), joined(given), count)]
        if parameters
        else [{}]
    )


@functools.lru_cache(maxsize=64)
def _allowed(parameters, given, count):
    """Every claim of a problem is tried at the same values."""
    allowed = []
    for scale in (1, 4, 16):
        allowed += [
            values
            for values in (
                _scaled(parameters, scale, one) for one in sample_values(parameters, 12 * count)
            )
            if given.subs(values) is sp.true
        ]
        if len(allowed) >= count:
            break
    else:
        raise RuntimeError("no values of the parameters were found that satisfy what is given")
    return allowed[:count]


def _scaled(parameters, scale, values):
    """Sample values times a scale; those of integer symbols whole."""
    return {
        p: (
            sp.sign(values[p]) * max(int(3 * scale * abs(values[p])), 1 if p.is_nonzero else 0)
            if p.is_integer
            else scale * values[p]
        )
        for p in parameters
    }


def in_every_case(samples, claim, given=sp.true):
    """Sample values, and more of them where an answer distinguishes cases that these do not meet,
    as far as the symbols and the condition `given` allow: in general position, between and beyond
    all borders along lines, and where a case is one value alone, at that value, if all of the
    answer has one there: what it is to have everywhere is asked by `judge_everywhere`."""
    samples = list(samples)
    relations = sorted(
        (
            relation
            for relation in cases(claim)
            if relation.free_symbols and samples and relation.free_symbols <= samples[0].keys()
        ),
        key=str,
    )
    met = _met(relations, samples)
    for base in samples[:2] if len(met) < 2 ** len(relations) else ():
        choices = [[base[s], *_between_borders(relations, base, s)] for s in base]
        for chosen in itertools.islice(itertools.product(*choices), MOST_CASES):
            values = dict(zip(base, chosen))
            truths = _truths(relations, values)
            if (
                truths not in met
                and joined(given).subs(values) is sp.true
                and not _left_out(claim, dict(zip(relations, truths)), values)
            ):
                met.add(truths)
                samples.append(values)
    return samples


def cases(claim):
    """The relations by which an answer distinguishes cases: those written, and those that a
    modulus, a sign, a step and the greatest of several stand for."""
    found = set()
    for part in _parts(claim):
        for piece in part.atoms(sp.Piecewise):
            found |= piece.atoms(Relational)
        for jump in part.atoms(sp.Abs, sp.sign, sp.Heaviside):
            found |= {jump.args[0] > 0} if jump.args[0].is_extended_real is not False else set()
        for greatest in part.atoms(sp.Max, sp.Min):
            found |= {one > other for one, other in itertools.combinations(greatest.args, 2)}
    return {relation for relation in found if isinstance(relation, Relational)}


def _left_out(claim, truths, values):
    """Whether a part of an answer has no value where another part distinguishes one value alone. A
    limit given in one entry of a matrix does not oblige the others."""
    alone = {
        relation
        for relation, true in truths.items()
        if (isinstance(relation, sp.Eq) and true == sp.true)
        or (isinstance(relation, sp.Ne) and true == sp.false)
    }
    entries = [
        entry
        for part in _parts(claim)
        for entry in (part if isinstance(part, sp.MatrixBase) else [part])
    ]
    return bool(alone) and any(
        entry.subs(values).has(sp.nan, sp.zoo) for entry in entries if not cases(entry) & alone
    )


def _parts(claim):
    """The expressions and matrices in an answer that is read."""
    if isinstance(claim, (list, tuple)):
        return [part for one in claim for part in _parts(one)]
    return [claim] if isinstance(claim, (sp.Basic, sp.MatrixBase)) else []


def _met(relations, samples):
    """The cases that sample values meet; no more of these are looked at when all are met."""
    met = set()
    for values in samples:
        if len(met) == 2 ** len(relations):
            break
        met.add(_truths(relations, values))
    return met


def _truths(relations, values):
    return tuple(_truth(relation, values) for relation in relations)


def _truth(relation, values):
    """True or false; None where it asks which of two numbers is greater, and one is not real."""
    try:
        return at_once(relation, values)
    except TypeError:
        return None


def _between_borders(relations, base, symbol):
    symbols = [s for s in base if any(relation.has(s) for relation in relations)]
    if symbol not in symbols:
        return []
    # Not by `nsimplify`: it looks for a closed form of every float, a tenth of a second each.
    place = [sp.Rational(base[s]) for s in symbols]
    borders = {
        relation: Condition(relation, symbols).borders(place, symbols.index(symbol))
        for relation in relations
    }
    found = sorted(set().union(*borders.values()))
    if not found:
        return []
    ends = found[0] - 0.37 * (1 + abs(found[0])), found[-1] + 0.37 * (1 + abs(found[-1]))
    alone = [
        root
        for relation, roots in borders.items()
        if isinstance(relation, (sp.Eq, sp.Ne))
        for root in roots
    ]
    places = [
        *(0.61 * one + 0.39 * other for one, other in itertools.pairwise(found)),
        *ends,
        *alone,
    ]
    as_given = (
        float
        if isinstance(base[symbol], float)
        else lambda x: sp.Rational(Fraction(x).limit_denominator(1000))
    )
    return [
        as_given(x)
        for x in (map(round, places) if symbol.is_integer else places)
        if allowed(symbol, np.sign(x))
    ]


def joined(given):
    """One condition of several."""
    return sp.And(*given) if isinstance(given, (list, tuple)) else given


def random_values(symbols, seed, count=6):
    """Random positive values of all symbols, of size one: `count` dicts. Each symbol gets small
    values and large ones."""
    random = np.random.default_rng(seed)
    columns = [spread(random, 0.4, 2.5, count) for _ in symbols]
    for k in range(count):
        yield {symbol: float(column[k]) for symbol, column in zip(symbols, columns)}


def signed_values(symbols, positive=(), count=8):
    """Values of both signs for symbols in general position, small and large ones for each."""
    random = np.random.default_rng(29)
    columns = {
        s: spread(random, 0.3, 3.0, count)
        * (1 if s in positive or s.is_positive else random.permutation([1, -1] * (count // 2)))
        for s in symbols
    }
    return [{s: float(column[k]) for s, column in columns.items()} for k in range(count)]


def spread(random, low, high, count):
    """Random numbers between two bounds, one in each of `count` parts of equal ratio, in random
    order."""
    return low * (high / low) ** ((random.permutation(count) + random.uniform(size=count)) / count)


def sample_cases(parameters):
    """Sample values of all parameters together: one row for each case."""
    if not parameters:
        return [()]
    columns = [
        [float(value) for value in domain]
        if isinstance(domain, sp.FiniteSet)
        else spread_over(float(domain.inf), float(domain.sup))
        for domain in parameters.values()
    ]
    return [
        tuple(float(column[(k + 2 * c) % len(column)]) for c, column in enumerate(columns))
        for k in range(len(columns[0]))
    ]


def spread_over(low, high, count=6):
    """Values inside an interval, which may be infinite."""
    shares = (np.arange(count) + 0.55) / count
    if np.isfinite(low) and np.isfinite(high):
        return low + (high - low) * shares
    if np.isfinite(low):
        return low + 0.8 * shares / (1.1 - shares)
    if np.isfinite(high):
        return high - 0.8 * shares / (1.1 - shares)
    return 4 * (2 * shares - 1)


def interval_of(symbol, domain):
    """The values a symbol may take: from the domain, else from its assumptions."""
    if domain and symbol in domain:
        return domain[symbol]
    if symbol.is_positive:
        return POSITIVE
    if symbol.is_negative:
        return NEGATIVE
    return sp.S.Reals


def ends(symbol, domain):
    return _ends_of(interval_of(symbol, domain))


@functools.lru_cache(maxsize=64)
def _ends_of(interval):
    return float(interval.start), float(interval.end)


def lies_inside(value, symbol, domain):
    low, high = ends(symbol, domain)
    return low < value < high


def draw(random, symbol, domain, share=None):
    """A random value of a symbol, of a moderate size; or that at a share, between 0 and 1, of all
    its values."""
    low, high = ends(symbol, domain)
    share = random.uniform() if share is None else share
    if math.isfinite(low) and math.isfinite(high):
        return low + (0.02 + 0.96 * share) * (high - low)
    smallest, largest = math.log(0.15), math.log(8)
    if math.isfinite(low) or math.isfinite(high):
        size = math.exp(smallest + share * (largest - smallest))
        return low + size if math.isfinite(low) else high - size
    sign, share = (1, 2 * share - 1) if share > 0.5 else (-1, 1 - 2 * share)
    return sign * math.exp(smallest + share * (largest - smallest))


def drawn(random, symbols, domain, count, claim):
    """Random values of symbols, a row for each, in `count` columns, and more where an answer
    distinguishes cases that these do not meet."""
    places = np.array([[draw(random, symbol, domain) for _ in range(count)] for symbol in symbols])
    if not cases(claim):
        return places
    samples = [dict(zip(symbols, map(float, place))) for place in places.T]
    inside = sp.And(*(interval_of(symbol, domain).as_relational(symbol) for symbol in symbols))
    return np.array(
        [[values[symbol] for values in in_every_case(samples, claim, inside)] for symbol in symbols]
    )


def rational(value):
    return Fraction(float(value)).limit_denominator(60 if abs(value) > 0.2 else 10**4)


def simple_rational(value, symbol, domain):
    """A simple rational near a value, for messages that can be checked by hand."""
    simple = Fraction(value).limit_denominator(9)
    # Whole numbers are where formulas in a good form happen not to be defined, such as 1/(u - 3).
    return (
        simple
        if simple.denominator > 1 and lies_inside(float(simple), symbol, domain)
        else rational(value)
    )

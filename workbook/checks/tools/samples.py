"""Sample values of symbols: exact ones for messages that can be checked by hand, and random ones."""

import functools
import itertools
from fractions import Fraction

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.tools.conditions import Condition, allowed
from workbook.checks.tools.domains import interval_of, random_value
from workbook.checks.tools.substitution import substituted

#: How many times as large as the others a value is that lies far out.
FAR = sp.Integer(10)
#: How many combinations of values are looked at for cases that an answer distinguishes.
MOST_CASES = 64
#: For how many data the points that a search found are kept.
MOST_KEPT = 32


def cached_points(search):
    """Cache a search for points, dicts {symbol: value}: its results serve every answer."""
    cache = {}

    @functools.wraps(search)
    def points(*data, **options):
        key = _fixed(data), _fixed(options)
        if key not in cache:
            if len(cache) == MOST_KEPT:
                cache.clear()
            cache[key] = list(search(*data, **options))
        return [dict(point) for point in cache[key]]

    return points


def _fixed(data):
    """Return data as a key: lists as tuples, dicts as pairs."""
    if isinstance(data, dict):
        return tuple((key, _fixed(value)) for key, value in data.items())
    return tuple(map(_fixed, data)) if isinstance(data, (list, tuple)) else data


def sample_values(parameters, count=6):
    """Return rational values for parameters, of both signs if their assumptions allow.

    Parameters
    ----------
    parameters : list of sympy.Symbol
        The parameters.
    count : int
        The number of samples.

    Returns
    -------
    list of dict
        Among any four that follow one another from the first on, a parameter has sizes below and above
        one, of either sign.
    """
    random = np.random.default_rng(5)
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
    """Return rational values for parameters in general position.

    They are those of `sample_values`, but none is a small number or a small multiple of another; the
    last two are large, of either sign: a root or a modulus may be right only near the others. Those of
    integer symbols are whole.
    """
    if not parameters:
        return [{}]
    primes = (997, 1009, 1013, 1019, 1021, 1031, 1033, 1039)
    samples = [
        {
            p: value * sp.Rational(prime, 1000)
            for (p, value), prime in zip(values.items(), itertools.cycle(primes))
        }
        for values in sample_values(parameters, 6)
    ]
    far = {p: FAR * value for p, value in samples[1].items()}
    far = [
        far,
        {p: value if p.is_nonnegative or p.is_nonpositive else -value for p, value in far.items()},
    ]
    return [_scaled(values, 1, values) for values in (*samples, *far)]


def allowed_values(parameters, domain, count):
    """Return rational values of both signs for parameters that satisfy conditions.

    Parameters
    ----------
    parameters : list of sympy.Symbol
        The parameters; whole numbers are taken for integer ones.
    domain : sympy condition or list of them
        What the values have to satisfy.
    count : int
        The number of samples. Where too few values of size one are allowed, larger ones are taken too.

    Returns
    -------
    list of dict
    """
    if parameters:
        return [dict(values) for values in _allowed(tuple(parameters), conjunction(domain), count)]
    if conjunction(domain) == sp.false:
        raise UnsuitableData("what is given, or what the quantity needs to exist, does not hold")
    return [{}]


@functools.lru_cache(maxsize=64)
def _allowed(parameters, domain, count):
    """Return allowed values; every claim of a problem is tried at the same ones."""
    allowed = []
    for scale in (1, 4, 16):
        allowed += [
            values
            for values in (
                _scaled(parameters, scale, values)
                for values in sample_values(parameters, 12 * count)
            )
            if domain.subs(values) is sp.true
        ]
        if len(allowed) >= count:
            break
    else:
        raise UnsuitableData("no values of the parameters were found that satisfy what is given")
    return allowed[:count]


def _scaled(parameters, scale, values):
    """Return sample values times a scale; those of integer symbols whole."""
    return {
        p: (
            sp.sign(values[p]) * max(int(3 * scale * abs(values[p])), 1 if p.is_nonzero else 0)
            if p.is_integer
            else scale * values[p]
        )
        for p in parameters
    }


def in_every_case(samples, claim, domain=sp.true):
    """Return samples, extended by one for each case of an answer that they do not cover.

    Parameters
    ----------
    samples : list of dict
        Values of the same symbols.
    claim : object
        The answer, or a list of its parts.
    domain : sympy condition or list of them
        What further samples have to satisfy.

    Returns
    -------
    list of dict
        Further samples are in general position, between and beyond all borders along lines. Where a
        case is one value alone, that value is taken if all of the answer has a value there: behaviour
        at all values is judged by `judge_everywhere`.
    """
    samples = list(samples)
    relations = sorted(
        (
            relation
            for relation in cases(claim)
            if relation.free_symbols and samples and relation.free_symbols <= samples[0].keys()
        ),
        key=str,
    )
    covered = _covered_cases(relations, samples)
    for base in samples[:2] if len(covered) < 2 ** len(relations) else ():
        choices = [[base[s], *_between_borders(relations, base, s)] for s in base]
        for chosen in itertools.islice(itertools.product(*choices), MOST_CASES):
            values = dict(zip(base, chosen))
            outcomes = _outcomes_at(relations, values)
            if (
                outcomes not in covered
                and conjunction(domain).subs(values) is sp.true
                and not _left_out(claim, dict(zip(relations, outcomes)), values)
            ):
                covered.add(outcomes)
                samples.append(values)
    return samples


def cases(claim):
    """Return the relations by which an answer distinguishes cases.

    They are those written in it, and those that a modulus, a sign, a step and the greatest of several
    stand for.
    """
    relations = set()
    for part in _parts(claim):
        for piece in part.atoms(sp.Piecewise):
            relations |= piece.atoms(Relational)
        for jump in part.atoms(sp.Abs, sp.sign, sp.Heaviside):
            relations |= {jump.args[0] > 0} if jump.args[0].is_extended_real is not False else set()
        for greatest in part.atoms(sp.Max, sp.Min):
            relations |= {
                first > second for first, second in itertools.combinations(greatest.args, 2)
            }
    return {relation for relation in relations if isinstance(relation, Relational)}


def _left_out(claim, outcomes, values):
    """Return whether a part has no value where another part distinguishes a single value.

    A limit given in one entry of a matrix does not oblige the others.
    """
    equalities = {
        relation
        for relation, outcome in outcomes.items()
        if (isinstance(relation, sp.Eq) and outcome == sp.true)
        or (isinstance(relation, sp.Ne) and outcome == sp.false)
    }
    entries = [
        entry
        for part in _parts(claim)
        for entry in (part if isinstance(part, sp.MatrixBase) else [part])
    ]
    return bool(equalities) and any(
        entry.subs(values).has(sp.nan, sp.zoo) for entry in entries if not cases(entry) & equalities
    )


def _parts(claim):
    """Return the expressions and matrices in an answer."""
    if isinstance(claim, (list, tuple)):
        return [part for item in claim for part in _parts(item)]
    return [claim] if isinstance(claim, (sp.Basic, sp.MatrixBase)) else []


def _covered_cases(relations, samples):
    """Return the cases in which sample values lie; stop when all are covered."""
    covered = set()
    for values in samples:
        if len(covered) == 2 ** len(relations):
            break
        covered.add(_outcomes_at(relations, values))
    return covered


def _outcomes_at(relations, values):
    return tuple(_outcome_at(relation, values) for relation in relations)


def _outcome_at(relation, values):
    """Return whether a relation holds; None if it compares numbers that are not real."""
    try:
        return substituted(relation, values)
    except TypeError:
        return None


def _between_borders(relations, base, symbol):
    symbols = [s for s in base if any(relation.has(s) for relation in relations)]
    if symbol not in symbols:
        return []
    # Not by `nsimplify`: it looks for a closed form of every float, a tenth of a second each.
    point = [sp.Rational(base[s]) for s in symbols]
    borders = {
        relation: Condition(relation, symbols).borders(point, symbols.index(symbol))
        for relation in relations
    }
    roots_of_all = sorted(set().union(*borders.values()))
    if not roots_of_all:
        return []
    ends = (
        roots_of_all[0] - 0.37 * (1 + abs(roots_of_all[0])),
        roots_of_all[-1] + 0.37 * (1 + abs(roots_of_all[-1])),
    )
    isolated = [
        root
        for relation, roots in borders.items()
        if isinstance(relation, (sp.Eq, sp.Ne))
        for root in roots
    ]
    points = [
        *(0.61 * lower + 0.39 * upper for lower, upper in itertools.pairwise(roots_of_all)),
        *ends,
        *isolated,
    ]
    as_given = (
        float
        if isinstance(base[symbol], float)
        else lambda x: sp.Rational(Fraction(x).limit_denominator(1000))
    )
    return [
        as_given(x)
        for x in (map(round, points) if symbol.is_integer else points)
        if allowed(symbol, np.sign(x))
    ]


def conjunction(conditions):
    """Return one condition for several."""
    return sp.And(*conditions) if isinstance(conditions, (list, tuple)) else conditions


def random_values(symbols, seed):
    """Yield random positive values of all symbols, of size one, small and large ones for each."""
    random = np.random.default_rng(seed)
    columns = [log_spread(random, 0.4, 2.5, 6) for _ in symbols]
    for k in range(6):
        yield {symbol: float(column[k]) for symbol, column in zip(symbols, columns)}


def signed_values(symbols, positive=()):
    """Return values of both signs for symbols in general position, small and large ones."""
    random = np.random.default_rng(29)
    columns = {
        s: log_spread(random, 0.3, 3.0, 8)
        * (1 if s in positive or s.is_positive else random.permutation([1, -1] * 4))
        for s in symbols
    }
    return [{s: float(column[k]) for s, column in columns.items()} for k in range(8)]


def log_spread(random, low, high, count):
    """Return random numbers, one in each of `count` parts of equal ratio, shuffled."""
    return low * (high / low) ** ((random.permutation(count) + random.uniform(size=count)) / count)


def random_columns(random, symbols, domain, count, claim):
    """Return random values of symbols in rows, with further columns for cases of an answer."""
    points = np.array(
        [[random_value(random, symbol, domain) for _ in range(count)] for symbol in symbols]
    )
    if not cases(claim):
        return points
    samples = [dict(zip(symbols, map(float, point))) for point in points.T]
    inside = sp.And(*(interval_of(symbol, domain).as_relational(symbol) for symbol in symbols))
    return np.array(
        [[values[symbol] for values in in_every_case(samples, claim, inside)] for symbol in symbols]
    )

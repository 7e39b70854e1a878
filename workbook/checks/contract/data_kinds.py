"""Kinds of data that a check can judge, read from their description in `contract.shapes`.

A description such as "Linear or Mechanical" names records, by the names of their classes; another
one is refused, so that a check never judges something else. So is a system without the controls or
outputs, a `Problem` with what the description does not mention, and a dict where none is described
or the other way round.
"""

import functools
import re

import sympy as sp

#: The records of `workbook.systems`, and the problem of `trajlib.pontryagin`.
RECORDS = (
    *("Coloured", "Controlled", "Deviations", "FilterErrors", "Functional", "Linear"),
    *("Measurements", "Mechanical", "Problem", "Process", "Quadratic", "Scalar", "Varying"),
    "WithError",
)
#: What may stand between the names of records where nothing else than a record is described.
BETWEEN = {"", "or", "pontryagin", "record"}
#: What no check of a problem takes into account.
CONSTRAINTS = {
    "path": "inequalities along the path",
    "terminal_inequalities": "inequalities at the end",
    "bounds_depend_on_state": "bounds of the control that depend on the state",
}


def unsuitable(datum, description):
    """Return why a datum is of no kind that is described, or "".

    Parameters
    ----------
    datum : object
        The value of an argument of a check.
    description : str
        Its description.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> unsuitable(Linear([[0]]), "Mechanical or Scalar")
    'expected Mechanical or Scalar, got Linear'
    """
    kind = type(datum).__name__
    if reason := _unsuitable_dict(datum, description):
        return reason
    named, only_records = _records_in(description)
    if datum is None or not named:
        return ""
    if kind not in named:
        return f"expected {description}, got {kind}" if only_records or kind in RECORDS else ""
    if kind != "Problem":
        absent = [
            name
            for name, matrix in (("controls", "B"), ("outputs", "H"))
            if name in description and not getattr(datum, matrix, True)
        ]
        return f"expected {description}, got one without {absent[0]}" if absent else ""
    features = [text for name, text in CONSTRAINTS.items() if getattr(datum, name)]
    if "one control" in description and len(datum.controls) > 1:
        features.append("several controls")
    if "interval" not in description and isinstance(datum.duration, tuple):
        features.append("an interval for the duration")
    if "a given duration" in description and datum.duration is None:
        features.append("a free duration")
    return f"this check cannot judge a problem with {' and '.join(features)}" if features else ""


def _unsuitable_dict(datum, description):
    """Return why a datum is a dict that is not described, or not the dict that is, or ""."""
    got = f"expected {description}, got {type(datum).__name__}"
    if isinstance(datum, dict):
        if description and "dict" not in description:
            return got
        of_sets = all(isinstance(value, sp.Set) for value in datum.values())
        return "" if "to intervals" not in description or of_sets else f"{got} to other values"
    if datum is None or not description.startswith("dict"):
        return ""
    names = _symbols(datum)
    return got + (
        f"; write {dict_of_ranges(names)}" if names and "to intervals" in description else ""
    )


def dict_of_ranges(symbols):
    """Return how a dict of intervals is written, in words."""
    names = ", ".join(f"{name}: ..." for name in symbols)
    return f"`{{{names}}}` with an interval such as `sp.Interval(1, 2)` in each place"


def _symbols(datum):
    """Return the symbols of a list of them."""
    return (
        [x for x in datum if isinstance(x, sp.Symbol)] if isinstance(datum, (list, tuple)) else []
    )


@functools.cache
def _records_in(description):
    """Return the records that a description names, and whether it describes nothing else."""
    words = set(re.findall(r"\w+", description.partition(" with ")[0]))
    return words & set(RECORDS), words <= BETWEEN.union(RECORDS)
